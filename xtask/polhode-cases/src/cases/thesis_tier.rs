//! The tier `thesis` on the diamonds: it does what the thesis saw, and its certificate says how wrong it is.
//!
//! The thesis's method lets the 3- and 4-diamond drift apart and collapse (Videos 13, 14), although they stand, and
//! makes the 5-diamond fall asymmetrically (Video 15), although it falls symmetrically.

use super::bodies::BRICK;
use super::diamonds::{Sides, diamond, mirror_error_m};
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::scene::{Method, Tier};
use polhode::{Acceleration, BodySample, Effects, Flow, Observer, Scene, Simulation};
use std::error::Error;

/// A brick that has moved this far has fallen, m.
const COLLAPSED_M: f64 = 0.5 * BRICK.z;
/// An asymmetry that cannot be rounding, m.
const ASYMMETRIC_M: f64 = 1e-3;

/// What the thesis saw.
pub(super) fn diamonds(_context: &Context) -> CaseResult {
    let case = "tier thesis";
    let mut rows = Vec::new();
    for m in [3, 4] {
        let run = Run::of(&thesis(diamond(m, Sides::Collide, 60.0)?), Effects::Planned)?;
        let moved = run.largest_movement_m();
        rows.push(Row::exact(case, &format!("{m}-diamond collapses within 60 s"), true, moved > COLLAPSED_M));
        rows.push(Row::info(case, &format!("{m}-diamond: largest movement in 60 s, m"), 0.0, moved));
    }
    let run = Run::of(&thesis(diamond(5, Sides::Collide, 2.0)?), Effects::Planned)?;
    let asymmetry = run.record.samples.iter().map(|sample| mirror_error_m(5, &sample[1..])).fold(0.0, f64::max);
    rows.push(Row::exact(case, "5-diamond falls asymmetrically", true, asymmetry > ASYMMETRIC_M));
    rows.push(Row::info(case, "5-diamond: mirror error in 2 s, m", 0.0, asymmetry));
    for m in [3, 4, 5] {
        rows.push(bound_row(case, m)?);
    }
    Ok(rows)
}

fn thesis(scene: Scene) -> Scene {
    scene.with_method(Method { tier: Some(Tier::Thesis), ..Method::default() })
}

/// The error of the accelerations of the tier `thesis` against the exact ones, step by step for as long as the state
/// is one that the exact tier accepts; it may not exceed the bound of the certificate.
fn bound_row(case: &str, m: usize) -> Result<Row, Box<dyn Error>> {
    /// Steps that are compared.
    const STEPS: usize = 20;
    /// Rounding of an error of zero and a bound of zero, in the unit of both.
    const ROUNDING: f64 = 1e-6;
    let scene = diamond(m, Sides::Collide, 10.0)?;
    let mut simulation = Simulation::new(&thesis(scene.clone()))?;
    let mut excess = 0.0f64;
    let mut compared = 0;
    let mut states: Vec<BodySample> = scene
        .bodies()
        .iter()
        .map(|body| BodySample { pose: *body.initial_pose(), velocity: *body.initial_velocity() })
        .collect();
    for _ in 0..STEPS {
        let thesis_accelerations = simulation.accelerations()?;
        let exact = at_state(&scene, &states)?;
        let report = simulation.run_observed(&mut OneStep)?;
        if let Ok(exact) = Simulation::new(&exact).and_then(|mut s| s.accelerations()) {
            let error = energy_norm(&scene, &states, &thesis_accelerations, &exact);
            excess = excess.max(error - report.certificate.max_acceleration_error_bound.unwrap_or(0.0));
            compared += 1;
        }
        states = report.bodies.iter().map(|body| body.state).collect();
    }
    if compared == 0 {
        return Err("no state of the tier thesis could be compared".into());
    }
    let quantity = format!("{m}-diamond: largest error above its bound, {compared} steps");
    Ok(Row::at_most(case, &quantity, ROUNDING, excess.max(0.0)))
}

/// The scene with its bodies in these states.
fn at_state(scene: &Scene, states: &[BodySample]) -> Result<Scene, Box<dyn Error>> {
    let mut builder = Scene::builder(scene.name()).gravity(scene.gravity()).duration_s(scene.duration_s());
    for (body, state) in scene.bodies().iter().zip(states) {
        builder = builder.body(body.clone().pose(state.pose).velocity(state.velocity));
    }
    Ok(builder.build()?)
}

/// `sqrt(da.M da)` of the difference of two sets of accelerations.
fn energy_norm(scene: &Scene, states: &[BodySample], a: &[Acceleration], b: &[Acceleration]) -> f64 {
    let mut sum = 0.0;
    for (number, body) in scene.bodies().iter().enumerate() {
        let Some(properties) = body.mass_properties() else { continue };
        let linear: DVec3 = a[number].linear - b[number].linear;
        let angular = states[number].pose.rotation.inverse_rotate(a[number].angular - b[number].angular);
        sum += properties.mass() * linear.length_squared() + angular.dot(properties.inertia().matrix() * angular);
    }
    sum.sqrt()
}

/// Stops a run after every step.
#[derive(Debug)]
struct OneStep;

impl Observer for OneStep {
    fn sample(&mut self, _t: f64, _bodies: &[BodySample]) {}

    fn progress(&mut self, _t: f64) -> Flow {
        Flow::Stop
    }
}
