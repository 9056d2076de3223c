//! All contacts of a pair of shapes at given poses.
//!
//! Two polyhedra: the best separating axis ([`crate::separation()`]) names a face of one body, and the face of the other
//! that lies most nearly against it; [`crate::evaluate()`] measures every contact of the two faces. When a pair of edges
//! separates best, that crossing is the only contact, unless a face beside one of the edges is almost parallel to the
//! other edge: then all contacts of the faces beside are given, so that a body that tips over an edge changes its
//! contacts continuously.
//!
//! Capsules, cylinders, cones and tori: `round_region.rs`. Compounds: `composite.rs`. Triangle meshes: `mesh_pair.rs`.
//! Other pairs: every vertex or point below the reach; the nearest features of a sphere.

use crate::clearance::place_tolerance;
use crate::narrow_phase::axis::gap::{self, Gap};
use crate::narrow_phase::axis::ring;
use crate::narrow_phase::axis::separating_axis::{Axes, EdgeAxis, Workspace};
use crate::narrow_phase::dispatch::separation::separation_with;
use crate::narrow_phase::feature::alike::ALIKE;
use crate::narrow_phase::feature::closest_feature::nearest_feature;
use crate::narrow_phase::parts::composite::{compound_manifold, is_composite};
use crate::narrow_phase::parts::mesh_pair::mesh_manifold;
use crate::narrow_phase::region::face_contacts::FacePair;
use crate::narrow_phase::region::face_pair;
use crate::narrow_phase::region::kept_region::KeptRegion;
use crate::narrow_phase::region::round_region;
use crate::narrow_phase::region::tied_faces;
use crate::narrow_phase::terms::crossed_edges::CrossedEdges;
use crate::narrow_phase::terms::evaluate::evaluate;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::shape::round::is_round;
use crate::{Contact, ContactFeature, ContactGeometry, Manifold, SeparatingAxis, Shape, Side, SurfaceFeature};
use glam::DVec3;
use polhode_spatial::Pose;

/// Directions whose components differ by less than this are the same when one of several equal axes is chosen.
const SAME_DIRECTION: f64 = 1e-9;

/// A crossing within so many tolerances of a vertex is that vertex' contact.
const SAME_PLACES: f64 = 4.0;

/// A shape at a pose.
#[derive(Clone, Copy)]
pub(crate) struct Placed<'a> {
    pub(crate) shape: &'a Shape,
    pub(crate) pose: &'a Pose,
}

/// All contacts of two shapes whose separation is at most `reach` (m).
pub fn manifold(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose, reach: f64) -> Manifold {
    manifold_with(&mut Workspace::default(), shape_a, pose_a, shape_b, pose_b, reach)
}

/// As [`manifold`], with buffers that the caller keeps.
pub fn manifold_with(
    workspace: &mut Workspace,
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
    reach: f64,
) -> Manifold {
    let mut found = Manifold::default();
    manifold_into(workspace, shape_a, pose_a, shape_b, pose_b, reach, &mut found);
    found
}

/// As [`manifold`], with buffers and a result that the caller keeps: nothing is allocated once they are large enough. What
/// stood in the result before is forgotten.
pub fn manifold_into(
    workspace: &mut Workspace,
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
    reach: f64,
    found: &mut Manifold,
) {
    near_manifold_into(workspace, shape_a, pose_a, shape_b, pose_b, reach, found);
    let composite = is_composite(shape_a) || is_composite(shape_b);
    if !composite || found.separation <= reach || !(pose_a.is_finite() && pose_b.is_finite()) {
        return;
    }
    let separation = separation_with(workspace, shape_a, pose_a, shape_b, pose_b);
    let axis = if separation == f64::INFINITY { SeparatingAxis::None } else { SeparatingAxis::Nearest };
    found.set_empty(separation, axis);
}

/// As [`manifold`] for those who ask for no more than what is within reach: beyond it the separation of a compound or a
/// mesh is some value above the reach, infinite perhaps, and the axis none. The separation of all parts is most of the work
/// of a pair that is near but apart.
pub fn near_manifold(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose, reach: f64) -> Manifold {
    let mut found = Manifold::default();
    near_manifold_into(&mut Workspace::default(), shape_a, pose_a, shape_b, pose_b, reach, &mut found);
    found
}

/// As [`near_manifold`], with buffers and a result that the caller keeps.
pub(crate) fn near_manifold_into(
    workspace: &mut Workspace,
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
    reach: f64,
    found: &mut Manifold,
) {
    if !(pose_a.is_finite() && pose_b.is_finite()) {
        return found.set_empty(f64::NAN, SeparatingAxis::None);
    }
    let (shapes, poses) = ([shape_a, shape_b], [pose_a, pose_b]);
    if shapes.iter().any(|shape| matches!(shape, Shape::Compound(_))) {
        return compound_manifold(workspace, shapes, poses, reach, found);
    }
    if shapes.iter().any(|shape| matches!(shape, Shape::TriangleMesh(_))) {
        return mesh_manifold(workspace, shapes, poses, reach, found);
    }
    let (a, b) = (Placed { shape: shape_a, pose: pose_a }, Placed { shape: shape_b, pose: pose_b });
    workspace.features.clear();
    if let (Shape::Convex(polyhedron_a), Shape::Convex(polyhedron_b)) = (shape_a, shape_b) {
        let x_ab = pose_a.relative(pose_b);
        workspace.place(polyhedron_b, &x_ab);
        let axes = workspace.search_deciding(polyhedron_a, polyhedron_b, &x_ab, reach);
        return along_axes(workspace, (polyhedron_a, a), (polyhedron_b, b), (&axes, None), reach, found);
    }
    let ring = |shape: &Shape| matches!(shape, Shape::Torus(_));
    if [shape_a, shape_b].into_iter().any(|shape| is_round(shape) || ring(shape)) {
        return of_round(workspace, a, b, reach, found);
    }
    let separation = separation_with(workspace, shape_a, pose_a, shape_b, pose_b);
    let axis = match (shape_a, shape_b) {
        _ if separation == f64::INFINITY => SeparatingAxis::None,
        (Shape::HalfSpace(_), _) => SeparatingAxis::FaceA(0),
        (_, Shape::HalfSpace(_)) => SeparatingAxis::FaceB(0),
        _ => SeparatingAxis::Nearest,
    };
    found.set_empty(separation, axis);
    if separation.is_nan() || reach.is_nan() || separation > reach {
        return;
    }
    match (shape_a, shape_b) {
        (Shape::HalfSpace(_), _) => against_surface(&mut workspace.features, a, b, Side::B),
        (_, Shape::HalfSpace(_)) => against_surface(&mut workspace.features, b, a, Side::A),
        (Shape::Convex(_), _) => against_surface(&mut workspace.features, a, b, Side::B),
        (_, Shape::Convex(_)) => against_surface(&mut workspace.features, b, a, Side::A),
        (Shape::Sphere(_), Shape::Sphere(_)) => workspace.features.push(ContactFeature::SphereSphere),
        (Shape::Sphere(_), _) => against_sphere(&mut workspace.features, shape_b, Side::B),
        _ => against_sphere(&mut workspace.features, shape_a, Side::A),
    }
    measure(&mut workspace.features, a, b, reach, &mut found.contacts);
}

/// Capsules, cylinders, cones and tori: the region along the best axis; of a cloud the region of every point, of a ring that of
/// every place at which it is nearest.
fn of_round(workspace: &mut Workspace, a: Placed<'_>, b: Placed<'_>, reach: f64, found: &mut Manifold) {
    let features = &mut workspace.features;
    let (pair_a, pair_b) = ((a.shape, a.pose), (b.shape, b.pose));
    found.set_empty(f64::INFINITY, SeparatingAxis::None);
    let mut add = |gap: Gap| {
        if gap.separation < found.separation {
            found.separation = gap.separation;
            found.axis = match (gap.a, gap.b) {
                (SurfaceFeature::Face(face), _) => SeparatingAxis::FaceA(face),
                (_, SurfaceFeature::Face(face)) => SeparatingAxis::FaceB(face),
                _ => SeparatingAxis::Nearest,
            };
        }
        if gap.separation <= reach {
            round_region::contacts(features, pair_a, pair_b, &gap, reach, &mut found.contacts);
        }
    };
    let half_space = |shape: &Shape| matches!(shape, Shape::HalfSpace(_));
    if half_space(a.shape) || half_space(b.shape) {
        add(gap::above_half_space(pair_a, pair_b));
    } else if matches!(a.shape, Shape::Torus(_)) || matches!(b.shape, Shape::Torus(_)) {
        ring::each(a.shape, a.pose, b.shape, b.pose, reach, add);
        found.contacts.sort_unstable_by_key(|contact| contact.feature);
        found.contacts.dedup_by_key(|contact| contact.feature);
    } else {
        gap::each(a.shape, a.pose, b.shape, b.pose, reach, add);
    }
    found.contacts.sort_unstable_by_key(|contact| contact.feature);
}

/// The features with their geometry, as far as they are within reach, sorted, instead of what the list held.
fn measure(features: &mut [ContactFeature], a: Placed<'_>, b: Placed<'_>, reach: f64, contacts: &mut Vec<Contact>) {
    features.sort_unstable();
    contacts.clear();
    for &feature in features.iter() {
        let geometry = evaluate(feature, a.shape, a.pose, b.shape, b.pose);
        contacts.extend(geometry.filter(|g| g.separation <= reach).map(|geometry| Contact { feature, geometry }));
    }
}

/// Every point of a cloud, vertex or centre of body `of`, against the nearest feature of a half-space or polyhedron.
fn against_surface(features: &mut Vec<ContactFeature>, surface: Placed<'_>, body: Placed<'_>, of: Side) {
    let sphere = matches!(body.shape, Shape::Sphere(_));
    let x = surface.pose.relative(body.pose);
    for (index, &center) in body.shape.centers().0.iter().enumerate() {
        let index = index as u32;
        let against = match surface.shape {
            Shape::Convex(polyhedron) => {
                let tolerance = place_tolerance(polyhedron.size, polyhedron.size, x.translation);
                nearest_feature(polyhedron, x.transform_point(center), tolerance).feature
            }
            _ => SurfaceFeature::Face(0),
        };
        features.push(match against {
            SurfaceFeature::Face(face) if !sphere => ContactFeature::VertexFace { vertex_of: of, vertex: index, face },
            _ => ContactFeature::Smooth { center_of: of, center: index, against },
        });
    }
}

/// Every point of a cloud against a sphere.
fn against_sphere(features: &mut Vec<ContactFeature>, cloud: &Shape, of: Side) {
    let points = 0..cloud.centers().0.len() as u32;
    features.extend(points.map(|center| ContactFeature::Smooth {
        center_of: of,
        center,
        against: SurfaceFeature::Sphere,
    }));
}

/// The contacts of two polyhedra along each of the faces that separate them equally well, instead of those that the
/// manifold held (`tied_faces.rs`). The workspace must be as the search that gave the manifold left it.
pub(crate) fn along_tied_faces(
    workspace: &mut Workspace,
    (a, pose_a): (&Shape, &Pose),
    (b, pose_b): (&Shape, &Pose),
    reach: f64,
    found: &mut Manifold,
) {
    found.contacts.clear();
    let (Shape::Convex(polyhedron_a), Shape::Convex(polyhedron_b)) = (a, b) else { return };
    let tolerance = place_tolerance(polyhedron_a.size, polyhedron_b.size, workspace.x_ab.translation);
    workspace.features.clear();
    tied_faces::each(workspace, found.separation, tolerance, |workspace, side, face| {
        tied_faces::features(workspace, [polyhedron_a, polyhedron_b], (side, face), tolerance);
    });
    let (a, b) = (Placed { shape: a, pose: pose_a }, Placed { shape: b, pose: pose_b });
    measure(&mut workspace.features, a, b, reach, &mut found.contacts);
}

/// The contacts of two polyhedra whose best axes are known. B must have been placed.
pub(crate) fn along_axes(
    workspace: &mut Workspace,
    (polyhedron_a, a): (&ConvexPolyhedron, Placed<'_>),
    (polyhedron_b, b): (&ConvexPolyhedron, Placed<'_>),
    (axes, kept): (&Axes, Option<&mut KeptRegion>),
    reach: f64,
    found: &mut Manifold,
) {
    let crossed =
        axes.edges.and_then(|e| CrossedEdges::new(polyhedron_a, a.pose, e.edge_a, polyhedron_b, b.pose, e.edge_b));
    let separation = axes.largest(crossed.as_ref());
    // Edges in a tie with a face do not decide.
    let edges = axes.deciding_edges();
    let crossed = crossed.filter(|_| edges.is_some());
    let axis = match edges {
        Some(EdgeAxis { edge_a, edge_b, .. }) => SeparatingAxis::Edges(edge_a, edge_b),
        None if axes.face_a.separation >= axes.face_b.separation => SeparatingAxis::FaceA(axes.face_a.face),
        None => SeparatingAxis::FaceB(axes.face_b.face),
    };
    found.set_empty(separation, axis);
    if separation.is_nan() || reach.is_nan() || separation > reach {
        return;
    }
    workspace.features.clear();
    let contacts = &mut found.contacts;
    let pair = match edges {
        Some(edges) => crossed
            .and_then(|crossed| faces_beside(workspace, polyhedron_a, polyhedron_b, a.pose, edges, crossed.normal)),
        None => Some(facing(workspace, polyhedron_a, polyhedron_b, axes, a.pose)),
    };
    if let Some(pair) = pair {
        let toward_a = -a.pose.rotation.rotate(polyhedron_a.faces[pair.0 as usize].normal);
        let upper = if is_upward(toward_a) { Side::A } else { Side::B };
        let limits = (axes.tolerance, reach);
        if let Some(kept) = kept {
            kept.collect(workspace, polyhedron_a, polyhedron_b, pair, limits, upper);
        } else {
            face_pair::collect(workspace, polyhedron_a, polyhedron_b, pair, limits, upper);
            workspace.features.sort_unstable();
        }
        // Where the faces stand at an angle, only what rests on a deciding face is a contact: the normals of the other
        // crossings of the two outlines do not keep the bodies apart.
        let normals = normals_of(workspace, polyhedron_a, pair, a.pose);
        let alike = normals.map(|normal| crossed.is_none_or(|c| c.normal.dot(normal) >= ALIKE));
        let deciding = deciding_faces(workspace, axes, pair, alike);
        let faces = FacePair {
            polyhedra: [polyhedron_a, polyhedron_b],
            poses: [a.pose, b.pose],
            faces: [pair.0, pair.1],
            deciding: [0, 1].map(|k| deciding[k].then_some(normals[k])),
            reach,
        };
        faces.measure(&workspace.features, &mut workspace.placed_edges, contacts);
        if let (Some(edges), Some(crossed), [false, true] | [true, false]) = (edges, crossed, alike) {
            along_edge(contacts, edges, &crossed.geometry(), axes.tolerance);
        }
    } else {
        if let Some(EdgeAxis { edge_a, edge_b, .. }) = edges {
            workspace.features.push(ContactFeature::EdgeEdge { edge_a, edge_b });
        }
        measure(&mut workspace.features, a, b, reach, contacts);
        // Apart, the nearest places of the lines may lie beyond the ends of the edges.
        contacts.retain(|c| c.geometry.margin >= -axes.tolerance);
    }
    if contacts.len() < 2 && separation <= axes.tolerance {
        touching(workspace, (polyhedron_a, a), (polyhedron_b, b), axes, reach, found);
    }
}

/// Contacts of polyhedra that touch or overlap where the pair of faces has one or none: edges that lie along each other
/// share more, and tolerances may leave none, but bodies that touch have a contact.
fn touching(
    workspace: &mut Workspace,
    (polyhedron_a, a): (&ConvexPolyhedron, Placed<'_>),
    (polyhedron_b, b): (&ConvexPolyhedron, Placed<'_>),
    axes: &Axes,
    reach: f64,
    found: &mut Manifold,
) {
    let contacts = &mut found.contacts;
    if axes.deciding_edges().is_none() && found.separation.abs() <= SAME_PLACES * axes.tolerance {
        let which = (found.separation, axes.tolerance, reach);
        along_best_tied_face(workspace, (polyhedron_a, a), (polyhedron_b, b), which, contacts);
    }
    if contacts.is_empty() {
        workspace.features.clear();
        workspace.features.push(deciding_contact(workspace, polyhedron_a, axes));
        measure(&mut workspace.features, a, b, f64::INFINITY, contacts);
    }
}

/// Instead of some contacts, where there are more, those along one of the faces that separate equally well: the one with
/// most, then the one whose normal is most nearly vertical (z, then y, then x), then the first.
fn along_best_tied_face(
    workspace: &mut Workspace,
    (polyhedron_a, a): (&ConvexPolyhedron, Placed<'_>),
    (polyhedron_b, b): (&ConvexPolyhedron, Placed<'_>),
    (separation, tolerance, reach): (f64, f64, f64),
    contacts: &mut Vec<Contact>,
) {
    let pair = [polyhedron_a, polyhedron_b];
    let few = contacts.len() as f64;
    let mut best: Option<(f64, DVec3, (Side, u32))> = None;
    tied_faces::each(workspace, separation, tolerance, |workspace, side, face| {
        workspace.features.clear();
        tied_faces::features(workspace, pair, (side, face), tolerance);
        let within = |feature: &&ContactFeature| {
            evaluate(**feature, a.shape, a.pose, b.shape, b.pose).is_some_and(|g| g.separation <= reach)
        };
        let number = workspace.features.iter().filter(within).count() as f64;
        let of_a = || polyhedron_a.faces[face as usize].normal;
        let normal = if side == Side::A { of_a() } else { workspace.normals[face as usize] };
        let direction = a.pose.rotation.rotate(normal).abs();
        if number > few && best.is_none_or(|(n, d, _)| is_better((number, direction), (n, d))) {
            best = Some((number, direction, (side, face)));
        }
    });
    if let Some((_, _, face)) = best {
        workspace.features.clear();
        tied_faces::features(workspace, pair, face, tolerance);
        measure(&mut workspace.features, a, b, reach, contacts);
    }
}

/// Contacts of an edge that lies almost in a face: the other face beside the edge stands at an angle, so that its outline,
/// seen along the face's normal, is not where its own sides say when the bodies overlap deeply. Crossings beyond the ends
/// of their edges are left out, and the deciding one is always there.
fn along_edge(contacts: &mut Vec<Contact>, edges: EdgeAxis, crossing: &ContactGeometry, tolerance: f64) {
    contacts.retain(|c| c.geometry.margin >= -tolerance);
    let feature = ContactFeature::EdgeEdge { edge_a: edges.edge_a, edge_b: edges.edge_b };
    let beside = |c: &Contact| c.geometry.point.distance(crossing.point) <= SAME_PLACES * tolerance;
    if crossing.margin < -tolerance || contacts.iter().any(|c| c.feature == feature || beside(c)) {
        return;
    }
    let place = contacts.partition_point(|c| c.feature < feature);
    contacts.insert(place, Contact { feature, geometry: *crossing });
}

/// Unit normals of two faces in the world, from B to A.
fn normals_of(workspace: &Workspace, a: &ConvexPolyhedron, (face_a, face_b): (u32, u32), pose_a: &Pose) -> [DVec3; 2] {
    let normals = [-a.faces[face_a as usize].normal, workspace.normals[face_b as usize]];
    normals.map(|normal| pose_a.rotation.rotate(normal))
}

/// Which faces of a pair say what belongs to the contact region: the one that separates better, or both when they
/// separate equally well (edges of two tilted bodies that meet: the places of the edge may lie under either face). Where
/// a crossing decides, only a face that is almost perpendicular to its normal counts: `alike`.
fn deciding_faces(workspace: &Workspace, axes: &Axes, (face_a, face_b): (u32, u32), alike: [bool; 2]) -> [bool; 2] {
    let along = [workspace.along_faces_a[face_a as usize], workspace.along_faces_b[face_b as usize]];
    [(0, 1), (1, 0)].map(|(own, other)| alike[own] && (!alike[other] || along[own] >= along[other] - axes.tolerance))
}

/// Whether a direction points up: by z, or else y, or else x.
pub(crate) fn is_upward(direction: DVec3) -> bool {
    [direction.z, direction.y, direction.x].into_iter().find(|c| c.abs() > SAME_DIRECTION).is_some_and(|c| c > 0.0)
}

/// The contact on the deciding axis itself: its crossing, or the deepest vertex under its face.
fn deciding_contact(workspace: &Workspace, a: &ConvexPolyhedron, axes: &Axes) -> ContactFeature {
    if let Some(EdgeAxis { edge_a, edge_b, .. }) = axes.deciding_edges() {
        return ContactFeature::EdgeEdge { edge_a, edge_b };
    }
    let (vertex_of, face, points, normal) = if axes.face_a.separation >= axes.face_b.separation {
        (Side::B, axes.face_a.face, &workspace.vertices, a.faces[axes.face_a.face as usize].normal)
    } else {
        (Side::A, axes.face_b.face, &a.vertices, workspace.normals[axes.face_b.face as usize])
    };
    let deepest = points.iter().enumerate().min_by(|(_, p), (_, q)| normal.dot(**p).total_cmp(&normal.dot(**q)));
    ContactFeature::VertexFace { vertex_of, vertex: deepest.map_or(0, |(i, _)| i as u32), face }
}

/// The faces beside two crossing edges that lie most nearly against each other, when at least one of them is almost
/// perpendicular to the normal of the crossing: then the other body's edge, which is perpendicular to that normal, lies
/// almost in the face, and more of it than the crossing may touch.
fn faces_beside(
    workspace: &Workspace,
    a: &ConvexPolyhedron,
    b: &ConvexPolyhedron,
    pose_a: &Pose,
    edges: EdgeAxis,
    normal: DVec3,
) -> Option<(u32, u32)> {
    let normal = pose_a.rotation.inverse_rotate(normal);
    let best = |faces: [u32; 2], along: &dyn Fn(u32) -> f64| {
        let [first, second] = faces.map(|face| (face, along(face)));
        if second.1 > first.1 { second } else { first }
    };
    let face_a = best(a.edges[edges.edge_a as usize].faces, &|f| -normal.dot(a.faces[f as usize].normal));
    let face_b = best(b.edges[edges.edge_b as usize].faces, &|f| normal.dot(workspace.normals[f as usize]));
    (face_a.1.max(face_b.1) >= ALIKE).then_some((face_a.0, face_b.0))
}

/// The deciding face and the face of the other body that lies against it.
///
/// Of several faces that separate equally well (a body flush with a corner of another) the one that meets the most
/// nearly parallel face is taken, then the one whose normal is most nearly vertical (z, then y, then x), then the first.
fn facing(workspace: &Workspace, a: &ConvexPolyhedron, b: &ConvexPolyhedron, axes: &Axes, pose_a: &Pose) -> (u32, u32) {
    let least = axes.face_separation() - axes.tolerance;
    let mut best: Option<(f64, DVec3, (u32, u32))> = None;
    let mut offer = |pair: (u32, u32), normal: DVec3, parallel: f64| {
        let direction = pose_a.rotation.rotate(normal).abs();
        if best.is_none_or(|(p, d, _)| is_better((parallel, direction), (p, d))) {
            best = Some((parallel, direction, pair));
        }
    };
    for (face, _) in workspace.along_faces_a.iter().enumerate().filter(|(_, s)| **s >= least) {
        let normal = a.faces[face].normal;
        let (other, parallel) = opposing(b, &workspace.vertices, |f| workspace.normals[f], normal, axes.tolerance);
        offer((face as u32, other), normal, parallel);
    }
    for (face, _) in workspace.along_faces_b.iter().enumerate().filter(|(_, s)| **s >= least) {
        let normal = workspace.normals[face];
        let (other, parallel) = opposing(a, &a.vertices, |f| a.faces[f].normal, normal, axes.tolerance);
        offer((other, face as u32), normal, parallel);
    }
    best.map_or((0, 0), |(_, _, pair)| pair)
}

/// Whether the first (parallelism or number, direction) goes before the second.
fn is_better(first: (f64, DVec3), second: (f64, DVec3)) -> bool {
    let differences = [first.0 - second.0, first.1.z - second.1.z, first.1.y - second.1.y, first.1.x - second.1.x];
    differences.into_iter().find(|d| d.abs() > SAME_DIRECTION).is_some_and(|d| d > 0.0)
}

/// Of the faces at the lowest vertices along `normal`, the one that lies most nearly against it, and how nearly (1 when
/// antiparallel).
fn opposing(
    polyhedron: &ConvexPolyhedron,
    vertices: &[DVec3],
    normal_of: impl Fn(usize) -> DVec3,
    normal: DVec3,
    tolerance: f64,
) -> (u32, f64) {
    let lowest = vertices.iter().map(|v| v.dot(normal)).fold(f64::INFINITY, f64::min);
    let mut best = (0, f64::NEG_INFINITY);
    for (vertex, place) in vertices.iter().enumerate() {
        if place.dot(normal) > lowest + tolerance {
            continue;
        }
        for &face in polyhedron.faces_at.of(vertex) {
            let parallel = -normal_of(face as usize).dot(normal);
            if parallel > best.1 + SAME_DIRECTION || (parallel > best.1 - SAME_DIRECTION && face < best.0) {
                best = (face, parallel);
            }
        }
    }
    best
}
