//! What the plan leaves out is not missed: the same bits where effects are absent or bodies rest, the same motion to
//! 1e-12 where the plan reduces the motion (a plane instead of space, rotation about a pivot instead of rows that hold
//! it).

use super::free_rotation::bits;
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use polhode::scene::{Integrator, Method};
use polhode::{Decision, Effect, Effects, EventKind};
use std::error::Error;

/// Up to when motions are compared at most, s.
const HORIZON_S: f64 = 1.0;

/// Scenes of which the first impact amplifies any difference a millionfold: a pile of 25 bodies that falls to pieces.
const CHAOTIC_AFTER_IMPACT: &[&str] = &["diamond-5"];

/// Tolerance of the runs by which rows and reduction of a pivot are compared: a tenth of the difference allowed.
const TOLERANCE: f64 = 1e-13;

/// How far a reduced motion may be from the full one, of the size and speed of the scene (1 in the scenes shipped).
const REDUCTION: f64 = 1e-12;

/// Every sample of every shipped scene, with the planned effects and with all.
pub(super) fn planned_equals_all(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for name in context.shipped.names()? {
        rows.push(compare(context, &name).unwrap_or_else(|error| Row::broken("effects", &name, error.to_string())));
    }
    Ok(rows)
}

fn compare(context: &Context, scene: &str) -> Result<Row, Box<dyn Error>> {
    let planned = context.shipped.run(scene)?;
    let all = Run::of(&planned.scene, Effects::All)?;
    if is_planar(&planned) {
        let until = horizon(&planned);
        let quantity = format!("{scene}: difference of planar motion from effects = all until t = {until:.3} s");
        return Ok(Row::at_most("effects", &quantity, REDUCTION, largest_difference(&planned, &all, until)));
    }
    if let Some((reduced, rows)) = with_and_without_rows(&planned)? {
        let until = horizon(&reduced);
        let quantity = format!("{scene}: difference of reduced rotation from rows at the pivot until t = {until:.3} s");
        return Ok(Row::at_most("effects", &quantity, REDUCTION, largest_difference(&reduced, &rows, until)));
    }
    let quantity = format!("{scene}: first sample that differs from effects = all");
    Ok(Row::exact("effects", &quantity, "none", first_difference(&planned, &all).as_deref().unwrap_or("none")))
}

/// A scene with pivots by the reduction of the plan and by rows, both under error control far below the difference
/// allowed; nothing when the plan reduces none.
fn with_and_without_rows(planned: &Run) -> Result<Option<(Run, Run)>, Box<dyn Error>> {
    let joints = planned.report.plan.effects.iter().find(|effect| effect.effect == Effect::Joints);
    let held = joints.is_some_and(|effect| effect.decision == Decision::On);
    if held || !planned.scene.bodies().iter().any(|body| body.pivot_point().is_some()) {
        return Ok(None);
    }
    let method = Method { integrator: Some(Integrator::Dop853), tolerance: Some(TOLERANCE), ..*planned.scene.method() };
    let scene = planned.scene.clone().with_method(method);
    Ok(Some((Run::of(&scene, Effects::Planned)?, Run::of(&scene, Effects::All)?)))
}

fn is_planar(run: &Run) -> bool {
    let planar = run.report.plan.effects.iter().find(|effect| effect.effect == Effect::PlanarMotion);
    planar.is_some_and(|effect| effect.decision == Decision::On)
}

/// The first second; of a scene whose motion is chaotic after an impact, up to the first.
fn horizon(run: &Run) -> f64 {
    let is_chaotic = CHAOTIC_AFTER_IMPACT.contains(&run.scene.name());
    let impact = run.record.events.iter().find(|event| event.kind == EventKind::Impact && is_chaotic);
    impact.map_or(HORIZON_S, |event| event.t_s.min(HORIZON_S))
}

/// Largest difference of position (m), velocity (m/s), attitude (rad) and angular velocity (rad/s) of a body.
fn largest_difference(a: &Run, b: &Run, until: f64) -> f64 {
    let mut largest = 0.0f64;
    for ((t, sample_a), sample_b) in a.record.times_s.iter().zip(&a.record.samples).zip(&b.record.samples) {
        if *t > until {
            break;
        }
        for (state_a, state_b) in sample_a.iter().zip(sample_b) {
            let apart = (state_a.pose.translation - state_b.pose.translation).length();
            let speed = (state_a.velocity.linear - state_b.velocity.linear).length();
            let turned = state_a.pose.rotation.angle_to(state_b.pose.rotation);
            let spin = (state_a.velocity.angular - state_b.velocity.angular).length();
            // A state that is not a number counts as infinitely far.
            let differences = [apart, speed, turned, spin].map(|d| if d.is_nan() { f64::INFINITY } else { d });
            largest = differences.into_iter().fold(largest, f64::max);
        }
    }
    largest
}

/// Time and body of the first sample in which two runs differ in a bit.
fn first_difference(a: &Run, b: &Run) -> Option<String> {
    if a.record.times_s.len() != b.record.times_s.len() {
        return Some(format!("{} and {} samples", a.record.times_s.len(), b.record.times_s.len()));
    }
    for (number, (sample_a, sample_b)) in a.record.samples.iter().zip(&b.record.samples).enumerate() {
        for (body, (state_a, state_b)) in sample_a.iter().zip(sample_b).enumerate() {
            if bits(state_a) != bits(state_b) || a.record.times_s[number] != b.record.times_s[number] {
                return Some(format!("t = {} s, body {}", a.record.times_s[number], a.scene.bodies()[body].name()));
            }
        }
    }
    None
}
