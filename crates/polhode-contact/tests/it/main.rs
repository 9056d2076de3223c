//! Integration tests of polhode-contact: one binary.

mod approximate_decomposition;
mod bounding_volumes;
mod broad_phase;
mod broad_phase_methods;
mod compounds;
mod derivatives;
mod distances;
mod face_contacts;
mod general_poses;
mod hostile_input;
mod impact_closed_forms;

mod impact_random;
mod line_contacts;
mod mesh_impacts;
mod mesh_valleys;
mod meshes;
mod nearest_normals;
mod needles;
mod persistent;
mod polyhedra;
mod query_parts;
mod rays;
mod reentrant_edges;
mod ridge_ends;
mod rings;
mod round_bounds;
mod round_contacts;
mod round_derivatives;
mod round_gaps;
mod round_impacts;
mod round_touch;
mod scenes;
mod smooth_shapes;
mod stacking;
mod support;
