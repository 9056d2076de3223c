//! Spring laws of contacts: forces that grow with the overlap of two bodies.
//!
//! A penalty method lets bodies overlap a little and pushes them apart by springs with dampers (thesis 3.1, "Penalty
//! Methods"). Nothing in these laws is tuned: the damping follows from the coefficient of restitution, and what a
//! spring takes up and gives back is known in closed form, so that the ledger of energy can close.
//!
//! | module | holds |
//! |---|---|
//! | `damping` | damping from restitution: exact relations and their inverses |
//! | `normal` | the force along the normal and its elastic energy |
//! | `tangential` | stiffness along the tangent plane after Mindlin |
//!
//! ```
//! use polhode_response::penalty::{Growth, NormalSpring, Relation};
//! let spring = NormalSpring::elastic(Growth::Linear, 1000.0)?;
//! let ratio = Relation::Plain.number_for(0.5)?;
//! // A mass of 1 kg that falls on this spring at any speed leaves it at half that speed.
//! let damped = spring.with_plain_damping(ratio, 1.0);
//! assert!((damped.force(0.01, 0.0) - 10.0).abs() < 1e-12);
//! assert!((Relation::Plain.restitution_of(ratio) - 0.5).abs() < 1e-12);
//! # Ok::<(), polhode_response::penalty::SpringError>(())
//! ```

mod damping;
mod normal;
mod tangential;

pub use damping::{Relation, SMALLEST_RESTITUTION};
pub use normal::{Damping, Growth, NormalSpring};
pub use tangential::{ElasticPair, TangentialSpring};

use thiserror::Error;

/// Why a spring law is refused.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SpringError {
    /// A number of the law is not positive and finite.
    #[error("{what} of a contact spring is {value}: a positive, finite number is needed")]
    Number {
        /// What the number is, with its unit.
        what: &'static str,
        /// The number.
        value: f64,
    },
    /// No damping of a spring reaches this restitution.
    #[error(
        "a damped spring cannot reach a restitution of {value}: it gives back at least {SMALLEST_RESTITUTION} of the \
         speed (a smaller one needs damping beyond all bounds) and at most 1; give a restitution of at least \
         {SMALLEST_RESTITUTION}, or use response = \"constraint\""
    )]
    Restitution {
        /// The restitution asked.
        value: f64,
    },
}
