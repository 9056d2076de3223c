//! NaN, infinity, huge and tiny numbers: answers without meaning are marked as such, and nothing panics or hangs.

use crate::support::{Random, at, cuboid, prism};
use polhode_contact::{Shape, Workspace, manifold, manifold_with, separation};
use polhode_spatial::{DVec3, Pose, UnitVector};
use proptest::prelude::*;

fn shapes() -> Vec<Shape> {
    vec![
        cuboid(1.0, 1e-3, 7.0),
        prism(5, 1.0, 1.0),
        Shape::sphere(1e-6).expect("radius"),
        Shape::points(vec![DVec3::ZERO, DVec3::ONE]).expect("points"),
        Shape::half_space(UnitVector::Y),
    ]
}

/// Poses that are not finite give no contact and a separation that is not a number.
#[test]
fn poses_that_are_not_finite() {
    for a in shapes() {
        for b in shapes() {
            for x in [f64::NAN, f64::INFINITY] {
                let result = manifold(&a, &at(x, 0.0, 0.0), &b, &Pose::IDENTITY, 1.0);
                assert!(result.contacts.is_empty() && result.separation.is_nan());
                assert!(separation(&a, &Pose::IDENTITY, &b, &at(0.0, x, 0.0)).is_nan());
            }
            assert!(manifold(&a, &Pose::IDENTITY, &b, &Pose::IDENTITY, f64::NAN).contacts.is_empty());
        }
    }
}

/// A workspace that has served other pairs gives the same bits as a fresh one.
#[test]
fn workspaces_carry_nothing_over() {
    let mut random = Random(23);
    let mut workspace = Workspace::default();
    let shapes = shapes();
    for _ in 0..500 {
        let (i, j) = ((random.unit() * 5.0) as usize, (random.unit() * 5.0) as usize);
        let (pose_a, pose_b) =
            (Pose::new(random.rotation(), random.vector()), Pose::new(random.rotation(), random.vector()));
        let kept = manifold_with(&mut workspace, &shapes[i], &pose_a, &shapes[j], &pose_b, 0.5);
        assert_eq!(kept, manifold(&shapes[i], &pose_a, &shapes[j], &pose_b, 0.5));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    /// Any finite poses and reach: every contact is finite, within reach, of unit normal, and the features are unique.
    #[test]
    fn any_poses(place in prop::array::uniform3(-3.0..3.0_f64), turn in prop::array::uniform3(-4.0..4.0_f64),
        snap in 0..3, exponent in -12..12_i32, reach in -1.0..2.0_f64, kinds in (0..5_usize, 0..5_usize)) {
        // Snapped poses give touching, aligned and coincident features.
        let snapped = |v: [f64; 3], to: f64| DVec3::from_array(v.map(|c| if snap > 0 { (c / to).round() * to } else { c }));
        let turn = polhode_spatial::Rotation::from_rotation_vector(
            if snap == 2 { DVec3::ZERO } else { snapped(turn, std::f64::consts::FRAC_PI_4) });
        let place = snapped(place, 0.5) * 10_f64.powi(exponent.max(0));
        let shapes = shapes();
        let result = manifold(&shapes[kinds.0], &Pose::new(turn, place), &shapes[kinds.1], &Pose::IDENTITY, reach);
        for pair in result.contacts.windows(2) {
            prop_assert!(pair[0].feature < pair[1].feature);
        }
        for contact in &result.contacts {
            prop_assert!(contact.geometry.point.is_finite());
            prop_assert!((contact.geometry.normal.length() - 1.0).abs() < 1e-12);
            prop_assert!(contact.geometry.separation <= reach.max(1e-9));
        }
    }
}
