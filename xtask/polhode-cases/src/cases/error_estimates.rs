//! Errors that runs tell beside their true errors, over scenes whose motion is known: the shares of `cargo xtask
//! calibrate`; and the horizons that runs tell beside the true ones, of chaotic scenes.

use super::{Amount, CaseResult, Context};
use crate::calibration::{self, Finding, GOALS, Horizon, Judged, Known, Shares, WITHIN, judge_all};
use crate::row::Row;
use polhode::ErrorEstimation;

const CASE: &str = "error estimates";

/// The plain run takes one scene in so many.
const PLAIN: usize = 10;

/// The plain run finds the horizons of the scenes whose names begin so.
const PLAIN_HORIZONS: [&str; 2] = ["billiard", "dice"];

/// What the shares are of.
const WHAT: [&str; 3] = ["at least a tenth of the true error", "at least a hundredth", "at most 100 times it"];

/// The shares of the runs of all tiers, and those of each.
#[allow(clippy::unnecessary_wraps, reason = "cases give a result")]
pub(super) fn rows(context: &Context) -> CaseResult {
    let all = calibration::all(&context.root, 0);
    let every = if context.amount == Amount::Full { 1 } else { PLAIN };
    let meant: Vec<&Known> = all.iter().step_by(every).collect();
    let judged = judge_all(&meant, ErrorEstimation::Quick, |_| {});
    let all = Shares::of(judged.iter());
    let row = |((what, goal), met): ((&&str, f64), f64)| {
        Row::at_most(CASE, &format!("share of runs that do not tell {what}"), 1.0 - goal, 1.0 - met)
    };
    let mut rows: Vec<Row> = WHAT.iter().zip(GOALS).zip(all.met).map(row).collect();
    for tier in calibration::tiers(&judged) {
        let shares = Shares::of(judged.iter().filter(|one| one.tier == tier));
        let quantity = format!("{}: those shares, of {} runs", tier.name(), shares.compared);
        rows.push(Row::info(CASE, &quantity, "", shares.met.map(|met| 1.0 - met)));
    }
    let failed = |one: &&Judged| matches!(one.finding, Finding::Failed(_));
    let named: Vec<&str> = judged.iter().filter(failed).map(|one| one.name.as_str()).collect();
    let named = if named.is_empty() { "none".to_owned() } else { named.join(", ") };
    rows.push(Row::exact(CASE, &format!("of {} scenes, those that fail", meant.len()), "none", named));
    let begin: &[&str] = if context.amount == Amount::Full { &[""] } else { &PLAIN_HORIZONS };
    let found = |begin: &&str| calibration::horizons(&context.root, begin, ErrorEstimation::Full, |_| {});
    rows.extend(begin.iter().flat_map(found).map(|horizon| of_horizon(&horizon)));
    Ok(rows)
}

/// How many times the true horizon is the told one, or the other way about; infinite where it is not told.
fn of_horizon(horizon: &Horizon) -> Row {
    let of = |(told, truth): (f64, f64)| (told / truth).max(truth / told);
    let factor = horizon.told_s.zip(horizon.true_s).map_or(f64::INFINITY, of);
    Row::at_most(CASE, &format!("horizon of {}: factor", horizon.name), WITHIN, factor)
}
