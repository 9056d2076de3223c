//! Friction of sustained contacts over a step, at velocity level.
//!
//! In the middle of the step, after a free flight of h/2, let `u-` be the slip of a contact before the kick of fields
//! and `u+` after all impulses, `a` the part of its rate that is due to neither. The slip at the end is `u+ + r` with
//! `r = h/2 a`. Coulomb's law holds for that slip and the impulses of the step: it is zero where `|p_t| <= mu p_n` can
//! make it zero, and opposite to `p_t = -mu p_n u / |u|` otherwise. A body that rests on a slope ends exactly where it
//! began: `u- = r`, `u+ = -r`, and the ways of both halves of the step cancel.
//!
//! Without a kick impulses that stick do the work `p_t.(u- + u+)/2 = -(|u-|^2 - |r|^2) / 2G`. So that none is gained,
//! `r` is shortened to the length of `u-` where it is longer.
//!
//! A contact without slip at the start of the step bears up to its static coefficient. If it slides nevertheless, the
//! problem is solved again with its kinetic one. A contact that slips at the start has the kinetic coefficient. Where
//! the static one is larger, a slip that passes through zero within the step would be turned round by a load that
//! static friction bears. Under the load and the kinetic friction against the slip `u0` at the start the slip is linear
//! in time, `u(s) = u0 + s d`, and vanishes at the part `s = -u0.d/|d|^2` of the step: the step is made in two parts
//! there ([`Stop`]). The change `d` is that of a second solution, in which all slips are pushed on along their
//! directions at the start: it has what joints, springs and other contacts give. The impulse that ends the first part
//! without slip is within the static cone, and the second part begins without slip.
//!
//! Friction of rolling and of spinning holds the relative rotation of the bodies after the impulses at zero, or
//! resists it by a moment of its largest size (`crate::solve::rotational_friction`).

use super::cone_problem::{ConeSolvers, KnownOfGroup, is_off};
use super::contacts::kinematics_at_point;
use super::middle::Stops;
use super::shared_work::Kicked;
use crate::accounting::time_step_report::Stop;
use crate::collision::contact_kinematics;
use crate::collision::friction_mode::FrictionCoefficients;
use crate::collision::slip_directions::SlipDirections;
use crate::collision::turn::Turn;
use crate::identity::contact_id::ContactId;
use crate::joints::joint_friction::MOST_ROUNDS_OF_BEARINGS;
use crate::model::{Model, tolerances};
use crate::rows::assembly::{Assembly, TangentRow};
use crate::rows::friction_blocks::push_contact;
use crate::rows::frictional_contact::FrictionalContact;
use crate::rows::resisted_rotation::{ResistedRotation, with_rotations};
use crate::rows::rotation_row::RotationRow;
use crate::scene::FrictionEllipse;
use crate::solve::cone_violation::{ConeViolation, RubbingForce, largest_violation};
use crate::solve::reactions::{Reactions, TangentReaction};
use polhode_contact::{ContactGeometry, ContactKinematics};
use polhode_dynamics::BodyState;
use polhode_response::friction::ContactStatus;
use polhode_response::{Blocks, BlocksSolution, ResponseError, SolverReport};
use polhode_spatial::{CompensatedSum, DVec3};
use std::ops::Range;

/// A slip below this fraction of what a step may change it by is none (1e-6 to 1e-4): contacts that stick are left with
/// the residual of the solver, at most that which is accepted (`polhode_response::solve::step`).
const STICKING_RELATIVE: f64 = 1e-5;

/// How much faster than anything in a step slips are pushed on, to find where they stop (no unit, 10 to 1000): no
/// friction turns them then, and the residual of the solver is that much larger in relation to the slips.
const BEYOND_TURNING: f64 = 100.0;

/// Friction of a contact in the middle of a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct TangentialRow {
    coefficients: FrictionCoefficients,
    /// Whether it has no slip at the start of the step, or comes to rest at its end.
    sticks: bool,
    /// The whole change of the slip in half a step without contact forces along the tangents, m/s.
    whole_change: [f64; 2],
    /// What a step may change a slip by, m/s.
    given: f64,
    /// Rows along both tangents.
    along: [TangentRow; 2],
    /// Those along which the bodies may slip.
    slips: SlipDirections,
    /// From the contact to where its rows along the tangents act in a patch, m.
    offset: Option<DVec3>,
    /// The slip after the kick of fields, along the tangents, m/s.
    slip: [f64; 2],
    /// By how much the kick has changed the relative velocity at the contact, m/s, and the relative rotation, rad/s.
    kicked: (DVec3, DVec3),
    /// `r` along the tangents, m/s.
    half_change: [f64; 2],
    /// The normal, for rotations.
    normal: DVec3,
    /// `w-`, the angular velocity of A relative to B, rad/s.
    rotation: DVec3,
    /// The length in the rows of rotations, m.
    turning_length: f64,
    /// Friction of rolling and of spinning in these rows (no unit).
    rotational: [Option<f64>; 2],
}

impl TangentialRow {
    /// That of a contact in these states; its rates of slip are not known yet. None without friction.
    pub(super) fn of(
        model: &Model,
        states: &[BodyState],
        id: ContactId,
        (kinematics, kicked): (&ContactKinematics, Kicked<'_>),
    ) -> Option<Self> {
        let own = FrictionalContact::of(model, states, (id, kinematics.geometry), None)?;
        let FrictionalContact { terms, coefficients, slip: slips, .. } = own;
        let along = terms.basis.map(|tangent| own.row_along(tangent));
        let slip = terms.basis.map(|tangent| tangent.dot(terms.slip_velocity));
        let rotational = Turn::ALL.map(|turn| turn.coefficient(model, (id.a, id.b)));
        let turning_length = tolerances::turning_length(model, id.a, id.b);
        let rotation = contact_kinematics::relative_rotation(model, states, id);
        let normal = kinematics.geometry.normal;
        let kicked = (kicked.change_at(id, kinematics.geometry.point), kicked.change_of_rotation(id));
        let half_change = [0.0; 2];
        Some(Self {
            coefficients,
            sticks: false,
            whole_change: [0.0; 2],
            given: 0.0,
            along,
            slips,
            offset: None,
            slip,
            kicked,
            half_change,
            normal,
            rotation,
            turning_length,
            rotational,
        })
    }

    /// The rows along the tangents.
    pub(super) fn along(&self) -> impl Iterator<Item = TangentRow> + use<> {
        self.along.into_iter().take(self.slips.count())
    }

    /// The contact.
    pub(super) fn id(&self) -> ContactId {
        self.along[0].id
    }

    /// The relative velocity of the bodies where its rows act, in the present states, m/s; beside those along its
    /// tangents its components are of no use.
    fn present_slip(&self, model: &Model, states: &[BodyState]) -> Option<DVec3> {
        let slip = contact_kinematics::tangential_kinematics(model, states, self.id())?.slip_velocity;
        let Some(offset) = self.offset else { return Some(slip) };
        let now = kinematics_at_point(model, states, self.id())?;
        let approach = now.geometry.normal * now.separation_rate;
        Some(slip + approach + contact_kinematics::relative_rotation(model, states, self.id()).cross(offset))
    }

    /// How many there are.
    pub(super) const fn tangents(&self) -> usize {
        self.slips.count()
    }

    /// The tangents of its patch with other contacts, with this mean normal.
    pub(super) fn tangents_of_patch(&self, normal: DVec3) -> [DVec3; 2] {
        match self.slips {
            SlipDirections::Both => normal.any_orthonormal_pair().into(),
            SlipDirections::First => {
                let across = self.along[1].along.normal;
                [across.cross(normal), across]
            }
        }
    }

    /// The same with its slip at the start of a step of `h` (s), m/s, and the rates of its slip without contact forces,
    /// m/s^2. In the first half of the step the separation changes its rate by `half_fall` (m/s).
    pub(super) fn with_rates(self, (at_start, rates): (f64, [f64; 2]), h: f64, half_fall: f64) -> Self {
        let change = rates.map(|rate| 0.5 * h * rate);
        let given = libm::hypot(change[0], change[1]) + self.coefficients.at_rest.largest() * half_fall.abs();
        let sticks = at_start <= STICKING_RELATIVE * given;
        let whole = Self { half_change: change, whole_change: change, given, sticks, ..self };
        let share = whole.share();
        Self { half_change: change.map(|change| share * change), ..whole }
    }

    /// The same contact, which comes to rest at the end of the step.
    pub(super) fn coming_to_rest(self) -> Self {
        Self { sticks: true, ..self }
    }

    /// Whether static friction holds more than kinetic.
    fn holds_more_at_rest(&self) -> bool {
        self.coefficients.sliding.is_below(self.coefficients.at_rest)
    }

    /// The slip at the start of the step along the tangents, m/s.
    fn slip_at_start(&self) -> [f64; 2] {
        let before = self.slip_before();
        [before[0] - self.whole_change[0], before[1] - self.whole_change[1]]
    }

    /// Whether its slip has stopped or turned within the step, with these velocities of its rows at the end.
    fn has_turned(&self, [u, v]: [f64; 2]) -> bool {
        let [x, y] = self.slip_at_start();
        !self.sticks && x * u + y * v <= STICKING_RELATIVE * self.given * libm::hypot(x, y)
    }

    /// The same with the whole change of its slip, which may gain energy, and faster by `offset` (m/s) along the slip
    /// at the start: a slip that does not turn then, so that friction is the kinetic one against it to the end of the
    /// step.
    fn slipping_on(self, offset: f64) -> Self {
        let half_change = self.offset_along_slip(offset);
        Self { half_change: [0, 1].map(|axis: usize| self.whole_change[axis] + half_change[axis]), ..self }
    }

    /// A velocity (m/s) along the slip at the start; none where it sticks.
    fn offset_along_slip(&self, offset: f64) -> [f64; 2] {
        let [x, y] = self.slip_at_start();
        let length = libm::hypot(x, y);
        if self.sticks || length == 0.0 { [0.0; 2] } else { [x, y].map(|part| offset * part / length) }
    }

    /// At which part of the step (0 to 1) its slip passes through zero if it has changed to `end` (m/s) at the end,
    /// linear in time.
    fn stops_at(&self, end: [f64; 2]) -> Option<f64> {
        let [x, y] = self.slip_at_start();
        let [dx, dy] = [end[0] - x, end[1] - y];
        let part = -(x * dx + y * dy) / (dx * dx + dy * dy);
        let nearest = libm::hypot(x + part * dx, y + part * dy);
        // NaN, without a change, gives none.
        (part > 0.0 && part < 1.0 && nearest <= STICKING_RELATIVE * self.given).then_some(part)
    }

    /// Whether the coefficient is the same along all tangents.
    pub(super) fn is_isotropic(&self) -> bool {
        [self.coefficients.at_rest, self.coefficients.sliding].into_iter().all(FrictionEllipse::is_circle)
    }

    /// The same as one of the contacts of a patch, which have these tangents (unit vectors, world), at this point of
    /// its plane (m, world). `approach` is the part of the relative velocity along its own normal (m/s, world).
    pub(super) fn on_patch(self, tangents: [DVec3; 2], point: DVec3, approach: DVec3) -> Self {
        let offset = point - self.along[0].along.point;
        let vector = |[x, y]: [f64; 2]| self.along[0].along.normal * x + self.along[1].along.normal * y;
        let slip = vector(self.slip) + approach + self.rotation.cross(offset);
        let (velocity, rotation) = self.kicked;
        let kicked = (velocity + rotation.cross(offset), rotation);
        let bias = vector(self.along.map(|row| row.acceleration_bias));
        let components = |vector: DVec3| tangents.map(|tangent| tangent.dot(vector));
        let mut along = self.along;
        for ((row, tangent), acceleration_bias) in along.iter_mut().zip(tangents).zip(components(bias)) {
            let geometry = ContactGeometry { point, normal: tangent, ..row.along };
            *row = TangentRow { along: geometry, acceleration_bias, ..*row };
        }
        let (slip, whole_change) = (components(slip), components(vector(self.whole_change)));
        let half_change = components(vector(self.half_change));
        Self { along, offset: Some(offset), slip, kicked, whole_change, half_change, ..self }
    }

    /// `r` as a vector, m/s.
    pub(super) fn half_change(&self) -> DVec3 {
        self.along.iter().zip(self.half_change).map(|(row, change)| row.along.normal * change).sum()
    }

    /// The same with the part of this `r` (m/s) along its tangents.
    pub(super) fn with_half_change(self, change: DVec3) -> Self {
        let change = self.along.map(|row| row.along.normal.dot(change));
        Self { half_change: change, ..self }
    }

    /// By how much the kick has changed the slip, along the tangents, m/s.
    fn change_by_kick(&self) -> [f64; 2] {
        self.along.map(|row| row.along.normal.dot(self.kicked.0))
    }

    /// `u-` along the tangents, m/s.
    fn slip_before(&self) -> [f64; 2] {
        let [x, y] = self.change_by_kick();
        [self.slip[0] - x, self.slip[1] - y]
    }

    /// The longest part of `r` that gains no energy (no unit, at most 1).
    pub(super) fn share(&self) -> f64 {
        let [before, length] = [self.slip_before(), self.half_change].map(|[x, y]| libm::hypot(x, y));
        if length > before { before / length } else { 1.0 }
    }

    /// The coefficient that limits its force at first.
    fn coefficient(&self) -> FrictionEllipse {
        if self.sticks { self.coefficients.at_rest } else { self.coefficients.sliding }
    }

    /// Whether its kinetic coefficient is another than the one at first.
    fn is_held_by_static_friction(&self) -> bool {
        self.sticks && self.coefficients.sliding.is_below(self.coefficients.at_rest)
    }

    /// The axes of its rows of rotation of each kind that friction resists, times their length (m), with that friction
    /// (no unit).
    fn rotations(&self) -> impl Iterator<Item = (Turn, f64, Vec<DVec3>)> + '_ {
        let basis = self.along.map(|row| row.along.normal);
        let of = move |(turn, friction): (Turn, &Option<f64>)| {
            let axes = turn.axes(self.normal, (&basis, self.slips)).into_iter().map(|axis| axis * self.turning_length);
            Some((turn, (*friction)?, axes.collect()))
        };
        Turn::ALL.into_iter().zip(&self.rotational).filter_map(of)
    }

    /// `w-` of these rows.
    fn rotation_constants(&self) -> Vec<f64> {
        self.rotations().flat_map(|(.., axes)| axes).map(|axis| axis.dot(self.rotation)).collect()
    }

    /// Constant terms of both tangents.
    fn of_both_tangents(&self) -> [f64; 2] {
        [self.slip[0] + self.half_change[0], self.slip[1] + self.half_change[1]]
    }

    /// Constant terms of its rows along the tangents.
    fn constants(&self) -> impl Iterator<Item = f64> + use<> {
        self.of_both_tangents().into_iter().take(self.slips.count())
    }
}

/// Rows of friction whose impulses are among some reactions: what their work is counted with.
#[derive(Debug, Default)]
pub(super) struct Rubbing {
    /// Of the contacts with friction, in the order of their reactions along tangents.
    rows: Vec<TangentialRow>,
    /// Of each moment the rotation before, rad/s.
    rotations_before: Vec<DVec3>,
}

impl Rubbing {
    /// Each contact with friction, and its impulses along tangents.
    pub(super) fn of_contacts<'a>(
        &'a self,
        reactions: &'a Reactions,
    ) -> impl Iterator<Item = (&'a TangentialRow, &'a [TangentReaction])> {
        let mut left = &reactions.tangential[..];
        self.rows.iter().map_while(move |row| {
            let (own, others) = left.split_at_checked(row.slips.count())?;
            left = others;
            Some((row, own))
        })
    }

    /// Energy lost to friction of slip in the order of action, J: `-p.(u + u+)/2` with the slips after the kick and, in
    /// the present states, after all impulses.
    pub(super) fn lost_to_slip_j(&self, reactions: &Reactions, model: &Model, states: &[BodyState]) -> f64 {
        let lost = |(row, own): (&TangentialRow, &[TangentReaction])| {
            let slip = row.present_slip(model, states)?;
            let of_row =
                |(own, before): (&TangentReaction, f64)| -0.5 * own.value * (before + own.along.normal.dot(slip));
            Some(own.iter().zip(row.slip).map(of_row).sum::<f64>())
        };
        self.of_contacts(reactions).filter_map(lost).collect::<CompensatedSum>().value()
    }

    /// Energy lost to friction of rolling and spinning, J: `-p.(w- + w+)/2` with the rotations in these states.
    pub(super) fn lost_to_moments_j(&self, reactions: &Reactions, model: &Model, states: &[BodyState]) -> f64 {
        let lost = |(&(id, moment), before): (&(ContactId, DVec3), &DVec3)| {
            -0.5 * moment.dot(*before + contact_kinematics::relative_rotation(model, states, id))
        };
        reactions.moments.iter().zip(&self.rotations_before).map(lost).collect::<CompensatedSum>().value()
    }
}

/// Impulses of contacts, some of them with friction.
#[derive(Debug)]
pub(super) struct FrictionalImpulses {
    pub(super) reactions: Reactions,
    pub(super) rubbing: Rubbing,
    /// Contacts that come to rest within the step, among those that are asked for.
    pub(super) stops: Vec<Stop>,
    /// How far they are from Coulomb's law.
    pub(super) violation: Option<ConeViolation>,
    pub(super) report: SolverReport,
    /// Factorisations in the velocities of bodies; 0 where the matrix of all rows was formed.
    pub(super) factorisations: usize,
}

/// How far impulses are from Coulomb's law.
fn violation_of(friction: &[Option<TangentialRow>], rows: &[Range<usize>], reactions: &[f64]) -> Option<ConeViolation> {
    let rubbing = |(contact, row): (usize, &Option<TangentialRow>)| {
        let row = row.as_ref()?;
        let (ellipse, id) = (row.coefficient(), row.id());
        let normal = reactions.get(contact).copied()?;
        let tangential = ellipse.length(reactions.get(rows.get(contact)?.clone())?);
        Some(RubbingForce { pair: (id.a, id.b), normal, tangential, friction: ellipse.largest() })
    };
    largest_violation(friction.iter().enumerate().filter_map(rubbing), 0.0)
}

/// Solves for the impulses of contacts whose normal rows `assembly` holds, and of its bilateral constraints, with these
/// constant terms (m/s).
///
/// # Errors
/// When a number is not finite.
pub(super) fn solve(
    mut assembly: Assembly,
    states: &[BodyState],
    mut constants: Vec<f64>,
    friction: &[Option<TangentialRow>],
    known: &KnownOfGroup,
    (solvers, h, stops_are): (&mut ConeSolvers, f64, Stops<'_>),
) -> Result<FrictionalImpulses, ResponseError> {
    let first_tangent = assembly.first_tangent();
    let mut rows = Vec::with_capacity(friction.len());
    for friction in friction {
        let first = assembly.problem.len();
        assembly.push_tangents(states, friction.iter().flat_map(TangentialRow::along))?;
        constants.extend(friction.iter().flat_map(TangentialRow::constants));
        let tangents = first..assembly.problem.len();
        rows.push(tangents);
    }
    let rotations = resisted_rotations(&mut assembly, friction)?;
    constants.extend(friction.iter().flatten().flat_map(TangentialRow::rotation_constants));
    let rows = FrictionRows { tangents: rows, rotations, first_tangent };
    let mut factorisations = 0;
    let settled = settle(&mut assembly, constants.clone(), (friction, known), &rows, (&mut *solvers, h))?;
    factorisations += settled.factorisations;
    let mut stops = Vec::new();
    let turned = turned(friction, &rows.tangents, &settled.solved, stops_are);
    if !turned.is_empty() {
        let (found, more) =
            stops_of(&turned, &mut assembly, (&constants, &settled), (friction, known, &rows), (solvers, h))?;
        factorisations += more;
        stops = found;
    }
    let Settled { friction, solved, .. } = settled;
    let rows = rows.tangents;
    let violation = violation_of(&friction, &rows, &solved.reactions);
    let reactions = Reactions::of(&assembly, friction.len(), &assembly.least(&solved.reactions)?);
    let rotation = |id: ContactId| friction.iter().flatten().find(|row| row.id() == id).map(|row| row.rotation);
    let rotations_before = reactions.moments.iter().map(|(id, _)| rotation(*id).unwrap_or_default()).collect();
    let rubbing = Rubbing { rows: friction.iter().flatten().copied().collect(), rotations_before };
    Ok(FrictionalImpulses { reactions, rubbing, stops, violation, report: solved.report, factorisations })
}

/// The rows of friction in a problem.
struct FrictionRows {
    /// Of each contact along its tangents.
    tangents: Vec<Range<usize>>,
    rotations: Vec<ResistedRotation>,
    first_tangent: usize,
}

/// Reactions, with the coefficients under which contacts bear them.
struct Settled {
    friction: Vec<Option<TangentialRow>>,
    solved: BlocksSolution,
    factorisations: usize,
}

/// Solves until no contact slides that is held by static friction, and loads of bearings stay.
fn settle(
    assembly: &mut Assembly,
    mut constants: Vec<f64>,
    (first, known): (&[Option<TangentialRow>], &KnownOfGroup),
    rows: &FrictionRows,
    (solvers, h): (&mut ConeSolvers, f64),
) -> Result<Settled, ResponseError> {
    let FrictionRows { tangents, rotations, first_tangent } = rows;
    let (mut rounds, mut factorisations) = (0, 0);
    loop {
        let mut friction: Vec<Option<TangentialRow>> = first.to_vec();
        let mut problem = solvers.problem(assembly, &constants, known, h)?;
        let mut solved = loop {
            let mut blocks = with_rotations(blocks(&friction, tangents), rotations);
            blocks.hold(friction.len()..*first_tangent);
            let solved = problem.solve(&blocks, |reactions| is_off(violation_of(&friction, tangents, reactions)))?;
            if !slide_under_static_friction(&mut friction, tangents, &solved, &constants) {
                break solved;
            }
        };
        factorisations += problem.factorisations();
        if problem.is_started_from() {
            solvers.last.note(assembly, &solved.reactions, friction.len(), h);
        }
        rounds += 1;
        let is_found = !assembly.press_by_loads(&solved.reactions, h)?;
        if is_found || rounds == MOST_ROUNDS_OF_BEARINGS {
            solved.report.residual =
                solved.report.residual.max(assembly.unfound_loads().map_or(0.0, |(change, _)| change));
            return Ok(Settled { friction, solved, factorisations });
        }
        assembly.press(&mut constants, h);
    }
}

/// Constant terms with those of these contacts along tangents.
fn with_tangents(constants: &[f64], friction: &[Option<TangentialRow>], rows: &FrictionRows) -> Vec<f64> {
    let mut constants = constants.to_vec();
    for (row, tangents) in friction.iter().zip(&rows.tangents) {
        let own = row.iter().flat_map(TangentialRow::constants);
        constants[tangents.clone()].iter_mut().zip(own).for_each(|(constant, own)| *constant = own);
    }
    constants
}

/// What values have along both tangents of a contact with these rows: zero along the one that has none.
fn of_both(values: &[f64], rows: &Range<usize>) -> [f64; 2] {
    let mut own = rows.clone().map(|row| values.get(row).copied().unwrap_or_default());
    [(); 2].map(|()| own.next().unwrap_or_default())
}

/// The contacts (by place) whose slips have stopped or turned at the end of the step, among those that are asked for.
fn turned(
    friction: &[Option<TangentialRow>],
    rows: &[Range<usize>],
    solved: &BlocksSolution,
    asked: Stops<'_>,
) -> Vec<usize> {
    let is_asked = |row: &TangentialRow| match asked {
        Stops::Sought => row.holds_more_at_rest(),
        Stops::SoughtOfAll => true,
        Stops::At(_) => false,
    };
    let has_turned = |row: &TangentialRow, rows| is_asked(row) && row.has_turned(of_both(&solved.velocities, rows));
    let contacts = friction.iter().zip(rows).enumerate();
    let turned = contacts.filter(|(_, (row, rows))| row.as_ref().is_some_and(|row| has_turned(row, rows)));
    turned.map(|(place, _)| place).collect()
}

/// Where the slips of these contacts (by place) pass through zero within the step, and the factorisations of the solve
/// that tells it: with all slips pushed on along their directions at the start, so that friction is kinetic to the end.
fn stops_of(
    turned: &[usize],
    assembly: &mut Assembly,
    (constants, settled): (&[f64], &Settled),
    (friction, known, rows): (&[Option<TangentialRow>], &KnownOfGroup, &FrictionRows),
    (solvers, h): (&mut ConeSolvers, f64),
) -> Result<(Vec<Stop>, usize), ResponseError> {
    let changes = settled.solved.velocities.iter().zip(constants).map(|(after, before)| after.abs() + before.abs());
    let offset = BEYOND_TURNING * changes.fold(0.0, f64::max);
    let on: Vec<_> = friction.iter().map(|row| row.map(|row| row.slipping_on(offset))).collect();
    let mut of_on = with_tangents(constants, &on, rows);
    // Bearings bear what the first solution has found.
    assembly.press(&mut of_on, h);
    let found = settle(assembly, of_on, (&on, known), rows, (solvers, h))?;
    let stop = |&place: &usize| {
        let (row, rows) = (friction.get(place)?.as_ref()?, rows.tangents.get(place)?);
        let (pushed, along) = (of_both(&found.solved.velocities, rows), row.offset_along_slip(offset));
        let part = row.stops_at([pushed[0] - along[0], pushed[1] - along[1]])?;
        Some(Stop { id: row.id(), part })
    };
    Ok((turned.iter().filter_map(stop).collect(), found.factorisations))
}

/// Adds the rows of rotations that friction resists.
fn resisted_rotations(
    assembly: &mut Assembly,
    friction: &[Option<TangentialRow>],
) -> Result<Vec<ResistedRotation>, ResponseError> {
    let mut resisted = Vec::new();
    for (normal, friction) in friction.iter().enumerate() {
        let Some(friction) = friction else { continue };
        let id = friction.id();
        for (turn, friction, axes) in friction.rotations() {
            let first = assembly.problem.len();
            assembly.push_rotations(axes.into_iter().map(|axis| RotationRow { id, axis }))?;
            let rows = first..assembly.problem.len();
            resisted.push(ResistedRotation { normal, turn, rows, friction, turns: false });
        }
    }
    Ok(resisted)
}

/// The blocks of contacts with these rows along tangents.
fn blocks(friction: &[Option<TangentialRow>], rows: &[Range<usize>]) -> Blocks {
    let mut blocks = Blocks::default();
    for (normal, (friction, tangents)) in friction.iter().zip(rows).enumerate() {
        let ellipse = friction.map_or(FrictionEllipse::default(), |friction| friction.coefficient());
        push_contact(&mut blocks, ellipse, normal, tangents.clone());
    }
    blocks
}

/// Gives contacts that slide although static friction holds them their kinetic coefficient. Returns whether there are
/// any. A contact at the limit of its cone without slip does not slide: where several contacts share a load that
/// friction bears, the part of each is not determined.
fn slide_under_static_friction(
    friction: &mut [Option<TangentialRow>],
    rows: &[Range<usize>],
    solved: &BlocksSolution,
    constants: &[f64],
) -> bool {
    let scale = constants.iter().fold(0.0, |most: f64, constant| most.max(constant.abs()));
    let mut any = false;
    for ((friction, status), tangents) in friction.iter_mut().zip(&solved.statuses).zip(rows) {
        let Some(friction) = friction.as_mut().filter(|friction| friction.is_held_by_static_friction()) else {
            continue;
        };
        let slip = tangents.clone().fold(0.0, |sum: f64, row| libm::hypot(sum, solved.velocities[row]));
        if *status == ContactStatus::Slide && slip > STICKING_RELATIVE * scale {
            friction.sticks = false;
            any = true;
        }
    }
    any
}
