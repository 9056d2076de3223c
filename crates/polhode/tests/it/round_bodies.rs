//! Round bodies that have struck each other without restitution part as slowly as their surfaces curve: the search for
//! their next impact must not count on the gap, which stays near zero for long.

use crate::support::{ball, run};
use polhode::contact::Shape;
use polhode::mesh::Capsule;
use polhode::spatial::{DVec3, Mass, Pose, Rotation, Velocity};
use polhode::{Body, Effects, Scene};
use std::f64::consts::FRAC_PI_2;

/// Two capsules side by side, one of which flies into the other off its middle: momentum stays, and the run ends.
#[test]
fn capsules_that_have_met_without_restitution_part() {
    let lying = Rotation::from_rotation_vector(DVec3::X * FRAC_PI_2);
    let capsule = |name: &str, center: DVec3, velocity: DVec3| {
        let properties = Capsule::new(0.1, 1.0).unwrap().solid(Mass::new(1.0).unwrap()).unwrap();
        Body::movable(name, properties)
            .geometry(Shape::capsule(0.1, 1.0).unwrap().into())
            .pose(Pose::new(lying, center))
            .velocity(Velocity::new(velocity, DVec3::ZERO))
    };
    let scene = Scene::builder("capsules")
        .gravity(DVec3::ZERO)
        .duration_s(1.0)
        .body(capsule("a", DVec3::ZERO, DVec3::ZERO))
        .body(capsule("b", DVec3::new(0.1, 0.15, 0.6), DVec3::NEG_Z * 2.0))
        .build()
        .unwrap();
    let (report, _) = run(&scene, Effects::Planned);
    let momentum: DVec3 = report.bodies.iter().map(|(_, sample)| sample.velocity.linear).sum();
    assert!((momentum + DVec3::Z * 2.0).length() < 1e-14, "{momentum}");
    assert!(report.certificate.max_penetration_m < 1e-12);
}

/// A ball that falls through a ring off its middle: it is turned aside by the inner side and goes on.
#[test]
fn ball_that_has_met_the_inside_of_a_ring_goes_through() {
    let scene = Scene::builder("ring")
        .duration_s(1.0)
        .body(Body::fixed("ring").geometry(Shape::torus(0.4, 0.1).unwrap().into()))
        .body(ball("ball", 1.0, 0.25, DVec3::new(0.1, 0.05, 1.0), DVec3::ZERO))
        .build()
        .unwrap();
    let (report, _) = run(&scene, Effects::Planned);
    let end = report.bodies[1].1.pose.translation;
    assert!(end.z < -1.0 && end.x < 0.0 && (end.x - 2.0 * end.y).abs() < 1e-12, "{end}");
}

/// Bodies on the axis of a ring meet it all along a circle: they come to rest on it, straight up, also when they stand off
/// the axis by as little as rounding leaves. A ball of radius r on the middle line of radius R of a tube of radius a rests
/// at a height of `sqrt((r + a)^2 - R^2)`, an equal ring at `2 a`.
#[test]
fn bodies_on_the_axis_of_a_ring_rest_on_it() {
    let ring = || Shape::torus(0.4, 0.1).unwrap();
    let on_ring = |upper: Body| {
        let lower = Body::fixed("ring").geometry(ring().into());
        let scene = Scene::builder("on a ring").duration_s(2.0).body(lower).body(upper).build().unwrap();
        let (report, _) = run(&scene, Effects::Planned);
        assert!(report.certificate.max_penetration_m < 1e-12);
        report.bodies[1].1.pose.translation
    };
    for aside in [0.0, 1e-12, 1e-9] {
        let end = on_ring(ball("ball", 1.0, 0.35, DVec3::new(aside, 0.0, 0.9), DVec3::ZERO));
        let height = (0.45_f64.powi(2) - 0.4_f64.powi(2)).sqrt();
        assert!((end - DVec3::Z * height).length() < 1e-11, "{aside}: {end}");
    }
    for start in [0.2, 0.6] {
        let properties = polhode::mesh::Torus::new(0.4, 0.1).unwrap().solid(Mass::new(1.0).unwrap()).unwrap();
        let upper =
            Body::movable("upper", properties).geometry(ring().into()).pose(Pose::from_translation(DVec3::Z * start));
        let end = on_ring(upper);
        assert!((end - DVec3::Z * 0.2).length() < 1e-12, "{start}: {end}");
    }
}
