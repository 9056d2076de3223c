//! Bodies that lie on hundreds of contacts move as those that lie on a few.
//!
//! The rim of a dense mesh has a contact at every vertex. Impacts and time steps begin with some of them and add what
//! closes; the motion of a rigid body that keeps flat does not depend on which of them bear the load.

use crate::checks::assert_closes;
use crate::friction::{on_slope, rough};
use crate::support::{accurate, run};
use polhode::contact::Shape;
use polhode::scene::{Method, Tier};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use polhode::{Body, Effects};
use std::f64::consts::TAU;

const G: f64 = 9.81;

/// A flat ring of points falls flat on a rough floor while it moves along. The impact (without restitution) takes `mu`
/// times the speed of the fall from its velocity, and friction slows it by `mu g` until it rests:
/// `x = v h_t + (v - mu u)^2/(2 mu g)`, with `u = sqrt(2 g h)` and the time of the fall `h_t = u/g`. 4 points and many
/// do the same.
#[test]
fn a_rim_of_many_points_slides_as_far_as_one_of_few() {
    let (friction, height, speed) = (0.3, 0.05, 1.0);
    let fall = (2.0 * G * height).sqrt();
    let after: f64 = speed - friction * fall;
    let distance = speed * fall / G + after * after / (2.0 * friction * G);
    let stepped = || Method { tier: Some(Tier::Stepped), step_s: Some(1e-3), ..Method::default() };
    for (points, method, allowed) in
        [(4, accurate(), 1e-9), (40, accurate(), 1e-9), (4, stepped(), 2e-3), (400, stepped(), 2e-3)]
    {
        let angle = |k: i32| TAU * (f64::from(k) + 0.3) / f64::from(points);
        let rim = (0..points).map(|k| DVec3::new(0.2 * angle(k).cos(), 0.2 * angle(k).sin(), -0.02)).collect();
        let inertia = Inertia::from_diagonal(DVec3::new(0.02, 0.02, 0.04)).unwrap();
        let ring = Body::movable("ring", MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia))
            .geometry(Shape::points(rim).unwrap().into())
            .pose(Pose::from_translation(DVec3::Z * (0.02 + height)))
            .velocity(Velocity::new(DVec3::X * speed, DVec3::ZERO));
        let scene =
            on_slope(Rotation::IDENTITY, ring, &rough(friction)).method(method).duration_s(0.6).build().unwrap();
        let (report, _) = run(&scene, Effects::Planned);
        let end = &report.bodies[0].state;
        let x = end.pose.translation.x;
        assert!((x - distance).abs() < allowed, "{points}: {x} for {distance}");
        assert!((end.pose.translation.z - 0.02).abs() < 1e-9, "{points}: {end:?}");
        assert!(end.velocity.linear.length() < 1e-12, "{points}: {end:?}");
        assert!(report.ledger.friction.value() > 0.0, "{points}: {:?}", report.ledger);
        assert_closes(&report);
    }
}
