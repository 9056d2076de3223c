//! What a search over the separating axes of two polyhedra leaves for the next one, at a pose nearby.
//!
//! Let B move in A's frame by a translation `dt` and a turn `dR`. A point at distance `r` from B's origin then moves by at
//! most `|dt| + r |dR|`, and seen from B a point of A by at most `|dt| + (r_A + |t|) |dR|`, with `|dR| <= 2 |dq|` for the
//! quaternions. Heights above the planes of a body change by no more. So
//!
//!  - a face that separated by `s` still separates by `s` less its change: when that exceeds the reach, the pair has no
//!    contact and nothing need be computed;
//!  - a face or an edge (`edge_axes.rs`) that stayed below a limit can decide again only when the limit plus its change
//!    comes up to the separation of the best face. Until then the others alone are searched, at the new poses and with the
//!    operations of a full search, and give its result bit by bit.
//!
//! The contacts of two faces that lie on each other are kept in the same way (`kept_region.rs`). No geometry is kept,
//! only which features need not be looked at and which ones touch.

use crate::narrow_phase::axis::axes::{Axes, axis_slack};
use crate::narrow_phase::axis::axis_search::{AxisSearch, lowest, plane_of_b};
use crate::narrow_phase::axis::drift::Drift;
use crate::narrow_phase::region::kept_region::KeptRegion;
use crate::shape::polyhedron::ConvexPolyhedron;
use polhode_spatial::Pose;

/// How far below the best face an axis must stay to be left out, relative to the length that turns into its change: about
/// the turn in rad for which a search lasts. Larger, and more features are looked at every time.
const MARGIN: f64 = 0.02;

/// What the last full search found.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
enum Verdict {
    /// Nothing that holds at other poses.
    #[default]
    Unknown,
    /// A face of A (family 0) or of B (1) separates by at least so much, m.
    Apart { family: usize, separation: f64 },
    /// Only some features can decide.
    Close,
}

/// What is known of a pair of polyhedra.
#[derive(Debug, Clone, Default)]
pub(crate) struct Coherence {
    verdict: Verdict,
    /// Faces and edges of both bodies: were they of other shapes, no index of theirs would hold.
    counts: [usize; 4],
    /// Since the last full search.
    drift: Drift,
    /// Separations, m, that every axis of A and of B that is left out stayed below.
    limits: [f64; 2],
    faces: [Vec<u32>; 2],
    edges: [Vec<u32>; 2],
    /// Contacts of the pair of faces that was looked at last.
    pub(crate) region: KeptRegion,
}

impl Coherence {
    /// Forgets everything but the buffers.
    pub(crate) fn forget(&mut self) {
        self.verdict = Verdict::Unknown;
        self.region.forget();
    }

    /// A separation beyond `reach` that the pair certainly has at this relative pose, m.
    #[inline]
    pub(crate) fn apart(&self, a: &ConvexPolyhedron, b: &ConvexPolyhedron, x_ab: &Pose, reach: f64) -> Option<f64> {
        let Verdict::Apart { family, separation } = self.verdict else { return None };
        if self.counts != counts(a, b) {
            return None;
        }
        let least = separation - self.drift.changes(x_ab)[family] - axis_slack(a, b, x_ab);
        (least > reach).then_some(least)
    }

    /// The axes that a full search would find, as far as they matter to the contacts within `reach`. B is placed.
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
                let family = usize::from(axes.face_b.separation > axes.face_a.separation);
                // Less its rounding, which is more than that of one nearby when the bodies are far apart.
                let separation = axes.face_separation() - axis_slack(a, b, x_ab);
                self.verdict = Verdict::Apart { family, separation };
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

    /// Keeps the features that may decide nearby.
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

    /// The search over the kept features alone; nothing when others may matter.
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
        // Faces within the tolerance of the best and those that lie against them within as much again are compared.
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
