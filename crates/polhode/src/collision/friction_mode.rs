//! Friction of an active contact until the next event: whether its bodies stick to each other or slip.
//!
//! Within a smooth phase the mode is fixed. A contact that sticks keeps the rate of its slip `u_T' = 0` by a tangential
//! force of any direction (rolling is sticking: the contact point moves over both bodies, the slip is zero). One that
//! slides bears the force `-mu f_n d` with `d = u_T / |u_T|`.
//!
//! The direction of a slip that has passed zero is continued as if the slip had not: `d = -u_T / |u_T|` where `u_T`
//! points against the direction at the start of the step. That makes the equations smooth past the instant at which the
//! slip vanishes, which an integrator of high order and the location of that instant need. Directions differ from that
//! at the start of the step only where the slip leaves it by more than rounding.

use crate::scene::FrictionEllipse;
use polhode_spatial::DVec3;

/// Slips below this fraction of their speed at the start of the step vanish together with the one that has been located
/// (1e-12 to 1e-7).
const STOPPED_SLIP: f64 = 1e-9;

/// A slip below this many times the rounding error of slips has vanished (10 to 1e4): the contacts of a body that turns
/// while it slides stop together, and their directions turn ever faster before.
const STOPPED_NOISE: f64 = 100.0;

/// A slip that points against its direction at the start of the step has stopped if it is below this fraction of its
/// speed there (1e-9 to 1e-4). A faster one has turned.
const TURNED_SLIP: f64 = 1e-6;

/// Coulomb's coefficients of a pair of bodies with friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FrictionCoefficients {
    /// Of a contact that sticks.
    pub(crate) at_rest: FrictionEllipse,
    /// Of a contact that slides.
    pub(crate) sliding: FrictionEllipse,
}

/// Lengths (m) that give the largest moments of friction of a pair of bodies, times the normal force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RotationalFriction {
    /// About axes in the tangent plane.
    pub(crate) rolling: f64,
    /// About the normal.
    pub(crate) spinning: f64,
}

/// How an active contact with friction behaves along its tangent plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum FrictionMode {
    /// The bodies do not slip on each other.
    Sticking,
    /// A slips over B.
    Sliding(Slide),
}

/// The slip of a contact at the start of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Slide {
    /// Direction of the slip, or that in which it begins to grow from zero; unit vector, world.
    pub(crate) direction: DVec3,
    /// Its speed, m/s; zero where it begins to grow.
    pub(crate) speed: f64,
    /// Rounding error of slips, m/s.
    pub(crate) noise: f64,
}

impl Slide {
    /// A slip that begins to grow from zero.
    pub(crate) fn beginning(direction: DVec3, noise: f64) -> Self {
        Self { direction, speed: 0.0, noise }
    }

    /// Component of a slip (m/s) along the direction at the start.
    pub(crate) fn along(&self, slip: DVec3) -> f64 {
        slip.dot(self.direction)
    }

    /// The direction of a slip `u_T` (m/s), continued smoothly through zero. A component across the direction at the
    /// start that is within rounding does not count: where the slip is small it would turn the friction at random, and
    /// friction resists it at the rate `mu g / |u_T|`, which no step could follow.
    pub(crate) fn direction_of(&self, slip: DVec3) -> DVec3 {
        let along = self.along(slip);
        let across = slip - self.direction * along;
        let width = across.length();
        if width <= self.noise {
            return self.direction;
        }
        let across = across * (1.0 - self.noise / width);
        let sign = if along < 0.0 { -1.0 } else { 1.0 };
        let forward = self.direction * along.abs() + across * sign;
        forward / forward.length()
    }

    /// The speed below which a slip cannot be distinguished from none, m/s.
    pub(crate) fn zero_speed(&self) -> f64 {
        STOPPED_NOISE * self.noise
    }

    /// Whether a slip (m/s) at the end of a step is zero to the error of the step.
    pub(crate) fn has_vanished(&self, slip: DVec3) -> bool {
        let share = if self.along(slip) <= 0.0 { TURNED_SLIP } else { STOPPED_SLIP };
        slip.length() <= (share * self.speed).max(self.zero_speed())
    }

    /// The same contact at the start of a later step, with this slip (m/s).
    pub(crate) fn renewed(&self, slip: DVec3) -> Self {
        Self { direction: self.direction_of(slip), speed: slip.length(), ..*self }
    }
}
