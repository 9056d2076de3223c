//! The limit of stiffness of springs (thesis, section 3.1): step against stiffness, explicit against implicit, and what
//! each costs.
//!
//! A ball of 1 kg falls 5 cm on a floor with a linear spring of stiffness k (N/m) and no damper, and is followed for
//! 0.3 s. With `w = sqrt(k/m)` an explicit step is stable up to `2/w` (semi-implicit Euler) and `2.78/w` (RK4). Beyond,
//! a run is refused with the longest step that would do. The implicit midpoint rule is stable on a spring at any step,
//! but not where the contact begins within one: the ball is as deep in the floor then as it has flown, and leaves with
//! the energy of a spring that is pressed so far. Below that it gains little. Error control locates the begin and the
//! end: a contact costs the same number of steps, however short it is.
//!
//! Errors are of the height after 0.3 s against error control at 1e-12. The notes of the rows are the table of
//! `docs/contact-methods/penalty.md`.

use super::bodies::{GRAVITY, half_space};
use super::rough_plane::sphere;
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::scene::{Integrator, Material, Method, PenaltyMethod, Response};
use polhode::spatial::{Pose, UnitVector};
use polhode::{Effects, Scene, SimulationError};
use std::error::Error;

const CASE: &str = "stiffness limit";
/// Radius (m), height of the fall (m) and duration (s).
const RADIUS: f64 = 0.1;
const FALL_M: f64 = 0.05;
const DURATION_S: f64 = 0.3;
/// Stiffness, N/m: the floor gives way by 3 cm to 3 micrometres.
const STIFFNESSES: [f64; 5] = [1e3, 1e5, 1e7, 1e9, 1e11];
/// The stiffest for which fixed explicit steps are made: their number goes with the root.
const STIFFEST_EXPLICIT: f64 = 1e9;
/// Explicit methods with their bound of a step times a frequency.
const EXPLICIT: [(Integrator, f64); 2] = [(Integrator::SemiImplicitEuler, 2.0), (Integrator::Rk4, 2.78)];
/// Tolerances of error control: of what is compared with, and of everyday, within which its error of the fall stays.
const TIGHT: f64 = 1e-12;
const EVERYDAY: f64 = 1e-6;
/// Part of the bound that is used.
const WITHIN: f64 = 0.5;
/// Bounds are those of the frequency to this, relative.
const BOUND: f64 = 1e-9;
/// The error of a fixed step within its bound, of the fall: the run is stable, but a contact of few steps ends early or
/// late by one.
const FEW_STEPS: f64 = 1.0;
/// Energy that the implicit rule may gain over the run with steps at the bound of Euler, of that of the fall.
const GAIN: f64 = 1e-2;

/// The ball with a method, on a floor of this stiffness.
fn fall(stiffness: f64, method: &Method) -> Result<Run, Box<dyn Error>> {
    let material = Material::new("elastic").with_restitution(1.0)?;
    let ball = sphere(RADIUS)?.pose(Pose::from_translation(DVec3::Z * (RADIUS + FALL_M))).material(material.clone());
    let penalty = PenaltyMethod { stiffness_n_m: Some(stiffness), ..PenaltyMethod::default() };
    let method = Method { response: Some(Response::Penalty), penalty: Some(penalty), ..method.clone() };
    let scene = Scene::builder("fall").body(ball).body(half_space("floor", UnitVector::Z).material(material));
    let scene = scene.method(method).duration_s(DURATION_S).output_interval_s(DURATION_S).build()?;
    Run::of(&scene, Effects::Planned)
}

/// Height of the ball above touch (m), and its energy over that of the fall.
fn end(run: &Run) -> Result<[f64; 2], Box<dyn Error>> {
    let state = run.report.bodies.first().ok_or("no body")?.state;
    let height = state.pose.translation.z - RADIUS;
    let moving = 0.5 * state.velocity.linear.length_squared() / GRAVITY;
    Ok([height, (height + moving) / FALL_M])
}

/// The longest step (s) that a refusal names; none where the run is not refused.
fn named_step(run: Result<Run, Box<dyn Error>>) -> Option<f64> {
    match run.err()?.downcast_ref::<SimulationError>()? {
        SimulationError::StepTooLong { limit_s, .. } => Some(*limit_s),
        _ => None,
    }
}

fn fixed(integrator: Integrator, step_s: f64) -> Method {
    Method { integrator: Some(integrator), step_s: Some(step_s), ..Method::default() }
}

/// All rows.
pub(super) fn rows(_context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for stiffness in STIFFNESSES {
        let frequency = stiffness.sqrt();
        let exact = fall(stiffness, &Method { tolerance: Some(TIGHT), ..Method::default() })?;
        let height = end(&exact)?[0];
        let controlled = fall(stiffness, &Method { tolerance: Some(EVERYDAY), ..Method::default() })?;
        rows.push(row(stiffness, "error control at 1e-6", (&controlled, height), EVERYDAY)?);
        for (integrator, bound) in EXPLICIT {
            let named = named_step(fall(stiffness, &fixed(integrator, 1.1 * bound / frequency)));
            let quantity = format!("k = {stiffness:e} N/m: longest step of {integrator} that a refusal names, s");
            rows.push(Row::compared(
                CASE,
                &quantity,
                bound / frequency,
                named.unwrap_or(f64::NAN),
                Tolerance::Relative(BOUND),
            ));
            if stiffness <= STIFFEST_EXPLICIT {
                let run = fall(stiffness, &fixed(integrator, WITHIN * bound / frequency))?;
                rows.push(row(stiffness, &format!("{integrator} at half its bound"), (&run, height), FEW_STEPS)?);
            }
        }
        for times in [1.0, 30.0] {
            let step_s = (times * 2.0 / frequency).min(0.1 * DURATION_S);
            let run = fall(stiffness, &fixed(Integrator::ImplicitMidpoint, step_s))?;
            let energy = end(&run)?[1];
            let what = format!("implicit-midpoint at {times} times the bound of Euler");
            rows.push(row(stiffness, &what, (&run, height), f64::INFINITY)?);
            let quantity = format!("k = {stiffness:e} N/m: {what}");
            rows.push(if times > 1.0 {
                Row::info(CASE, &format!("{quantity}: energy at the end, of that of the fall"), "", energy)
            } else {
                let gain = (energy - 1.0).max(0.0);
                Row::at_most(CASE, &format!("{quantity}: gain of energy, of that of the fall"), GAIN, gain)
            });
        }
    }
    Ok(rows)
}

/// The error of a run, of the fall, with its steps.
fn row(stiffness: f64, what: &str, (run, height): (&Run, f64), limit: f64) -> Result<Row, Box<dyn Error>> {
    let error = (end(run)?[0] - height).abs() / FALL_M;
    let quantity = format!("k = {stiffness:e} N/m: {what}: error of the height, of the fall");
    let row = if limit.is_finite() {
        Row::at_most(CASE, &quantity, limit, error)
    } else {
        Row::info(CASE, &quantity, "", error)
    };
    Ok(Row { note: Some(format!("{} steps, {:.4} s", run.report.steps, run.wall_s)), ..row })
}
