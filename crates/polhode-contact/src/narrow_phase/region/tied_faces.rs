//! Contacts along each of several faces that separate two polyhedra equally well.
//!
//! Where an edge or a vertex touches an edge, every direction between the normals of the adjacent faces separates. A
//! manifold takes the pair of faces that are most nearly parallel, which need not contain the touching features. When
//! the polyhedra are parts of bodies, another part may also cover the edge of such a face: at the bottom of a groove
//! the normals of the whole body are those of the groove's sides. Here each separating face is taken by itself, with
//! the lowest feature of the other polyhedron over it:
//!
//! | lowest | contacts |
//! |---|---|
//! | a vertex | the vertex on the face |
//! | an edge | its ends on the face, and its crossings with the sides of the face, ends of sides included |
//! | a face | those of two faces that lie on each other (`face_pair.rs`) |

use crate::ContactFeature;
use crate::Side;
use crate::clearance::FLUSH_COSINE;
use crate::narrow_phase::feature::face_border::face_margin;
use crate::narrow_phase::region::face_pair;
use crate::narrow_phase::region::pair_buffers::PairBuffers;
use crate::shape::polyhedron::{ConvexPolyhedron, Edge, Face};
use glam::DVec3;
use polhode_spatial::Pose;

/// Faces whose separations differ by less than this many tolerances separate equally well: each of the two features may
/// be some tolerances off.
const TIED: f64 = 8.0;

/// A face and the polyhedron over it, in the frame of the face.
struct FaceBelow<'a> {
    /// Body of the face.
    side: Side,
    polyhedron: &'a ConvexPolyhedron,
    face: Face<'a>,
    number: u32,
    other: &'a ConvexPolyhedron,
    /// Pose of the other polyhedron.
    pose: Pose,
    tolerance: f64,
}

/// Calls `visit` with the body and number of every face whose separation is `best` (m) within some tolerances. The
/// buffers must hold the separations along all faces, as a search that did not end early leaves them.
pub(crate) fn each(
    buffers: &mut PairBuffers,
    best: f64,
    tolerance: f64,
    mut visit: impl FnMut(&mut PairBuffers, Side, u32),
) {
    let least = best - TIED * tolerance;
    for number in 0..buffers.search.along_faces_a.len() {
        if buffers.search.along_faces_a[number] >= least {
            visit(buffers, Side::A, number as u32);
        }
    }
    for number in 0..buffers.search.along_faces_b.len() {
        if buffers.search.along_faces_b[number] >= least {
            visit(buffers, Side::B, number as u32);
        }
    }
}

/// Adds the contact features along one face to those of the buffers. B must have been placed.
pub(crate) fn features(
    buffers: &mut PairBuffers,
    [a, b]: [&ConvexPolyhedron; 2],
    (side, number): (Side, u32),
    tolerance: f64,
) {
    let x_ab = buffers.search.x_ab;
    let (polyhedron, other, pose) = if side == Side::A { (a, b, x_ab) } else { (b, a, x_ab.inverse()) };
    let Some(face) = polyhedron.face(number as usize) else { return };
    let below = FaceBelow { side, polyhedron, face, number, other, pose, tolerance };
    if let Some(flush) = below.flush_face() {
        let pair = if side == Side::A { (number, flush) } else { (flush, number) };
        face_pair::collect(buffers, a, b, pair, (tolerance, f64::INFINITY), Side::A);
    } else {
        below.collect(&mut buffers.features);
    }
}

impl FaceBelow<'_> {
    fn place(&self, vertex: u32) -> DVec3 {
        self.pose.transform_point(self.other.vertices[vertex as usize])
    }

    /// The other polyhedron's face that lies on this one.
    fn flush_face(&self) -> Option<u32> {
        let normal = self.pose.rotation.inverse_rotate(self.face.normal);
        self.other.faces.iter().position(|face| -face.normal.dot(normal) >= FLUSH_COSINE).map(|face| face as u32)
    }

    /// The lowest vertices over the face, and the crossings of edges between two of them.
    fn collect(&self, features: &mut Vec<ContactFeature>) {
        let height = |vertex: u32| self.face.normal.dot(self.place(vertex));
        let vertices = 0..self.other.vertices.len() as u32;
        let lowest = vertices.clone().map(height).fold(f64::INFINITY, f64::min);
        let low = |vertex: u32| height(vertex) <= lowest + self.tolerance;
        for vertex in vertices.filter(|&vertex| low(vertex)) {
            if face_margin(self.polyhedron, &self.face, self.place(vertex)) >= -self.tolerance {
                features.push(ContactFeature::VertexFace { vertex_of: self.side.other(), vertex, face: self.number });
            }
        }
        for (number, edge) in self.other.edges.iter().enumerate() {
            if edge.vertices.iter().all(|&vertex| low(vertex)) {
                self.cross(number as u32, edge, features);
            }
        }
    }

    /// The crossings of an edge that lies in the face's plane with the sides of the face.
    fn cross(&self, number: u32, edge: &Edge, features: &mut Vec<ContactFeature>) {
        let [start, end] = edge.vertices.map(|vertex| self.place(vertex));
        for ((&corner, &side), &own) in self.face.vertices.iter().zip(self.face.sides).zip(self.face.edges) {
            let corner = self.polyhedron.vertices[corner as usize];
            let [from, to] = [start, end].map(|place| side.dot(place - corner));
            let crosses = from.min(to) < -self.tolerance && from.max(to) > self.tolerance;
            let crossing = start + (end - start) * (from / (from - to));
            if crosses && face_margin(self.polyhedron, &self.face, crossing) >= -self.tolerance {
                let (edge_a, edge_b) = if self.side == Side::A { (own, number) } else { (number, own) };
                features.push(ContactFeature::EdgeEdge { edge_a, edge_b });
            }
        }
    }
}
