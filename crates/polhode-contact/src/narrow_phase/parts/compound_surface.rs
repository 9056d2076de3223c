//! Which contacts of one part of a compound are contacts of the whole body.
//!
//! Parts may overlap, or touch at faces that are not on the surface of the body (the cuts of an exact decomposition).
//! Each contact of a part, at a place `x` of its surface with outward normal `v`, is tested with short probes in the
//! plane through `x` with normal `v`:
//!
//!  - A contact on a face is kept when the face is free somewhere beside `x`: not every probe has another part above
//!    it.
//!  - A contact at an edge or vertex is kept when no other part at `x` rises above the plane by more than 0.01 rad. The
//!    valid normals at an edge or vertex of the whole body are those that are valid for all of its parts; as for bodies
//!    without parts, a normal may be outside them by that angle, so that both ends of an edge on which a body rocks
//!    stay contacts. It is also kept when it lies at the end of a face with normal `v` that is free beside `x`: the
//!    face of the whole body ends there.
//!  - An edge or vertex between coplanar faces of several parts is not a feature of the whole body. Its edge crossings
//!    are removed. Its vertex contact is replaced by a vertex of the other body when there is one, so that the contacts
//!    are the vertices of the whole contact region.
//!
//! Limits: gaps and steps between parts that are shorter than the probe (`surface_probe.rs`) count as closed.

use crate::bounding::aabb::Aabb;
use crate::clearance::FLUSH_COSINE;
use crate::narrow_phase::feature::alike::ALIKE_SINE;
use crate::narrow_phase::feature::face_border::{PlaceOnFace, face_margin, place_on_face};
use crate::narrow_phase::parts::same_places::SAME_PLACE_OF_PARTS;
use crate::narrow_phase::parts::surface_probe::probe_length;
use crate::shape::Compound;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::{ContactFeature, ContactGeometry, Shape, Side, SurfaceFeature};
use glam::DVec3;
use polhode_spatial::Pose;
use polhode_spatial::unit_vector::SAME_DIRECTION;

/// Number of directions that are probed around a place.
const PROBES: u32 = 16;

/// A contact of one part of each body.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Candidate {
    /// Feature numbers count within the parts.
    pub(crate) feature: ContactFeature,
    pub(crate) parts: [usize; 2],
    /// Relative to A's origin.
    pub(crate) geometry: ContactGeometry,
    /// Whether its vertex replaces one of the other body.
    pub(crate) replaced: bool,
}

/// A place on the surface of a part, in the compound's frame.
struct PlaceOnPart<'a> {
    compound: &'a Compound,
    part: usize,
    near: &'a [usize],
    x: DVec3,
    v: DVec3,
    tolerance: f64,
    probe: f64,
}

/// The contact of two parts as a contact of the whole body `side`; `None` when the whole body does not have it. Poses
/// are those of the candidate; `near` is a buffer.
pub(crate) fn on_whole(
    mut candidate: Candidate,
    shapes: [&Shape; 2],
    (compound, side): (&Compound, Side),
    poses: [&Pose; 2],
    tolerance: f64,
    near: &mut Vec<usize>,
) -> Option<Candidate> {
    let at = side.index();
    let geometry = candidate.geometry;
    let (sign, pose) = if side == Side::A { (-1.0, poses[0]) } else { (1.0, poses[1]) };
    let x = pose.inverse_transform_point(geometry.point - geometry.normal * (0.5 * sign * geometry.separation));
    let v = pose.rotation.inverse_rotate(geometry.normal * sign);
    let part = candidate.parts[at];
    let probe = probe_length(compound.parts[part].size(), tolerance);
    near.clear();
    let around = Aabb::of_point(x).widened(2.0 * probe);
    compound.tree.overlaps(&around, &mut |other| near.push(other as usize));
    near.retain(|&other| other != part);
    if near.is_empty() {
        return Some(candidate);
    }
    let place = PlaceOnPart { compound, part, near, x, v, tolerance, probe };
    let Shape::Convex(own) = shapes[at] else { return (!place.is_covered()).then_some(candidate) };
    match feature_of(candidate.feature, side) {
        Some(SurfaceFeature::Face(face)) => place.is_exposed(own, face).then_some(candidate),
        Some(SurfaceFeature::Edge(edge)) => {
            let edge = own.edges.get(edge as usize)?;
            let stands = place.is_supported() || place.ends_a_face(own, &edge.faces);
            (stands && !place.continues_across(own, edge.direction)).then_some(candidate)
        }
        Some(SurfaceFeature::Vertex(vertex)) => {
            if !(place.is_supported() || place.ends_a_face(own, own.faces_at.of(vertex as usize))) {
                return None;
            }
            let Some(straight) = place.continued_edge(own, vertex) else { return Some(candidate) };
            let inner = place.is_inner();
            let local = |direction: DVec3| poses[1 - at].rotation.inverse_rotate(pose.rotation.rotate(direction));
            let x_other = poses[1 - at]
                .inverse_transform_point(geometry.point + geometry.normal * (0.5 * sign * geometry.separation));
            let on_face = if geometry.margin > SAME_PLACE_OF_PARTS * tolerance {
                PlaceOnFace::Inside
            } else {
                place_on_face(shapes[1 - at], candidate.feature, x_other, SAME_PLACE_OF_PARTS * tolerance)
            };
            match on_face {
                PlaceOnFace::AtVertex(other) if !candidate.replaced => {
                    let face = own
                        .faces_at
                        .of(vertex as usize)
                        .iter()
                        .find(|&&f| own.faces[f as usize].normal.dot(v) > 1.0 - SAME_DIRECTION);
                    let Some(&face) = face else { return Some(candidate) };
                    candidate.feature = ContactFeature::VertexFace { vertex_of: side.other(), vertex: other, face };
                    candidate.replaced = true;
                    Some(candidate)
                }
                PlaceOnFace::OnEdge(along) if !inner => {
                    (along.dot(local(straight)).abs() < FLUSH_COSINE).then_some(candidate)
                }
                PlaceOnFace::Inside | PlaceOnFace::OnEdge(_) | PlaceOnFace::AtVertex(_) => None,
                PlaceOnFace::Unknown => Some(candidate),
            }
        }
        _ => (!place.is_covered()).then_some(candidate),
    }
}

/// The feature of one body that a contact of two parts names; none where it is round or a point of a cloud.
fn feature_of(feature: ContactFeature, side: Side) -> Option<SurfaceFeature> {
    match feature {
        ContactFeature::VertexFace { vertex_of, vertex, .. } if vertex_of == side => {
            Some(SurfaceFeature::Vertex(vertex))
        }
        ContactFeature::VertexFace { face, .. } => Some(SurfaceFeature::Face(face)),
        ContactFeature::EdgeEdge { edge_a, edge_b } => Some(SurfaceFeature::Edge([edge_a, edge_b][side.index()])),
        ContactFeature::Smooth { center_of, against, .. } if center_of != side => Some(against),
        _ => None,
    }
}

impl PlaceOnPart<'_> {
    fn others(&self) -> impl Iterator<Item = &ConvexPolyhedron> {
        self.near.iter().filter_map(|&part| match &self.compound.parts[part] {
            Shape::Convex(polyhedron) => Some(polyhedron),
            _ => None,
        })
    }

    /// Whether the place is strictly inside another part.
    fn is_covered(&self) -> bool {
        self.near.iter().any(|&part| match &self.compound.parts[part] {
            Shape::Convex(polyhedron) => polyhedron.outside(self.x) < -self.tolerance,
            Shape::Sphere(s) => (self.x - s.center()).length() < s.radius() - self.tolerance,
            _ => false,
        })
    }

    /// Unit vectors perpendicular to the normal, evenly spaced.
    fn probes(&self) -> impl Iterator<Item = DVec3> {
        let (u, w) = self.v.any_orthonormal_pair();
        (0..PROBES).map(move |k| {
            // Rotated by an angle that avoids the edge directions of symmetric faces.
            let angle = (f64::from(k) + 0.3) / f64::from(PROBES) * std::f64::consts::TAU;
            u * libm::cos(angle) + w * libm::sin(angle)
        })
    }

    /// Whether a region of the face beside the place has no other part above it; true where no probe lies on the face.
    fn is_exposed(&self, own: &ConvexPolyhedron, face: u32) -> bool {
        let Some(face) = own.face(face as usize) else { return false };
        let mut probed = false;
        for direction in self.probes() {
            let x = self.x + direction * self.probe;
            if face_margin(own, &face, x) < 0.0 {
                continue;
            }
            probed = true;
            if !self.others().any(|other| self.is_above(other, x)) {
                return true;
            }
        }
        !probed
    }

    /// Whether another part covers a place: it extends above it along the normal.
    fn is_above(&self, other: &ConvexPolyhedron, x: DVec3) -> bool {
        other.faces.iter().all(|face| {
            let height = face.normal.dot(x) - face.offset;
            height <= self.tolerance && (height < -self.tolerance || face.normal.dot(self.v) < -SAME_DIRECTION)
        })
    }

    /// Whether no other part at the place rises above the contact plane by more than the angle within which normals
    /// belong to one region of contact.
    fn is_supported(&self) -> bool {
        let rises = |point: DVec3, ball: f64| {
            let from = point - self.x;
            from.dot(self.v) + ball > self.tolerance + ALIKE_SINE * from.length()
        };
        self.near.iter().all(|&part| {
            let shape = &self.compound.parts[part];
            let (centers, radius) = shape.centers();
            let here = match shape {
                Shape::Convex(polyhedron) => polyhedron.outside(self.x) <= self.tolerance,
                Shape::Sphere(s) => (self.x - s.center()).length() <= s.radius() + self.tolerance,
                _ => false,
            };
            !here || !centers.iter().any(|&center| rises(center, radius))
        })
    }

    /// Whether one of these faces has the contact normal and is free beside the place. The face of the whole body ends
    /// where another part rises above it, and its points up to there can touch.
    fn ends_a_face(&self, own: &ConvexPolyhedron, faces: &[u32]) -> bool {
        let along = |&&face: &&u32| own.faces[face as usize].normal.dot(self.v) > 1.0 - SAME_DIRECTION;
        faces.iter().filter(along).any(|&face| self.is_exposed(own, face))
    }

    fn is_filled(&self, x: DVec3) -> bool {
        self.others().any(|other| other.outside(x) <= self.tolerance)
    }

    /// Whether another part continues the surface in the contact plane beyond an edge of this part.
    fn continues_across(&self, own: &ConvexPolyhedron, edge: DVec3) -> bool {
        let side = edge.cross(self.v).normalize_or_zero() * self.probe;
        let away = if own.outside(self.x + side) <= self.tolerance { -side } else { side };
        own.outside(self.x - away) <= self.tolerance && self.is_filled(self.x + away)
    }

    /// The direction of an edge of this part in the contact plane that another part continues beyond the vertex.
    fn continued_edge(&self, own: &ConvexPolyhedron, vertex: u32) -> Option<DVec3> {
        let directions = own.edges_at.of(vertex as usize).iter().map(|&edge| {
            let edge = &own.edges[edge as usize];
            if edge.vertices[0] == vertex { edge.direction } else { -edge.direction }
        });
        directions.filter(|d| d.dot(self.v).abs() <= SAME_DIRECTION).find(|d| self.is_filled(self.x - *d * self.probe))
    }

    /// Whether the parts cover the contact plane all around the place.
    fn is_inner(&self) -> bool {
        let Shape::Convex(own) = &self.compound.parts[self.part] else { return false };
        self.probes().all(|d| {
            let x = self.x + d * self.probe;
            own.outside(x) <= self.tolerance || self.is_filled(x)
        })
    }
}
