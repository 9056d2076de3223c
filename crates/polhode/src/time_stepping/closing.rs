//! Contacts that close within a step without a bounce: one complementarity problem at its start.
//!
//! With the gap `g` (m) of a contact, the rates `u-` before and `u+` after the impulses `p` (N s), and the length h of
//! the step (s):
//!
//! `0 <= p _|_ u+ + g/h >= 0`:
//!
//! a contact that would close within the step is slowed down so that its gap closes at its end. All contacts that may
//! close are rows, also those that close only because others deflect their bodies; friction obeys Coulomb's law with
//! the velocities after the impulses. Without this problem the bodies would overlap in the middle of the step by half
//! of the way by which they approach within it. Impulses give no energy (`row_at_start` in `sustained.rs`). A contact
//! whose gap is closed is stopped by the next step; so a blow arrives in two parts. Source: docs/REFERENCES.md, Moreau
//! 1988; the gaps after Stewart and Trinkle 1996.
//!
//! Assumption: normals hardly turn within a step. What their turning leaves is removed at its end.

use super::contacts::{NearContact, slips_at_start};
use super::impacts::refresh;
use super::kick::Kick;
use super::middle::{Middle, Problem, Stops};
use super::repeated::SHARE_OF_SIZE;
use super::step::{Substep, TimeStepper};
use crate::accounting::time_step_report::TimeStepReport;
use crate::model::{Model, tolerances};
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;

impl TimeStepper {
    /// Slows down the contacts that would close within a substep faster than sustained ones, and updates velocities and
    /// contacts.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn stop_closing(
        &mut self,
        model: &Model,
        states: &mut [BodyState],
        bodies: &[usize],
        near: &mut [NearContact],
        Substep { t, h, .. }: Substep,
        report: &mut TimeStepReport,
    ) -> Result<(), ResponseError> {
        let acts = |contact: &NearContact| {
            let allowed = SHARE_OF_SIZE * tolerances::pair_size(model, contact.id.a, contact.id.b);
            contact.impact_time(h).is_some() || contact.kept_off > 0.0 || contact.overlaps_in_middle(h, allowed)
        };
        if !near.iter().any(acts) {
            return Ok(());
        }
        let slips = slips_at_start(model, states, near);
        let none = Kick::default();
        let start = Middle { problem: Problem::Closing, t, h, stops: Stops::At(&[]), kick: &none };
        self.sustain(model, states, bodies, (near, &slips), start, report)?;
        refresh(model, states, bodies, near, t);
        Ok(())
    }
}
