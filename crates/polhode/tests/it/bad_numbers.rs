//! Numbers that no scene should have give a typed error or a finite result, in a bounded number of steps.

use crate::checks::{by, particle, try_run};
use crate::support::{accurate, ball, elastic, floor};
use polhode::dynamics::integrator::Method as Integrator;
use polhode::scene::{Attachment, DragLaw, Force, Frame, Method, Signal, Tier};
use polhode::spatial::{DVec3, Velocity};
use polhode::{BodyId, Scene, SceneBuilder};
use std::sync::atomic::{AtomicU32, Ordering};

/// Numbers that are not finite, that overflow or underflow when squared, and zero.
const STRANGE: [f64; 9] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300, 1e150, 1e12, 1e-300, 0.0];

/// Steps that a run of one of these scenes may take.
const STEPS: u32 = 1000;

/// Runs a scene if it can be built. The run must end in an error, or in finite states.
fn check_survival(what: &str, builder: SceneBuilder) {
    let Ok(scene) = builder.build() else { return };
    match try_run(&scene, STEPS) {
        Ok((report, recorder)) => {
            assert!(report.energy.final_j.is_finite(), "{what}");
            for row in &recorder.samples {
                assert!(row.iter().all(|body| body.pose.is_finite() && body.velocity.is_finite()), "{what}");
            }
        }
        Err(error) => assert!(!error.to_string().is_empty(), "{what}"),
    }
}

fn scene(force: Force) -> SceneBuilder {
    Scene::builder("strange")
        .duration_s(0.05)
        .output_interval_s(0.011)
        .body(floor().material(elastic(0.5)))
        .body(ball("a", 1.0, 0.1, DVec3::Z * 0.15, DVec3::ZERO).material(elastic(0.5)))
        .body(particle("b", 1.0, DVec3::X, DVec3::Y))
        .force(force)
}

fn applied(force: DVec3, torque: DVec3, point: Option<DVec3>, signal: Signal) -> Force {
    Force::Applied { body: BodyId::new(1), force, torque, frame: Frame::Body, point, signal }
}

fn spring(stiffness: f64, rest_length: f64, damping: f64, point: DVec3) -> Force {
    Force::Spring {
        a: Attachment::World(point),
        b: Attachment::Body { body: BodyId::new(1), point },
        stiffness,
        rest_length,
        damping,
    }
}

/// Each strange number in turn as each number of each force.
#[test]
fn strange_forces_end_in_an_error_or_a_finite_motion() {
    for x in STRANGE {
        let v = DVec3::new(0.0, x, 1.0);
        let forces = [
            ("force", applied(v, DVec3::ZERO, None, Signal::ONE)),
            ("torque", applied(DVec3::ZERO, v, None, Signal::ONE)),
            ("point", applied(DVec3::X, DVec3::ZERO, Some(v), Signal::ONE)),
            ("signal", applied(DVec3::X, DVec3::ZERO, None, Signal::from_fn(move |t| if t > 0.013 { x } else { 1.0 }))),
            ("stiffness", spring(x, 0.1, 0.0, DVec3::ZERO)),
            ("rest length", spring(3.0, x, 0.0, DVec3::ZERO)),
            ("damping", spring(3.0, 0.1, x, DVec3::ZERO)),
            ("anchor", spring(3.0, 0.1, 1.0, v)),
            ("gravity", Force::PointGravity { center: DVec3::ZERO, mu: x }),
            ("center", Force::PointGravity { center: v, mu: 1.0 }),
            ("mutual", Force::MutualGravity { constant: x }),
            (
                "drag",
                Force::Drag {
                    body: BodyId::new(1),
                    law: DragLaw::Quadratic,
                    translational: x,
                    rotational: 0.1,
                    wind: DVec3::X,
                },
            ),
            (
                "spin",
                Force::Drag {
                    body: BodyId::new(1),
                    law: DragLaw::Linear,
                    translational: 0.1,
                    rotational: x,
                    wind: DVec3::ZERO,
                },
            ),
            (
                "wind",
                Force::Drag {
                    body: BodyId::new(1),
                    law: DragLaw::Quadratic,
                    translational: 0.1,
                    rotational: 0.1,
                    wind: v,
                },
            ),
        ];
        for (what, force) in forces {
            check_survival(&format!("{what} = {x}"), scene(force.clone()));
            let by_rk4 = scene(force.clone()).method(by(Integrator::Rk4, 0.01));
            check_survival(&format!("{what} = {x} by rk4"), by_rk4);
            let by_exact = scene(force.clone()).method(by(Integrator::Exact, 0.01));
            check_survival(&format!("{what} = {x} by exact"), by_exact);
            let thesis = Method { tier: Some(Tier::Thesis), ..Method::default() };
            check_survival(&format!("{what} = {x} by the thesis"), scene(force.clone()).method(thesis));
            let stepped = Method { tier: Some(Tier::Stepped), ..Method::default() };
            check_survival(&format!("{what} = {x} by time steps"), scene(force).method(stepped));
        }
    }
}

/// Springs whose ends coincide, with and without a rest length and a damper.
#[test]
fn spring_of_zero_length_gives_a_finite_motion() {
    for (rest_length, damping) in [(0.0, 0.0), (0.0, 1.0), (0.2, 0.0), (0.2, 1.0)] {
        let builder = Scene::builder("spring")
            .gravity(DVec3::ZERO)
            .duration_s(0.3)
            .body(ball("idle", 1.0, 0.1, DVec3::Y * 3.0, DVec3::ZERO))
            .body(ball("a", 1.0, 0.1, DVec3::ZERO, DVec3::ZERO))
            .force(spring(1e12, rest_length, damping, DVec3::ZERO));
        check_survival("spring", builder);
    }
}

/// Steps, tolerances and durations, strange and at the limits of what is accepted.
#[test]
fn strange_methods_end_in_an_error_or_a_finite_motion() {
    let force = || spring(100.0, 0.1, 0.0, DVec3::ZERO);
    for integrator in Integrator::ALL.map(Some).into_iter().chain([None]) {
        for step in STRANGE.into_iter().chain([1e-9, 1e3, 0.04, 0.05, 0.06]) {
            for tier in [Tier::Accurate, Tier::Thesis, Tier::Stepped] {
                let method = Method { tier: Some(tier), integrator, step_s: Some(step), ..Method::default() };
                check_survival(&format!("{integrator:?} {tier:?} step {step}"), scene(force()).method(method));
            }
        }
    }
    for tolerance in STRANGE.into_iter().chain([1e-15, 1e-16, 1e-3, 0.1, 0.2]) {
        for step_s in [0.01, 1e3] {
            let method = Method { tolerance: Some(tolerance), step_s: Some(step_s), ..accurate() };
            check_survival(&format!("tolerance {tolerance}"), scene(force()).method(method.clone()));
            let dop853 = Method { integrator: Some(Integrator::Dop853), ..method };
            check_survival(&format!("tolerance {tolerance}"), scene(force()).method(dop853));
        }
    }
    for interval in STRANGE.into_iter().chain([1e-5, 0.05, 0.050_000_000_000_000_01]) {
        check_survival(&format!("interval {interval}"), scene(force()).output_interval_s(interval));
    }
    for duration in STRANGE.into_iter().chain([1e-9, 1e-15, 0.0099]) {
        check_survival(&format!("duration {duration}"), scene(force()).duration_s(duration));
    }
}

/// At the tightest and at the loosest tolerance an oscillation is as accurate as the tolerance promises.
#[test]
fn oscillation_keeps_its_tolerance() {
    for (tolerance, allowed) in [(1e-15, 1e-11), (1e-11, 1e-9), (1e-6, 1e-3), (0.1, 1.0)] {
        let scene = Scene::builder("oscillator")
            .gravity(DVec3::ZERO)
            .duration_s(3.0)
            .method(Method { tolerance: Some(tolerance), ..accurate() })
            .body(particle("idle", 1.0, DVec3::Y * 9.0, DVec3::ZERO))
            .body(particle("mass", 1.0, DVec3::X, DVec3::ZERO))
            .force(spring(49.0, 0.0, 0.0, DVec3::ZERO))
            .build()
            .unwrap();
        let (report, _) = try_run(&scene, 1_000_000).unwrap();
        let found = report.bodies[1].state.pose.translation.x;
        assert!((found - f64::cos(21.0)).abs() < allowed, "{tolerance}: {:e}", found - f64::cos(21.0));
    }
}

/// A pivot far away, and a spin about it that overflows.
#[test]
fn strange_pivots_end_in_an_error_or_a_finite_motion() {
    for x in STRANGE {
        for (pivot, spin) in [(DVec3::X * x, 1.0), (DVec3::X, x)] {
            let body = particle("body", 1.0, DVec3::ZERO, DVec3::ZERO)
                .pivot(pivot)
                .velocity(Velocity::new(DVec3::ZERO, DVec3::Y * spin));
            check_survival(&format!("pivot {pivot} spin {spin}"), Scene::builder("pivot").duration_s(0.05).body(body));
        }
    }
}

/// A method that is replaced after the scene was built is checked too: a step of length zero is refused.
#[test]
fn method_replaced_later_is_checked() {
    let scene = scene(spring(100.0, 0.1, 0.0, DVec3::ZERO)).build().unwrap();
    for step in [0.0, -1.0, 1e-300, f64::NAN] {
        for tier in [Tier::Accurate, Tier::Thesis, Tier::Stepped] {
            let method = Method { tier: Some(tier), step_s: Some(step), ..Method::default() };
            let ended = match try_run(&scene.clone().with_method(method), STEPS) {
                Ok((report, _)) => report.outcome == polhode::Outcome::Completed,
                Err(_) => true,
            };
            assert!(ended, "step {step} {tier:?}");
        }
    }
}

/// The simulation calls a user's signal at times of the run only.
#[test]
fn signals_are_evaluated_within_the_run_only() {
    static OUTSIDE: AtomicU32 = AtomicU32::new(0);
    let signal = Signal::from_fn(|t| {
        if !(0.0..=0.05).contains(&t) {
            OUTSIDE.fetch_add(1, Ordering::Relaxed);
        }
        1.0
    });
    for integrator in [Integrator::Rk4, Integrator::Exact, Integrator::Dop853, Integrator::Splitting4] {
        let method = by(integrator, 0.01);
        let builder = scene(applied(DVec3::X, DVec3::ZERO, None, signal.clone())).method(method);
        assert!(try_run(&builder.build().unwrap(), STEPS).is_ok());
        assert_eq!(OUTSIDE.load(Ordering::Relaxed), 0, "{integrator}");
    }
}
