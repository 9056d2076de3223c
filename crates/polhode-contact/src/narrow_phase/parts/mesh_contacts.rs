//! Contacts of one triangle of a mesh with another body. The mesh is body A, and its frame is the frame of computation.

use crate::narrow_phase::axis::axis_search::{AxisSearch, lowest_vertex, range};
use crate::narrow_phase::axis::body::Body;
use crate::narrow_phase::axis::gap::Gap;
use crate::narrow_phase::feature::alike::ALIKE;
use crate::narrow_phase::feature::face_border::{PlaceOnFace, place_on_face};
use crate::narrow_phase::feature::mesh_feature::Flatness;
use crate::narrow_phase::feature::part_feature::Kind;
use crate::narrow_phase::feature::placed::Placed;
use crate::narrow_phase::pair::facing::opposing;
use crate::narrow_phase::pair::pair_manifold::pair_manifold;
use crate::narrow_phase::pair::pair_separation::pair_separation;
use crate::narrow_phase::parts::ridge_ends::TouchingPair;
use crate::narrow_phase::parts::same_places::SAME_PLACE_OF_PARTS;
use crate::narrow_phase::parts::triangle_axes::{Decision, Triangle, TriangleAxes};
use crate::narrow_phase::region::face_pair;
use crate::narrow_phase::region::pair_buffers::PairBuffers;
use crate::narrow_phase::region::round_region;
use crate::narrow_phase::region::upward::is_upward;
use crate::narrow_phase::terms::evaluate::evaluate;
use crate::shape::TriangleMesh;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::shape::round::is_round;
use crate::shape::topology::{flat_triangle, set_flat_triangle};
use crate::shape::triangle::{TriangleFeature, from_triangle};
use crate::{Contact, ContactFeature, Manifold, Shape, Side, SurfaceFeature};
use glam::DVec3;
use polhode_spatial::Pose;
use polhode_spatial::unit_vector::SAME_DIRECTION;

/// A triangle gives contacts when the penetration along its own axes is at most this many times that of the whole pair.
pub(crate) const DEEPER: f64 = 1.5;

/// A contact of a mesh (A) in its frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MeshContact {
    pub(crate) contact: Contact,
    /// Its position in the order of discovery.
    pub(crate) order: u32,
    /// Whether it lies on a convex edge or corner of its triangle, so that other triangles there may have it too.
    pub(crate) on_convex_edge: bool,
}

/// A mesh, A, and another body, B, in the mesh's frame.
#[derive(Clone, Copy)]
pub(crate) struct MeshPair<'a> {
    /// The mesh as a shape.
    pub(crate) shape: &'a Shape,
    pub(crate) mesh: &'a TriangleMesh,
    pub(crate) other: &'a Shape,
    /// Pose of the other body.
    pub(crate) x: Pose,
    pub(crate) tolerance: f64,
    pub(crate) reach: f64,
}

impl<'a> MeshPair<'a> {
    /// The pair in the mesh's frame.
    pub(crate) const fn touching(&'a self) -> TouchingPair<'a> {
        let poses = [&Pose::IDENTITY, &self.x];
        TouchingPair { shapes: [self.shape, self.other], poses, same_place: SAME_PLACE_OF_PARTS * self.tolerance }
    }
}

/// Places a polyhedron in the mesh's frame, and gives the offsets of its faces there, m.
pub(crate) fn place_other(search: &mut AxisSearch, other: &Shape, x: &Pose, offsets: &mut Vec<f64>) {
    offsets.clear();
    if let Shape::Convex(polyhedron) = other {
        search.place(polyhedron, x);
        let faces = polyhedron.faces.iter().zip(&search.normals);
        offsets.extend(faces.map(|(face, normal)| normal.dot(x.translation) + face.offset));
    }
}

/// A triangle as a shape, kept from call to call.
#[derive(Debug, Clone, Default)]
pub(crate) struct FlatTriangle(Option<Shape>);

impl FlatTriangle {
    fn set(&mut self, triangle: &Triangle) -> &Shape {
        let Triangle { corners, normal, .. } = *triangle;
        let shape = self.0.get_or_insert_with(|| Shape::Convex(flat_triangle(corners, normal)));
        if let Shape::Convex(flat) = shape {
            set_flat_triangle(flat, corners, normal);
        }
        shape
    }
}

/// Adds the contacts of a triangle with a polyhedron that has been placed to `contacts`, and to `bends` the places at
/// which the two touch at the border of a feature (`ridge_ends.rs`).
pub(crate) fn of_polyhedron(
    buffers: &mut PairBuffers,
    pair: &MeshPair<'_>,
    triangle: &Triangle,
    polyhedron: &ConvexPolyhedron,
    axes: &TriangleAxes,
    (flat, contacts, bends): (&mut FlatTriangle, &mut Vec<MeshContact>, &mut Vec<DVec3>),
) {
    let (tolerance, reach) = (pair.tolerance, pair.reach);
    buffers.features.clear();
    let mut deciding: Option<[Option<DVec3>; 2]> = None;
    if let Some((side, face)) = faces_of(&buffers.search, triangle, polyhedron, axes, tolerance) {
        let outward = triangle.outward(side);
        let upper = if is_upward(-outward) { Side::A } else { Side::B };
        let Shape::Convex(flat) = flat.set(triangle) else { return };
        face_pair::collect(buffers, flat, polyhedron, (side, face), (tolerance, reach), upper);
        let of_face = buffers.search.normals[face as usize];
        // Normals from B to A.
        deciding = Some(match axes.decision {
            Decision::Side(_) => [Some(-outward), None],
            Decision::Face(face) => [Some(buffers.search.normals[face as usize]), None],
            Decision::Edges(..) => [Some(-outward), Some(of_face)],
        });
    } else if let Decision::Edges(k, edge_b, _) = axes.decision {
        buffers.features.push(ContactFeature::EdgeEdge { edge_a: k as u32, edge_b });
    }
    let features = std::mem::take(&mut buffers.features);
    let on_triangle = OnTriangle { pair, triangle };
    let touching = pair.touching();
    for &feature in &features {
        // Where a ridge bends, the contacts of a single triangle are not contacts of the whole surface: cross the
        // ridges there instead (`ridge_ends.rs`).
        let place = on_triangle.measure(feature).map(|c| c.geometry).filter(|geometry| touching.is_at_border(geometry));
        bends.extend(place.map(|geometry| geometry.point));
        let Some(found) = on_triangle.on_surface(feature) else { continue };
        let geometry = found.contact.geometry;
        let alike = |normal: &DVec3| geometry.normal.dot(*normal) >= ALIKE;
        let decided = deciding.is_none_or(|normals| normals.iter().flatten().any(alike));
        // Before contact, the closest points of the two lines may lie beyond the ends of the edges.
        let crossing = deciding.is_some() || geometry.margin >= -tolerance;
        if decided && crossing && geometry.separation <= reach {
            contacts.push(found);
        }
    }
    buffers.features = features;
}

/// The contact on the deciding axis itself: the edge crossing, or the vertex with the largest penetration of the face.
pub(crate) fn deciding_contact(
    search: &AxisSearch,
    pair: &MeshPair<'_>,
    triangle: &Triangle,
    axes: &TriangleAxes,
) -> Option<Contact> {
    let feature = match axes.decision {
        Decision::Edges(k, edge_b, _) => ContactFeature::EdgeEdge { edge_a: k as u32, edge_b },
        Decision::Face(face) => {
            let vertex = lowest_vertex(&triangle.corners, search.normals[face as usize]);
            ContactFeature::VertexFace { vertex_of: Side::A, vertex, face }
        }
        Decision::Side(face) => {
            let vertex = lowest_vertex(&search.vertices, triangle.outward(face));
            ContactFeature::VertexFace { vertex_of: Side::B, vertex, face }
        }
    };
    OnTriangle { pair, triangle }.measure(feature)
}

/// The side of the triangle and the face of the polyhedron that are in face-face contact, if any.
fn faces_of(
    search: &AxisSearch,
    triangle: &Triangle,
    polyhedron: &ConvexPolyhedron,
    axes: &TriangleAxes,
    tolerance: f64,
) -> Option<(u32, u32)> {
    match axes.decision {
        Decision::Side(side) => {
            let outward = triangle.outward(side);
            let normal_of = |face: usize| search.normals[face];
            // Of faces that lie equally against it the first.
            let (face, _) = opposing(polyhedron, &search.vertices, normal_of, outward, (tolerance, 0.0));
            Some((side, face))
        }
        Decision::Face(face) => {
            let normal = search.normals[face as usize];
            Some((u32::from(normal.dot(triangle.normal) > 0.0), face))
        }
        Decision::Edges(_, edge, v) => {
            let side = u32::from(triangle.normal.dot(v) < 0.0);
            let faces = polyhedron.edges[edge as usize].faces;
            let against = |f: u32| -search.normals[f as usize].dot(v);
            let face = if against(faces[1]) > against(faces[0]) { faces[1] } else { faces[0] };
            (triangle.outward(side).dot(v) >= ALIKE && against(face) >= ALIKE).then_some((side, face))
        }
    }
}

/// Decides which contacts of a triangle are contacts of the whole surface.
struct OnTriangle<'a> {
    pair: &'a MeshPair<'a>,
    triangle: &'a Triangle,
}

impl OnTriangle<'_> {
    /// The contact, with the feature numbers of the mesh.
    fn measure(&self, feature: ContactFeature) -> Option<Contact> {
        let index = self.triangle.index as usize;
        let mesh = self.pair.mesh;
        let patch = mesh.patch_of[index];
        let feature = feature.renumbered(|side, kind, number| match (side, kind) {
            (Side::A, Kind::Face) => Some(2 * patch + number),
            (Side::A, Kind::Edge) => mesh.edges_of[index].get(number as usize).copied(),
            (Side::A, Kind::Vertex) => mesh.joined[index].get(number as usize).copied(),
            (Side::B, _) => Some(number),
        })?;
        self.measure_whole(feature)
    }

    fn measure_whole(&self, feature: ContactFeature) -> Option<Contact> {
        let geometry = evaluate(feature, self.pair.shape, &Pose::IDENTITY, self.pair.other, &self.pair.x)?;
        Some(Contact { feature, geometry })
    }

    /// The contact; `None` when the surface of the whole mesh does not have it.
    fn on_surface(&self, feature: ContactFeature) -> Option<MeshContact> {
        let contact = self.measure(feature)?;
        let (mesh, tolerance) = (self.pair.mesh, self.pair.tolerance);
        let outward = -contact.geometry.normal;
        let place = contact.geometry.point + contact.geometry.normal * (0.5 * contact.geometry.separation);
        match contact.feature {
            ContactFeature::VertexFace { vertex_of: Side::A, vertex, .. } => {
                if !mesh.supports_at_vertex(vertex, outward, tolerance, 0.0) {
                    return None;
                }
                let straight = match mesh.flatness(vertex, outward, tolerance) {
                    Flatness::Corner => return Some(MeshContact { contact, order: 0, on_convex_edge: false }),
                    Flatness::Straight(direction) => Some(direction),
                    Flatness::Inner => None,
                };
                let on_body = contact.geometry.point - contact.geometry.normal * (0.5 * contact.geometry.separation);
                let y = self.pair.x.inverse_transform_point(on_body);
                match (place_on_face(self.pair.other, contact.feature, y, SAME_PLACE_OF_PARTS * tolerance), straight) {
                    (PlaceOnFace::AtVertex(vertex), _) => {
                        let side = u32::from(outward.dot(self.triangle.normal) < 0.0);
                        let face = 2 * mesh.patch_of[self.triangle.index as usize] + side;
                        let flat = outward.dot(self.triangle.normal).abs() >= ALIKE;
                        let contact = if flat {
                            self.measure_whole(ContactFeature::VertexFace { vertex_of: Side::B, vertex, face })?
                        } else {
                            contact
                        };
                        Some(MeshContact { contact, order: 0, on_convex_edge: false })
                    }
                    (PlaceOnFace::OnEdge(along), Some(straight)) => {
                        let across = self.pair.x.rotation.rotate(along).cross(straight).length();
                        (across > PARALLEL).then_some(MeshContact { contact, order: 0, on_convex_edge: false })
                    }
                    (PlaceOnFace::Unknown, _) => Some(MeshContact { contact, order: 0, on_convex_edge: false }),
                    (PlaceOnFace::Inside | PlaceOnFace::OnEdge(_), _) => None,
                }
            }
            ContactFeature::EdgeEdge { edge_a, .. } => {
                let stands = !mesh.edges[edge_a as usize].flat
                    && mesh.supports_at_edge(edge_a, outward, tolerance, SAME_DIRECTION);
                stands.then_some(MeshContact { contact, order: 0, on_convex_edge: false })
            }
            _ => {
                let at = self.feature_at(place);
                let supported = self.supports(at, outward, 0.0);
                Some(MeshContact { contact, order: 0, on_convex_edge: at != TriangleFeature::Face && supported })
            }
        }
    }

    /// The feature of the triangle (corner, edge or face) on which a place lies.
    fn feature_at(&self, place: DVec3) -> TriangleFeature {
        let limit = SAME_PLACE_OF_PARTS * self.pair.tolerance;
        let corners = self.triangle.corners;
        if let Some(k) = corners.iter().position(|c| c.distance(place) <= limit) {
            return TriangleFeature::Corner(k);
        }
        let sides = self.pair.mesh.sides[self.triangle.index as usize];
        (0..3)
            .find(|&k| sides[k].dot(place - corners[k]).abs() <= limit)
            .map_or(TriangleFeature::Face, TriangleFeature::Edge)
    }

    fn supports(&self, at: TriangleFeature, v: DVec3, slope: f64) -> bool {
        self.pair.mesh.supports_at(self.triangle.index, at, v, self.pair.tolerance, slope)
    }
}

/// A straight border of the mesh is parallel to an edge of the body when the sine of their angle is below this.
const PARALLEL: f64 = 1e-6;

/// Adds the contacts of a sphere or a point cloud with a triangle. Returns the separation, m.
pub(crate) fn of_centers(pair: &MeshPair<'_>, triangle: &Triangle, contacts: &mut Vec<MeshContact>) -> f64 {
    let MeshPair { mesh, other, x, tolerance, reach, .. } = pair;
    let (tolerance, reach) = (*tolerance, *reach);
    let (centers, radius) = other.centers();
    let side = side_of(triangle, other, x, tolerance);
    let on_triangle = OnTriangle { pair, triangle };
    let index = triangle.index as usize;
    let mut least = f64::INFINITY;
    for (number, &center) in centers.iter().enumerate() {
        let center = x.transform_point(center);
        let near = NearTriangle::new(triangle, center, side, tolerance);
        least = least.min(near.distance - radius);
        if near.distance - radius > reach {
            continue;
        }
        let slope = tolerance / near.distance.abs().max(tolerance);
        let supported = on_triangle.supports(near.feature, near.direction, slope);
        let over_face = near.lateral <= SAME_PLACE_OF_PARTS * tolerance;
        if !(supported || over_face) {
            continue;
        }
        let number = number as u32;
        let against = match near.feature {
            TriangleFeature::Edge(k) if !over_face => SurfaceFeature::Edge(mesh.edges_of[index][k]),
            TriangleFeature::Corner(k) if !over_face => SurfaceFeature::Vertex(mesh.joined[index][k]),
            _ => SurfaceFeature::Face(2 * mesh.patch_of[index] + near.side),
        };
        let feature = match against {
            SurfaceFeature::Face(face) if radius == 0.0 => {
                ContactFeature::VertexFace { vertex_of: Side::B, vertex: number, face }
            }
            _ => ContactFeature::Smooth { center_of: Side::B, center: number, against },
        };
        let on_convex_edge = near.feature != TriangleFeature::Face && supported;
        contacts.extend(on_triangle.measure_whole(feature).map(|contact| MeshContact {
            contact,
            order: 0,
            on_convex_edge,
        }));
    }
    least
}

/// The side of the triangle on which less of the body overlaps: 0 outer, 1 inner. `None` for a sphere, and for a cloud
/// without extent along the normal: the side then depends on the position of the centre.
fn side_of(triangle: &Triangle, other: &Shape, x: &Pose, tolerance: f64) -> Option<u32> {
    let (centers, radius) = other.centers();
    if radius > 0.0 {
        return None;
    }
    let normal = x.rotation.inverse_rotate(triangle.normal);
    let base = triangle.normal.dot(x.translation) - triangle.offset;
    let (low, high) = range(centers, normal);
    let (below, above) = (base + low, base + high);
    (above - below > 4.0 * tolerance).then(|| u32::from(below < -above))
}

/// A point beside or below a triangle.
struct NearTriangle {
    /// The feature that is nearest to the point.
    feature: TriangleFeature,
    side: u32,
    /// Signed, m: negative beyond the face on its side.
    distance: f64,
    direction: DVec3,
    /// In-plane distance from the closest point of the triangle, m.
    lateral: f64,
}

impl NearTriangle {
    fn new(triangle: &Triangle, point: DVec3, side: Option<u32>, tolerance: f64) -> Self {
        let (away, feature) = from_triangle(&triangle.corners, point);
        let height = triangle.normal.dot(point) - triangle.offset;
        let lateral = (away - triangle.normal * triangle.normal.dot(away)).length();
        let length = away.length();
        let over = lateral <= SAME_PLACE_OF_PARTS * tolerance;
        let side = match side {
            Some(side) => side,
            None => u32::from(height < -POINT_DEPTH * tolerance),
        };
        let outward = triangle.outward(side);
        if over || feature == TriangleFeature::Face {
            let distance = if side == 0 { height } else { -height };
            return Self { feature, side, distance, direction: outward, lateral };
        }
        Self { feature, side, distance: length, direction: away / length, lateral }
    }
}

/// A single point counts as on the outer side when it is at most this many place tolerances below the plane.
const POINT_DEPTH: f64 = 64.0;

/// The separation of a triangle from a body that is no polyhedron, m.
pub(crate) fn triangle_separation(
    search: &mut AxisSearch,
    mesh: &TriangleMesh,
    triangle: &Triangle,
    other: &Shape,
    x: &Pose,
    flat: &mut FlatTriangle,
) -> f64 {
    match other {
        Shape::Sphere(_) | Shape::Points(_) => {
            let (centers, radius) = other.centers();
            let tolerance = crate::clearance::place_tolerance(mesh.bounds_size(), mesh.bounds_size(), x.translation);
            let side = side_of(triangle, other, x, tolerance);
            let near = |&c: &DVec3| NearTriangle::new(triangle, x.transform_point(c), side, tolerance).distance;
            centers.iter().map(near).fold(f64::INFINITY, f64::min) - radius
        }
        _ => pair_separation(search, Placed::new(flat.set(triangle), &Pose::IDENTITY), Placed::new(other, x)),
    }
}

/// Adds the contacts of a triangle with a curved body, found as those of a flat polyhedron with that body. Returns the
/// separation, m.
pub(crate) fn of_curved(
    buffers: &mut PairBuffers,
    pair: &MeshPair<'_>,
    triangle: &Triangle,
    (flat, manifold): (&mut FlatTriangle, &mut Manifold),
    contacts: &mut Vec<MeshContact>,
) -> f64 {
    let MeshPair { mesh, other, x, reach, .. } = pair;
    let flat_triangle = Placed::new(flat.set(triangle), &Pose::IDENTITY);
    pair_manifold(buffers, flat_triangle, Placed::new(other, x), *reach, manifold);
    let on_triangle = OnTriangle { pair, triangle };
    let mut lost = false;
    for local in &manifold.contacts {
        let Some(contact) = on_triangle.measure(local.feature) else { continue };
        let place = local.geometry.point + local.geometry.normal * (0.5 * local.geometry.separation);
        let at = on_triangle.feature_at(place);
        let edges = &mesh.edges_of[triangle.index as usize];
        let flat_edge = matches!(at, TriangleFeature::Edge(k) if mesh.edges[edges[k] as usize].flat);
        let supported = on_triangle.supports(at, -local.geometry.normal, SAME_DIRECTION);
        // A face keeps its normal up to its border, even where the next face rises: in a valley both faces have
        // contacts.
        if is_on_face(local.feature) || (supported && !flat_edge) {
            contacts.push(MeshContact { contact, order: 0, on_convex_edge: at != TriangleFeature::Face && supported });
        } else {
            lost = true;
        }
    }
    if lost && is_round(other) {
        on_own_face(&mut buffers.features, &on_triangle, flat.set(triangle), manifold, contacts);
    }
    manifold.separation
}

/// Whether a contact of a triangle as a flat polyhedron lies on one of its faces.
const fn is_on_face(feature: ContactFeature) -> bool {
    matches!(
        feature,
        ContactFeature::VertexFace { vertex_of: Side::B, .. }
            | ContactFeature::Smooth { center_of: Side::B, against: SurfaceFeature::Face(_), .. }
            | ContactFeature::Elements { a: SurfaceFeature::Face(_), .. }
    )
}

/// Adds the contacts of a round body on the face of a triangle that were hidden by invalid contacts at the same place.
/// At the bottom of a valley, a disc crosses the edges of both sides, and a mesh vertex may lie on the disc at the same
/// place as a point of the rim lies on the face. The surface does not have the first contact of each such pair, but has
/// the second one. The contacts of `manifold` must have been used before: this function overwrites them.
fn on_own_face(
    features: &mut Vec<ContactFeature>,
    on_triangle: &OnTriangle<'_>,
    flat: &Shape,
    manifold: &mut Manifold,
    contacts: &mut Vec<MeshContact>,
) {
    let MeshPair { other, x, reach, tolerance, .. } = on_triangle.pair;
    let slack = SAME_PLACE_OF_PARTS * *tolerance;
    let body = Body::whole(other, *x);
    for (side, sign) in [(0, 1.0), (1, -1.0)] {
        let outward = on_triangle.triangle.normal * sign;
        let along = -body.support(-outward) - on_triangle.triangle.offset * sign;
        if along > *reach || along < manifold.separation.min(0.0) * DEEPER - slack {
            continue;
        }
        let gap = Gap {
            separation: along,
            normal: -outward,
            a: SurfaceFeature::Face(side),
            b: body.farthest(-outward),
            tolerance: *tolerance,
        };
        let pair = (Placed::new(flat, &Pose::IDENTITY), Placed::new(other, x));
        manifold.contacts.clear();
        let found = &mut manifold.contacts;
        round_region::contacts(features, pair.0, pair.1, &gap, *reach, is_on_face, found);
        let measured = found.iter().filter_map(|contact| on_triangle.measure(contact.feature));
        let within = measured.filter(|contact| contact.geometry.margin >= -slack);
        contacts.extend(within.map(|contact| MeshContact { contact, order: 0, on_convex_edge: false }));
    }
}
