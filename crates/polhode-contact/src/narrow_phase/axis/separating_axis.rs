//! Separating axes of two convex polyhedra.
//!
//! Two convex polyhedra are apart exactly when the normal of a face of either, or the common perpendicular of an edge of
//! each, separates them; overlapping, the least overlap over these axes is the depth of penetration. Of the pairs of
//! edges only those count whose arcs cross on the Gauss map (the arc of an edge joins the normals of its two faces on
//! the unit sphere): only those support the difference of the bodies. Sources: docs/REFERENCES.md, Gottschalk 1996,
//! Gregorius 2013.

use crate::ContactFeature;
use crate::clearance::place_tolerance;
use crate::narrow_phase::axis::edge_axes::EdgeBuffers;
use crate::narrow_phase::terms::crossed_edges::CrossedEdges;
use crate::shape::polyhedron::ConvexPolyhedron;
use glam::DVec3;
use polhode_spatial::Pose;

/// Buffers that a caller may keep from call to call, so that the narrow phase allocates nothing but its results.
#[derive(Debug, Clone, Default)]
pub struct Workspace {
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
    pub(crate) triangle: crate::narrow_phase::parts::triangle_axes::TriangleBuffers,
    pub(crate) face_pair: crate::narrow_phase::region::face_pair::Buffers,
    pub(crate) features: Vec<ContactFeature>,
    pub(crate) placed_edges: crate::narrow_phase::region::face_contacts::PlacedEdges,
    pub(crate) composite: crate::narrow_phase::parts::composite::CompositeBuffers,
    pub(crate) mesh: crate::narrow_phase::parts::mesh_pair::MeshBuffers,
    pub(crate) same_places: crate::narrow_phase::parts::composite::SamePlaces,
    pub(crate) ridges: crate::narrow_phase::parts::ridge_ends::RidgeBuffers,
    pub(crate) bounds: [Vec<crate::impact::quadratic_bound::Quadratic>; 2],
}

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
    pub(crate) fn separation(&self, a: &ConvexPolyhedron, pose_a: &Pose, b: &ConvexPolyhedron, pose_b: &Pose) -> f64 {
        let crossed = self.edges.and_then(|e| CrossedEdges::new(a, pose_a, e.edge_a, b, pose_b, e.edge_b));
        self.largest(crossed.as_ref())
    }

    /// The same when the edges have been placed.
    pub(crate) fn largest(&self, crossed: Option<&CrossedEdges>) -> f64 {
        let faces = self.face_separation();
        let counts = self.edges.is_some_and(|edges| edges.separation > faces);
        let best = crossed.filter(|_| counts).map_or(faces, |crossed| crossed.separation.max(faces));
        best.max(self.along_nearly_parallel.0)
    }
}

impl Workspace {
    /// Brings B into A's frame.
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

    /// Best axes of the pair. The search ends early, with what it has, when an axis separates by more than `stop`; pairs
    /// of edges along which the bodies overlap, and no less than along the best face, may be left out. B must have been
    /// placed.
    pub(crate) fn search(&mut self, a: &ConvexPolyhedron, b: &ConvexPolyhedron, x_ab: &Pose, stop: f64) -> Axes {
        self.search_faces(a, b, x_ab, stop).unwrap_or_else(|mut axes| {
            self.select_edges(a, b, x_ab, axes.edge_limits(a, b, x_ab, [0.0; 2]));
            self.best_edges(a, b, &mut axes, stop);
            axes
        })
    }

    /// As [`Self::search`], with edges only where they separate better than the faces do.
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

    /// The best face of each body: `Ok` when one separates by more than `stop`, `Err` when the edges have to be asked.
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

/// Offset in A's frame of the plane of a face of B with this normal there, m: from the difference of the origins rather
/// than from a turned vertex.
pub(crate) fn plane_of_b(b: &ConvexPolyhedron, face: usize, normal: DVec3, x_ab: &Pose) -> f64 {
    normal.dot(x_ab.translation) + b.faces[face].offset
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

/// Least coordinate of some points along a direction.
pub(crate) fn lowest(points: &[DVec3], direction: DVec3) -> f64 {
    range(points, direction).0
}

/// Least and largest coordinate of some points along a direction.
#[inline]
pub(crate) fn range(points: &[DVec3], direction: DVec3) -> (f64, f64) {
    points.iter().map(|p| p.dot(direction)).fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), height| {
        // Compared by hand: `min` and `max` also have to ask for what is no number.
        (if height < low { height } else { low }, if height > high { height } else { high })
    })
}
