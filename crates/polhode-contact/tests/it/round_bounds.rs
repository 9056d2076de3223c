//! Boxes around moving round shapes, and the mirror symmetry of round shapes.

use crate::support::{Flight, Random, capsule, cone, cylinder, floor, ring};
use polhode_contact::{Shape, mirror_defect, swept_aabb};
use polhode_spatial::{DVec3, Motion, Pose, Still, UnitVector};

/// The box of a cylinder or torus at rest is tight; that of a moving shape contains points of its surface at all times.
#[test]
fn swept_boxes() {
    let mut random = Random(3);
    let tilted = UnitVector::new(DVec3::new(1.0, 2.0, 2.0)).expect("a direction").get();
    let turn =
        polhode_spatial::Rotation::from_rotation_vector(DVec3::Z.cross(tilted).normalize() * libm::acos(tilted.z));
    let still = Still(Pose::new(turn, DVec3::X));
    let aabb = swept_aabb(&cylinder(0.3, 2.0), &still, 0.0, 1.0).expect("a box");
    let half = DVec3::new(1.0 / 3.0 + 0.3 * 8.0_f64.sqrt() / 3.0, 2.0 / 3.0 + 0.3 * 5.0_f64.sqrt() / 3.0, 0.0);
    assert!((aabb.max() - DVec3::X - half).truncate().length() < 1e-12, "{aabb:?}");
    let ring = ring(1.0, 0.25);
    let flat = swept_aabb(&ring, &Still(Pose::IDENTITY), 0.0, 1.0).expect("a box");
    assert!((flat.max() - DVec3::new(1.25, 1.25, 0.25)).length() < 1e-12, "{flat:?}");
    let floor = floor();
    for shape in [capsule(0.2, 0.5), cylinder(0.3, 0.6), cone(0.3, 0.7), ring] {
        for _ in 0..30 {
            let mut motion = Flight::new(random.pose(1.0), random.vector(), random.vector() * 3.0);
            motion.acceleration = random.vector() * 5.0;
            let aabb = swept_aabb(&shape, &motion, 0.2, 0.7).expect("a box");
            for k in 0..=20 {
                let pose = motion.pose(0.2 + 0.025 * f64::from(k));
                // The least distance of the shape from each side of the box, by the closed form of half-spaces.
                for (direction, bound) in
                    [(DVec3::Z, aabb.min().z), (-DVec3::X, -aabb.max().x), (DVec3::Y, aabb.min().y)]
                {
                    let side = UnitVector::new(direction).expect("a direction");
                    let plane = Shape::half_space(side);
                    let height = polhode_contact::separation(&shape, &pose, &plane, &Pose::IDENTITY);
                    assert!(height >= bound, "{shape:?} {height} {bound}");
                }
            }
        }
        assert!(swept_aabb(&shape, &still, 0.0, 1.0).is_ok_and(|aabb| aabb.is_finite()));
    }
    assert!(!swept_aabb(&floor, &still, 0.0, 1.0).expect("a box").is_finite());
}

/// A cylinder and a torus are symmetric in planes through the axis and in the plane across the middle; a cone only in
/// planes through the axis.
#[test]
fn mirrors() {
    let (across, through) = (UnitVector::Z, UnitVector::new(DVec3::new(1.0, 2.0, 0.0)).expect("a direction"));
    let slanted = UnitVector::new(DVec3::new(1.0, 2.0, 2.0)).expect("a direction");
    let ring = ring(1.0, 0.25);
    for shape in [cylinder(0.3, 0.6), capsule(0.3, 0.6), ring] {
        assert!(mirror_defect(&shape, across, 0.0) < 1e-15);
        assert!(mirror_defect(&shape, through, 0.0) < 1e-15);
        assert!(mirror_defect(&shape, slanted, 0.0) > 0.1);
        assert!((mirror_defect(&shape, across, 0.05) - 0.1).abs() < 1e-12);
    }
    let cone = cone(0.3, 0.7);
    assert!(mirror_defect(&cone, through, 0.0) < 1e-15);
    assert!(mirror_defect(&cone, across, -0.175) > 0.1);
}
