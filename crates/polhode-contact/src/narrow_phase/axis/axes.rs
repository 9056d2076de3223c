//! What a search over the separating axes of two polyhedra found.

use crate::clearance::place_tolerance;
use crate::narrow_phase::terms::crossed_edges::CrossedEdges;
use crate::shape::polyhedron::ConvexPolyhedron;
use glam::DVec3;
use polhode_spatial::Pose;

/// Rounding of a separation along any axis relative to the lengths that enter it, with room: the axis of two edges that
/// are only just not parallel ([`crate::clearance::PARALLEL_SINE`]) is uncertain by some epsilon over that sine.
pub(crate) const AXIS_SLACK: f64 = 1e-8;

/// The best axis of a kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FaceAxis {
    pub(crate) separation: f64,
    pub(crate) face: u32,
}

/// The best pair of edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EdgeAxis {
    /// Separation less the rounding of the axis, m.
    pub(crate) separation: f64,
    pub(crate) edge_a: u32,
    pub(crate) edge_b: u32,
}

/// What the search over all axes found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Axes {
    pub(crate) face_a: FaceAxis,
    pub(crate) face_b: FaceAxis,
    pub(crate) edges: Option<EdgeAxis>,
    /// Separation of all vertices along the best perpendicular of edges that are nearly parallel, m, and that direction, out of A
    /// in its frame: it is uncertain, but whatever it is, the bodies are at least that far apart along it. `-inf` when there is
    /// none.
    pub(crate) along_nearly_parallel: (f64, DVec3),
    /// Distance up to which features are in one place, m.
    pub(crate) tolerance: f64,
    /// Differences of separations up to this are rounding, m.
    pub(crate) rounding: f64,
}

impl FaceAxis {
    const NONE: Self = Self { separation: f64::NEG_INFINITY, face: 0 };

    /// Takes a face that separates better; of equal ones the first stays.
    pub(crate) fn take(&mut self, separation: f64, face: usize) {
        if separation > self.separation {
            *self = Self { separation, face: face as u32 };
        }
    }
}

impl Axes {
    /// Nothing found yet.
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

    /// The pair of edges, when it separates by more than the faces do; a tie goes to the faces.
    pub(crate) fn deciding_edges(&self) -> Option<EdgeAxis> {
        self.edges.filter(|e| e.separation > self.face_separation() + self.tolerance)
    }

    /// Largest separation over all axes; that of edges measured between their nearest places, where it is most accurate.
    /// Edges that separate by a little more than the faces, within the tolerance, do not decide, but their separation counts
    /// when it is more by more than the rounding of their axis. Of edges that are nearly parallel that rounding is large, and
    /// the separation of all vertices counts.
    pub(crate) fn separation(&self, polyhedra: [&ConvexPolyhedron; 2], poses: [&Pose; 2]) -> f64 {
        self.largest(self.crossed_edges(polyhedra, poses).as_ref())
    }

    /// The best pair of edges at their nearest places.
    pub(crate) fn crossed_edges(&self, polyhedra: [&ConvexPolyhedron; 2], poses: [&Pose; 2]) -> Option<CrossedEdges> {
        self.edges.and_then(|edges| CrossedEdges::new(polyhedra, poses, [edges.edge_a, edges.edge_b]))
    }

    /// The same when the edges have been placed.
    pub(crate) fn largest(&self, crossed: Option<&CrossedEdges>) -> f64 {
        let faces = self.face_separation();
        let counts = self.edges.is_some_and(|edges| edges.separation > faces);
        let best = crossed.filter(|_| counts).map_or(faces, |crossed| crossed.separation.max(faces));
        best.max(self.along_nearly_parallel.0)
    }

    /// Pairs of edges that separate by no more than this need not be found: faces do as well to rounding, or the bodies
    /// touch anyway.
    pub(crate) fn edge_threshold(&self, stop: f64) -> f64 {
        (self.face_separation() + self.rounding).min(0.0).min(stop)
    }

    /// Separations below which edges of A and of B are left out, m: those of the best face, or touch, less a margin.
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
