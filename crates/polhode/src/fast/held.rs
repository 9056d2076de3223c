//! The joints of a group: their rows in the present poses, and what they give.
//!
//! The pivots and joints of the bodies and the limits of their coordinates become joints of
//! `polhode_response::sequential_impulses`. Rows are found anew after every movement, so that an axis that turns by
//! some degrees in a step is followed. The impulses of the last substep start the next step.
//!
//! Assumption: no member is kinematic, and no coordinate has forces of its own (`TierFeature::AllOfJoints` refuses
//! these). Failure: loads that need more rounds than there are sweeps leave gaps, which the certificate tells.

use crate::constraint::ConstraintId;
use crate::constraint::joint::pivot_rows;
use crate::constraint::row::{BilateralRow, Member, RowsAt};
use crate::identity::contact_id::ContactId;
use crate::joints::joint_contacts;
use crate::model::Model;
use crate::report::momentum_ledger::{Momentum, MomentumSum};
use polhode_dynamics::BodyState;
use polhode_response::law::MOST_ROWS;
use polhode_response::sequential_impulses::{
    BodyImpulse, ImpulseJoint, JointImpulses, JointLaw, JointRow, SequentialImpulses, SweepRule, Works,
};
use polhode_spatial::{DVec3, Velocity};

/// A joint or a pivot after a step: what the next one starts from, and what it has done.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HeldJoint {
    pub(super) id: ConstraintId,
    /// Impulses of its rows in the last substep, N s.
    pub(super) multipliers: [f64; MOST_ROWS],
    /// Mean force (N), and moment about the centre of mass (N m), on the body of this number in the last step.
    pub(super) body: usize,
    pub(super) force: DVec3,
    pub(super) moment: DVec3,
}

/// A limit that pressed in the last substep of a step: what the next one starts from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HeldLimit {
    pub(super) id: ContactId,
    /// Its impulse, N s.
    pub(super) multiplier: f64,
}

/// What a joint of the solver is.
#[derive(Debug, Clone, Copy)]
enum Source {
    Pivot(usize),
    /// The place of the joint in the world.
    Joint(usize),
    Limit(ContactId),
}

/// A joint of the solver: what it is of, its identity after the step (none of a limit), and the bodies of its two
/// sides.
#[derive(Debug, Clone, Copy)]
struct Known {
    source: Source,
    id: Option<ConstraintId>,
    sides: [Option<usize>; 2],
}

/// The joints of a group.
#[derive(Debug, Default)]
pub(super) struct Held {
    joints: JointImpulses,
    known: Vec<Known>,
    rows: Vec<JointRow>,
    support: MomentumSum,
}

impl Held {
    /// Whether there is none.
    pub(super) fn is_empty(&self) -> bool {
        self.joints.is_empty()
    }

    /// Takes the joints of these bodies, ascending, in these states. `numbers` are those of the bodies in the solver.
    pub(super) fn load(
        &mut self,
        (model, solver): (&Model, &SequentialImpulses),
        (states, bodies): (&[BodyState], &[usize]),
        numbers: &[u32],
    ) {
        self.joints.clear();
        self.known.clear();
        self.support = MomentumSum::default();
        if !model.joints.has_rows() {
            return;
        }
        let pivots = bodies.iter().filter(|&&body| model.bodies[body].held.is_some());
        let pivots = pivots.map(|&body| (Source::Pivot(body), Some(ConstraintId::Pivot { body })));
        let joints = model.joints.joint_places_among(bodies);
        let joints = joints.into_iter().map(|place| (Source::Joint(place), Some(model.joints.list[place].id())));
        for (source, id) in pivots.chain(joints) {
            let at = rows_at(model, states, source);
            let sides = [0, 1].map(|side| at.as_ref()?.members.get(side).map(|member| member.body));
            self.add(Known { source, id, sides }, JointLaw::Hold, at.map_or(0, |at| at.rows.len()), numbers);
        }
        for (a, b) in model.joints.joint_contact_pairs_among(bodies) {
            for &feature in model.joints.joint_contacts_of_pair((a, b)) {
                let id = ContactId { a, b, feature };
                let known = Known { source: Source::Limit(id), id: None, sides: [Some(a), id.second()] };
                self.add(known, JointLaw::Limit, 1, numbers);
            }
        }
        self.joints.prepare(solver);
    }

    fn add(&mut self, known: Known, law: JointLaw, rows: usize, numbers: &[u32]) {
        let bodies = known.sides.map(|body| body.map_or(SequentialImpulses::IMMOVABLE, |body| numbers[body]));
        self.joints.add(ImpulseJoint { bodies, law, rows });
        self.known.push(known);
    }

    /// The rows in these states.
    pub(super) fn find_rows(&mut self, model: &Model, solver: &SequentialImpulses, states: &[BodyState]) {
        for (number, known) in self.known.iter().enumerate() {
            self.rows.clear();
            if let Source::Limit(id) = known.source {
                self.rows.extend(limit_row(model, states, id));
            } else if let Some(at) = rows_at(model, states, known.source) {
                self.rows.extend(at.rows.iter().map(|row| row_of(row, &at.members)));
            }
            self.joints.set_rows(number, &self.rows);
        }
        self.joints.factor(solver);
    }

    /// Gives the impulses that are known from the last step, times `warm`.
    pub(super) fn start(&mut self, solver: &mut SequentialImpulses, last: (&[HeldJoint], &[HeldLimit]), warm: f64) {
        let (joints, limits) = last;
        for (number, known) in self.known.iter().enumerate() {
            let multipliers = if let Source::Limit(id) = known.source {
                let place = limits.binary_search_by_key(&id, |held| held.id).ok();
                place.map(|place| [limits[place].multiplier, 0.0, 0.0, 0.0, 0.0, 0.0])
            } else {
                let place = known.id.and_then(|id| joints.binary_search_by_key(&id, |held| held.id).ok());
                place.map(|place| joints[place].multipliers)
            };
            if let Some(multipliers) = multipliers {
                self.joints.set_multipliers(number, multipliers.map(|impulse| impulse * warm));
            }
        }
        self.joints.start(solver);
    }

    /// Starts a later substep: the impulses of the one before, which act again, are turned with the rows.
    pub(super) fn start_again(&mut self, solver: &mut SequentialImpulses) {
        self.joints.start(solver);
    }

    /// A sweep over all.
    pub(super) fn sweep(&mut self, solver: &mut SequentialImpulses, rule: &SweepRule) {
        self.joints.sweep(solver, rule);
    }

    /// How many joints were solved in the step, each as often as it was.
    pub(super) fn solved(&self) -> usize {
        self.joints.solved()
    }

    /// What has collided in the step parts again while the joints hold. Returns what all did.
    pub(super) fn bounce(
        &mut self,
        solver: &mut SequentialImpulses,
        rules: [&SweepRule; 2],
        states: &[BodyState],
    ) -> Works {
        let works = self.joints.bounce(solver, rules);
        if works != Works::default() {
            self.note_support(states);
        }
        works
    }

    /// Ends a substep. Returns what the joints did in it, J: what holds does no work but by its softness.
    pub(super) fn end_substep(&mut self, solver: &SequentialImpulses, states: &[BodyState]) -> f64 {
        let work = self.joints.end_substep(solver);
        self.note_support(states);
        work
    }

    /// What the world gives through joints, about its origin.
    fn note_support(&mut self, states: &[BodyState]) {
        for (number, known) in self.known.iter().enumerate() {
            let [Some(body), None] = known.sides else { continue };
            let BodyImpulse { linear, angular } = self.joints.given(number)[0];
            let angular = states[body].pose.translation.cross(linear) + angular;
            self.support.add(Momentum { linear, angular });
        }
    }

    /// Momentum from the world in the step, about its origin.
    pub(super) fn support(&self) -> Momentum {
        self.support.value()
    }

    /// The joints and pivots after a step, whose inverse length is given (1/s).
    pub(super) fn after(&self, inverse_step: f64) -> impl Iterator<Item = HeldJoint> + '_ {
        self.known.iter().enumerate().filter_map(move |(number, known)| {
            let (id, body) = (known.id?, known.sides[0]?);
            let BodyImpulse { linear, angular } = self.joints.total(number)[0];
            let (force, moment) = (linear * inverse_step, angular * inverse_step);
            Some(HeldJoint { id, multipliers: self.joints.multipliers(number), body, force, moment })
        })
    }

    /// The limits that pressed in the last substep.
    pub(super) fn limits_after(&self) -> impl Iterator<Item = HeldLimit> + '_ {
        self.known.iter().enumerate().filter_map(|(number, known)| {
            let Source::Limit(id) = known.source else { return None };
            let multiplier = self.joints.multipliers(number)[0];
            (multiplier > 0.0).then_some(HeldLimit { id, multiplier })
        })
    }
}

/// The rows of a pivot or a joint where the bodies are; rates are not asked for. None of a limit.
fn rows_at(model: &Model, states: &[BodyState], source: Source) -> Option<RowsAt> {
    let at = |body: usize| (states[body].pose, Velocity::default());
    match source {
        Source::Pivot(body) => {
            let held = model.bodies[body].held?;
            Some(pivot_rows((body, held.arm), held.place, at))
        }
        Source::Joint(place) => Some(model.joints.list[place].rows_at(at)),
        Source::Limit(_) => None,
    }
}

/// A row of these members for the solver.
fn row_of(row: &BilateralRow, members: &[Member]) -> JointRow {
    let mut own = JointRow { gap: row.gap, ..JointRow::default() };
    if let Some(first) = members.first() {
        (own.force, own.moments[0]) = row.entries(first);
    }
    if let Some(second) = members.get(1) {
        own.moments[1] = row.entries(second).1;
    }
    own
}

/// The row of a limit of a joint; none where its coordinate has no direction.
fn limit_row(model: &Model, states: &[BodyState], id: ContactId) -> Option<JointRow> {
    let geometry = joint_contacts::joint_contact_kinematics(model, states, id)?.geometry;
    let moment = |body: usize| (geometry.point - states[body].pose.translation).cross(geometry.normal);
    let second = id.second().map_or(DVec3::ZERO, |second| -moment(second));
    Some(JointRow { force: geometry.normal, moments: [moment(id.a), second], gap: geometry.separation })
}
