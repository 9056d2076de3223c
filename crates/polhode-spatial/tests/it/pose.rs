//! Poses form a group that acts on points, without loss of digits far from the origin.

use crate::random::{assert_vector, poses, rotations, vectors};
use polhode_spatial::{DVec3, Pose};
use proptest::prelude::*;

/// Two bodies a million metres from the origin, a centimetre apart: their relative pose has all its digits.
#[test]
fn relative_pose_far_from_the_origin() {
    let far = DVec3::new(1048576.0, -2097152.0, 3145728.0);
    let gap = DVec3::new(0.0078125, 0.015625, 0.0);
    let relative = Pose::from_translation(far).relative(&Pose::from_translation(far + gap));
    assert_eq!(relative.translation, gap);
}

#[test]
fn what_is_not_finite_is_seen() {
    assert!(Pose::IDENTITY.is_finite() && Pose::default() == Pose::IDENTITY);
    assert!(!Pose::from_translation(DVec3::new(0.0, f64::NAN, 0.0)).is_finite());
}

proptest! {
    /// Composition acts as one pose after the other; it is associative; the inverse undoes it.
    #[test]
    fn group(a in poses(10.0), b in poses(10.0), c in poses(10.0), q in vectors(10.0)) {
        assert_vector((a * b).transform_point(q), a.transform_point(b.transform_point(q)), 30.0, 1e-14);
        assert_vector(((a * b) * c).transform_point(q), (a * (b * c)).transform_point(q), 40.0, 1e-14);
        assert_vector(a.inverse().transform_point(a.transform_point(q)), q, 20.0, 1e-14);
        assert_vector(a.inverse_transform_point(a.transform_point(q)), q, 20.0, 1e-14);
    }

    /// The relative pose is the inverse of one times the other.
    #[test]
    fn relative(a in poses(10.0), b in poses(10.0), q in vectors(10.0)) {
        assert_vector(a.relative(&b).transform_point(q), (a.inverse() * b).transform_point(q), 30.0, 1e-14);
        assert_vector((a * a.relative(&b)).transform_point(q), b.transform_point(q), 30.0, 1e-14);
    }

    /// Distances between points are kept.
    #[test]
    fn rigid(a in poses(10.0), p in vectors(10.0), q in vectors(10.0)) {
        let distance = a.transform_point(p).distance(a.transform_point(q));
        prop_assert!((distance - p.distance(q)).abs() < 4e-14);
    }

    /// A common shift by 2^20 m of two frames on a binary grid does not change their relative pose by a bit.
    #[test]
    fn relative_pose_does_not_see_the_origin(r in rotations(), p in vectors(4.0), q in vectors(4.0)) {
        let grid = f64::from(1 << 20);
        let [p, q] = [p, q].map(|v| (v * grid).round() / grid);
        let (a, b) = (Pose::new(r, p), Pose::new(r.inverse(), q));
        let shift = |x: Pose| Pose::new(x.rotation, x.translation + DVec3::splat(grid));
        prop_assert_eq!(a.relative(&b), shift(a).relative(&shift(b)));
    }
}
