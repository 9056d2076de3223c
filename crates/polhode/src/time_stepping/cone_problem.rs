//! The cone problem of a group of contacts in a time step, and who solves it: with friction always, without from
//! [`LEAST_IN_BODIES`] contacts on.
//!
//! | contacts | unknowns | start |
//! |---|---|---|
//! | fewer than [`LEAST_IN_BODIES`] | reactions: the matrix of all rows is formed | none |
//! | fewer, beside trees of joints | reactions beside the trees: the matrix of those rows | forces of the last step |
//! | as many, or more | velocities of bodies: no matrix of rows | forces of the last step |
//!
//! `polhode_response::friction` solves the first of these, `polhode_response::sparse` the others.
//! Both take the same rows, laws and constant terms. With the velocities of bodies memory and time grow with bodies and
//! contacts, where the matrix of `n` rows takes `n^2` numbers and its factors `n^3` products; for a handful of contacts
//! the matrix is smaller than what it saves. The forces of the last step are part of the state of a run
//! (`last_forces.rs`); the order in which bodies are eliminated is kept while they stay coupled, and follows from
//! them: it changes no bit.
//!
//! Where one does not come to the residual asked for, the other is tried, unless the rows are too many for their
//! matrix, and the better answer is taken. What is left is told.

use super::last_forces::LastForces;
use crate::rows::assembly::Assembly;
use crate::solve::cone_violation::{CONE_LIMIT, ConeViolation};
use crate::solve::jointed::trees_of;
use polhode_response::friction::FrictionSettings;
use polhode_response::sparse::{BodySettings, BodySolver, HeldForest};
use polhode_response::{Blocks, BlocksSolution, Delassus, ResponseError, SolverStatus};
use std::collections::BTreeMap;

/// From so many contacts in a group on the velocities of bodies are solved for (8 to 50).
pub(crate) const LEAST_IN_BODIES: usize = 16;

/// Most rows whose matrix is formed where the velocities of bodies were not solved for exactly enough (200 to 600).
const MOST_ROWS_IN_PLACE: usize = 400;

/// The same in the steps of heaps, which have many such groups (60 to 150).
const MOST_ROWS_IN_HEAPS: usize = 100;

/// Reactions whose violation of Coulomb's law is beyond this part of its limit are solved for to rounding (no unit,
/// 0.01 to 1).
const SHARE_OF_CONE_LIMIT: f64 = 0.1;

/// Most sweeps of block Gauss-Seidel after all other methods of the solver have failed. The error that remains is part
/// of the error estimate of a stretch of crowded events.
const LAST_SWEEPS: u32 = 100;

/// The largest residual of a step's problem with which no other way is tried (no unit, 1e-9 to 1e-7): velocities are
/// then wrong by at most about this fraction of the speed that gravity gives in a step.
pub(super) const EXACT_ENOUGH: f64 = 1e-8;

/// As exactly as rounding allows where that is found soon, else as exactly as is accepted.
const SETTINGS_IN_BODIES: BodySettings = BodySettings {
    tolerance: 1e-12,
    acceptance: EXACT_ENOUGH,
    factorisations: 150,
    warm_steps: 8,
    rounds_of_sweeps: 0,
};

/// The solvers of the groups of a run, and the forces that they start from.
#[derive(Debug, Default)]
pub(super) struct ConeSolvers {
    /// By the first body of the group.
    solvers: BTreeMap<usize, BodySolver>,
    pub(super) last: LastForces,
    /// Rounds of sweeps of each problem.
    rounds_of_sweeps: usize,
}

impl Clone for ConeSolvers {
    /// The state without the memory of the solvers, which changes no answer.
    fn clone(&self) -> Self {
        Self { solvers: BTreeMap::new(), last: self.last.clone(), rounds_of_sweeps: self.rounds_of_sweeps }
    }
}

impl ConeSolvers {
    /// Those that make so many rounds of sweeps.
    pub(super) fn with_sweeps(rounds_of_sweeps: usize) -> Self {
        Self { rounds_of_sweeps, ..Self::default() }
    }

    /// Forgets the answers that problems would start from.
    pub(super) fn forget(&mut self) {
        self.last = LastForces::default();
        self.solvers.clear();
    }

    /// The problem of the rows of an assembly, the first of which are these contacts, in a step of `h` (s).
    pub(super) fn problem<'a>(
        &'a mut self,
        assembly: &'a Assembly,
        constants: &'a [f64],
        contacts: usize,
        h: f64,
    ) -> ConeProblem<'a> {
        let first = assembly.bodies().first().filter(|_| is_for_bodies(assembly, contacts));
        let system = if let Some(&first) = first {
            System::Bodies {
                solver: self.solvers.entry(first).or_default(),
                start: self.last.start(assembly, contacts, h),
            }
        } else if let Some(forest) = trees_of(assembly) {
            let start = self.last.start(assembly, contacts, h);
            let of_others = |start: Vec<f64>| forest.others().iter().map(|&row| start[row]).collect();
            let start = start.map(of_others);
            System::Beside { delassus: forest.beside(&assembly.problem).delassus, forest, start }
        } else {
            System::Rows(assembly.problem.delassus())
        };
        let settings = BodySettings { rounds_of_sweeps: self.rounds_of_sweeps, ..SETTINGS_IN_BODIES };
        let most_rows_in_place = if self.rounds_of_sweeps > 0 { MOST_ROWS_IN_HEAPS } else { MOST_ROWS_IN_PLACE };
        ConeProblem { assembly, constants, system, settings, most_rows_in_place, factorisations: 0 }
    }
}

/// Whether a problem of so many contacts is solved in the velocities of bodies. Soft rows have no place there yet, nor
/// have rows of gears between more than two bodies.
pub(super) fn is_for_bodies(assembly: &Assembly, contacts: usize) -> bool {
    contacts >= LEAST_IN_BODIES && assembly.problem.compliances().is_empty() && assembly.problem.is_of_pairs()
}

/// The problem of one group.
#[derive(Debug)]
pub(super) struct ConeProblem<'a> {
    assembly: &'a Assembly,
    constants: &'a [f64],
    system: System<'a>,
    settings: BodySettings,
    /// Most rows whose matrix is formed where the velocities of bodies were not solved for exactly enough.
    most_rows_in_place: usize,
    factorisations: usize,
}

/// The unknowns of a problem.
#[derive(Debug)]
enum System<'a> {
    /// Reactions; the matrix of all rows.
    Rows(Delassus),
    /// Reactions of the rows beside trees of joints; their matrix, and those of a similar problem.
    Beside { forest: HeldForest, delassus: Delassus, start: Option<Vec<f64>> },
    /// Velocities of bodies; reactions of a similar problem.
    Bodies { solver: &'a mut BodySolver, start: Option<Vec<f64>> },
}

impl ConeProblem<'_> {
    /// Solves it with these laws; `violation` is how far reactions are from Coulomb's law. A further solve starts from
    /// the answer of the one before.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn solve(
        &mut self,
        blocks: &Blocks,
        violation: impl Fn(&[f64]) -> Option<ConeViolation>,
    ) -> Result<BlocksSolution, ResponseError> {
        let constants = self.constants;
        match &mut self.system {
            System::Rows(delassus) => {
                let mut best = solve_for_rows(blocks, (delassus, constants), None, violation)?;
                let problem = &self.assembly.problem;
                let is_plain = problem.compliances().is_empty() && problem.is_of_pairs();
                if best.report.residual > EXACT_ENOUGH && is_plain {
                    let system = (&mut BodySolver::default(), &self.settings);
                    let (other, effort) = blocks.solve_in_bodies(problem, constants, Some(&best.reactions), system)?;
                    self.factorisations += effort.factorisations;
                    take_better(&mut best, other);
                }
                if best.report.residual > EXACT_ENOUGH {
                    let other = blocks.solve(delassus, constants, Some(&best.reactions), &exact())?;
                    take_better(&mut best, other);
                }
                Ok(best)
            }
            System::Beside { forest, delassus, start } => {
                let problem = &self.assembly.problem;
                let of_others = forest.constants_beside(problem, constants)?;
                let own = blocks.beside(forest);
                let in_rows = |of_others: &[f64]| {
                    let mut reactions = vec![0.0; problem.len()];
                    for (&row, &reaction) in forest.others().iter().zip(of_others) {
                        reactions[row] = reaction;
                    }
                    violation(&reactions)
                };
                let mut best = solve_for_rows(&own, (delassus, &of_others), start.as_deref(), in_rows)?;
                if best.report.residual > EXACT_ENOUGH {
                    let other = own.solve(delassus, &of_others, Some(&best.reactions), &exact())?;
                    take_better(&mut best, other);
                }
                *start = Some(best.reactions.clone());
                blocks.with_forest((problem, forest), constants, &best)
            }
            System::Bodies { solver, start } => {
                let problem = &self.assembly.problem;
                let (mut solved, effort) =
                    blocks.solve_in_bodies(problem, constants, start.as_deref(), (solver, &self.settings))?;
                self.factorisations += effort.factorisations;
                if solved.report.status != SolverStatus::Solved && problem.len() <= self.most_rows_in_place {
                    take_better(&mut solved, blocks.solve(&problem.delassus(), constants, None, &exact())?);
                }
                *start = Some(solved.reactions.clone());
                Ok(solved)
            }
        }
    }

    /// Factorisations in the velocities of bodies so far.
    pub(super) const fn factorisations(&self) -> usize {
        self.factorisations
    }

    /// Whether the next step starts from its answer.
    pub(super) const fn is_started_from(&self) -> bool {
        matches!(self.system, System::Bodies { .. } | System::Beside { .. })
    }
}

/// Takes the other answer if its residual is smaller.
fn take_better(best: &mut BlocksSolution, other: BlocksSolution) {
    if other.report.residual < best.report.residual {
        *best = other;
    }
    let is_solved = best.report.residual <= EXACT_ENOUGH;
    best.report.status = if is_solved { SolverStatus::Solved } else { SolverStatus::Inaccurate };
}

/// Settings that ask for rounding.
fn exact() -> FrictionSettings {
    FrictionSettings { last_sweeps: LAST_SWEEPS, ..FrictionSettings::default() }
}

/// Solves for the reactions, with the matrix of all rows and their constant terms, from those of a similar problem.
fn solve_for_rows(
    blocks: &Blocks,
    (delassus, constants): (&Delassus, &[f64]),
    start: Option<&[f64]>,
    violation: impl Fn(&[f64]) -> Option<ConeViolation>,
) -> Result<BlocksSolution, ResponseError> {
    let exact = exact();
    let settings = FrictionSettings { acceptance: EXACT_ENOUGH, ..exact };
    // A slip or a rate of turning that is much faster than contacts approach hides what is left of their reactions in
    // the residual.
    let has_rotations = blocks.laws().iter().any(|law| law.resists_rotation());
    let mut solved = blocks.solve(delassus, constants, start, if has_rotations { &exact } else { &settings })?;
    let is_off = violation(&solved.reactions).is_some_and(|found| found.value > SHARE_OF_CONE_LIMIT * CONE_LIMIT);
    if !has_rotations && is_off {
        solved = blocks.solve(delassus, constants, Some(&solved.reactions), &exact)?;
    }
    if solved.report.residual <= settings.acceptance {
        solved.report.status = SolverStatus::Solved;
    }
    Ok(solved)
}

#[cfg(test)]
mod tests {
    //! With the matrix of all rows and in the velocities of bodies: the same motion of one pile, some of whose cubes
    //! move.
    #![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use crate::collision::contact_set;
    use crate::collision::{contact_kinematics, friction};
    use crate::model::Model;
    use crate::model::pivot_form::PivotRows;
    use crate::rows::assembly::TangentRow;
    use crate::rows::friction_blocks::push_contact;
    use crate::scene::Material;
    use crate::scene::{Body, Geometry, Scene};
    use polhode_contact::Shape;
    use polhode_dynamics::BodyState;
    use polhode_mesh::solid_box;
    use polhode_spatial::{DVec3, Mass, Pose, UnitVector, Velocity};

    /// Ten cubes in a pyramid that fall for a step under gravity; those above slide along.
    fn pile() -> (Model, Vec<BodyState>) {
        let material = Material::new("rough").with_friction(0.5).unwrap();
        let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into());
        let mut scene = Scene::builder("pile").body(floor.material(material.clone()));
        for (row, column) in (0..4).flat_map(|row| (0..4 - row).map(move |column| (row, column))) {
            let place = DVec3::new((f64::from(column) + 0.5 * f64::from(row)) * 1.1, 0.0, f64::from(row) + 0.5);
            let shape = Geometry::Shape(Shape::cuboid(DVec3::ONE).unwrap());
            let fall = DVec3::new(0.05 * f64::from(row * column), 0.02 * f64::from(row), -9.81 / 60.0);
            let cube =
                Body::movable(format!("{row} {column}"), solid_box(DVec3::ONE, Mass::new(1.0).unwrap()).unwrap());
            let cube = cube.geometry(shape).pose(Pose::from_translation(place));
            scene = scene.body(cube.velocity(Velocity::new(fall, DVec3::ZERO)).material(material.clone()));
        }
        Model::new(&scene.build().unwrap(), PivotRows::default()).unwrap()
    }

    #[test]
    fn rows_and_bodies_give_one_motion() {
        let (model, states) = pile();
        let bodies: Vec<usize> = (1..states.len()).collect();
        let pairs = (0..states.len()).flat_map(|a| (a + 1..states.len()).map(move |b| (a, b)));
        let touches: Vec<_> =
            pairs.flat_map(|(a, b)| contact_set::contacts_of_pair(&model, &states, a, b, 1e-9)).collect();
        let geometries = touches.iter().map(|touch| (touch.id, touch.kinematics.geometry));
        let mut assembly = Assembly::new(&model, &states, &bodies, geometries).unwrap();
        let mut constants: Vec<f64> = touches.iter().map(|touch| touch.kinematics.separation_rate).collect();
        let mut blocks = Blocks::default();
        for (normal, touch) in touches.iter().enumerate() {
            let terms = contact_kinematics::tangential_kinematics(&model, &states, touch.id).unwrap();
            let ellipse = friction::friction_at(&model, &states, touch.id, terms.basis).unwrap().at_rest;
            let first = assembly.problem.len();
            let row = |tangent| TangentRow::new(touch.id, &touch.kinematics.geometry, &terms, tangent);
            assembly.push_tangents(&states, terms.basis.map(row).into_iter()).unwrap();
            constants.extend(terms.basis.map(|tangent| tangent.dot(terms.slip_velocity)));
            push_contact(&mut blocks, ellipse, normal, first..assembly.problem.len());
        }
        assert!(touches.len() >= LEAST_IN_BODIES, "{} contacts", touches.len());
        let mut solvers = ConeSolvers::default();
        let mut problem = solvers.problem(&assembly, &constants, touches.len(), 1.0 / 60.0);
        assert!(problem.is_started_from());
        let in_bodies = problem.solve(&blocks, |_| None).unwrap();
        assert!(problem.factorisations() > 0 && in_bodies.report.residual < 1e-11, "{:?}", in_bodies.report);
        let delassus = assembly.problem.delassus();
        let for_rows = blocks.solve(&delassus, &constants, None, &exact()).unwrap();
        assert_eq!(for_rows.report.status, SolverStatus::Solved);
        let motions = [&in_bodies, &for_rows].map(|solved| assembly.problem.response(&solved.reactions).unwrap());
        for (a, b) in motions[0].iter().zip(&motions[1]) {
            assert!((a - b).abs() < 1e-9, "{a} in bodies, {b} with the matrix");
        }
    }
}
