//! Held contacts are put exactly together where steps end and where contacts begin to hold.
//!
//! What drift and touch leave of their separations is projected away (`crate::interaction::projection`). That moves bodies by
//! the tolerance at the most, but it may push one into a neighbour that is not held to it: an overlap that the motion never
//! had, and that moving it out again would only hand back. Then the contacts stay open, as far as touch allows, until there is
//! room.
//!
//! Neighbours of other islands stand where they are at that time within their own steps. Fails where they move into a body
//! after it was put together: that shows as an impact.

use super::engine::Engine;
use crate::SimulationError;
use crate::accounting::books::Balance;
use crate::collision::contact_set::ContactId;
use crate::core::Core;
use crate::interaction::overlap::Overlaps;
use crate::interaction::projection;
use polhode_spatial::Pose;
use std::collections::BTreeSet;

/// A projection that moves bodies by less than this fraction of their size pushes nothing: a tenth of what a run is judged by.
const PUSH_RELATIVE: f64 = 1e-13;

impl Engine {
    /// Puts contacts of some bodies (ascending) onto zero separation at `t` (s), those `touching` in position, those `held` in
    /// velocity too, and books it; `before` is the balance of the bodies before. Where bodies would be pushed into neighbours,
    /// their places stay.
    ///
    /// # Errors
    /// When a state is not finite.
    pub(super) fn put_together(
        &mut self,
        core: &mut Core,
        bodies: &[usize],
        (touching, held): (&[ContactId], &[ContactId]),
        t: f64,
        before: Balance,
    ) -> Result<(), SimulationError> {
        let start: Vec<Pose> = bodies.iter().map(|&body| self.states[body].pose).collect();
        let how = (core.settings.step_error(), &mut core.solver);
        let mut done = projection::project(&core.world, &mut self.states, bodies, (touching, held), how)
            .map_err(|source| Core::response_error(t, source))?;
        let pushes = |body: &usize| done.moved_m > PUSH_RELATIVE * core.world.bodies[*body].size;
        if bodies.iter().any(pushes) && self.stay_apart(core, bodies, &start, touching, t)? {
            (done.moved_m, done.unconverged) = (0.0, Vec::new());
        }
        let after = core.accounts.books.balance(&core.world, &self.states, bodies);
        core.book_projection(t, &self.states, &done, (before, after));
        Ok(())
    }

    /// Puts bodies back to the poses `start` if they now overlap neighbours more than there, and all contacts `touching` touch
    /// there; whether it did.
    fn stay_apart(
        &mut self,
        core: &Core,
        bodies: &[usize],
        start: &[Pose],
        touching: &[ContactId],
        t: f64,
    ) -> Result<bool, SimulationError> {
        let mut pairs = BTreeSet::new();
        for &body in bodies {
            let partners = self.near.partners(body).iter().copied().chain(self.contacts.partners(body));
            pairs.extend(partners.map(|other| (body.min(other), body.max(other))));
        }
        let pairs: Vec<_> = pairs.into_iter().collect();
        let mut others: Vec<usize> = pairs.iter().flat_map(|&(a, b)| [a, b]).collect();
        others.sort_unstable();
        others.dedup();
        others.retain(|body| bodies.binary_search(body).is_err() && core.world.bodies[*body].moves());
        let mut states = self.states.clone();
        for other in others {
            states[other] = self.state_at(core, other, t)?;
        }
        let now = Overlaps::find(&core.world, &states, &pairs);
        if !now.is_excess {
            return Ok(false);
        }
        for (&body, pose) in bodies.iter().zip(start) {
            states[body].pose = *pose;
        }
        let then = Overlaps::find(&core.world, &states, &pairs);
        let touches = |&id: &ContactId| {
            let kinematics = core.world.kinematics(&states, id);
            let reach = core.world.touch_distance(&states, id.a, id.b);
            kinematics.is_some_and(|kinematics| kinematics.geometry.separation <= reach)
        };
        let stays = then.deepest_m < now.deepest_m && touching.iter().all(touches);
        if stays {
            for (&body, pose) in bodies.iter().zip(start) {
                self.states[body].pose = *pose;
            }
        }
        Ok(stays)
    }
}
