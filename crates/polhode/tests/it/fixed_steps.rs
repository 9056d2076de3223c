//! Methods with fixed steps tell the truth: what comes to rest within a step is held by static friction, drag and
//! springs are stable at any step, a run whose energy the integrator has changed is degraded and says which step would
//! do, queries answer by the law that the steps obey, and every tier judges a start in the same way.

use crate::checks::{assert_closes, particle};
use crate::friction::sticky;
use crate::stepped::stepped;
use crate::support::{ball, brick, floor, run_estimating, run_even_degraded};
use polhode::contact::Shape;
use polhode::scene::{Attachment, DragLaw, Force, Integrator, Method, Tier};
use polhode::spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};
use polhode::{
    Body, BodyId, Effects, ErrorEstimation, Geometry, Outcome, RunReport, Scene, SceneBuilder, Simulation,
    SimulationError,
};

const G: f64 = 9.81;

/// An incline of this slope (rad) with a flat box on it that moves up it at 1 m/s, turned about the vertical.
fn thrown_up(slope: f64, azimuth: f64, material: (f64, f64), speed: f64) -> (SceneBuilder, DVec3) {
    let turn = Rotation::from_rotation_vector(DVec3::Z * azimuth) * Rotation::from_rotation_vector(DVec3::Y * slope);
    let (up, normal) = (turn.rotate(-DVec3::X), turn.rotate(DVec3::Z));
    let material = || sticky(material.0, material.1);
    let floor = Body::fixed("floor").geometry(Geometry::Shape(Shape::half_space(UnitVector::new(normal).unwrap())));
    let thrown = brick("box", DVec3::new(0.3, 0.3, 0.05), normal * 0.025).material(material());
    let thrown = thrown.pose(Pose::new(turn, normal * 0.025)).velocity(Velocity::new(up * speed, DVec3::ZERO));
    (Scene::builder("incline").body(floor.material(material())).body(thrown), up)
}

fn run(scene: &SceneBuilder, method: Method) -> RunReport {
    let scene = scene.clone().method(method).build().unwrap();
    let report = run_even_degraded(&scene, Effects::Planned).0;
    assert_closes(&report);
    report
}

/// How far the last body is along a direction from where the scene has it, m.
fn way(scene: &SceneBuilder, report: &RunReport, along: DVec3) -> f64 {
    let start = scene.clone().build().unwrap().bodies().last().unwrap().initial_pose().translation;
    (report.bodies.last().unwrap().state.pose.translation - start).dot(along)
}

/// A box thrown up an incline of 30 degrees stops after `v^2/(2 g (sin + mu_k cos))` = 0.060 m and stays where the
/// static coefficient holds it, at steps from half a millisecond to a fiftieth of a second and in any direction. Where
/// the static one does not hold it, it slides back with the kinetic one, to the order of the step.
#[test]
fn a_slip_that_ends_within_a_step_is_held_by_static_friction() {
    let slope = 30f64.to_radians();
    let (sin, cos) = slope.sin_cos();
    let stops = 1.0 / (2.0 * G * (sin + 0.4 * cos));
    for step in [5e-4, 1e-3, 2e-3, 3.7e-3, 5e-3, 1e-2, 2e-2] {
        for azimuth in [0.0, 2.5] {
            let (scene, up) = thrown_up(slope, azimuth, (0.8, 0.4), 1.0);
            let scene = scene.duration_s(0.5).output_interval_s(0.5);
            let report = run(&scene, stepped(step));
            let found = way(&scene, &report, up);
            assert!((found - stops).abs() < 20.0 * step * step, "{step}, {azimuth}: {found} instead of {stops}");
            assert!(report.bodies[1].state.velocity.linear.length() < 1e-9, "{step}, {azimuth}");
        }
        let (scene, up) = thrown_up(slope, 0.3, (0.5, 0.4), 1.0);
        let scene = scene.duration_s(0.5).output_interval_s(0.5);
        let back = 0.5 - 1.0 / (G * (sin + 0.4 * cos));
        let exact = stops - 0.5 * G * (sin - 0.4 * cos) * back * back;
        let found = way(&scene, &run(&scene, stepped(step)), up);
        assert!((found - exact).abs() < 0.5 * step, "{step}: {found} instead of {exact}");
    }
}

/// A ball of this mass under one force, without gravity unless it is given.
fn alone(force: Force, mass: f64, at: DVec3, velocity: DVec3, gravity: DVec3) -> SceneBuilder {
    let scene = Scene::builder("alone").gravity(gravity).body(particle("ball", mass, at, velocity));
    scene.force(force).output_interval_s(10.0)
}

fn drag(law: DragLaw, translational: f64) -> Force {
    Force::Drag { body: BodyId::new(0), law, translational, rotational: 0.0, wind: DVec3::ZERO }
}

/// Under linear drag alone the velocity decays as `e^(-c t/m)` at any step; in a fall it reaches `m g/c` exactly, and
/// quadratic drag slows a body as `v/(1 + c v t/m)`.
#[test]
fn drag_is_exact_at_any_step() {
    for strength in [0.01, 1.0, 2.5, 10.0, 1e3, 1e6] {
        let (step, mass) = (1e-3, 1e-3);
        let c = strength * mass / step;
        let scene = alone(drag(DragLaw::Linear, c), mass, DVec3::ZERO, DVec3::X, DVec3::ZERO).duration_s(0.005);
        let report = run(&scene, stepped(step));
        let exact = libm::exp(-5.0 * strength);
        assert!((report.bodies[0].state.velocity.linear.x - exact).abs() < 1e-13 + 1e-12 * exact, "{strength}");
        assert_eq!(report.outcome, Outcome::Completed, "{:?}", report.warnings);

        let gravity = -DVec3::Z * G;
        let scene = alone(drag(DragLaw::Linear, c), mass, DVec3::ZERO, DVec3::ZERO, gravity).duration_s(0.05);
        let found = run(&scene, stepped(step)).bodies[0].state.velocity.linear.z;
        let exact = G * step / strength * libm::expm1(-50.0 * strength);
        assert!((found - exact).abs() < 1e-12 * exact.abs() + 1e-15, "{strength}: {found} {exact}");

        let scene = alone(drag(DragLaw::Quadratic, c), mass, DVec3::ZERO, DVec3::X, DVec3::ZERO).duration_s(0.005);
        let found = run(&scene, stepped(step)).bodies[0].state.velocity.linear.x;
        let exact = 1.0 / (1.0 + 5.0 * strength);
        assert!((found - exact).abs() < 1e-12, "{strength}: {found} {exact}");
    }
}

/// A spring to the world or between the centres of two bodies, with and without damping, is stable at any step, however
/// stiff: `k h^2/m` from a tenth to 1e8. The energy swings by at most a third, and does not grow; where it swings by
/// more than a thousandth the run is degraded.
#[test]
fn springs_are_stable_at_any_step() {
    for strength in [0.1, 1.0, 5.0, 20.0, 1e3, 1e8] {
        for damping in [0.0, 0.3, 30.0] {
            let (step, mass) = (1e-3, 1e-3);
            let stiffness = strength * mass / (step * step);
            let spring =
                |a, b, rest_length| Force::Spring { a, b, stiffness, rest_length, damping: damping * mass / step };
            let on = |body, point| Attachment::Body { body: BodyId::new(body), point };
            let world = spring(Attachment::World(DVec3::Z * 0.1), on(0, DVec3::ZERO), 0.1);
            let one = alone(world, mass, DVec3::X * 1e-3, DVec3::ZERO, DVec3::ZERO);
            let between = spring(on(0, DVec3::ZERO), on(1, DVec3::ZERO), 0.1);
            let pair = Scene::builder("pair").gravity(DVec3::ZERO).force(between).output_interval_s(10.0);
            let pair = pair.body(ball("left", mass, 0.01, DVec3::ZERO, DVec3::Y * 0.1));
            let pair = pair.body(ball("right", 3.0 * mass, 0.01, DVec3::new(0.1001, 0.0, 0.0), DVec3::ZERO));
            for (name, scene) in [("world", one), ("pair", pair)] {
                // Not the ledger: the energy of the stiffest springs is the small difference of large ones.
                let scene = scene.duration_s(0.3).method(stepped(step)).build().unwrap();
                let report = run_estimating(&scene, Effects::Planned, ErrorEstimation::Off).0;
                let swing = report.certificate.max_numerical_relative;
                let what = format!("{name}, {strength}, {damping}: {swing:e} {:?}", report.warnings);
                assert_eq!(report.outcome == Outcome::Degraded, swing > 1e-3, "{what}");
                assert!(report.energy.final_j < 1.4 * report.energy.initial_j, "{what}");
            }
        }
    }
}

/// Every method with a fixed step blows up or goes wrong on a spring with `k h^2/m = 20` or by drag with `c h/m = 10`:
/// the run ends degraded, says when and which step would do, and with that step it is completed.
#[test]
fn a_run_that_blows_up_is_degraded_and_says_which_step_would_do() {
    let (step, mass) = (1e-3, 1e-3);
    let spring = Force::Spring {
        a: Attachment::World(DVec3::Z * 0.1),
        b: Attachment::Body { body: BodyId::new(0), point: DVec3::ZERO },
        stiffness: 20.0 * mass / (step * step),
        rest_length: 0.05,
        damping: 0.0,
    };
    let methods = [
        Integrator::ExplicitEuler,
        Integrator::SemiImplicitEuler,
        Integrator::Rk4,
        Integrator::Rkmk4,
        Integrator::Cf4,
        Integrator::Splitting,
        Integrator::Splitting4,
        Integrator::MoserVeselov,
        Integrator::ImplicitMidpoint,
        Integrator::ExactStrang,
    ];
    for integrator in methods {
        for tier in [Tier::Accurate, Tier::Thesis] {
            let by = |step| Method {
                tier: Some(tier),
                integrator: Some(integrator),
                step_s: Some(step),
                ..Method::default()
            };
            let scene = alone(spring.clone(), mass, DVec3::Z * 1e-3, DVec3::ZERO, DVec3::ZERO).duration_s(0.05);
            let built = scene.clone().method(by(step)).build().unwrap();
            let Ok(report) = Simulation::new(&built).unwrap().run() else { continue };
            let what = format!("{integrator:?} {tier:?}: {:?}", report.warnings);
            assert_eq!(report.outcome, Outcome::Degraded, "{what}");
            let said = report.warnings.iter().find(|warning| warning.contains("would do")).expect(&what);
            let enough = said.split("a step of ").nth(1).unwrap().split(' ').next().unwrap();
            let enough: f64 = enough.parse().unwrap();
            // Methods of first and second order would need a million steps.
            if enough > 5e-6 {
                let report = run(&scene, by(enough));
                assert_eq!(report.outcome, Outcome::Completed, "{what}: {:?}", report.warnings);
            }
        }
    }
}

/// A box that rests on a slope of 30 degrees by friction does not accelerate, and the forces of its contacts carry its
/// weight: at the start, after a step and after many, in the tier `stepped` as in `accurate`. One that slides
/// accelerates by `g (sin - mu cos)`.
#[test]
fn queries_of_accelerations_and_forces_have_friction() {
    let slope = 30f64.to_radians();
    for method in [stepped(1e-3), Method { tier: Some(Tier::Accurate), ..Method::default() }] {
        let (scene, up) = thrown_up(slope, 0.4, (1.0, 1.0), 0.0);
        let scene = scene.duration_s(1.0).method(method.clone()).build().unwrap();
        let mut simulation = Simulation::new(&scene).unwrap();
        for t in [0.0, 1e-3, 0.5] {
            simulation.advance_to(t).unwrap();
            let found = simulation.accelerations().unwrap()[1];
            assert!(found.linear.length() < 1e-11 && found.angular.length() < 1e-10, "{t}: {found:?}");
            let on_box = |contact: &polhode::ContactView| {
                let force = contact.normal * contact.normal_force_n + contact.friction_n;
                if contact.body_a.index() == 1 { force } else { -force }
            };
            let sum: DVec3 = simulation.frame().contacts.iter().map(on_box).sum();
            assert!((sum - DVec3::Z * G).length() < 1e-6, "{t}: {sum}");
        }
        let (scene, _) = thrown_up(slope, 0.4, (0.2, 0.2), -1.0);
        let scene = scene.duration_s(1.0).method(method).build().unwrap();
        let mut simulation = Simulation::new(&scene).unwrap();
        for t in [0.0, 0.25] {
            simulation.advance_to(t).unwrap();
            let found = simulation.accelerations().unwrap()[1].linear;
            let exact = up * -(G * (slope.sin() - 0.2 * slope.cos()));
            assert!((found - exact).length() < 1e-9, "{t}: {found} {exact}");
        }
    }
}

/// Bodies that overlap at the start are refused by every tier, with the same error.
#[test]
fn every_tier_refuses_a_start_with_overlap() {
    let scene = Scene::builder("overlap").body(floor());
    let scene = scene.body(brick("a", DVec3::splat(0.2), DVec3::Z * 0.1));
    let scene = scene.body(brick("b", DVec3::splat(0.2), DVec3::Z * 0.28)).build().unwrap();
    let refused = [Tier::Accurate, Tier::Stepped, Tier::Thesis].map(|tier| {
        let scene = scene.clone().with_method(Method { tier: Some(tier), ..Method::default() });
        let error = Simulation::new(&scene).unwrap_err();
        assert!(matches!(error, SimulationError::Scene(_)), "{error}");
        error.to_string()
    });
    assert!(refused.iter().all(|said| *said == refused[0] && said.contains("0.02")), "{refused:?}");
}

/// A fall of half a metre in two steps of 5 s ends far from where it should: the run warns of the step, of the body and
/// of the time, names the step that would do, and its certificate estimates an error and holds the penetration and the
/// projection that the ledger has booked.
#[test]
fn a_step_that_is_too_long_is_told() {
    let tilted = Rotation::from_rotation_vector(DVec3::new(0.3, 0.2, 0.0));
    let material = || polhode::scene::Material::new("m").with_friction(0.4).unwrap().with_restitution(0.2).unwrap();
    let falling = brick("box", DVec3::new(0.4, 0.3, 0.2), DVec3::ZERO).material(material());
    let falling = falling.pose(Pose::new(tilted, DVec3::Z * 0.6));
    let scene = Scene::builder("drop").duration_s(10.0).body(floor().material(material())).body(falling);
    let report = run(&scene, stepped(5.0));
    let warned = report.warnings.iter().any(|said| said.contains("box") && said.contains("would do"));
    assert!(warned, "{:?}", report.warnings);
    assert_eq!(report.outcome, Outcome::Degraded, "{:?}", report.certificate);
    assert!(report.error.relative().unwrap() > 1e-3, "{:?}", report.certificate);
    let certificate = report.certificate;
    if report.ledger.projection.value() != 0.0 {
        assert!(certificate.max_projection_m > 0.0 && certificate.max_penetration_m > 0.0, "{certificate:?}");
        assert!(certificate.max_projection_at.is_some() && certificate.max_projection_j > 0.0, "{certificate:?}");
    }
    let fine = run(&scene.duration_s(2.0), stepped(1e-3));
    assert!(!fine.warnings.iter().any(|said| said.contains("would do")), "{:?}", fine.warnings);
    assert_eq!(fine.certificate.max_acceleration_error_bound, None);
}

/// A fall with drag has an error, and its estimate is at least a tenth of it, at two steps.
#[test]
fn the_estimated_error_holds() {
    for step in [0.05, 0.02] {
        let scene = alone(drag(DragLaw::Quadratic, 0.3), 1.0, DVec3::ZERO, DVec3::new(3.0, 0.0, 1.0), -DVec3::Z * G);
        let scene = scene.duration_s(2.0);
        let [found, finer] = [step, 1e-3].map(|step| run(&scene, stepped(step)));
        let [a, b] = [&found, &finer].map(|report| report.bodies[0].state.pose.translation);
        // The size of the body is twice its largest radius of gyration.
        let size = 2.0 * 0.4f64.sqrt();
        let (error, estimate) = ((a - b).length() / size, found.error.relative().unwrap());
        assert!(error > 0.0 && estimate > 0.1 * error, "{step}: {error:e} {estimate:e}");
    }
}
