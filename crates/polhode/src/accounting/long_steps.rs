//! Steps of a fixed length that are too long for what they move: a body passes its own size in one, or turns by a
//! radian.
//!
//! A fixed step takes the contacts that it finds at its ends (or predicts from its start). A body that passes its own
//! size in a step may pass another body, and one that turns by a radian may turn a corner through it, without a
//! contact. Only steps in which a body may touch another one count: a flight alone is exact at any step.

use crate::model::Model;
use crate::snapshot::content;
use polhode_dynamics::BodyState;

/// The angle by which a body may turn in one step, rad: within it the chord is the arc to a twentieth.
const LARGEST_TURN_OF_STEP: f64 = 1.0;

/// How far a body moved in one step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Movement {
    pub(crate) body: usize,
    /// End of the step, s.
    pub(crate) t: f64,
    /// Length of the step, s.
    pub(crate) step_s: f64,
    /// Relative to the size of the body.
    pub(crate) travel: f64,
    /// rad.
    pub(crate) turn: f64,
    /// A step in which the body stays within the limits, s: by its motion in this step, and from rest under gravity.
    pub(crate) enough_s: f64,
}

impl Movement {
    /// That of a body between two states, in a step from `t` over `h` (s). The rotation is the faster one of both.
    pub(crate) fn between(
        model: &Model,
        body: usize,
        (start, end): (&BodyState, &BodyState),
        (t, h): (f64, f64),
    ) -> Self {
        let way = (end.pose.translation - start.pose.translation).length();
        let rates = [start, end].map(|state| model.velocity(body, state).angular.length());
        let size = model.bodies[body].size;
        let (travel, turn) = (way / size, h * rates[0].max(rates[1]));
        let falls = (2.0 * size / model.gravity().length()).sqrt();
        let enough_s = falls.min(h / travel.max(turn / LARGEST_TURN_OF_STEP));
        Self { body, t: t + h, step_s: h, travel, turn, enough_s }
    }

    /// How many times the step is too long.
    fn excess(&self) -> f64 {
        self.travel.max(self.turn / LARGEST_TURN_OF_STEP)
    }
}

/// Steps that were too long.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct LongSteps {
    count: u64,
    /// Time of the first one, s.
    first_s: f64,
    worst: Option<Movement>,
}

impl LongSteps {
    /// Records how far a body moved in one step; those within the limits are ignored.
    pub(crate) fn note(&mut self, movement: Movement) {
        // NaN is detected by the check of states.
        if movement.excess().is_nan() || movement.excess() <= 1.0 {
            return;
        }
        if self.count == 0 {
            self.first_s = movement.t;
        }
        self.count += 1;
        if self.worst.is_none_or(|worst| movement.excess() > worst.excess()) {
            self.worst = Some(movement);
        }
    }

    /// The warning, if a step was too long.
    pub(crate) fn warning(&self, model: &Model) -> Option<String> {
        let worst = self.worst?;
        let Movement { body, t, step_s, travel, turn, enough_s } = worst;
        let name = &model.bodies[body].name;
        let moved = if travel >= turn / LARGEST_TURN_OF_STEP {
            format!("{name} moved by {travel:.3} times its size")
        } else {
            format!("{name} turned by {turn:.3} rad")
        };
        let enough = 0.95 * enough_s;
        let times = if self.count == 1 {
            "once".to_owned()
        } else {
            format!("{} times, first at t = {} s", self.count, self.first_s)
        };
        Some(format!(
            "t = {t} s: {moved} in one step of {step_s:e} s, where contacts may be missed ({times}): a step of \
             {enough:.1e} s would do"
        ))
    }

    /// As plain data.
    pub(super) fn save(&self) -> content::LongSteps {
        let worst = self.worst.map(|Movement { body, t, step_s, travel, turn, enough_s }| content::Movement {
            body,
            t,
            step_s,
            travel,
            turn,
            enough_s,
        });
        content::LongSteps { count: self.count, first_s: self.first_s, worst }
    }

    /// From such data of a scene with this many bodies; none when it names a body that does not exist.
    pub(super) fn restored(saved: &content::LongSteps, bodies: usize) -> Option<Self> {
        let movement = |content::Movement { body, t, step_s, travel, turn, enough_s }| Movement {
            body,
            t,
            step_s,
            travel,
            turn,
            enough_s,
        };
        let worst = saved.worst.map(movement);
        worst.is_none_or(|worst| worst.body < bodies).then_some(Self {
            count: saved.count,
            first_s: saved.first_s,
            worst,
        })
    }
}
