//! `polhode cost --target E`: asked and reached on scenes with contact and friction whose motion is known in closed
//! form.
//!
//! For every scene the program names the cheapest setting of all methods whose error stays below a target. The setting
//! is run again and compared with the closed form, which the program does not know: what it says of its error must be
//! true, by whichever method. Errors are those of positions, relative to the largest distance that a body travels, as
//! the program measures them.
//!
//! The plain run takes six scenes; all sixty, and whether a setting three times as cheap would have done, are of the
//! full run, since that is timed.

use super::context::Amount;
use super::{CaseResult, Context};
use crate::calibration::closed::{ClosedForm, corpus};
use crate::row::Row;
use polhode::Recorder;
use polhode_scene::Override;
use serde_json::Value;
use std::error::Error;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

const CASE: &str = "accuracy asked and reached";

/// The plain run takes one scene in so many: one less than there are kinds, so that kinds and targets change.
const PLAIN: usize = 11;

/// Errors that are asked for, in turn.
const TARGETS: [f64; 4] = [1e-2, 1e-3, 1e-5, 1e-7];

/// Part of the scenes that may miss what is asked.
const MISSING: f64 = 0.05;

/// How far beyond what is asked an error may be.
const OPTIMISTIC: f64 = 10.0;

/// How much dearer than the cheapest setting that would do the chosen one may be.
const DEARER: f64 = 3.0;

/// Samples of a run that are compared.
const SAMPLES: u32 = 20;

/// What came of a scene.
struct Asked {
    name: String,
    /// Error reached, of what was asked.
    reached: f64,
    /// Cost of what was chosen, of the cheapest that would do.
    dearer: f64,
}

/// All rows.
pub(super) fn rows(context: &Context) -> CaseResult {
    let program = context.program.path(&context.root)?;
    let every = if context.amount == Amount::Full { 1 } else { PLAIN };
    let mut asked = Vec::new();
    for (number, known) in corpus(0).iter().enumerate().step_by(every) {
        asked.push(ask(program, known, TARGETS[number % TARGETS.len()], context)?);
    }
    let missing = asked.iter().filter(|asked| asked.reached > 1.0).count() as f64 / asked.len() as f64;
    let worst = |value: fn(&Asked) -> f64| asked.iter().max_by(|a, b| value(a).total_cmp(&value(b)));
    let mut rows = vec![Row::at_most(CASE, &format!("part of {} that miss it", asked.len()), MISSING, missing)];
    if let Some(worst) = worst(|asked| asked.reached) {
        rows.push(Row::at_most(CASE, &format!("reached, of asked: {}", worst.name), OPTIMISTIC, worst.reached));
    }
    if let (Amount::Full, Some(worst)) = (context.amount, worst(|asked| asked.dearer)) {
        rows.push(Row::at_most(CASE, &format!("dearer than needed: {}", worst.name), DEARER, worst.dearer));
    }
    Ok(rows)
}

/// Lets the program choose, and compares what it chose with the closed form.
fn ask(program: &Path, known: &ClosedForm, target: f64, context: &Context) -> Result<Asked, Box<dyn Error>> {
    let study = study(program, known, target)?;
    let candidates = study["candidates"].as_array().cloned().unwrap_or_default();
    let toml =
        study["target"]["cheapest"]["name"].as_str().ok_or(format!("{}: nothing reaches {target:e}", known.name))?;
    let is =
        |candidate: &&Value| format!("{} {}", word(candidate, "method"), word(candidate, "setting")).trim_end() == toml;
    let chosen = candidates.iter().find(is).ok_or(format!("{}: {toml} is not in the table", known.name))?;
    let reached = error(known, chosen)?;
    let cost = |candidate: &Value| candidate["time_ratio"].as_f64().unwrap_or(f64::INFINITY);
    let mut dearer = 1.0_f64;
    if context.amount == Amount::Full {
        // The closed forms are of positions; attitudes, which count too, are as the program tells them.
        let turns_well =
            |candidate: &&Value| candidate["attitude_error_rad"].as_f64().is_some_and(|error| error <= target);
        let is_cheap = |candidate: &&Value| cost(candidate) * DEARER < cost(chosen);
        for candidate in candidates.iter().filter(is_cheap).filter(turns_well) {
            if error(known, candidate).is_ok_and(|error| error <= target) {
                dearer = dearer.max(cost(chosen) / cost(candidate));
            }
        }
    }
    let name = format!("{} at {target:e} by {toml}", known.name);
    Ok(Asked { name, reached: reached / target, dearer })
}

fn word<'a>(candidate: &'a Value, key: &str) -> &'a str {
    candidate[key].as_str().unwrap_or_default()
}

/// Runs `polhode cost --target` on the scene, given on stdin.
fn study(program: &Path, known: &ClosedForm, target: f64) -> Result<Value, Box<dyn Error>> {
    let mut command = Command::new(program);
    command.args(["cost", "-", "--json", "--budget", "1.5", "--rounds", "3", "--samples", "50", "--target"]);
    let piped = command.arg(target.to_string()).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = piped.spawn()?;
    child.stdin.take().ok_or("no stdin")?.write_all(known.text.as_bytes())?;
    let output = child.wait_with_output()?;
    if !matches!(output.status.code(), Some(0 | 1)) {
        return Err(format!("{}: {}", known.name, String::from_utf8_lossy(&output.stderr)).into());
    }
    Ok(serde_json::from_slice(&output.stdout)?)
}

/// Largest distance from the closed form of the scene run by a candidate's settings, of the largest distance travelled.
fn error(known: &ClosedForm, candidate: &Value) -> Result<f64, Box<dyn Error>> {
    let changes = candidate["changes"].as_object().ok_or("a candidate without changes")?;
    let change = |(key, value): (&String, &Value)| Override::new("candidate", key, value.as_str().unwrap_or_default());
    let mut changes: Vec<Override> = changes.iter().map(change).collect();
    changes.push(Override::new("samples", "output.interval", format!("{:?}", known.duration_s / f64::from(SAMPLES))));
    let scene = polhode_scene::load_text(&known.name, &known.text, &changes)?.scene;
    let body = scene.bodies().iter().position(|body| body.name() == "body").ok_or("no body")?;
    let mut recorder = Recorder::default();
    polhode::Simulation::new(&scene)?.run_observed(&mut recorder)?;
    let start = (known.position)(0.0);
    let (mut error, mut travelled) = (0.0_f64, 0.0_f64);
    for (&t, row) in recorder.times_s.iter().zip(&recorder.samples) {
        let expected = (known.position)(t);
        error = error.max((row[body].pose.translation - expected).length());
        travelled = travelled.max((expected - start).length());
    }
    Ok(error / travelled)
}
