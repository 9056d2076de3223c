//! Flat positions of closed loops ahead: where the bars of a linkage lie in one line.
//!
//! There rows of joints depend on each other that do not beside it, and another branch of motion leaves (a
//! parallelogram may become an anti-parallelogram). The motion that goes on with continuous velocities is smooth
//! through the flat position, but forces of joints have a pole of first order there, and so do accelerations off the
//! branch: there the error of a method does not fall with its step, whose stages are off the branch by their own
//! errors. So beside a flat position each stage is evaluated at the closed poses next to it, with velocities that keep
//! the joints ([`Stages::Closed`]). These are on the branch, and the motion that the method sees is smooth. At the flat
//! position itself nothing tells the branches apart: a step passes it where the method has no stage, that of DOP853
//! from a third to three fifths of its length ([`GAP`]). The branch taken is that on which velocities are
//! continuous.
//!
//! When it is reached: how far rows are from depending on each other is the least pivot of their Jacobian
//! (`polhode_response::solve::held::Supports`), which falls linearly with the distance. Two of them, an instant apart
//! along the motion, give its time. Limit: where motion begins at a flat position a stage has to lie there, and steps
//! are short.

use super::pace::instant;
use crate::joints::held;
use crate::model::{Model, prescribed};
use crate::rows::assembly::Assembly;
use crate::solve::projection::{Removal, project_positions, project_velocities};
use crate::tier::core::Core;
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;
use polhode_spatial::Rotation;

/// The largest gap between the stages of DOP853, in lengths of the step (no unit): the flat position lies in its
/// middle.
const GAP: [f64; 2] = [1.0 / 3.0, 3.0 / 5.0];

/// At which poses the stages of a step are evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stages {
    /// Those that the method gives.
    AsTheyAre,
    /// Those next to them at which joints are closed, with velocities that keep them.
    Closed,
}

impl Stages {
    /// Moves the bodies to where their forces are evaluated.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn place(self, model: &Model, states: &mut [BodyState], bodies: &[usize]) -> Result<(), ResponseError> {
        if self == Self::Closed {
            project_positions(model, states, bodies, &[])?;
            project_velocities(model, states, bodies, (&[], &[], &[]), Removal::Complete)?;
        }
        Ok(())
    }
}

/// A flat position ahead or behind.
#[derive(Debug, Clone, Copy)]
pub(super) struct FlatPosition {
    /// The time to it, s; negative after it.
    time_s: f64,
    /// How far the rows are from depending on each other now (no unit).
    independence: f64,
}

impl FlatPosition {
    /// The one next to these bodies at `t` (s), if their loops have one. `beside` are overwritten.
    pub(super) fn near(
        core: &Core,
        states: &[BodyState],
        bodies: &[usize],
        t: f64,
        beside: &mut [BodyState],
    ) -> Option<Self> {
        let model = &core.model;
        if !held::has_loops_among(model, bodies) {
            return None;
        }
        let look = instant(core.settings.step_s);
        for &body in bodies {
            let (state, velocity) = (states[body], model.velocity(body, &states[body]));
            beside[body] = state;
            beside[body].pose.translation += velocity.linear * look;
            beside[body].pose.rotation = Rotation::from_rotation_vector(velocity.angular * look) * state.pose.rotation;
        }
        prescribed::prescribe(model, t + look, beside);
        let independence = |states: &[BodyState]| {
            let mut assembly = Assembly::new(model, states, bodies, std::iter::empty()).ok()?;
            assembly.find_supports();
            assembly.independence()
        };
        let (now, then) = (independence(states)?, independence(beside)?);
        let approach = now.least - then.least;
        let is_found = now.rank == then.rank && approach != 0.0;
        is_found.then_some(Self { time_s: look * now.least / approach, independence: now.least })
    }

    /// How the stages of a step of `h` (s) are evaluated.
    pub(super) fn stages(self, h: f64) -> Stages {
        if 0.5 * self.time_s.abs() <= h { Stages::Closed } else { Stages::AsTheyAre }
    }

    /// The length of a step (s) that does not end near it, where `proposed` (s) is proposed and the limit cuts it to
    /// `length` (s): it passes it between its stages, or leaves that to the next step. Where the limit is next to it,
    /// the step goes beyond the limit, and ends where its own polynomials say.
    pub(super) fn length_beside(self, proposed: f64, length: f64) -> f64 {
        let (time, middle) = (self.time_s, 0.5 * (GAP[0] + GAP[1]));
        let across = time / middle;
        let ends_near_it = GAP[0] * across < length && length < across;
        if time <= 0.0 {
            length
        } else if across <= length || (ends_near_it && across <= proposed) {
            across
        } else if 0.5 * across <= length {
            0.5 * time
        } else {
            length.min(time - middle * length)
        }
    }

    /// Whether a step of `h` (s) has its end near it.
    pub(super) fn is_near_end(self, h: f64) -> bool {
        self.length_beside(h, h) < h
    }

    /// What the rounding of a pose by a metre makes of accelerations in a step of `h` (s), 1/s^2: next to the flat
    /// position a gap `g` puts bodies off the branch by `g` over the distance, and `2 g / t^3` of that is acceleration.
    pub(super) fn acceleration_of_gaps(self, h: f64) -> f64 {
        let time = self.time_s;
        let is_passed = 0.0 < time && time < h;
        let least = if is_passed { 0.5 * (GAP[1] - GAP[0]) * h } else { f64::INFINITY };
        let nearest = least.min(time.abs()).min((time - h).abs());
        2.0 * time.abs() / (self.independence * nearest * nearest * nearest)
    }
}
