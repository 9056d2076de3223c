//! Drops: on which of its faces a body comes to rest, how often, and how hard it is struck.
//!
//! Statics says on which faces it can rest, and how far each is from tipping ([`Facets`]); throws from random attitudes
//! say how often it comes to rest there ([`RestPoses`]). A throw is a run of the simulation like any other, by the
//! method of the scene, and depends on its number and the seed alone.
//!
//! | module | holds |
//! |---|---|
//! | `attitude` | random attitudes |
//! | `facets` | [`Facets`]: the faces on which a body can rest, by statics |
//! | `contact_time` | how long an impact lasts, and its greatest force (Hertz) |
//! | `setting` | [`Setting`]: what is thrown, on what, and from where |
//! | `throw` | [`Throw`]: one throw, and what became of it |
//! | `poses` | [`RestPoses`]: all throws together |
//! | `part` | [`Part`]: a part above a floor, as the text of a scene |
//! | `json` | [`json`](json()): everything as one object, and a line for each throw |
//! | `error` | [`DropError`] |

mod attitude;
mod contact_time;
mod error;
mod facets;
mod json;
mod part;
mod poses;
mod setting;
mod throw;

pub use error::DropError;
pub use facets::{Facet, Facets};
pub use json::{THROW_COLUMNS, json, throw_line};
pub use part::{NAMED_SHAPES, Part, PartShape};
pub use poses::{RestPoses, Spread, Throws};
pub use setting::{Setting, Start};
pub use throw::{Blow, Fate, Throw};
