//! Projection of held contacts onto zero separation, at the ends of steps and where contacts begin to hold.
//!
//! The projection (`crate::solve::projection`) removes the separations that drift and the touch distance leave.
//! It moves bodies by the tolerance at most, but it may push one into a neighbour without a held contact. The motion
//! did not cause that penetration, and removing it would push the next body. In that case the projection is undone,
//! provided that all contacts still touch.
//!
//! Neighbours of other islands are evaluated at that time within their own steps. Limit: if a neighbour moves into a
//! body after its projection, an impact is found.

use super::motions::Motions;
use super::schedule::Schedule;
use crate::accounting::books::Balance;
use crate::collision::contact_kinematics;
use crate::error::SimulationError;
use crate::identity::contact_id::ContactId;
use crate::joints::bilateral::Bilateral;
use crate::joints::held;
use crate::model::{Model, tolerances};
use crate::solve::overlap::Overlaps;
use crate::solve::projection::{self, Projected};
use crate::tier::core::Core;
use polhode_dynamics::BodyState;
use polhode_spatial::Pose;
use std::collections::BTreeSet;

/// A projection that moves bodies by less than this fraction of their size is not checked for neighbours: a tenth of
/// what a step aims at (`Settings::penetration_aim`).
const PUSH_RELATIVE: f64 = 1e-13;

impl Motions {
    /// Projects contacts of some bodies (ascending) onto zero separation and velocity at `t` (s). Books the change;
    /// `before` is the balance of the bodies before. If bodies would be pushed into neighbours, their poses are
    /// restored.
    ///
    /// # Errors
    /// When a state is not finite, or an integrator cannot evaluate a neighbour.
    pub(super) fn project_held_contacts(
        &mut self,
        core: &mut Core,
        schedule: &Schedule,
        bodies: &[usize],
        projected: Projected<'_>,
        t: f64,
        before: Balance,
    ) -> Result<(), SimulationError> {
        let start: Vec<Pose> = bodies.iter().map(|&body| self.states[body].pose).collect();
        let how = (core.settings.step_error(), &mut core.memory);
        let mut done = projection::project(&core.model, &mut self.states, bodies, projected, how)
            .map_err(|source| SimulationError::of_response(t, source))?;
        let pushes = |body: &usize| done.moved_m > PUSH_RELATIVE * core.model.bodies[*body].size;
        if bodies.iter().any(pushes)
            && self.restore_poses_if_pushed(core, schedule, bodies, &start, projected.touching, t)?
        {
            done.moved_m = 0.0;
            done.unconverged.retain(|constraint| constraint.contact().is_none());
        }
        let after = core.accounts.books.balance(&core.model, &self.states, bodies);
        core.book_projection(t, &self.states, &done, (before, after));
        Ok(())
    }

    /// Restores the poses `start` under two conditions: in them the bodies overlap their neighbours less than now, and
    /// all contacts `touching` still touch. Returns whether it did.
    fn restore_poses_if_pushed(
        &mut self,
        core: &Core,
        schedule: &Schedule,
        bodies: &[usize],
        start: &[Pose],
        touching: &[ContactId],
        t: f64,
    ) -> Result<bool, SimulationError> {
        let mut pairs = BTreeSet::new();
        for &body in bodies {
            let partners = schedule.partners(core, body);
            pairs.extend(partners.map(|other| (body.min(other), body.max(other))));
        }
        let pairs: Vec<_> = pairs.into_iter().collect();
        let mut others: Vec<usize> = pairs.iter().flat_map(|&(a, b)| [a, b]).collect();
        others.sort_unstable();
        others.dedup();
        others.retain(|body| bodies.binary_search(body).is_err() && core.model.bodies[*body].moves());
        let beside = others.iter().map(|&other| self.state_at(core, other, t)).collect::<Result<Vec<_>, _>>()?;
        let mut states = std::mem::take(&mut self.scratch);
        for (&other, state) in others.iter().zip(beside) {
            states[other] = state;
        }
        for &body in bodies {
            states[body] = self.states[body];
        }
        let now = Overlaps::find(&core.model, &states, &pairs);
        for (&body, pose) in bodies.iter().zip(start) {
            states[body].pose = *pose;
        }
        let restores = now.is_excess
            && Overlaps::find(&core.model, &states, &pairs).deepest_m < now.deepest_m
            && all_touch(&core.model, &states, bodies, touching);
        if restores {
            for (&body, pose) in bodies.iter().zip(start) {
                self.states[body].pose = *pose;
            }
        }
        others.extend(bodies);
        self.restore_scratch(core, states, &others);
        Ok(restores)
    }
}

/// Whether all these contacts touch, and the pivots of these bodies are within the touch distance of their anchors.
fn all_touch(model: &Model, states: &[BodyState], bodies: &[usize], contacts: &[ContactId]) -> bool {
    let touches = |&id: &ContactId| {
        let kinematics = contact_kinematics::kinematics(model, states, id);
        kinematics.is_some_and(|kinematics| {
            kinematics.geometry.separation <= tolerances::touch_distance(model, states, id.a, id.b)
        })
    };
    let is_in_place = |bilateral: Bilateral| {
        let (a, b) = bilateral.id.bodies();
        bilateral.gap() <= tolerances::touch_distance(model, states, a, b)
    };
    contacts.iter().all(touches) && held::bilaterals(model, states, bodies).all(is_in_place)
}
