//! The integrators that a scene can ask for, through the facade.

use crate::checks::{assert_closes, by, heavy_brick, particle, try_run};
use crate::support::{elastic, floor, run, run_even_degraded};
use polhode::dynamics::integrator::Method as Integrator;
use polhode::scene::{Attachment, DragLaw, Force, Method, Orientation, RotationRate, Tier};
use polhode::spatial::{DVec3, Pose, Rotation, Velocity};
use polhode::{Body, BodyId, BodySample, Effects, EventKind, Scene, SceneBuilder, SceneError};

/// How far the observed order may fall short of the order p: halving the step gains at least `2^(p - 0.4)`.
const ORDER_SHORTFALL: f64 = 0.4;

/// Errors below this are rounding and say nothing about order.
const ROUNDING_ERROR: f64 = 1e-11;

fn tumbling() -> SceneBuilder {
    Scene::builder("tumbling").duration_s(0.8).output_interval_s(0.8).body(Body::fixed("post")).body(
        heavy_brick("brick", 1.3, DVec3::new(0.5, 0.3, 0.2), DVec3::Z)
            .pose(Pose::new(Rotation::from_rotation_vector(DVec3::new(0.3, 0.9, 0.2)), DVec3::Z))
            .velocity(Velocity::new(DVec3::new(1.0, 0.0, 2.0), DVec3::new(1.0, 4.0, -2.0))),
    )
}

fn heavy_top() -> SceneBuilder {
    let turn = Rotation::from_rotation_vector(DVec3::new(0.3, 0.9, 0.2));
    let at = DVec3::new(0.02, 0.05, 0.3);
    let body = heavy_brick("top", 1.3, DVec3::new(0.5, 0.3, 0.2), DVec3::ZERO)
        .pose(Pose::new(turn, DVec3::Z - turn.rotate(at)))
        .pivot(DVec3::Z)
        .velocity(Velocity::new(DVec3::ZERO, DVec3::new(1.0, 2.0, 5.0)));
    Scene::builder("top").duration_s(0.8).output_interval_s(0.8).body(Body::fixed("post")).body(body)
}

fn end(scene: SceneBuilder, method: Method) -> BodySample {
    // The longest steps of the lowest orders lose more energy than a run may.
    let is_crude = method.integrator.is_some_and(|integrator| integrator.order() <= 2);
    let run = if is_crude { run_even_degraded } else { run };
    let (report, _) = run(&scene.method(method).build().unwrap(), Effects::Planned);
    assert_closes(&report);
    report.bodies[1].state
}

fn apart(a: &BodySample, b: &BodySample) -> f64 {
    let place = (a.pose.translation - b.pose.translation).length();
    let speed = (a.velocity.linear - b.velocity.linear).length();
    let spin = (a.velocity.angular - b.velocity.angular).length();
    place.max(speed).max(spin).max(a.pose.rotation.angle_to(b.pose.rotation))
}

/// Every integrator converges with its order: on free motion to the closed form, on a heavy top to the solution of
/// DOP853.
#[test]
fn every_integrator_converges_with_its_order() {
    let exact_top = Method { tolerance: Some(1e-14), ..by(Integrator::Dop853, 0.002) };
    for (scene, exact) in [
        (tumbling as fn() -> SceneBuilder, end(tumbling(), Method::default())),
        (heavy_top, end(heavy_top(), exact_top)),
    ] {
        for integrator in Integrator::ALL {
            let errors = [0.004, 0.002].map(|step| apart(&end(scene(), by(integrator, step)), &exact));
            let gain = f64::log2(errors[0] / errors[1]);
            let order = f64::from(integrator.order());
            assert!(errors[1] < ROUNDING_ERROR || gain > order - ORDER_SHORTFALL, "{integrator}: {errors:?} {gain}");
        }
    }
}

/// The coordinates of orientation and the variable of rotation (angular momentum or velocity) change only the error of
/// `rk4`.
#[test]
fn representations_of_rk4_agree() {
    let exact = end(tumbling(), Method::default());
    let top = end(heavy_top(), Method::default());
    let mut errors = Vec::new();
    for orientation in [
        Orientation::Quaternion,
        Orientation::QuaternionUnnormalized,
        Orientation::QuaternionThreeNumbers,
        Orientation::Matrix,
        Orientation::MatrixUnorthogonalized,
        Orientation::EulerAngles,
    ] {
        for rotation_rate in [RotationRate::AngularMomentum, RotationRate::AngularVelocity] {
            let method = Method {
                orientation: Some(orientation),
                rotation_rate: Some(rotation_rate),
                ..by(Integrator::Rk4, 0.002)
            };
            let error = apart(&end(tumbling(), method.clone()), &exact);
            assert!(error < 1e-8, "{orientation:?} {rotation_rate:?}: {error:e}");
            let error_top = apart(&end(heavy_top(), method), &top);
            assert!(error_top < 5e-8, "{orientation:?} {rotation_rate:?}: {error_top:e}");
            errors.push(error);
        }
    }
    errors.sort_by(f64::total_cmp);
    errors.dedup();
    assert_eq!(errors.len(), 12, "each is a method of its own: {errors:?}");
}

/// A brick falls tumbling onto a floor by every integrator, at a slow and a fast spin. It strikes when the exact motion
/// does, to the order of the integrator, and overlaps the floor by no more than the error of a step.
#[test]
fn stepped_bodies_strike_the_floor() {
    let tilt = Pose::new(Rotation::from_rotation_vector(DVec3::new(0.3, 0.5, 0.1)), DVec3::Z * 0.8);
    for spin in [2.0, 40.0] {
        let scene = |method: Method| {
            Scene::builder("landing")
                .method(method)
                .duration_s(0.6)
                .output_interval_s(0.1)
                .body(floor().material(elastic(0.6)))
                .body(
                    heavy_brick("brick", 1.3, DVec3::new(0.5, 0.3, 0.2), DVec3::ZERO)
                        .pose(tilt)
                        .velocity(Velocity::new(DVec3::X, DVec3::new(0.2, 1.0, -0.4) * spin))
                        .material(elastic(0.6)),
                )
                .build()
                .unwrap()
        };
        let first = |method: Method| {
            let (integrator, step) = (method.integrator, method.step_s);
            let (report, recorder) = try_run(&scene(method), 100_000).unwrap();
            assert_closes(&report);
            // Impacts are decided by velocities, which agree with the path of a method of order p to its error.
            let order = integrator.map_or(8.0, |integrator| f64::from(integrator.order()));
            let allowed = 0.5 * f64::powf(spin * step.unwrap_or(0.0), order + 1.0) + 1e-12;
            let depth = report.certificate.max_penetration_m;
            assert!(depth <= allowed, "{integrator:?}: {depth:e} {allowed:e}");
            recorder.events.iter().find(|event| event.kind == EventKind::Impact).unwrap().t_s
        };
        let exact = first(Method::default());
        for integrator in Integrator::ALL {
            let errors = [0.002, 0.001].map(|step| (first(by(integrator, step)) - exact).abs());
            // The gain of halving the step is at least 2^(p - 1): at an impact the error need not be even in the step.
            let gain = f64::exp2(f64::from(integrator.order()) - 1.0);
            assert!(errors[1] < ROUNDING_ERROR || errors[1] < errors[0] / gain, "{integrator}: {errors:?}");
        }
    }
}

/// A body that turns more than once a step strikes a wall when the closed form does, if the integrator rotates bodies
/// exactly: within the step its motion is that of the integrator, not an interpolating polynomial.
#[test]
fn body_that_turns_often_a_step_strikes_in_time() {
    let scene = |method: Method| {
        let spin = Velocity::new(DVec3::ZERO, DVec3::new(0.0, 900.0, 0.0));
        Scene::builder("spinner")
            .method(method)
            .duration_s(0.5)
            .body(floor().material(elastic(1.0)))
            .body(
                heavy_brick("stick", 0.4, DVec3::new(0.6, 0.02, 0.02), DVec3::Z * 0.8)
                    .velocity(spin)
                    .material(elastic(1.0)),
            )
            .build()
            .unwrap()
    };
    let first = |method: Method| {
        let (report, recorder) = try_run(&scene(method), 200_000).unwrap();
        assert!(report.certificate.max_penetration_m <= 1e-12, "{:e}", report.certificate.max_penetration_m);
        recorder.events.iter().find(|event| event.kind == EventKind::Impact).unwrap().t_s
    };
    let exact = first(Method::default());
    for integrator in [Integrator::Exact, Integrator::Splitting4, Integrator::MoserVeselov4, Integrator::Rk4] {
        let found = first(by(integrator, 2e-4));
        assert!((found - exact).abs() < 1e-4, "{integrator}: {found} {exact}");
    }
    let coarse = first(Method { step_s: Some(0.01), integrator: Some(Integrator::ExactStrang), ..Method::default() });
    assert!((coarse - exact).abs() < 1e-10);
}

/// Splitting integrators refuse forces that depend on velocities.
#[test]
fn drag_is_refused_by_splittings() {
    for integrator in Integrator::ALL {
        let drag = Force::Drag {
            body: BodyId::new(0),
            law: DragLaw::Linear,
            translational: 0.3,
            rotational: 0.01,
            wind: DVec3::ZERO,
        };
        let built = Scene::builder("drag")
            .duration_s(0.05)
            .method(by(integrator, 0.01))
            .body(particle("body", 1.0, DVec3::ZERO, DVec3::X))
            .force(drag)
            .build();
        match built {
            Ok(scene) => assert!(try_run(&scene, 1000).is_ok(), "{integrator}"),
            Err(error) => {
                assert!(matches!(error, SceneError::IntegratorTakesNoVelocities { .. }), "{integrator}: {error}");
                assert!(!matches!(integrator, Integrator::Rk4 | Integrator::Dop853 | Integrator::Cf4));
            }
        }
    }
}

/// Samples within steps err no more than those at the ends of steps, and asking for them changes no bit of the motion.
#[test]
fn samples_between_steps_are_of_the_methods_order() {
    for integrator in Integrator::ALL {
        let scene = |interval| heavy_top().method(by(integrator, 0.004)).output_interval_s(interval).build().unwrap();
        let (coarse, _) = run(&scene(0.8), Effects::Planned);
        let (fine, between) = run(&scene(0.004 / 3.7), Effects::Planned);
        let (_, at_steps) = run(&scene(0.004), Effects::Planned);
        assert_eq!(coarse.bodies, fine.bodies, "{integrator}");
        let exact = heavy_top().method(Method { tolerance: Some(1e-14), ..by(Integrator::Dop853, 0.002) });
        let (_, exact_between) = run(&exact.clone().output_interval_s(0.004 / 3.7).build().unwrap(), Effects::Planned);
        let (_, exact_at) = run(&exact.output_interval_s(0.004).build().unwrap(), Effects::Planned);
        let worst = |a: &polhode::Recorder, b: &polhode::Recorder| {
            a.samples.iter().zip(&b.samples).map(|(x, y)| apart(&x[1], &y[1])).fold(0.0, f64::max)
        };
        let (at, within) = (worst(&at_steps, &exact_at), worst(&between, &exact_between));
        assert!(within < 1.5 * at + ROUNDING_ERROR, "{integrator}: {at:e} {within:e}");
    }
}

/// The tier `thesis` takes every integrator: a free flight is as accurate as in the tier `accurate`, and a brick lands.
#[test]
fn thesis_takes_any_integrator() {
    let exact = end(tumbling(), Method::default());
    for integrator in Integrator::ALL {
        let method = Method { tier: Some(Tier::Thesis), ..by(integrator, 0.002) };
        let found = apart(&end(tumbling(), method.clone()), &exact);
        let in_accurate = apart(&end(tumbling(), by(integrator, 0.002)), &exact);
        assert!(found <= in_accurate * 1.001 + 1e-10, "{integrator}: {found:e} {in_accurate:e}");
        let landing = Scene::builder("landing")
            .method(method)
            .duration_s(0.6)
            .output_interval_s(0.0131)
            .body(floor().material(elastic(0.3)))
            .body(heavy_brick("brick", 1.3, DVec3::new(0.5, 0.3, 0.2), DVec3::Z * 0.4).material(elastic(0.3)))
            .build()
            .unwrap();
        let (report, recorder) = run(&landing, Effects::Planned);
        assert!(!recorder.events.is_empty());
        assert_closes(&report);
    }
}

/// The plan chooses the integrator by the forces: the closed form without any, splitting under error control for
/// conservative forces that are weak over a step, DOP853 for stiff forces and for those that take energy. The
/// certificate holds the error of the steps.
#[test]
fn plan_chooses_by_the_forces() {
    let held = |force: Option<Force>| {
        let scene = force.into_iter().fold(tumbling(), SceneBuilder::force).build().unwrap();
        let simulation = polhode::Simulation::new(&scene).unwrap();
        let plan = (simulation.plan().integrator, simulation.plan().integrator_reason.clone());
        (plan, run(&scene, Effects::Planned).0.certificate.max_step_error.unwrap_or(0.0))
    };
    let spring = |stiffness| Force::Spring {
        a: Attachment::Body { body: BodyId::new(0), point: DVec3::ZERO },
        b: Attachment::Body { body: BodyId::new(1), point: DVec3::X * 0.2 },
        stiffness,
        rest_length: 0.0,
        damping: 0.0,
    };
    let drag = Force::Drag {
        body: BodyId::new(1),
        law: DragLaw::Linear,
        translational: 0.5,
        rotational: 0.1,
        wind: DVec3::ZERO,
    };
    let ((chosen, _), error) = held(None);
    assert_eq!((chosen, error), (Integrator::Exact, 0.0));
    for (force, expected, reason) in [
        (spring(0.5), Integrator::ExactAdaptive, "conservative"),
        (spring(5e4), Integrator::Dop853, "more than sixteen"),
        (drag, Integrator::Dop853, "take or give energy"),
    ] {
        let ((chosen, why), error) = held(Some(force));
        assert!(chosen == expected && why.contains(reason), "{chosen}: {why}");
        assert!(error > 0.0 && error <= 1.0, "{chosen}: {error}");
    }
}
