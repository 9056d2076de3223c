//! Ten thousand free bodies, different and asymmetric, that tumble under gravity.
//!
//! Their numbers come from Weyl sequences `frac(k a)`, which fill an interval evenly and are the same in every run.

use polhode::dynamics::{BodyState, RigidBody};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, Velocity};

/// How many bodies.
pub(crate) const BODIES: usize = 10_000;

/// Ranges of the principal moments, kg m^2: bodies of about (1, 2, 3), all of which a real body can have.
const MOMENTS: [(f64, f64); 3] = [(1.0, 1.3), (1.9, 2.1), (2.6, 2.9)];

/// Range of the angular speed, rad/s.
const ANGULAR_SPEED: (f64, f64) = (1.0, 6.0);

/// Side of the cube that the bodies start in, m, and range of their speed along each axis, m/s.
const SIDE: f64 = 10.0;
const SPEED: (f64, f64) = (-5.0, 5.0);

/// Fractional parts of these (the square roots of primes) are irrational and independent.
const GENERATORS: [f64; 13] = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0, 23.0, 29.0, 31.0, 37.0, 41.0];

/// A body with its state at the start.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TumblingBody {
    pub(crate) mass: f64,
    pub(crate) moments: DVec3,
    pub(crate) properties: MassProperties,
    pub(crate) pose: Pose,
    pub(crate) velocity: Velocity,
}

impl TumblingBody {
    /// Body number `k`, or nothing if its numbers were no body's.
    fn new(k: usize) -> Option<Self> {
        let fraction = |i: usize| (GENERATORS[i].sqrt() * (k + 1) as f64).fract();
        let within = |i: usize, (low, high): (f64, f64)| low + (high - low) * fraction(i);
        let vector =
            |i: usize, range: (f64, f64)| DVec3::new(within(i, range), within(i + 1, range), within(i + 2, range));
        let moments = DVec3::new(within(0, MOMENTS[0]), within(1, MOMENTS[1]), within(2, MOMENTS[2]));
        let mass = 1.0;
        let direction = vector(3, (-1.0, 1.0)).normalize_or_zero();
        Some(Self {
            mass,
            moments,
            properties: MassProperties::new(Mass::new(mass).ok()?, DVec3::ZERO, Inertia::from_diagonal(moments).ok()?),
            pose: Pose::new(Rotation::from_rotation_vector(vector(8, (-1.5, 1.5))), vector(6, (0.0, SIDE))),
            velocity: Velocity::new(vector(9, SPEED), direction * within(12, ANGULAR_SPEED)),
        })
    }

    /// For dynamics.
    #[allow(dead_code, reason = "not every bench goes below the facade")]
    pub(crate) fn rigid_body(&self) -> RigidBody {
        RigidBody::new(&self.properties)
    }

    /// State at the start.
    #[allow(dead_code, reason = "not every bench goes below the facade")]
    pub(crate) fn state(&self) -> BodyState {
        self.rigid_body().at_velocity(self.pose, self.velocity)
    }
}

/// All of them.
pub(crate) fn tumbling_bodies() -> Vec<TumblingBody> {
    (0..BODIES).filter_map(TumblingBody::new).collect()
}
