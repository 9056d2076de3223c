//! The joints of a group: their rows in the present poses, and what they give.
//!
//! The bilateral constraints of the bodies (`World::bilaterals`: pivots and joints) and the limits of their coordinates become joints of
//! `polhode_response::sequential_impulses`. Rows are found anew after every movement, so that an axis that turns by some degrees in a step is
//! followed. The impulses of holding rows start the next step; limits start from nothing.
//!
//! Assumption: no member is kinematic, and no coordinate has forces of its own (`TierFeature::AllOfJoints` refuses these). Failure: loads that need
//! more rounds than there are sweeps leave gaps, which the certificate tells.

use crate::collision::contact_id::ContactId;
use crate::constraint::ConstraintId;
use crate::constraint::bilateral::Bilateral;
use crate::world::World;
use crate::{Momentum, MomentumSum};
use polhode_dynamics::BodyState;
use polhode_response::sequential_impulses::{
    BodyImpulse, ImpulseJoint, JointImpulses, JointLaw, JointRow, MOST_JOINT_ROWS, SequentialImpulses, SweepRule,
};
use polhode_spatial::DVec3;

/// A joint or a pivot after a step: what the next one starts from, and what it has done.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HeldJoint {
    pub(super) id: ConstraintId,
    /// Impulses of its rows in the last substep, N s.
    pub(super) multipliers: [f64; MOST_JOINT_ROWS],
    /// Mean force (N), and moment about the centre of mass (N m), on the body of this number in the last step.
    pub(super) body: usize,
    pub(super) force: DVec3,
    pub(super) moment: DVec3,
}

/// What a joint of the solver is: of a constraint, none of a limit; and the bodies of its two sides.
#[derive(Debug, Clone, Copy)]
struct Known {
    id: Option<ConstraintId>,
    sides: [Option<usize>; 2],
}

/// The joints of a group.
#[derive(Debug, Default)]
pub(super) struct Held {
    joints: JointImpulses,
    known: Vec<Known>,
    support: MomentumSum,
}

impl Held {
    /// Whether there is none.
    pub(super) fn is_empty(&self) -> bool {
        self.joints.is_empty()
    }

    /// Removes all.
    pub(super) fn clear(&mut self) {
        self.joints.clear();
        self.known.clear();
        self.support = MomentumSum::default();
    }

    /// The rows of these bodies, ascending, in these states. `numbers` are those of the bodies in the solver.
    pub(super) fn find_rows(
        &mut self,
        (world, solver): (&World, &SequentialImpulses),
        (states, bodies): (&[BodyState], &[usize]),
        numbers: &[u32],
    ) {
        if !world.has_rows() {
            return;
        }
        let mut place = 0;
        let mut set = |known: Known, law: JointLaw, rows: &[JointRow]| {
            let mut joint = ImpulseJoint {
                bodies: known.sides.map(|body| body.map_or(SequentialImpulses::IMMOVABLE, |body| numbers[body])),
                law,
                rows: [JointRow::default(); MOST_JOINT_ROWS],
                count: rows.len(),
            };
            joint.rows.iter_mut().zip(rows).for_each(|(to, row)| *to = *row);
            self.joints.set(solver, place, joint);
            if self.known.len() == place {
                self.known.push(known);
            }
            place += 1;
        };
        for bilateral in world.bilaterals(states, bodies) {
            let rows = rows_of(&bilateral);
            let sides = [0, 1].map(|side| bilateral.members.get(side).map(|member| member.body));
            set(Known { id: Some(bilateral.id), sides }, JointLaw::Hold, &rows);
        }
        for (a, b) in world.joint_contact_pairs_among(bodies) {
            for &feature in world.joint_contacts_of_pair((a, b)) {
                let id = ContactId { a, b, feature };
                let sides = [Some(a), id.second()];
                let row = world.joint_contact_kinematics(states, id).map(|at| {
                    let (normal, point) = (at.geometry.normal, at.geometry.point);
                    let forces = [normal, if id.second().is_some() { -normal } else { DVec3::ZERO }];
                    let arm = |body: usize| point - states[body].pose.translation;
                    JointRow {
                        forces,
                        moments: [arm(a).cross(forces[0]), arm(b).cross(forces[1])],
                        gap: at.geometry.separation,
                    }
                });
                set(Known { id: None, sides }, JointLaw::Limit, row.as_slice());
            }
        }
    }

    /// Gives the impulses that are known from the last step, times `warm`.
    pub(super) fn start(&mut self, solver: &mut SequentialImpulses, last: &[HeldJoint], warm: f64) {
        for (number, known) in self.known.iter().enumerate() {
            let Some(id) = known.id else { continue };
            if let Ok(place) = last.binary_search_by_key(&id, |held| held.id) {
                self.joints.start(solver, number, last[place].multipliers.map(|impulse| impulse * warm));
            }
        }
    }

    /// Starts a later substep: the impulses of the one before, which act again, are turned with the rows.
    pub(super) fn start_again(&mut self, solver: &mut SequentialImpulses) {
        self.joints.start_again(solver);
    }

    /// A sweep over all.
    pub(super) fn sweep(&mut self, solver: &mut SequentialImpulses, rule: &SweepRule) {
        self.joints.sweep(solver, rule);
    }

    /// After an impact at the end of the step the joints hold again. Returns their work, J.
    pub(super) fn hold_after_impact(
        &mut self,
        solver: &mut SequentialImpulses,
        rule: &SweepRule,
        states: &[BodyState],
    ) -> f64 {
        let work = self.joints.hold_after_impact(solver, rule);
        self.note_support(states);
        work
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
}

/// The rows of a constraint.
fn rows_of(bilateral: &Bilateral) -> Vec<JointRow> {
    let of = |row: &crate::constraint::row::BilateralRow| {
        let mut own = JointRow { gap: row.gap, ..JointRow::default() };
        for (side, member) in bilateral.members.iter().take(2).enumerate() {
            (own.forces[side], own.moments[side]) = row.entries(member);
        }
        own
    };
    bilateral.rows.iter().map(of).collect()
}
