//! A run: a scene that a program advances in time, queries, and changes.
//!
//! | module | holds |
//! |---|---|
//! | `simulation` | [`Simulation`](crate::Simulation): steps, runs, queries, snapshots |
//! | `engines` | the engines of the tiers, begun and restored |
//! | `start_overlap` | bodies that overlap at the start: refused, or moved apart |
//! | `actions` | what a program does to bodies and joints |
//! | `surfaces` | friction and restitution that a program changes |
//! | `steering` | kinematic bodies that a program steers |
//! | `stability` | [`Stability`](crate::Stability): how far bodies at rest are from moving |
//! | `evaluation` | [`Evaluation`](crate::Evaluation): a scene in states that somebody else gives |
//! | `accompany` | runs beside this one are begun, followed and compared with it, to estimate its error |
//! | `distances` | how far it is from them, and what that says of its errors |
//! | `pieces` | pieces of a run that another method computes again where bodies touch |
//! | `tell_errors` | the estimated errors of samples, for the observer |
//! | `beside` | how such a run begins: by which method, steps and states |
//! | `restoring` | snapshots, and simulations that continue from them |
//! | `singular_force` | the singular force that has made a run fail |

mod accompany;
mod actions;
mod beside;
mod distances;
mod engines;
pub(crate) mod evaluation;
mod pieces;
mod restoring;
pub(crate) mod simulation;
mod singular_force;
pub mod stability;
mod start_overlap;
pub(crate) mod steering;
mod surfaces;
mod tell_errors;
