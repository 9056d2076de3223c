//! The result of a search over the separating axes of two polyhedra.

use crate::clearance::place_tolerance;
use crate::narrow_phase::terms::crossed_edges::CrossedEdges;
use crate::shape::polyhedron::ConvexPolyhedron;
use glam::DVec3;
use polhode_spatial::Pose;

/// Bound of the rounding of a separation along any axis, relative to the lengths it is computed from: the axis of two
/// edges that are almost parallel ([`crate::clearance::PARALLEL_SINE`]) is uncertain by some epsilon over that sine.
pub(crate) const AXIS_SLACK: f64 = 1e-8;

/// The best face of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FaceAxis {
    pub(crate) separation: f64,
    pub(crate) face: u32,
}

/// The best pair of edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EdgeAxis {
    /// Separation minus the rounding of the axis, m.
    pub(crate) separation: f64,
    pub(crate) edge_a: u32,
    pub(crate) edge_b: u32,
}

/// The best axis of each kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Axes {
    pub(crate) face_a: FaceAxis,
    pub(crate) face_b: FaceAxis,
    pub(crate) edges: Option<EdgeAxis>,
    /// Largest separation of all vertices along a common perpendicular of nearly parallel edges, m, and that direction,
    /// out of A in its frame. The direction is uncertain, but along any direction the separation of all vertices is a
    /// lower bound. `-inf` when there is none.
    pub(crate) along_nearly_parallel: (f64, DVec3),
    /// Distance up to which features coincide, m.
    pub(crate) tolerance: f64,
    /// Differences of separations up to this are rounding error, m.
    pub(crate) rounding: f64,
}

impl FaceAxis {
    const NONE: Self = Self { separation: f64::NEG_INFINITY, face: 0 };

    /// Replaces the face if the new one separates better; in a tie the earlier one stays.
    pub(crate) fn take(&mut self, separation: f64, face: usize) {
        if separation > self.separation {
            *self = Self { separation, face: face as u32 };
        }
    }
}

impl Axes {
    /// The start of a search: no axis yet.
    pub(crate) fn none(a: &ConvexPolyhedron, b: &ConvexPolyhedron, x_ab: &Pose) -> Self {
        let tolerance = place_tolerance(a.size, b.size, x_ab.translation);
        let rounding = f64::EPSILON * (a.size + b.size + x_ab.translation.length());
        Self {
            face_a: FaceAxis::NONE,
            face_b: FaceAxis::NONE,
            edges: None,
            along_nearly_parallel: (f64::NEG_INFINITY, DVec3::ZERO),
            tolerance,
            rounding,
        }
    }

    /// Largest separation over the faces.
    pub(crate) fn face_separation(&self) -> f64 {
        self.face_a.separation.max(self.face_b.separation)
    }

    /// The pair of edges, when it separates better than the faces; in a tie the faces are preferred.
    pub(crate) fn deciding_edges(&self) -> Option<EdgeAxis> {
        self.edges.filter(|e| e.separation > self.face_separation() + self.tolerance)
    }

    /// Largest separation over all axes; that of edges is computed between their nearest points, where it is most
    /// accurate. Edges better than the faces by less than the tolerance are not the deciding axis, but their separation
    /// is used when the difference exceeds the rounding of their axis. For nearly parallel edges that rounding is
    /// large, and the separation of all vertices is used instead.
    pub(crate) fn separation(&self, polyhedra: [&ConvexPolyhedron; 2], poses: [&Pose; 2]) -> f64 {
        self.largest(self.crossed_edges(polyhedra, poses).as_ref())
    }

    /// The best pair of edges with their nearest points.
    pub(crate) fn crossed_edges(&self, polyhedra: [&ConvexPolyhedron; 2], poses: [&Pose; 2]) -> Option<CrossedEdges> {
        self.edges.and_then(|edges| CrossedEdges::new(polyhedra, poses, [edges.edge_a, edges.edge_b]))
    }

    /// The largest separation, when [`Self::crossed_edges`] has been computed.
    pub(crate) fn largest(&self, crossed: Option<&CrossedEdges>) -> f64 {
        let faces = self.face_separation();
        let counts = self.edges.is_some_and(|edges| edges.separation > faces);
        let best = crossed.filter(|_| counts).map_or(faces, |crossed| crossed.separation.max(faces));
        best.max(self.along_nearly_parallel.0)
    }

    /// Pairs of edges with a separation up to this need not be found: a face is as good within rounding, or the bodies
    /// are not farther apart than touch or the limit `stop`.
    pub(crate) fn edge_threshold(&self, stop: f64) -> f64 {
        (self.face_separation() + self.rounding).min(0.0).min(stop)
    }

    /// Limits below which edges of A and of B are excluded, m: the separation of the best face, or zero if that is
    /// less, minus a margin.
    pub(crate) fn edge_limits(
        &self,
        a: &ConvexPolyhedron,
        b: &ConvexPolyhedron,
        x_ab: &Pose,
        margins: [f64; 2],
    ) -> [f64; 2] {
        let best = self.face_separation().min(0.0) - axis_slack(a, b, x_ab);
        margins.map(|margin| best - margin)
    }
}

/// Rounding of a separation along any axis of the pair, m.
pub(crate) fn axis_slack(a: &ConvexPolyhedron, b: &ConvexPolyhedron, x_ab: &Pose) -> f64 {
    AXIS_SLACK * (a.size + b.size + x_ab.translation.length())
}
