//! Random attitudes: all rotations are as probable as each other.
//!
//! From three shares u, v, w of (0, 1), the unit quaternion `[sqrt(u) cos 2 pi w, sqrt(1-u) sin 2 pi v,
//! sqrt(1-u) cos 2 pi v, sqrt(u) sin 2 pi w]` is uniform on the sphere of four dimensions. The shares of a throw are
//! those of a sweep, and depend on the seed, the number of the throw and nothing else. Source: docs/REFERENCES.md,
//! Shoemake 1992.

use crate::sweep::share;
use polhode::spatial::Rotation;
use std::f64::consts::TAU;

/// The attitude of a throw.
pub(super) fn attitude(seed: u64, throw: u64) -> Rotation {
    let [u, v, w] = ["attitude.u", "attitude.v", "attitude.w"].map(|name| share(seed, throw, name));
    let ((sv, cv), (sw, cw)) = (libm::sincos(TAU * v), libm::sincos(TAU * w));
    let (a, b) = (u.sqrt(), (1.0 - u).sqrt());
    Rotation::renormalized(polhode::spatial::DQuat::from_xyzw(b * sv, b * cv, a * sw, a * cw))
}

#[cfg(test)]
mod tests {
    //! The attitudes of a seed are uniform: moments of a turned vector, and of the trace of the rotation.
    use super::attitude;
    use polhode::spatial::DVec3;

    /// Of a unit vector that is turned uniformly, each component has mean 0 and mean square 1/3; the share of rotations
    /// by an angle below t is (t - sin t)/pi.
    #[test]
    fn attitudes_are_uniform() {
        const COUNT: u32 = 20_000;
        let all: Vec<_> = (0..COUNT).map(|throw| attitude(5, u64::from(throw))).collect();
        let own = DVec3::new(0.6, 0.0, 0.8);
        let (mut mean, mut squares) = (DVec3::ZERO, DVec3::ZERO);
        for rotation in &all {
            let turned = rotation.rotate(own);
            mean += turned / f64::from(COUNT);
            squares += turned * turned / f64::from(COUNT);
        }
        let deviation = (1.0 / 3.0 / f64::from(COUNT)).sqrt();
        assert!(mean.abs().max_element() < 4.0 * deviation, "{mean}");
        assert!((squares - DVec3::splat(1.0 / 3.0)).abs().max_element() < 4.0 * deviation, "{squares}");
        let below = |angle: f64| all.iter().filter(|own| own.to_rotation_vector().length() < angle).count();
        for angle in [1.0_f64, 2.0, 2.8] {
            let share = (angle - libm::sin(angle)) / std::f64::consts::PI;
            let found = below(angle) as f64 / f64::from(COUNT);
            let error = (share * (1.0 - share) / f64::from(COUNT)).sqrt();
            assert!((found - share).abs() < 4.0 * error, "{angle}: {found} {share}");
        }
    }
}
