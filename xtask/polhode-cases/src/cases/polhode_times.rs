//! Times along the polhode: flips and periods of FR-02 to FR-04, wobbles about principal axes of FR-05.
//!
//! A body that spins near its middle axis flips over at times that depend on the logarithm of how near it was: FR-03
//! misses the axis by 1e-8 and waits 35 s. Times are zeros of the middle component of the body rate.

use super::bodies::rotor;
use super::motion::{Crossing, angular_momentum, body_rate, state_at, zeros};
use super::{CaseResult, Context};
use glam::DVec3;
use polhode::dynamics::FreeRotation;
use polhode::mesh::solid_box;
use polhode::scene::Method;
use polhode::spatial::{Mass, Rotation, Velocity};
use polhode::{Body, Scene};
use std::error::Error;
use std::f64::consts::TAU;

/// Principal moments, kg m^2.
const MOMENTS: DVec3 = DVec3::new(1.0, 2.0, 3.0);

/// Samples of a run in which zeros are looked for; a flip takes some seconds.
const SAMPLES: f64 = 2000.0;

/// A free rotation that is flown in one step, whatever its length.
fn flight(body: Body, duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    Ok(Scene::builder("free rotation")
        .gravity(DVec3::ZERO)
        .body(body)
        .duration_s(duration_s)
        .output_interval_s(duration_s / SAMPLES)
        .method(Method { step_s: Some(duration_s), ..Method::default() })
        .build()?)
}

/// Zeros of the middle component of the angular velocity, s.
fn flips(spin: DVec3, duration_s: f64, count: usize) -> Result<Vec<f64>, Box<dyn Error>> {
    zeros(&flight(rotor("rotor", MOMENTS, spin)?, duration_s)?, count, Crossing::Any, |sample| body_rate(sample).y)
}

/// Flips of the body near the separatrix.
pub(super) fn fr_02(context: &Context, spin: DVec3) -> CaseResult {
    let times = flips(spin, 60.0, 5)?;
    let row = |quantity: &str, measured: f64| context.reference.row("FR-02", quantity, measured);
    let parameter = record(spin).parameter().ok_or("the rotation is steady")?;
    let end = state_at(&flight(rotor("rotor", MOMENTS, spin)?, 100.0)?, 100.0)?;
    let momentum = angular_momentum(MOMENTS, &end);
    let energy = 0.5 * momentum.dot(end.velocity.angular);
    Ok(vec![
        row("period of w in body axes, s", times[2] - times[0])?,
        row("time between flips, s", times[1] - times[0])?,
        row("elliptic parameter m", parameter)?,
        context.reference.row("FR-02", "first five zeros of w2, s", times)?,
        context.reference.row("FR-02", "E, |L|, J and kg m^2/s", [energy, momentum.length()])?,
    ])
}

/// The period of the generic rotation.
pub(super) fn fr_04(context: &Context, spin: DVec3) -> CaseResult {
    let times = flips(spin, 12.0, 3)?;
    Ok(vec![context.reference.row("FR-04", "period of w in body axes, s", times[2] - times[0])?])
}

/// Next to the separatrix.
pub(super) fn fr_03(context: &Context) -> CaseResult {
    /// How far the spin is from the middle axis, rad/s.
    const MISSED: f64 = 1e-8;
    let spin = DVec3::new(MISSED, 1.0, MISSED);
    let times = flips(spin, 110.0, 2)?;
    let rate = record(spin).phase_rate().ok_or("the rotation is steady")?;
    let row = |quantity: &str, measured: f64| context.reference.row("FR-03", quantity, measured);
    Ok(vec![
        row("first zero of w2, s", times[0])?,
        row("second zero of w2, s", times[1])?,
        row("growth rate about the middle axis, 1/s", rate)?,
    ])
}

/// The record of a rotation that starts unturned.
fn record(spin: DVec3) -> FreeRotation {
    FreeRotation::new(MOMENTS, Rotation::IDENTITY, MOMENTS * spin)
}

/// A book that is thrown spinning about each of its axes.
pub(super) fn fr_05(context: &Context) -> CaseResult {
    /// Deviation of the spin, rad/s: its square is what the small-angle formulas leave out.
    const WOBBLE: f64 = 1e-5;
    /// Deviation that grows a hundredfold and stays small.
    const SEED: f64 = 1e-8;
    /// Time over which it grows, s.
    const GROWING_S: f64 = 9.0;
    let book = |spin: DVec3| -> Result<Body, Box<dyn Error>> {
        let properties = solid_box(DVec3::new(1.0, 4.0, 6.0), Mass::new(1.0)?)?;
        Ok(Body::movable("book", properties).velocity(Velocity::new(DVec3::ZERO, spin)))
    };
    let mut rows = Vec::new();
    for (axis, name) in [(DVec3::X, "largest"), (DVec3::Z, "smallest")] {
        let scene = flight(book(axis + DVec3::Y * WOBBLE)?, 40.0)?;
        let times = zeros(&scene, 3, Crossing::Any, |sample| body_rate(sample).y)?;
        let quantity = format!("wobble about the axis of the {name} moment, rad/s");
        rows.push(context.reference.row("FR-05", &quantity, TAU / (times[2] - times[0]))?);
    }
    let end = state_at(&flight(book(DVec3::new(SEED, 1.0, 0.0))?, GROWING_S)?, GROWING_S)?;
    // A deviation along one of the other axes alone grows as cosh(rate t).
    let rate = (body_rate(&end).x / SEED).acosh() / GROWING_S;
    rows.push(context.reference.row("FR-05", "growth about the middle axis, 1/s", rate)?);
    Ok(rows)
}
