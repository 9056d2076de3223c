//! Free rotation: FR-02 and FR-04 against Jacobi's elliptic functions, whatever the step and the sampling.

use super::bodies::rotor;
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::scene::Method;
use polhode::{BodySample, Effects, Scene};
use std::error::Error;

/// Principal moments of both cases, kg m^2.
const MOMENTS: DVec3 = DVec3::new(1.0, 2.0, 3.0);
/// Largest relative change of energy and angular momentum: a few units in the last place.
const CONSERVATION: f64 = 1e-13;
/// Samples of the run that is compared with a single step.
const SAMPLES: u32 = 6000;

/// Near the separatrix: the body turns over every 11 s.
pub(super) fn fr_02(context: &Context) -> CaseResult {
    let spin = DVec3::new(0.01, 2.0, 0.01);
    free_rotation(context, "FR-02", spin, &[100.0])
}

/// A generic motion, over a short and a long time.
pub(super) fn fr_04(context: &Context) -> CaseResult {
    free_rotation(context, "FR-04", DVec3::ONE, &[10.0, 1000.0])
}

fn free_rotation(context: &Context, case: &str, spin: DVec3, times: &[f64]) -> CaseResult {
    let mut rows = Vec::new();
    for &time in times {
        let at = |what: &str, unit: &str| format!("{what} at t = {time} s{unit}");
        let once = run(spin, time, time)?;
        let often = run(spin, time, time / f64::from(SAMPLES))?;
        let (last, sampled) = (once.last("rotor")?, often.last("rotor")?);
        let body_rate = last.pose.rotation.inverse_rotate(last.velocity.angular);
        rows.push(context.reference.row(case, &at("w in body axes", ", rad/s"), body_rate.to_array())?);
        rows.push(orientation_row(context, case, &at("q", ""), &last)?);
        let same = bits(&last) == bits(&sampled);
        rows.push(Row::exact(case, &at(&format!("same bits in one step and in {SAMPLES}"), ""), true, same));
        let energy = &once.report.energy;
        let energy_change = (energy.final_j - energy.initial_j) / energy.initial_j;
        rows.push(Row::at_most(case, &at("relative change of energy", ""), CONSERVATION, energy_change));
        rows.push(Row::at_most(case, &at("relative change of L", ""), CONSERVATION, momentum_change(&last, spin)));
    }
    Ok(rows)
}

/// One step of the whole time, sampled at an interval.
fn run(spin: DVec3, time: f64, interval: f64) -> Result<Run, Box<dyn Error>> {
    let scene = Scene::builder("free rotation")
        .gravity(DVec3::ZERO)
        .body(rotor("rotor", MOMENTS, spin)?)
        .duration_s(time)
        .output_interval_s(interval)
        .method(Method { step_s: Some(interval), ..Method::default() })
        .build()?;
    Run::of(&scene, Effects::Planned)
}

/// The orientation against the reference, with the sign that is nearer to it.
fn orientation_row(context: &Context, case: &str, quantity: &str, sample: &BodySample) -> Result<Row, Box<dyn Error>> {
    let q = sample.pose.rotation.to_wxyz();
    let as_is = context.reference.row(case, quantity, q)?;
    let opposite = context.reference.row(case, quantity, q.map(|component| -component))?;
    Ok(if as_is.error <= opposite.error { as_is } else { opposite })
}

/// Distance of the angular momentum from that of the start, relative to it; the body starts unrotated.
fn momentum_change(sample: &BodySample, spin: DVec3) -> f64 {
    let rotation = sample.pose.rotation;
    let momentum = rotation.rotate(MOMENTS * rotation.inverse_rotate(sample.velocity.angular));
    let start = MOMENTS * spin;
    (momentum - start).length() / start.length()
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
