//! The bodies of an island as trees, and where the coordinates of their joints are in a flat state.
//!
//! | joint | coordinates `q` | speeds `u` |
//! |---|---|---|
//! | none: a free base | place of the centre of mass (3), quaternion (4) | velocity (3), angular velocity (3), world |
//! | ball | quaternion of the child in the frame of the parent (4) | relative angular velocity (3), world |
//! | hinge | angle (1) | its rate (1) |
//! | slider | displacement (1) | its rate (1) |
//!
//! A flat state holds all `q`, then all `u`, each in the order of the nodes, parents before children.

use crate::constraint::joint::ModelJoint;
use crate::constraint::tree_joint::{FreeMotionOfJoint, JointOfChild};
use crate::model::Model;
use std::collections::{BTreeMap, VecDeque};
use std::ops::Range;

/// A body with the joint to its parent.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Node {
    /// The body.
    pub(crate) body: usize,
    /// Its place among the bodies of the island.
    pub(crate) place: usize,
    /// The node of its parent; none for the world.
    pub(crate) parent: Option<usize>,
    /// None for a free base.
    pub(crate) joint: Option<JointOfChild>,
    /// Where its coordinates and its speeds begin.
    pub(crate) first_q: usize,
    pub(crate) first_u: usize,
}

impl Node {
    /// How many coordinates it has.
    pub(crate) fn coordinates(&self) -> usize {
        match self.joint.map(|joint| joint.free) {
            None => 7,
            Some(FreeMotionOfJoint::Ball) => 4,
            Some(FreeMotionOfJoint::Hinge | FreeMotionOfJoint::Slider) => 1,
        }
    }

    /// How many speeds.
    pub(crate) fn speeds(&self) -> usize {
        match self.joint.map(|joint| joint.free) {
            None => 6,
            Some(FreeMotionOfJoint::Ball) => 3,
            Some(FreeMotionOfJoint::Hinge | FreeMotionOfJoint::Slider) => 1,
        }
    }

    /// Where its speeds are.
    pub(crate) fn u(&self) -> Range<usize> {
        self.first_u..self.first_u + self.speeds()
    }
}

/// The trees of an island.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tree {
    /// Parents before children.
    pub(crate) nodes: Vec<Node>,
    /// Numbers of a flat state.
    pub(crate) numbers: usize,
}

impl Tree {
    /// That of these bodies (movable, ascending); none where a joint is of another kind, or closes a loop.
    pub(crate) fn of(model: &Model, bodies: &[usize]) -> Option<Self> {
        // The joints of each body, with the end that it is at and the body at the other one.
        let mut joints_of: BTreeMap<usize, Vec<(usize, usize, Option<usize>)>> = BTreeMap::new();
        let mut roots = Vec::new();
        let joints: Vec<_> = model.joints.joints_among(bodies).map(ModelJoint::tree_joint).collect::<Option<_>>()?;
        for (number, joint) in joints.iter().enumerate() {
            for end in 0..2 {
                let other = joint.ends[1 - end].body;
                let Some(body) = joint.ends[end].body else { continue };
                joints_of.entry(body).or_default().push((number, end, other));
                if other.is_none() {
                    roots.push((body, Some(joint.of_child(1 - end)), Some(number)));
                }
            }
        }
        roots.extend(bodies.iter().map(|&body| (body, None, None)));
        let mut tree = Self { nodes: Vec::with_capacity(bodies.len()), numbers: 0 };
        let mut node_of: BTreeMap<usize, usize> = BTreeMap::new();
        let mut used = 0;
        for (root, joint, number) in roots {
            if node_of.contains_key(&root) {
                continue;
            }
            used += usize::from(number.is_some());
            let mut next = VecDeque::from([(root, None, joint)]);
            while let Some((body, parent, joint)) = next.pop_front() {
                let place = bodies.binary_search(&body).ok()?;
                let own = tree.nodes.len();
                if node_of.insert(body, own).is_some() {
                    return None;
                }
                tree.nodes.push(Node { body, place, parent, joint, first_q: 0, first_u: 0 });
                let held_to = parent.map(|parent: usize| tree.nodes[parent].body);
                for &(number, end, other) in joints_of.get(&body).map_or(&[][..], Vec::as_slice) {
                    let Some(other) = other else { continue };
                    if Some(other) == held_to {
                        continue;
                    }
                    used += 1;
                    next.push_back((other, Some(own), Some(joints[number].of_child(end))));
                }
            }
        }
        // Every joint connects a body to its parent, or closes a loop.
        if used != joints.len() {
            return None;
        }
        tree.number();
        Some(tree)
    }

    /// Gives all nodes their places in a flat state.
    fn number(&mut self) {
        let mut next = 0;
        for node in &mut self.nodes {
            node.first_q = next;
            next += node.coordinates();
        }
        for node in &mut self.nodes {
            node.first_u = next;
            next += node.speeds();
        }
        self.numbers = next;
    }
}
