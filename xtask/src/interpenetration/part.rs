//! Convex pieces of bodies: a convex part of a solid, one triangle of a surface, or a point.

use glam::DVec3;
use polhode::mesh::TriangleMesh;
use polhode_spatial::Pose;
use std::collections::BTreeSet;

/// A convex piece, in the frame of its body or placed in the world.
#[derive(Debug, Clone)]
pub(super) struct Part {
    pub(super) vertices: Vec<DVec3>,
    pub(super) faces: Vec<[u32; 3]>,
    /// Each once.
    pub(super) edges: Vec<[u32; 2]>,
    /// The corners of the box about it.
    pub(super) low: DVec3,
    pub(super) high: DVec3,
}

impl Part {
    /// A convex solid.
    pub(super) fn of_mesh(mesh: &TriangleMesh) -> Self {
        Self::new(mesh.vertices().to_vec(), mesh.triangles().to_vec())
    }

    /// A triangle.
    pub(super) fn of_triangle(corners: [DVec3; 3]) -> Self {
        Self::new(corners.to_vec(), vec![[0, 1, 2]])
    }

    /// A point.
    pub(super) fn of_point(point: DVec3) -> Self {
        Self::new(vec![point], Vec::new())
    }

    fn new(vertices: Vec<DVec3>, faces: Vec<[u32; 3]>) -> Self {
        let sides = faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let edges: BTreeSet<[u32; 2]> = sides.map(|[a, b]| [a.min(b), a.max(b)]).collect();
        let (low, high) = bounds(&vertices);
        Self { vertices, faces, edges: edges.into_iter().collect(), low, high }
    }

    /// The middle of the vertices and the places halfway to them: inside, as the piece is convex.
    pub(super) fn marks(&self) -> Vec<DVec3> {
        let middle = self.vertices.iter().sum::<DVec3>() / self.vertices.len() as f64;
        self.vertices.iter().map(|vertex| middle.midpoint(*vertex)).chain([middle]).collect()
    }

    /// The piece in the world, every vertex rounded once.
    pub(super) fn placed(&self, pose: &Pose) -> Self {
        let vertices: Vec<DVec3> = self.vertices.iter().map(|&vertex| pose.transform_point(vertex)).collect();
        let (low, high) = bounds(&vertices);
        Self { vertices, faces: self.faces.clone(), edges: self.edges.clone(), low, high }
    }

    /// The least move along an axis that parts the boxes of two pieces, m; negative when they are apart. Not the extent of
    /// what they share, which is nothing where one of them is flat.
    pub(super) fn box_overlap(&self, other: &Self) -> f64 {
        box_overlap((self.low, self.high), (other.low, other.high))
    }

    /// Ends of an edge.
    pub(super) fn ends(&self, [a, b]: [u32; 2]) -> [DVec3; 2] {
        [self.vertices[a as usize], self.vertices[b as usize]]
    }

    /// Ends of the edges whose boxes meet that of the other piece.
    pub(super) fn edges_near(&self, other: &Self) -> Vec<[DVec3; 2]> {
        let ends = self.edges.iter().map(|&edge| self.ends(edge));
        ends.filter(|[a, b]| (a.max(*b).min(other.high) - a.min(*b).max(other.low)).min_element() >= 0.0).collect()
    }
}

pub(super) fn box_overlap((low_a, high_a): (DVec3, DVec3), (low_b, high_b): (DVec3, DVec3)) -> f64 {
    (high_a - low_b).min(high_b - low_a).min_element()
}

pub(super) fn bounds(points: &[DVec3]) -> (DVec3, DVec3) {
    points.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), &point| (low.min(point), high.max(point)))
}
