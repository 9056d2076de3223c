//! The guesses of the thesis's section 3.4: which contacts vanish is tried, one set after the other, until forces fit.
//!
//! For a set `V` of contacts that vanish and the others, `S`: `f_V = 0`, `G_SS f_S = -b_S` with `f_S >= 0`, and
//! `w_V = G_VS f_S + b_V >= 0` (N, 1/kg, m/s^2). A set that fits gives an exact answer, whose motion is the only one
//! (Gauss's principle). The sets are tried by their size: none vanishes first, then each contact alone, each pair, and
//! so on; within a size in the order of the rows. There are `2^n` for `n` contacts, so that more than [`MOST_GUESSED`]
//! are refused.
//!
//! Sets `S` with rows that depend on each other are passed over: where they have forces, a smaller set of independent
//! rows among them has some too (Caratheodory), with forces of zero at the others, which do not vanish for all that. So
//! the answer has no more carrying contacts than it needs, and forces are not those of least norm; which contacts
//! vanish is read from `w > 0`.
//!
//! Fails where contacts contradict each other to rounding: no set fits then, and the status says so.
//!
//! Source: thesis, section 3.4, Finding the Vanishing Contact Points.

#[cfg(feature = "census")]
use crate::census::{self, Chain, Size};
use crate::certificate::{nan_max, power_bound, row_accelerations, row_residual, row_scales};
use crate::delassus::Delassus;
use crate::error::{ResponseError, check_finite, check_length};
use crate::report::{Method, SolverReport, SolverStatus};
use crate::settings::SolverSettings;
use crate::tolerances::DEPENDENT;
use crate::tolerances::ZERO_CUT;

/// Most contacts whose sets are tried (16 to 24): a million sets take about a second.
pub const MOST_GUESSED: usize = 20;

/// Rounding of forces and accelerations of a set that fits, relative to their terms (no unit).
const FITS: f64 = 1e-11;

/// Forces found by guessing.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct GuessedForces {
    /// `f`, not negative, N; zero where no set fits.
    pub forces: Vec<f64>,
    /// `w = G f + b`, m/s^2.
    pub residual_accelerations: Vec<f64>,
    /// The contacts that vanish: those that accelerate away, ascending.
    pub vanishing: Vec<usize>,
    /// How many sets were tried, the one that fits included.
    pub guesses: u64,
    /// The certificate.
    pub report: SolverReport,
}

/// Contact forces by guesses of which contacts vanish.
///
/// # Errors
/// When there are more than [`MOST_GUESSED`] contacts, lengths differ, a number is not finite, or a setting is out of
/// range.
#[cfg_attr(feature = "census", track_caller)]
pub fn guesses(delassus: &Delassus, b: &[f64], settings: &SolverSettings) -> Result<GuessedForces, ResponseError> {
    let found = by_guesses(delassus, b, settings)?;
    #[cfg(feature = "census")]
    {
        let size = Size { rows: b.len(), ..Size::default() };
        census::note_single(Chain::Thesis, size, "guesses", found.report.status, found.report.residual);
    }
    Ok(found)
}

fn by_guesses(delassus: &Delassus, b: &[f64], settings: &SolverSettings) -> Result<GuessedForces, ResponseError> {
    check_length("constant terms", delassus.len(), b.len())?;
    check_finite("constant terms", b)?;
    delassus.check_finite()?;
    settings.check()?;
    let count = b.len();
    if count > MOST_GUESSED {
        return Err(ResponseError::TooManyGuesses { contacts: count, limit: MOST_GUESSED });
    }
    let mut tried = 0;
    for vanishing in 0..=count {
        let mut set = (1_u64 << vanishing) - 1;
        while set < 1_u64 << count {
            tried += 1;
            let carrying: Vec<usize> = (0..count).filter(|row| set >> row & 1 == 0).collect();
            if let Some(forces) = forces_of(delassus, b, &carrying) {
                return Ok(answer((delassus, b), forces, tried, settings));
            }
            if set == 0 {
                break;
            }
            set = next_of_size(set);
        }
    }
    let mut nothing = answer((delassus, b), vec![0.0; count], tried, settings);
    nothing.report.status = SolverStatus::Infeasible;
    Ok(nothing)
}

/// The next larger number with as many ones (Gosper).
const fn next_of_size(set: u64) -> u64 {
    let lowest = set & set.wrapping_neg();
    let ripple = set + lowest;
    ripple | (((set ^ ripple) >> 2) / lowest)
}

/// The forces where these rows alone carry some, if they fit.
fn forces_of(delassus: &Delassus, b: &[f64], carrying: &[usize]) -> Option<Vec<f64>> {
    let factor = Factor::of(delassus, carrying)?;
    let mut forces = vec![0.0; b.len()];
    let (mut w, mut scales) = (b.to_vec(), vec![0.0; b.len()]);
    // Once more for the rounding of the factor.
    for _ in 0..2 {
        let left: Vec<f64> = carrying.iter().map(|&row| -w[row]).collect();
        for (&row, correction) in carrying.iter().zip(factor.solve(left)) {
            forces[row] += correction;
        }
        row_accelerations(delassus.entries(), b, &forces, &mut w);
    }
    let largest = forces.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
    if forces.iter().any(|force| force.is_nan() || *force < -FITS * largest) {
        return None;
    }
    for force in &mut forces {
        *force = force.max(0.0);
    }
    row_accelerations(delassus.entries(), b, &forces, &mut w);
    row_scales(delassus.entries(), b, &forces, &mut scales);
    w.iter().zip(&scales).all(|(w, scale)| *w >= -FITS * scale).then_some(forces)
}

/// A Cholesky factor of some rows, its lines one after the other.
struct Factor(Vec<Vec<f64>>);

impl Factor {
    /// None where a row depends on those before it.
    fn of(delassus: &Delassus, rows: &[usize]) -> Option<Self> {
        let mut lines: Vec<Vec<f64>> = Vec::with_capacity(rows.len());
        for (i, &row) in rows.iter().enumerate() {
            let mut line: Vec<f64> = Vec::with_capacity(i + 1);
            for (j, &column) in rows[..i].iter().enumerate() {
                let known: f64 = line.iter().zip(&lines[j]).map(|(a, b)| a * b).sum();
                line.push((delassus.get(row, column) - known) / lines[j][j]);
            }
            let own = delassus.get(row, row);
            let left = own - line.iter().map(|entry| entry * entry).sum::<f64>();
            if left.is_nan() || left <= DEPENDENT * own {
                return None;
            }
            line.push(left.sqrt());
            lines.push(line);
        }
        Some(Self(lines))
    }

    fn solve(&self, mut x: Vec<f64>) -> Vec<f64> {
        for i in 0..x.len() {
            let known: f64 = self.0[i][..i].iter().zip(&x).map(|(entry, x)| entry * x).sum();
            x[i] = (x[i] - known) / self.0[i][i];
        }
        for i in (0..x.len()).rev() {
            let known: f64 = (i + 1..x.len()).map(|j| self.0[j][i] * x[j]).sum();
            x[i] = (x[i] - known) / self.0[i][i];
        }
        x
    }
}

fn answer(
    (delassus, b): (&Delassus, &[f64]),
    forces: Vec<f64>,
    guesses: u64,
    settings: &SolverSettings,
) -> GuessedForces {
    let (mut w, mut scales) = (vec![0.0; b.len()], vec![0.0; b.len()]);
    row_accelerations(delassus.entries(), b, &forces, &mut w);
    row_scales(delassus.entries(), b, &forces, &mut scales);
    let residual = (0..w.len())
        .map(|row| row_residual(delassus.get(row, row), forces[row], w[row], scales[row]))
        .fold(0.0, nan_max);
    let status = if residual <= settings.acceptance { SolverStatus::Solved } else { SolverStatus::Inaccurate };
    let report = SolverReport {
        status,
        method: Method::Guesses,
        iterations: usize::try_from(guesses).unwrap_or(usize::MAX),
        residual,
        bound: power_bound(&forces, &w),
        rank: forces.iter().filter(|force| **force > 0.0).count(),
        ..SolverReport::default()
    };
    let vanishing = (0..w.len()).filter(|&row| w[row] > ZERO_CUT * scales[row]).collect();
    GuessedForces { forces, residual_accelerations: w, vanishing, guesses, report }
}
