//! Springs of the tier `penalty` against closed forms: Hertz's impacts of two balls and of a ball on a rigid plane
//! (Chung and Ooi 2011, tests 1 and 2), restitution by both dampers, gross slip and sticking (tests 3 to 7), and the
//! ledger.

use polhode::contact::Shape;
use polhode::mesh::solid_sphere;
use polhode::scene::{Integrator, Material, Method, PenaltyMethod, Response, SceneError, SpringDamping, SpringLaw};
use polhode::spatial::{DVec3, Mass, Pose, UnitVector, Velocity};
use polhode::{Body, RunReport, Scene, Simulation, SimulationError, SpringImpact};
use std::f64::consts::PI;

const TOLERANCE: f64 = 1e-9;

fn method(penalty: PenaltyMethod) -> Method {
    Method { response: Some(Response::Penalty), penalty: Some(penalty), ..Method::default() }
}

fn hertz() -> PenaltyMethod {
    PenaltyMethod { law: Some(SpringLaw::Hertz), ..PenaltyMethod::default() }
}

fn ball(name: &str, radius: f64, density: f64, material: &Material, place: DVec3, velocity: Velocity) -> Body {
    let mass = Mass::new(4.0 / 3.0 * PI * radius.powi(3) * density).unwrap();
    Body::movable(name, solid_sphere(radius, mass).unwrap())
        .geometry(Shape::sphere(radius).unwrap().into())
        .pose(Pose::from_translation(place))
        .velocity(velocity)
        .material(material.clone())
}

fn wall(material: &Material) -> Body {
    Body::fixed("wall").geometry(Shape::half_space(UnitVector::Z).into()).material(material.clone())
}

fn run(bodies: Vec<Body>, method: Method, duration_s: f64) -> (RunReport, SpringImpact) {
    let scene = Scene::builder("impact").method(method).gravity(DVec3::ZERO).duration_s(duration_s);
    let scene = bodies.into_iter().fold(scene, polhode::SceneBuilder::body).build().unwrap();
    let report = Simulation::new(&scene).unwrap().run().unwrap();
    let closure = report.ledger.closure_relative();
    assert!(closure < 1e-12, "the ledger closes to {closure:e}");
    let springs = report.springs.clone().unwrap();
    assert_eq!(springs.impacts, 1);
    (report, springs.first_impacts[0])
}

fn near(what: &str, found: f64, expected: f64, relative: f64) {
    let error = (found / expected - 1.0).abs();
    assert!(error < relative, "{what}: {found:e} instead of {expected:e}, off by {error:.2e}");
}

/// Chung and Ooi, test 1: two glass balls meet head on.
#[test]
fn two_balls_after_hertz() {
    let glass = Material::new("glass").with_restitution(1.0).unwrap().with_elasticity(48e9, 0.2).unwrap();
    let at = |side: f64| Velocity::new(DVec3::Z * (-10.0 * side), DVec3::ZERO);
    let one = |name: &str, side: f64| ball(name, 0.01, 2800.0, &glass, DVec3::Z * (0.0105 * side), at(side));
    let (_, impact) = run(vec![one("upper", 1.0), one("lower", -1.0)], method(hertz()), 2e-4);
    near("depth", impact.penetration_m, 274.11270e-6, 1e-7);
    near("force", impact.force_n, 10.696_889e3, 1e-6);
    near("duration", impact.duration_s, 40.339_456e-6, 1e-7);
    let reduced = 4.0 / 3.0 * PI * 0.01f64.powi(3) * 2800.0 / 2.0;
    let stiffness = 4.0 / 3.0 * 48e9 / (2.0 * (1.0 - 0.04)) * 0.005f64.sqrt();
    let depth = (1.25 * reduced * 400.0 / stiffness).powf(0.4);
    near("depth", impact.penetration_m, depth, TOLERANCE);
    near("force", impact.force_n, stiffness * depth.powf(1.5), TOLERANCE);
    near("duration", impact.duration_s, 2.943_275_184_324_706 * depth / 20.0, TOLERANCE);
    near("restitution", impact.restitution(), 1.0, TOLERANCE);
}

/// Chung and Ooi, test 2: a ball meets a rigid plane.
#[test]
fn a_ball_on_a_rigid_plane_after_hertz() {
    let alloy = Material::new("alloy").with_restitution(1.0).unwrap().with_elasticity(70e9, 0.3).unwrap();
    let rigid = Material::new("rigid").with_restitution(1.0).unwrap();
    let falling = Velocity::new(DVec3::Z * -0.2, DVec3::ZERO);
    let own = ball("ball", 0.1, 2699.0, &alloy, DVec3::Z * 0.1001, falling);
    let (_, impact) = run(vec![wall(&rigid), own], method(hertz()), 0.01);
    near("depth", impact.penetration_m, 49.717_175e-6, 1e-7);
    near("force", impact.force_n, 11.369_858e3, 1e-7);
    near("duration", impact.duration_s, 731.656_64e-6, 1e-7);
    let mass = 4.0 / 3.0 * PI * 1e-3 * 2699.0;
    let stiffness = 4.0 / 3.0 * 70e9 / 0.91 * 0.1f64.sqrt();
    let depth = (1.25 * mass * 0.04 / stiffness).powf(0.4);
    near("depth", impact.penetration_m, depth, TOLERANCE);
    near("duration", impact.duration_s, 2.943_275_184_324_706 * depth / 0.2, TOLERANCE);
}

/// Chung and Ooi, test 3: a ball meets a plane with every restitution, by both dampers and both growths.
#[test]
fn restitution_is_that_asked() {
    for damping in [SpringDamping::HuntCrossley, SpringDamping::Plain] {
        for law in [SpringLaw::Hertz, SpringLaw::Linear] {
            for e in [0.02, 0.2, 0.4, 0.6, 0.8, 1.0] {
                let oxide = Material::new("oxide").with_restitution(e).unwrap().with_elasticity(380e9, 0.23).unwrap();
                let falling = Velocity::new(DVec3::Z * -3.9, DVec3::ZERO);
                let own = ball("ball", 0.0025, 4000.0, &oxide, DVec3::Z * 0.002_51, falling);
                let penalty = PenaltyMethod { law: Some(law), damping: Some(damping), ..PenaltyMethod::default() };
                let (report, impact) = run(vec![wall(&oxide), own], method(penalty), 0.002);
                near(&format!("{damping:?} {law:?} {e}"), impact.restitution(), e, TOLERANCE);
                let lost = 0.5 * 4.0 / 3.0 * PI * 0.0025f64.powi(3) * 4000.0 * 3.9 * 3.9 * (1.0 - e * e);
                assert!(
                    (report.ledger.damping.value() - lost).abs() < 1e-8 * lost.max(1e-6),
                    "{damping:?} {law:?} {e}"
                );
            }
        }
    }
}

/// Velocity and spin of a ball after it has met the plane with a tangential velocity and a spin about y.
fn oblique(
    penalty: PenaltyMethod,
    material: &Material,
    radius: f64,
    (normal, along, spin): (f64, f64, f64),
) -> [f64; 3] {
    let moving = Velocity::new(DVec3::new(along, 0.0, -normal), DVec3::Y * spin);
    let own = ball("ball", radius, 2700.0, material, DVec3::Z * (1.001 * radius), moving);
    let (report, _) = run(vec![wall(material), own], method(penalty), 0.01 * radius / normal + 1e-3);
    let after = &report.bodies[1].state.velocity;
    [after.linear.x, after.angular.y, after.linear.z]
}

/// Chung and Ooi, tests 4 to 6: where a ball slides from begin to end friction takes `mu (1 + e) m v_n`, so that
/// `V' = V - mu (1 + e) v_n` and `w' = w + (5/2) mu (1 + e) v_n / r`.
#[test]
fn gross_slip_is_that_of_rigid_bodies() {
    let cases = [(0.092, 0.98, 40.0f64), (0.092, 0.98, 60.0), (0.092, 0.98, 85.0), (0.4, 0.5, 89.0), (0.3, 1.0, 80.0)];
    for (friction, e, degrees) in cases {
        let alloy = Material::new("alloy").with_restitution(e).unwrap().with_friction(friction).unwrap();
        let alloy = alloy.with_elasticity(70e9, 0.33).unwrap();
        let (along, normal) = (3.9 * degrees.to_radians().sin(), 3.9 * degrees.to_radians().cos());
        // A plain damper begins with a normal force, so that the contact sticks at first: it is left out.
        for penalty in [hertz(), PenaltyMethod::default()] {
            let [v, w, up] = oblique(penalty, &alloy, 0.0025, (normal, along, 0.0));
            near("up", up, e * normal, TOLERANCE);
            let turned = friction * (1.0 + e) * normal;
            near("slip", v, along - turned, TOLERANCE);
            near("spin", w, 2.5 * turned / 0.0025, TOLERANCE);
        }
    }
}

/// A linear spring that sticks throughout: the slip is that of an oscillator on the tangential spring, with 2/7 of the
/// mass, over the half period of the normal spring.
#[test]
fn sticking_is_an_oscillator() {
    let alloy = Material::new("alloy").with_restitution(1.0).unwrap().with_friction(1e9).unwrap();
    let alloy = alloy.with_elasticity(70e9, 0.3).unwrap();
    let (normal, along, spin, radius) = (1.0, 0.02, 1.5, 0.01);
    let [v, w, _] = oblique(PenaltyMethod::default(), &alloy, radius, (normal, along, spin));
    let slip = along - spin * radius;
    let ratio: f64 = 2.0 * 0.7 / 1.7;
    let after = slip * (PI * (3.5 * ratio).sqrt()).cos();
    let change = 2.0 / 7.0 * (after - slip);
    near("velocity", v, along + change, TOLERANCE);
    near("spin", w, spin - 2.5 * change / radius, TOLERANCE);
}

/// Chung and Ooi, test 7: two equal balls that spin against each other do not slip on each other: they keep their
/// spins.
#[test]
fn balls_that_roll_on_each_other_keep_their_spins() {
    let copper = Material::new("copper").with_restitution(1.0).unwrap().with_friction(0.4).unwrap();
    let copper = copper.with_elasticity(120e9, 0.35).unwrap();
    let moving = |side: f64| Velocity::new(DVec3::X * (-0.2 * side), DVec3::Y * (175.0 * side));
    let one = |name: &str, side: f64| ball(name, 0.1, 8900.0, &copper, DVec3::X * (0.100_01 * side), moving(side));
    let (report, impact) = run(vec![one("right", 1.0), one("left", -1.0)], method(hertz()), 0.003);
    near("restitution", impact.restitution(), 1.0, TOLERANCE);
    for (body, side) in report.bodies.iter().zip([1.0, -1.0]) {
        let velocity = &body.state.velocity;
        near("spin", velocity.angular.y, 175.0 * side, TOLERANCE);
        assert!(velocity.linear.z.abs() < 1e-9 * 0.2, "{velocity:?}");
    }
}

fn bouncing(method: Method, duration_s: f64) -> Scene {
    let rubber = Material::new("rubber").with_restitution(0.5).unwrap().with_friction(0.3).unwrap();
    let moving = Velocity::new(DVec3::new(0.3, 0.1, -1.0), DVec3::new(2.0, -1.0, 3.0));
    let own = ball("ball", 0.05, 1000.0, &rubber, DVec3::Z * 0.06, moving);
    Scene::builder("bouncing").method(method).duration_s(duration_s).body(wall(&rubber)).body(own).build().unwrap()
}

/// Fixed steps of their own length reach the restitution to a few hundredths, and their ledger closes; a step that no
/// explicit method can follow is refused with one that would do, and the implicit rule takes it.
#[test]
fn fixed_steps_are_followed_or_refused() {
    let by = |integrator, step_s| Method { integrator: Some(integrator), step_s, ..method(PenaltyMethod::default()) };
    for integrator in [Integrator::Rk4, Integrator::SemiImplicitEuler, Integrator::ImplicitMidpoint] {
        let report = Simulation::new(&bouncing(by(integrator, None), 0.02)).unwrap().run().unwrap();
        assert!(report.ledger.closure_relative() < 1e-12, "{integrator:?}");
        let impact = report.springs.unwrap().first_impacts[0];
        assert!((impact.restitution() - 0.5).abs() < 0.05, "{integrator:?}: {impact:?}");
    }
    for integrator in [Integrator::Rk4, Integrator::SemiImplicitEuler] {
        let refused = Simulation::new(&bouncing(by(integrator, Some(1e-3)), 0.02)).unwrap().run().unwrap_err();
        let SimulationError::StepTooLong { limit_s, .. } = refused else { panic!("{integrator:?}: {refused}") };
        Simulation::new(&bouncing(by(integrator, Some(0.4 * limit_s)), 0.02)).unwrap().run().unwrap();
    }
    Simulation::new(&bouncing(by(Integrator::ImplicitMidpoint, Some(1e-3)), 0.02)).unwrap().run().unwrap();
}

/// The implicit step has one matrix of all bodies that may meet: a row of more than 64 balls about to touch is refused,
/// a short one is not.
#[test]
fn implicit_steps_of_many_bodies_are_refused() {
    const STEP: f64 = 1e-4;
    let plain = Material::new("plain").with_restitution(0.5).unwrap();
    let implicit = || Method {
        integrator: Some(Integrator::ImplicitMidpoint),
        step_s: Some(STEP),
        ..method(PenaltyMethod::default())
    };
    let outcome = |bodies: u32| {
        let one = |number: u32| {
            let place = DVec3::new(0.200_000_1 * f64::from(number), 0.0, 0.100_000_1);
            let inwards = if number.is_multiple_of(2) { DVec3::X } else { DVec3::NEG_X };
            let velocity = Velocity::new(inwards - DVec3::Z, DVec3::ZERO);
            ball(&format!("ball {number}"), 0.1, 1000.0, &plain, place, velocity)
        };
        let scene = Scene::builder("row").method(implicit()).duration_s(STEP).body(wall(&plain));
        let scene = (0..bodies).map(one).fold(scene, polhode::SceneBuilder::body).build().unwrap();
        Simulation::new(&scene).unwrap().run().map(|_| ())
    };
    outcome(8).unwrap();
    let refused = outcome(65).unwrap_err();
    assert!(matches!(refused, SimulationError::ImplicitTooLarge { bodies: 65, limit: 64, .. }), "{refused}");
}

/// A run that goes on from a snapshot in the middle of a contact has the same bits.
#[test]
fn snapshots_keep_springs() {
    let scene = bouncing(method(PenaltyMethod::default()), 0.1);
    let mut whole = Simulation::new(&scene).unwrap();
    whole.advance_to(0.009_66).unwrap();
    let snapshot = whole.snapshot();
    let mut restored = Simulation::new(&scene).unwrap();
    restored.restore(&snapshot).unwrap();
    assert_eq!(restored.snapshot(), snapshot);
    let (whole, restored) = (whole.run().unwrap(), restored.run().unwrap());
    assert_eq!(whole.bodies, restored.bodies);
    assert_eq!(whole.springs, restored.springs);
}

/// At rest a linear spring carries the weight: the ball sinks by m g/k.
#[test]
fn weight_compresses_a_spring() {
    let rubber = Material::new("rubber").with_restitution(0.2).unwrap();
    let own = ball("ball", 0.1, 1000.0, &rubber, DVec3::Z * 0.1, Velocity::ZERO);
    let penalty =
        PenaltyMethod { stiffness_n_m: Some(1e4), damping: Some(SpringDamping::Plain), ..PenaltyMethod::default() };
    let scene = Scene::builder("rest").method(method(penalty)).duration_s(3.0).body(wall(&rubber)).body(own);
    let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
    let report = simulation.run().unwrap();
    let weight = 4.0 / 3.0 * PI * 1e-3 * 1000.0 * 9.81;
    let height = report.bodies[1].state.pose.translation.z;
    assert!((height - (0.1 - weight / 1e4)).abs() < 1e-9, "{height}");
    let contacts = simulation.contacts();
    near("force", contacts[0].normal_force_n, weight, 1e-7);
    assert!(simulation.accelerations().unwrap()[1].linear.length() < 1e-6);
    assert!(report.ledger.closure_relative() < 1e-12);
}

/// A restitution that no damper reaches, 0 of every material among them, gets the strongest damping, and the report
/// says what is reached; the overlap stays within that stated, and comes near it.
#[test]
fn restitution_out_of_reach_is_told() {
    for damping in [SpringDamping::HuntCrossley, SpringDamping::Plain] {
        let dead = Material::new("dead");
        let falling = Velocity::new(DVec3::Z * -1.0, DVec3::ZERO);
        let own = ball("ball", 0.1, 1000.0, &dead, DVec3::Z * 0.1001, falling);
        let penalty = PenaltyMethod { damping: Some(damping), penetration_m: Some(1e-3), ..PenaltyMethod::default() };
        let (report, impact) = run(vec![wall(&dead), own], method(penalty), 0.2);
        assert_eq!(report.springs.unwrap().out_of_reach, Some([0.0, 0.01]));
        near(&format!("{damping:?}"), impact.restitution(), 0.01, 1e-6);
    }
    let elastic = Material::new("elastic").with_restitution(1.0).unwrap();
    let falling = Velocity::new(DVec3::Z * -1.0, DVec3::ZERO);
    let own = ball("ball", 0.1, 1000.0, &elastic, DVec3::Z * 0.1001, falling);
    let penalty = PenaltyMethod { penetration_m: Some(1e-3), ..PenaltyMethod::default() };
    let (report, impact) = run(vec![wall(&elastic), own], method(penalty), 0.2);
    assert_eq!(report.springs.unwrap().out_of_reach, None);
    near("penetration of a lone elastic impact", impact.penetration_m, 1e-3, TOLERANCE);
}

/// What springs cannot do is refused when the scene is built.
#[test]
fn refusals() {
    let build = |material: Material, penalty: PenaltyMethod, shape: Shape| {
        let mass = Mass::new(1.0).unwrap();
        let own =
            Body::movable("own", solid_sphere(0.1, mass).unwrap()).geometry(shape.into()).material(material.clone());
        let own = own.pose(Pose::from_translation(DVec3::Z));
        Scene::builder("refused").method(method(penalty)).body(wall(&material)).body(own).build().unwrap_err()
    };
    let (ball, cube) = (Shape::sphere(0.1).unwrap(), Shape::cuboid(DVec3::ONE).unwrap());
    let soft = Material::new("soft").with_restitution(0.5).unwrap();
    let elastic = soft.clone().with_elasticity(1e9, 0.3).unwrap();
    assert!(matches!(build(soft.clone(), hertz(), ball.clone()), SceneError::HertzModulus { .. }));
    assert!(matches!(build(elastic.clone(), hertz(), cube), SceneError::HertzShape { .. }));
    let contradictory = [
        PenaltyMethod { penetration_m: Some(1e-3), ..hertz() },
        PenaltyMethod { penetration_m: Some(1e-3), stiffness_n_m: Some(1.0), ..PenaltyMethod::default() },
        PenaltyMethod { slip_speed_m_s: Some(1e-3), ..PenaltyMethod::default() },
    ];
    for penalty in contradictory {
        let refused = build(elastic.clone(), penalty, ball.clone());
        assert!(matches!(refused, SceneError::PenaltyKnob { .. }), "{refused}");
    }
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let penalty = PenaltyMethod { penetration_m: Some(wrong), ..PenaltyMethod::default() };
        assert!(matches!(build(soft.clone(), penalty, ball.clone()), SceneError::Number { .. }), "{wrong}");
        assert!(Material::new("wrong").with_elasticity(wrong, 0.3).is_err(), "{wrong}");
    }
    assert!(Material::new("wrong").with_elasticity(1e9, 0.6).is_err());
}
