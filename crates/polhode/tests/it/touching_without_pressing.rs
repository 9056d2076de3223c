//! What touches without pressing is held by no friction, at once or later: `|f_t| <= mu f_n` at `f_n = 0`. Bodies
//! beside walls, in corners of walls and on walls after an impact without restitution fall freely, whatever their shape
//! and their friction; no force violates the cones, which the certificate says.

use crate::friction::rough;
use crate::support::{accurate, ball, brick, run};
use polhode::contact::Shape;
use polhode::scene::PrescribedMotion;
use polhode::spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Effects, RunReport, Scene, SceneBuilder};

const G: f64 = 9.81;

/// A wall through the origin with this normal.
fn wall(name: &str, normal: DVec3) -> Body {
    Body::fixed(name).geometry(Shape::half_space(UnitVector::new(normal).unwrap()).into())
}

/// A scene of bodies with friction, the first of which moves.
fn scene(friction: f64, bodies: impl IntoIterator<Item = Body>) -> SceneBuilder {
    let builder = Scene::builder("beside a wall").method(accurate()).duration_s(0.5).output_interval_s(0.1);
    bodies.into_iter().fold(builder, |builder, body| builder.body(body.material(rough(friction))))
}

/// Asserts that the first body has fallen freely, keeping what else it had, and that friction kept its law.
#[track_caller]
fn assert_fell(report: &RunReport, start: DVec3, velocity: DVec3) {
    let end = &report.bodies[0].state;
    let t = report.duration_s;
    let place = start + velocity * t - DVec3::Z * (0.5 * G * t * t);
    let speed = velocity - DVec3::Z * (G * t);
    assert!((end.pose.translation - place).length() < 1e-11, "{:?} {place:?}", end.pose);
    assert!((end.velocity.linear - speed).length() < 1e-11, "{:?} {speed:?}", end.velocity);
    assert!(report.certificate.max_friction_violation_of_limit <= 1.0, "{:?}", report.certificate);
}

/// A box and a ball beside one wall and in the corner of two, at rest at first or gliding along the wall. In a corner
/// of friction 1 and more forces within the cones can hold what rests: the normal force of each wall balances the
/// friction of the other one.
#[test]
fn bodies_beside_walls_fall_freely() {
    let walls = [wall("wall", DVec3::X), wall("other wall", DVec3::Y)];
    for (count, friction) in [(1, 0.5), (1, 1e-6), (1, 2.0), (2, 0.5), (2, 0.9)] {
        for up in [0.0, 1.0] {
            let velocity = DVec3::Z * up;
            let place = DVec3::splat(0.1);
            let cube = brick("box", DVec3::splat(0.2), place).velocity(Velocity::new(velocity, DVec3::ZERO));
            for body in [cube, ball("ball", 1.0, 0.1, place, velocity)] {
                let bodies = [body].into_iter().chain(walls.iter().take(count).cloned());
                let (report, _) = run(&scene(friction, bodies).build().unwrap(), Effects::Planned);
                assert_fell(&report, place, velocity);
            }
        }
    }
}

/// A wall that glides along itself takes nothing with it that does not press on it.
#[test]
fn gliding_wall_takes_nothing_with_it() {
    let motion = PrescribedMotion::constant_velocity(Velocity::new(DVec3::new(0.0, 1.0, 2.0), DVec3::ZERO)).unwrap();
    let moving = Body::kinematic("wall", motion).geometry(Shape::half_space(UnitVector::X).into());
    let place = DVec3::X * 0.1;
    let (report, _) =
        run(&scene(0.7, [brick("box", DVec3::splat(0.2), place), moving]).build().unwrap(), Effects::Planned);
    assert_fell(&report, place, DVec3::ZERO);
}

/// A book thrown flat at a wall without restitution stops there, for friction of 0.6 takes the small speed at which it
/// falls; then it falls along the wall. Turned walls do the same.
#[test]
fn book_thrown_at_a_wall_slides_down() {
    for azimuth in [0.0, 0.7, 2.5] {
        let turn = Rotation::from_rotation_vector(DVec3::Z * azimuth);
        let start = turn.rotate(DVec3::X * 0.225);
        let book = brick("book", DVec3::new(0.05, 0.2, 0.3), DVec3::ZERO)
            .pose(Pose::new(turn, start))
            .velocity(Velocity::new(turn.rotate(DVec3::X * -2.0), DVec3::ZERO));
        let scene = scene(0.6, [book, wall("wall", turn.rotate(DVec3::X))]).build().unwrap();
        let (report, _) = run(&scene, Effects::Planned);
        // It hits after 0.1 s, 0.05 g lower, and falls for 0.4 s.
        let place = turn.rotate(DVec3::X * 0.025) - DVec3::Z * (0.5 * G * (0.01 + 0.16));
        let end = &report.bodies[0].state;
        assert!((end.pose.translation - place).length() < 1e-11, "{:?} {place:?}", end.pose);
        assert!((end.velocity.linear + DVec3::Z * (G * 0.4)).length() < 1e-11, "{:?}", end.velocity);
        assert!(report.certificate.max_friction_violation_of_limit <= 1.0, "{:?}", report.certificate);
    }
}
