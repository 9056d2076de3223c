//! `polhode cost SCENE --scale N,2N,4N`: how the time of a method grows with the number of bodies.
//!
//! The arrays of the scene are given these numbers of bodies, and every method runs each size: those of `--vary`, or
//! every tier with its own settings. The time is the least of some rounds, since whatever else the machine does only
//! adds to it. The exponent between two sizes of `N` bodies that take times `T` is `p = ln(T2/T1) / ln(N2/N1)`. A size
//! that would take longer than the method's share of `--budget` is left out, as the last size and the exponent so far
//! tell.

use super::text::ratio;
use crate::failure::Failure;
use crate::text::Table;
use polhode::Scene;
use polhode::scene::Tier;
use polhode_scene::Override;
use polhode_scene::csv::quoted;
use polhode_study::candidate::{self, Axis, Candidate, change};
use polhode_study::{Source, StudyError};
use serde_json::{Value, json};
use std::fmt::Write as _;

/// What errors name as the place of a number of bodies.
const ORIGIN: &str = "command line (--scale)";

/// Rounds of a size, unless its share of the time is spent before.
const ROUNDS: u32 = 3;

/// The exponent from which the time of the second size is expected (no unit).
const EXPECTED_GROWTH: f64 = 1.5;

/// What was measured.
#[derive(Debug)]
pub(super) struct ScaleStudy {
    scene: String,
    duration_s: f64,
    /// Every method at every size, the sizes of a method one after the other.
    rows: Vec<Row>,
}

/// A method at one size.
#[derive(Debug)]
struct Row {
    method: String,
    /// Bodies that forces move.
    bodies: usize,
    outcome: Result<Taken, String>,
}

/// The time of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Taken {
    seconds: f64,
    steps: u64,
    /// Of the growth from the size before; none for the first.
    exponent: Option<f64>,
}

impl ScaleStudy {
    /// Runs every method of `axes`, or every tier, at every size.
    ///
    /// # Errors
    /// When the scene has no arrays of moving bodies, or `axes` or a size are refused.
    pub(super) fn run(source: &Source<'_>, sizes: &[u32], axes: &[Axis], budget_s: f64) -> Result<Self, Failure> {
        let loaded = source.loaded()?;
        let (scene, duration_s) = (loaded.scene.name().to_owned(), loaded.scene.duration_s());
        let scaled = |&size: &u32| {
            loaded.scaled_to(size, ORIGIN).ok_or_else(|| {
                let what = "--scale changes the number of bodies of [[arrays]], and the scene has none that move";
                Failure::Usage(format!("error: {what}; see [[arrays]] in docs/scene-format.md"))
            })
        };
        let sizes: Vec<Vec<Override>> = sizes.iter().map(scaled).collect::<Result<_, _>>()?;
        let methods = if axes.is_empty() {
            Tier::ALL.into_iter().map(of_tier).collect()
        } else {
            candidate::product(axes).map_err(StudyError::Axis)?
        };
        let share_s = budget_s / methods.len() as f64;
        let rows = methods.iter().flat_map(|method| of_method(source, method, &sizes, share_s)).collect();
        Ok(Self { scene, duration_s, rows })
    }

    /// The table for people.
    pub(super) fn page(&self) -> String {
        let mut table = Table::default();
        table.row(["method", "bodies", "s a simulated s", "steps", "exponent"]);
        for row in &self.rows {
            let bodies = row.bodies.to_string();
            match &row.outcome {
                Ok(taken) => {
                    let exponent = taken.exponent.map_or_else(String::new, |exponent| format!("{exponent:.2}"));
                    let time = ratio(taken.seconds / self.duration_s);
                    table.row([&row.method, &bodies, &time, &taken.steps.to_string(), &exponent]);
                }
                Err(reason) => table.row([&row.method, &bodies, reason, "", ""]),
            }
        }
        let what = "time: the least of some rounds on this machine, without preparing the scene; exponent: of the \
                    growth from the size before";
        format!("scene {}, {} s\n\n{}\n{what}\n", self.scene, self.duration_s, table.print())
    }

    /// The table as CSV.
    pub(super) fn csv(&self) -> String {
        let mut text = "method,bodies,time_s,steps,exponent,failure\n".to_owned();
        for row in &self.rows {
            let (method, bodies) = (&row.method, row.bodies);
            let _ = match &row.outcome {
                Ok(Taken { seconds, steps, exponent }) => {
                    let exponent = exponent.map_or_else(String::new, |exponent| format!("{exponent:?}"));
                    writeln!(text, "{method},{bodies},{seconds:?},{steps},{exponent},")
                }
                Err(reason) => writeln!(text, "{method},{bodies},,,,{}", quoted(reason)),
            };
        }
        text
    }

    /// Everything as JSON.
    pub(super) fn json(&self) -> Value {
        let row = |row: &Row| {
            let mut value = json!({ "method": row.method, "bodies": row.bodies });
            match &row.outcome {
                Ok(taken) => {
                    value["time_s"] = json!(taken.seconds);
                    value["steps"] = json!(taken.steps);
                    value["exponent"] = json!(taken.exponent);
                }
                Err(reason) => value["failure"] = json!(reason),
            }
            value
        };
        json!({
            "scene": self.scene,
            "duration_s": self.duration_s,
            "rows": self.rows.iter().map(row).collect::<Vec<_>>(),
        })
    }
}

fn of_tier(tier: Tier) -> Candidate {
    let changes = vec![change("method.tier", tier.name())];
    Candidate { series: tier.name().to_owned(), rung: String::new(), changes, growth: None }
}

/// One method at every size, the smallest first.
fn of_method(source: &Source<'_>, method: &Candidate, sizes: &[Vec<Override>], share_s: f64) -> Vec<Row> {
    let mut before: Option<(usize, Taken)> = None;
    let mut rows = Vec::with_capacity(sizes.len());
    for size in sizes {
        let changes: Vec<Override> = size.iter().chain(&method.changes).cloned().collect();
        let bodies = source.scene(size).as_ref().map_or(0, moving);
        let outcome = source.scene(&changes).and_then(|scene| of_size(source, &scene, before, share_s));
        if let Ok(taken) = outcome {
            before = Some((bodies, taken));
        }
        rows.push(Row { method: method.name(), bodies, outcome });
    }
    rows
}

fn of_size(source: &Source<'_>, scene: &Scene, before: Option<(usize, Taken)>, share_s: f64) -> Result<Taken, String> {
    let bodies = moving(scene);
    let more = before.map(|(fewer, taken)| (bodies as f64 / fewer.max(1) as f64, taken));
    if let Some((more, taken)) = more {
        let growth = taken.exponent.unwrap_or(EXPECTED_GROWTH);
        let expected_s = taken.seconds * more.powf(growth);
        if expected_s > share_s {
            return Err(format!("left out: about {expected_s:.1} s a run; a larger --budget includes it"));
        }
    }
    let (mut least, mut total, mut steps) = (f64::INFINITY, 0.0, 0);
    for _ in 0..ROUNDS {
        let (report, took) = source.run(scene)?;
        (least, steps) = (least.min(took.as_secs_f64()), report.steps);
        total += took.as_secs_f64();
        if total > share_s {
            break;
        }
    }
    let exponent = more.map(|(more, taken)| (least / taken.seconds).ln() / more.ln());
    Ok(Taken { seconds: least, steps, exponent: exponent.filter(|exponent| exponent.is_finite()) })
}

/// Bodies that forces move.
fn moving(scene: &Scene) -> usize {
    scene.bodies().iter().filter(|body| !body.is_fixed() && body.motion().is_none()).count()
}
