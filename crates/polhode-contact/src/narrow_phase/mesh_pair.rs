//! A triangle mesh against another body.
//!
//! Every triangle that the body's box meets is taken as a flat convex body. Of what it gives only the contacts stay whose
//! normal the surface has at the mesh's feature (`mesh_feature.rs`): the inner edges and vertices of a flat patch give
//! none, so that a box on a plane of many triangles has its four corners and no more, and a ball on it one contact. The
//! side of the surface is the one on which less of the body overlaps; a single point is on the outer side. Of contacts
//! of one vertex with several faces of a convex edge or corner that it lies on, the one with the lowest face stays.
//! All is computed in the mesh's frame, and the same whichever body is called A.

use crate::clearance::place_tolerance;
use crate::narrow_phase::composite::keep_one_each;
use crate::narrow_phase::evaluate::evaluate;
use crate::narrow_phase::mesh_contacts::{
    MeshPair, Surroundings, deciding_contact, of_centers, of_parts, of_polyhedron,
};
use crate::narrow_phase::separating_axis::Workspace;
use crate::narrow_phase::triangle_axes::{Decision, Triangle, TriangleAxes, triangle_axes};
use crate::shape::TriangleMesh;
use crate::{Contact, ContactFeature, Manifold, SeparatingAxis, Shape};
use polhode_spatial::Pose;

/// Places nearer than this many place tolerances are one.
const SAME_PLACE: f64 = 8.0;

/// How much deeper along a triangle's axis than as a whole a body may overlap there.
const DEEPER: f64 = 1.5;

/// The mesh of a pair and the other body; nothing when none is a mesh.
fn sides_of(shapes: [&Shape; 2]) -> Option<(usize, &TriangleMesh, &Shape)> {
    match shapes {
        [Shape::TriangleMesh(mesh), other] => Some((0, mesh, other)),
        [other, Shape::TriangleMesh(mesh)] => Some((1, mesh, other)),
        _ => None,
    }
}

/// Grounds do not meet each other.
const fn never_meets(other: &Shape) -> bool {
    matches!(other, Shape::TriangleMesh(_) | Shape::HalfSpace(_))
}

/// The separation of a pair of which one is a mesh; nothing for other pairs.
pub(crate) fn mesh_separation(workspace: &mut Workspace, shapes: [&Shape; 2], poses: [&Pose; 2]) -> Option<f64> {
    let (at, mesh, other) = sides_of(shapes)?;
    if never_meets(other) {
        return Some(f64::INFINITY);
    }
    let x = poses[at].relative(poses[1 - at]);
    let bounds = other.bounds_at(&x);
    let tolerance = tolerance_of(mesh, other, &x);
    let around = Surroundings::new(workspace, other, &x);
    let mut measure = |index: u32, best: f64| {
        let triangle = Triangle::new(mesh, index);
        match other {
            Shape::Convex(polyhedron) => {
                let limits = (tolerance, best.max(0.0));
                triangle_axes(workspace, &around.offsets, mesh, &triangle, polyhedron, limits).separation
            }
            _ => crate::narrow_phase::mesh_contacts::separation_of_part(workspace, mesh, &triangle, other, &x),
        }
    };
    Some(mesh.tree.least(f64::INFINITY, 0.0, &|of| of.distance(&bounds), &mut measure))
}

fn tolerance_of(mesh: &TriangleMesh, other: &Shape, x: &Pose) -> f64 {
    let size = if other.size() > 0.0 { other.size() } else { mesh.bounds_size() };
    place_tolerance(size, mesh.bounds_size(), x.translation)
}

/// All contacts of a pair of which one is a mesh; nothing for other pairs.
pub(crate) fn mesh_manifold(
    workspace: &mut Workspace,
    shapes: [&Shape; 2],
    poses: [&Pose; 2],
    reach: f64,
) -> Option<Manifold> {
    let (at, mesh, other) = sides_of(shapes)?;
    if never_meets(other) {
        return Some(Manifold::empty(f64::INFINITY, SeparatingAxis::None));
    }
    let x = poses[at].relative(poses[1 - at]);
    let tolerance = tolerance_of(mesh, other, &x);
    let pair = MeshPair { shape: shapes[at], mesh, other, x, tolerance, reach };
    let around = Surroundings::new(workspace, other, &x);
    let bounds = other.bounds_at(&x).inflated(reach.max(0.0) + SAME_PLACE * tolerance);
    let mut triangles = Vec::new();
    mesh.tree.overlaps(&bounds, &mut |triangle| triangles.push(triangle));
    triangles.sort_unstable();
    let mut found = Found { contacts: Vec::new(), separation: f64::INFINITY, axis: SeparatingAxis::None };
    let mut near: Vec<(Triangle, TriangleAxes)> = Vec::new();
    for index in triangles {
        let triangle = Triangle::new(mesh, index);
        match other {
            Shape::Convex(polyhedron) => {
                let axes = triangle_axes(workspace, &around.offsets, mesh, &triangle, polyhedron, (tolerance, reach));
                found.note(axes.separation, axis_of(mesh, &triangle, axes.decision));
                if axes.separation <= reach {
                    near.push((triangle, axes));
                }
            }
            Shape::Sphere(_) | Shape::Points(_) => {
                let least = of_centers(&pair, &triangle, &mut found.contacts);
                found.note(least, SeparatingAxis::Nearest);
            }
            _ => {
                let least = of_parts(workspace, &pair, &triangle, &mut found.contacts);
                found.note(least, SeparatingAxis::Nearest);
            }
        }
    }
    if found.separation.is_nan() || reach.is_nan() || found.separation > reach {
        let separation = mesh_separation(workspace, shapes, poses)?;
        let axis = if separation == f64::INFINITY { SeparatingAxis::None } else { SeparatingAxis::Nearest };
        return Some(Manifold::empty(separation, axis));
    }
    if let Shape::Convex(polyhedron) = other {
        // A triangle along whose own axes the body overlaps more than it does as a whole touches it with a vertex or an
        // edge only, and the triangles beside it have the axis.
        near.retain(|(_, axes)| axes.supported >= found.separation.min(0.0) * DEEPER - SAME_PLACE * tolerance);
        for (triangle, axes) in &near {
            of_polyhedron(workspace, &pair, triangle, polyhedron, axes, &mut found.contacts);
        }
    }
    let mut kept = one_on_convex_edges(found.contacts, SAME_PLACE * tolerance);
    keep_one_each(&mut kept, SAME_PLACE * tolerance);
    let deepest = near.iter().min_by(|(_, p), (_, q)| p.separation.total_cmp(&q.separation));
    if let (true, true, Some((triangle, axes))) = (kept.is_empty(), found.separation <= tolerance, deepest) {
        // Bodies that touch have a contact, also where tolerances left none.
        kept.extend(deciding_contact(workspace, &pair, triangle, axes));
    }
    let axis = if at == 0 { found.axis } else { swapped(found.axis) };
    Some(Manifold { contacts: measured(&kept, at, shapes, poses), separation: found.separation, axis })
}

/// Contacts found with the mesh as A, as they are of the pair given (the mesh stands there at `at`), sorted.
fn measured(found: &[Contact], at: usize, shapes: [&Shape; 2], poses: [&Pose; 2]) -> Vec<Contact> {
    let measure = |contact: &Contact| {
        let feature = if at == 0 { contact.feature } else { contact.feature.swapped() };
        let geometry = evaluate(feature, shapes[0], poses[0], shapes[1], poses[1])?;
        Some(Contact { feature, geometry })
    };
    let mut contacts: Vec<Contact> = found.iter().filter_map(measure).collect();
    contacts.sort_unstable_by_key(|contact| contact.feature);
    contacts
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

/// A contact in the mesh's frame, the mesh being A.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MeshContact {
    pub(crate) contact: Contact,
    /// It lies on an edge or corner of its triangle at which the surface falls away on all sides.
    pub(crate) on_convex_edge: bool,
}

struct Found {
    contacts: Vec<MeshContact>,
    separation: f64,
    axis: SeparatingAxis,
}

impl Found {
    fn note(&mut self, separation: f64, axis: SeparatingAxis) {
        if separation < self.separation || separation.is_nan() {
            (self.separation, self.axis) = (separation, axis);
        }
    }
}

/// Of contacts of one vertex at a convex edge or corner, with each of its faces, the one with the lowest face.
fn one_on_convex_edges(mut found: Vec<MeshContact>, tolerance: f64) -> Vec<Contact> {
    found.sort_by_key(|c| c.contact.feature);
    let mut kept: Vec<MeshContact> = Vec::with_capacity(found.len());
    for next in found {
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
            kept.push(next);
        }
    }
    kept.into_iter().map(|c| c.contact).collect()
}
