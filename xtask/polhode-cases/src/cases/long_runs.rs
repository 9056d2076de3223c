//! CD-05: a million steps of a box at rest and of a pendulum; those of a free body are FR-07.

use super::bodies::{GRAVITY, cuboid, half_space};
use super::invariances::pendulum;
use super::motion::{Crossing, angle_between, zeros};
use super::run::{Run, movement_m};
use super::{CaseResult, Context};
use crate::row::Value;
use glam::DVec3;
use polhode::scene::Method;
use polhode::spatial::UnitVector;
use polhode::{BodySample, Effects, Scene};
use std::error::Error;
use std::f64::consts::TAU;

/// Steps at full count.
const STEPS: usize = 1_000_000;
/// Length of a step, s.
const STEP_S: f64 = 1e-3;

/// At rest, swinging.
pub(super) fn cd_05(context: &Context) -> CaseResult {
    let steps = context.amount.of(STEPS);
    let mut rows = Vec::new();
    for (effects, name) in [(Effects::Planned, "planned effects"), (Effects::All, "all effects")] {
        let quantity = "resting box: displacement, m";
        let mut row = context.reference.row("CD-05", quantity, resting_box(steps, effects)?)?;
        row.quantity = format!("{quantity}: {steps} steps, {name}");
        rows.push(row);
    }
    let (period, quantity) = (swing_period()?, "10 degrees: period of the rod, s");
    let period_row = context.reference.row("JT-01", quantity, period)?;
    let Some(Value::Number(exact)) = period_row.reference else {
        return Err("the period of the pendulum is no number".into());
    };
    rows.push(period_row);
    let (drift, phase) = swinging(steps, exact)?;
    for (quantity, measured) in [("pendulum: relative drift of energy", drift), ("pendulum: phase error, rad", phase)] {
        let mut row = context.reference.row("CD-05", quantity, measured)?;
        row.quantity = format!("{quantity}: {steps} steps");
        rows.push(row);
    }
    Ok(rows)
}

fn method() -> Method {
    Method { step_s: Some(STEP_S), ..Method::default() }
}

/// Largest distance that a cube on the floor has moved by the end, m.
fn resting_box(steps: usize, effects: Effects) -> Result<f64, Box<dyn Error>> {
    let duration_s = STEP_S * steps as f64;
    let scene = Scene::builder("resting box")
        .body(half_space("floor", UnitVector::Z))
        .body(cuboid("box", DVec3::ONE, 1.0, DVec3::Z * 0.5)?)
        .duration_s(duration_s)
        .output_interval_s(duration_s / 10.0)
        .method(method())
        .build()?;
    let run = Run::of(&scene, effects)?;
    let (Some(first), Some(last)) = (run.record.samples.first(), run.record.samples.last()) else {
        return Err("no samples".into());
    };
    Ok(movement_m(&scene, first, last))
}

/// A rod let go at 10 degrees; the first zero of its angle is a quarter of the period from the start.
fn rod(duration_s: f64) -> Result<polhode::SceneBuilder, Box<dyn Error>> {
    let scene = Scene::builder("pendulum").gravity(DVec3::Z * -GRAVITY);
    Ok(scene.body(pendulum(10.0_f64.to_radians())?).duration_s(duration_s))
}

/// Angle from hanging, rad, with its sign.
fn angle(sample: &BodySample) -> f64 {
    let hanging = sample.pose.rotation.rotate(DVec3::Z);
    angle_between(hanging, DVec3::Z) * hanging.x.signum()
}

/// The period by the default method, s.
fn swing_period() -> Result<f64, Box<dyn Error>> {
    let times = zeros(&rod(3.0)?.build()?, 3, Crossing::Any, angle)?;
    Ok(times[2] - times[0])
}

/// Relative drift of energy, and the phase error (rad) where the rod last hung straight down.
fn swinging(steps: usize, period: f64) -> Result<(f64, f64), Box<dyn Error>> {
    let duration_s = STEP_S * steps as f64;
    let scene = rod(duration_s)?.method(method()).output_interval_s(duration_s.min(1.0)).build()?;
    let run = Run::of(&scene, Effects::Planned)?;
    let drift = run.report.ledger.numerical.value() / run.report.ledger.scale_j;
    // Near the last time at which it ought to hang straight down, its angle is its rate there times the delay.
    let quarters = ((duration_s / period - 0.25) * 2.0).floor();
    let straight_s = (0.25 + 0.5 * quarters) * period;
    let sample = super::motion::state_at(&scene, straight_s)?;
    let delay_s = angle(&sample) / sample.velocity.angular.y;
    Ok((drift, delay_s.abs() * TAU / period))
}
