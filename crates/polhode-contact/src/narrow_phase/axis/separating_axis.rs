//! Separating axes of two convex polyhedra.
//!
//! Two convex polyhedra are separated exactly when a face normal of one of them, or the common perpendicular of an edge
//! of each, is a separating axis. When they overlap, the smallest overlap over these axes is the penetration depth.
//! Only pairs of edges whose arcs cross on the Gauss map are candidates (the arc of an edge joins the normals of its
//! two faces on the unit sphere): only these pairs form faces of the Minkowski difference. Sources: docs/REFERENCES.md,
//! Gottschalk 1996, Gregorius 2013.

use crate::narrow_phase::axis::axes::Axes;
use crate::narrow_phase::axis::axis_search::{AxisSearch, plane_of_b};
use crate::shape::polyhedron::ConvexPolyhedron;
use glam::DVec3;
use polhode_spatial::Pose;

impl AxisSearch {
    /// Best axes of the pair. The search ends early, with the best axes so far, when one separates by more than `stop`.
    /// Pairs of edges with a negative separation not above that of the best face may be omitted. B must have been
    /// placed.
    pub(crate) fn search(&mut self, a: &ConvexPolyhedron, b: &ConvexPolyhedron, x_ab: &Pose, stop: f64) -> Axes {
        self.search_faces(a, b, x_ab, stop).unwrap_or_else(|mut axes| {
            self.select_edges(a, b, x_ab, axes.edge_limits(a, b, x_ab, [0.0; 2]));
            self.best_edges(a, b, &mut axes, stop);
            axes
        })
    }

    /// As [`Self::search`], but finds a pair of edges only if it separates better than the faces.
    pub(crate) fn search_deciding(
        &mut self,
        a: &ConvexPolyhedron,
        b: &ConvexPolyhedron,
        x_ab: &Pose,
        stop: f64,
    ) -> Axes {
        self.search_faces(a, b, x_ab, stop).unwrap_or_else(|mut axes| {
            self.select_edges(a, b, x_ab, axes.edge_limits(a, b, x_ab, [0.0; 2]));
            self.deciding_edges(a, b, x_ab, &mut axes, stop);
            axes
        })
    }

    /// The best face of each body: `Ok` when one separates by more than `stop`, `Err` when the edges have to be
    /// searched too.
    pub(crate) fn search_faces(
        &mut self,
        a: &ConvexPolyhedron,
        b: &ConvexPolyhedron,
        x_ab: &Pose,
        stop: f64,
    ) -> Result<Axes, Axes> {
        let mut axes = Axes::none(a, b, x_ab);
        self.along_faces_a.clear();
        self.along_faces_b.clear();
        self.edges.heights_a.clear();
        self.edges.heights_b.clear();
        for (index, face) in a.faces.iter().enumerate() {
            let separation = lowest_of(&mut self.edges.heights_a, &self.vertices, face.normal) - face.offset;
            self.along_faces_a.push(separation);
            axes.face_a.take(separation, index);
        }
        if axes.face_a.separation > stop {
            return Ok(axes);
        }
        for (index, normal) in self.normals.iter().enumerate() {
            let lowest = lowest_of(&mut self.edges.heights_b, &a.vertices, *normal);
            let separation = lowest - plane_of_b(b, index, *normal, x_ab);
            self.along_faces_b.push(separation);
            axes.face_b.take(separation, index);
        }
        if axes.face_b.separation > stop { Ok(axes) } else { Err(axes) }
    }
}

/// Least coordinate of some points along a direction; the coordinates of all are added to a list.
fn lowest_of(heights: &mut Vec<f64>, points: &[DVec3], direction: DVec3) -> f64 {
    let mut least = f64::INFINITY;
    heights.extend(points.iter().map(|p| {
        let height = p.dot(direction);
        least = if height < least { height } else { least };
        height
    }));
    least
}

/// Best separating axes of two polyhedra, in A's frame; see [`AxisSearch::search`].
pub(crate) fn search_axes(
    search: &mut AxisSearch,
    [a, b]: [&ConvexPolyhedron; 2],
    [pose_a, pose_b]: [&Pose; 2],
    stop: f64,
) -> Axes {
    let x_ab = pose_a.relative(pose_b);
    search.place(b, &x_ab);
    search.search(a, b, &x_ab, stop)
}
