//! Contact forces at one instant: the complementarity problem of accelerations, with Coulomb's law where contacts have
//! friction.
//!
//! Without friction it is `0 <= f _|_ G f + b >= 0` (thesis 3.4), solved by the active set that begins with the
//! contacts that hold already.
//!
//! A contact without slip sticks (`u_T' = 0`, `|f_t| <= mu_s f_n`) or begins to slide against the direction of its
//! force; one that slides along `d` bears `-mu f_n d`; every contact satisfies `0 <= f_n _|_ chi'' >= 0`. Where static
//! and kinetic friction differ, the contacts that cannot stick under the static coefficient slide under the kinetic
//! one, and the problem is solved again until no further contact begins to slide.

use crate::collision::contact_kinematics;
use crate::collision::friction_mode::{FrictionCoefficients, FrictionMode};
use crate::collision::touch::{Hold, Touch};
use crate::collision::turn::Turn;
use crate::identity::contact_id::ContactId;
use crate::joints::joint_friction::MOST_ROUNDS_OF_BEARINGS;
use crate::model::{Loads, Model, tolerances};
use crate::rows::assembly::{self, Assembly};
use crate::rows::frictional_contact::{FrictionalContact, Sliding};
use crate::rows::resisted_rotation::{self, ResistedRotation, direction_of, with_rotations};
use crate::solve::cone_violation::{ConeViolation, RubbingForce};
use polhode_dynamics::BodyState;
use polhode_response::friction::ContactStatus;
use polhode_response::solve::instant::{SLIDING_ROUNDING, STICKING_ACCELERATION};
use polhode_response::{Answer, Ask, Blocks, Choice, Memory, Question, ResponseError, Rows, WarmStart};
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

/// What the forces are wanted for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// The motion goes on from them.
    Future,
    /// They are told.
    Present,
}

/// Forces of some contacts, and accelerations of their bodies.
#[derive(Debug)]
pub(crate) struct Accelerations {
    pub(crate) assembly: Assembly,
    /// Of the rows of contacts and pivots.
    pub(crate) solution: Answer,
    /// Generalised accelerations of the bodies.
    pub(crate) of_bodies: Vec<f64>,
    /// The largest relative acceleration without contact forces, m/s^2.
    pub(crate) scale: f64,
    /// What rounding of the forces may leave of accelerations, m/s^2.
    rounding: f64,
    /// Whether contacts slide and other forces that hold all contacts as well would move the bodies in another way.
    pub(crate) motion_depends_on_choice: bool,
    /// Whether the masses that the contacts meet are alike.
    are_alike: bool,
    /// Whether contacts slide, and the least forces with which all hold are the answer.
    are_exact: bool,
    /// What friction does, in the order of the contacts; none for a contact without friction.
    pub(crate) contacts: Vec<Option<ContactTangent>>,
    /// What friction of rolling and spinning does.
    pub(crate) turns: BTreeMap<(ContactId, Turn), ContactTurn>,
}

/// What friction does at a contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactTangent {
    /// Force on A in the tangent plane, N.
    pub(crate) force: DVec3,
    /// `u_T'`, m/s^2.
    pub(crate) slip_acceleration: DVec3,
    /// Its coefficients of friction, and the tangents they are for.
    coefficients: FrictionCoefficients,
    basis: [DVec3; 2],
    /// The direction in which it slides already.
    pub(crate) sliding: Option<DVec3>,
    /// Whether the solver found that it slides, or slides already.
    pub(crate) slides: bool,
    /// Whether friction holds it. A contact that touches without pressing is not held: friction of no force holds
    /// nothing.
    pub(crate) is_held: bool,
    /// Its normal and its tangential force.
    pub(crate) rubbing: RubbingForce,
    /// Whether its force is more than rounding, so that it has a direction.
    has_force: bool,
}

impl ContactTangent {
    /// The direction in which the slip of a contact begins to grow: against its friction force. The slip acceleration
    /// has the same direction, but where the force barely exceeds static friction it is too small to give one. A
    /// contact that touches without pressing bears no force: its slip follows its acceleration.
    pub(crate) fn begins_along(&self) -> Option<DVec3> {
        if !self.has_force {
            return self.slip_acceleration.try_normalize();
        }
        self.coefficients
            .at_rest
            .slip_against(self.basis, self.force)
            .or_else(|| self.slip_acceleration.try_normalize())
    }
}

/// What friction of rolling or spinning does at a contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactTurn {
    /// The direction in which the bodies turn, or begin to turn, on each other (unit vector, world); none while
    /// friction holds them.
    pub(crate) turning: Option<DVec3>,
}

impl Accelerations {
    /// Solves for the forces of `contacts` on `bodies` (movable, ascending) at time `t` (s).
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn solve(
        model: &Model,
        (t, states): (f64, &[BodyState]),
        bodies: &[usize],
        contacts: &[Touch],
        loads: &Loads,
        (wanted, memory): (Wanted, &mut Memory),
    ) -> Result<Self, ResponseError> {
        let mut frictional: Vec<_> =
            contacts.iter().map(|touch| FrictionalContact::of_touch(model, states, touch)).collect();
        loop {
            let found = Self::of_laws(model, (t, states), bodies, (contacts, &frictional), (loads, wanted, memory))?;
            if begin_to_slide(&mut frictional, &found) {
                continue;
            }
            if wanted == Wanted::Present || found.are_alike || !begin_exactly(&mut frictional, &found) {
                return Ok(found);
            }
            let exact = Self::of_laws(model, (t, states), bodies, (contacts, &frictional), (loads, wanted, memory))?;
            return Ok(if exact.is_exact_slide() { exact } else { found });
        }
    }

    /// Whether these are the exact forces of contacts that slide, and slips grow in the directions that were taken.
    fn is_exact_slide(&self) -> bool {
        let grows =
            |tangent: &ContactTangent| tangent.sliding.is_none_or(|along| tangent.slip_acceleration.dot(along) >= 0.0);
        self.are_exact && self.contacts.iter().flatten().all(grows)
    }

    fn of_laws(
        model: &Model,
        (t, states): (f64, &[BodyState]),
        bodies: &[usize],
        (contacts, frictional): (&[Touch], &[Option<FrictionalContact>]),
        (loads, wanted, memory): (&Loads, Wanted, &mut Memory),
    ) -> Result<Self, ResponseError> {
        let rows = contacts.iter().map(|touch| (touch.id, touch.kinematics.geometry));
        let mut assembly = Assembly::new(model, states, bodies, rows)?;
        let blocks = blocks_of(&mut assembly, states, frictional)?;
        let rotations = rotations_of(&mut assembly, (model, states), (contacts, frictional))?;
        let FreeMotion { free, mut constants } = FreeMotion::of(&assembly, model, (t, states), contacts, loads)?;
        let blocks = with_rotations(blocks, &rotations);
        let ask = asked(wanted, bodies.iter().map(|&body| &states[body]), &free);
        // Accelerations of joints are differences of centripetal terms, whatever the forces are that follow from them.
        let has_joints = !assembly.bilaterals().is_empty();
        let noise_floor = if has_joints { tolerances::acceleration_rounding(model, states, bodies) } else { 0.0 };
        let start = WarmStart::new((0..contacts.len()).filter(|&place| contacts[place].hold == Hold::Held).collect());
        let known = Question { blocks: Some(&blocks), start: Some(&start), noise_floor, ..Question::default() };
        let mut solved = with_loads_of_bearings(&mut assembly, &mut constants, (known, ask), memory)?;
        let of_bodies = with_free(assembly.problem.response(&solved.reactions)?, &free);
        let assembly = assembly.with_supports(model);
        solved.reactions = assembly.least(&solved.reactions)?.into_owned();
        let mut first = assembly.first_tangent();
        let scale = largest(&constants);
        let tangential = frictional.iter().enumerate().map(|(normal, friction)| {
            let friction = friction.as_ref()?;
            let rounding = STICKING_ACCELERATION * scale / assembly.problem.mobility(first);
            let found = contact_tangent(&solved, (normal, first), (contacts.get(normal)?.id, friction), rounding);
            first += friction.tangents().len();
            Some(found)
        });
        let mut tangential: Vec<Option<ContactTangent>> = tangential.collect();
        complete_slips((model, t, states), frictional, (&assembly, &of_bodies), &mut tangential);
        let turn = |law: &ResistedRotation| {
            let turning = turning(&assembly, law, &solved);
            Some(((contacts.get(law.normal)?.id, law.turn), ContactTurn { turning }))
        };
        let turns = rotations.iter().filter_map(turn).collect();
        Ok(Self {
            are_alike: assembly.problem.has_alike_masses(),
            contacts: tangential,
            of_bodies,
            scale,
            rounding: solved.rounding,
            motion_depends_on_choice: solved.choice == Some(Choice::DecidesMotion),
            are_exact: solved.choice.is_some(),
            turns,
            solution: of_contacts_and_joints(solved, assembly.first_tangent()),
            assembly,
        })
    }
}

/// The forces of rows, found again until the loads of bearings stay: these change the constant terms.
///
/// # Errors
/// When a number is not finite.
pub(crate) fn with_loads_of_bearings(
    assembly: &mut Assembly,
    constants: &mut [f64],
    (known, ask): (Question<'_>, Ask<'_>),
    memory: &mut Memory,
) -> Result<Answer, ResponseError> {
    let (mut known, mut near) = (known, None);
    for round in 1..MOST_ROUNDS_OF_BEARINGS {
        let found = assembly.answer(Question { constants, near: near.as_deref(), ..known }, ask, memory)?;
        let blocks = known.blocks.filter(|_| round == 1 && ask == Ask::Stage);
        let change = |change: &[f64]| memory.change_at_stage(change, blocks?, found.reactions.len());
        if !assembly.press_by_linear_loads((&found.reactions, 1.0), constants.len(), change)? {
            return Ok(found);
        }
        assembly.press(constants, 1.0);
        known.rows = Rows::AsBefore;
        near = Some(found.reactions);
    }
    assembly.answer(Question { constants, near: near.as_deref(), ..known }, ask, memory)
}

/// The violation of Coulomb's law in bearings whose loads were not found: their friction is that of other loads.
pub(crate) fn violation_of_bearings(assembly: &Assembly) -> Option<ConeViolation> {
    assembly.unfound_loads().map(|(value, pair)| ConeViolation { value, pair })
}

/// What is asked of the rows between bodies in these states.
fn asked<'a>(wanted: Wanted, mut states: impl Iterator<Item = &'a BodyState>, free: &'a [f64]) -> Ask<'a> {
    let is_still = |state: &BodyState| state.linear_velocity == DVec3::ZERO && state.angular_momentum == DVec3::ZERO;
    match wanted {
        Wanted::Present => Ask::Present,
        Wanted::Future if states.all(is_still) => Ask::Rest { free },
        Wanted::Future => Ask::Instant,
    }
}

/// Accelerations without the forces that are asked for.
pub(super) struct FreeMotion {
    /// Of the bodies.
    pub(super) free: Vec<f64>,
    /// Of the rows, m/s^2.
    pub(super) constants: Vec<f64>,
}

impl FreeMotion {
    pub(super) fn of(
        assembly: &Assembly,
        model: &Model,
        (t, states): (f64, &[BodyState]),
        contacts: &[Touch],
        loads: &Loads,
    ) -> Result<Self, ResponseError> {
        let free = assembly.free_accelerations(model, states, loads);
        let kinematics = contacts.iter().map(|touch| (touch.id, &touch.kinematics));
        let constants = assembly.acceleration_constants(model, t, states, &free, kinematics)?;
        Ok(Self { free, constants })
    }
}

/// The accelerations that forces give, with those without them.
fn with_free(mut accelerations: Vec<f64>, free: &[f64]) -> Vec<f64> {
    accelerations.iter_mut().zip(free).for_each(|(acceleration, free)| *acceleration += free);
    accelerations
}

/// The largest magnitude of some numbers.
fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most: f64, number| most.max(number.abs()))
}

/// Adds the rows along the tangents of contacts with friction. Returns the block of each contact and those of pivots.
pub(crate) fn blocks_of(
    assembly: &mut Assembly,
    states: &[BodyState],
    frictional: &[Option<FrictionalContact>],
) -> Result<Blocks, ResponseError> {
    let mut blocks = Blocks::default();
    for (normal, friction) in frictional.iter().enumerate() {
        let first = assembly.problem.len();
        assembly.push_tangents(states, friction.iter().flat_map(FrictionalContact::rows))?;
        FrictionalContact::push_block(friction.as_ref(), &mut blocks, normal, first..assembly.problem.len());
    }
    blocks.hold(frictional.len()..assembly.first_tangent());
    Ok(blocks)
}

/// Adds the rows of rotations that friction resists.
fn rotations_of(
    assembly: &mut Assembly,
    (model, states): (&Model, &[BodyState]),
    (contacts, frictional): (&[Touch], &[Option<FrictionalContact>]),
) -> Result<Vec<ResistedRotation>, ResponseError> {
    let turning = |place: usize, turn: Turn| {
        let Touch { id, kinematics, modes, .. } = &contacts[place];
        let Some(FrictionMode::Sliding(slide)) = modes.rotation.get(turn) else { return None };
        let rotation = contact_kinematics::relative_rotation(model, states, *id);
        Some(slide.direction_of(turn.part(rotation, kinematics.geometry.normal)))
    };
    resisted_rotation::push(assembly, model, frictional, turning)
}

/// The direction in which a rotation turns; none while it is held.
fn turning(assembly: &Assembly, law: &ResistedRotation, solved: &Answer) -> Option<DVec3> {
    let mut of_rows = vec![0.0; assembly.problem.len()];
    for (row, part) in law.rows.clone().zip(direction_of(solved, law)?) {
        of_rows[row] = part;
    }
    assembly.of_rotations(&of_rows).map(|(row, part)| row.axis * part).sum::<DVec3>().try_normalize()
}

/// What friction does at a contact, from the solution of all rows: its normal row and its first tangential one. A force
/// of at most `rounding` (N) is none.
fn contact_tangent(
    solved: &Answer,
    (normal, first): (usize, usize),
    (id, friction): (ContactId, &FrictionalContact),
    rounding: f64,
) -> ContactTangent {
    let sum = |of: &[f64]| {
        let along = friction.tangents().into_iter().zip(of.iter().skip(first));
        along.map(|(tangent, value)| tangent * *value).sum::<DVec3>()
    };
    let (force, status) = (sum(&solved.reactions), solved.statuses.get(normal));
    let along: Vec<f64> = solved.reactions.iter().skip(first).take(friction.tangents().len()).copied().collect();
    let at_rest = friction.coefficients.at_rest;
    let (tangential, coefficient) = match friction.sliding {
        Some(sliding) => (force.length(), sliding.coefficient),
        None => (at_rest.length(&along), at_rest.largest()),
    };
    let normal = solved.reactions.get(normal).copied().unwrap_or(0.0);
    let rubbing = RubbingForce { pair: (id.a, id.b), normal, tangential, friction: coefficient };
    ContactTangent {
        force,
        slip_acceleration: sum(&solved.velocities),
        coefficients: friction.coefficients,
        basis: friction.terms.basis,
        sliding: friction.sliding.map(|sliding| sliding.direction),
        slides: status == Some(&ContactStatus::Slide),
        is_held: status == Some(&ContactStatus::Stick),
        rubbing,
        has_force: force.length() > rounding,
    }
}

/// Gives contacts that slide the whole rate of their slip along its direction: their row is along what friction
/// opposes, which with a grain is another one.
fn complete_slips(
    (model, t, states): (&Model, f64, &[BodyState]),
    frictional: &[Option<FrictionalContact>],
    (assembly, accelerations): (&Assembly, &[f64]),
    tangential: &mut [Option<ContactTangent>],
) {
    if !model.surfaces.have_grain() {
        return;
    }
    for (friction, tangent) in frictional.iter().zip(tangential) {
        let (Some(friction), Some(tangent)) = (friction, tangent) else { continue };
        let Some(Sliding { direction, row, .. }) = friction.sliding else { continue };
        if row != direction {
            let row = friction.row_along(direction);
            let along = (&row.along, row.acceleration_bias);
            let rate =
                assembly::relative_acceleration(model, (t, states), row.id, along, assembly.split(accelerations));
            tangent.slip_acceleration = direction * rate;
        }
    }
}

/// The answer of the first rows, those of contacts and pivots.
fn of_contacts_and_joints(mut solved: Answer, rows: usize) -> Answer {
    solved.reactions.truncate(rows);
    solved.velocities.truncate(rows);
    solved
}

/// Lets contacts slide whose slips grow by more than rounding, so that their forces are found as those of contacts that
/// slide. The cone problem of heavy bodies on light ones is solved only to the rounding of the heavy ones' forces, and
/// would let bodies that slide together slide on each other. Returns whether there are any.
fn begin_exactly(frictional: &mut [Option<FrictionalContact>], found: &Accelerations) -> bool {
    let least = SLIDING_ROUNDING * (STICKING_ACCELERATION * found.scale + found.rounding);
    let mut any = false;
    for (friction, tangent) in frictional.iter_mut().zip(&found.contacts) {
        let (Some(friction), Some(tangent)) = (friction, tangent) else { continue };
        let slides = friction.sliding.is_none() && tangent.slides && tangent.slip_acceleration.length() > least;
        if slides && let Some(direction) = tangent.begins_along() {
            *friction = friction.sliding_along(direction);
            any = true;
        }
    }
    any
}

/// Lets contacts slide that cannot stick and whose kinetic friction is below the static one. Returns whether there are
/// any.
fn begin_to_slide(frictional: &mut [Option<FrictionalContact>], found: &Accelerations) -> bool {
    let mut any = false;
    for (friction, tangent) in frictional.iter_mut().zip(&found.contacts) {
        let (Some(friction), Some(tangent)) = (friction, tangent) else { continue };
        let growth = tangent.slip_acceleration.length();
        let slides = friction.sliding.is_none() && tangent.slides && growth > STICKING_ACCELERATION * found.scale;
        if slides
            && friction.coefficients.sliding.is_below(friction.coefficients.at_rest)
            && let Some(direction) = tangent.begins_along()
        {
            *friction = friction.sliding_along(direction);
            any = true;
        }
    }
    any
}
