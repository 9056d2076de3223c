//! The tier `thesis`: the algorithm of the thesis's section 3.5, unchanged, for comparison.
//!
//! Each step has a fixed length and these stages:
//!
//! 1. detect penetrations;
//! 2. apply impulses by propagation until no contact approaches;
//! 3. take the contacts that separate slowly as resting;
//! 4. find their forces by the linear programme of least total force, with the thesis's guesses of vanishing contacts;
//! 5. integrate one step by RK4 under these forces, which stay constant.
//!
//! No event is located and nothing is projected. Bodies in a stack therefore penetrate each other and vibrate, by about
//! the distance that they travel in a step; the certificate bounds the error of the forces.
//!
//! With a [`Response`](crate::scene::Response) other than by constraint, stages 3 and 4 are left out, and the tier does
//! what the thesis tried before it had them (`impulse_models`).
//!
//! | module | holds |
//! |---|---|
//! | `facts` | what the tier is: its name, defaults, promise, and what it takes |
//! | `engine` | a run, one step of it, and queries at the present |
//! | `impulse_models` | what the thesis tried before it had contact forces |
//! | `system` | bodies under fields and constant contact forces |

mod engine;
pub(crate) mod facts;
mod impulse_models;
mod system;

pub(crate) use engine::ThesisEngine;
