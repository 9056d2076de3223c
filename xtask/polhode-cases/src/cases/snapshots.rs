//! Snapshots: a run that goes on from one has the same bits as a run that was never stopped.
//!
//! Every shipped scene is stopped at random times, each at the end of a step or at an event in the middle of the steps
//! of others, kept as bytes, and continued by another simulation. The samples and events before the stop and those
//! after it together have the strict hash of the run that was never stopped, and the reports are the same.

use super::run::Run;
use super::{Amount, CaseResult, Context};
use crate::row::Row;
use polhode::{BodySample, ErrorEstimation, Event, Flow, Observer, Outcome, Recorder, RunReport, Simulation, Snapshot};
use polhode_oracles::random::Random;
use std::error::Error;
use strict_hash::strict_hash;

/// Stops of each scene.
const STOPS: usize = 20;

/// The same when not all cases run.
const FEW_STOPS: usize = 2;

/// Every shipped scene, stopped and continued.
pub(super) fn continued_runs(context: &Context) -> CaseResult {
    let stops = match context.amount {
        Amount::Full => STOPS,
        Amount::Part => FEW_STOPS,
    };
    let mut rows = Vec::new();
    for (number, scene) in context.shipped.names()?.iter().enumerate() {
        let quantity = format!("{scene}: stops after which the run goes on with other bits, of {stops}");
        rows.push(match differing(context, scene, stops, number as u64) {
            Ok(differing) => Row::exact("snapshots", &quantity, "none", differing),
            Err(error) => Row::broken("snapshots", &quantity, error.to_string()),
        });
    }
    Ok(rows)
}

/// The times of those stops, or `none`.
fn differing(context: &Context, scene: &str, stops: usize, seed: u64) -> Result<String, Box<dyn Error>> {
    let whole = context.shipped.run(scene)?;
    let mut random = Random(seed);
    let mut times: Vec<f64> = (0..stops).map(|_| random.between(0.0, whole.scene.duration_s())).collect();
    times.sort_by(f64::total_cmp);
    let mut simulation = Simulation::new(&whole.scene)?.estimating(ErrorEstimation::Off);
    let mut before = Until { record: Recorder::default(), stop_s: 0.0 };
    let mut wrong = Vec::new();
    for stop_s in times {
        before.stop_s = stop_s;
        if simulation.time() < stop_s && simulation.run_observed(&mut before)?.outcome == Outcome::Completed {
            break;
        }
        let bytes = simulation.snapshot().to_bytes();
        if !goes_on(&whole, before.record.clone(), &bytes)? {
            wrong.push(simulation.time().to_string());
        }
    }
    Ok(if wrong.is_empty() { "none".to_owned() } else { format!("t = {} s", wrong.join(", ")) })
}

/// Whether another simulation goes on from the snapshot to the end of the whole run.
fn goes_on(whole: &Run, mut record: Recorder, bytes: &[u8]) -> Result<bool, Box<dyn Error>> {
    let mut simulation = Simulation::new(&whole.scene)?.estimating(ErrorEstimation::Off);
    simulation.restore(&Snapshot::from_bytes(bytes)?)?;
    let report = simulation.run_observed(&mut record)?;
    Ok(strict_hash(&record) == strict_hash(&whole.record) && text(&report) == text(&whole.report))
}

/// A report with all digits.
fn text(report: &RunReport) -> String {
    format!("{report:?}")
}

/// Keeps everything until a step ends at or after a time (s).
struct Until {
    record: Recorder,
    stop_s: f64,
}

impl Observer for Until {
    fn sample(&mut self, t: f64, bodies: &[BodySample]) {
        self.record.sample(t, bodies);
    }

    fn event(&mut self, event: &Event) {
        self.record.event(event);
    }

    fn progress(&mut self, t: f64) -> Flow {
        if t >= self.stop_s { Flow::Stop } else { Flow::Continue }
    }
}

#[cfg(test)]
mod tests {
    //! A scene with impacts and rest is stopped and continued.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use std::path::Path;

    #[test]
    fn a_bouncing_ball_goes_on() {
        let context = Context::new(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."), Amount::Part).unwrap();
        assert_eq!(differing(&context, "bouncing-ball", 3, 1).unwrap(), "none");
    }
}
