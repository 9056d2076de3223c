//! Joints by their own coordinates: those kinds of joints whose relative motion has coordinates of its own, in which
//! the motion of trees can be written (`crate::reduced`).
//!
//! | kind | coordinates | relative motion of A and B |
//! |---|---|---|
//! | ball | a quaternion | A turns about the anchor |
//! | hinge | an angle, rad | A turns about an axis through the anchor |
//! | slider | a displacement, m | A is displaced along an axis |
//!
//! What is fixed in the bodies is taken from their poses at the start of the run.

use crate::scene::{Joint, JointKind};
use polhode_spatial::{DVec3, Pose, Rotation};

/// The relative motion that a joint of a tree leaves free.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FreeMotionOfJoint {
    Ball,
    Hinge,
    Slider,
}

/// An end of such a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TreeEnd {
    /// The body; none for the world.
    pub(crate) body: Option<usize>,
    /// The anchor in the moving frame of the body, m.
    pub(crate) arm: DVec3,
    /// The axis there (unit vector); of a ball joint it means nothing.
    pub(crate) axis: DVec3,
    /// The attitude at the start.
    attitude: Rotation,
}

/// A joint that may be one of a tree.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TreeJoint {
    pub(crate) free: FreeMotionOfJoint,
    pub(crate) ends: [TreeEnd; 2],
}

/// A joint as its parent sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct JointOfChild {
    pub(crate) free: FreeMotionOfJoint,
    /// The anchor in the moving frame of the parent (of the world: its place), and in that of the child, m.
    pub(crate) parent_arm: DVec3,
    pub(crate) child_arm: DVec3,
    /// The axis in the frame of the parent (unit vector).
    pub(crate) axis: DVec3,
    /// `R_PC` at the start.
    pub(crate) relative: Rotation,
}

/// Whether joints of a kind may be those of trees.
pub(crate) const fn is_of_trees(kind: JointKind) -> bool {
    matches!(kind, JointKind::Ball | JointKind::Hinge { .. } | JointKind::Slider { .. })
}

impl TreeJoint {
    /// A joint between ends with these moving frames at the start (no body: the world); none where it is of another
    /// kind.
    pub(crate) fn of(joint: &Joint, ends: [(Option<usize>, Pose); 2]) -> Option<Self> {
        let (free, axis) = match joint.kind() {
            JointKind::Ball => (FreeMotionOfJoint::Ball, DVec3::Z),
            JointKind::Hinge { axis } => (FreeMotionOfJoint::Hinge, axis.get()),
            JointKind::Slider { axis } => (FreeMotionOfJoint::Slider, axis.get()),
            _ => return None,
        };
        let anchor = joint.anchor();
        let end = |(body, pose): (Option<usize>, Pose)| TreeEnd {
            body,
            arm: pose.inverse_transform_point(anchor),
            axis: pose.rotation.inverse_rotate(axis),
            attitude: pose.rotation,
        };
        Some(Self { free, ends: ends.map(end) })
    }

    /// As the parent sees it that is at its first or second end.
    pub(crate) fn of_child(&self, parent: usize) -> JointOfChild {
        let (parent, child) = (&self.ends[parent.min(1)], &self.ends[1 - parent.min(1)]);
        JointOfChild {
            free: self.free,
            parent_arm: parent.arm,
            child_arm: child.arm,
            axis: parent.axis,
            relative: parent.attitude.inverse() * child.attitude,
        }
    }
}
