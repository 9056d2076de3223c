//! The velocity of a body's points, and the motion of a body that does not move.

use crate::random::{poses, vectors};
use polhode_spatial::{DVec3, Motion, MotionBounds, Pose, Rotation, Still, Velocity};
use proptest::prelude::*;

#[test]
fn rest_is_exact() {
    assert!(Velocity::ZERO.is_zero() && Velocity::default().is_zero());
    assert!(!Velocity::new(DVec3::ZERO, DVec3::new(0.0, 5e-324, 0.0)).is_zero());
    assert!(!Velocity::new(DVec3::new(f64::NAN, 0.0, 0.0), DVec3::ZERO).is_finite());
}

proptest! {
    /// The velocity of a point is the rate of change of its position: central difference of the pose, whose error is
    /// of second order in the step.
    #[test]
    fn velocity_of_a_point_is_a_derivative(
        pose in poses(3.0), v in vectors(2.0), w in vectors(2.0), p in vectors(2.0),
    ) {
        let velocity = Velocity::new(v, w);
        let at = |t: f64| {
            let turned = Rotation::from_rotation_vector(w * t) * pose.rotation;
            Pose::new(turned, pose.translation + v * t).transform_point(p)
        };
        let h = 1e-5;
        let difference = (at(h) - at(-h)) / (2.0 * h);
        let expected = velocity.at(pose.rotation.rotate(p));
        prop_assert!((difference - expected).length() < 1e-8, "{difference} {expected}");
    }

    /// Two points of a rigid body do not approach each other.
    #[test]
    fn rigid(v in vectors(2.0), w in vectors(2.0), p in vectors(2.0), q in vectors(2.0)) {
        let velocity = Velocity::new(v, w);
        prop_assert!((velocity.at(p) - velocity.at(q)).dot(p - q).abs() < 1e-13);
    }

    /// A body at rest is where it is at any time, and its bounds are zero.
    #[test]
    fn still(pose in poses(3.0), t in any::<f64>()) {
        let still = Still(pose);
        prop_assert_eq!(still.pose(t), pose);
        prop_assert!(still.velocity(t).is_zero());
        prop_assert_eq!(still.bounds(0.0, t), MotionBounds::default());
    }
}
