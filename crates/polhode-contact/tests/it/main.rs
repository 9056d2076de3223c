//! Integration tests of polhode-contact: one binary.

mod approximate_decomposition;
mod broad_phase;
mod derivatives;
mod face_contacts;
mod general_poses;
mod hostile_input;
mod impact_closed_forms;

mod impact_random;
mod polyhedra;
mod smooth_shapes;
mod stacking;
mod support;
