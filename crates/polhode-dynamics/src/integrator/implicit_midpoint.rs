//! The implicit midpoint rule of free rotation: the energy-momentum method of Simo and Wong.
//!
//! `p+ - p = h p_m x I^-1 p_m` with `p_m = (p + p+)/2` in principal axes, and the turn of the attitude by Cayley's map
//! of `h I^-1 p_m/2`, for which `p+ = R^T p` exactly. Energy, `|p|` and L are conserved to round-off at any step, and
//! the map is symmetric; order 2, with an error some ten times that of [`super::splitting`]. The equation is solved in
//! `cayley_equation.rs`. With loads it is the drift of kick-drift-kick.
//! Sources: docs/REFERENCES.md, Simo and Wong 1991; Austin, Krishnaprasad and Wang 1993.

use super::IntegrationError;
use super::cayley_equation::{Rule, asymmetry, turn};
use super::composition::STRANG;
use super::one_step::{OneStep, integrator_by_driver};
use super::split_step::{SplitStep, Turn};
use glam::{DQuat, DVec3};

/// The method.
#[derive(Debug)]
pub struct ImplicitMidpoint(OneStep<SplitStep<Midpoint>>);

impl ImplicitMidpoint {
    /// Without bodies until it is started.
    pub fn new() -> Self {
        Self(OneStep::new(SplitStep::new("implicit-midpoint", 2, &[1.0], STRANG)))
    }
}

impl Default for ImplicitMidpoint {
    fn default() -> Self {
        Self::new()
    }
}

integrator_by_driver!(ImplicitMidpoint);

#[derive(Debug)]
struct Midpoint;

impl Turn for Midpoint {
    #[inline]
    fn turn(moments: DVec3, p: DVec3, h: f64) -> Result<DQuat, IntegrationError> {
        turn(Rule::Midpoint, p / moments * (0.5 * h), asymmetry(moments))
    }
}
