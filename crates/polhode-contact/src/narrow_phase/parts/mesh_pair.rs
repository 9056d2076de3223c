//! Contacts of a triangle mesh with another body.
//!
//! Each triangle that overlaps the box of the other body is treated as a flat convex body. A contact of a triangle is
//! kept only if the whole surface allows its normal at this feature of the mesh (`mesh_feature.rs`). Edges and vertices
//! inside a flat patch give no contacts: a box on a plane of many triangles has contacts at its four corners only, and
//! a sphere has one.
//!
//! The body is taken to be on the side of the surface on which less of it overlaps. A single point is taken to be on
//! the outer side. When a vertex lies on a convex edge or corner of the mesh, it has a contact with several faces; the
//! one with the lowest face number is kept.
//!
//! All computation is in the frame of the mesh. The result does not depend on which body is called A.

use crate::clearance::place_tolerance_of_sizes;
use crate::narrow_phase::pair::measure::measure_again;
use crate::narrow_phase::parts::mesh_contacts::{
    DEEPER, FlatTriangle, MeshContact, MeshPair, deciding_contact, of_centers, of_curved, of_polyhedron, place_other,
    triangle_separation,
};
use crate::narrow_phase::parts::ridge_ends::{RidgeBuffers, crossings};
use crate::narrow_phase::parts::same_places::{SAME_PLACE_OF_PARTS, SamePlaces};
use crate::narrow_phase::parts::triangle_axes::{Decision, Triangle, TriangleAxes, TriangleBuffers, triangle_axes};
use crate::narrow_phase::region::pair_buffers::PairBuffers;
use crate::shape::TriangleMesh;
use crate::{ContactFeature, Manifold, SeparatingAxis, Shape};
use polhode_spatial::Pose;

/// The mesh of a pair, after its position (0 or 1), and the other body; `None` when neither is a mesh.
pub(crate) fn mesh_and_other(shapes: [&Shape; 2]) -> Option<(usize, &TriangleMesh, &Shape)> {
    match shapes {
        [Shape::TriangleMesh(mesh), other] => Some((0, mesh, other)),
        [other, Shape::TriangleMesh(mesh)] => Some((1, mesh, other)),
        _ => None,
    }
}

/// Whether contact of this shape with a mesh is not computed: meshes and half-spaces are fixed surroundings, and have
/// no contacts with each other.
pub(crate) const fn never_meets(other: &Shape) -> bool {
    matches!(other, Shape::TriangleMesh(_) | Shape::HalfSpace(_))
}

/// The separation of a mesh from another body; `None` for other pairs.
pub(crate) fn mesh_separation(buffers: &mut MeshBuffers, shapes: [&Shape; 2], poses: [&Pose; 2]) -> Option<f64> {
    let (at, mesh, other) = mesh_and_other(shapes)?;
    if never_meets(other) {
        return Some(f64::INFINITY);
    }
    let x = poses[at].relative(poses[1 - at]);
    let bounds = other.bounds_at(&x);
    let tolerance = tolerance_of(mesh, other, &x);
    let MeshBuffers { pair: bodies, axes, offsets, flat, .. } = buffers;
    place_other(&mut bodies.search, other, &x, offsets);
    let mut measure = |index: u32, best: f64| {
        let triangle = Triangle::new(mesh, index);
        match other {
            Shape::Convex(polyhedron) => {
                let limits = (tolerance, best.max(0.0));
                triangle_axes(&bodies.search, axes, offsets, mesh, &triangle, polyhedron, limits).separation
            }
            _ => triangle_separation(&mut bodies.search, mesh, &triangle, other, &x, flat),
        }
    };
    Some(mesh.tree.least(f64::INFINITY, 0.0, &|of| of.distance(&bounds), &mut measure))
}

fn tolerance_of(mesh: &TriangleMesh, other: &Shape, x: &Pose) -> f64 {
    place_tolerance_of_sizes(mesh.bounds_size(), other.size(), x.translation)
}

/// Buffers that are reused from call to call.
#[derive(Debug, Clone, Default)]
pub(crate) struct MeshBuffers {
    /// For a triangle and the other body.
    pub(crate) pair: PairBuffers,
    axes: TriangleBuffers,
    /// Offsets of the faces of the other body, a polyhedron, m.
    offsets: Vec<f64>,
    triangles: Vec<u32>,
    near: Vec<(Triangle, TriangleAxes)>,
    contacts: Vec<MeshContact>,
    flat: FlatTriangle,
    /// Contacts of one triangle.
    of_triangle: Manifold,
    ridges: RidgeBuffers,
    same_places: SamePlaces,
}

/// All contacts of a mesh with another body. The separation is computed only when it is within reach.
pub(crate) fn mesh_manifold(
    buffers: &mut MeshBuffers,
    shapes: [&Shape; 2],
    poses: [&Pose; 2],
    reach: f64,
    found: &mut Manifold,
) {
    found.set_empty(f64::INFINITY, SeparatingAxis::None);
    let Some((at, mesh, other)) = mesh_and_other(shapes) else { return };
    if never_meets(other) {
        return;
    }
    let x = poses[at].relative(poses[1 - at]);
    let pair = MeshPair { shape: shapes[at], mesh, other, x, tolerance: tolerance_of(mesh, other, &x), reach };
    of_triangles(buffers, &pair, found);
    if found.is_beyond(reach) {
        return found.set_empty(found.separation, SeparatingAxis::None);
    }
    of_surface(buffers, &pair, found);
    if at == 1 {
        found.axis = swapped(found.axis);
        found.contacts.iter_mut().for_each(|contact| contact.feature = contact.feature.swapped());
    }
    measure_again(&mut found.contacts, shapes, poses, reach.max(pair.tolerance));
    found.contacts.sort_unstable_by_key(|contact| contact.feature);
}

/// The separation of the triangles within reach, and their contacts when the other body is not a polyhedron.
fn of_triangles(buffers: &mut MeshBuffers, pair: &MeshPair<'_>, found: &mut Manifold) {
    let MeshBuffers { pair: bodies, axes: of_axes, offsets, triangles, near, contacts, flat, of_triangle, .. } =
        buffers;
    let MeshPair { mesh, other, ref x, tolerance, reach, .. } = *pair;
    place_other(&mut bodies.search, other, x, offsets);
    triangles.clear();
    contacts.clear();
    near.clear();
    let bounds = other.bounds_at(x).widened(reach.max(0.0) + SAME_PLACE_OF_PARTS * tolerance);
    mesh.tree.overlaps(&bounds, &mut |triangle| triangles.push(triangle));
    triangles.sort_unstable();
    let mut note = |separation: f64, axis: SeparatingAxis| {
        if separation < found.separation || separation.is_nan() {
            (found.separation, found.axis) = (separation, axis);
        }
    };
    for &index in triangles.iter() {
        let triangle = Triangle::new(mesh, index);
        match other {
            Shape::Convex(polyhedron) => {
                let limits = (tolerance, reach);
                let axes = triangle_axes(&bodies.search, of_axes, offsets, mesh, &triangle, polyhedron, limits);
                note(axes.separation, axis_of(mesh, &triangle, axes.decision));
                if axes.separation <= reach {
                    near.push((triangle, axes));
                }
            }
            Shape::Sphere(_) | Shape::Points(_) => {
                note(of_centers(pair, &triangle, contacts), SeparatingAxis::Nearest);
            }
            _ => {
                let least = of_curved(bodies, pair, &triangle, (flat, of_triangle), contacts);
                note(least, SeparatingAxis::Nearest);
            }
        }
    }
}

/// The contacts of the whole surface, in the mesh's frame with the mesh as A.
fn of_surface(buffers: &mut MeshBuffers, pair: &MeshPair<'_>, found: &mut Manifold) {
    let MeshBuffers { pair: bodies, near, contacts, flat, ridges, same_places, .. } = buffers;
    let tolerance = pair.tolerance;
    if let Shape::Convex(polyhedron) = pair.other {
        // When the penetration along a triangle's own axes exceeds that of the whole pair, the body touches this
        // triangle only at a vertex or an edge. The deciding axis then belongs to a neighbouring triangle.
        near.retain(|(_, axes)| axes.supported >= found.separation.min(0.0) * DEEPER - SAME_PLACE_OF_PARTS * tolerance);
        for (triangle, axes) in near.iter() {
            of_polyhedron(bodies, pair, triangle, polyhedron, axes, (flat, contacts, &mut ridges.places));
        }
    }
    one_on_convex_edges(contacts, SAME_PLACE_OF_PARTS * tolerance);
    found.contacts.extend(contacts.iter().map(|c| c.contact));
    crossings(ridges, pair.touching(), &mut found.contacts);
    same_places.keep_one_each(&mut found.contacts, SAME_PLACE_OF_PARTS * tolerance);
    let deepest = near.iter().min_by(|(_, p), (_, q)| p.separation.total_cmp(&q.separation));
    if let (true, true, Some((triangle, axes))) = (found.contacts.is_empty(), found.separation <= tolerance, deepest) {
        // Bodies that touch must have a contact. The tolerances may have removed all of them.
        found.contacts.extend(deciding_contact(&bodies.search, pair, triangle, axes));
    }
}

const fn swapped(axis: SeparatingAxis) -> SeparatingAxis {
    match axis {
        SeparatingAxis::FaceA(face) => SeparatingAxis::FaceB(face),
        SeparatingAxis::FaceB(face) => SeparatingAxis::FaceA(face),
        SeparatingAxis::Edges(a, b) => SeparatingAxis::Edges(b, a),
        SeparatingAxis::Nearest | SeparatingAxis::None => axis,
    }
}

fn axis_of(mesh: &TriangleMesh, triangle: &Triangle, decision: Decision) -> SeparatingAxis {
    let index = triangle.index as usize;
    match decision {
        Decision::Side(side) => SeparatingAxis::FaceA(2 * mesh.patch_of[index] + side),
        Decision::Face(face) => SeparatingAxis::FaceB(face),
        Decision::Edges(k, edge, _) => SeparatingAxis::Edges(mesh.edges_of[index][k], edge),
    }
}

/// Keeps one contact of a vertex that lies on a convex edge or corner of the mesh: that with the lowest face number.
fn one_on_convex_edges(found: &mut Vec<MeshContact>, tolerance: f64) {
    // Contacts with equal features stay in the order in which they were found.
    (0..).zip(found.iter_mut()).for_each(|(order, c)| c.order = order);
    found.sort_unstable_by_key(|c| (c.contact.feature, c.order));
    let mut count = 0;
    for k in 0..found.len() {
        let (kept, next) = (&found[..count], found[k]);
        let vertex = |c: &MeshContact| match c.contact.feature {
            ContactFeature::VertexFace { vertex_of: crate::Side::B, vertex, .. } => Some(vertex),
            _ => None,
        };
        let hides = |before: &MeshContact| {
            before.on_convex_edge
                && vertex(before) == vertex(&next)
                && before.contact.geometry.point.distance(next.contact.geometry.point) <= tolerance
        };
        let covered = next.on_convex_edge
            && vertex(&next).is_some()
            && kept.iter().rev().take_while(|before| vertex(before) == vertex(&next)).any(hides);
        if !covered {
            found[count] = next;
            count += 1;
        }
    }
    found.truncate(count);
}
