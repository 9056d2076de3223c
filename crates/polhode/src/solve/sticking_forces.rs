//! Forces of contacts of which none slides yet.
//!
//! The least forces with which every contact holds and sticks are an answer if they lie in the cones of static
//! friction, exact to rounding at any ratio of masses. Where they do not, bodies at rest are asked for forces in the
//! cones that add up to the same on every body, those of the greatest reserve of friction
//! (`polhode_response::friction::Structure`), and all others for those of Coulomb's law. What these methods leave is
//! taken out by the least change, with residuals of twice the working precision: large forces that cancel on a light
//! body then leave no more than its own weight is rounded by.

use crate::collision::touch::Touch;
use crate::model::Model;
use crate::rows::assembly::Assembly;
use crate::rows::frictional_contact::Frictional;
use crate::scene::FrictionEllipse;
use crate::solve::least_sliding_forces::exceeds_friction;
use polhode_dynamics::BodyState;
use polhode_response::friction::{ContactStatus, FrictionSettings, Structure};
use polhode_response::{
    Blocks, BlocksSolution, Delassus, FallbackPolicy, LeastNormForces, Method, ResponseError, SolverReport,
    SolverStatus, least_norm_forces,
};
use polhode_spatial::DVec3;
use std::ops::Range;

/// A slip acceleration below this fraction of the largest relative acceleration without contact forces is rounding
/// (1e-13 to 1e-9).
pub(crate) const STICKING_ACCELERATION: f64 = 1e-11;

/// Accelerations of contacts that stick up to this many times the limit of rounding are the residual of the solver (10
/// to 1e4).
pub(crate) const SLIDING_ROUNDING: f64 = 1e3;

/// Convex programmes of the cone problem at an instant at which nothing slides yet (8 to 64): without its answer the
/// motion cannot begin.
const CORRECTIONS: u32 = 32;

/// The part of friction that bodies at rest may need (no unit): 1, and the accuracy of that part. Forces that leave the
/// cones of all of it are refused afterwards.
pub(super) const MOST_FRICTION_NEEDED: f64 = 1.0 + 1e-6;

/// Rounding error of a sum of terms, in units in the last place of the sum of their magnitudes (4 to 64).
const FORCE_ROUNDING_UNITS: f64 = 16.0;

/// Forces with which every contact holds and sticks, and what they leave.
#[derive(Debug)]
pub(super) struct HoldingForces {
    /// Of all rows, N.
    pub(super) forces: Vec<f64>,
    /// The largest acceleration of a row that they leave, relative to the largest without forces. At large ratios of
    /// masses that of forces of twice the working precision, of which these are the rounded ones.
    pub(super) residual: f64,
    /// Whether that is rounding.
    pub(super) is_balanced: bool,
}

impl HoldingForces {
    /// The least forces.
    fn least(assembly: &Assembly, (delassus, constants): (&Delassus, &[f64])) -> Result<Self, ResponseError> {
        let least = least_norm_forces(&assembly.problem, delassus, constants)?;
        let left = left_by(assembly, constants, &least)?;
        Ok(Self::new((delassus, constants), least.forces, &left))
    }

    /// Forces that nearly hold every contact, made exact with the least change of those that bear something.
    fn near(
        of: (&Model, &[BodyState], &[Touch]),
        assembly: &Assembly,
        (delassus, constants): (&Delassus, &[f64]),
        frictional: &[Option<Frictional>],
        mut forces: Vec<f64>,
    ) -> Result<Self, ResponseError> {
        let mut pressed = Vec::new();
        let mut first = assembly.first_tangent();
        for (normal, friction) in frictional.iter().enumerate() {
            let own = first..first + friction.as_ref().map_or(0, |friction| friction.tangents().len());
            first = own.end;
            if forces[normal] > 0.0 {
                pressed.push((normal, own));
            }
        }
        let left = assembly.problem.accelerations(constants, &forces)?;
        let change = least_change(of, assembly, &pressed, &left)?;
        let left = left_by(assembly, &left, &change)?;
        forces.iter_mut().zip(&change.forces).for_each(|(force, change)| *force += change);
        Ok(Self::new((delassus, constants), forces, &left))
    }

    fn new((delassus, constants): (&Delassus, &[f64]), forces: Vec<f64>, left: &[f64]) -> Self {
        let most = |of: &[f64]| of.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let (scale, left) = (most(constants), most(left));
        let is_balanced = left <= STICKING_ACCELERATION * scale + rounding_of(delassus, &forces);
        let residual = if scale > 0.0 { left / scale } else { 0.0 };
        Self { forces, residual, is_balanced }
    }

    /// These forces as a solution, if they lie in the cones of static friction and hold every contact to rounding.
    pub(super) fn solution(
        &self,
        assembly: &Assembly,
        frictional: &[Option<Frictional>],
        method: Method,
    ) -> Option<BlocksSolution> {
        let mut tangents = self.forces.iter().skip(assembly.first_tangent());
        for (&normal, friction) in self.forces.iter().zip(frictional) {
            let own = friction.as_ref().map_or(0, |friction| friction.tangents().len());
            let tangential: Vec<f64> = tangents.by_ref().take(own).copied().collect();
            let ellipse =
                friction.as_ref().map_or(FrictionEllipse::default(), |friction| friction.coefficients.at_rest);
            let (tangential, limit) = (ellipse.length(&tangential), ellipse.largest() * normal);
            if normal < 0.0 || exceeds_friction(tangential, limit) {
                return None;
            }
        }
        self.is_balanced.then(|| BlocksSolution {
            velocities: vec![0.0; self.forces.len()],
            reactions: self.forces.clone(),
            parts: Vec::new(),
            statuses: vec![ContactStatus::Stick; frictional.len()],
            report: SolverReport { method, residual: self.residual, ..SolverReport::default() },
        })
    }
}

/// What forces leave of accelerations of all rows, m/s^2.
fn left_by(assembly: &Assembly, accelerations: &[f64], least: &LeastNormForces) -> Result<Vec<f64>, ResponseError> {
    match &least.loads {
        Some(loads) => assembly.problem.accelerations_under(accelerations, &least.forces, loads),
        None => assembly.problem.accelerations(accelerations, &least.forces),
    }
}

/// Rounding of the accelerations by large forces that cancel, m/s^2: some rounding units of the terms of `G f`.
pub(crate) fn rounding_of(delassus: &Delassus, forces: &[f64]) -> f64 {
    let terms = |row: usize| delassus.row(row).iter().zip(forces).map(|(g, f)| (g * f).abs()).sum::<f64>();
    FORCE_ROUNDING_UNITS * f64::EPSILON * (0..delassus.len()).map(terms).fold(0.0, f64::max)
}

/// The solution where nothing slides yet. The least forces with which every contact holds and sticks are an answer if
/// they lie in the cones of static friction, exact to rounding at any ratio of masses. Bodies at rest stay at rest if
/// any forces can hold them: where friction jams them against each other Coulomb's law has answers that move them as
/// well. The slow methods of the cone problem are for what nothing holds.
pub(crate) fn of_no_slip(
    of: (&Model, &[BodyState], &[Touch]),
    assembly: &Assembly,
    (blocks, delassus, constants): (&Blocks, &Delassus, &[f64]),
    frictional: &[Option<Frictional>],
) -> Result<BlocksSolution, ResponseError> {
    let problem = (delassus, constants);
    let least = HoldingForces::least(assembly, problem)?;
    if let Some(held) = least.solution(assembly, frictional, Method::ActiveSet) {
        return Ok(held);
    }
    let is_still = |body: &BodyState| body.linear_velocity == DVec3::ZERO && body.angular_momentum == DVec3::ZERO;
    let patient = FrictionSettings { corrections: CORRECTIONS, ..FrictionSettings::default() };
    if !least.is_balanced || !assembly.bodies().iter().all(|&body| is_still(&of.1[body])) {
        let solved = blocks.solve(delassus, constants, None, &patient)?;
        return refined(of, assembly, problem, frictional, solved);
    }
    let settings = FrictionSettings { fallback: FallbackPolicy::Refuse, ..FrictionSettings::default() };
    let solved = blocks.solve(delassus, constants, None, &settings)?;
    let is_solved = solved.report.status == SolverStatus::Solved;
    if is_solved && !solved.statuses.contains(&ContactStatus::Slide) {
        let near = HoldingForces::near(of, assembly, problem, frictional, solved.reactions.clone())?;
        if let Some(held) = near.solution(assembly, frictional, solved.report.method) {
            return Ok(held);
        }
    }
    if let Some(held) = in_equilibrium(of, assembly, (blocks, delassus, constants), frictional, &least)? {
        return Ok(held);
    }
    let solved = if is_solved { solved } else { blocks.solve(delassus, constants, None, &patient)? };
    refined(of, assembly, problem, frictional, solved)
}

/// Forces within the cones under which no contact moves, if there are any; `least` are forces that hold every contact,
/// within the cones or not.
fn in_equilibrium(
    of: (&Model, &[BodyState], &[Touch]),
    assembly: &Assembly,
    (blocks, delassus, constants): (&Blocks, &Delassus, &[f64]),
    frictional: &[Option<Frictional>],
    least: &HoldingForces,
) -> Result<Option<BlocksSolution>, ResponseError> {
    // Limit analysis asks what bodies press on each other by; what presses a joint is given.
    if !assembly.problem.compliances().is_empty() {
        return Ok(None);
    }
    let free: Vec<f64> = assembly.problem.response(&least.forces)?.iter().map(|acceleration| -acceleration).collect();
    let limit = Structure::new(&assembly.problem, blocks, &free, &least.forces)?.friction_limit()?;
    let Some(limit) = limit.filter(|limit| limit.factor <= MOST_FRICTION_NEEDED) else { return Ok(None) };
    let held = HoldingForces::near(of, assembly, (delassus, constants), frictional, limit.forces)?;
    Ok(held.solution(assembly, frictional, Method::InteriorPoint))
}

/// Changes the forces by as little as possible so that all contacts that hold and stick have no acceleration: at large
/// ratios of masses the residual of the solver, relative to the largest acceleration, would move heavy bodies. The
/// solution is returned as it is where a contact slides.
fn refined(
    of: (&Model, &[BodyState], &[Touch]),
    assembly: &Assembly,
    (delassus, constants): (&Delassus, &[f64]),
    frictional: &[Option<Frictional>],
    mut solved: BlocksSolution,
) -> Result<BlocksSolution, ResponseError> {
    let limit = constants.iter().fold(0.0, |most: f64, b| most.max(b.abs()));
    let limit = STICKING_ACCELERATION * limit + rounding_of(delassus, &solved.reactions);
    let limit = SLIDING_ROUNDING * limit;
    let mut first = assembly.first_tangent();
    let mut pressed = Vec::new();
    for (normal, friction) in frictional.iter().enumerate() {
        let own = first..first + friction.as_ref().map_or(0, |friction| friction.tangents().len());
        first = own.end;
        let moves = own.clone().chain([normal]).any(|row| solved.velocities[row].abs() > limit);
        match solved.statuses.get(normal) {
            Some(ContactStatus::Open) | None => continue,
            Some(ContactStatus::Stick) if !moves => {}
            Some(ContactStatus::Stick | ContactStatus::Slide) => return Ok(solved),
        }
        pressed.push((normal, own));
    }
    let left = assembly.problem.accelerations(constants, &solved.reactions)?;
    let change = least_change(of, assembly, &pressed, &left)?.forces;
    solved.reactions.iter_mut().zip(&change).for_each(|(reaction, change)| *reaction += change);
    let held = (0..assembly.first_tangent()).skip(frictional.len());
    let held = held.chain(pressed.into_iter().flat_map(|(normal, tangents)| tangents.chain([normal])));
    held.for_each(|row| solved.velocities[row] = 0.0);
    Ok(solved)
}

/// The least changes of the forces of some contacts, each with its rows along the tangents, and of pivots that cancel
/// what is left in their rows. Other rows have zero.
fn least_change(
    (model, states, contacts): (&Model, &[BodyState], &[Touch]),
    assembly: &Assembly,
    pressed: &[(usize, Range<usize>)],
    left: &[f64],
) -> Result<LeastNormForces, ResponseError> {
    let normals = pressed.iter().map(|(normal, _)| *normal);
    let tangents = pressed.iter().flat_map(|(_, tangents)| tangents.clone());
    let rows: Vec<usize> =
        normals.clone().chain(contacts.len()..assembly.first_tangent()).chain(tangents.clone()).collect();
    let normals = normals.map(|index| (contacts[index].id, contacts[index].kinematics.geometry));
    let mut active = Assembly::new(model, states, assembly.bodies(), normals)?;
    let along = tangents.filter_map(|row| assembly.tangents().get(row - assembly.first_tangent())).copied();
    active.push_tangents(states, along)?;
    let own: Vec<f64> = rows.iter().map(|&row| left[row]).collect();
    let change = least_norm_forces(&active.problem, &active.problem.delassus(), &own)?;
    let mut forces = vec![0.0; left.len()];
    rows.into_iter().zip(change.forces).for_each(|(row, change)| forces[row] = change);
    Ok(LeastNormForces { forces, loads: change.loads })
}
