//! FR-02 against the best of other engines, and what every integrator makes of it.
//!
//! Other engines were measured on this rotation over 100 s, with errors computed from recorded states by one program.
//! The best was MuJoCo's RK4 with 100,000 steps of 1 ms: 4e-12 rad. This engine has a tenth of the steps, its default.

use super::bodies::rotor;
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::{Row, Value};
use glam::DVec3;
use polhode::scene::{Integrator, Method};
use polhode::spatial::Rotation;
use polhode::{Effects, Scene};
use std::error::Error;

const CASE: &str = "peers";
/// The best error of another engine, rad.
const BEST: f64 = 4e-12;
/// A tenth of its steps, s.
const STEP_S: f64 = 0.01;

fn run(integrator: Option<Integrator>) -> Result<Run, Box<dyn Error>> {
    let scene = Scene::builder("free rotation")
        .gravity(DVec3::ZERO)
        .body(rotor("rotor", DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.01, 2.0, 0.01))?)
        .duration_s(100.0)
        .output_interval_s(100.0)
        .method(Method { integrator, step_s: Some(STEP_S), ..Method::default() })
        .build()?;
    Run::of(&scene, Effects::Planned)
}

/// The reference orientation of FR-02 at its end.
fn reference(context: &Context) -> Result<Rotation, Box<dyn Error>> {
    let row = context.reference.row("FR-02", "q at t = 100 s", [0.0; 4])?;
    match row.reference {
        Some(Value::Numbers(numbers)) => match numbers[..] {
            [w, x, y, z] => Ok(Rotation::from_wxyz([w, x, y, z])?),
            _ => Err("the reference orientation has not four numbers".into()),
        },
        _ => Err("the reference orientation is not made of numbers".into()),
    }
}

/// The default method against the best peer; the others, and times, for information.
pub(super) fn free_rotation(context: &Context) -> CaseResult {
    let exact = reference(context)?;
    let error = |run: &Run| run.last("rotor").map(|last| last.pose.rotation.angle_to(exact));
    let default = run(None)?;
    let mut rows = vec![
        Row::at_most(CASE, "FR-02, 100 s: error of the default method, rad", BEST, error(&default)?),
        Row::info(CASE, "FR-02, 100 s: steps of the default method, of the peer", 100_000, default.report.steps),
        Row::info(CASE, "FR-02, 100 s: wall time of the default method, ms", "", default.wall_s * 1000.0),
    ];
    for integrator in Integrator::ALL {
        let run = run(Some(integrator))?;
        rows.push(Row::info(CASE, &format!("FR-02, 100 s: error of {integrator} at 0.01 s, rad"), BEST, error(&run)?));
        let microseconds = run.wall_s / run.report.steps as f64 * 1e6;
        rows.push(Row::info(CASE, &format!("FR-02: {integrator}: a step, us"), "", microseconds));
    }
    Ok(rows)
}
