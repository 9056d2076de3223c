//! The energy of time steps in which fields and contacts act together: what they share is booked where it belongs.

use crate::support::{brick, floor};
use polhode::scene::{Attachment, Force, Method, Tier};
use polhode::spatial::{DVec3, Velocity};
use polhode::{BodyId, Scene, Simulation};

/// Step, s.
const STEP_S: f64 = 0.01;

/// What the integrator may lose, J: 1e-4 of the 100 J that the spring stores. It is of second order in the step.
const SMALL_J: f64 = 1e-2;

/// A smooth brick of 1 kg slides at 1 m/s over the floor, while a spring of 100 N presses it down. In each step the
/// spring gives it 1 N s and the floor takes it back. Booked one after the other, the integrator would gain 0.5 J in
/// each of the ten steps and the impacts lose it; neither does.
#[test]
fn a_spring_that_presses_a_body_on_the_floor_gives_the_integrator_nothing() {
    let center = DVec3::Z * 0.05;
    let slides = Velocity::new(DVec3::X, DVec3::ZERO);
    let spring = Force::Spring {
        a: Attachment::World(center + DVec3::Z),
        b: Attachment::Body { body: BodyId::new(1), point: DVec3::ZERO },
        stiffness: 50.0,
        rest_length: 3.0,
        damping: 0.0,
    };
    let method = Method { tier: Some(Tier::Stepped), step_s: Some(STEP_S), ..Method::default() };
    let scene = Scene::builder("pressed")
        .body(floor())
        .body(brick("brick", DVec3::splat(0.1), center).velocity(slides))
        .force(spring)
        .duration_s(0.1)
        .method(method)
        .build()
        .unwrap();
    let report = Simulation::new(&scene).unwrap().run().unwrap();
    let ledger = &report.ledger;
    assert!(ledger.impact.value().abs() < SMALL_J, "impacts took {} J", ledger.impact.value());
    assert!(ledger.numerical.value().abs() < SMALL_J, "the integrator took {} J", ledger.numerical.value());
    assert!(ledger.closure_relative() < 1e-12);
}

/// What the rod on a pivot may give the integrator, J: some 1e-8 J are measured, and the order of action would show
/// 3e-2 J.
const OF_INTEGRATOR_J: f64 = 1e-6;

/// What its impacts may take, J: 1.2e-5 J are measured, of the same 3e-2 J.
const OF_IMPACTS_J: f64 = 1e-4;

/// A smooth rod turns about a pivot at its end, with its other end on the floor. In each step its weight gives it an
/// angular momentum about the pivot, and the floor takes it back. Booked one after the other, the integrator would gain
/// 3e-3 J in each of the ten steps and the impacts lose it; the integrator gains nothing, and impacts take a little.
#[test]
fn the_weight_of_a_body_on_a_pivot_that_lies_on_the_floor_gives_the_integrator_nothing() {
    let (pivot, center) = (DVec3::Z * 0.05, DVec3::new(0.2, 0.0, 0.05));
    let turns = Velocity::new(DVec3::Y * 0.2, DVec3::Z);
    let method = Method { tier: Some(Tier::Stepped), step_s: Some(STEP_S), ..Method::default() };
    let scene = Scene::builder("turning")
        .body(floor())
        .body(brick("rod", DVec3::new(0.4, 0.1, 0.1), center).velocity(turns).pivot(pivot))
        .duration_s(0.1)
        .method(method)
        .build()
        .unwrap();
    let report = Simulation::new(&scene).unwrap().run().unwrap();
    let ledger = &report.ledger;
    assert!(ledger.impact.value().abs() < OF_IMPACTS_J, "impacts took {} J", ledger.impact.value());
    assert!(ledger.numerical.value().abs() < OF_INTEGRATOR_J, "the integrator took {} J", ledger.numerical.value());
    assert!(ledger.closure_relative() < 1e-12);
}
