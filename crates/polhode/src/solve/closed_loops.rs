//! The poses at which closed loops of joints are closed, next to those that bodies have within a time step.
//!
//! The rows of a closed loop may depend on each other: a four-bar of hinges has three rows more than it can bear, as
//! long as it lies in its plane. After half a step of free flight its joints are open by some `h^2`, and by as much the
//! bodies have left the plane. There the same rows are independent, by some `h^2` of their size, and together they hold
//! the mechanism fast. Where they depend is a property of the closed loop: so the rows are those of the poses at which
//! it is closed.
//!
//! Method: with the rows `J` of the closed poses and the masses of the present ones, impulses `M (v+ - v-) = J^T p`
//! such that `J (v+ + v-) = 0`. Constant terms are the rates of the same rows, so that rows that depend on each other
//! never contradict each other. They do no work; the closed poses follow from those in the middle of the step alone, so
//! that a step is still its own inverse: its error is of the third order. Arms of forces are those of the closed poses,
//! so that forces between two bodies change the angular momentum by some `h^3`, which is booked.
//!
//! Assumption: closed poses are found by the projection of `projection.rs`. Trees of joints have no rows that depend on
//! each other there; they keep the rows of their present poses.
//! Source: the projection of Hairer, Lubich and Wanner 2006, IV.4, in its symmetric form, V.4.1 (docs/REFERENCES.md).

use super::projection::project_positions;
use crate::joints::bilateral::{Bilateral, Reaction, bilateral_support};
use crate::joints::held;
use crate::model::Model;
use crate::model::states_of::{set_states, states_of};
use crate::report::momentum_ledger::{Momentum, MomentumSum};
use crate::rows::groups::coupled_groups;
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;
use polhode_spatial::{DVec3, Pose};
use std::collections::BTreeMap;

/// The poses of bodies in closed loops at which these are closed.
#[derive(Debug, Clone, Default)]
pub(crate) struct ClosedLoops {
    poses: BTreeMap<usize, Pose>,
}

impl ClosedLoops {
    /// Those next to the poses of these bodies (movable, ascending), of each group that joints connect for itself. The
    /// states are the same afterwards.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn of(model: &Model, states: &mut [BodyState], bodies: &[usize]) -> Result<Self, ResponseError> {
        let mut closed = Self::default();
        if !held::has_loops_among(model, bodies) {
            return Ok(closed);
        }
        for group in coupled_groups(model, std::iter::empty(), bodies) {
            if !held::has_loops_among(model, &group.bodies) {
                continue;
            }
            let present = states_of(states, &group.bodies);
            let projected = project_positions(model, states, &group.bodies, &[]);
            closed.poses.extend(group.bodies.iter().map(|&body| (body, states[body].pose)));
            set_states(states, &group.bodies, &present);
            projected?;
        }
        Ok(closed)
    }

    /// The bilateral constraints of these bodies with the rows of the closed poses and the velocities of these states.
    pub(crate) fn bilaterals<'a>(
        &'a self,
        model: &'a Model,
        states: &'a [BodyState],
        bodies: &'a [usize],
    ) -> impl Iterator<Item = Bilateral> + 'a {
        held::bilaterals_by(model, bodies, |body| {
            let (pose, velocity) = held::motion_of(model, states, body);
            (self.poses.get(&body).copied().unwrap_or(pose), velocity)
        })
    }

    /// Whether some of these bodies are in closed loops.
    pub(crate) fn hold_any(&self, bodies: &[usize]) -> bool {
        bodies.iter().any(|body| self.poses.contains_key(body))
    }

    /// What reactions between bodies change their momentum by because their arms are those of the closed poses, angular
    /// about a point (m, world).
    pub(crate) fn stray_momentum<'a>(
        &self,
        states: &[BodyState],
        about: DVec3,
        reactions: impl Iterator<Item = (&'a Bilateral, Reaction)> + Clone,
    ) -> Momentum {
        if self.poses.is_empty() {
            return Momentum::default();
        }
        let mut sum = MomentumSum::default();
        for (constraint, reaction) in reactions.clone() {
            for (body, linear, moment) in constraint.loads(reaction) {
                let angular = (states[body].pose.translation - about).cross(linear) + moment;
                sum.add(Momentum { linear, angular });
            }
        }
        sum.value() - bilateral_support(about, reactions)
    }
}
