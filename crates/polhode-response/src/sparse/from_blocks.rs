//! The rows of a contact problem, with the laws that are stated for them, as a problem in the velocities of bodies.
//!
//! [`Blocks::solve`] forms the matrix of all rows, [`Blocks::solve_in_bodies`] does not: it takes the same rows, laws,
//! constant terms and scales, and gives its answer in the same places. `v_free` is zero here, and the constant terms
//! of the rows are the bias. Bodies of fewer than six coordinates (three in a plane) have the others beside them, on
//! which nothing acts. Blocks of held rows may hold rows of several joints: each is divided where its bodies change.
//!
//! Assumption: the rows of a block that is not held are of the same two bodies. Failure: more coordinates than six,
//! or an inverse mass that is not positive definite (a body that some force cannot move), is refused.

use crate::error::{ResponseError, check_length};
use crate::friction::FallbackPolicy;
use crate::friction::coulomb_cone::put_parts_into_discs;
use crate::friction::rows_behind::RowsBehind;
use crate::friction::{Blocks, BlocksSolution, FrictionMethod, FrictionReport, FrictionSettings, FrictionSolution};
use crate::law::Law;
use crate::problem::ContactProblem;
use crate::report::{Method, SolverReport};
use crate::sparse::block6::WIDTH;
use crate::sparse::body::masses_of;
use crate::sparse::problem::{BodyProblem, BodyRows};
use crate::sparse::settings::BodySettings;
use crate::sparse::solution::{BodyMethod, BodyReport, BodySolution};
use crate::sparse::solver::BodySolver;
use crate::tolerances::EXACT_ENOUGH;

/// Factorisations for an impact of many contacts, and where other restitutions can be tried in its place.
const FACTORISATIONS_OF_AN_IMPACT: usize = 150;
const FACTORISATIONS_OF_AN_ATTEMPT: usize = 80;

/// The bodies of a block of rows: one or two.
type Members = [Option<usize>; 2];

impl Blocks {
    /// Solves for the reactions of all rows in the velocities of bodies; `start` are those of a similar problem. The
    /// solver keeps its elimination from one problem to the next as long as the same bodies are coupled.
    ///
    /// ```
    /// use polhode_response::sparse::{BodySettings, BodySolver};
    /// use polhode_response::{Blocks, ContactProblem, Law};
    /// // A point of 2 kg on a floor of friction 0.5, pushed down with 3 m/s and along with 4 m/s.
    /// let mut problem = ContactProblem::new(2, vec![0.5, 0.0, 0.0, 0.5])?;
    /// problem.push_row(&[(0, &[0.0, 1.0])])?;
    /// problem.push_held_row(&[(0, &[1.0, 0.0])])?;
    /// let mut blocks = Blocks::default();
    /// blocks.push(Law::Cone { rows: 2, friction: 0.5 }, [0, 1]);
    /// let mut solver = BodySolver::default();
    /// let system = (&mut solver, &BodySettings::default());
    /// let (solved, _) = blocks.solve_in_bodies(&problem, &[-3.0, 4.0], None, system)?;
    /// assert!((solved.velocities[1] - 2.5).abs() < 1e-11);
    /// # Ok::<(), polhode_response::ResponseError>(())
    /// ```
    ///
    /// # Errors
    /// See the top of the module; when a length differs, a row does not exist, or a number is not finite.
    #[cfg_attr(feature = "census", track_caller)]
    pub fn solve_in_bodies(
        &self,
        problem: &ContactProblem,
        constants: &[f64],
        start: Option<&[f64]>,
        (solver, settings): (&mut BodySolver, &BodySettings),
    ) -> Result<(BlocksSolution, BodyReport), ResponseError> {
        check_length("constant terms", problem.len(), constants.len())?;
        let start: Option<Vec<f64>> = start.map(|start| {
            let of_rows = self.rows().iter().map(|&row| start.get(row).copied().unwrap_or(0.0));
            of_rows.zip(self.scales()).map(|(own, scale)| own / scale).collect()
        });
        let constants = self.velocities_in_blocks(constants);
        let solved = self.solved_in_bodies(problem, &constants, start.as_deref(), (solver, settings))?;
        let solution = BlocksSolution {
            reactions: self.reactions_in_rows(&solved.reactions),
            velocities: self.velocities_in_rows(&solved.rates),
            statuses: solved.statuses,
            parts: solved.parts,
            report: report_of(&solved.report),
        };
        Ok((solution, solved.report))
    }

    /// The same with rows, statuses and parts in the order of the blocks.
    #[cfg_attr(feature = "census", track_caller)]
    fn solved_in_bodies(
        &self,
        problem: &ContactProblem,
        constants: &[f64],
        start: Option<&[f64]>,
        (solver, settings): (&mut BodySolver, &BodySettings),
    ) -> Result<BodySolution, ResponseError> {
        let Converted { bodies, given } = self.in_bodies(problem, constants)?;
        let mut solved = solver.solve(&bodies, start, settings)?;
        let mut first = 0;
        for law in self.laws() {
            if law.pushes() {
                put_parts_into_discs(*law, &mut solved.reactions[first..first + law.rows()]);
            }
            first += law.rows();
        }
        solved.statuses = given.iter().map(|&block| solved.statuses[block]).collect();
        solved.parts = given.iter().map(|&block| solved.parts[block]).collect();
        Ok(solved)
    }

    /// The problem in the velocities of bodies, whose rows are in the order of the blocks, as are the constant terms.
    pub(super) fn in_bodies(&self, problem: &ContactProblem, constants: &[f64]) -> Result<Converted, ResponseError> {
        if let Some(&row) = self.rows().iter().find(|&&row| row >= problem.len()) {
            return Err(ResponseError::UnknownRow { row, rows: problem.len() });
        }
        let masses = masses_of(problem)?;
        let mut bodies = BodyProblem::new(&masses, &vec![[0.0; WIDTH]; masses.len()])?;
        let scales: Vec<f64> = self.scales().collect();
        let (mut first, mut given) = (0, Vec::with_capacity(self.len()));
        let mut room = Room::default();
        for law in self.laws() {
            let own = first..first + law.rows();
            first = own.end;
            given.push(bodies.len());
            let (rows, scales) = (&self.rows()[own.clone()], &scales[own.clone()]);
            let constants = &constants[own];
            let mut start = 0;
            while start < rows.len() {
                let members = members_of(problem, rows[start]);
                let (law, end) = if let Law::Hold { .. } = law {
                    let together = rows[start..].iter().take_while(|row| members_of(problem, **row) == members).count();
                    (Law::Hold { rows: together }, start + together)
                } else {
                    (*law, rows.len())
                };
                let (rows, scales, bias) = (&rows[start..end], &scales[start..end], &constants[start..end]);
                room.push(&mut bodies, problem, Part { law, members, rows, scales, bias })?;
                start = end;
            }
        }
        Ok(Converted { bodies, given })
    }
}

/// Solves the cone problem of an impact with these laws, in the velocities of the bodies behind its rows; constant
/// terms and start are in the order of the laws.
///
/// # Errors
/// See the top of the module.
#[cfg_attr(feature = "census", track_caller)]
pub(crate) fn solve_behind(
    (laws, behind): (&[Law], &RowsBehind),
    constants: &[f64],
    start: &[f64],
    (solver, settings): (&mut BodySolver, &FrictionSettings),
) -> Result<FrictionSolution, ResponseError> {
    let mut blocks = Blocks::default();
    let mut first = 0;
    for law in laws {
        let own = first..first + law.rows();
        first = own.end;
        let (rows, scales) = (&behind.rows[own.clone()], &behind.scales[own]);
        blocks.push_scaled(*law, rows.iter().copied(), scales.iter().copied());
    }
    let is_one_of_many = settings.fallback == FallbackPolicy::Refuse;
    let limits = BodySettings {
        tolerance: settings.tolerance,
        acceptance: settings.acceptance.max(EXACT_ENOUGH),
        factorisations: if is_one_of_many { FACTORISATIONS_OF_AN_ATTEMPT } else { FACTORISATIONS_OF_AN_IMPACT },
        ..BodySettings::default()
    };
    let start = Some(start).filter(|start| start.iter().any(|reaction| *reaction != 0.0));
    let solved = blocks.solved_in_bodies(&behind.problem, constants, start, (solver, &limits))?;
    let report = FrictionReport {
        status: solved.report.status,
        method: FrictionMethod::Newton,
        newton_steps: solved.report.factorisations,
        residual: solved.report.residual,
        ..FrictionReport::default()
    };
    Ok(FrictionSolution {
        reactions: solved.reactions,
        velocities: solved.rates,
        statuses: solved.statuses,
        parts: solved.parts,
        squeeze: Vec::new(),
        report,
    })
}

/// A problem in the velocities of bodies.
pub(super) struct Converted {
    pub(super) bodies: BodyProblem,
    /// The first contact or joint that each block was made into.
    given: Vec<usize>,
}

/// Rows of one law and the same bodies.
#[derive(Debug, Clone, Copy)]
struct Part<'a> {
    law: Law,
    members: Members,
    rows: &'a [usize],
    scales: &'a [f64],
    bias: &'a [f64],
}

/// Memory for the rows of one part.
#[derive(Debug, Default)]
struct Room {
    jacobians: [Vec<f64>; 2],
}

impl Room {
    /// Adds the rows of a part.
    fn push(
        &mut self,
        bodies: &mut BodyProblem,
        problem: &ContactProblem,
        part: Part<'_>,
    ) -> Result<(), ResponseError> {
        let count = part.rows.len();
        for jacobian in &mut self.jacobians {
            jacobian.clear();
            jacobian.resize(count * WIDTH, 0.0);
        }
        for (place, (&row, &scale)) in part.rows.iter().zip(part.scales).enumerate() {
            for entry in problem.entries(row) {
                let side = part.members.iter().position(|member| *member == Some(entry.body));
                let Some(jacobian) = side.map(|side| &mut self.jacobians[side]) else {
                    return Err(ResponseError::RowBodies(part.members.len() + 1));
                };
                for (target, value) in jacobian[place * WIDTH..].iter_mut().zip(entry.jacobian) {
                    *target = scale * value;
                }
            }
        }
        let sides = part.members.iter().zip(&self.jacobians);
        let sides: Vec<(usize, &[f64])> = sides.filter_map(|(body, of)| Some(((*body)?, &of[..]))).collect();
        bodies.push(&BodyRows { law: part.law, bodies: &sides, bias: part.bias, compliance: &[] })?;
        Ok(())
    }
}

/// The bodies that a row touches.
fn members_of(problem: &ContactProblem, row: usize) -> Members {
    let mut members = [None; 2];
    for (member, entry) in members.iter_mut().zip(problem.entries(row)) {
        *member = Some(entry.body);
    }
    members
}

fn report_of(report: &BodyReport) -> SolverReport {
    SolverReport {
        status: report.status,
        method: in_general(report.method),
        tried: report.tried.iter().map(in_general).collect(),
        iterations: report.factorisations,
        // What is told is what decides whether the problem is solved.
        residual: report.rank,
        ..SolverReport::default()
    }
}

/// A method in the velocities of bodies in the words of all problems.
const fn in_general(method: BodyMethod) -> Method {
    match method {
        BodyMethod::Start | BodyMethod::Warm => Method::WarmStart,
        BodyMethod::Newton | BodyMethod::LastNewton => Method::ActiveSet,
        BodyMethod::InteriorPoint => Method::InteriorPoint,
        BodyMethod::Smoothing
        | BodyMethod::Compliance
        | BodyMethod::FarCompliance
        | BodyMethod::Sweeps
        | BodyMethod::Lagrangian => Method::ColdStart,
    }
}
