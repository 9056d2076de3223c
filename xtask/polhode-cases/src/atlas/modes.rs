//! How small disturbances of a motion grow or die away: the exponents of its modes.
//!
//! A state x of n numbers that are small goes on by x(t + h) = P x(t). P is found by least squares from the samples of
//! one run, n of which must not depend on each other; the exponents are log(p)/h of its eigenvalues p. A linear
//! combination of what is small is as good a state as any other, so that components of orientations and angular
//! velocities do.

use super::runs::SceneRun;
use crate::cases::Run;
use crate::row::Value;
use polhode::Effects;
use serde::Deserialize;
use std::error::Error;
use std::f64::consts::TAU;

/// Turns of the search for the roots of a polynomial: some twenty are needed.
const MOST_TURNS: usize = 500;

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

/// A complex number.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Complex {
    re: f64,
    im: f64,
}

impl Complex {
    fn plus(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }

    fn minus(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }

    fn times(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }

    fn over(self, other: Self) -> Self {
        let square = other.re * other.re + other.im * other.im;
        let turned = self.times(Self { re: other.re, im: -other.im });
        Self { re: turned.re / square, im: turned.im / square }
    }
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
        return Ok(vec![Value::Number(if part == Part::Growth { largest.re } else { largest.im })]);
    }
    let parts = exponents.iter().flat_map(|own| [Some(own.re), (own.im != 0.0).then_some(own.im)]);
    Ok(parts.flatten().map(Value::Number).collect())
}

/// P of least squares: by orthogonal columns (Gram and Schmidt, twice).
fn propagator(states: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, Box<dyn Error>> {
    let (size, count) = (states.first().map_or(0, Vec::len), states.len().saturating_sub(1));
    if count < size || size == 0 {
        return Err(format!("{count} steps do not determine {size} modes").into());
    }
    let column = |number: usize| -> Vec<f64> { states[..count].iter().map(|state| state[number]).collect() };
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let mut upper = vec![vec![0.0; size]; size];
    for number in 0..size {
        let mut own = column(number);
        for _ in 0..2 {
            for (k, other) in basis.iter().enumerate() {
                let part = dot(&own, other);
                upper[k][number] += part;
                own.iter_mut().zip(other).for_each(|(own, other)| *own -= part * other);
            }
        }
        let length = dot(&own, &own).sqrt();
        if length == 0.0 {
            return Err("the samples do not determine all modes".into());
        }
        upper[number][number] = length;
        basis.push(own.into_iter().map(|own| own / length).collect());
    }
    let row = |of: usize| {
        let next: Vec<f64> = states[1..].iter().map(|state| state[of]).collect();
        let mut solution = vec![0.0; size];
        for number in (0..size).rev() {
            let known: f64 = (number + 1..size).map(|k| upper[number][k] * solution[k]).sum();
            solution[number] = (dot(&basis[number], &next) - known) / upper[number][number];
        }
        solution
    };
    Ok((0..size).map(row).collect())
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The exponents of a propagator over this time, s: roots of its characteristic polynomial (Faddeev and LeVerrier) by
/// Weierstrass's method.
fn exponents(propagator: &[Vec<f64>], interval_s: f64) -> Vec<Complex> {
    let size = propagator.len();
    let mut coefficients = vec![1.0];
    let mut matrix = vec![vec![0.0; size]; size];
    for order in 1..=size {
        let last = coefficients.last().copied().unwrap_or(1.0);
        matrix = product(propagator, &matrix);
        (0..size).for_each(|k| matrix[k][k] += last);
        let trace: f64 = (0..size).map(|k| product(propagator, &matrix)[k][k]).sum();
        coefficients.push(-trace / order as f64);
    }
    let start = |k: usize| {
        let (sine, cosine) = libm::sincos(0.4 + TAU * k as f64 / size as f64);
        Complex { re: 0.9 * cosine, im: 0.9 * sine }
    };
    let mut roots: Vec<Complex> = (0..size).map(start).collect();
    for _ in 0..MOST_TURNS {
        for k in 0..size {
            let zero = Complex { re: 0.0, im: 0.0 };
            let value =
                coefficients.iter().fold(zero, |sum, &own| sum.times(roots[k]).plus(Complex { re: own, im: 0.0 }));
            let others = (0..size).filter(|&other| other != k);
            let apart = others.fold(Complex { re: 1.0, im: 0.0 }, |all, other| all.times(roots[k].minus(roots[other])));
            roots[k] = roots[k].minus(value.over(apart));
        }
    }
    let mut all: Vec<Complex> = roots
        .iter()
        .map(|root| if root.im.abs() < REAL * root.re.abs() { Complex { im: 0.0, ..*root } } else { *root })
        .map(|root| [libm::log(libm::hypot(root.re, root.im)), libm::atan2(root.im, root.re)])
        .map(|[re, im]| Complex { re: re / interval_s, im: im / interval_s })
        .filter(|own| own.im >= 0.0)
        .collect();
    all.sort_by(|a, b| a.re.total_cmp(&b.re));
    all
}

/// A root whose imaginary part is below this part of the real one is real: rounding leaves some 1e-12.
const REAL: f64 = 1e-9;

fn product(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let size = a.len();
    (0..size).map(|i| (0..size).map(|j| (0..size).map(|k| a[i][k] * b[k][j]).sum()).collect()).collect()
}

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
        assert!((found[0].re + 2.0).abs() < 1e-9 && found[0].im == 0.0, "{found:?}");
        assert!((found[1].re + 0.5).abs() < 1e-9 && (found[1].im - 3.0).abs() < 1e-9, "{found:?}");
    }
}
