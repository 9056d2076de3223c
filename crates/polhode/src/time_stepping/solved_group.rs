//! The impulses of one group of bodies over a step: what they give and take, and how they are applied.
//!
//! Energy in the order of action is `sum p.(u + u+)/2`, with the rates `u` after the kick and `u+` after all impulses
//! (`shared_work.rs`). Where it grows with the impulses, because a slip turns within the step, they are shortened
//! together: a part `s` of them changes it by `s l + s^2 q`. Where no part takes energy, because a slip turns against a
//! spring, the step is divided where that slip stops. How it fails: where the slip has been stopped and no part takes
//! energy, none is applied, and the step says that its problem was not solved.

use super::contacts::{NearContact, kinematics_at_point};
use super::kick::Kick;
use super::row::Row;
use super::shared_work::Kicked;
use super::sustained_friction::Rubbing;
use crate::accounting::time_step_report::{Stop, TimeStepReport};
use crate::collision::moving_surfaces;
use crate::constraint::softness::SoftWork;
use crate::identity::contact_id::ContactId;
use crate::joints::bilateral::{Bilateral, Reaction};
use crate::model::Model;
use crate::model::states_of::{set_states, states_of};
use crate::rows::groups::Group;
use crate::solve::closed_loops::ClosedLoops;
use crate::solve::cone_violation::ConeViolation;
use crate::solve::reactions::{Gain, Reactions};
use polhode_contact::ContactGeometry;
use polhode_dynamics::BodyState;
use polhode_spatial::CompensatedSum;

/// The impulses of one group.
pub(super) struct SolvedGroup {
    pub(super) group: Group,
    pub(super) reactions: Reactions,
    /// What friction is counted with.
    pub(super) rubbing: Rubbing,
    pub(super) found: Found,
    /// The part of what was solved for that the impulses are: 1 where they were not shortened, 0 where none is applied.
    pub(super) share: f64,
}

/// How the impulses of one group were found.
pub(super) struct Found {
    /// Natural map, relative.
    pub(super) residual: f64,
    /// How far they are from Coulomb's law.
    pub(super) violation: Option<ConeViolation>,
    /// Slips that end within the step, at which it is divided.
    pub(super) stops: Vec<Stop>,
}

impl Found {
    /// Tells it in the report of the step.
    pub(super) fn tell(&self, report: &mut TimeStepReport) {
        report.residual = report.residual.max(self.residual);
        report.cone_violation = ConeViolation::larger(report.cone_violation, self.violation);
    }
}

impl SolvedGroup {
    /// Change of kinetic energy in the order of action, J, `sum p.(u + u+)/2` with the rates `u` after the kick and the
    /// present ones of the bodies: where large impulses cancel, these differ by rounding from the solution of the
    /// problem.
    pub(super) fn energy_change(&self, model: &Model, states: &[BodyState], rows: &[Row], near: &[NearContact]) -> f64 {
        let parts = self.group.contacts.iter().zip(&self.reactions.normal).filter(|(_, p)| **p > 0.0);
        let change = |(&index, &p): (&usize, &f64)| {
            let row = &rows[index];
            let after =
                kinematics_at_point(model, states, near[row.contact].id).map_or(-row.bound, |now| now.separation_rate);
            0.5 * p * (row.kinematics.separation_rate + after)
        };
        parts.map(change).collect::<CompensatedSum>().value()
    }

    /// The contacts with their geometry.
    pub(super) fn geometries<'a>(
        &'a self,
        rows: &'a [Row],
        near: &'a [NearContact],
    ) -> impl Iterator<Item = (ContactId, &'a ContactGeometry)> + Clone {
        self.group.contacts.iter().map(move |&index| (near[rows[index].contact].id, &rows[index].kinematics.geometry))
    }

    /// Energy lost to friction, J, with the present slips and rotations of the bodies.
    pub(super) fn lost_to_friction_j(&self, model: &Model, states: &[BodyState]) -> f64 {
        self.rubbing.lost_to_slip_j(&self.reactions, model, states)
            + self.rubbing.lost_to_moments_j(&self.reactions, model, states)
    }

    /// Work of surfaces that move, J.
    fn work_of_surfaces(&self, model: &Model, states: &[BodyState]) -> f64 {
        moving_surfaces::surface_work(model, states, self.reactions.along_tangents())
    }

    /// Works of springs, dampers and motors at joints, J.
    pub(super) fn soft_work(&self) -> SoftWork {
        let works = |(of, reaction): &(Bilateral, Reaction)| {
            let softness = of.softness.as_ref()?;
            Some(softness.works(of.multiplier(*reaction) / self.share, self.share))
        };
        self.reactions.bilaterals.iter().filter_map(works).fold(SoftWork::default(), |sum, one| sum + one)
    }

    /// Applies the impulses. Those that would add energy are shortened, all by one factor, until they add none: the
    /// terms r of their rows are then shorter. Where no part of them takes energy, none is applied, and their share is
    /// 0.
    pub(super) fn apply(
        &mut self,
        model: &Model,
        states: &mut [BodyState],
        of: (&[usize], &Kick, &ClosedLoops),
        rows: &[Row],
        near: &[NearContact],
    ) {
        let start = states_of(states, &self.group.bodies);
        let whole = self.try_out(model, states, of, rows, near);
        if whole.is_excess() {
            set_states(states, &self.group.bodies, &start);
            self.shorten(0.5);
            let half = self.try_out(model, states, of, rows, near);
            set_states(states, &self.group.bodies, &start);
            // With a part s of them the energy grows by s l + s^2 q.
            let linear = 4.0 * half.gain_j - whole.gain_j;
            let share = -linear / (whole.gain_j - linear);
            self.shorten(if share.is_finite() { 2.0 * share.clamp(0.0, 1.0) } else { 0.0 });
            let is_sound = share > 0.0 && !self.try_out(model, states, of, rows, near).is_excess();
            if !is_sound {
                set_states(states, &self.group.bodies, &start);
                self.reactions.clear();
                self.found.residual = self.residual_of_none(rows);
                self.share = 0.0;
            }
        }
        for &body in &self.group.bodies {
            model.keep_in_plane(body, &mut states[body]);
        }
    }

    /// The residual of no impulses: the largest rate by which a row is not kept, relative to the largest rate, term and
    /// fall of the rows. What rounding leaves of rows that press on each other between walls is none.
    fn residual_of_none(&self, rows: &[Row]) -> f64 {
        let members = || self.group.contacts.iter().map(|&index| &rows[index]);
        let closing = members().filter(|row| row.closes(row.kinematics.separation_rate));
        let missing = closing.map(|row| -(row.kinematics.separation_rate + row.bound)).fold(0.0, f64::max);
        let scale = |row: &Row| row.kinematics.separation_rate.abs().max(row.bound.abs()).max(row.half_fall.abs());
        let scale = members().map(scale).fold(0.0, f64::max);
        if scale > 0.0 { missing / scale } else { 0.0 }
    }

    /// Applies the impulses, and says what energy they add.
    fn try_out(
        &self,
        model: &Model,
        states: &mut [BodyState],
        (bodies, kick, loops): (&[usize], &Kick, &ClosedLoops),
        rows: &[Row],
        near: &[NearContact],
    ) -> Gain {
        let soft = self.soft_work();
        let by_soft = soft.spring + soft.damper + soft.motor;
        let kicked = Kicked { states, bodies, kick, loops };
        let by_reactions = self.reactions.of_bilaterals().map(|(of, impulse)| kicked.shared_by_reaction_j(of, impulse));
        let shared_j = kicked.shared_j(self.reactions.at_contacts(self.geometries(rows, near)))
            + kicked.shared_by_moments_j(self.reactions.of_rotations())
            + by_reactions.sum::<f64>();
        let others = self.work_of_surfaces(model, states) + by_soft + shared_j;
        self.reactions.apply_with_gain(model, states, (&self.group.bodies, self.geometries(rows, near)), others)
    }

    /// Leaves this part of the impulses.
    fn shorten(&mut self, part: f64) {
        self.share *= part;
        self.reactions.shorten(part);
    }
}
