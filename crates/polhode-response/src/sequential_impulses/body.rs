//! A body as sequential impulses know it: what an impulse does to it, its velocity, and how far it has come in this
//! step.

use super::lanes::{Lanes, Symmetric, Vectors, by_place};
use polhode_spatial::{DMat3, DVec3};

/// A body: its velocity is changed by impulses, its displacement by whoever integrates it.
///
/// The inverse inertia is that at the start of the step, world axes. A body that no impulse moves has zero for both
/// inverses.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C, align(64))]
pub struct ImpulseBody {
    linear: [f64; 3],
    inverse_mass: f64,
    angular: [f64; 3],
    unused: f64,
    // A line of the cache for what all sweeps read, one for each of the others.
    inverse_inertia: [f64; 6],
    unused_too: [f64; 2],
    moved: [f64; 3],
    turned: [f64; 3],
    mean_linear: [f64; 3],
    mean_angular: [f64; 3],
}

impl ImpulseBody {
    /// A body at rest at the start of a step, with its inverse mass (1/kg) and inverse inertia (1/(kg m^2), world).
    pub fn new(inverse_mass: f64, inverse_inertia: DMat3) -> Self {
        let [x, y, z] = [inverse_inertia.x_axis, inverse_inertia.y_axis, inverse_inertia.z_axis];
        Self {
            linear: [0.0; 3],
            inverse_mass,
            angular: [0.0; 3],
            unused: 0.0,
            unused_too: [0.0; 2],
            moved: [0.0; 3],
            turned: [0.0; 3],
            inverse_inertia: [x.x, x.y, x.z, y.y, y.z, z.z],
            mean_linear: [0.0; 3],
            mean_angular: [0.0; 3],
        }
    }

    /// One that no impulse moves.
    pub fn immovable() -> Self {
        Self::new(0.0, DMat3::ZERO)
    }

    /// Inverse mass, 1/kg.
    pub fn inverse_mass(&self) -> f64 {
        self.inverse_mass
    }

    /// Inverse inertia about the centre of mass, world, 1/(kg m^2).
    pub fn inverse_inertia(&self) -> DMat3 {
        let [xx, xy, xz, yy, yz, zz] = self.inverse_inertia;
        DMat3::from_cols(DVec3::new(xx, xy, xz), DVec3::new(xy, yy, yz), DVec3::new(xz, yz, zz))
    }

    /// Whether an impulse moves it.
    pub(super) fn is_moved(&self) -> bool {
        self.inverse_mass > 0.0 || self.inverse_inertia != [0.0; 6]
    }

    /// Velocity of the centre of mass, m/s, world.
    pub fn linear(&self) -> DVec3 {
        DVec3::from_array(self.linear)
    }

    /// Angular velocity, rad/s, world.
    pub fn angular(&self) -> DVec3 {
        DVec3::from_array(self.angular)
    }

    /// Sets both velocities.
    pub fn set_velocity(&mut self, linear: DVec3, angular: DVec3) {
        (self.linear, self.angular) = (linear.to_array(), angular.to_array());
    }

    /// Sets the mean of both velocities at the start and at the end of a substep: impulses of the substep do their work
    /// along it.
    pub fn set_mean_velocity(&mut self, linear: DVec3, angular: DVec3) {
        (self.mean_linear, self.mean_angular) = (linear.to_array(), angular.to_array());
    }

    /// Sets how far the centre of mass has come since the start of the step (m), and how far the body has turned
    /// (rotation vector, rad).
    pub fn set_displacement(&mut self, moved: DVec3, turned: DVec3) {
        (self.moved, self.turned) = (moved.to_array(), turned.to_array());
    }
}

/// Bodies in lanes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Gathered<L> {
    pub(super) linear: Vectors<L>,
    pub(super) angular: Vectors<L>,
    pub(super) inverse_mass: L,
    pub(super) inverse_inertia: Symmetric<L>,
}

/// One vector of each of these bodies.
#[inline(always)]
fn gathered<L: Lanes>(bodies: &[ImpulseBody], numbers: &[u32], part: fn(&ImpulseBody) -> &[f64; 3]) -> Vectors<L> {
    let of = |lane: usize| part(&bodies[numbers[lane] as usize]);
    Vectors {
        x: L::from_lanes(|lane| of(lane)[0]),
        y: L::from_lanes(|lane| of(lane)[1]),
        z: L::from_lanes(|lane| of(lane)[2]),
    }
}

/// A vector of translation and one of rotation of each body.
#[derive(Debug, Clone, Copy)]
pub(super) struct Twist<L> {
    pub(super) linear: Vectors<L>,
    pub(super) angular: Vectors<L>,
}

impl<L: Lanes> Twist<L> {
    /// How far the bodies have come since the start of the step.
    #[inline(always)]
    pub(super) fn displacements(bodies: &[ImpulseBody], numbers: &[u32]) -> Self {
        Self {
            linear: gathered(bodies, numbers, |body| &body.moved),
            angular: gathered(bodies, numbers, |body| &body.turned),
        }
    }

    /// Their mean velocities over a substep.
    #[inline(always)]
    pub(super) fn means(bodies: &[ImpulseBody], numbers: &[u32]) -> Self {
        Self {
            linear: gathered(bodies, numbers, |body| &body.mean_linear),
            angular: gathered(bodies, numbers, |body| &body.mean_angular),
        }
    }
}

impl<L: Lanes> Gathered<L> {
    /// The bodies of these numbers, one for each lane.
    #[inline(always)]
    pub(super) fn load(bodies: &[ImpulseBody], numbers: &[u32]) -> Self {
        let of = |lane: usize| &bodies[numbers[lane] as usize];
        Self {
            linear: gathered(bodies, numbers, |body| &body.linear),
            angular: gathered(bodies, numbers, |body| &body.angular),
            inverse_mass: L::from_lanes(|lane| of(lane).inverse_mass),
            inverse_inertia: Symmetric {
                entries: by_place(L::splat(0.0), |k| L::from_lanes(|lane| of(lane).inverse_inertia[k])),
            },
        }
    }

    /// Writes the velocities back.
    #[inline(always)]
    pub(super) fn store_velocities(&self, bodies: &mut [ImpulseBody], numbers: &[u32]) {
        let (v, w) = (&self.linear, &self.angular);
        for lane in 0..L::WIDTH {
            let body = &mut bodies[numbers[lane] as usize];
            body.linear = [v.x.lane(lane), v.y.lane(lane), v.z.lane(lane)];
            body.angular = [w.x.lane(lane), w.y.lane(lane), w.z.lane(lane)];
        }
    }

    /// Its velocities.
    #[inline(always)]
    pub(super) fn twist(&self) -> Twist<L> {
        Twist { linear: self.linear, angular: self.angular }
    }

    /// An impulse with its moment about the centre of mass acts.
    #[inline(always)]
    pub(super) fn take(&mut self, impulse: Vectors<L>, moment: Vectors<L>) {
        self.linear = self.linear + impulse.times(self.inverse_mass);
        self.angular = self.angular + self.inverse_inertia.times(moment);
    }

    /// The opposite of the impulse.
    #[inline(always)]
    pub(super) fn give(&mut self, impulse: Vectors<L>, moment: Vectors<L>) {
        self.linear = self.linear - impulse.times(self.inverse_mass);
        self.angular = self.angular - self.inverse_inertia.times(moment);
    }
}
