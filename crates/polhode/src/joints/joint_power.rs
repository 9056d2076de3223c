//! The power that a joint gives to its bodies.

use crate::constraint::joint::ModelJoint;
use crate::model::Model;
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, Pose, Velocity};

/// What a joint that does this to its first body (a force, N, at its anchor, and a moment, N m), and its springs,
/// dampers and motors, give to its bodies, W.
pub(crate) fn power_of_joint(
    model: &Model,
    states: &[BodyState],
    joint: &ModelJoint,
    (force, moment): (DVec3, DVec3),
) -> f64 {
    let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
    let own = model.forces.of_joints.iter().filter(|own| own.joint.number() == joint.number());
    let by_forces: f64 = own.map(|own| own.power(motion)).sum();
    let slip = joint.slip(motion);
    by_forces + force.dot(slip.linear) + moment.dot(slip.angular)
}
