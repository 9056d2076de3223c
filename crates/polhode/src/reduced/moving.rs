//! Poses and velocities of the bodies of a tree from the coordinates of its joints, and back.
//!
//! With the attitudes `R_P` and `R_C` of parent and child, and their anchors `a_P` and `a_C` in their frames:
//!
//! | joint | `R_C` | anchor of the child |
//! |---|---|---|
//! | hinge | `R_P exp(n q) R_0` | that of the parent |
//! | ball | `R_P Q` | that of the parent |
//! | slider | `R_P R_0` | that of the parent, displaced by `q` along the axis |
//!
//! The centre of mass of the child is at its anchor less `R_C a_C`. Velocities follow from those of the parent in the
//! same way.

use super::tree::{Node, Tree};
use crate::constraint::tree_joint::{FreeMotionOfJoint, JointOfChild};
use crate::model::Model;
use polhode_dynamics::BodyState;
use polhode_dynamics::state::quaternion_rate;
use polhode_spatial::{DQuat, DVec3, Pose, Rotation, Velocity};

/// A body of a tree, with what its joint needs, in world axes.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Moving {
    pub(super) pose: Pose,
    pub(super) velocity: Velocity,
    /// The axis of its joint (unit vector).
    pub(super) axis: DVec3,
    /// From the centres of mass of parent (of the world: its origin) and child to the anchor, m.
    pub(super) parent_arm: DVec3,
    pub(super) arm: DVec3,
    /// From the centre of mass of the parent to its own, m.
    pub(super) away: DVec3,
}

impl Tree {
    /// The bodies, in the order of the nodes, from a flat state.
    pub(super) fn moving(&self, flat: &[f64], moving: &mut Vec<Moving>) {
        moving.clear();
        for node in &self.nodes {
            let Some(joint) = &node.joint else {
                moving.push(base(node, flat));
                continue;
            };
            let parent = node.parent.map_or_else(Moving::default, |parent| moving[parent]);
            moving.push(child(&parent, (node, joint), flat));
        }
    }

    /// The flat state of bodies in these states.
    pub(crate) fn coordinates(&self, model: &Model, states: &[BodyState]) -> Vec<f64> {
        let mut flat = vec![0.0; self.numbers];
        for node in &self.nodes {
            let (pose, velocity) = motion(model, states, node.body);
            let u = node.u();
            let Some(joint) = &node.joint else {
                flat[node.first_q..node.first_q + 3].copy_from_slice(&pose.translation.to_array());
                flat[node.first_q + 3..node.first_q + 7].copy_from_slice(&pose.rotation.to_wxyz());
                flat[u.start..u.start + 3].copy_from_slice(&velocity.linear.to_array());
                flat[u.start + 3..u.end].copy_from_slice(&velocity.angular.to_array());
                continue;
            };
            let parent = node.parent.map(|parent| self.nodes[parent].body);
            let (from, by) =
                parent.map_or_else(|| (Pose::IDENTITY, Velocity::default()), |body| motion(model, states, body));
            let relative = from.rotation.inverse() * pose.rotation;
            let turning = velocity.angular - by.angular;
            let axis = from.rotation.rotate(joint.axis);
            match joint.free {
                FreeMotionOfJoint::Ball => {
                    flat[node.first_q..node.first_q + 4].copy_from_slice(&relative.to_wxyz());
                    flat[u].copy_from_slice(&turning.to_array());
                }
                FreeMotionOfJoint::Hinge => {
                    let [w, x, y, z] = (relative * joint.relative.inverse()).to_wxyz();
                    flat[node.first_q] = 2.0 * libm::atan2(joint.axis.dot(DVec3::new(x, y, z)), w);
                    flat[u.start] = axis.dot(turning);
                }
                FreeMotionOfJoint::Slider => {
                    let parent_anchor = from.translation + from.rotation.rotate(joint.parent_arm);
                    let gap = pose.translation + pose.rotation.rotate(joint.child_arm) - parent_anchor;
                    flat[node.first_q] = axis.dot(gap);
                    let carried = by.linear + by.angular.cross(pose.translation - from.translation);
                    flat[u.start] = axis.dot(velocity.linear - carried);
                }
            }
        }
        flat
    }

    /// Writes the states of its bodies, by their places in the island, from a flat state.
    pub(crate) fn states(&self, model: &Model, flat: &[f64], mut write: impl FnMut(&Node, BodyState)) {
        let mut moving = Vec::with_capacity(self.nodes.len());
        self.moving(flat, &mut moving);
        for (node, own) in self.nodes.iter().zip(&moving) {
            if let Some(rigid) = &model.bodies[node.body].rigid {
                write(node, rigid.at_velocity(own.pose, own.velocity));
            }
        }
    }

    /// The rates of the coordinates, from a flat state and its bodies.
    pub(super) fn coordinate_rates(&self, flat: &[f64], moving: &[Moving], rates: &mut [f64]) {
        for (node, own) in self.nodes.iter().zip(moving) {
            let (q, u) = (node.first_q, node.u());
            match node.joint.map(|joint| joint.free) {
                None => {
                    rates[q..q + 3].copy_from_slice(&flat[u.start..u.start + 3]);
                    rates[q + 3..q + 7]
                        .copy_from_slice(&quaternion_rate(quaternion(flat, q + 3), own.velocity.angular));
                }
                Some(FreeMotionOfJoint::Ball) => {
                    let parent = node.parent.map_or(Rotation::IDENTITY, |parent| moving[parent].pose.rotation);
                    let turning = parent.inverse_rotate(vector(flat, u.start));
                    rates[q..q + 4].copy_from_slice(&quaternion_rate(quaternion(flat, q), turning));
                }
                Some(FreeMotionOfJoint::Hinge | FreeMotionOfJoint::Slider) => rates[q] = flat[u.start],
            }
        }
    }
}

/// The pose of the moving frame of a body, and its velocity.
fn motion(model: &Model, states: &[BodyState], body: usize) -> (Pose, Velocity) {
    (states[body].pose, model.velocity(body, &states[body]))
}

/// Three numbers of a flat state.
fn vector(flat: &[f64], first: usize) -> DVec3 {
    DVec3::new(flat[first], flat[first + 1], flat[first + 2])
}

/// Four numbers of a flat state, as they are.
fn quaternion(flat: &[f64], first: usize) -> DQuat {
    DQuat::from_xyzw(flat[first + 1], flat[first + 2], flat[first + 3], flat[first])
}

fn base(node: &Node, flat: &[f64]) -> Moving {
    let rotation = Rotation::renormalized(quaternion(flat, node.first_q + 3));
    let pose = Pose::new(rotation, vector(flat, node.first_q));
    let velocity = Velocity::new(vector(flat, node.first_u), vector(flat, node.first_u + 3));
    Moving { pose, velocity, ..Moving::default() }
}

fn child(parent: &Moving, (node, joint): (&Node, &JointOfChild), flat: &[f64]) -> Moving {
    let axis = parent.pose.rotation.rotate(joint.axis);
    let (q, u) = (flat[node.first_q], flat[node.first_u]);
    let (turned, turning) = match joint.free {
        FreeMotionOfJoint::Ball => (Rotation::renormalized(quaternion(flat, node.first_q)), vector(flat, node.first_u)),
        FreeMotionOfJoint::Hinge => (Rotation::from_rotation_vector(joint.axis * q) * joint.relative, axis * u),
        FreeMotionOfJoint::Slider => (joint.relative, DVec3::ZERO),
    };
    let rotation = parent.pose.rotation * turned;
    let parent_arm = parent.pose.rotation.rotate(joint.parent_arm);
    let arm = rotation.rotate(joint.child_arm);
    let (shift, speed) = match joint.free {
        FreeMotionOfJoint::Slider => (axis * q, axis * u),
        FreeMotionOfJoint::Ball | FreeMotionOfJoint::Hinge => (DVec3::ZERO, DVec3::ZERO),
    };
    let away = parent_arm + shift - arm;
    let angular = parent.velocity.angular + turning;
    // The anchor of the child goes with the parent, and the child turns about it.
    let anchor = parent.velocity.linear + parent.velocity.angular.cross(parent_arm + shift) + speed;
    let velocity = Velocity::new(anchor - angular.cross(arm), angular);
    let pose = Pose::new(rotation, parent.pose.translation + away);
    Moving { pose, velocity, axis, parent_arm: parent_arm + shift, arm, away }
}
