//! Smoothing Newton: where contacts at the limit of sticking keep Newton's method from its end, and the path of
//! compliance turns back.
//!
//! Zeros of the smoothed functions are on the path of the interior point, but points on the way need not be inside
//! the cones: nothing blocks a step where slips turn. Steps are damped, as much as the last ones needed; the
//! smoothing is lessened when it is what is left of the natural map. Sources: Chen, Qi and Sun 1998; Fukushima, Luo
//! and Tseng 2002. Failure: a local minimum of the function's square ends progress; the best point of all is kept,
//! and its residual told.

use crate::dense::kernels::largest;
use crate::friction::coulomb_cone::filled_up;
use crate::sparse::block6::{Vector6, WIDTH};
use crate::sparse::cone_form::ConeForm;
use crate::sparse::elimination::Elimination;
use crate::sparse::iterate::{Iterate, Measure};
use crate::sparse::problem::BodyProblem;
use crate::sparse::smoothed_cone::{ConeStep, SmoothedCone};
use crate::sparse::system::{BodySystem, RowMatrix, Sides, held_stiffness};
use crate::tolerances::DECREASE;
use crate::tolerances::LEAST_DAMPING;

/// Bounds of the scale of velocities to reactions, in that by its load (no unit): a contact counts as sliding by a
/// slip that is small beside all velocities, and yet above rounding.
const SMALLEST_SCALE: f64 = 1e-2;

/// Times that rounding of the factors is solved for again.
const SMOOTHING_REFINEMENTS: usize = 1;

/// Halvings of a step.
const SMOOTHING_HALVINGS: usize = 2;

/// Damping at first, and the least that a failure leads to (shares of the scale, no unit).
const FIRST_DAMPING: f64 = 1e-2;
const LEAST_AFTER_FAILURE: f64 = 1e-4;

/// What the damping is multiplied by after a step that failed, and after one that was cut short (no units).
const MORE_DAMPING: f64 = 8.0;
const SOME_MORE_DAMPING: f64 = 2.0;

/// What it is multiplied by after a whole step: after one that left this share of the square, and after any other (no
/// units).
const HELPS: std::ops::Range<f64> = 0.05..0.5;
const LITTLE_LESS_DAMPING: f64 = 0.5;
const LESS_DAMPING: f64 = 0.1;

/// Steps at one smoothing in which the square must halve, or another path is taken, with so much more smoothing (no
/// unit).
const STALLED_SMOOTHING_STEPS: usize = 4;
const MORE_SMOOTHING: f64 = 10.0;

/// The function's square is less than this share of the natural map's: smoothing is what is left (no unit).
const MOSTLY_SMOOTHING: f64 = 0.1;

/// What the smoothing is lessened to by a whole step, and by any other (no unit).
const LESS_SMOOTHING: f64 = 0.3;
const LITTLE_LESS_SMOOTHING: f64 = 0.5;

/// The method for one problem.
#[derive(Debug)]
pub(crate) struct Smoothing<'a> {
    problem: &'a BodyProblem,
    elimination: &'a Elimination,
    measure: &'a Measure,
    /// One for each block; none for rows that are held.
    cones: Vec<Option<SmoothedCone>>,
    /// `x.y` of each block when the gap is 1 (J).
    weights: Vec<f64>,
    /// Velocities per load of each block (1/kg).
    scales: Vec<f64>,
    /// Of the path: `x.y` of all blocks over their weights.
    gap: f64,
    damping: f64,
    progress: Progress,
    /// Where the method is; the best answer may be another.
    current: Iterate,
    stiffness: Vec<RowMatrix>,
    dr: Vec<f64>,
    dv: Vec<Vector6>,
}

/// Where the interior point has ended.
#[derive(Debug)]
pub(crate) struct InteriorEnd {
    /// `y_0 / x_0` of each block (1/kg).
    pub(crate) ratios: Vec<f64>,
    /// `x.y` of each block when the gap is 1 (J).
    pub(crate) weights: Vec<f64>,
    pub(crate) gap: f64,
}

impl<'a> Smoothing<'a> {
    /// From `start`, where the interior point has ended; `loads` are reactions of about the size of the answer.
    pub(crate) fn new(
        problem: &'a BodyProblem,
        elimination: &'a Elimination,
        measure: &'a Measure,
        loads: &[f64],
        end: InteriorEnd,
        start: Iterate,
    ) -> Self {
        let scales = measure.scales(problem, loads);
        let cone = |((block, scale), ratio): ((_, &f64), &f64)| {
            let scale = ratio.clamp(SMALLEST_SCALE * scale, *scale);
            Some(SmoothedCone { form: ConeForm::of(problem, block)?, scale, smoothing: 0.0 })
        };
        Self {
            problem,
            elimination,
            measure,
            cones: problem.blocks.iter().zip(&scales).zip(&end.ratios).map(cone).collect(),
            weights: end.weights,
            scales,
            gap: end.gap,
            damping: FIRST_DAMPING,
            progress: Progress::default(),
            current: start,
            stiffness: Vec::new(),
            dr: Vec::new(),
            dv: Vec::new(),
        }
    }

    /// Goes on; `best` is then the best of all.
    pub(crate) fn run(&mut self, system: &mut BodySystem, best: &mut Iterate, limits: SmoothingLimits) {
        let mut trial = Iterate::default();
        for _ in 0..limits.most {
            if best.rank <= limits.tolerance {
                return;
            }
            self.smooth(self.gap);
            let square = self.square(&self.current);
            if self.progress.is_stalled(self.gap, square) {
                self.take_another_path();
                continue;
            }
            self.step(system);
            if !largest(&self.dr).is_finite() {
                return;
            }
            let (length, next) = self.search(square, &mut trial);
            best.keep(&trial);
            // Written so that NaN is refused.
            let is_better = next < square;
            if !is_better {
                self.damping = (MORE_DAMPING * self.damping).clamp(LEAST_AFTER_FAILURE, 1.0);
                continue;
            }
            self.smooth(0.0);
            let plain = self.square(&trial);
            if next < MOSTLY_SMOOTHING * plain {
                self.gap *= if length == 1.0 { LESS_SMOOTHING } else { LITTLE_LESS_SMOOTHING };
            }
            self.damping = next_damping(self.damping, length, next / square);
            std::mem::swap(&mut self.current, &mut trial);
        }
    }

    /// Halves the step until the square decreases; returns its length and the square.
    fn search(&self, square: f64, trial: &mut Iterate) -> (f64, f64) {
        let mut length = 1.0;
        let mut wanted = Vec::with_capacity(self.dr.len());
        for halving in 0.. {
            wanted.clear();
            wanted.extend(self.current.reactions.iter().zip(&self.dr).map(|(r, d)| r + length * d));
            trial.take(self.problem, self.measure, &wanted);
            let next = self.square(trial);
            if next <= (1.0 - DECREASE * length) * square || halving == SMOOTHING_HALVINGS {
                return (length, next);
            }
            length *= 0.5;
        }
        (length, f64::INFINITY)
    }

    /// Goes back on a path on which every contact has the scale of its reaction and velocity by now: at a local
    /// minimum of the square the old one may have turned back.
    fn take_another_path(&mut self) {
        self.gap *= MORE_SMOOTHING;
        self.damping = FIRST_DAMPING;
        let scales = self.measure.scales(self.problem, &self.current.reactions);
        let parts = self.problem.blocks.iter().zip(&mut self.cones).zip(&mut self.weights);
        for (((block, cone), weight), by_load) in parts.zip(scales) {
            let Some(cone) = cone else { continue };
            let load = self.current.reactions[block.rows.start].abs();
            let speed = largest(&self.current.rates[block.rows.clone()]);
            let own = if load * by_load > speed { speed / load } else { by_load };
            cone.scale = own.max(SMALLEST_SCALE * by_load);
            *weight = self.measure.speed * self.measure.speed / by_load;
        }
    }

    fn smooth(&mut self, gap: f64) {
        for (cone, weight) in self.cones.iter_mut().zip(&self.weights) {
            if let Some(cone) = cone {
                cone.smoothing = gap * weight / cone.scale;
            }
        }
    }

    fn square(&self, at: &Iterate) -> f64 {
        let mut sum = 0.0;
        for (block, cone) in self.problem.blocks.iter().zip(&self.cones) {
            let rows = block.rows.clone();
            sum += match cone {
                Some(cone) => cone.square(&filled_up(&at.reactions[rows.clone()]), &filled_up(&at.rates[rows])),
                None => at.rates[rows].iter().map(|u| u * u).sum::<f64>(),
            };
        }
        sum
    }

    fn step(&mut self, system: &mut BodySystem) {
        let (at, damping) = (&self.current, self.damping);
        self.stiffness.clear();
        self.dr.clear();
        for ((block, cone), scale) in self.problem.blocks.iter().zip(&self.cones).zip(&self.scales) {
            let rows = block.rows.clone();
            if let Some(cone) = cone {
                let (r, u) = (filled_up(&at.reactions[rows.clone()]), filled_up(&at.rates[rows.clone()]));
                let ConeStep { stiffness, constant } = cone.step(&r, &u, damping);
                self.stiffness.push(stiffness);
                self.dr.extend_from_slice(&constant[..rows.len()]);
            } else {
                let stiffness = held_stiffness(self.problem, block, damping * scale);
                self.dr.extend(rows.enumerate().map(|(k, row)| -stiffness[k][k] * at.rates[row]));
                self.stiffness.push(stiffness);
            }
        }
        system.factor(self.problem, self.elimination, &self.stiffness);
        let bodies = vec![[0.0; WIDTH]; self.problem.movable_bodies()];
        let sides = Sides { bodies: &bodies, rows: &mut self.dr };
        system.solve(self.problem, self.elimination, sides, SMOOTHING_REFINEMENTS, &mut self.dv);
    }
}

/// How far the square has come at one smoothing.
#[derive(Debug, Clone, Copy, Default)]
struct Progress {
    gap: f64,
    square: f64,
    steps: usize,
}

impl Progress {
    /// Takes in the square before a step; whether it has not halved for long.
    fn is_stalled(&mut self, gap: f64, square: f64) -> bool {
        if gap != self.gap || square < 0.5 * self.square {
            *self = Self { gap, square, steps: 0 };
        }
        self.steps += 1;
        self.steps > STALLED_SMOOTHING_STEPS
    }
}

/// Limits of one run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SmoothingLimits {
    /// Most steps.
    pub(crate) most: usize,
    /// The residual to reach.
    pub(crate) tolerance: f64,
}

/// The damping after a step that was taken. One that hardly helped is as far as this damping leads: the next one is
/// bolder.
fn next_damping(damping: f64, length: f64, ratio: f64) -> f64 {
    if length < 1.0 {
        return (SOME_MORE_DAMPING * damping).clamp(LEAST_AFTER_FAILURE, 1.0);
    }
    let factor = if HELPS.contains(&ratio) { LITTLE_LESS_DAMPING } else { LESS_DAMPING };
    (factor * damping).max(LEAST_DAMPING)
}
