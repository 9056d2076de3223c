//! Interior point, primal and dual, for contacts with friction: the cold start.
//!
//! The method follows `x o y = gap weight e` to `gap = 0` by Newton steps of the equations of bodies, of `y` and of
//! that product, scaled after Nesterov and Todd, predictor first (Mehrotra). The slip `mu |u_t|` is part of the
//! Newton step: taken as known, it would have to be found by repetition. On the path a contact rubs with `mu u_t /
//! (|u_t| + u_n/mu)`, which is smooth. It starts from the loads that would hold all contacts, one factorisation: with
//! them mass ratios of 1e6 take no more steps than equal masses, since each contact has its own share of the gap.
//!
//! Once a step was short, only a part of the slip's change is in it.
//!
//! Sources: Acary, Armand, Nguyen and Shpakovych 2023; Mehrotra 1992. Assumption: none on ranks, redundant contacts
//! are welcome. Failure: where the path turns back (many contacts slide into each other) steps become short and the
//! method ends as jammed; where contacts are at the limit of sticking the residual goes with the root of the gap.

use crate::friction::coulomb_cone::{BlockRows, filled_up};
use crate::law::MOST_ROWS;
use crate::sparse::block6::{Vector6, add_scaled};
use crate::sparse::cone_form::ConeForm;
use crate::sparse::elimination::Elimination;
use crate::sparse::interior_cone::InteriorCone;
use crate::sparse::iterate::{Iterate, Measure};
use crate::sparse::problem::BodyProblem;
use crate::sparse::system::{BodySystem, RowMatrix, Sides, held_stiffness};
use crate::tolerances::LEAST_DAMPING;
use crate::tolerances::MOST_SHORT_STEPS;

/// How far of the way to the boundary a step goes (no unit, 0.9 to 0.999).
const TO_THE_BOUNDARY: f64 = 0.99;

/// The least of it, in inverse masses (no unit, 1e-13 to 1e-12): under heavy loads rounding of light bodies is seen.
const LEAST_SHIFT: f64 = 1e-13;

/// Times that the step is solved for again.
const INTERIOR_REFINEMENTS: usize = 2;

/// Steps shorter than this lead nowhere (no unit, 0.1 to 0.3): the path turns.
const JAMMED_STEP: f64 = 0.2;

/// How much of the change of slips is part of a step once one was so short (no unit, 0.8 to 0.95). With all of it the
/// path turns back where many contacts slide into each other; with none the slips are found by repetition.
const SHARE_OF_SLIP: f64 = 0.9;

/// The loads are still found while the gap is above this share of that at the start (no unit), and short steps say
/// little.
const LOADS_FOUND: f64 = 1e-2;

/// Below this balanced residual a whole step that leaves this share of it shows contacts at the limit of sticking,
/// where the residual goes with the root of the gap (no units).
const ROUGHLY: f64 = 1e-4;
const SLOWLY: f64 = 0.3;
const NEARLY_WHOLE: f64 = 0.9;

/// Balanced residual at which Newton's method knows what sticks, slides and parts (no unit, 1e-6 to 1e-4). Later
/// steps of the interior point cost as much and gain less.
const NEAR: f64 = 1e-6;

/// The method for one problem.
#[derive(Debug)]
pub(crate) struct InteriorPoint<'a> {
    problem: &'a BodyProblem,
    elimination: &'a Elimination,
    measure: &'a Measure,
    /// One for each block; none for rows that are held.
    cones: Vec<Option<InteriorCone>>,
    /// Velocities per load, of each block (1/kg).
    scales: Vec<f64>,
    v: Vec<Vector6>,
    /// Reactions; those of rows that are held are unknowns, the others follow from the cones.
    r: Vec<f64>,
    u: Vec<f64>,
    dv: Vec<Vector6>,
    /// Of the change of slips that is part of a step.
    share: f64,
    dr: Vec<f64>,
    stiffness: Vec<RowMatrix>,
    /// What the bodies' equation is left with.
    rest: Vec<Vector6>,
}

impl<'a> InteriorPoint<'a> {
    /// At the start. `loads` are reactions of about the size of the answer.
    pub(crate) fn new(
        problem: &'a BodyProblem,
        elimination: &'a Elimination,
        measure: &'a Measure,
        loads: &[f64],
    ) -> Self {
        let scales = measure.scales(problem, loads);
        let cone = |(block, scale)| {
            Some(InteriorCone::new(ConeForm::of(problem, block)?, measure.speed / scale, measure.speed))
        };
        Self {
            problem,
            elimination,
            measure,
            cones: problem.blocks.iter().zip(&scales).map(cone).collect(),
            scales,
            v: problem.free.clone(),
            r: vec![0.0; problem.rows()],
            u: Vec::new(),
            dv: Vec::new(),
            share: 1.0,
            dr: Vec::new(),
            stiffness: Vec::new(),
            rest: Vec::new(),
        }
    }

    /// Steps until the answer is near, steps become short, or `most` are done. `best` is the best answer of all.
    pub(crate) fn run(&mut self, system: &mut BodySystem, best: &mut Iterate, most: usize) {
        let mut iterate = Iterate::default();
        let (mut short, mut last) = (0, f64::INFINITY);
        for _ in 0..most {
            let length = self.step(system);
            self.write_reactions();
            iterate.take(self.problem, self.measure, &self.r);
            best.keep(&iterate);
            let balanced = self.measure.balanced(self.problem, &iterate);
            short = if length < JAMMED_STEP { short + 1 } else { 0 };
            if short > 0 && self.share > SHARE_OF_SLIP {
                (short, self.share) = (0, SHARE_OF_SLIP);
            }
            let is_slow = balanced < ROUGHLY && length > NEARLY_WHOLE && balanced > SLOWLY * last;
            last = balanced;
            // Written so that NaN ends it.
            let is_jammed = short >= MOST_SHORT_STEPS && self.gap() < LOADS_FOUND;
            let goes_on = !is_jammed && balanced > NEAR && !is_slow;
            if !goes_on {
                return;
            }
        }
    }

    /// The mean gap, of that at the start.
    pub(crate) fn gap(&self) -> f64 {
        let (sum, count) = self.sum(InteriorCone::gap);
        sum / count.max(1.0)
    }

    /// `x.y` of each block at the start (J).
    pub(crate) fn weights(&self) -> Vec<f64> {
        self.cones.iter().map(|cone| cone.as_ref().map_or(0.0, InteriorCone::weight)).collect()
    }

    /// `y_0 / x_0` of each block (1/kg).
    pub(crate) fn ratios(&self) -> Vec<f64> {
        self.cones
            .iter()
            .zip(&self.scales)
            .map(|(cone, scale)| cone.as_ref().map_or(*scale, InteriorCone::ratio))
            .collect()
    }

    fn sum(&self, of: impl Fn(&InteriorCone) -> f64) -> (f64, f64) {
        self.cones.iter().flatten().fold((0.0, 0.0), |(sum, count), cone| (sum + of(cone), count + 1.0))
    }

    /// Puts the reactions of the cones in their places.
    fn write_reactions(&mut self) {
        for (block, cone) in self.problem.blocks.iter().zip(&self.cones) {
            if let Some(cone) = cone {
                let own = &mut self.r[block.rows.clone()];
                let rows = own.len();
                own.copy_from_slice(&cone.reactions()[..rows]);
            }
        }
    }

    /// One step: one factorisation. Returns its length.
    fn step(&mut self, system: &mut BodySystem) -> f64 {
        self.linearise();
        system.factor(self.problem, self.elimination, &self.stiffness);
        self.aim(InteriorCone::aim_at_zero);
        let mut longest = self.solve(system);
        let (sum, count) = self.sum(InteriorCone::gap);
        if count > 0.0 {
            let after = self.sum(|cone| cone.gap_after(longest.min(1.0))).0;
            let share = (after / sum).clamp(0.0, 1.0);
            // Mehrotra's power of what the predictor leaves.
            let gap = share * share * share * sum / count;
            self.aim(|cone| cone.aim_at(gap));
            longest = self.solve(system);
        }
        let length = (TO_THE_BOUNDARY * longest).min(1.0);
        for (v, dv) in self.v.iter_mut().zip(&self.dv) {
            add_scaled(length, dv, v);
        }
        for (block, cone) in self.problem.blocks.iter().zip(&mut self.cones) {
            match cone {
                Some(cone) => cone.advance(length),
                None => {
                    for row in block.rows.clone() {
                        self.r[row] += length * self.dr[row];
                    }
                }
            }
        }
        length
    }

    fn linearise(&mut self) {
        let problem = self.problem;
        self.write_reactions();
        problem.rates(&self.v, &self.r, &mut self.u);
        problem.scaled_velocities(&self.r, &mut self.rest);
        for (target, v) in self.rest.iter_mut().zip(&self.v) {
            add_scaled(-1.0, v, target);
        }
        self.stiffness.clear();
        let masses = &self.measure.inverse_masses;
        for (((block, cone), scale), mass) in problem.blocks.iter().zip(&mut self.cones).zip(&self.scales).zip(masses) {
            let shift = (LEAST_DAMPING * scale).max(LEAST_SHIFT * mass);
            self.stiffness.push(match cone {
                Some(cone) => cone.linearise(&filled_up(&self.u[block.rows.clone()]), self.share, shift),
                None => held_stiffness(problem, block, shift),
            });
        }
    }

    /// Sets the right sides of the rows.
    fn aim(&mut self, at: impl Fn(&mut InteriorCone) -> BlockRows) {
        self.dr.clear();
        for ((block, cone), stiffness) in self.problem.blocks.iter().zip(&mut self.cones).zip(&self.stiffness) {
            let rows = block.rows.clone();
            match cone {
                Some(cone) => self.dr.extend_from_slice(&at(cone)[..rows.len()]),
                None => self.dr.extend(rows.enumerate().map(|(k, row)| -stiffness[k][k] * self.u[row])),
            }
        }
    }

    /// Solves for the step; returns the longest length that stays inside.
    fn solve(&mut self, system: &mut BodySystem) -> f64 {
        let sides = Sides { bodies: &self.rest, rows: &mut self.dr };
        system.solve(self.problem, self.elimination, sides, INTERIOR_REFINEMENTS, &mut self.dv);
        let mut longest = f64::INFINITY;
        for (block, cone) in self.problem.blocks.iter().zip(&mut self.cones) {
            if let Some(cone) = cone {
                let mut rates = [0.0; MOST_ROWS];
                self.problem.add_rates(block, &self.dv, &mut rates);
                longest = longest.min(cone.take_step(&rates));
            }
        }
        longest
    }
}
