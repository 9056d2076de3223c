//! What joints bear in time steps, and the joints that break at the end of a step.
//!
//! They bear what the step has applied, divided by its length (`crate::time_stepping`): with the velocities of the same
//! run that is Newton's law. Before the first step they bear what the law of the steps gives at the instant. A joint
//! breaks by what it bears without impulses of impacts, which break by their own strength; what the others bear then
//! shows in the next step.

use super::engine::SteppedEngine;
use super::instant_forces::PresentForces;
use super::islands::joined;
use crate::constraint::joint::ModelJoint;
use crate::error::SimulationError;
use crate::joints::joint_contacts;
use crate::report::frame::JointView;
use crate::solve::joint_loads::{joint_view, overloaded};
use crate::tier::core::Core;
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;
use std::collections::{BTreeMap, BTreeSet};

impl SteppedEngine {
    /// Breaks the joints that have borne as much as they can in a step, by these loads.
    ///
    /// # Errors
    /// When the forces on the bodies cannot be made.
    pub(super) fn break_overloaded(
        &mut self,
        core: &mut Core,
        loads: &BTreeMap<usize, JointView>,
    ) -> Result<(), SimulationError> {
        let broken = overloaded(&core.model, loads);
        if broken.is_empty() {
            return Ok(());
        }
        let of_broken = core.model.joints.list.iter().filter(|joint| broken.contains(&joint.number()));
        let bodies: Vec<usize> = of_broken.flat_map(ModelJoint::bodies).collect();
        core.break_joints(core.t, &self.states, &broken)?;
        self.resting.wake_all();
        for body in bodies {
            self.flights[body] = None;
        }
        Ok(())
    }

    /// What the joints bear, where bodies have these states.
    pub(super) fn loads_of_joints(&self, core: &Core, states: &[BodyState]) -> BTreeMap<usize, JointView> {
        let Some(loads) = &self.loads else { return self.loads_at_instant(core, states) };
        let view = |joint: &ModelJoint| {
            let view = loads.get(&joint.number())?;
            Some((
                joint.number(),
                JointView { point_m: joint_contacts::anchor_of(&core.model, states, joint), ..*view },
            ))
        };
        core.model.joints.list.iter().filter_map(view).collect()
    }

    /// The same by the law of the steps at the present.
    fn loads_at_instant(&self, core: &Core, states: &[BodyState]) -> BTreeMap<usize, JointView> {
        let mut loads = BTreeMap::new();
        if core.model.joints.list.is_empty() {
            return loads;
        }
        let pairs: BTreeSet<(usize, usize)> =
            self.touching.iter().copied().chain(core.model.joints.joint_contact_pairs()).collect();
        let touches = self.resting_touches(core, &pairs.into_iter().collect::<Vec<_>>());
        for (bodies, contacts) in joined(&core.model, &touches) {
            match PresentForces::solve(core, states, &bodies, &contacts) {
                Ok(forces) => loads.extend(forces.joints),
                Err(_) => loads.extend(core.model.joints.joints_among(&bodies).map(|joint| {
                    let point = joint_contacts::anchor_of(&core.model, states, joint);
                    (joint.number(), joint_view(joint.number(), point, (DVec3::NAN, DVec3::NAN)))
                })),
            }
        }
        loads
    }
}
