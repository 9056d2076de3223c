//! The videos of the thesis: every scene that shows one does what its description says, the wrong ones by their fault
//! and the right ones without it. Tops, table, stacks and diamonds have cases of their own besides.

use super::diamonds::mirror_error_m;
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::BodySample;

const CASE: &str = "videos";

/// A guess of the inertia that is wrong by ten makes a body come to rest earlier or later by more than this, s.
const OTHER_REST_S: f64 = 0.2;
/// An axis that nods does so by more than this, rad.
const NODS_RAD: f64 = 0.01;
/// An axis that goes round does so by more than a turn, rad.
const TURN_RAD: f64 = std::f64::consts::TAU;
/// A bounce is higher than this, m.
const BOUNCE_M: f64 = 0.1;
/// What sinks does so by more than this in a second, m.
const SINKS_M: f64 = 5e-3;
/// What vibrates moves up and down by more than this, m.
const VIBRATES_M: f64 = 1e-4;
/// What moves less is not seen, m.
const UNSEEN_M: f64 = 1e-4;
/// A brick that has moved by half its height has fallen, m.
const FALLEN_M: f64 = 0.125;
/// An asymmetry that cannot be rounding, m.
const ASYMMETRIC_M: f64 = 1e-3;
/// How long bodies that have come to rest are looked at, s.
const LAST_S: f64 = 1.0;

/// All scenes that show a video.
pub(super) fn rows(context: &Context) -> CaseResult {
    let run = |name: &str| context.shipped.run(name);
    let mut rows = Vec::new();
    let (large, right) = (rest_s(&*run("box-drop-wrong-inertia")?), rest_s(&*run("box-drop")?));
    rows.push(more(1, "how much later the box with a large inertia rests, s", OTHER_REST_S, large - right));
    let (small, right) = (rest_s(&*run("pyramid-drop-wrong-inertia")?), rest_s(&*run("pyramid-drop")?));
    rows.push(more(2, "how much earlier the pyramid with a small inertia rests, s", OTHER_REST_S, right - small));
    let (nutation, precession) = nodding_and_turning(&*run("spinning-top")?);
    rows.push(more(3, "nutation of the top, rad", NODS_RAD, nutation));
    rows.push(more(3, "precession of the top, rad", TURN_RAD, precession));
    let caught = highest_after_landing(&*run("bouncing-ball-caught")?);
    rows.push(more(4, "how deep the ball that is caught stays at the least, m", 0.0, -caught));
    rows.push(more(4, "how high the other one bounces, m", BOUNCE_M, highest_after_landing(&*run("bouncing-ball")?)));
    for (video, name) in [(5, "box-drop"), (6, "pyramid-drop")] {
        let sinking = last_heights(&*run(&format!("{name}-sinking"))?);
        rows.push(more(video, "how far the body sinks in the last second, m", SINKS_M, sinking.first - sinking.last));
        rows.push(still(video, &*run(name)?));
    }
    for (video, name) in [(7, "box-drop"), (8, "pyramid-drop")] {
        let vibrating = run(&format!("{name}-vibrating"))?;
        let lifted_j = -vibrating.report.ledger.projection.value();
        rows.push(more(
            video,
            "how far the body vibrates in the last second, m",
            VIBRATES_M,
            last_heights(&vibrating).range,
        ));
        rows.push(more(video, "energy that lifting the body has given, J", 0.0, lifted_j));
        rows.push(still(video, &*run(name)?));
    }
    let by_forces = last_heights(&*run("box-drop-contact-forces")?).range;
    rows.push(Row::at_most(CASE, "video 9: movement by forces in the last second, m", UNSEEN_M, by_forces));
    for (video, name) in [(13, "diamond-3-drifting"), (14, "diamond-4-collapsing")] {
        rows.push(more(video, "how far the farthest brick falls, m", FALLEN_M, run(name)?.largest_movement_m()));
    }
    let mirror_error =
        |run: &Run| run.record.samples.iter().map(|bodies| mirror_error_m(5, &bodies[1..])).fold(0.0, f64::max);
    rows.push(more(15, "mirror error, m", ASYMMETRIC_M, mirror_error(&*run("diamond-5-asymmetric")?)));
    rows.push(Row::at_most(
        CASE,
        "video 15: mirror error of the right version, m",
        ASYMMETRIC_M,
        mirror_error(&*run("diamond-5")?),
    ));
    Ok(rows)
}

/// That a quantity is larger than what is asked.
fn more(video: usize, quantity: &str, asked: f64, measured: f64) -> Row {
    let mut row = Row::exact(CASE, &format!("video {video}: {quantity}: above {asked}"), true, measured > asked);
    row.note = Some(format!("{measured:.4}"));
    row
}

/// That the right version has not moved in the last second.
fn still(video: usize, run: &Run) -> Row {
    let quantity = format!("video {video}: movement of the right version in the last second, m");
    Row::exact(CASE, &quantity, 0.0, last_heights(run).range)
}

/// The body that each of these scenes is about: the last one.
fn body(bodies: &[BodySample]) -> Option<&BodySample> {
    bodies.last()
}

/// The time from which on the body turns no more, s; that of the last sample when it still turns.
fn rest_s(run: &Run) -> f64 {
    let turns = |bodies: &Vec<BodySample>| body(bodies).is_some_and(|body| body.velocity.angular != DVec3::ZERO);
    let last = run.record.samples.iter().rposition(turns).unwrap_or_default();
    run.record.times_s.get(last).copied().unwrap_or(f64::NAN)
}

/// Heights of the origin of the body in the last second, m.
struct Heights {
    first: f64,
    last: f64,
    range: f64,
}

fn last_heights(run: &Run) -> Heights {
    let end_s = run.record.times_s.last().copied().unwrap_or_default();
    let samples = run.record.times_s.iter().zip(&run.record.samples).filter(|(t, _)| **t >= end_s - LAST_S);
    let heights: Vec<f64> =
        samples.filter_map(|(_, bodies)| body(bodies)).map(|body| body.pose.translation.z).collect();
    let (Some(&first), Some(&last)) = (heights.first(), heights.last()) else {
        return Heights { first: f64::NAN, last: f64::NAN, range: f64::NAN };
    };
    Heights { first, last, range: range(&heights) }
}

fn range(numbers: &[f64]) -> f64 {
    let (low, high) =
        numbers.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &x| (low.min(x), high.max(x)));
    high - low
}

/// Highest place of the ball's lowest point after it has come to the floor, m.
fn highest_after_landing(run: &Run) -> f64 {
    /// Radius of the ball of these scenes, m.
    const RADIUS: f64 = 0.5;
    let heights: Vec<f64> = run
        .record
        .samples
        .iter()
        .filter_map(|bodies| body(bodies))
        .map(|body| body.pose.translation.z - RADIUS)
        .collect();
    // The first sample from which it does not fall any further.
    let landed = heights.windows(2).position(|pair| pair[1] > pair[0]).unwrap_or(heights.len());
    heights[landed.min(heights.len())..].iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// Range of the tilt of the top's axis, and how far it goes round the vertical, rad.
fn nodding_and_turning(run: &Run) -> (f64, f64) {
    let axes: Vec<DVec3> = run
        .record
        .samples
        .iter()
        .filter_map(|bodies| body(bodies))
        .map(|body| body.pose.rotation.rotate(DVec3::Z))
        .collect();
    let tilts: Vec<f64> = axes.iter().map(|axis| libm::acos(axis.z)).collect();
    let turned = axes.windows(2).map(|pair| {
        let [a, b] = [pair[0], pair[1]];
        libm::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y)
    });
    (range(&tilts), turned.sum::<f64>().abs())
}
