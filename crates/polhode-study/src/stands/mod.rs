//! Whether bodies stand, how firmly, what moves first, and up to which value of any key of the scene.
//!
//! A scene stands when limit analysis (`polhode::stability`) finds forces within the cones of friction that hold all
//! bodies at rest, and none moves in the first step. The two are independent: one solves for forces, the other
//! integrates. What does not rest, or touches nothing, is in no analysis.
//!
//! | module | holds |
//! |---|---|
//! | `standing` | [`Standing`]: the answer; [`Question`]: the scene that it is asked of |
//! | `mechanism` | [`Mechanism`]: the motion that begins, and the [`Hinge`]s about which bodies turn |
//! | `bisect` | [`Bisection`]: up to which value of a key the scene stands |
//! | `answer` | the answer as one JSON object |
//! | `error` | [`StandsError`] |

mod answer;
mod bisect;
mod error;
mod mechanism;
mod standing;

pub use answer::{bisection_json, standing_json};
pub use bisect::{Bisection, Interval, MOST_DIGITS, Numbers};
pub use error::StandsError;
pub use mechanism::{Begins, Hinge, Mechanism, mechanism_at_push};
pub use standing::{Question, Standing};
