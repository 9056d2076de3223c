//! Integration tests of polhode-response: statements of physics, each with its number.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

mod blocks_in_bodies;
mod bodies_against_delassus;
mod bodies_of_heaps;
mod body_costs;
mod body_invariance;
mod body_problems;
mod body_scenes;
mod body_warm_starts;
mod cases;
mod certificates;
mod contradicting_rows;
mod degenerate;
mod diamonds;
mod exact;
mod forces;
mod free_bodies;
mod friction;
mod frictional_impacts;
mod frictional_paths;
mod impacts;
mod joints;
mod law_left;
mod laws;
mod least_force;
mod mass_ratios;
mod methods_needed;
mod methods_tried;
mod multiple_frictional_impacts;
mod one_door;
mod oracle;
mod problem;
mod problem_set;
mod pulse_with_friction;
mod resisted_rotations;
mod scenes;
mod thesis_forces;
