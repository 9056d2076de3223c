//! What joints bear in time steps, by the law of the steps at the present, and the joints that break at the end of a step.

use super::engine::{SteppedEngine, joined};
use super::instant_forces::PresentForces;
use crate::SimulationError;
use crate::constraint::joint::WorldJoint;
use crate::core::Core;
use crate::frame::JointView;
use crate::solve::joint_loads::{joint_view, overloaded};
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;
use std::collections::{BTreeMap, BTreeSet};

impl SteppedEngine {
    /// Breaks the joints that bear as much as they can now, and those that bear it when these are gone.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn break_overloaded(&mut self, core: &mut Core) -> Result<(), SimulationError> {
        while core.world.may_break() {
            let loads = self.loads_of_joints(core, &self.states);
            let broken = overloaded(&core.world, &loads);
            if broken.is_empty() {
                break;
            }
            let bodies: Vec<usize> = core
                .world
                .joints
                .iter()
                .filter(|joint| broken.contains(&joint.number()))
                .flat_map(WorldJoint::bodies)
                .collect();
            core.break_joints(core.t, &self.states, &broken)?;
            self.resting.wake_all();
            for body in bodies {
                self.flights[body] = None;
            }
        }
        Ok(())
    }

    /// What the joints bear at the present, where bodies have these states.
    pub(super) fn loads_of_joints(&self, core: &Core, states: &[BodyState]) -> BTreeMap<usize, JointView> {
        let mut loads = BTreeMap::new();
        if core.world.joints.is_empty() {
            return loads;
        }
        let pairs: BTreeSet<(usize, usize)> =
            self.touching.iter().copied().chain(core.world.joint_contact_pairs()).collect();
        let touches = self.resting_touches(core, &pairs.into_iter().collect::<Vec<_>>());
        for (bodies, contacts) in joined(&core.world, &touches) {
            match PresentForces::solve(core, states, &bodies, &contacts) {
                Ok(forces) => loads.extend(forces.joints),
                Err(_) => loads.extend(core.world.joints_among(&bodies).map(|joint| {
                    let point = core.world.anchor_of(states, joint);
                    (joint.number(), joint_view(joint.number(), point, (DVec3::NAN, DVec3::NAN)))
                })),
            }
        }
        loads
    }
}
