//! The path of compliance: where many contacts of a heap are about to slip, part and stick.
//!
//! Every contact yields by a compliance `c` about reactions `r_0`, so that its reaction is an explicit function of the
//! velocities, `r(v)` (`compliant_law.rs`). What is left is one equation of the bodies,
//!
//! `v = v_free + M^-1 H^T r(v)`,
//!
//! which Newton's method solves with damped steps: with a large `c` the laws are soft and it comes to the end from
//! anywhere. Then `c` is made smaller, by as much as the last steps allow, with the tangent of the path as the next
//! start. Contacts change what they do one after the other along the path, where Newton's method for rigid contacts
//! would have to guess all at once. The residual of an answer at `c` is about `c |r - r_0|`: it is that of contacts
//! which are rigid but for their compliance, and forces of redundant contacts are unique on the way.
//!
//! Symbols and units: `c` in velocities per load of each contact (no unit), `v` (m/s kg^1/2), `r`, `r_0` (N s).
//! Sources: Alart and Curnier 1991; Rockafellar 1976 (with the last answer as `r_0` its error is left out of the next
//! one); Allgower and Georg 1990 (steps along a path). Assumption: none on ranks. Failure: where the path turns back at
//! a `c` (rows that contradict each other let corners slip at a load that they no longer bear) steps become short and
//! the run ends; a new one from its answer takes another path. The best point is kept, and its residual told.

use crate::friction::coulomb_cone::{BlockRows, filled_up};
use crate::sparse::block6::{Vector6, WIDTH, add_scaled, dot6};
use crate::sparse::compliant_law::Spring;
use crate::sparse::elimination::Elimination;
use crate::sparse::iterate::{Iterate, Measure};
use crate::sparse::problem::BodyProblem;
use crate::sparse::system::{BodySystem, RowMatrix, Sides};
use crate::tolerances::DECREASE;
use crate::tolerances::MOST_SHORT_STEPS;

/// The least compliance (no unit, 1e-8 to 1e-6): rounding of velocities, divided by it, is seen in the reactions.
const LEAST_COMPLIANCE: f64 = 1e-7;

/// What a compliance is multiplied by where Newton's method did not come to the end at the first one (no unit).
const SOFTER: f64 = 10.0;

/// The step of the path at first, its shortest one, and the one beyond which the path turns back: the next compliance
/// over the last one (no units).
const FIRST_SHRINKAGE: f64 = 0.3;
const LONGEST_SHRINKAGE: f64 = 0.01;
const TURNING_BACK: f64 = 0.85;

/// So few of Newton's steps at one compliance make the next step of the path longer, and so many shorter.
const FEW_STEPS: usize = 1;
const MANY_STEPS: usize = 4;

/// Failures in a row that end a run.
const MOST_FAILURES: usize = 6;

/// Newton's steps at one compliance, and how many of them may be too short.
const MOST_STEPS: usize = 8;
/// A step that is halved to less than this is too short (no unit).
const SHORT_STEP: f64 = 0.02;

/// What Newton's method leaves of the bodies' equation, relative to what contacts give: this share of the compliance,
/// within these bounds (no units). It need not be as exact as the next compliance asks for, and not beyond rounding.
const SHARE_OF_COMPLIANCE: f64 = 0.3;
const LARGEST_MISSING: f64 = 1e-2;

/// Times that rounding of the factors is solved for again.
const PATH_REFINEMENTS: usize = 1;

/// Limits of one run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PathLimits {
    /// The first compliance (no unit).
    pub(crate) first: f64,
    /// Most factorisations.
    pub(crate) most: usize,
    /// The residual to reach.
    pub(crate) tolerance: f64,
}

/// Velocities, what contacts do there, and what that leaves.
#[derive(Debug, Clone, Default)]
struct Point {
    v: Vec<Vector6>,
    /// `r(v)`.
    reactions: Vec<f64>,
    /// `H v + b`.
    rates: Vec<f64>,
    /// `-dr/du` of each block.
    stiffness: Vec<RowMatrix>,
    /// `v_free + M^-1 H^T r(v) - v`, scaled.
    rest: Vec<Vector6>,
    /// Its length.
    missing: f64,
    /// The length of `M^-1 H^T r(v)`, scaled.
    given: f64,
}

/// What became of Newton's method at one compliance.
#[derive(Debug, Clone, Copy)]
enum Came {
    /// To the end, after so many steps.
    ToTheEnd(usize),
    Nowhere,
}

/// The method for one problem and one `r_0`.
#[derive(Debug)]
pub(crate) struct CompliancePath<'a> {
    problem: &'a BodyProblem,
    elimination: &'a Elimination,
    measure: &'a Measure,
    /// Velocities per load of each block (1/kg).
    scales: Vec<f64>,
    /// `r_0`.
    reference: Vec<f64>,
    at: Point,
    trial: Point,
    /// Zero for every row: velocities without what rows yield.
    unloaded: Vec<f64>,
    dv: Vec<Vector6>,
    dr: Vec<f64>,
}

impl<'a> CompliancePath<'a> {
    /// About the reactions `reference`; `loads` are reactions of about the size of the answer.
    pub(crate) fn new(
        problem: &'a BodyProblem,
        elimination: &'a Elimination,
        measure: &'a Measure,
        loads: &[f64],
        reference: Vec<f64>,
    ) -> Self {
        Self {
            problem,
            elimination,
            measure,
            scales: measure.scales(problem, loads),
            reference,
            at: Point::default(),
            trial: Point::default(),
            unloaded: vec![0.0; problem.rows()],
            dv: Vec::new(),
            dr: Vec::new(),
        }
    }

    /// Follows the path; `best` is then the best answer of all.
    pub(crate) fn run(&mut self, system: &mut BodySystem, best: &mut Iterate, limits: PathLimits) {
        let last = system.factorisations + limits.most;
        let (mut c, mut shrinkage, mut failures) = (limits.first, FIRST_SHRINKAGE, 0);
        let mut iterate = Iterate::default();
        // The last point of the path, and its compliance.
        let mut reached: Option<(Point, f64)> = None;
        self.problem.scaled_velocities(&self.reference, &mut self.at.v);
        while system.factorisations < last && failures < MOST_FAILURES {
            let came = self.newton(system, c, MOST_STEPS.min(last - system.factorisations));
            iterate.take(self.problem, self.measure, &self.at.reactions);
            best.keep(&iterate);
            if best.rank <= limits.tolerance {
                return;
            }
            match (came, &reached) {
                (Came::ToTheEnd(steps), _) => {
                    failures = 0;
                    if reached.is_some() {
                        shrinkage = next_shrinkage(shrinkage, steps);
                    }
                    if c <= LEAST_COMPLIANCE {
                        return;
                    }
                    reached = Some((self.at.clone(), c));
                }
                (Came::Nowhere, None) => {
                    failures += 1;
                    c *= SOFTER;
                    self.problem.scaled_velocities(&self.reference, &mut self.at.v);
                    continue;
                }
                (Came::Nowhere, Some((point, _))) => {
                    failures += 1;
                    shrinkage = shrinkage.sqrt();
                    if shrinkage > TURNING_BACK || system.factorisations >= last {
                        return;
                    }
                    self.at.clone_from(point);
                    system.factor(self.problem, self.elimination, &self.at.stiffness);
                }
            }
            let Some((_, from)) = &reached else { return };
            let next = (from * shrinkage).max(LEAST_COMPLIANCE);
            self.predict(system, next / from - 1.0);
            c = next;
        }
    }

    /// Newton's method at one compliance.
    fn newton(&mut self, system: &mut BodySystem, c: f64, most: usize) -> Came {
        let mut at = std::mem::take(&mut self.at);
        self.evaluate(c, &mut at);
        let wanted = (SHARE_OF_COMPLIANCE * c).clamp(LEAST_COMPLIANCE, LARGEST_MISSING);
        let (mut steps, mut short) = (0, 0);
        let came = loop {
            // One step at the least: its factors are those of the tangent.
            if steps > 0 && at.missing <= wanted * at.given {
                break Came::ToTheEnd(steps);
            }
            if steps >= most || short >= MOST_SHORT_STEPS || !at.missing.is_finite() {
                break Came::Nowhere;
            }
            system.factor(self.problem, self.elimination, &at.stiffness);
            self.dr.clear();
            self.dr.resize(self.problem.rows(), 0.0);
            let sides = Sides { bodies: &at.rest, rows: &mut self.dr };
            system.solve(self.problem, self.elimination, sides, PATH_REFINEMENTS, &mut self.dv);
            steps += 1;
            if self.search(c, &mut at) < SHORT_STEP {
                short += 1;
            }
        };
        self.at = at;
        came
    }

    /// Halves the step until less is missing; returns its length.
    fn search(&mut self, c: f64, at: &mut Point) -> f64 {
        let mut trial = std::mem::take(&mut self.trial);
        let mut length = 1.0;
        loop {
            trial.v.clone_from(&at.v);
            for (v, dv) in trial.v.iter_mut().zip(&self.dv) {
                add_scaled(length, dv, v);
            }
            self.evaluate(c, &mut trial);
            if trial.missing < (1.0 - DECREASE * length) * at.missing || length < SHORT_STEP {
                break;
            }
            length *= 0.5;
        }
        std::mem::swap(at, &mut trial);
        self.trial = trial;
        length
    }

    /// Goes along the tangent of the path to a compliance that is so much larger (no unit), by the last factors.
    fn predict(&mut self, system: &mut BodySystem, larger: f64) {
        self.dr.clear();
        for (block, stiffness) in self.problem.blocks.iter().zip(&self.at.stiffness) {
            let u: BlockRows = filled_up(&self.at.rates[block.rows.clone()]);
            let change = |line: &BlockRows| line.iter().zip(u).map(|(k, u)| k * u).sum::<f64>() * larger;
            self.dr.extend(stiffness.iter().take(block.rows.len()).map(change));
        }
        let bodies = vec![[0.0; WIDTH]; self.problem.movable_bodies()];
        let sides = Sides { bodies: &bodies, rows: &mut self.dr };
        system.solve(self.problem, self.elimination, sides, PATH_REFINEMENTS, &mut self.dv);
        for (v, dv) in self.at.v.iter_mut().zip(&self.dv) {
            add_scaled(1.0, dv, v);
        }
    }

    /// What contacts do at the velocities of a point.
    fn evaluate(&self, c: f64, at: &mut Point) {
        let problem = self.problem;
        problem.rates(&at.v, &self.unloaded, &mut at.rates);
        at.stiffness.clear();
        at.reactions.clear();
        for (block, scale) in problem.blocks.iter().zip(&self.scales) {
            let rows = block.rows.clone();
            let spring = Spring {
                compliance: c * scale,
                own: filled_up(&problem.compliance[rows.clone()]),
                reactions: filled_up(&self.reference[rows.clone()]),
            };
            let yielded = spring.yielded(block.law, &filled_up(&at.rates[rows.clone()]));
            at.reactions.extend_from_slice(&yielded.reactions[..rows.len()]);
            at.stiffness.push(yielded.stiffness);
        }
        problem.scaled_velocities(&at.reactions, &mut at.rest);
        let (mut missing, mut given) = (0.0, 0.0);
        for ((rest, free), v) in at.rest.iter_mut().zip(&problem.free).zip(&at.v) {
            let mut by_contacts = *rest;
            add_scaled(-1.0, free, &mut by_contacts);
            given += dot6(&by_contacts, &by_contacts);
            add_scaled(-1.0, v, rest);
            missing += dot6(rest, rest);
        }
        (at.missing, at.given) = (missing.sqrt(), given.sqrt());
    }
}

/// The next step of the path, after one that took so many of Newton's steps.
fn next_shrinkage(shrinkage: f64, steps: usize) -> f64 {
    if steps <= FEW_STEPS {
        (shrinkage * shrinkage.sqrt()).max(LONGEST_SHRINKAGE)
    } else if steps >= MANY_STEPS {
        shrinkage.sqrt()
    } else {
        shrinkage
    }
}
