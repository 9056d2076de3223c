//! A scene to play with: it runs while somebody pulls at its bodies, and goes back to any time it has passed.
//!
//! What a page does with the engine, without the page: the same steps as any other run, so that an untouched run has
//! the strict hash that every program prints of the scene; actions between steps, which are kept, so that going back to
//! a time and on from there repeats them bit by bit; what the present holds, as numbers and as JSON.
//!
//! | module | holds |
//! |---|---|
//! | `playground` | [`Playground`]: the scene that runs |
//! | `timeline` | the steps, actions and snapshots so far |
//! | [`mod@grab`] | [`Grab`]: the spring by which a body is held |
//! | [`mod@native`] | [`native::Hashes`]: what the same run on another platform is held against |
//! | `told` | report and energies as one JSON object |
//! | [`mod@why`] | the forces on a body, and what would have to change for it to move |
//! | `error` | [`PlayError`] |

mod error;
pub mod grab;
pub mod native;
mod playground;
mod timeline;
mod told;
pub mod why;

#[cfg(test)]
mod tests;

pub use error::PlayError;
pub use grab::Grab;
pub use playground::Playground;
