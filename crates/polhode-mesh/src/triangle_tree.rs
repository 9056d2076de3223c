//! A tree of bounding boxes over the triangles of a mesh, for lines along z: which triangles one can meet.
//!
//! Boxes are halved along their longer side in the plane of x and y, where lines along z are points, and stored in the
//! order of a depth-first walk with the place to go on when a box is missed. Building is n log n, a query about log n
//! for triangles that do not overlap much in that plane.

use crate::triangle_mesh::Bounds;
use glam::DVec3;
use std::ops::Range;

/// Triangles in a leaf; between 2 and 8 the time hardly changes.
const LEAF: usize = 4;

/// The tree.
#[derive(Debug, Clone)]
pub(crate) struct TriangleTree {
    /// Corners of the triangles in the order of the leaves.
    triangles: Vec<[DVec3; 3]>,
    /// In the order of a depth-first walk.
    nodes: Vec<Node>,
}

#[derive(Debug, Clone)]
struct Node {
    bounds: Bounds,
    /// The triangles of a leaf; empty for a node with two halves, which follow it.
    triangles: Range<usize>,
    /// The node that a walk goes on with when it does not enter this one.
    skip: usize,
}

impl TriangleTree {
    pub(crate) fn new(triangles: Vec<[DVec3; 3]>) -> Self {
        let mut tree = Self { triangles, nodes: Vec::new() };
        tree.split(0..tree.triangles.len());
        tree
    }

    /// The depth is the logarithm of the number of triangles.
    fn split(&mut self, run: Range<usize>) {
        let triangles = &mut self.triangles[run.clone()];
        let bounds = Bounds::of(triangles.iter().flatten().copied());
        let node = self.nodes.len();
        let is_leaf = triangles.len() <= LEAF;
        self.nodes.push(Node { bounds, triangles: if is_leaf { run.clone() } else { 0..0 }, skip: 0 });
        if !is_leaf {
            let size = bounds.max - bounds.min;
            let axis = usize::from(size.y > size.x);
            // Thrice the middle; equal ones may stand in any order, because no result depends on it.
            let middle = |t: &[DVec3; 3]| t[0][axis] + t[1][axis] + t[2][axis];
            let half = triangles.len() / 2;
            triangles.select_nth_unstable_by(half, |s, t| middle(s).total_cmp(&middle(t)));
            self.split(run.start..run.start + half);
            self.split(run.start + half..run.end);
        }
        self.nodes[node].skip = self.nodes.len();
    }

    /// The triangles whose boxes the ray from `point` along +z meets, and perhaps a few more of their leaves.
    pub(crate) fn above(&self, point: DVec3) -> impl Iterator<Item = &[DVec3; 3]> + '_ {
        let mut index = 0;
        std::iter::from_fn(move || {
            while let Some(node) = self.nodes.get(index) {
                let Bounds { min, max } = node.bounds;
                let is_met =
                    min.x <= point.x && point.x <= max.x && min.y <= point.y && point.y <= max.y && point.z <= max.z;
                index = if is_met { index + 1 } else { node.skip };
                if is_met && !node.triangles.is_empty() {
                    return Some(&self.triangles[node.triangles.clone()]);
                }
            }
            None
        })
        .flatten()
    }
}
