//! Free rotation: FR-01 to FR-07 against closed forms, whatever the step and the sampling.

use super::bodies::rotor;
use super::motion::{angle_between, angular_momentum, body_rate};
use super::run::Run;
use super::{CaseResult, Context, polhode_times};
use crate::row::Row;
use glam::{DMat3, DVec3};
use polhode::scene::Method;
use polhode::{BodySample, Effects, Scene};
use std::error::Error;

/// Principal moments of FR-02, FR-04 and FR-07, kg m^2.
const MOMENTS: DVec3 = DVec3::new(1.0, 2.0, 3.0);
/// Largest relative change of energy and angular momentum: a few units in the last place.
const CONSERVATION: f64 = 1e-13;
/// Samples of the run that is compared with a single step.
const SAMPLES: u32 = 6000;

/// A symmetric body: its axis precesses about the angular momentum.
pub(super) fn fr_01(context: &Context) -> CaseResult {
    let (moments, spin, time) = (DVec3::new(2.0, 2.0, 1.0), DVec3::new(1.0, 0.0, 5.0), 10.0);
    let last = run(moments, spin, time, time)?.last("rotor")?;
    let mut rows = end_state(context, "FR-01", "", &last, time)?;
    let quarter = run(moments, spin, 1.0, 1.0)?.last("rotor")?;
    let momentum = moments * spin;
    // The turn of the symmetry axis about the angular momentum, less than half a turn in a second.
    let across = |axis: DVec3| axis - momentum * (axis.dot(momentum) / momentum.length_squared());
    let angle = angle_between(across(DVec3::Z), across(quarter.pose.rotation.rotate(DVec3::Z)));
    rows.push(context.reference.row("FR-01", "precession rate |L|/I1, rad/s", angle)?);
    Ok(rows)
}

/// Near the separatrix: the body turns over every 11 s.
pub(super) fn fr_02(context: &Context) -> CaseResult {
    let spin = DVec3::new(0.01, 2.0, 0.01);
    let mut rows = free_rotation(context, "FR-02", spin, &[100.0])?;
    rows.extend(polhode_times::fr_02(context, spin)?);
    Ok(rows)
}

/// A generic motion, over a short and a long time.
pub(super) fn fr_04(context: &Context) -> CaseResult {
    let mut rows = free_rotation(context, "FR-04", DVec3::ONE, &[10.0, 1000.0])?;
    rows.extend(polhode_times::fr_04(context, DVec3::ONE)?);
    Ok(rows)
}

/// A needle that spins fast about its long axis, and a plate.
pub(super) fn fr_06(context: &Context) -> CaseResult {
    /// Of the needle about its long axis, kg m^2.
    const THIN: f64 = 1e-6;
    let bodies = [
        ("needle: ", DVec3::new(THIN, 1.0, 1.0 + THIN), DVec3::new(100.0, 1.0, 0.5)),
        ("plate: ", DVec3::new(1.0, 1.5, 2.5), DVec3::new(1.0, 2.0, 3.0)),
    ];
    let mut rows = Vec::new();
    for (name, moments, spin) in bodies {
        let last = run(moments, spin, 10.0, 10.0)?.last("rotor")?;
        rows.extend(end_state(context, "FR-06", name, &last, 10.0)?);
    }
    Ok(rows)
}

/// Many steps: what is conserved is conserved, and a rotation stays one.
pub(super) fn fr_07(context: &Context) -> CaseResult {
    /// Steps at full count.
    const STEPS: usize = 1_000_000;
    /// Lengths of the steps, s.
    const LENGTHS_S: [f64; 2] = [1e-3, 1e-4];
    let steps = context.amount.of(STEPS);
    let mut rows = Vec::new();
    for step in LENGTHS_S {
        let time = step * steps as f64;
        let scene = scene(MOMENTS, DVec3::ONE, time, step)?;
        let scene = scene.output_interval_s(time / 1000.0).build()?;
        let run = Run::of(&scene, Effects::Planned)?;
        let start = MOMENTS * DVec3::ONE;
        let energy = &run.report.energy;
        let mut drift = [((energy.final_j - energy.initial_j) / energy.initial_j).abs(), 0.0];
        let (mut off_rotation, mut direction) = ([0.0f64; 2], 0.0f64);
        for sample in run.record.samples.iter().filter_map(|bodies| bodies.first()) {
            let momentum = angular_momentum(MOMENTS, sample);
            drift[1] = f64::max(drift[1], (momentum.length() / start.length() - 1.0).abs());
            direction = direction.max(angle_between(momentum, start));
            let norm = sample.pose.rotation.quaternion().length();
            let matrix = sample.pose.rotation.to_matrix();
            let defect = matrix.transpose() * matrix - DMat3::IDENTITY;
            off_rotation[0] = off_rotation[0].max((norm - 1.0).abs());
            off_rotation[1] = defect.to_cols_array().iter().fold(off_rotation[1], |most, x| most.max(x.abs()));
        }
        let quantities: [(&str, Vec<f64>); 3] = [
            ("relative drift of E and |L|", drift.to_vec()),
            ("| |q| - 1 |, |R^T R - 1|", off_rotation.to_vec()),
            ("direction of L in the world, rad", vec![direction]),
        ];
        for (quantity, measured) in quantities {
            let measured = if measured.len() == 1 { measured[0].into() } else { crate::row::Value::Numbers(measured) };
            let mut row = context.reference.row("FR-07", quantity, measured)?;
            row.quantity = format!("{quantity}: {steps} steps of {step} s");
            rows.push(row);
        }
    }
    Ok(rows)
}

fn free_rotation(context: &Context, case: &str, spin: DVec3, times: &[f64]) -> CaseResult {
    let mut rows = Vec::new();
    for &time in times {
        let at = |what: &str| format!("{what} at t = {time} s");
        let once = run(MOMENTS, spin, time, time)?;
        let often = run(MOMENTS, spin, time, time / f64::from(SAMPLES))?;
        let (last, sampled) = (once.last("rotor")?, often.last("rotor")?);
        rows.extend(end_state(context, case, "", &last, time)?);
        let same = bits(&last) == bits(&sampled);
        rows.push(Row::exact(case, &at(&format!("same bits in one step and in {SAMPLES}")), true, same));
        let energy = &once.report.energy;
        let energy_change = (energy.final_j - energy.initial_j) / energy.initial_j;
        rows.push(Row::at_most(case, &at("relative change of energy"), CONSERVATION, energy_change));
        let start = MOMENTS * spin;
        let momentum_change = (angular_momentum(MOMENTS, &last) - start).length() / start.length();
        rows.push(Row::at_most(case, &at("relative change of L"), CONSERVATION, momentum_change));
    }
    Ok(rows)
}

/// Angular velocity and orientation at the end; `of` names the body where a case has several.
fn end_state(context: &Context, case: &str, of: &str, last: &BodySample, time: f64) -> CaseResult {
    let rate = format!("{of}w in body axes at t = {time} s, rad/s");
    Ok(vec![
        context.reference.row(case, &rate, body_rate(last).to_array())?,
        orientation_row(context, case, &format!("{of}q at t = {time} s"), last)?,
    ])
}

fn scene(moments: DVec3, spin: DVec3, time: f64, step: f64) -> Result<polhode::SceneBuilder, Box<dyn Error>> {
    Ok(Scene::builder("free rotation")
        .gravity(DVec3::ZERO)
        .body(rotor("rotor", moments, spin)?)
        .duration_s(time)
        .method(Method { step_s: Some(step), ..Method::default() }))
}

/// A run in steps of this interval, each of them sampled.
fn run(moments: DVec3, spin: DVec3, time: f64, interval: f64) -> Result<Run, Box<dyn Error>> {
    let scene = scene(moments, spin, time, interval)?.output_interval_s(interval).build()?;
    Run::of(&scene, Effects::Planned)
}

/// The orientation against the reference, with the sign that is nearer to it.
pub(super) fn orientation_row(
    context: &Context,
    case: &str,
    quantity: &str,
    sample: &BodySample,
) -> Result<Row, Box<dyn Error>> {
    let q = sample.pose.rotation.to_wxyz();
    let as_is = context.reference.row(case, quantity, q)?;
    let opposite = context.reference.row(case, quantity, q.map(|component| -component))?;
    Ok(if as_is.error <= opposite.error { as_is } else { opposite })
}

/// All bits of a state.
pub(super) fn bits(sample: &BodySample) -> [u64; 13] {
    let p = sample.pose.translation.to_array();
    let q = sample.pose.rotation.to_wxyz();
    let v = sample.velocity.linear.to_array();
    let w = sample.velocity.angular.to_array();
    let mut bits = [0; 13];
    for (slot, number) in bits.iter_mut().zip(p.iter().chain(&q).chain(&v).chain(&w)) {
        *slot = number.to_bits();
    }
    bits
}
