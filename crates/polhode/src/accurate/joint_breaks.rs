//! When joints break: the first time in a step at which one bears as much as it can.
//!
//! The event function is `1 - max(F/F_most, M/M_most)` with the force `F` and the moment `M` of the joint at its
//! anchor, from the forces that are solved for at the states of the step. It is looked at where the step begins, at
//! eight times and where it ends; the first crossing is located by the locator of all events. A load that grows beyond
//! the strength and falls again between two looks is not seen.

use super::constrained_step::ConstrainedStep;
use super::contact_change::ContactChange;
use super::hold::Forces;
use super::locate::PENETRATION_CHECKS;
use super::step_search::StepSearch;
use crate::collision::contact_kinematics;
use crate::collision::touch::Touch;
use crate::constraint::locator::{Side, close_in};
use crate::error::SimulationError;
use crate::report::frame::JointView;
use crate::solve::joint_loads::{ContactForce, joint_loads, overloaded};
use crate::tier::core::Core;
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

/// What the joints of a group bear under these forces, whose contacts these are.
pub(super) fn loads_of(
    core: &Core,
    states: &[BodyState],
    (forces, touches): (&Forces, &[Touch]),
) -> BTreeMap<usize, JointView> {
    let contacts = touches.iter().zip(forces.of_contacts()).enumerate().map(|(index, (touch, normal))| {
        let tangential = forces.friction(index).map_or(DVec3::ZERO, |friction| friction.force);
        let geometry = &touch.kinematics.geometry;
        ContactForce { id: touch.id, point: geometry.point, force: geometry.normal * *normal + tangential }
    });
    joint_loads(&core.model, states, (&forces.assembly, &forces.solution.reactions), contacts)
}

impl StepSearch<'_> {
    /// The change of contacts that was found, or the break of joints before it: until `limit` (s).
    ///
    /// # Errors
    /// When forces cannot be found.
    pub(super) fn or_earlier_break(
        &mut self,
        found: Option<ContactChange>,
        limit: f64,
    ) -> Result<Option<ContactChange>, SimulationError> {
        if !self.core.model.joints.may_break_among(&self.step.bodies) {
            return Ok(found);
        }
        let (start, end) = (self.step.t, found.as_ref().map_or(limit, |change| change.t));
        let at = |t: f64, joints: Vec<usize>| ContactChange {
            t,
            breaking: joints.into_iter().collect(),
            ..ContactChange::default()
        };
        let mut before = start;
        for k in 0..=PENETRATION_CHECKS {
            let t = start + (end - start) * (f64::from(k) / f64::from(PENETRATION_CHECKS));
            let joints = self.overloaded_at(t)?;
            if joints.is_empty() {
                before = t;
                continue;
            }
            if k == 0 {
                return Ok(Some(at(start, joints)));
            }
            let bracket = close_in((before, t), |t| {
                let is_whole = self.overloaded_at(t)?.is_empty();
                Ok::<_, SimulationError>(if is_whole { Side::Before } else { Side::After })
            })?;
            let joints = self.overloaded_at(bracket.after)?;
            return Ok(match found {
                Some(mut change) if change.t <= bracket.after => {
                    change.breaking.extend(joints);
                    Some(change)
                }
                _ => Some(at(bracket.after, joints)),
            });
        }
        Ok(found)
    }

    /// The joints that bear as much as they can at a time of the step.
    fn overloaded_at(&mut self, t: f64) -> Result<Vec<usize>, SimulationError> {
        self.step.states_at(&self.core.model, t, self.states);
        let touches: Vec<Touch> = held_touches(self.core, self.step, self.states);
        let mut solver = std::mem::take(&mut self.core.memory);
        let forces = Forces::solve(&self.core.model, t, self.states, &self.step.bodies, &touches, &mut solver);
        self.core.memory = solver;
        let forces = forces.map_err(|source| SimulationError::of_response(t, source))?;
        Ok(overloaded(&self.core.model, &loads_of(self.core, self.states, (&forces, &touches))))
    }
}

/// The held contacts of a step in these states, with their modes.
fn held_touches(core: &Core, step: &ConstrainedStep, states: &[BodyState]) -> Vec<Touch> {
    let touch =
        |&id| Some(Touch::held(id, contact_kinematics::kinematics(&core.model, states, id)?, step.active.modes(id)));
    step.active.held().iter().filter_map(touch).collect()
}
