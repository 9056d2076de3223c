//! Two convex polyhedra in A's frame, prepared for the search over their separating axes.

use crate::shape::polyhedron::ConvexPolyhedron;
use glam::DVec3;
use polhode_spatial::Pose;

/// B in A's frame, and the separations along the faces; the buffers may be kept from call to call.
#[derive(Debug, Clone, Default)]
pub(crate) struct AxisSearch {
    /// Pose of B in A's frame.
    pub(crate) x_ab: Pose,
    /// Vertices, face normals and edge directions of B in A's frame.
    pub(crate) vertices: Vec<DVec3>,
    pub(crate) normals: Vec<DVec3>,
    pub(crate) directions: Vec<DVec3>,
    pub(crate) edges: EdgeBuffers,
    /// Separation along the normal of each face of A and of B, m.
    pub(crate) along_faces_a: Vec<f64>,
    pub(crate) along_faces_b: Vec<f64>,
}

/// Buffers of the search for edges.
#[derive(Debug, Clone, Default)]
pub(crate) struct EdgeBuffers {
    /// `normal . vertex` of every vertex of the other body for each face of A, then of B, m.
    pub(crate) heights_a: Vec<f64>,
    pub(crate) heights_b: Vec<f64>,
    /// The edges that are searched, ascending.
    pub(crate) of_a: Vec<u32>,
    pub(crate) of_b: Vec<u32>,
}

impl AxisSearch {
    /// Transforms B into A's frame.
    pub(crate) fn place(&mut self, b: &ConvexPolyhedron, x_ab: &Pose) {
        self.x_ab = *x_ab;
        let rotation = x_ab.rotation.to_matrix();
        self.vertices.clear();
        self.vertices.extend(b.vertices.iter().map(|&v| x_ab.transform_point(v)));
        self.normals.clear();
        self.normals.extend(b.faces.iter().map(|f| rotation * f.normal));
        self.directions.clear();
        self.directions.extend(b.edges.iter().map(|e| rotation * e.direction));
    }
}

/// Offset in A's frame of the plane of a face of B with this normal there, m. It is computed from the difference of the
/// origins rather than from a rotated vertex, which would be rounded.
pub(crate) fn plane_of_b(b: &ConvexPolyhedron, face: usize, normal: DVec3, x_ab: &Pose) -> f64 {
    normal.dot(x_ab.translation) + b.faces[face].offset
}

/// Least coordinate of some points along a direction.
pub(crate) fn lowest(points: &[DVec3], direction: DVec3) -> f64 {
    range(points, direction).0
}

/// The index of the lowest point along a direction, in a tie the first; 0 when there is none.
pub(crate) fn lowest_vertex(points: &[DVec3], direction: DVec3) -> u32 {
    let heights = points.iter().map(|p| direction.dot(*p)).enumerate();
    heights.min_by(|(_, p), (_, q)| p.total_cmp(q)).map_or(0, |(index, _)| index as u32)
}

/// Least and largest coordinate of some points along a direction.
#[inline]
pub(crate) fn range(points: &[DVec3], direction: DVec3) -> (f64, f64) {
    points.iter().map(|p| p.dot(direction)).fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), height| {
        // Written with comparisons: `min` and `max` also have to handle NaN.
        (if height < low { height } else { low }, if height > high { height } else { high })
    })
}
