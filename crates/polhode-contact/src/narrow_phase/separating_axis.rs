//! Separating axes of two convex polyhedra.
//!
//! Two convex polyhedra are apart exactly when the normal of a face of either, or the common perpendicular of an edge of
//! each, separates them; overlapping, the least overlap over these axes is the depth of penetration. Of the pairs of
//! edges only those count whose arcs cross on the Gauss map (the arc of an edge joins the normals of its two faces on
//! the unit sphere): only those support the difference of the bodies. Sources: docs/REFERENCES.md, Gottschalk 1996,
//! Gregorius 2013.

use crate::clearance::{PARALLEL_SINE, place_tolerance};
use crate::narrow_phase::crossed_edges::CrossedEdges;
use crate::shape::polyhedron::ConvexPolyhedron;
use glam::DVec3;
use polhode_spatial::Pose;

/// Rounding of the separation along an edge axis, in units of epsilon times the lever over the sine of the angle
/// between the edges: the direction of their cross product is uncertain by that much.
const AXIS_ULPS: f64 = 8.0;

/// Buffers that a caller may keep from call to call, so that the narrow phase allocates nothing but its results.
#[derive(Debug, Clone, Default)]
pub struct Workspace {
    /// Vertices, face normals and edge directions of B in A's frame.
    pub(crate) vertices: Vec<DVec3>,
    pub(crate) normals: Vec<DVec3>,
    pub(crate) directions: Vec<DVec3>,
    /// Sine of the angle of each edge to each face of the other body, `direction . normal`.
    edges_a_faces_b: Vec<f64>,
    edges_b_faces_a: Vec<f64>,
    /// Separation along the normal of each face of A and of B, m.
    pub(crate) along_faces_a: Vec<f64>,
    pub(crate) along_faces_b: Vec<f64>,
    pub(crate) face_pair: crate::narrow_phase::face_pair::Buffers,
    pub(crate) features: Vec<crate::ContactFeature>,
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
    /// Distance up to which features are in one place, m.
    pub(crate) tolerance: f64,
}

impl Axes {
    /// Largest separation over the faces.
    pub(crate) fn face_separation(&self) -> f64 {
        self.face_a.separation.max(self.face_b.separation)
    }

    /// The pair of edges, when it separates by more than the faces do; a tie goes to the faces.
    pub(crate) fn deciding_edges(&self) -> Option<EdgeAxis> {
        self.edges.filter(|e| e.separation > self.face_separation() + self.tolerance)
    }

    /// Largest separation over all axes; that of edges measured between their nearest places, where it is most accurate.
    pub(crate) fn separation(&self, a: &ConvexPolyhedron, pose_a: &Pose, b: &ConvexPolyhedron, pose_b: &Pose) -> f64 {
        let measured = |e: EdgeAxis| {
            let crossed = CrossedEdges::new(a, pose_a, e.edge_a, b, pose_b, e.edge_b);
            crossed.map_or(e.separation, |crossed| crossed.separation)
        };
        self.deciding_edges().map_or(self.face_separation(), measured)
    }
}

impl Workspace {
    /// Brings B into A's frame.
    pub(crate) fn place(&mut self, b: &ConvexPolyhedron, x_ab: &Pose) {
        let rotation = x_ab.rotation.to_matrix();
        self.vertices.clear();
        self.vertices.extend(b.vertices.iter().map(|&v| x_ab.transform_point(v)));
        self.normals.clear();
        self.normals.extend(b.faces.iter().map(|f| rotation * f.normal));
        self.directions.clear();
        self.directions.extend(b.edges.iter().map(|e| rotation * e.direction));
    }

    /// Best axes of the pair. The search ends early, with what it has, when an axis separates by more than `stop`.
    /// B must have been placed.
    pub(crate) fn search(&mut self, a: &ConvexPolyhedron, b: &ConvexPolyhedron, x_ab: &Pose, stop: f64) -> Axes {
        let mut axes = Axes {
            face_a: FaceAxis { separation: f64::NEG_INFINITY, face: 0 },
            face_b: FaceAxis { separation: f64::NEG_INFINITY, face: 0 },
            edges: None,
            tolerance: place_tolerance(a.size, b.size, x_ab.translation),
        };
        self.along_faces_a.clear();
        self.along_faces_b.clear();
        for (index, face) in a.faces.iter().enumerate() {
            let separation = lowest(&self.vertices, face.normal) - face.offset;
            self.along_faces_a.push(separation);
            if separation > axes.face_a.separation {
                axes.face_a = FaceAxis { separation, face: index as u32 };
            }
        }
        if axes.face_a.separation > stop {
            return axes;
        }
        for (index, face) in b.faces.iter().enumerate() {
            let normal = self.normals[index];
            // The plane's offset in A's frame, from the origins' difference rather than from a rotated vertex.
            let separation = lowest(&a.vertices, normal) - (normal.dot(x_ab.translation) + face.offset);
            self.along_faces_b.push(separation);
            if separation > axes.face_b.separation {
                axes.face_b = FaceAxis { separation, face: index as u32 };
            }
        }
        if axes.face_b.separation > stop {
            return axes;
        }
        axes.edges = self.best_edges(a, b, stop);
        axes
    }

    /// The pair of edges with the largest separation among those whose arcs cross.
    fn best_edges(&mut self, a: &ConvexPolyhedron, b: &ConvexPolyhedron, stop: f64) -> Option<EdgeAxis> {
        self.edges_a_faces_b.clear();
        for edge in &a.edges {
            self.edges_a_faces_b.extend(self.normals.iter().map(|n| n.dot(edge.direction)));
        }
        self.edges_b_faces_a.clear();
        for direction in &self.directions {
            self.edges_b_faces_a.extend(a.faces.iter().map(|f| f.normal.dot(*direction)));
        }
        let (faces_a, faces_b) = (a.faces.len(), b.faces.len());
        let mut best: Option<EdgeAxis> = None;
        for (i, edge_a) in a.edges.iter().enumerate() {
            let against_b = &self.edges_a_faces_b[i * faces_b..(i + 1) * faces_b];
            for (j, edge_b) in b.edges.iter().enumerate() {
                // With B's normals turned round, the arcs (n1, n2) and (-m1, -m2) cross when m1 and m2 lie on opposite
                // sides of A's arc, n1 and n2 on opposite sides of B's, and both arcs on one hemisphere.
                let (x, y) = (against_b[edge_b.faces[0] as usize], against_b[edge_b.faces[1] as usize]);
                if x * y >= 0.0 {
                    continue;
                }
                let against_a = &self.edges_b_faces_a[j * faces_a..(j + 1) * faces_a];
                let (z, w) = (-against_a[edge_a.faces[0] as usize], -against_a[edge_a.faces[1] as usize]);
                if z * w >= 0.0 || x * w <= 0.0 {
                    continue;
                }
                let Some(separation) = self.along_edges(a, b, i, j) else { continue };
                if best.is_none_or(|best| separation > best.separation) {
                    best = Some(EdgeAxis { separation, edge_a: i as u32, edge_b: j as u32 });
                }
                if separation > stop {
                    return best;
                }
            }
        }
        best
    }

    /// Separation along the common perpendicular of two edges less its rounding, m; nothing when they are parallel.
    fn along_edges(&self, a: &ConvexPolyhedron, b: &ConvexPolyhedron, i: usize, j: usize) -> Option<f64> {
        let (edge_a, edge_b) = (&a.edges[i], &b.edges[j]);
        let cross = edge_a.direction.cross(self.directions[j]);
        let sine = cross.length();
        if sine.is_nan() || sine <= PARALLEL_SINE {
            return None;
        }
        let outward = a.faces[edge_a.faces[0] as usize].normal + a.faces[edge_a.faces[1] as usize].normal;
        let between = self.vertices[edge_b.vertices[0] as usize] - a.vertices[edge_a.vertices[0] as usize];
        let along = between.dot(cross) / sine;
        let rounding = AXIS_ULPS * f64::EPSILON * between.length() * (1.0 / sine - 1.0);
        Some(if cross.dot(outward) >= 0.0 { along - rounding } else { -along - rounding })
    }
}

/// Least coordinate of some points along a direction.
fn lowest(points: &[DVec3], direction: DVec3) -> f64 {
    points.iter().map(|p| p.dot(direction)).fold(f64::INFINITY, f64::min)
}
