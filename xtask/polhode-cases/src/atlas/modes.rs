//! How small disturbances of a motion grow or die away: the exponents of its modes.
//!
//! A state x of n numbers that are small goes on by x(t + h) = P x(t). P is found by least squares from the samples of
//! one run, n of which must not depend on each other; the exponents are log(p)/h of its eigenvalues p. A linear
//! combination of what is small is as good a state as any other, so that components of orientations and angular
//! velocities do.

use super::runs::SceneRun;
use crate::cases::Run;
use crate::row::Value;
use nalgebra::{Complex, DMatrix};
use polhode::Effects;
use serde::Deserialize;
use std::error::Error;

/// Which modes.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Modes {
    /// The state, each a quantity of a body in the words of `polhode sweep --measure`.
    pub state: Vec<String>,
    /// From so many samples after the first.
    pub samples: usize,
    /// What the state is.
    #[serde(default)]
    pub of: Of,
    /// Only the exponent with the largest real part, and of it this part.
    pub largest: Option<Part>,
}

/// What a state is.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Of {
    /// The quantities themselves, which are small.
    #[default]
    Values,
    /// By how much they change from sample to sample, of a motion that repeats itself.
    Differences,
}

/// A part of a complex number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Part {
    /// The real one.
    Growth,
    /// The imaginary one.
    Frequency,
}

/// An exponent: growth and frequency, 1/s.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Exponent {
    growth: f64,
    frequency: f64,
}

/// The exponents in the order of their growth, of a conjugate pair the one that turns forward: real part, and imaginary
/// part where there is one.
///
/// # Errors
/// When the scene does not run, or its samples do not determine P.
pub(super) fn found(run: &SceneRun, modes: &Modes) -> Result<Vec<Value>, Box<dyn Error>> {
    let loaded = run.loaded()?;
    let quantities = modes.state.iter().map(|name| loaded.quantity(name)).collect::<Result<Vec<_>, _>>()?;
    let run = Run::of(&loaded.scene, Effects::Planned)?;
    let mut states: Vec<Vec<f64>> = Vec::new();
    for sample in run.record.samples.iter().take(modes.samples + 1) {
        let state: Option<Vec<f64>> = quantities.iter().map(|quantity| quantity.of_bodies(sample)).collect();
        states.push(state.ok_or("a state is made of quantities of bodies")?);
    }
    if modes.of == Of::Differences {
        let apart = |pair: &[Vec<f64>]| pair[1].iter().zip(&pair[0]).map(|(after, before)| after - before).collect();
        states = states.windows(2).map(apart).collect();
    }
    let interval_s = run.scene.output_interval_s();
    let exponents = exponents(&propagator(&states)?, interval_s);
    if let Some(part) = modes.largest {
        let largest = exponents.last().ok_or("there is no mode")?;
        return Ok(vec![Value::Number(if part == Part::Growth { largest.growth } else { largest.frequency })]);
    }
    let parts = exponents.iter().flat_map(|own| [Some(own.growth), (own.frequency != 0.0).then_some(own.frequency)]);
    Ok(parts.flatten().map(Value::Number).collect())
}

/// P of least squares.
fn propagator(states: &[Vec<f64>]) -> Result<DMatrix<f64>, Box<dyn Error>> {
    let (size, count) = (states.first().map_or(0, Vec::len), states.len().saturating_sub(1));
    if count < size || size == 0 {
        return Err(format!("{count} steps do not determine {size} modes").into());
    }
    let rows = |of: &[Vec<f64>]| DMatrix::from_fn(count, size, |row, column| of[row][column]);
    let (before, after) = (rows(&states[..count]), rows(&states[1..]));
    let factors = before.qr();
    let solved = factors.r().solve_upper_triangular(&(factors.q().transpose() * after));
    Ok(solved.ok_or("the samples do not determine all modes")?.transpose())
}

/// The exponents of a propagator over this time, s.
fn exponents(propagator: &DMatrix<f64>, interval_s: f64) -> Vec<Exponent> {
    let of = |value: &Complex<f64>| {
        let turn = if value.im.abs() < REAL * value.re.abs() { 0.0 } else { value.im };
        let growth = libm::log(libm::hypot(value.re, value.im));
        Exponent { growth: growth / interval_s, frequency: libm::atan2(turn, value.re) / interval_s }
    };
    let values = propagator.complex_eigenvalues();
    let mut all: Vec<Exponent> = values.iter().map(of).filter(|own| own.frequency >= 0.0).collect();
    all.sort_by(|a, b| a.growth.total_cmp(&b.growth));
    all
}

/// A root whose imaginary part is below this part of the real one is real: rounding leaves some 1e-12.
const REAL: f64 = 1e-9;

#[cfg(test)]
mod tests {
    //! A damped oscillation and a decay are told apart in what is a mixture of both.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn the_exponents_of_a_mixture_are_found() {
        let state = |t: f64| {
            let wave = (-0.5 * t).exp();
            let (c, s, d) = (wave * (3.0 * t).cos(), wave * (3.0 * t).sin(), (-2.0 * t).exp());
            vec![c + d, s - 0.5 * d, c + s + 2.0 * d]
        };
        let states: Vec<Vec<f64>> = (0..12).map(|k| state(0.1 * f64::from(k))).collect();
        let found = exponents(&propagator(&states).unwrap(), 0.1);
        assert_eq!(found.len(), 2);
        assert!((found[0].growth + 2.0).abs() < 1e-9 && found[0].frequency == 0.0, "{found:?}");
        assert!((found[1].growth + 0.5).abs() < 1e-9 && (found[1].frequency - 3.0).abs() < 1e-9, "{found:?}");
    }
}
