//! How far a solid is from convex.
//!
//! A solid is convex when every vertex lies on or behind the plane of every face (thesis 3.2: a convex object is the
//! intersection of the half-spaces of its triangles). Measured is the largest distance of a vertex in front of a plane.
//! A thin triangle does not know its own plane: rounding its corners tilts it by up to rounding over height, and what
//! that tilt explains is not counted. Degenerate triangles have no plane and are left out.
//!
//! The farthest vertex in front of each plane is found in a tree of bounding boxes, pruned by the largest distance so
//! far. A plane that touches a round solid of n vertices meets about sqrt(n) boxes, so the time grows as n^1.5.

use crate::triangle_mesh::{Bounds, COORDINATE_ROUNDING};
use crate::{SolidMesh, TriangleMesh};
use glam::DVec3;
use polhode_spatial::rounding;
use std::ops::Range;

/// Vertices in a leaf of the tree; between 4 and 32 the time hardly changes.
const LEAF: usize = 8;

/// How convex a solid is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Convexity {
    /// Largest distance of a vertex in front of the plane of a face, m, less what rounding of the coordinates
    /// explains; 0 for a convex solid.
    pub excess: f64,
    /// The vertex and the triangle (counted from 0) it stands in front of, when there is any.
    pub worst: Option<(u32, u32)>,
    /// Diagonal of the solid's bounding box, m, that the excess is compared with.
    pub size: f64,
}

impl Convexity {
    /// Whether the solid is convex to [`rounding::DIGITS_OF_A_FILE`].
    pub fn is_convex(&self) -> bool {
        self.excess <= rounding::DIGITS_OF_A_FILE * self.size
    }
}

/// Measures how far `solid` is from convex.
pub fn convexity(solid: &SolidMesh) -> Convexity {
    let mesh = solid.mesh();
    let bounds = mesh.bounds();
    let (reference, size) = (bounds.center(), bounds.diagonal());
    let rounding = COORDINATE_ROUNDING * bounds.largest_coordinate();
    let tree = Tree::of(mesh, reference);
    let mut result = Convexity { excess: 0.0, worst: None, size };
    for (triangle, &corners) in (0u32..).zip(mesh.triangles()) {
        let [a, b, c] = mesh.corners(corners).map(|p| p - reference);
        let cross = (b - a).cross(c - a);
        let twice_area = cross.length();
        let height = twice_area / (b - a).length().max((c - b).length()).max((a - c).length());
        // NaN is the height of a point.
        if height <= rounding || height.is_nan() {
            continue;
        }
        let normal = cross / twice_area;
        let allowance = rounding * (1.0 + size / height);
        let plane = normal.dot(a) + allowance;
        if let Some((vertex, distance)) = tree.farthest(normal, plane + result.excess) {
            result.excess += distance;
            result.worst = Some((vertex, triangle));
        }
    }
    result
}

/// The vertices that triangles use, in a balanced tree of bounding boxes.
struct Tree {
    points: Vec<(DVec3, u32)>,
    /// In the order of a depth-first walk.
    nodes: Vec<Node>,
}

/// A box around a run of points.
struct Node {
    bounds: Bounds,
    /// The points of a leaf; empty for a node with two halves, which follow it.
    points: Range<usize>,
    /// The node that a walk goes on with when it does not enter this one.
    skip: usize,
}

impl Tree {
    fn of(mesh: &TriangleMesh, reference: DVec3) -> Self {
        let mut indices: Vec<u32> = mesh.triangles().iter().flatten().copied().collect();
        indices.sort_unstable();
        indices.dedup();
        let vertices = mesh.vertices();
        let points = indices.into_iter().map(|index| (vertices[index as usize] - reference, index)).collect();
        let mut tree = Self { points, nodes: Vec::new() };
        tree.split(0..tree.points.len());
        tree
    }

    /// Sorts a run of points into halves along the longest side of their box, recursively, and lists the nodes. The
    /// depth is the logarithm of the number of points.
    fn split(&mut self, run: Range<usize>) {
        let points = &mut self.points[run.clone()];
        let bounds = Bounds::of(points.iter().map(|&(point, _)| point));
        let node = self.nodes.len();
        let is_leaf = points.len() <= LEAF;
        self.nodes.push(Node { bounds, points: if is_leaf { run.clone() } else { 0..0 }, skip: 0 });
        if !is_leaf {
            let axis = (bounds.max - bounds.min).max_position();
            let half = points.len() / 2;
            points.select_nth_unstable_by(half, |p, q| p.0[axis].total_cmp(&q.0[axis]).then(p.1.cmp(&q.1)));
            self.split(run.start..run.start + half);
            self.split(run.start + half..run.end);
        }
        self.nodes[node].skip = self.nodes.len();
    }

    /// The vertex farthest beyond `offset` along `normal`, with its distance beyond, if any is.
    fn farthest(&self, normal: DVec3, offset: f64) -> Option<(u32, f64)> {
        let (mut best, mut limit) = (None, offset);
        let is_positive = normal.cmpgt(DVec3::ZERO);
        let mut index = 0;
        while let Some(node) = self.nodes.get(index) {
            let support = normal.dot(DVec3::select(is_positive, node.bounds.max, node.bounds.min));
            if support <= limit {
                index = node.skip;
                continue;
            }
            for &(point, vertex) in &self.points[node.points.clone()] {
                let height = normal.dot(point);
                if height > limit {
                    (limit, best) = (height, Some(vertex));
                }
            }
            index += 1;
        }
        best.map(|vertex| (vertex, limit - offset))
    }
}
