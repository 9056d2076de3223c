//! Contact forces with friction at one instant: the complementarity problem of accelerations with Coulomb's law.
//!
//! A contact without slip sticks (`u_T' = 0`, `|f_t| <= mu_s f_n`) or begins to slide against the direction of its
//! force; one that slides along `d` bears `-mu f_n d`; every contact satisfies `0 <= f_n _|_ chi'' >= 0`. Where static
//! and kinetic friction differ, the contacts that cannot stick under the static coefficient slide under the kinetic
//! one, and the problem is solved again until no further contact begins to slide.

use super::assembly::{Assembly, TangentRow};
use super::friction_blocks::{FrictionBlocks, RowSolution};
use super::least_sliding_forces::{RowFriction, exceeds_friction, least_sliding_forces};
use super::rotation_row::RotationRow;
use super::rotational_friction::{ResistedRotation, solve_with_rotations};
use crate::collision::contact_set::{ContactId, Touch};
use crate::collision::friction_mode::{FrictionCoefficients, FrictionMode};
use crate::collision::turn::Turn;
use crate::scene::FrictionEllipse;
use crate::world::{Loads, World};
use polhode_contact::TangentialKinematics;
use polhode_dynamics::BodyState;
use polhode_response::friction::{ContactStatus, FrictionBlock, FrictionSettings, balancing_forces};
use polhode_response::{
    ContactSolution, Delassus, FallbackPolicy, LeastNormForces, Method, ResponseError, SolverReport, SolverStatus,
    WarmStart, least_norm_forces,
};
use polhode_spatial::DVec3;
use std::collections::BTreeMap;
use std::ops::Range;

/// A slip acceleration below this fraction of the largest relative acceleration without contact forces is rounding
/// (1e-13 to 1e-9).
const STICKING_RELATIVE: f64 = 1e-11;

/// Accelerations of contacts that stick up to this many times the limit of rounding are the residual of the solver (10 to
/// 1e4).
const SLIDING_ROUNDING: f64 = 1e3;

/// The residual that counts as solved where something slides (no unit, 1e-12 to 1e-9): errors of steps are larger. Where
/// nothing slides the answer may put bodies to rest for good, and is asked for to rounding.
const ACCEPTED_SLIDING: f64 = 1e-10;

/// Convex programmes of the cone problem at an instant at which nothing slides yet (8 to 64): without its answer the motion
/// cannot begin.
const CORRECTIONS: u32 = 32;

/// Directions (unit vectors) that differ by less count as one where slips begin (1e-5 to 1e-3): just beyond static
/// friction, by 1e-9 of it, forces may point apart by the square root of that.
const SAME_DIRECTION: f64 = 1e-4;

/// Parts of friction that are kept in reserve when forces in equilibrium are sought (no unit): making them exact changes
/// them a little, and forces at the limit of friction would leave the cones.
const RESERVES: [f64; 3] = [1e-6, 1e-2, 1e-4];

/// Rounding error of a sum of terms, in units in the last place of the sum of their magnitudes (4 to 64).
const ROUNDING_UNITS: f64 = 16.0;

/// Forces and accelerations of some contacts, of which at least one has friction.
#[derive(Debug)]
pub(crate) struct FrictionalAccelerations {
    pub(crate) assembly: Assembly,
    /// Of the rows of contacts and pivots.
    pub(crate) solution: ContactSolution,
    /// Generalised accelerations of the bodies.
    pub(crate) accelerations: Vec<f64>,
    /// The largest relative acceleration without contact forces, m/s^2.
    pub(crate) scale: f64,
    /// Whether contacts slide and other forces that hold all contacts as well would move the bodies in another way.
    pub(crate) motion_depends_on_choice: bool,
    /// In the order of the contacts; none for a contact without friction.
    pub(crate) contacts: Vec<Option<ContactTangent>>,
    /// What friction of rolling and spinning does.
    pub(crate) turns: BTreeMap<(ContactId, Turn), ContactTurn>,
}

/// What friction does at a contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactTangent {
    /// Force on A in the tangent plane, N.
    pub(crate) force: DVec3,
    /// The sum of the forces on A in the tangent planes of all contacts of the pair, N.
    pub(crate) force_of_pair: DVec3,
    /// `u_T'`, m/s^2.
    pub(crate) slip_acceleration: DVec3,
    /// Its coefficients of friction, and the tangents they are for.
    coefficients: FrictionCoefficients,
    basis: [DVec3; 2],
    /// The direction in which it slides already.
    pub(crate) sliding: Option<DVec3>,
    /// Whether the solver found that it slides, or slides already.
    pub(crate) slides: bool,
}

impl ContactTangent {
    /// The direction in which the slip of a contact begins to grow: against its friction force. The slip acceleration
    /// has the same direction, but where the force barely exceeds static friction it is too small to give one. There
    /// the forces at several contacts of one pair may differ a little in direction without effect on the motion; slips
    /// that begin in such directions would turn at once. A force that nearly agrees with the sum of its pair takes the
    /// direction of the sum.
    pub(crate) fn begins_along(&self) -> Option<DVec3> {
        let against = |force| self.coefficients.at_rest.slip_against(self.basis, force);
        let own = against(self.force).or_else(|| self.slip_acceleration.try_normalize())?;
        let together = against(self.force_of_pair);
        Some(together.filter(|together| (*together - own).length() < SAME_DIRECTION).unwrap_or(own))
    }
}

/// What friction of rolling or spinning does at a contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactTurn {
    /// The direction in which the bodies turn, or begin to turn, on each other (unit vector, world); none while
    /// friction holds them.
    pub(crate) turning: Option<DVec3>,
}

/// A contact with friction among the rows.
#[derive(Debug, Clone, Copy)]
struct Frictional {
    coefficients: FrictionCoefficients,
    terms: TangentialKinematics,
    /// The angular velocity of A relative to B, rad/s.
    rotation: DVec3,
    /// How it slides; none when it sticks.
    sliding: Option<Sliding>,
}

/// A contact that slides.
#[derive(Debug, Clone, Copy)]
struct Sliding {
    /// The direction of its slip (unit vector, world).
    direction: DVec3,
    /// That of its row: what friction opposes. The direction of the slip, but with a grain.
    row: DVec3,
    /// The coefficient there.
    coefficient: f64,
}

impl Sliding {
    fn along(direction: DVec3, coefficients: &FrictionCoefficients, terms: &TangentialKinematics) -> Self {
        let (row, coefficient) = coefficients.sliding.opposed(terms.basis, direction);
        Self { direction, row, coefficient }
    }
}

impl Frictional {
    fn of(world: &World, states: &[BodyState], touch: &Touch) -> Option<Self> {
        world.friction_of(touch.id.a, touch.id.b)?;
        let terms = world.tangential_kinematics(states, touch.id)?;
        let coefficients = world.friction_at(states, touch.id, terms.basis)?;
        let sliding = match touch.friction {
            None | Some(FrictionMode::Sticking) => None,
            Some(FrictionMode::Sliding(slide)) => Some(slide.direction_of(terms.slip_velocity)),
        };
        let sliding = sliding.map(|direction| Sliding::along(direction, &coefficients, &terms));
        let rotation = world.relative_rotation(states, touch.id);
        Some(Self { coefficients, terms, rotation, sliding })
    }

    /// Adds the block of a contact with these rows: what they ask for together.
    fn push_block(friction: Option<&Self>, blocks: &mut FrictionBlocks, normal: usize, tangents: Range<usize>) {
        match friction {
            None => blocks.push_contact(FrictionEllipse::default(), normal, tangents),
            Some(Self { sliding: Some(sliding), .. }) => {
                let block = FrictionBlock::Sliding { friction: sliding.coefficient };
                blocks.push(block, std::iter::once(normal).chain(tangents));
            }
            Some(Self { coefficients, .. }) => blocks.push_contact(coefficients.at_rest, normal, tangents),
        }
    }

    /// The directions of its rows in the tangent plane.
    fn tangents(&self) -> Vec<DVec3> {
        self.sliding.map_or_else(|| self.terms.basis.to_vec(), |sliding| vec![sliding.row])
    }
}

impl FrictionalAccelerations {
    /// Solves for the forces of `contacts` on `bodies` (movable, ascending) at time `t` (s).
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn solve(
        world: &World,
        (t, states): (f64, &[BodyState]),
        bodies: &[usize],
        contacts: &[Touch],
        loads: &Loads,
    ) -> Result<Self, ResponseError> {
        let mut frictional: Vec<_> = contacts.iter().map(|touch| Frictional::of(world, states, touch)).collect();
        loop {
            let found = Self::of_laws(world, (t, states), bodies, (contacts, &frictional), loads)?;
            if !begin_to_slide(&mut frictional, &found) {
                return Ok(found);
            }
        }
    }

    fn of_laws(
        world: &World,
        (t, states): (f64, &[BodyState]),
        bodies: &[usize],
        (contacts, frictional): (&[Touch], &[Option<Frictional>]),
        loads: &Loads,
    ) -> Result<Self, ResponseError> {
        let rows = contacts.iter().map(|touch| (touch.id, touch.kinematics.geometry));
        let mut assembly = Assembly::new(world, states, bodies, rows)?;
        let blocks = blocks_of(&mut assembly, states, (contacts, frictional))?;
        let ResistedRotations { turns, laws: mut rotations } =
            rotations_of(&mut assembly, world, contacts, frictional)?;
        let free = assembly.free_accelerations(world, states, loads);
        let kinematics = contacts.iter().map(|touch| (touch.id, &touch.kinematics));
        let constants = assembly.acceleration_constants(world, t, states, &free, kinematics)?;
        let delassus = assembly.problem.delassus();
        let any_slides = frictional.iter().flatten().any(|friction| friction.sliding.is_some());
        let mut motion_depends_on_choice = false;
        let holding = if !rotations.is_empty() {
            None
        } else if any_slides {
            let held = all_hold((world, states, contacts), &assembly, &constants, frictional)?;
            held.map(|(solution, depends)| {
                motion_depends_on_choice = depends;
                solution
            })
        } else {
            None
        };
        let solved = if let Some(holding) = holding {
            holding
        } else if !rotations.is_empty() {
            solve_with_rotations(&blocks, &mut rotations, &delassus, &constants)?
        } else {
            let of = (world, states, contacts);
            if any_slides {
                let settings = FrictionSettings { acceptance: ACCEPTED_SLIDING, ..FrictionSettings::default() };
                blocks.solve(&delassus, &constants, None, &settings)?
            } else {
                of_no_slip(of, &assembly, (&blocks, &delassus, &constants), frictional)?
            }
        };
        let mut accelerations = assembly.problem.response(&solved.reactions)?;
        for (acceleration, free) in accelerations.iter_mut().zip(&free) {
            *acceleration += free;
        }
        let mut first = assembly.first_tangent();
        let tangential = frictional.iter().enumerate().map(|(normal, friction)| {
            let friction = friction.as_ref()?;
            let found = contact_tangent(&solved, (normal, first), friction);
            first += friction.tangents().len();
            Some(found)
        });
        let mut tangential: Vec<Option<ContactTangent>> = tangential.collect();
        add_up_pairs(contacts, &mut tangential);
        complete_slips((world, t, states), (contacts, frictional), (&assembly, &accelerations), &mut tangential);
        let turn = |law: &ResistedRotation| ContactTurn { turning: turning(&assembly, law) };
        let turns = turns.into_iter().zip(rotations.iter().map(turn)).collect();
        let scale = constants.iter().fold(0.0f64, |most, b| most.max(b.abs()));
        let solution = contact_solution(&solved, assembly.first_tangent());
        Ok(Self { contacts: tangential, solution, accelerations, scale, assembly, motion_depends_on_choice, turns })
    }
}

/// Adds the rows along the tangents of contacts with friction. Returns the block of each contact and those of pivots.
fn blocks_of(
    assembly: &mut Assembly,
    states: &[BodyState],
    (contacts, frictional): (&[Touch], &[Option<Frictional>]),
) -> Result<FrictionBlocks, ResponseError> {
    let mut blocks = FrictionBlocks::default();
    for (normal, (touch, friction)) in contacts.iter().zip(frictional).enumerate() {
        let first = assembly.problem.len();
        let tangents = friction.iter().flat_map(|friction| {
            let geometry = &touch.kinematics.geometry;
            let row = |tangent| TangentRow::new(touch.id, geometry, &friction.terms, tangent);
            friction.tangents().into_iter().map(row)
        });
        assembly.push_tangents(states, tangents)?;
        Frictional::push_block(friction.as_ref(), &mut blocks, normal, first..assembly.problem.len());
    }
    blocks.push_held(contacts.len()..assembly.first_tangent());
    Ok(blocks)
}

/// Forces with which every contact holds and sticks, and what they leave.
#[derive(Debug)]
struct HoldingForces {
    /// Of all rows, N.
    forces: Vec<f64>,
    /// The largest acceleration of a row that they leave, relative to the largest without forces. At large ratios of masses
    /// that of forces of twice the working precision, of which these are the rounded ones.
    residual: f64,
    /// Whether that is rounding.
    is_balanced: bool,
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
        of: (&World, &[BodyState], &[Touch]),
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
        let is_balanced = left <= STICKING_RELATIVE * scale + rounding_of(delassus, &forces);
        let residual = if scale > 0.0 { left / scale } else { 0.0 };
        Self { forces, residual, is_balanced }
    }

    /// These forces as a solution, if they lie in the cones of static friction and hold every contact to rounding.
    fn solution(&self, assembly: &Assembly, frictional: &[Option<Frictional>], method: Method) -> Option<RowSolution> {
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
        self.is_balanced.then(|| RowSolution {
            velocities: vec![0.0; self.forces.len()],
            reactions: self.forces.clone(),
            statuses: vec![ContactStatus::Stick; frictional.len()],
            report: SolverReport { method, residual: self.residual, ..SolverReport::default() },
        })
    }
}

/// What forces leave of accelerations of all rows, m/s^2.
fn left_by(assembly: &Assembly, accelerations: &[f64], least: &LeastNormForces) -> Result<Vec<f64>, ResponseError> {
    match &least.loads {
        Some(loads) => assembly.problem.accelerations_under(accelerations, loads),
        None => assembly.problem.accelerations(accelerations, &least.forces),
    }
}

/// Where some contacts slide: the least forces with which every contact holds, and whether the motion
/// depends on that choice.
fn all_hold(
    of: (&World, &[BodyState], &[Touch]),
    assembly: &Assembly,
    constants: &[f64],
    frictional: &[Option<Frictional>],
) -> Result<Option<(RowSolution, bool)>, ResponseError> {
    let friction = frictional.iter().map(|friction| match friction {
        None => RowFriction::Frictionless,
        Some(Frictional { sliding: Some(sliding), .. }) => RowFriction::Slides(sliding.coefficient),
        Some(Frictional { coefficients, .. }) => RowFriction::Sticks(coefficients.at_rest),
    });
    let scale = constants.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let rounding = |delassus: &Delassus, forces: &[f64]| STICKING_RELATIVE * scale + rounding_of(delassus, forces);
    let friction: Vec<RowFriction> = friction.collect();
    let Some(least) = least_sliding_forces(of, assembly, constants, &friction, rounding)? else { return Ok(None) };
    let reactions = least.forces;
    let mut velocities = assembly.problem.delassus().times(&reactions)?;
    for (velocity, constant) in velocities.iter_mut().zip(constants) {
        *velocity += constant;
    }
    // What is held is at zero up to rounding.
    let mut first = assembly.first_tangent();
    velocities[..first].fill(0.0);
    for friction in frictional.iter().flatten() {
        let rows = friction.tangents().len();
        if friction.sliding.is_none() {
            velocities[first..first + rows].fill(0.0);
        }
        first += rows;
    }
    let report = SolverReport { method: Method::ActiveSet, ..SolverReport::default() };
    let slides = |friction: &Option<Frictional>| friction.as_ref().is_some_and(|friction| friction.sliding.is_some());
    let status = |friction| if slides(friction) { ContactStatus::Slide } else { ContactStatus::Stick };
    let statuses = frictional.iter().map(status).collect();
    Ok(Some((RowSolution { reactions, velocities, statuses, report }, least.motion_depends_on_choice)))
}

/// Rounding of the accelerations by large forces that cancel, m/s^2: some rounding units of the terms of `G f`.
fn rounding_of(delassus: &Delassus, forces: &[f64]) -> f64 {
    let terms = |row: usize| delassus.row(row).iter().zip(forces).map(|(g, f)| (g * f).abs()).sum::<f64>();
    ROUNDING_UNITS * f64::EPSILON * (0..delassus.len()).map(terms).fold(0.0, f64::max)
}

/// The solution where nothing slides yet. The least forces with which every contact holds and sticks are an answer if they
/// lie in the cones of static friction, exact to rounding at any ratio of masses. Bodies at rest stay at rest if any forces
/// can hold them: where friction jams them against each other Coulomb's law has answers that move them as well. The slow
/// methods of the cone problem are for what nothing holds.
fn of_no_slip(
    of: (&World, &[BodyState], &[Touch]),
    assembly: &Assembly,
    (blocks, delassus, constants): (&FrictionBlocks, &Delassus, &[f64]),
    frictional: &[Option<Frictional>],
) -> Result<RowSolution, ResponseError> {
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

/// Forces within the cones under which no contact moves, if there are any; `least` are forces that hold every contact, within
/// the cones or not.
fn in_equilibrium(
    of: (&World, &[BodyState], &[Touch]),
    assembly: &Assembly,
    (blocks, delassus, constants): (&FrictionBlocks, &Delassus, &[f64]),
    frictional: &[Option<Frictional>],
    least: &HoldingForces,
) -> Result<Option<RowSolution>, ResponseError> {
    let rows = blocks.of_rows_of_assembly();
    for reserve in RESERVES {
        // Where nothing balances with the least reserve nothing does with a larger one.
        let Some(nearly) = balancing_forces(&assembly.problem, &least.forces, rows, reserve)? else { break };
        let held = HoldingForces::near(of, assembly, (delassus, constants), frictional, nearly)?;
        if let Some(held) = held.solution(assembly, frictional, Method::InteriorPoint) {
            return Ok(Some(held));
        }
    }
    Ok(None)
}

/// Changes the forces by as little as possible so that all contacts that hold and stick have no acceleration: at large
/// ratios of masses the residual of the solver, relative to the largest acceleration, would move heavy bodies. The
/// solution is returned as it is where a contact slides.
fn refined(
    of: (&World, &[BodyState], &[Touch]),
    assembly: &Assembly,
    (delassus, constants): (&Delassus, &[f64]),
    frictional: &[Option<Frictional>],
    mut solved: RowSolution,
) -> Result<RowSolution, ResponseError> {
    let limit = constants.iter().fold(0.0, |most: f64, b| most.max(b.abs()));
    let limit = STICKING_RELATIVE * limit + rounding_of(delassus, &solved.reactions);
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
    (world, states, contacts): (&World, &[BodyState], &[Touch]),
    assembly: &Assembly,
    pressed: &[(usize, Range<usize>)],
    left: &[f64],
) -> Result<LeastNormForces, ResponseError> {
    let normals = pressed.iter().map(|(normal, _)| *normal);
    let tangents = pressed.iter().flat_map(|(_, tangents)| tangents.clone());
    let rows: Vec<usize> =
        normals.clone().chain(contacts.len()..assembly.first_tangent()).chain(tangents.clone()).collect();
    let normals = normals.map(|index| (contacts[index].id, contacts[index].kinematics.geometry));
    let mut active = Assembly::new(world, states, assembly.bodies(), normals)?;
    let along = tangents.filter_map(|row| assembly.tangents().get(row - assembly.first_tangent())).copied();
    active.push_tangents(states, along)?;
    let own: Vec<f64> = rows.iter().map(|&row| left[row]).collect();
    let change = least_norm_forces(&active.problem, &active.problem.delassus(), &own)?;
    let mut forces = vec![0.0; left.len()];
    rows.into_iter().zip(change.forces).for_each(|(row, change)| forces[row] = change);
    Ok(LeastNormForces { forces, loads: change.loads })
}

/// Rotations that friction resists.
#[derive(Debug, Default)]
struct ResistedRotations {
    /// Their contacts, and which rotation it is.
    turns: Vec<(ContactId, Turn)>,
    /// What friction asks of each.
    laws: Vec<ResistedRotation>,
}

/// Adds the rows of rotations that friction resists.
fn rotations_of(
    assembly: &mut Assembly,
    world: &World,
    contacts: &[Touch],
    frictional: &[Option<Frictional>],
) -> Result<ResistedRotations, ResponseError> {
    let mut found = ResistedRotations::default();
    if !world.has_rotational_friction() {
        return Ok(found);
    }
    for (normal, (touch, frictional)) in contacts.iter().zip(frictional).enumerate() {
        let Some(frictional) = frictional else { continue };
        for turn in Turn::ALL {
            let Some(friction) = turn.friction(world, (touch.id.a, touch.id.b)) else { continue };
            let axes = turn.axes(touch.kinematics.geometry.normal, frictional.terms.basis);
            let rows = assembly.problem.len()..assembly.problem.len() + axes.len();
            let along = match touch.rotation.get(turn) {
                Some(FrictionMode::Sliding(slide)) => {
                    let rotation = turn.part(frictional.rotation, touch.kinematics.geometry.normal);
                    let direction = slide.direction_of(rotation);
                    Some(axes.iter().map(|axis| axis.dot(direction)).collect())
                }
                Some(FrictionMode::Sticking) | None => None,
            };
            assembly.push_rotations(axes.into_iter().map(|axis| RotationRow { id: touch.id, axis }))?;
            found.turns.push((touch.id, turn));
            found.laws.push(ResistedRotation { normal, rows, friction, turns: along });
        }
    }
    Ok(found)
}

/// The direction in which a rotation turns; none while it is held.
fn turning(assembly: &Assembly, law: &ResistedRotation) -> Option<DVec3> {
    let mut of_rows = vec![0.0; assembly.problem.len()];
    for (row, part) in law.rows.clone().zip(law.turns.as_ref()?) {
        of_rows[row] = *part;
    }
    assembly.of_rotations(&of_rows).map(|(row, part)| row.axis * part).sum::<DVec3>().try_normalize()
}

/// What friction does at a contact, from the solution of all rows: its normal row and its first tangential one.
fn contact_tangent(solved: &RowSolution, (normal, first): (usize, usize), friction: &Frictional) -> ContactTangent {
    let sum = |of: &[f64]| {
        let along = friction.tangents().into_iter().zip(of.iter().skip(first));
        along.map(|(tangent, value)| tangent * *value).sum::<DVec3>()
    };
    ContactTangent {
        force: sum(&solved.reactions),
        force_of_pair: DVec3::ZERO,
        slip_acceleration: sum(&solved.velocities),
        coefficients: friction.coefficients,
        basis: friction.terms.basis,
        sliding: friction.sliding.map(|sliding| sliding.direction),
        slides: solved.statuses.get(normal) == Some(&ContactStatus::Slide),
    }
}

/// Gives contacts that slide the whole rate of their slip along its direction: their row is along what friction opposes,
/// which with a grain is another one.
fn complete_slips(
    (world, t, states): (&World, f64, &[BodyState]),
    (contacts, frictional): (&[Touch], &[Option<Frictional>]),
    (assembly, accelerations): (&Assembly, &[f64]),
    tangential: &mut [Option<ContactTangent>],
) {
    if !world.has_grain() {
        return;
    }
    for ((touch, friction), tangent) in contacts.iter().zip(frictional).zip(tangential) {
        let (Some(friction), Some(tangent)) = (friction, tangent) else { continue };
        let Some(Sliding { direction, row, .. }) = friction.sliding else { continue };
        if row != direction {
            let row = TangentRow::new(touch.id, &touch.kinematics.geometry, &friction.terms, direction);
            let along = (&row.along, row.acceleration_bias);
            let rate = world.relative_acceleration((t, states), row.id, along, assembly.split(accelerations));
            tangent.slip_acceleration = direction * rate;
        }
    }
}

/// Gives each contact the sum of the forces of its pair.
fn add_up_pairs(contacts: &[Touch], tangential: &mut [Option<ContactTangent>]) {
    let mut sums: BTreeMap<(usize, usize), DVec3> = BTreeMap::new();
    for (touch, tangent) in contacts.iter().zip(tangential.iter()) {
        if let Some(tangent) = tangent {
            *sums.entry((touch.id.a, touch.id.b)).or_default() += tangent.force;
        }
    }
    for (touch, tangent) in contacts.iter().zip(tangential) {
        if let (Some(tangent), Some(&sum)) = (tangent, sums.get(&(touch.id.a, touch.id.b))) {
            tangent.force_of_pair = sum;
        }
    }
}

/// The solution of the first rows, those of contacts and pivots.
fn contact_solution(solved: &RowSolution, rows: usize) -> ContactSolution {
    let forces: Vec<f64> = solved.reactions.iter().take(rows).copied().collect();
    let carry = forces.iter().enumerate().filter(|&(_, &force)| force > 0.0).map(|(row, _)| row);
    ContactSolution {
        residual_accelerations: solved.velocities.iter().take(rows).copied().collect(),
        held: forces.iter().map(|&force| force > 0.0).collect(),
        squeeze: Vec::new(),
        warm_start: WarmStart::new(carry.collect()),
        report: solved.report,
        forces,
    }
}

/// Lets contacts slide that cannot stick and whose kinetic friction is below the static one. Returns whether there are
/// any.
fn begin_to_slide(frictional: &mut [Option<Frictional>], found: &FrictionalAccelerations) -> bool {
    let mut any = false;
    for (friction, tangent) in frictional.iter_mut().zip(&found.contacts) {
        let (Some(friction), Some(tangent)) = (friction, tangent) else { continue };
        let growth = tangent.slip_acceleration.length();
        let slides = friction.sliding.is_none() && tangent.slides && growth > STICKING_RELATIVE * found.scale;
        if slides && friction.coefficients.sliding.is_below(friction.coefficients.at_rest) {
            let along = |direction| Sliding::along(direction, &friction.coefficients, &friction.terms);
            friction.sliding = tangent.begins_along().map(along);
            any |= friction.sliding.is_some();
        }
    }
    any
}
