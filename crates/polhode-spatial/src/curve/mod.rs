//! Curves in space by arc length: what a body on a track follows.
//!
//! | module | holds |
//! |---|---|
//! | `piecewise` | [`Curve`]: its kinds, and its places by arc length |
//! | `piece` | the formulas |
//! | `moved` | curves turned, shifted and mirrored |
//! | `span` | parts that turn by little |
//! | `place` | [`CurvePoint`]: a place of a curve |
//! | `nearest` | the place nearest to a point |
//! | `meets_itself` | whether a curve comes near itself |
//! | `spline` | cubic splines |
//! | `quadrature` | integrals |
//! | `error` | [`CurveError`]: why a curve is refused |

mod error;
mod meets_itself;
mod moved;
mod nearest;
mod piece;
mod piecewise;
mod place;
mod quadrature;
mod span;
mod spline;

pub use error::CurveError;
pub use piecewise::{Bend, Coil, Curve, CurvePlane, Rolling, Wave};
pub use place::CurvePoint;
pub use spline::SplineEnds;
