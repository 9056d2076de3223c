//! Impacts within a step: what closes fast enough is struck where the step begins.
//!
//! A contact is struck when it approaches faster than a contact that lasts ([`super::contacts::RESTING_STEPS`]) and closes
//! at once, or within the step if it has restitution. With it are struck all contacts that touch and are connected to
//! it, as at an impact of the accurate tier; then, with the new velocities, whatever closes now, until nothing does.
//! Bodies bounce before they meet, by at most the way of one step, and never overlap by an impact. Contacts without
//! restitution that close later in the step are left to the sustained impulses, which close their gap exactly.

use super::contacts::{FreeAccelerations, NearContact, kinematics_at_point};
use super::report::{ContactImpulse, ImpulseKind, TimeStepReport};
use super::step::{Part, TimeStepper};
use crate::collision::contact_set::{Hold, Touch};
use crate::interaction::groups::{Group, groups};
use crate::interaction::impact::{strike, support};
use crate::world::World;
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;
use polhode_response::impact::{ImpactOutcome, ImpactSettings, ImpactStatus};

/// Rounds of impacts in one step at the most: as many as bodies of a chain with gaps, or bounces to and fro between two
/// others. What still closes afterwards is stopped without restitution.
const MOST_ROUNDS: usize = 128;

/// Rounds of one impact law at the most, before it stops what approaches without restitution.
const MOST_IMPULSES: usize = 20_000;

impl TimeStepper {
    /// Strikes what hits within a part of a step, and updates velocities and contacts.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn strike_closing(
        &mut self,
        world: &World,
        states: &mut [BodyState],
        bodies: &[usize],
        near: &mut [NearContact],
        Part { t, h, instant }: Part,
        report: &mut TimeStepReport,
    ) -> Result<(), ResponseError> {
        let mut together = vec![false; near.len()];
        for _ in 0..MOST_ROUNDS {
            let hits: Vec<bool> = near.iter().map(|contact| contact.is_struck(world, h, instant)).collect();
            if !hits.contains(&true) {
                return Ok(());
            }
            for (index, contact) in near.iter().enumerate() {
                let touch_distance = world.touch_distance(states, contact.id.a, contact.id.b);
                together[index] |= hits[index] || contact.touches(h, touch_distance);
            }
            let members = near.iter().enumerate().filter(|(index, _)| together[*index]);
            let members = members.map(|(index, contact)| (index, contact.id.a, contact.id.b));
            for group in groups(world, members) {
                if group.contacts.iter().any(|&index| hits[index])
                    && !self.strike_group(world, states, &group, near, t, report)?
                {
                    return Ok(());
                }
            }
            refresh(world, states, bodies, near, t);
        }
        report.fallbacks += 1;
        Ok(())
    }

    /// Strikes one group; whether the law found an answer. Otherwise nothing has changed.
    fn strike_group(
        &mut self,
        world: &World,
        states: &mut [BodyState],
        group: &Group,
        near: &[NearContact],
        t: f64,
        report: &mut TimeStepReport,
    ) -> Result<bool, ResponseError> {
        let touch = |contact: &NearContact| Touch {
            id: contact.id,
            kinematics: contact.kinematics,
            hold: Hold::Open,
            known: false,
        };
        let touches: Vec<Touch> = group.contacts.iter().map(|&index| touch(&near[index])).collect();
        let all = Group { bodies: group.bodies.clone(), contacts: (0..touches.len()).collect() };
        let settings = ImpactSettings { limit: MOST_IMPULSES, ..ImpactSettings::default() };
        let outcome = strike(world, states, &all, &touches, self.law, &settings, &mut self.solver)?.outcome;
        if outcome.status == ImpactStatus::NotSolved {
            report.fallbacks += 1;
            return Ok(false);
        }
        for &body in &group.bodies {
            world.keep_in_plane(body, &mut states[body]);
        }
        note(world, states, &touches, &outcome, t, report);
        Ok(true)
    }
}

/// Books an impact and lists its impulses.
fn note(
    world: &World,
    states: &[BodyState],
    touches: &[Touch],
    outcome: &ImpactOutcome,
    t: f64,
    report: &mut TimeStepReport,
) {
    report.residual = report.residual.max(outcome.residual);
    report.fallbacks += u64::from(outcome.status == ImpactStatus::LimitReached);
    let impulses = touches.iter().zip(&outcome.impulses);
    let impulses = impulses.map(|(touch, &p)| (touch.id, &touch.kinematics.geometry, p));
    let given = support(world, report.books.ledger.momentum.about, impulses.clone());
    let work = world.prescribed_work(states, impulses);
    report.books.impact(outcome.energy_change, given, work);
    report.impulses.extend(outcome.applications.iter().map(|application| ContactImpulse {
        t,
        id: touches[application.row].id,
        geometry: touches[application.row].kinematics.geometry,
        impulse: application.impulse,
        kind: ImpulseKind::Impact { energy_change_j: application.energy_change },
    }));
}

/// The contacts with the present velocities.
fn refresh(world: &World, states: &[BodyState], bodies: &[usize], near: &mut [NearContact], t: f64) {
    let free = FreeAccelerations::with_fields(world, t, states, bodies);
    for contact in near {
        if let Some(kinematics) = kinematics_at_point(world, states, contact.id) {
            contact.kinematics = kinematics;
            contact.acceleration = free.relative(states, contact.id, &kinematics);
        }
    }
}
