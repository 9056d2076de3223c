//! The geometry of the contacts of two faces of polyhedra.
//!
//! The result is that of [`evaluate`](crate::evaluate()) for every feature, bit for bit. What the features share is
//! computed once: the normals of the two faces and the transformed edges. Features whose normal is not like that of a
//! deciding face are omitted before they are evaluated.

use crate::narrow_phase::feature::alike::ALIKE;
use crate::narrow_phase::feature::edge_line::EdgeLine;
use crate::narrow_phase::terms::crossed_edges::{CrossedEdges, Perpendicular, PlacedEdge};
use crate::narrow_phase::terms::point_on_surface::vertex_above_face;
use crate::shape::polyhedron::{ConvexPolyhedron, Face};
use crate::{Contact, ContactFeature, ContactGeometry, Side};
use glam::DVec3;
use polhode_spatial::Pose;

/// Two bodies and a face of each.
pub(crate) struct FacePair<'a> {
    pub(crate) polyhedra: [&'a ConvexPolyhedron; 2],
    pub(crate) poses: [&'a Pose; 2],
    pub(crate) faces: [u32; 2],
    /// Normals of the faces that decide the contacts, from B to A.
    pub(crate) deciding: [Option<DVec3>; 2],
    /// m.
    pub(crate) reach: f64,
}

/// Edges of B, by number, in world axes.
pub(crate) type PlacedEdges = Vec<(u32, PlacedEdge)>;

impl FacePair<'_> {
    /// Replaces the contacts by those of the features whose separation is within reach and whose normal is like a
    /// deciding one, in the order of the features.
    pub(crate) fn measure(&self, features: &[ContactFeature], placed_b: &mut PlacedEdges, contacts: &mut Vec<Contact>) {
        contacts.clear();
        let [a, b] = self.polyhedra;
        let (Some(face_a), Some(face_b)) = (a.face(self.faces[0] as usize), b.face(self.faces[1] as usize)) else {
            return;
        };
        placed_b.clear();
        let gradient_a = self.poses[0].rotation.rotate(face_a.normal);
        let gradient_b = self.poses[1].rotation.rotate(face_b.normal);
        let (on_a, on_b) = (self.is_alike(-gradient_a), self.is_alike(gradient_b));
        let mut placed_a: Option<(u32, PlacedEdge)> = None;
        for &feature in features {
            let geometry = match feature {
                ContactFeature::VertexFace { vertex_of: Side::A, vertex, .. } if on_b => {
                    self.vertex_on((Side::A, vertex), &face_b, gradient_b)
                }
                ContactFeature::VertexFace { vertex_of: Side::B, vertex, .. } if on_a => {
                    self.vertex_on((Side::B, vertex), &face_a, gradient_a)
                }
                ContactFeature::EdgeEdge { edge_a, edge_b } => self.crossing(&mut placed_a, edge_a, placed_b, edge_b),
                _ => None,
            };
            contacts.extend(geometry.map(|geometry| Contact { feature, geometry }));
        }
    }

    fn is_alike(&self, normal: DVec3) -> bool {
        self.deciding.iter().flatten().any(|deciding| normal.dot(*deciding) >= ALIKE)
    }

    fn vertex_on(&self, (of, vertex): (Side, u32), face: &Face<'_>, gradient: DVec3) -> Option<ContactGeometry> {
        let (v, e) = (of.index(), of.other().index());
        let place = *self.polyhedra[v].vertices.get(vertex as usize)?;
        vertex_above_face(of, (place, self.poses[v]), (self.polyhedra[e], face, self.poses[e]), gradient, self.reach)
    }

    fn crossing(
        &self,
        placed_a: &mut Option<(u32, PlacedEdge)>,
        edge_a: u32,
        placed_b: &mut PlacedEdges,
        edge_b: u32,
    ) -> Option<ContactGeometry> {
        let [a, b] = self.polyhedra;
        let a = match placed_a {
            Some((edge, placed)) if *edge == edge_a => *placed,
            _ => placed_a.insert((edge_a, PlacedEdge::new(&EdgeLine::of_polyhedron(a, edge_a)?, self.poses[0]))).1,
        };
        let b = if let Some((_, placed)) = placed_b.iter().find(|(edge, _)| *edge == edge_b) {
            *placed
        } else {
            let placed = PlacedEdge::new(&EdgeLine::of_polyhedron(b, edge_b)?, self.poses[1]);
            placed_b.push((edge_b, placed));
            placed
        };
        let perpendicular = Perpendicular::new(&a, &b)?;
        if !self.is_alike(perpendicular.normal) {
            return None;
        }
        let [origin_a, origin_b] = self.poses.map(|pose| pose.translation);
        let geometry = CrossedEdges::along(&perpendicular, &a, origin_a, &b, origin_b).geometry();
        (geometry.separation <= self.reach).then_some(geometry)
    }
}
