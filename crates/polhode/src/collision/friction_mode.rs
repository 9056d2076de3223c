//! Friction of an active contact until the next event: whether its bodies stick to each other or slip.
//!
//! Within a smooth phase the mode is fixed. A contact that sticks keeps the rate of its slip `u_T' = 0` by a tangential
//! force of any direction (rolling is sticking: the contact point moves over both bodies, the slip is zero). One that
//! slides bears the force `-mu f_n d` with `d = u_T / |u_T|`.
//!
//! The direction of a slip that has passed zero is continued as if the slip had not: `d = -u_T / |u_T|` where `u_T`
//! points against the direction at the start of the step. That makes the equations smooth past the instant at which the
//! slip vanishes, which an integrator of high order and the location of that instant need.

use polhode_spatial::DVec3;

/// Coulomb's coefficients of a pair of bodies with friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FrictionCoefficients {
    /// Of a contact that sticks.
    pub(crate) at_rest: f64,
    /// Of a contact that slides.
    pub(crate) sliding: f64,
}

/// How an active contact with friction behaves along its tangent plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum FrictionMode {
    /// The bodies do not slip on each other.
    Sticking,
    /// A slips over B in about this direction (unit vector, world): that of the slip at the start of the step, or that
    /// in which the slip begins to grow from zero.
    Sliding(DVec3),
}

impl FrictionMode {
    /// The direction of a slip `u_T` (m/s), continued smoothly through zero; the direction at the start where the slip is
    /// below `negligible` (m/s). None for a contact that sticks.
    pub(crate) fn direction(self, slip: DVec3, negligible: f64) -> Option<DVec3> {
        let Self::Sliding(start) = self else { return None };
        let speed = slip.length();
        let along = slip.dot(start);
        match () {
            () if speed <= negligible || along == 0.0 => Some(start),
            () if along > 0.0 => Some(slip / speed),
            () => Some(-slip / speed),
        }
    }
}
