//! Orientations between two frames, by the angular velocities of both.
//!
//! Two orientations alone leave open how often, and which way, a body has turned from one to the other: the shortest
//! way is wrong from half a turn on. With the mean w of the angular velocities at both ends, a time h apart,
//!
//! ```text
//! R(s) = exp(s rho) exp(s h w) R_0    with    rho = the rotation vector of R_1 (exp(h w) R_0)^-1,    s from 0 to 1
//! ```
//!
//! goes through both orientations; for a constant angular velocity it is exact over any number of turns, and the
//! shortest way where the body stands. It fails where the angular velocity changes between frames by so much that h w
//! is wrong by half a turn. The viewer does the same (`viewer/src/rotation.js`).

use polhode::spatial::{DVec3, Rotation};

/// An orientation (body to world) with the angular velocity in the world, rad/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Turning {
    pub(crate) rotation: Rotation,
    pub(crate) angular_velocity: DVec3,
}

impl Turning {
    /// Angle from here to another frame `h` (s) later, along the way that the body turns, rad.
    pub(crate) fn angle_to(&self, next: &Self, h: f64) -> f64 {
        self.mean_turn(next, h).length()
    }

    /// Orientation at the fraction `s` of the time to another frame `h` (s) later.
    pub(crate) fn towards(&self, next: &Self, h: f64, s: f64) -> Rotation {
        let turn = self.mean_turn(next, h);
        let reached = Rotation::from_rotation_vector(turn) * self.rotation;
        let rest = (next.rotation * reached.inverse()).to_rotation_vector();
        Rotation::from_rotation_vector(rest * s) * (Rotation::from_rotation_vector(turn * s) * self.rotation)
    }

    fn mean_turn(&self, next: &Self, h: f64) -> DVec3 {
        (self.angular_velocity + next.angular_velocity) * (0.5 * h)
    }
}

#[cfg(test)]
mod tests {
    //! A constant spin is exact at any speed, and both ends are met whatever the spins are.
    use super::*;

    #[test]
    fn fast_spins_turn_forwards() {
        for (spin, h) in [(250.0, 1.0 / 60.0), (-250.0, 1.0 / 60.0), (1000.0, 0.04), (3.0, 0.1), (0.0, 1.0)] {
            let w = DVec3::new(0.6, 0.0, 0.8) * spin;
            let at = |t: f64| Rotation::from_rotation_vector(w * t) * Rotation::from_rotation_vector(DVec3::X);
            let frame = |t: f64| Turning { rotation: at(t), angular_velocity: w };
            for s in [0.0, 0.1, 0.5, 0.9, 1.0] {
                assert!(frame(0.2).towards(&frame(0.2 + h), h, s).angle_to(at(0.2 + s * h)) < 1e-12, "{spin} {s}");
            }
        }
    }

    #[test]
    fn ends_are_met() {
        let start = Turning { rotation: Rotation::IDENTITY, angular_velocity: DVec3::new(90.0, 3.0, -7.0) };
        let rotation = Rotation::from_rotation_vector(DVec3::new(0.3, -1.0, 2.0));
        let end = Turning { rotation, angular_velocity: DVec3::ZERO };
        assert!(start.towards(&end, 0.1, 0.0).angle_to(start.rotation) < 1e-14);
        assert!(start.towards(&end, 0.1, 1.0).angle_to(end.rotation) < 1e-12);
    }
}
