//! The discrete Moser-Veselov map of free rotation, plain (order 2) and preprocessed (order 4).
//!
//! The discrete analogue of the free rigid body that is itself integrable: energy and `|L|` are conserved to round-off,
//! not only on average, and the map is symplectic and symmetric; only the speed along the polhode and the attitude are
//! in error. In quaternion form one equation per step is solved (`cayley_equation.rs`).
//!
//! Because energy H and `C = |L|^2/2` are constant, order 4 costs only other moments (Hairer and Vilmart 2006):
//!
//! ```text
//! 1/I~_j = (1 + h^2 s)/I_j + h^2 d,     P = I1 I2 I3,  S = I1 + I2 + I3
//! s = -(1/I1 + 1/I2 + 1/I3) H/3 + S C/(6 P),     d = S H/(6 P) - C/(3 P)
//! ```
//!
//! With loads the order-2 map is the drift of kick-drift-kick, and the order-4 map that of Blanes and Moan's
//! composition.
//! A step beyond about one radian may have no solution, which is reported. Sources: docs/REFERENCES.md, Moser and
//! Veselov 1991; Hairer and Vilmart 2006.

use super::IntegrationError;
use super::blanes_moan;
use super::cayley_equation::{Rule, asymmetry, turn};
use super::composition::STRANG;
use super::one_step::{OneStep, integrator_by_driver};
use super::split_step::{SplitStep, Turn};
use glam::{DQuat, DVec3};

/// The map of order 2.
#[derive(Debug)]
pub struct MoserVeselov(OneStep<SplitStep<Plain>>);

impl MoserVeselov {
    /// Without bodies until it is started.
    pub fn new() -> Self {
        Self(OneStep::new(SplitStep::new("moser-veselov", 2, &[1.0], STRANG)))
    }
}

impl Default for MoserVeselov {
    fn default() -> Self {
        Self::new()
    }
}

integrator_by_driver!(MoserVeselov);

/// The preprocessed map of order 4.
#[derive(Debug)]
pub struct MoserVeselov4(OneStep<SplitStep<Preprocessed>>);

impl MoserVeselov4 {
    /// Without bodies until it is started.
    pub fn new() -> Self {
        Self(OneStep::new(SplitStep::new("moser-veselov-4", 4, &[1.0], blanes_moan::STAGES)))
    }
}

impl Default for MoserVeselov4 {
    fn default() -> Self {
        Self::new()
    }
}

integrator_by_driver!(MoserVeselov4);

#[derive(Debug)]
struct Plain;

impl Turn for Plain {
    #[inline]
    fn turn(moments: DVec3, p: DVec3, h: f64) -> Result<DQuat, IntegrationError> {
        turn(Rule::MoserVeselov, p / moments * (0.5 * h), asymmetry(moments))
    }
}

#[derive(Debug)]
struct Preprocessed;

impl Turn for Preprocessed {
    #[inline]
    fn turn(moments: DVec3, p: DVec3, h: f64) -> Result<DQuat, IntegrationError> {
        let reciprocals = moments.recip();
        let energy = 0.5 * p.dot(p * reciprocals);
        let casimir = 0.5 * p.length_squared();
        let sum = moments.x + moments.y + moments.z;
        let product = (reciprocals.x * reciprocals.y) * reciprocals.z;
        let sixth = product * (1.0 / 6.0);
        let stretch = sum * casimir * sixth - (reciprocals.x + reciprocals.y + reciprocals.z) * energy * (1.0 / 3.0);
        let shift = (sum * energy - 2.0 * casimir) * sixth;
        let modified = reciprocals * (1.0 + h * h * stretch) + DVec3::splat(h * h * shift);
        // Also lets NaN through, which the state then shows.
        if modified.min_element() <= 0.0 {
            return Err(IntegrationError::NoConvergence { iterations: 0, change: f64::INFINITY });
        }
        turn(Rule::MoserVeselov, p * modified * (0.5 * h), asymmetry(modified.recip()))
    }
}
