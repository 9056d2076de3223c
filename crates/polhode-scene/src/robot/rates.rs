//! How the links of a robot move at the start: from the rates of its coordinates to velocities.
//!
//! From the root outward `w = w_P + a q'` and `v = v_P + w_P x (x - x_P) + (a q') x (x - x_A)` at the origin `x` of a
//! link, with P its parent, `a` the axis of its joint and A a point of it; a slider adds `a q'` to `v`.

use super::model::{Robot, RobotJointKind};
use glam::DVec3;
use polhode::spatial::{Pose, Velocity};

/// The velocity of the origin of each link and its angular velocity, along the axes of the model. `rates` are those of
/// the joints: their coordinates as a keyframe has them. Links stand behind their parents.
pub(super) fn velocities(robot: &Robot, poses: &[Pose], rates: &[Vec<f64>]) -> Vec<Velocity> {
    let mut velocities = vec![Velocity::ZERO; robot.links.len()];
    for (joint, rates) in robot.joints.iter().zip(rates) {
        let (pose, above) = (poses[joint.child], velocities[joint.parent]);
        let along = |axis: DVec3| pose.rotation.rotate(axis);
        let rate = |index: usize| rates.get(index).copied().unwrap_or(0.0);
        let three = |first: usize| DVec3::new(rate(first), rate(first + 1), rate(first + 2));
        let carried = above.at(pose.translation - poses[joint.parent].translation);
        let arm = pose.translation - pose.transform_point(joint.anchor);
        let turning = |own: DVec3| Velocity::new(carried + own.cross(arm), above.angular + own);
        velocities[joint.child] = match joint.kind {
            RobotJointKind::Free => Velocity::new(three(0), along(three(3))),
            RobotJointKind::Ball => turning(along(three(0))),
            RobotJointKind::Hinge { axis } => turning(along(axis.get()) * rate(0)),
            RobotJointKind::Slider { axis } => Velocity::new(carried + along(axis.get()) * rate(0), above.angular),
            _ => Velocity::new(carried, above.angular),
        };
    }
    velocities
}

/// The inertia that the coordinate of a joint moves in these poses, kg m^2 of a hinge, kg of a slider: of all links
/// behind it, the others at rest.
pub(super) fn inertia(robot: &Robot, poses: &[Pose], number: usize) -> f64 {
    let mut rates = vec![Vec::new(); robot.joints.len()];
    rates[number] = vec![1.0];
    let velocities = velocities(robot, poses, &rates);
    let twice_energy = |(link, pose): (usize, &Pose)| {
        let own = robot.links[link].inertial.as_ref()?;
        let frame = *pose * own.frame;
        let velocity = velocities[link];
        let center = velocity.at(frame.translation - pose.translation);
        let turning = frame.rotation.inverse().rotate(velocity.angular);
        Some(own.mass * center.length_squared() + turning.dot(own.inertia * turning))
    };
    poses.iter().enumerate().filter_map(twice_energy).sum()
}
