//! The row of a contact in a problem of a time step (`sustained.rs` has its equations).

use super::contacts::NearContact;
use super::middle::Problem;
use super::sustained_friction::TangentialRow;
use crate::accounting::time_step_report::ImpulseKind;
use crate::model::{Model, tolerances};
use polhode_contact::ContactKinematics;
use polhode_dynamics::BodyState;

/// A row that approaches at the end by less than this fraction of its rates is left out: some dozen rounding units.
const ROW_ROUNDING: f64 = 1e-14;

/// A contact in the middle of the step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    pub(super) contact: usize,
    pub(super) problem: Problem,
    /// After the kick of fields.
    pub(super) kinematics: ContactKinematics,
    /// `u-`, m/s.
    pub(super) rate_before: f64,
    /// r, m/s.
    pub(super) bound: f64,
    /// The least r with which no energy is gained, m/s.
    pub(super) least_bound: f64,
    /// `h/2 a`, m/s.
    pub(super) half_fall: f64,
    /// Error of r by the rounding of the separation, m/s.
    pub(super) rounding: f64,
    /// None without friction.
    pub(super) friction: Option<TangentialRow>,
}

impl Row {
    /// Whether the contact would penetrate with this rate of separation after the impulses.
    pub(super) fn closes(&self, rate: f64) -> bool {
        rate + self.bound < -(self.rounding + ROW_ROUNDING * (rate.abs() + self.bound.abs()))
    }

    /// The kind of its impulse (N s) in a step of `h` (s).
    pub(super) fn kind_of_impulse(&self, contact: &NearContact, impulse: f64, h: f64) -> ImpulseKind {
        // The speed of approach of the contact at the start of the step.
        let approach = -(self.rate_before - self.half_fall);
        let is_impact = approach > contact.resting_speed && contact.closing_time().is_some_and(|time| time <= h);
        if is_impact || !self.is_sustained() {
            ImpulseKind::Impact { energy_change_j: 0.5 * impulse * (self.rate_before - self.bound) }
        } else {
            ImpulseKind::Sustained
        }
    }

    /// Whether it is of the problem in the middle of a step: in that at its start only what closes is a row.
    pub(super) fn is_sustained(&self) -> bool {
        self.problem == Problem::Sustained
    }

    /// Whether the row is in the problem of a step of `h` (s) from the beginning.
    pub(super) fn is_first_choice(&self, model: &Model, states: &[BodyState], contact: &NearContact, h: f64) -> bool {
        let touch_distance = tolerances::touch_distance(model, states, contact.id.a, contact.id.b);
        let lasts = contact.kinematics.separation_rate >= -contact.resting_speed;
        let presses = self.is_sustained() && lasts && self.half_fall <= 0.0 && contact.touches(h, touch_distance);
        presses || self.closes(self.kinematics.separation_rate)
    }
}
