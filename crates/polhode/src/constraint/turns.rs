//! The revolutions of angles of joints: those that ties count (`tie.rs`), and those of angles that turn on
//! (`joint_coordinate.rs`).

use super::joint::ModelJoint;
use super::tie::Tie;
use crate::model::Model;
use crate::scene::SceneError;
use crate::snapshot::SnapshotError;
use polhode_dynamics::BodyState;
use polhode_spatial::{Pose, Velocity};
use std::collections::BTreeSet;

impl Model {
    /// Takes the angles whose revolutions joints and ties of these bodies count from their states at the end of a step.
    ///
    /// # Errors
    /// When the force fields cannot be made.
    pub(crate) fn count_turns(&mut self, states: &[BodyState], bodies: &[usize]) -> Result<(), SceneError> {
        let joints = self.joint_places_among(bodies);
        let ties: BTreeSet<usize> =
            bodies.iter().filter_map(|body| self.joints.ties_of_body.get(body)).flatten().copied().collect();
        self.count_turns_of(states, joints.into_iter(), ties.into_iter())
    }

    /// The same of all joints and ties.
    ///
    /// # Errors
    /// When the force fields cannot be made.
    pub(crate) fn count_all_turns(&mut self, states: &[BodyState]) -> Result<(), SceneError> {
        self.count_turns_of(states, 0..self.joints.list.len(), 0..self.joints.ties.len())
    }

    fn count_turns_of(
        &mut self,
        states: &[BodyState],
        joints: impl Iterator<Item = usize>,
        ties: impl Iterator<Item = usize>,
    ) -> Result<(), SceneError> {
        let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, self.velocity(body, &states[body])) };
        let turned = joints.filter_map(|place| {
            let joint = &self.joints.list[place];
            let now = joint.turned_at(motion);
            let has_turned = !joint.turned().eq(now.iter().copied());
            has_turned.then_some((place, now))
        });
        let turned: Vec<(usize, Vec<f64>)> = turned.collect();
        let counted = ties.filter_map(|place| Some((place, self.joints.ties[place].counted_at(motion)?)));
        let counted: Vec<(usize, f64)> = counted.collect();
        let mut is_sprung = false;
        for (place, now) in turned {
            is_sprung |= self.joints.list[place].follow(&now);
        }
        for (place, angle) in counted {
            self.joints.ties[place].set_counted(angle);
        }
        // The fields have joints of their own.
        if is_sprung { self.make_fields() } else { Ok(()) }
    }

    /// What is counted, rad: by the numbers of the ties, then by those of the joints.
    pub(crate) fn turns(&self) -> Vec<(usize, f64)> {
        let of_ties = self.joints.ties.iter().filter_map(|tie| Some((tie.number(), tie.counted()?)));
        of_ties.chain(self.turned_joints()).collect()
    }

    fn turned_joints(&self) -> impl Iterator<Item = (usize, f64)> {
        self.joints.list.iter().flat_map(|joint| joint.turned().map(|near| (joint.number(), near)))
    }

    /// Replaces it.
    ///
    /// # Errors
    /// When it is not of the joints and ties that count revolutions, or not finite.
    pub(crate) fn replace_turns(&mut self, saved: &[(usize, f64)]) -> Result<(), SnapshotError> {
        let refused = SnapshotError::Invalid("its revolutions are not those of the joints and gears of the scene");
        let own: Vec<usize> = self.turns().into_iter().map(|(number, _)| number).collect();
        let is_own = saved.iter().map(|(number, _)| *number).eq(own);
        if !(is_own && saved.iter().all(|(_, angle)| angle.is_finite())) {
            return Err(refused);
        }
        let mut saved = saved.iter().map(|(_, angle)| *angle);
        let counting = self.joints.ties.iter_mut().filter(|tie: &&mut Tie| tie.counted().is_some());
        for (tie, angle) in counting.zip(saved.by_ref()) {
            tie.set_counted(angle);
        }
        for joint in &mut self.joints.list {
            let count = ModelJoint::turned(joint).count();
            let own: Vec<f64> = saved.by_ref().take(count).collect();
            joint.follow(&own);
        }
        self.make_fields().map_err(|_| refused)
    }
}
