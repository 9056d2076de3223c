//! Bodies keep their velocity over the seams of flush bodies: no feature that another body covers gives a contact. What
//! stands out trips them, and an edge that its neighbour has uncovered is an edge. The verify case `seams` runs all
//! shapes, speeds and directions.

use crate::support::{accurate, ball, elastic, run};
use polhode::contact::Shape;
use polhode::scene::{Method, Tier};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Velocity};
use polhode::{Body, Effects, Scene};

/// A fixed tile of 1 m whose top is at a height.
fn tile(name: &str, x: f64, top: f64) -> Body {
    Body::fixed(name)
        .geometry(Shape::cuboid(DVec3::new(1.0, 4.0, 0.2)).unwrap().into())
        .pose(Pose::from_translation(DVec3::new(x, 0.0, top - 0.1)))
}

fn slider(shape: Shape, height: f64, velocity: DVec3) -> Body {
    let inertia = Inertia::from_diagonal(DVec3::splat(1e-3)).unwrap();
    Body::movable("slider", MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia))
        .geometry(shape.into())
        .pose(Pose::from_translation(DVec3::new(-0.4, -0.1, height)))
        .velocity(Velocity::new(velocity, DVec3::ZERO))
}

fn shapes() -> Vec<(Shape, f64)> {
    vec![
        (Shape::sphere(0.05).unwrap(), 0.05),
        (Shape::cylinder(0.05, 0.05).unwrap(), 0.025),
        (Shape::cone(0.05, 0.08).unwrap(), 0.02),
        (Shape::torus(0.04, 0.01).unwrap(), 0.01),
        (Shape::cuboid(DVec3::splat(0.1)).unwrap(), 0.05),
    ]
}

/// The velocity of a slider after it has passed from one tile to the next, which lies higher by `step` (m).
fn after(shape: Shape, height: f64, velocity: DVec3, step: f64, tier: Tier) -> DVec3 {
    let scene = Scene::builder("seam")
        .method(Method { tier: Some(tier), ..Method::default() })
        .duration_s(0.8)
        .body(tile("first", -0.5, 0.0))
        .body(tile("second", 0.5, step))
        .body(slider(shape, height, velocity));
    let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
    report.bodies[2].state.velocity.linear
}

#[test]
fn seam_takes_nothing() {
    for (shape, height) in shapes() {
        for velocity in [DVec3::X, DVec3::new(1.0, 0.2, 0.0)] {
            for tier in [Tier::Accurate, Tier::Stepped] {
                let end = after(shape.clone(), height, velocity, 0.0, tier);
                assert!((end - velocity).length() <= 1e-12, "{shape:?} {tier:?}: {end:?}");
            }
        }
    }
}

#[test]
fn step_of_a_thousandth_trips() {
    for (shape, height) in shapes() {
        let end = after(shape.clone(), height, DVec3::X, 1e-4, Tier::Accurate);
        assert!((end - DVec3::X).length() > 1e-4, "{shape:?}: {end:?}");
    }
}

/// At restitution 1 a seam that bounced a ball by rounding would let it bounce hundreds of thousands of times.
#[test]
fn elastic_ball_does_not_bounce_at_a_seam() {
    let scene = Scene::builder("elastic seam")
        .method(accurate())
        .duration_s(1.0)
        .body(tile("first", -0.5, 0.0).material(elastic(1.0)))
        .body(tile("second", 0.5, 0.0))
        .body(ball("ball", 1.0, 0.05, DVec3::new(-0.4, 0.0, 0.05), DVec3::X));
    let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
    assert_eq!(report.bodies[2].state.velocity.linear, DVec3::X);
    assert!(report.events < 10, "{}", report.events);
}

/// A ball that rolls towards a single tile from below its top, without a neighbour, is stopped by its edge.
#[test]
fn uncovered_edge_is_an_edge() {
    let floor = tile("floor", -0.5, -0.02);
    let scene = Scene::builder("edge").method(accurate()).duration_s(0.6).body(floor).body(tile("second", 0.5, 0.0));
    let ball = ball("ball", 1.0, 0.05, DVec3::new(-0.4, 0.0, 0.03), DVec3::X * 0.5);
    let (report, _) = run(&scene.duration_s(1.0).body(ball).build().unwrap(), Effects::Planned);
    assert!(report.bodies[2].state.velocity.linear.x < 0.4, "{:?}", report.bodies[2].state.velocity);
}
