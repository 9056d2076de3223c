//! RK4 and DOP853 integrate constrained motion, with the forces of constraint at every stage.

use crate::checks::{assert_closes, by, numerical_relative};
use crate::support::{Sides, accurate, brick, diamond, floor, run};
use polhode::contact::Shape;
use polhode::dynamics::integrator::Method as Integrator;
use polhode::scene::Method;
use polhode::spatial::{DVec3, Mass, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Effects, EventKind, Geometry, RunReport, Scene, Simulation};

/// The error of the final pose of a body against a run at a tighter tolerance: the sum of m and rad.
fn error_of(report: &RunReport, reference: &RunReport, body: usize) -> f64 {
    let (found, exact) = (report.bodies[body].state.pose, reference.bodies[body].state.pose);
    (found.translation - exact.translation).length() + found.rotation.angle_to(exact.rotation)
}

fn precise() -> Method {
    Method { tolerance: Some(1e-13), ..accurate() }
}

/// A tilted ring that spins about its own axis on a smooth floor: the one contact point runs round the ring.
fn ring(method: Method) -> Scene {
    let (major, minor, tilt) = (0.3, 0.05, 0.5_f64);
    let properties = polhode::mesh::primitives::Torus::new(major, minor).unwrap();
    let properties = properties.solid(Mass::new(1.3).unwrap()).unwrap();
    let turn = Rotation::from_rotation_vector(DVec3::X * tilt);
    let center = DVec3::Z * (major * tilt.sin() + minor);
    let body = Body::movable("ring", properties)
        .geometry(Shape::torus(major, minor).unwrap().into())
        .pose(Pose::new(turn, center))
        .velocity(Velocity::new(DVec3::X * 0.2, turn.rotate(DVec3::Z * 18.0)));
    Scene::builder("ring").method(method).duration_s(0.4).body(floor()).body(body).build().unwrap()
}

/// The error of RK4 over a smooth motion with a held contact falls with the fourth power of its step; DOP853 agrees
/// with the reference.
#[test]
fn rk4_moves_a_held_contact_at_order_four() {
    let reference = run(&ring(precise()), Effects::Planned).0;
    assert_eq!(reference.events, 0, "the contact holds all the time");
    let errors: Vec<f64> = [0.02, 0.01, 0.005]
        .into_iter()
        .map(|step| {
            let (report, _) = run(&ring(by(Integrator::Rk4, step)), Effects::Planned);
            assert_eq!(report.events, 0);
            assert!(report.steps.abs_diff((0.4 / step) as u64) <= 1, "fixed steps: {}", report.steps);
            assert!(report.certificate.max_penetration_m < 1e-12);
            assert_closes(&report);
            error_of(&report, &reference, 1)
        })
        .collect();
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((3.6..4.6).contains(&order), "{order} {errors:?}");
    }
    assert!(errors[2] < 1e-5, "{errors:?}");
    let (dop853, _) = run(&ring(by(Integrator::Dop853, 0.01)), Effects::Planned);
    assert!(error_of(&dop853, &reference, 1) < 1e-9, "{:e}", error_of(&dop853, &reference, 1));
}

/// A box slides off a table and tips (case RC-10). RK4 finds the times when contacts change and when the last one ends
/// to its own order.
#[test]
fn rk4_locates_changes_of_contacts() {
    let scene = |method| {
        let table = Body::fixed("table")
            .geometry(Geometry::Shape(Shape::cuboid(DVec3::new(4.0, 2.0, 1.0)).unwrap()))
            .pose(Pose::from_translation(DVec3::new(-2.0, 0.0, -0.5)));
        let slider = brick("box", DVec3::new(1.0, 0.5, 0.5), DVec3::new(-0.5, 0.0, 0.25))
            .velocity(Velocity::new(DVec3::X, DVec3::ZERO));
        Scene::builder("box off table").method(method).duration_s(1.0).body(table).body(slider).build().unwrap()
    };
    let reference = run(&scene(precise()), Effects::Planned).0;
    let errors = [0.04, 0.02, 0.01].map(|step| {
        let (report, recorder) = run(&scene(by(Integrator::Rk4, step)), Effects::Planned);
        let detached: Vec<_> = recorder.events.iter().filter(|event| event.kind == EventKind::Detach).collect();
        assert_eq!(detached.len(), 4, "{:?}", recorder.events);
        assert!((detached[0].t_s - 0.5).abs() < 1e-9, "{}", detached[0].t_s);
        assert_closes(&report);
        ((detached[3].t_s - 0.906_228_978_0).abs(), error_of(&report, &reference, 1))
    });
    assert!(errors[2].0 < 1e-6 && errors[2].1 < 1e-6, "{errors:?}");
    // Two halvings of the step gain 256 at order four. The last step of each phase of motion is shorter than the
    // others, so that the gain is not exactly that.
    assert!(errors[0].1 / errors[2].1 > 100.0, "{errors:?}");
}

/// Where accelerations are constant RK4 is exact: a box slides down a slope by its closed form, and a diamond rests.
#[test]
fn rk4_is_exact_under_constant_forces() {
    let angle = 0.3_f64;
    let turn = Rotation::from_rotation_vector(DVec3::Y * angle);
    let normal = turn.rotate(DVec3::Z);
    let slope = Body::fixed("slope").geometry(Shape::half_space(UnitVector::new(normal).unwrap()).into());
    let slider = brick("box", DVec3::new(1.0, 0.5, 0.25), DVec3::ZERO).pose(Pose::new(turn, normal * 0.125));
    let scene = Scene::builder("slope").method(by(Integrator::Rk4, 0.01)).duration_s(1.0).body(slope).body(slider);
    let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
    let way = turn.rotate(DVec3::X) * (0.5 * 9.81 * angle.sin());
    let apart = (report.bodies[1].state.pose.translation - normal * 0.125 - way).length();
    assert!(apart < 1e-12, "{apart:e}");
    assert!(numerical_relative(&report) < 1e-13);
    let standing = diamond(3, Sides::Touch).method(by(Integrator::Rk4, 0.01)).duration_s(1.0);
    let scene = standing.build().unwrap();
    let (report, _) = run(&scene, Effects::All);
    for (polhode::ReportedBody { state: sample, .. }, body) in report.bodies.iter().zip(scene.bodies()) {
        assert!(sample.velocity.is_zero());
        assert_eq!(sample.pose, *body.initial_pose());
    }
}

/// A stack topples and slides apart with RK4 as with DOP853. A run that is stopped on the way continues with the same
/// bits.
#[test]
fn rk4_topples_a_stack() {
    let scene = |method| {
        let size = DVec3::new(1.0, 0.5, 0.25);
        let mut scene = Scene::builder("stack").method(method).duration_s(0.6).body(floor());
        for (number, x) in [0.0, 0.35, 0.75].into_iter().enumerate() {
            let center = DVec3::new(x, 0.0, 0.25 * number as f64 + 0.125);
            scene = scene.body(brick(&format!("brick {number}"), size, center));
        }
        scene.build().unwrap()
    };
    let (reference, _) = run(&scene(precise()), Effects::Planned);
    assert!(reference.bodies[3].state.velocity.linear.length() > 0.5, "{:?}", reference.bodies[3]);
    let errors = [0.01, 0.0025].map(|step| {
        let (report, _) = run(&scene(by(Integrator::Rk4, step)), Effects::Planned);
        assert_closes(&report);
        (1..4).map(|body| error_of(&report, &reference, body)).fold(0.0, f64::max)
    });
    assert!(errors[1] < 1e-7 && errors[0] / errors[1] > 30.0, "{errors:?}");
    let scene = scene(by(Integrator::Rk4, 0.01));
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(0.2345).unwrap();
    let mut other = Simulation::new(&scene).unwrap();
    other.restore(&simulation.snapshot()).unwrap();
    let (one, two) = (simulation.run().unwrap(), other.run().unwrap());
    assert_eq!(one.bodies, two.bodies);
    assert_eq!(one.bodies, run(&scene, Effects::Planned).0.bodies);
}

/// The plan names the method that integrates constrained motion.
#[test]
fn the_plan_names_the_method_of_constrained_motion() {
    let plan = Simulation::new(&ring(by(Integrator::Rk4, 0.01))).unwrap().plan().clone();
    assert_eq!(plan.integrator, Integrator::Rk4);
    assert!(plan.integrator_reason.contains("at every stage"), "{}", plan.integrator_reason);
}
