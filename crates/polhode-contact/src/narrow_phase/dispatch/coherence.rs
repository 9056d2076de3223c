//! Temporal coherence: which separating axes of two polyhedra need not be searched again at a nearby pose.
//!
//! Let B move in A's frame by a translation `dt` (m) and a rotation `dR`. A point of B at the distance `r` from B's
//! origin moves by at most `|dt| + r |dR|`, and a point of A at the distance `r_A` from A's origin moves in B's frame
//! by at most `|dt| + (r_A + |t|) |dR|`; `t` is B's position in A's frame, and `|dR| <= 2 |dq|` for the unit
//! quaternions. The separation along a face normal changes by no more. So
//!
//!  - a face that separated the bodies by `s` still separates them by `s` minus this change. If that exceeds the reach,
//!    the pair has no contact and nothing is computed;
//!  - a face or an edge (`edge_axes.rs`) whose separation was below a limit can be the best only when the limit plus
//!    the change reaches the separation of the best face. Until then only the others are searched, at the new poses and
//!    with the operations of a full search, which gives its result bit for bit.
//!
//! The contacts of two faces that lie on each other are kept in the same way (`kept_region.rs`). No geometry is kept,
//! only the lists of features to search and of features that touch. It cannot fail: when a bound is exceeded, the full
//! search is run.

use crate::Side;
use crate::narrow_phase::axis::axes::{Axes, axis_slack};
use crate::narrow_phase::axis::axis_search::{AxisSearch, lowest, plane_of_b};
use crate::narrow_phase::axis::drift::Drift;
use crate::narrow_phase::region::kept_region::KeptRegion;
use crate::shape::polyhedron::ConvexPolyhedron;
use polhode_spatial::Pose;

/// By how much the separation of an axis must be below that of the best face for it to be omitted, relative to the
/// lever arm of its change: about the rotation in rad for which the lists hold. A larger value keeps more features in
/// the lists.
const MARGIN: f64 = 0.02;

/// The result of the last full search.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
enum Verdict {
    /// It implies nothing at other poses.
    #[default]
    Unknown,
    /// A face of this body separates the two by at least this, m.
    Apart { of: Side, separation: f64 },
    /// Only the kept features can be the best axis.
    Close,
}

/// The memory of a pair of polyhedra.
#[derive(Debug, Clone, Default)]
pub(crate) struct Coherence {
    verdict: Verdict,
    /// Numbers of faces and edges of both bodies; other numbers mean other shapes, whose indices differ.
    counts: [usize; 4],
    /// Motion since the last full search.
    drift: Drift,
    /// Upper bounds of the separations along the omitted axes of A and of B, m.
    limits: [f64; 2],
    faces: [Vec<u32>; 2],
    edges: [Vec<u32>; 2],
    /// Contact features of the last pair of faces.
    pub(crate) region: KeptRegion,
}

impl Coherence {
    /// Resets the memory; the buffers stay allocated.
    pub(crate) fn forget(&mut self) {
        self.verdict = Verdict::Unknown;
        self.region.forget();
    }

    /// A lower bound of the separation at this relative pose, if there is one beyond `reach`, m.
    #[inline]
    pub(crate) fn apart(&self, a: &ConvexPolyhedron, b: &ConvexPolyhedron, x_ab: &Pose, reach: f64) -> Option<f64> {
        let Verdict::Apart { of, separation } = self.verdict else { return None };
        if self.counts != counts(a, b) {
            return None;
        }
        let least = separation - self.drift.changes(x_ab)[of.index()] - axis_slack(a, b, x_ab);
        (least > reach).then_some(least)
    }

    /// The best axes, as a full search would find them, as far as they matter to contacts within `reach` (m). Places B
    /// in the buffers.
    pub(crate) fn search(
        &mut self,
        search: &mut AxisSearch,
        a: &ConvexPolyhedron,
        b: &ConvexPolyhedron,
        x_ab: &Pose,
        reach: f64,
    ) -> Axes {
        search.place(b, x_ab);
        if let Some(axes) = self.search_again(search, a, b, x_ab, reach) {
            return axes;
        }
        if self.counts != counts(a, b) {
            self.forget();
        }
        self.verdict = Verdict::Unknown;
        self.counts = counts(a, b);
        self.drift = Drift::since(a, b, x_ab);
        let mut axes = match search.search_faces(a, b, x_ab, reach) {
            Ok(axes) => {
                let of = if axes.face_b.separation > axes.face_a.separation { Side::B } else { Side::A };
                // The rounding is subtracted here: it is larger at this pose than at a nearer one.
                let separation = axes.face_separation() - axis_slack(a, b, x_ab);
                self.verdict = Verdict::Apart { of, separation };
                return axes;
            }
            Err(axes) => axes,
        };
        self.limits = axes.edge_limits(a, b, x_ab, self.drift.levers.map(|lever| MARGIN * lever));
        search.select_edges(a, b, x_ab, self.limits);
        if self.limits.into_iter().all(f64::is_finite) {
            self.keep(search);
        }
        search.deciding_edges(a, b, x_ab, &mut axes, reach);
        axes
    }

    /// Stores the features that may be the best axis at nearby poses.
    fn keep(&mut self, search: &AxisSearch) {
        self.verdict = Verdict::Close;
        let along = [&search.along_faces_a, &search.along_faces_b];
        for ((faces, along), limit) in self.faces.iter_mut().zip(along).zip(self.limits) {
            faces.clear();
            let above = along.iter().enumerate().filter(|(_, separation)| **separation >= limit);
            faces.extend(above.map(|(face, _)| face as u32));
        }
        for (edges, chosen) in self.edges.iter_mut().zip([&search.edges.of_a, &search.edges.of_b]) {
            edges.clone_from(chosen);
        }
    }

    /// The search over the kept features alone; none when another one may be the best.
    fn search_again(
        &self,
        search: &mut AxisSearch,
        a: &ConvexPolyhedron,
        b: &ConvexPolyhedron,
        x_ab: &Pose,
        reach: f64,
    ) -> Option<Axes> {
        if self.verdict != Verdict::Close || self.counts != counts(a, b) {
            return None;
        }
        let mut axes = Axes::none(a, b, x_ab);
        search.along_faces_a.clear();
        search.along_faces_a.resize(a.faces.len(), f64::NEG_INFINITY);
        for face in self.faces[0].iter().map(|&face| face as usize) {
            let separation = lowest(&search.vertices, a.faces[face].normal) - a.faces[face].offset;
            search.along_faces_a[face] = separation;
            axes.face_a.take(separation, face);
        }
        search.along_faces_b.clear();
        search.along_faces_b.resize(b.faces.len(), f64::NEG_INFINITY);
        for face in self.faces[1].iter().map(|&face| face as usize) {
            let normal = search.normals[face];
            let separation = lowest(&a.vertices, normal) - plane_of_b(b, face, normal, x_ab);
            search.along_faces_b[face] = separation;
            axes.face_b.take(separation, face);
        }
        // The manifold compares faces within one tolerance of the best, and the faces against them within another one.
        let needed = axes.face_separation().min(0.0) - 2.0 * axes.tolerance - axis_slack(a, b, x_ab);
        let changes = self.drift.changes(x_ab);
        if !(0..2).all(|k| self.limits[k] + changes[k] < needed) {
            return None;
        }
        if axes.face_separation() <= reach {
            search.edges.of_a.clone_from(&self.edges[0]);
            search.edges.of_b.clone_from(&self.edges[1]);
            search.deciding_edges(a, b, x_ab, &mut axes, reach);
        }
        Some(axes)
    }
}

fn counts(a: &ConvexPolyhedron, b: &ConvexPolyhedron) -> [usize; 4] {
    [a.faces.len(), a.edges.len(), b.faces.len(), b.edges.len()]
}
