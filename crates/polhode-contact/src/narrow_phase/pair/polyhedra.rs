//! The contacts of two convex polyhedra whose best separating axes are known. The rules are in `manifold.rs`.

use crate::clearance::place_tolerance;
use crate::narrow_phase::axis::axes::{Axes, EdgeAxis};
use crate::narrow_phase::axis::axis_search::{AxisSearch, lowest_vertex};
use crate::narrow_phase::feature::alike::ALIKE;
use crate::narrow_phase::feature::placed::Placed;
use crate::narrow_phase::pair::facing::{deciding_faces, faces_beside, facing, is_better, normals_of};
use crate::narrow_phase::pair::measure::measure;
use crate::narrow_phase::region::face_contacts::FacePair;
use crate::narrow_phase::region::face_pair;
use crate::narrow_phase::region::kept_region::KeptRegion;
use crate::narrow_phase::region::pair_buffers::PairBuffers;
use crate::narrow_phase::region::same_place::SAME_PLACE;
use crate::narrow_phase::region::tied_faces;
use crate::narrow_phase::region::upward::is_upward;
use crate::narrow_phase::terms::evaluate::evaluate;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::{Contact, ContactFeature, ContactGeometry, Manifold, SeparatingAxis, Shape, Side};
use glam::DVec3;

/// Fills `found` with the contacts of two polyhedra whose best axes are known. B must have been placed in the buffers.
pub(crate) fn along_axes(
    buffers: &mut PairBuffers,
    polyhedra: [&ConvexPolyhedron; 2],
    [a, b]: [Placed<'_>; 2],
    (axes, kept): (&Axes, Option<&mut KeptRegion>),
    reach: f64,
    found: &mut Manifold,
) {
    let [polyhedron_a, polyhedron_b] = polyhedra;
    let crossed = axes.crossed_edges(polyhedra, [a.pose, b.pose]);
    let separation = axes.largest(crossed.as_ref());
    // When edges and a face separate equally well, the face decides.
    let edges = axes.deciding_edges();
    let crossed = crossed.filter(|_| edges.is_some());
    let axis = match edges {
        Some(EdgeAxis { edge_a, edge_b, .. }) => SeparatingAxis::Edges(edge_a, edge_b),
        None if axes.face_a.separation >= axes.face_b.separation => SeparatingAxis::FaceA(axes.face_a.face),
        None => SeparatingAxis::FaceB(axes.face_b.face),
    };
    found.set_empty(separation, axis);
    if found.is_beyond(reach) {
        return;
    }
    buffers.features.clear();
    let contacts = &mut found.contacts;
    let pair = match edges {
        Some(edges) => crossed.and_then(|crossed| {
            faces_beside(&buffers.search, polyhedron_a, polyhedron_b, a.pose, edges, crossed.normal)
        }),
        None => Some(facing(&buffers.search, polyhedron_a, polyhedron_b, axes, a.pose)),
    };
    if let Some(pair) = pair {
        let toward_a = -a.pose.rotation.rotate(polyhedron_a.faces[pair.0 as usize].normal);
        let upper = if is_upward(toward_a) { Side::A } else { Side::B };
        let limits = (axes.tolerance, reach);
        if let Some(kept) = kept {
            kept.collect(buffers, polyhedron_a, polyhedron_b, pair, limits, upper);
        } else {
            face_pair::collect(buffers, polyhedron_a, polyhedron_b, pair, limits, upper);
            buffers.features.sort_unstable();
        }
        // Where the faces are at an angle, only features on a deciding face are contacts: the normals of the other
        // crossings of the two outlines do not separate the bodies.
        let normals = normals_of(&buffers.search, polyhedron_a, pair, a.pose);
        let alike = normals.map(|normal| crossed.is_none_or(|c| c.normal.dot(normal) >= ALIKE));
        let deciding = deciding_faces(&buffers.search, axes, pair, alike);
        let faces = FacePair {
            polyhedra,
            poses: [a.pose, b.pose],
            faces: [pair.0, pair.1],
            deciding: [0, 1].map(|k| deciding[k].then_some(normals[k])),
            reach,
        };
        faces.measure(&buffers.features, &mut buffers.placed_edges, contacts);
        if let (Some(edges), Some(crossed), [false, true] | [true, false]) = (edges, crossed, alike) {
            along_edge(contacts, edges, &crossed.geometry(), axes.tolerance);
        }
    } else {
        if let Some(EdgeAxis { edge_a, edge_b, .. }) = edges {
            buffers.features.push(ContactFeature::EdgeEdge { edge_a, edge_b });
        }
        measure(&mut buffers.features, a, b, reach, contacts);
        // When the bodies are apart, the nearest points of the lines may lie beyond the ends of the edges.
        contacts.retain(|c| c.geometry.margin >= -axes.tolerance);
    }
    if contacts.len() < 2 && separation <= axes.tolerance {
        touching(buffers, polyhedra, [a, b], axes, reach, found);
    }
}

/// Adds contacts of polyhedra that touch or overlap when the pair of faces gave one or none: collinear edges share more
/// than one point, and where tolerances left none, bodies that touch still have a contact.
fn touching(
    buffers: &mut PairBuffers,
    polyhedra: [&ConvexPolyhedron; 2],
    [a, b]: [Placed<'_>; 2],
    axes: &Axes,
    reach: f64,
    found: &mut Manifold,
) {
    let contacts = &mut found.contacts;
    if axes.deciding_edges().is_none() && found.separation.abs() <= SAME_PLACE * axes.tolerance {
        let which = (found.separation, axes.tolerance, reach);
        along_best_tied_face(buffers, polyhedra, [a, b], which, contacts);
    }
    if contacts.is_empty() {
        buffers.features.clear();
        buffers.features.push(deciding_contact(&buffers.search, polyhedra[0], axes));
        measure(&mut buffers.features, a, b, f64::INFINITY, contacts);
    }
}

/// Replaces the contacts by those along one of the faces that separate equally well, if that face gives more. Of
/// several such faces the one with most contacts is taken, then the one whose normal is most nearly vertical (z, then
/// y, then x), then the first.
fn along_best_tied_face(
    buffers: &mut PairBuffers,
    polyhedra: [&ConvexPolyhedron; 2],
    [a, b]: [Placed<'_>; 2],
    (separation, tolerance, reach): (f64, f64, f64),
    contacts: &mut Vec<Contact>,
) {
    let few = contacts.len() as f64;
    let mut best: Option<(f64, DVec3, (Side, u32))> = None;
    tied_faces::each(buffers, separation, tolerance, |buffers, side, face| {
        buffers.features.clear();
        tied_faces::features(buffers, polyhedra, (side, face), tolerance);
        let within = |feature: &&ContactFeature| {
            evaluate(**feature, a.shape, a.pose, b.shape, b.pose).is_some_and(|g| g.separation <= reach)
        };
        let number = buffers.features.iter().filter(within).count() as f64;
        let of_a = || polyhedra[0].faces[face as usize].normal;
        let normal = if side == Side::A { of_a() } else { buffers.search.normals[face as usize] };
        let direction = a.pose.rotation.rotate(normal).abs();
        if number > few && best.is_none_or(|(n, d, _)| is_better((number, direction), (n, d))) {
            best = Some((number, direction, (side, face)));
        }
    });
    if let Some((_, _, face)) = best {
        buffers.features.clear();
        tied_faces::features(buffers, polyhedra, face, tolerance);
        measure(&mut buffers.features, a, b, reach, contacts);
    }
}

/// Replaces the contacts of a manifold by those along each of the faces that separate the two polyhedra equally well
/// (`tied_faces.rs`). The buffers must be unchanged since the search that gave the manifold.
pub(crate) fn along_tied_faces(buffers: &mut PairBuffers, [a, b]: [Placed<'_>; 2], reach: f64, found: &mut Manifold) {
    found.contacts.clear();
    let (Shape::Convex(polyhedron_a), Shape::Convex(polyhedron_b)) = (a.shape, b.shape) else { return };
    let tolerance = place_tolerance(polyhedron_a.size, polyhedron_b.size, buffers.search.x_ab.translation);
    buffers.features.clear();
    tied_faces::each(buffers, found.separation, tolerance, |buffers, side, face| {
        tied_faces::features(buffers, [polyhedron_a, polyhedron_b], (side, face), tolerance);
    });
    measure(&mut buffers.features, a, b, reach, &mut found.contacts);
}

/// Corrects the contacts of an edge that lies almost in a face. The face beside the edge is at an angle to that face;
/// when the bodies overlap deeply, its outline projected along the face's normal differs from its own sides. So
/// crossings beyond the ends of their edges are removed, and the crossing with the largest separation is added if it is
/// missing.
fn along_edge(contacts: &mut Vec<Contact>, edges: EdgeAxis, crossing: &ContactGeometry, tolerance: f64) {
    contacts.retain(|c| c.geometry.margin >= -tolerance);
    let feature = ContactFeature::EdgeEdge { edge_a: edges.edge_a, edge_b: edges.edge_b };
    let beside = |c: &Contact| c.geometry.point.distance(crossing.point) <= SAME_PLACE * tolerance;
    if crossing.margin < -tolerance || contacts.iter().any(|c| c.feature == feature || beside(c)) {
        return;
    }
    let place = contacts.partition_point(|c| c.feature < feature);
    contacts.insert(place, Contact { feature, geometry: *crossing });
}

/// The contact on the separating axis itself: the crossing of its edges, or the deepest vertex below its face.
fn deciding_contact(search: &AxisSearch, a: &ConvexPolyhedron, axes: &Axes) -> ContactFeature {
    if let Some(EdgeAxis { edge_a, edge_b, .. }) = axes.deciding_edges() {
        return ContactFeature::EdgeEdge { edge_a, edge_b };
    }
    let (vertex_of, face, points, normal) = if axes.face_a.separation >= axes.face_b.separation {
        (Side::B, axes.face_a.face, &search.vertices, a.faces[axes.face_a.face as usize].normal)
    } else {
        (Side::A, axes.face_b.face, &a.vertices, search.normals[axes.face_b.face as usize])
    };
    ContactFeature::VertexFace { vertex_of, vertex: lowest_vertex(points, normal), face }
}
