//! The tier `fast` where bodies meet fast: a bounce has friction, by the law of single impacts; what is shot at a wall
//! does not end beyond it, or the run says so.
//!
//! Oracles: the impact of a ball with friction in closed form, the tier `accurate`, and which side of a wall a body is
//! on.

use crate::fast_joints::fast;
use crate::support::{ball, brick, floor};
use polhode::contact::Shape;
use polhode::scene::{Material, Method, Tier};
use polhode::spatial::{DVec3, Pose, Rotation, Velocity};
use polhode::{Body, ErrorEstimation, Geometry, Outcome, RunReport, Scene, SceneBuilder, Simulation};

const STEP_S: f64 = 1.0 / 60.0;

fn material(friction: f64, restitution: f64) -> Material {
    Material::new("m").with_friction(friction).unwrap().with_restitution(restitution).unwrap()
}

fn run(scene: SceneBuilder) -> RunReport {
    Simulation::new(&scene.build().unwrap()).unwrap().estimating(ErrorEstimation::Off).run().unwrap()
}

/// A ball that hits a floor obliquely gets the spin at which it rolls, or all that friction gives:
/// `p = min(m s/(1 + m r^2/I), mu (1 + e) m v)` against the slip s.
#[test]
fn a_ball_bounces_with_friction() {
    let radius = 0.1;
    for (friction, restitution, along, spin) in [
        (0.1, 0.5, 3.0, 0.0),
        (0.5, 0.5, 1.0, 0.0),
        (0.5, 1.0, 1.0, 0.0),
        (0.3, 0.8, 2.0, 20.0),
        (0.9, 0.3, 2.0, -30.0),
        (0.2, 1.0, 5.0, 0.0),
    ] {
        let down = 4.0;
        let velocity = Velocity::new(DVec3::new(along, 0.0, -down), DVec3::Y * spin);
        let own = ball("ball", 1.0, radius, DVec3::Z * 0.2, DVec3::ZERO)
            .velocity(velocity)
            .material(material(friction, restitution));
        let scene = Scene::builder("bounce").method(fast(STEP_S)).duration_s(0.1).gravity(DVec3::ZERO);
        let report = run(scene.body(floor().material(material(friction, restitution))).body(own));
        let found = report.bodies[1].state.velocity;
        let slip: f64 = along - spin * radius;
        let impulse = (slip.abs() / 3.5).min(friction * (1.0 + restitution) * down).copysign(slip);
        let expected = Velocity::new(
            DVec3::new(along - impulse, 0.0, restitution * down),
            DVec3::Y * (spin + 2.5 * impulse / radius),
        );
        let error = (found.linear - expected.linear).length() + radius * (found.angular - expected.angular).length();
        assert!(error < 1e-9, "{friction} {restitution} {along} {spin}: {found:?}, not {expected:?}");
    }
}

/// A dumbbell that hits a floor with one end bounces as in the tier `accurate`, the better the shorter the step is.
#[test]
fn an_eccentric_bounce_is_that_of_a_single_impact() {
    let end = |method: Method| {
        let part = |x: f64| Shape::sphere(0.0176).unwrap().translated(DVec3::X * x).unwrap();
        let shape = Shape::compound(vec![part(-0.0176), part(0.0176)]).unwrap();
        let turn = Rotation::from_rotation_vector(DVec3::new(0.3, 0.6, 1.0));
        let own = brick("dumbbell", DVec3::new(0.06, 0.03, 0.03), DVec3::ZERO).geometry(Geometry::Shape(shape));
        let own = own.pose(Pose::new(turn, DVec3::Z * 0.195)).material(material(0.7, 1.0));
        let own = own.velocity(Velocity::new(DVec3::new(-0.85, -0.51, -0.33), DVec3::new(0.0, 4.8, 2.2)));
        let scene = Scene::builder("dumbbell").method(method).duration_s(0.25);
        run(scene.body(floor().material(material(0.7, 1.0))).body(own)).bodies[1].state.pose.translation
    };
    let exact = end(Method { tier: Some(Tier::Accurate), ..Method::default() });
    for step_s in [0.004, 0.001] {
        let error = (end(fast(step_s)) - exact).length();
        assert!(error < 2.0 * step_s, "{step_s}: {error} m");
    }
}

/// Plates, rods and compounds that are shot at walls and floors at 10 to 2000 m/s do not end beyond them, or the run is
/// degraded.
#[test]
fn what_is_shot_at_a_wall_is_before_it_or_told() {
    let part = |x: f64| Shape::sphere(0.05).unwrap().translated(DVec3::X * x).unwrap();
    let shapes = [
        Shape::sphere(0.1).unwrap(),
        Shape::cuboid(DVec3::new(0.4, 0.4, 0.01)).unwrap(),
        Shape::capsule(0.02, 0.5).unwrap(),
        Shape::compound(vec![part(-0.15), part(0.15)]).unwrap(),
    ];
    let mut told = 0;
    for shape in &shapes {
        for thickness in [0.01, 0.1] {
            for speed in [10.0, 30.0, 100.0, 300.0, 1000.0, 2000.0] {
                // Friction throws some of them aside: none comes to the border.
                let wall = Shape::cuboid(DVec3::new(200.0, 200.0, thickness)).unwrap();
                let wall = Body::fixed("wall").geometry(Geometry::Shape(wall)).material(material(0.5, 0.0));
                let turn = Rotation::from_rotation_vector(DVec3::new(0.3, 0.5, 0.2));
                let own = brick("shot", DVec3::splat(0.2), DVec3::ZERO).geometry(Geometry::Shape(shape.clone()));
                let own = own.pose(Pose::new(turn, DVec3::Z * 2.0)).material(material(0.5, 0.0));
                let own = own.velocity(Velocity::new(DVec3::Z * -speed, DVec3::ZERO));
                let scene = Scene::builder("shot").method(fast(STEP_S)).gravity(DVec3::ZERO);
                let report = run(scene.duration_s((3.0_f64 / speed).max(0.05)).body(wall).body(own));
                let height = report.bodies[1].state.pose.translation.z;
                let is_told = report.outcome != Outcome::Completed;
                told += usize::from(is_told);
                assert!(height > 0.5 * thickness || is_told, "{shape:?} at {speed} m/s: {height}");
            }
        }
    }
    assert!(told <= 24, "{told} of 48 shots are degraded");
}
