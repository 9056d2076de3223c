//! Free rotation does not depend on how it is described: world turned, axes renamed, mirrored, time reversed, split.

use crate::support::{cases, direction, moments, rotation};
use glam::{DQuat, DVec3};
use polhode_dynamics::exact_rotation::drift;
use polhode_spatial::Rotation;
use proptest::prelude::*;

/// How much rounding the motion may amplify: the products below turn by at most 3 rad about any axis, and
/// exp(3) = 20.
const TOLERANCE: f64 = 1e-13;

/// Time in which the fastest possible rate turns by 3 rad.
fn short_time(moments: DVec3, momentum: DVec3, fraction: f64) -> f64 {
    3.0 * fraction * moments.min_element() / momentum.length()
}

proptest! {
    #![proptest_config(cases(300))]

    /// There and back again.
    #[test]
    fn time_reverses(i in moments(2.0), l in direction(), r in rotation(), f in -1.0..1.0f64) {
        let h = short_time(i, l, f);
        let there = drift(i, r, l, h);
        prop_assert!(drift(i, there, l, -h).angle_to(r) < TOLERANCE);
    }

    /// Two drifts are one of both times.
    #[test]
    fn times_add(i in moments(1.0), l in direction(), r in rotation(), f in -1.0..1.0f64, g in -1.0..1.0f64) {
        let (h, k) = (short_time(i, l, f), short_time(i, l, g));
        let twice = drift(i, drift(i, r, l, h), l, k);
        prop_assert!(twice.angle_to(drift(i, r, l, h + k)) < 5.0 * TOLERANCE);
    }

    /// Turning the world turns the answer.
    #[test]
    fn world_has_no_direction(
        i in moments(2.0), l in direction(), r in rotation(), w in rotation(), f in -1.0..1.0f64,
    ) {
        let h = short_time(i, l, f);
        let turned = drift(i, w * r, w.rotate(l), h);
        prop_assert!(turned.angle_to(w * drift(i, r, l, h)) < TOLERANCE);
    }

    /// Renaming the axes, by even and odd permutations, changes nothing. (An odd one turns an axis round to stay
    /// right-handed: here the third.)
    #[test]
    fn axes_have_no_names(i in moments(2.0), l in direction(), f in -1.0..1.0f64) {
        let h = 5.0 * short_time(i, l, f);
        let reference = drift(i, Rotation::IDENTITY, l, h).quaternion();
        let cyclic = |v: DVec3| DVec3::new(v.y, v.z, v.x);
        let q = drift(cyclic(i), Rotation::IDENTITY, cyclic(l), h).quaternion();
        prop_assert!(distance(q, DQuat::from_xyzw(reference.y, reference.z, reference.x, reference.w)) < TOLERANCE);
        let swapped = drift(DVec3::new(i.y, i.x, i.z), Rotation::IDENTITY, DVec3::new(l.y, l.x, -l.z), h).quaternion();
        let expected = DQuat::from_xyzw(reference.y, reference.x, -reference.z, reference.w);
        prop_assert!(distance(swapped, expected) < TOLERANCE);
    }

    /// In a mirror angular momentum, an axial vector, turns round along the plane, and so does the rotation.
    #[test]
    fn mirror_image_moves_as_the_mirror_shows(i in moments(2.0), l in direction(), f in -1.0..1.0f64) {
        let h = 5.0 * short_time(i, l, f);
        let reference = drift(i, Rotation::IDENTITY, l, h).quaternion();
        let mirrored = drift(i, Rotation::IDENTITY, DVec3::new(l.x, -l.y, -l.z), h).quaternion();
        let expected = DQuat::from_xyzw(reference.x, -reference.y, -reference.z, reference.w);
        prop_assert!(distance(mirrored, expected) < TOLERANCE);
    }

    /// Twice the momentum in half the time is the same turn.
    #[test]
    fn speed_scales_time(i in moments(2.0), l in direction(), f in -1.0..1.0f64, scale in 0.01..100.0f64) {
        let h = 5.0 * short_time(i, l, f);
        let scaled = drift(i, Rotation::IDENTITY, l * scale, h / scale);
        prop_assert!(scaled.angle_to(drift(i, Rotation::IDENTITY, l, h)) < 5.0 * TOLERANCE);
    }
}

fn distance(a: DQuat, b: DQuat) -> f64 {
    (a - b).length().min((a + b).length())
}
