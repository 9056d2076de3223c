//! The revolutions of angles of joints: those that ties count (`tie.rs`), and those of angles that turn on
//! (`joint_coordinate.rs`).

use crate::constraint::joint::ModelJoint;
use crate::constraint::tie::Tie;
use crate::model::{Joints, Model};
use crate::scene::SceneError;
use crate::snapshot::SnapshotError;
use polhode_dynamics::BodyState;
use polhode_spatial::{Pose, Velocity};
use std::collections::BTreeSet;

impl Joints {
    /// What is counted, rad: by the numbers of the ties, then by those of the joints.
    pub(crate) fn turns(&self) -> Vec<(usize, f64)> {
        let of_ties = self.ties.iter().filter_map(|tie| Some((tie.number(), tie.counted()?)));
        of_ties.chain(self.turned_joints()).collect()
    }

    fn turned_joints(&self) -> impl Iterator<Item = (usize, f64)> {
        self.list.iter().flat_map(|joint| joint.turned().map(|near| (joint.number(), near)))
    }
}

/// Takes the angles whose revolutions joints and ties of these bodies count from their states at the end of a step.
///
/// # Errors
/// When the force fields cannot be made.
pub(crate) fn count_turns(model: &mut Model, states: &[BodyState], bodies: &[usize]) -> Result<(), SceneError> {
    let joints = model.joints.joint_places_among(bodies);
    let ties: BTreeSet<usize> =
        bodies.iter().filter_map(|body| model.joints.ties_of_body.get(body)).flatten().copied().collect();
    count_turns_of(model, states, joints.into_iter(), ties.into_iter())
}

/// The same of all joints and ties.
///
/// # Errors
/// When the force fields cannot be made.
pub(crate) fn count_all_turns(model: &mut Model, states: &[BodyState]) -> Result<(), SceneError> {
    count_turns_of(model, states, 0..model.joints.list.len(), 0..model.joints.ties.len())
}

fn count_turns_of(
    model: &mut Model,
    states: &[BodyState],
    joints: impl Iterator<Item = usize>,
    ties: impl Iterator<Item = usize>,
) -> Result<(), SceneError> {
    let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
    let turned = joints.filter_map(|place| {
        let joint = &model.joints.list[place];
        let now = joint.turned_at(motion);
        let has_turned = !joint.turned().eq(now.iter().copied());
        has_turned.then_some((place, now))
    });
    let turned: Vec<(usize, Vec<f64>)> = turned.collect();
    let counted = ties.filter_map(|place| Some((place, model.joints.ties[place].counted_at(motion)?)));
    let counted: Vec<(usize, f64)> = counted.collect();
    let mut is_sprung = false;
    for (place, now) in turned {
        is_sprung |= model.joints.list[place].follow(&now);
    }
    for (place, angle) in counted {
        model.joints.ties[place].set_counted(angle);
    }
    // The fields have joints of their own.
    if is_sprung { model.make_fields() } else { Ok(()) }
}

/// Replaces it.
///
/// # Errors
/// When it is not of the joints and ties that count revolutions, or not finite.
pub(crate) fn replace_turns(model: &mut Model, saved: &[(usize, f64)]) -> Result<(), SnapshotError> {
    let refused = SnapshotError::Invalid("its revolutions are not those of the joints and gears of the scene");
    let own: Vec<usize> = model.joints.turns().into_iter().map(|(number, _)| number).collect();
    let is_own = saved.iter().map(|(number, _)| *number).eq(own);
    if !(is_own && saved.iter().all(|(_, angle)| angle.is_finite())) {
        return Err(refused);
    }
    let mut saved = saved.iter().map(|(_, angle)| *angle);
    let counting = model.joints.ties.iter_mut().filter(|tie: &&mut Tie| tie.counted().is_some());
    for (tie, angle) in counting.zip(saved.by_ref()) {
        tie.set_counted(angle);
    }
    for joint in &mut model.joints.list {
        let count = ModelJoint::turned(joint).count();
        let own: Vec<f64> = saved.by_ref().take(count).collect();
        joint.follow(&own);
    }
    model.make_fields().map_err(|_| refused)
}
