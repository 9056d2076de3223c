//! The tier `fast`: real time, by substeps of soft contacts and sequential impulses.
//!
//! Contacts are found once a step, with a margin for what the bodies may do in it; a contact that is apart lets its
//! bodies close by its separation (speculative contact), so that fast bodies do not pass through others. The step has
//! substeps of `h` (s), each with these stages:
//!
//! 1. gravity and forces act on the velocities;
//! 2. the impulses of the substep before act again, and one sweep over all contacts corrects them, while overlaps are
//!    pushed apart softly;
//! 3. the bodies move;
//! 4. another sweep the other way, without the push, takes out the velocity that it gave.
//!
//! Joints are swept before contacts, their rows found anew after every movement. At the end contacts that collided part
//! again with their restitution, and friction. Friction is Coulomb's at each point, in a disc. Sources and formulas:
//! `polhode_response::sequential_impulses`, docs/contact-methods/fast.md. Failure: none that stops a run; with few
//! substeps tall stacks and large mass ratios sag, and the residual of the certificate says how much.
//!
//! | module | holds |
//! |---|---|
//! | `facts` | what the tier is: its name, defaults, promise, and what it takes |
//! | `rules` | softness, substeps, thresholds |
//! | `rest` | islands at rest, which steps leave out |
//! | `step` | the stages of a step |
//! | `turning` | free rotation over a substep |
//! | `group` | the step of some islands: what one task computes |
//! | `held` | joints: their rows, and what they give |
//! | `passage` | whether a body has come through another |
//! | `impacts` | collisions as events |
//! | `course` | states and contacts of all bodies, and a step of them |
//! | `engine` | a run: steps, what is booked, queries at the present |

mod course;
mod engine;
pub(crate) mod facts;
mod group;
mod held;
mod impacts;
mod passage;
mod rest;
mod rules;
mod step;
mod turning;

pub(crate) use engine::FastEngine;
