//! The tier `micro-collisions`: bodies act on each other by impulses alone, after Mirtich.
//!
//! There are no contact forces. Each step of fixed length `h` (s) has these stages:
//!
//! 1. find contacts within the collision envelope, and those that would close within the step;
//! 2. strike those that approach, by the impact law of the scene: real impacts with the restitution of the materials,
//!    micro-collisions with that of the envelope (`collision/envelope.rs`); friction of a contact that is struck alone
//!    by the path of slip, stick and reversal of its collision (Routh's equations), of several by their cone problem;
//! 3. integrate the free motion over the step.
//!
//! A body at rest hovers in the envelope and vibrates by about `g h^2/8`; a force on it is the mean of its impulses
//! over a step. A body that sticks on a slope creeps: between two collisions it slips freely, by about
//! `g h sin(slope)/2` (m/s). A contact that would close within a step is struck where it is, at a gap of up to its
//! speed times `h`, so that bodies do not overlap; what they overlap by all the same is measured and reported.
//!
//! Mirtich strikes contacts one at a time. With `impact = "propagation"` so does this tier; a body on several corners
//! then sinks, by the energy that its corners take from each other.
//!
//! Source: Mirtich 1996; Mirtich and Canny 1995.
//!
//! | module | holds |
//! |---|---|
//! | `facts` | what the tier is: its name, defaults, and what it takes |
//! | `engine` | a run, one step of it, and queries at the present |

mod engine;
pub(crate) mod facts;

pub(crate) use engine::MicroCollisionEngine;
