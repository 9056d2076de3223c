//! Holds a run to what its tier promises (`crate::scene::promise` has the quantities and their limits).
//!
//! Every step, impact, projection and sample records what it measures in the accounts, with bodies, time and limit; the
//! end of the run compares. A run that exceeds a limit is
//! [`Outcome::Degraded`](crate::report::run_report::Outcome::Degraded), and its first warnings say by how much, which
//! bodies, when, and what would help.
//!
//! | quantity | limit |
//! |---|---|
//! | penetration of a pair | `overlap s + 18 ulp`, plus the approach during four units of the time of an impact |
//! | gap of a joint | `gap s + 18 ulp`; a rotation `gap` rad |
//! | displacement by one projection, under error control | `overlap s + 40 ulp` |
//! | energy that projections take or give, in all | `energy E` |
//! | energy of the method, in all | `energy E`; under error control at least 10 tolerances E for each longest step |
//! | both in stretches of crowded events | the tolerance of crowding times E for each longest step |
//! | residual of a problem at an instant | that of the promise, at least what rounding of its terms leaves |
//! | residual of a time step, violation of Coulomb's law, estimated error | those of the promise |
//!
//! s: size of the smaller body of the pair, m; ulp: unit in the last place of the largest coordinate of the two, m; E:
//! the largest energy of the run, at least that of lifting all bodies by their size, J. Integrators of fixed steps that
//! a scene names in a tier under error control may take what those of other tiers may, a hundredth of E.
//!
//! In every tier a run is degraded too in which ending bounces took more than 1e-9 of E beyond the energy of the
//! bounces themselves, or lifting bodies onto faces that are higher by less than the touch distance gave more than
//! that, or with a problem that was not solved to its tolerance.

use super::facts::ErrorOrder;
use crate::accounting::books::Balance;
use crate::accounting::measures::{Limits, Measure};
use crate::accounting::numerical_loss::FixedStep;
use crate::accounting::time_step_report::TimeStepReport;
use crate::collision::touch::Touch;
use crate::constraint::ConstraintId;
use crate::model::{rates, reported, tolerances};
use crate::scene::OverlapLimit;
use crate::solve::bounce_friction::EndedBounces;
use crate::solve::cone_violation::ConeViolation;
use crate::solve::projection::Projection;
use crate::tier::core::Core;
use polhode_contact::ContactKinematics;
use polhode_dynamics::{BodyState, RigidBody};

/// How far a projection of a separation that is rounding may move a tilted body, in such separations (no unit): beyond
/// that the projection is partial (`crate::solve::projection`).
const MOVED_BY_ROUNDING: f64 = 5.0;

/// Allowed delay of an impact, in units in the last place of its time.
const TIME_ULPS: f64 = 4.0;

/// Energy that ended bounces may take beyond their own, and that lifts onto higher faces may give, relative to the
/// largest energy of the run (no unit, 1e-12 to 1e-8): a run that loses or gains more does not have the motion of its
/// scene.
const REPLACED_RELATIVE: f64 = 1e-9;

/// Energy that a method under error control may take in a step, in units of its tolerance, relative to the largest
/// energy (no unit, 1 to 100): the error of a step is a fraction of its tolerance.
const TOLERANCES_PER_STEP: f64 = 10.0;

impl Core {
    /// The limits of the whole run.
    pub(crate) fn limits(&self) -> Limits {
        let settings = &self.settings;
        let order = match settings.tier.facts().order {
            ErrorOrder::Fixed(order) => order,
            ErrorOrder::WithContact(order) if self.model.surfaces.may_collide() => order,
            ErrorOrder::WithContact(_) | ErrorOrder::OfIntegrator => settings.integrator.order(),
        };
        let is_fixed = !settings.controls_error();
        let duration_s = self.model.scene.duration_s();
        let step = is_fixed.then_some(FixedStep { step_s: settings.step_s, order, duration_s });
        let energy = settings.promise.energy;
        let of_steps = TOLERANCES_PER_STEP * settings.tolerance * (duration_s / settings.step_s).max(1.0);
        Limits {
            projection_energy_relative: energy,
            crowd_projection_relative: self.crowding_allowed(),
            numerical_relative: if is_fixed { energy } else { energy.max(of_steps) + self.crowding_allowed() },
            replaced_relative: REPLACED_RELATIVE,
            smallest_energy_j: rates::lifting_energy_j(&self.model),
            step,
            remedy: settings.tier.facts().remedy,
        }
    }

    /// The part of the largest energy that the stretches of crowded events so far may take: their tolerance for each
    /// longest step, as of the error of a position.
    fn crowding_allowed(&self) -> f64 {
        let longest = self.settings.step_s;
        self.settings.crowding_tolerance * (self.accounts.crowded.length_s() / longest).max(1.0)
    }

    /// Books a time step of a stretch of crowded events that ends at `t` (s) in these states, and records what its
    /// projections took.
    pub(crate) fn note_crowd_step(&mut self, t: f64, states: &[BodyState], report: &TimeStepReport) {
        self.accounts.note_time_step(&self.model, t, states, report);
        let taken_j = report.books.ledger.projection.value();
        if let Some(id) = report.deepest {
            self.note_crowd_projection(t, (id.a, id.b), taken_j);
        }
    }

    /// Records that projections of a pair took this energy (J) in a stretch of crowded events, at `t` (s).
    pub(crate) fn note_crowd_projection(&mut self, t: f64, pair: (usize, usize), taken_j: f64) {
        let measure = Measure { t, pair, value: taken_j.abs(), allowed: f64::INFINITY };
        self.accounts.measures.crowd_projection.note(measure);
        self.accounts.measures.crowd_projection_sum.add(taken_j);
    }

    /// Records the penetration of a contact of a pair at `t` (s) in the certificate.
    pub(crate) fn note_contact(
        &mut self,
        t: f64,
        states: &[BodyState],
        pair: (usize, usize),
        contact: &ContactKinematics,
    ) {
        self.note_separation(t, states, pair, (contact.geometry.separation, contact.separation_rate));
    }

    /// Records the separation of a pair (m) and its rate (m/s) at `t` (s) in the certificate.
    pub(crate) fn note_separation(
        &mut self,
        t: f64,
        states: &[BodyState],
        (a, b): (usize, usize),
        (separation_m, rate): (f64, f64),
    ) {
        let allowed = self.penetration_allowed(t, states, (a, b), rate);
        self.accounts.measures.penetration.note(Measure { t, pair: (a, b), value: -separation_m, allowed });
    }

    /// The penetration (m) that the run promises not to exceed for a pair at `t` (s) whose separation changes at this
    /// rate (m/s); infinite without a promise.
    pub(crate) fn penetration_allowed(&self, t: f64, states: &[BodyState], (a, b): (usize, usize), rate: f64) -> f64 {
        // The time of an impact is known to its rounding only.
        let late_approach = TIME_ULPS * f64::EPSILON * t.abs() * rate.abs();
        self.promised_overlap_m((a, b)) + tolerances::penetration_rounding(&self.model, states, a, b) + late_approach
    }

    /// The overlap (m) that the run promises not to exceed for a pair, without rounding.
    fn promised_overlap_m(&self, (a, b): (usize, usize)) -> f64 {
        match self.settings.promise.overlap {
            OverlapLimit::OfSize(part) => part * tolerances::pair_size(&self.model, a, b),
            OverlapLimit::OfStatedPenetration(times) | OverlapLimit::OfEnvelope(times) => times * self.stated_depth_m,
        }
    }

    /// Whether a pair overlaps by more than a step under error control leaves, which is far less than is promised.
    pub(crate) fn overlaps_beyond_aim(&self, overlap: &Measure) -> bool {
        let (a, b) = overlap.pair;
        let aim = self.settings.penetration_aim() * tolerances::pair_size(&self.model, a, b);
        overlap.value > overlap.allowed - self.promised_overlap_m(overlap.pair) + aim
    }

    /// Records the penetration that a time step up to `t` (s) has left and removed, and what that took.
    pub(crate) fn note_overlap_of_step(&mut self, t: f64, states: &[BodyState], report: &TimeStepReport) {
        let taken_j = report.books.ledger.projection.value();
        self.accounts.measures.drift_energy.add(taken_j);
        let Some(pair) = report.deepest.map(|id| (id.a, id.b)) else { return };
        let allowed = self.penetration_allowed(t, states, pair, 0.0);
        let measure = |value: f64, allowed: f64| Measure { t, pair, value, allowed };
        let measures = &mut self.accounts.measures;
        measures.penetration.note(measure(report.max_penetration_m, allowed));
        measures.projection.note(measure(report.max_projection_m, f64::INFINITY));
        measures.projection_energy.note(measure(taken_j.abs(), f64::INFINITY));
    }

    /// Books the end of bounces of some bodies at `t` (s), and records in the certificate what was taken beyond the
    /// energy of the bounces and their friction. The energy of bounces is at most the one that all the bodies have at
    /// the speed of the fastest one.
    pub(crate) fn book_ended_bounces(
        &mut self,
        t: f64,
        bodies: &[usize],
        fastest: &Touch,
        (before, after): (Balance, Balance),
        ended: &EndedBounces,
    ) {
        let taken = self.accounts.books.rest(before, after, ended.work_j) - ended.friction_j;
        self.accounts.books.friction_at_rest(ended.friction_j);
        let mass = |&body: &usize| self.model.bodies[body].rigid.as_ref().map_or(0.0, RigidBody::mass);
        let speed = fastest.kinematics.separation_rate;
        let of_bounces = 0.5 * bodies.iter().map(mass).sum::<f64>() * speed * speed;
        let beyond = (taken.abs() - of_bounces).max(0.0);
        let pair = (fastest.id.a, fastest.id.b);
        let measure = Measure { t, pair, value: beyond, allowed: f64::INFINITY };
        self.accounts.measures.ended_bounces.note(measure);
        self.accounts.measures.ended_bounces_sum.add(beyond);
    }

    /// Records in the certificate how far forces or impulses at `t` (s) are from Coulomb's law.
    pub(crate) fn note_friction(&mut self, t: f64, violation: Option<ConeViolation>) {
        self.accounts.note_friction(t, violation);
    }

    /// Books a projection at `t` (s) that has led to these states, and records it in the certificate.
    pub(crate) fn book_projection(
        &mut self,
        t: f64,
        states: &[BodyState],
        done: &Projection,
        balances: (Balance, Balance),
    ) {
        self.note_displacement(t, states, done);
        let taken = self.enter_projection(t, done, balances);
        self.accounts.measures.drift_energy.add(taken);
    }

    /// The same where bodies were lifted onto higher faces. Their energy is not that of a drift: the faces are higher.
    pub(crate) fn book_lift(&mut self, t: f64, states: &[BodyState], done: &Projection, balances: (Balance, Balance)) {
        self.note_displacement(t, states, done);
        let taken = self.enter_projection(t, done, balances);
        self.accounts.measures.lifts_sum.add(taken);
        if let Some(pair) = done.pair() {
            self.accounts.measures.lifts.note(Measure { t, pair, value: taken.abs(), allowed: f64::INFINITY });
        }
    }

    /// Records how far a projection at `t` (s) that has led to these states moved bodies. Steps of a fixed length leave
    /// more to it the longer they are, and only their overlaps are limited.
    fn note_displacement(&mut self, t: f64, states: &[BodyState], done: &Projection) {
        let Some(pair @ (a, b)) = done.pair() else { return };
        let allowed = match self.settings.promise.overlap {
            OverlapLimit::OfSize(part) if self.settings.projects_within_promise() => {
                part * tolerances::pair_size(&self.model, a, b)
                    + MOVED_BY_ROUNDING * tolerances::rounding(&self.model, states, a, b)
            }
            _ => f64::INFINITY,
        };
        self.accounts.measures.projection.note(Measure { t, pair, value: done.moved_m, allowed });
    }

    /// The same for overlaps within the touch distance at the start, which are removed without a limit.
    pub(crate) fn book_initial_projection(&mut self, t: f64, done: &Projection, balances: (Balance, Balance)) {
        if let Some(pair) = done.pair() {
            let moved = Measure { t, pair, value: done.moved_m, allowed: f64::INFINITY };
            self.accounts.measures.projection.note(moved);
        }
        self.enter_projection(t, done, balances);
    }

    /// Books a projection and counts the constraints that it did not project. Returns the energy it removed, J.
    fn enter_projection(&mut self, t: f64, done: &Projection, (before, after): (Balance, Balance)) -> f64 {
        let energy_j = self.accounts.books.projection(before, after, done.work_j);
        if let Some(pair) = done.pair() {
            // The limit is a fraction of the largest energy of the run, which is known at its end.
            let taken = Measure { t, pair, value: energy_j.abs(), allowed: f64::INFINITY };
            self.accounts.measures.projection_energy.note(taken);
        }
        for (a, b) in done.jumped.iter().map(ConstraintId::bodies) {
            let names = reported::pair_names(&self.model, a, b);
            self.accounts.tolerate(t, format!("a contact of {names} whose point had jumped was not projected"));
        }
        for constraint in &done.unconverged {
            let (a, b) = constraint.bodies();
            let names = reported::pair_names(&self.model, a, b);
            let what = if constraint.contact().is_some() { "contact" } else { "pivot" };
            self.accounts.tolerate(t, format!("the projection of a {what} of {names} did not converge"));
        }
        energy_j
    }
}
