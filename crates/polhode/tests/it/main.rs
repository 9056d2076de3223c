//! Tests of the facade: statements of physics about whole scenes.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

mod bad_numbers;
mod broad_phases;
mod checks;
mod constrained_methods;
mod dependence;
mod diamonds;
mod flight;
mod forces;
mod forces_with_contact;
mod frames;
mod friction;
mod friction_at_its_limit;
mod friction_effects;
mod friction_on_moving_ground;
mod grain;
mod impacts;
mod impulse_models;
mod integrators;
mod invariance;
mod kinematic;
mod kinematic_steps;
mod linked_rings;
mod mass_ratios;
mod momentum;
mod moving_surfaces;
mod outcomes;
mod piles;
mod pivot_rows;
mod pivots;
mod planar;
mod prescribed_motion;
mod program;
mod public_interface;
mod refusals;
mod rotational_friction;
mod round_bodies;
mod seams;
mod snapshots;
mod stepped;
mod stiff_and_singular;
mod support;
mod table_edge;
