//! Impacts within a step: the impact law acts at its start on contacts that close fast enough.
//!
//! The impact law acts on a contact that approaches faster than a sustained contact
//! ([`super::contacts::RESTING_STEPS`]) and closes at once, or within the step if it has restitution. It includes all
//! touching contacts connected to it, as at an impact of the accurate tier. This is repeated with the new velocities
//! until no contact closes. Bodies bounce before they meet, by at most the travel of one step, so an impact never
//! leaves a penetration. Contacts without restitution that close later in the step are slowed down so that their gaps
//! close at its end (`closing.rs`).

use super::contacts::{FreeAccelerations, NearContact, foresee_with_joints, kinematics_at_point, touch};
use super::step::{Substep, TimeStepper};
use crate::accounting::time_step_report::{ContactImpulse, ImpulseKind, TimeStepReport};
use crate::collision::touch::Touch;
use crate::identity::contact_id::ContactId;
use crate::model::tolerances::MOST_COLLISIONS;
use crate::model::{Model, tolerances};
use crate::rows::groups::{Group, groups};
use crate::solve::cone_violation::ConeViolation;
use crate::solve::frictional_impact::Restitution;
use crate::solve::impact::{Struck, strike_group};
use crate::solve::joint_loads::ContactForce;
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;
use polhode_response::impact::{ImpactSettings, ImpactStatus};
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

/// Most rounds of impacts in one step: one for each body of a chain with gaps, or for each bounce of a body between two
/// others. Contacts that still close afterwards are stopped without restitution.
const MOST_ROUNDS: usize = 128;

impl TimeStepper {
    /// Resolves the impacts within a substep, and updates velocities and contacts.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn strike_closing(
        &mut self,
        model: &Model,
        states: &mut [BodyState],
        bodies: &[usize],
        near: &mut [NearContact],
        Substep { t, h, instant }: Substep,
        report: &mut TimeStepReport,
    ) -> Result<(), ResponseError> {
        let mut is_member = vec![false; near.len()];
        for _ in 0..MOST_ROUNDS {
            let hits: Vec<bool> = near.iter().map(|contact| contact.is_struck(model, h, instant)).collect();
            if !hits.contains(&true) {
                return Ok(());
            }
            for (index, contact) in near.iter().enumerate() {
                let touch_distance = tolerances::touch_distance(model, states, contact.id.a, contact.id.b);
                is_member[index] |= hits[index] || contact.touches(h, touch_distance);
            }
            let members = near.iter().enumerate().filter(|(index, _)| is_member[*index]);
            let members = members.map(|(index, contact)| (index, contact.id.a, contact.id.b));
            for group in groups(model, members) {
                if group.contacts.iter().any(|&index| hits[index])
                    && !self.strike_group(model, states, &group, near, t, report)?
                {
                    return Ok(());
                }
            }
            refresh(model, states, bodies, near, t);
        }
        report.fallbacks += 1;
        Ok(())
    }

    /// Applies the impact law to one group. Returns whether it found a solution; otherwise nothing has changed.
    fn strike_group(
        &mut self,
        model: &Model,
        states: &mut [BodyState],
        group: &Group,
        near: &[NearContact],
        t: f64,
        report: &mut TimeStepReport,
    ) -> Result<bool, ResponseError> {
        let touches: Vec<Touch> = group.contacts.iter().map(|&index| touch(&near[index])).collect();
        let all = Group { bodies: group.bodies.clone(), contacts: (0..touches.len()).collect() };
        let settings = settings_for(group, near);
        let struck = strike_group(model, states, &all, &touches, self.law, &settings, &mut self.memory)?;
        if struck.outcome.status == ImpactStatus::NotSolved {
            report.fallbacks += 1;
            return Ok(false);
        }
        for &body in &group.bodies {
            model.keep_in_plane(body, &mut states[body]);
        }
        note(model, states, &touches, &struck, t, report);
        Ok(true)
    }
}

/// Settings under which a contact that approaches as slowly as a sustained one does not approach: it stays closed to
/// the step that follows. For laws that ask which contacts approach, one that rests to the accuracy of the step would
/// else be struck as well.
fn settings_for(group: &Group, near: &[NearContact]) -> ImpactSettings {
    let largest = |value: fn(&NearContact) -> f64| {
        group.contacts.iter().filter_map(|&index| near.get(index)).map(value).fold(0.0, f64::max)
    };
    let approach = largest(|contact| -contact.kinematics.separation_rate);
    let resting = largest(|contact| contact.resting_speed.max(contact.unseen_speed));
    let usual = ImpactSettings { limit: MOST_COLLISIONS, ..ImpactSettings::default() };
    if resting < approach {
        ImpactSettings { threshold: usual.threshold.max(resting / approach), ..usual }
    } else {
        usual
    }
}

/// Books an impact and records its impulses.
fn note(model: &Model, states: &[BodyState], touches: &[Touch], struck: &Struck, t: f64, report: &mut TimeStepReport) {
    let outcome = &struck.outcome;
    report.residual = report.residual.max(outcome.residual);
    report.fallbacks += u64::from(outcome.status == ImpactStatus::LimitReached);
    report.raises_energy |= struck.restitution == Restitution::RaisesEnergy;
    let about = report.books.ledger.momentum.about;
    let given = struck.support(model, about, touches);
    let work = struck.work(model, states, touches);
    report.cone_violation = ConeViolation::larger(report.cone_violation, struck.violation);
    report.books.impact((outcome.energy_change, struck.friction_j), given, work);
    report.told.take_struck(model, states, struck.reactions.of_bilaterals());
    let mut tangential: BTreeMap<ContactId, DVec3> = BTreeMap::new();
    for own in &struck.reactions.tangential {
        *tangential.entry(own.id).or_default() += own.vector();
    }
    // Rows of bilateral constraints follow those of the contacts: their impulses are no events.
    for application in &outcome.applications {
        let Some(touch) = touches.get(application.row) else { continue };
        let geometry = touch.kinematics.geometry;
        // Friction of all applications of a contact is told with the first one.
        let friction = tangential.remove(&touch.id).unwrap_or_default();
        let force = geometry.normal * application.impulse + friction;
        report.told.take_contact(model, states, (ContactForce { id: touch.id, point: geometry.point, force }, true));
        report.impulses.push(ContactImpulse {
            t,
            id: touch.id,
            geometry,
            impulse: application.impulse,
            friction,
            kind: ImpulseKind::Impact { energy_change_j: application.energy_change },
        });
    }
}

/// The contacts with the present velocities.
pub(super) fn refresh(model: &Model, states: &[BodyState], bodies: &[usize], near: &mut [NearContact], t: f64) {
    let free = FreeAccelerations::with_fields(model, t, states, bodies);
    for contact in near.iter_mut() {
        if let Some(kinematics) = kinematics_at_point(model, states, contact.id) {
            contact.kinematics = kinematics;
            contact.acceleration = free.relative(states, contact.id, &kinematics);
        }
    }
    foresee_with_joints(model, states, bodies, near, t);
}
