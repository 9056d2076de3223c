//! Springs of the tier `penalty` against closed forms: Hertz's impacts of two balls and of a ball on a rigid plane (Chung and
//! Ooi 2011, tests 1 and 2), restitution by both dampers, gross slip and sticking (tests 3 to 7), and the ledger.

use polhode::contact::Shape;
use polhode::mesh::solid_sphere;
use polhode::scene::{Material, Method, PenaltyMethod, Response, SpringLaw};
use polhode::spatial::{DVec3, Mass, Pose, UnitVector, Velocity};
use polhode::{Body, RunReport, Scene, Simulation, SpringImpact};
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
    let scene = bodies.into_iter().fold(scene, |scene, body| scene.body(body)).build().unwrap();
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
    println!("{impact:?}");
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
