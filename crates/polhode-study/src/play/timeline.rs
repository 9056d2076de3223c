//! The steps, actions and snapshots of a run that somebody plays with.
//!
//! A run is a pure function of its start, the lengths of its steps, and the actions between them. The timeline keeps
//! the last two, and a snapshot every so many steps: a time that has passed is reached again from the snapshot before
//! it, with the same bits.

use polhode::scene::Material;
use polhode::spatial::DVec3;
use polhode::{BodyId, RunHashPlace, Snapshot};

/// Snapshots that are kept at the most (16 to 1024): when they are as many, every second one is dropped, and later ones
/// are twice as far apart.
const MOST_SNAPSHOTS: usize = 128;

/// Steps between the first snapshots (1 to 64).
const FIRST_STRIDE: u64 = 8;

/// What somebody does to the simulation between two steps.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Action {
    /// A force and a torque that last.
    Load { body: BodyId, force_n: DVec3, torque_nm: DVec3 },
    /// An impulse at a point.
    Push { body: BodyId, impulse_ns: DVec3, point_m: DVec3 },
    /// A body is moved.
    Shift { body: BodyId, by_m: DVec3 },
    /// Another friction and restitution.
    Material(Box<Material>),
}

/// A step that has been made.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Made {
    /// The time reached, s.
    t_s: f64,
    /// Its largest length where one was asked for, s.
    within_s: Option<f64>,
}

/// The state before a step.
#[derive(Debug, Clone)]
pub(super) struct Kept {
    /// The number of the step.
    pub(super) step: u64,
    pub(super) snapshot: Snapshot,
    pub(super) hash: RunHashPlace,
    /// The materials of then, each once.
    pub(super) materials: Vec<Material>,
}

/// All of it.
#[derive(Debug, Clone)]
pub(super) struct Timeline {
    made: Vec<Made>,
    actions: Vec<(u64, Action)>,
    kept: Vec<Kept>,
    stride: u64,
}

impl Default for Timeline {
    fn default() -> Self {
        Self { made: Vec::new(), actions: Vec::new(), kept: Vec::new(), stride: FIRST_STRIDE }
    }
}

impl Timeline {
    /// How many steps have been made.
    pub(super) fn steps(&self) -> u64 {
        self.made.len() as u64
    }

    /// Whether nobody has acted.
    pub(super) fn is_untouched(&self) -> bool {
        self.actions.is_empty() && self.made.iter().all(|made| made.within_s.is_none())
    }

    /// Whether a snapshot is due before the next step.
    pub(super) fn wants_snapshot(&self) -> bool {
        self.steps().is_multiple_of(self.stride) && self.kept.last().is_none_or(|kept| kept.step < self.steps())
    }

    /// Keeps a state before a step.
    pub(super) fn keep(&mut self, kept: Kept) {
        if self.kept.len() >= MOST_SNAPSHOTS {
            self.stride *= 2;
            let stride = self.stride;
            self.kept.retain(|kept| kept.step.is_multiple_of(stride));
        }
        self.kept.push(kept);
    }

    /// Notes an action before the next step.
    pub(super) fn act(&mut self, action: Action) {
        self.actions.push((self.steps(), action));
    }

    /// Notes a step.
    pub(super) fn step(&mut self, t_s: f64, within_s: Option<f64>) {
        self.made.push(Made { t_s, within_s });
    }

    /// How many of the steps end at this time (s) or before it.
    pub(super) fn steps_until(&self, t_s: f64) -> u64 {
        self.made.partition_point(|made| made.t_s <= t_s) as u64
    }

    /// The last state kept at this number of steps or before it.
    pub(super) fn kept_before(&self, step: u64) -> Option<&Kept> {
        self.kept.iter().rev().find(|kept| kept.step <= step)
    }

    /// The largest length of a step where one was asked for (s), and the actions before it.
    pub(super) fn made(&self, step: u64) -> (Option<f64>, Vec<Action>) {
        let within_s = self.made.get(step as usize).and_then(|made| made.within_s);
        (within_s, self.actions.iter().filter(|(own, _)| *own == step).map(|(_, action)| action.clone()).collect())
    }

    /// The body on which a load lasts; none where none does.
    pub(super) fn loaded_body(&self) -> Option<BodyId> {
        self.actions.iter().rev().find_map(|(_, action)| match action {
            Action::Load { body, force_n, torque_nm } => {
                Some((*force_n != DVec3::ZERO || *torque_nm != DVec3::ZERO).then_some(*body))
            }
            _ => None,
        })?
    }

    /// Forgets what follows so many steps.
    pub(super) fn forget_after(&mut self, steps: u64) {
        self.made.truncate(steps as usize);
        self.actions.retain(|(step, _)| *step < steps);
        self.kept.retain(|kept| kept.step <= steps);
    }
}

#[cfg(test)]
mod tests {
    //! Times are found among steps, and what follows one is forgotten with its actions.
    use super::*;

    fn timeline() -> Timeline {
        let mut timeline = Timeline::default();
        for step in 0..10_u32 {
            if step == 4 {
                timeline.act(Action::Shift { body: BodyId::new(0), by_m: DVec3::X });
            }
            timeline.step(0.1 * f64::from(step + 1), None);
        }
        timeline
    }

    #[test]
    fn steps_are_counted_up_to_a_time() {
        let timeline = timeline();
        assert_eq!([-1.0, 0.05, 0.1, 0.35, 9.0].map(|t_s| timeline.steps_until(t_s)), [0, 0, 1, 3, 10]);
    }

    #[test]
    fn going_back_before_an_action_forgets_it() {
        let mut timeline = timeline();
        assert!(!timeline.is_untouched());
        assert_eq!(timeline.made(4).1.len(), 1);
        timeline.forget_after(4);
        assert!(timeline.is_untouched());
        assert_eq!(timeline.steps(), 4);
    }
}
