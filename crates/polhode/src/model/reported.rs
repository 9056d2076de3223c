//! Bodies as they are reported: poses of their own origins, velocities and accelerations of their centres of mass.

use super::bodies::Model;
use super::body::ModelBody;
use crate::identity::body_id::BodyId;
use crate::model::prescribed_state;
use crate::report::acceleration::Acceleration;
use crate::report::body_sample::{BodySample, ReportedBody};
use crate::scene::MOST_NAMES;
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::{DVec3, Pose, Velocity};

/// A body's pose and velocity as they are reported. The velocity is that of the centre of mass; of a kinematic
/// body, which has none, that of its own origin.
pub(crate) fn sample(model: &Model, index: usize, state: &BodyState) -> BodySample {
    let body = &model.bodies[index];
    let velocity = match (&body.rigid, &body.trajectory) {
        (Some(rigid), _) => rigid.center_of_mass_velocity(state),
        (None, Some(_)) => prescribed_state::velocity_of(state),
        (None, None) => Velocity::ZERO,
    };
    BodySample { pose: state.pose * Pose::from_translation(-body.origin), velocity }
}

/// As [`Model::sample`], of a movable body with its mass properties `rigid`.
pub(crate) fn sample_of(model: &Model, index: usize, rigid: &RigidBody, state: &BodyState) -> BodySample {
    let pose = state.pose * Pose::from_translation(-model.bodies[index].origin);
    BodySample { pose, velocity: rigid.center_of_mass_velocity(state) }
}

/// A body's acceleration as it is reported: that of the centre of mass, computed from that of the origin of the
/// moving frame.
pub(crate) fn reported_acceleration(
    model: &Model,
    body: usize,
    state: &BodyState,
    linear: DVec3,
    angular: DVec3,
) -> Acceleration {
    let Some(rigid) = &model.bodies[body].rigid else { return Acceleration { linear, angular } };
    let arm = state.pose.rotation.rotate(rigid.arm());
    let w = rigid.angular_velocity(state);
    Acceleration { linear: linear + angular.cross(arm) + w.cross(w.cross(arm)), angular }
}

/// The pose of a body's moving frame from that of its own origin.
pub(crate) fn moving_pose(model: &Model, body: usize, pose: Pose) -> Pose {
    pose * Pose::from_translation(model.bodies[body].origin)
}

/// Names of all bodies and their states as they are reported.
pub(crate) fn named_samples(model: &Model, states: &[BodyState]) -> Vec<ReportedBody> {
    let named = model.bodies.iter().zip(states).take(model.shown()).enumerate();
    let reported = |(index, (body, state)): (usize, (&ModelBody, &BodyState))| ReportedBody {
        body: BodyId::new(index),
        name: body.name.clone(),
        state: sample(model, index, state),
    };
    named.map(reported).collect()
}

/// The names of two bodies, as warnings give them.
pub(crate) fn pair_names(model: &Model, a: usize, b: usize) -> String {
    if a == b { names_of(model, &[a]) } else { names_of(model, &[a, b]) }
}

/// The names of some bodies, as warnings give them; of many only the first.
pub(crate) fn names_of(model: &Model, bodies: &[usize]) -> String {
    let names: Vec<_> = bodies.iter().take(MOST_NAMES).map(|&body| model.bodies[body].name.as_str()).collect();
    let named = names.join(" and ");
    match bodies.len().saturating_sub(MOST_NAMES) {
        0 => named,
        more => format!("{named} and {more} more"),
    }
}
