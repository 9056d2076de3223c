//! Edge-edge contacts at the vertices of bent ridges.
//!
//! A ridge is a convex edge of the whole surface of a body. It may bend at a vertex: on the inner side of a ring of
//! straight pieces, the surface beside the vertex rises above the planes of both pieces. A body that lies in such a
//! bend touches both pieces. The normals of a single part do not give these contacts: the whole surface rises above the
//! contact plane at the vertex, so that each crossing looks like one at a hidden edge, and the vertex itself has no
//! valid normal. Two bends may also touch each other, as in a tight chain. They then have four crossings at one place.
//!
//! The search starts from places at which the bodies touch at the border of a feature. Every edge of A that passes
//! through or ends at such a place is crossed with every such edge of B. The crossing is a contact under two
//! conditions:
//!
//! - both whole surfaces lie below the contact plane right beside the place, along either edge;
//! - at least one body rises above the contact plane at the place itself. Where neither does, the normal is one of many
//!   that a convex vertex or edge allows, and the separating axes choose among those.
//!
//! Limits: the method fails where a piece of a ridge is shorter than a probe (`surface_probe.rs`), or where the bend
//! over the length of a probe is smaller than rounding.

use crate::bounding::aabb::Aabb;
use crate::narrow_phase::feature::edge_line::EdgeLine;
use crate::narrow_phase::parts::surface_probe::{LEAST_PROBE, probe_length};
use crate::narrow_phase::terms::crossed_edges::CrossedEdges;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::shape::triangle::from_triangle;
use crate::shape::{Compound, TriangleMesh};
use crate::{Contact, ContactFeature, ContactGeometry, Shape};
use glam::DVec3;
use polhode_spatial::Pose;
use polhode_spatial::unit_vector::SAME_DIRECTION;

/// Buffers of [`crossings`].
#[derive(Debug, Clone, Default)]
pub(crate) struct RidgeBuffers {
    /// Places at which the bodies touch at the border of a feature, in the frame of the poses.
    pub(crate) places: Vec<DVec3>,
    near: Vec<u32>,
    here: [Vec<EdgeHere>; 2],
}

/// An edge of a body that passes through or ends at a place.
#[derive(Debug, Clone, Copy)]
struct EdgeHere {
    number: u32,
    /// Points at the length of a probe from the place, in both directions along the edge, in the body's frame; `None`
    /// where the edge ends before.
    beside: [Option<DVec3>; 2],
    along: DVec3,
}

/// Two bodies that touch.
#[derive(Clone, Copy)]
pub(crate) struct TouchingPair<'a> {
    pub(crate) shapes: [&'a Shape; 2],
    pub(crate) poses: [&'a Pose; 2],
    /// Places nearer to each other than this are the same, m.
    pub(crate) same_place: f64,
}

impl TouchingPair<'_> {
    /// Whether a contact of two parts lies at the border of its features, with no gap.
    pub(crate) fn is_at_border(&self, contact: &ContactGeometry) -> bool {
        contact.separation.abs() <= self.same_place && contact.margin.abs() <= self.same_place
    }
}

/// The surface of a body, by kind of shape.
#[derive(Clone, Copy)]
enum Surface<'a> {
    Parts(&'a Compound),
    Single(&'a ConvexPolyhedron),
    Mesh(&'a TriangleMesh),
}

/// The surface of a body, with the tolerance for tests near a place.
#[derive(Clone, Copy)]
struct LocalSurface<'a> {
    surface: Surface<'a>,
    /// A place at most this far outside a part counts as inside, m.
    slack: f64,
}

/// Adds the contacts at the places in the buffers and clears these places. The same contact may be added more than
/// once.
pub(crate) fn crossings(buffers: &mut RidgeBuffers, pair: TouchingPair<'_>, contacts: &mut Vec<Contact>) {
    let RidgeBuffers { places, near, here } = buffers;
    let surfaces = [0, 1].map(|at| LocalSurface::new(pair.shapes[at], pair.same_place));
    let [Some(a), Some(b)] = surfaces else { return places.clear() };
    places.sort_unstable_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)).then(p.z.total_cmp(&q.z)));
    for (k, &place) in places.iter().enumerate() {
        let mut before = places[..k].iter().rev().take_while(|known| place.x - known.x <= pair.same_place);
        if before.any(|known| known.distance(place) <= pair.same_place) {
            continue;
        }
        let own = pair.poses.map(|pose| pose.inverse_transform_point(place));
        a.edges_at(own[0], near, &mut here[0]);
        b.edges_at(own[1], near, &mut here[1]);
        for edge_a in &here[0] {
            for edge_b in &here[1] {
                contacts.extend(crossing(pair, [a, b], own, [edge_a, edge_b], near));
            }
        }
    }
    places.clear();
}

/// The crossing of two edges at a place; `None` when it is not a contact of the whole surfaces.
fn crossing(
    pair: TouchingPair<'_>,
    bodies: [LocalSurface<'_>; 2],
    own: [DVec3; 2],
    edges: [&EdgeHere; 2],
    near: &mut Vec<u32>,
) -> Option<Contact> {
    let [pose_a, pose_b] = pair.poses;
    let lines = [bodies[0].line(edges[0].number)?, bodies[1].line(edges[1].number)?];
    let geometry = CrossedEdges::between(&lines[0], pose_a, &lines[1], pose_b)?.geometry();
    if geometry.margin < -pair.same_place || geometry.separation.abs() > pair.same_place {
        return None;
    }
    let outward = [pose_a.rotation.inverse_rotate(-geometry.normal), pose_b.rotation.inverse_rotate(geometry.normal)];
    let mut is_convex = |k: usize| {
        let mut beside = edges[k].beside.iter().flatten();
        beside.any(|&x| bodies[k].lies_below(x, edges[k], outward[k], near))
    };
    if !(is_convex(0) && is_convex(1)) {
        return None;
    }
    let mut rises = |k: usize| bodies[k].rises(own[k], outward[k], near);
    let feature = ContactFeature::EdgeEdge { edge_a: edges[0].number, edge_b: edges[1].number };
    (rises(0) || rises(1)).then_some(Contact { feature, geometry })
}

impl<'a> LocalSurface<'a> {
    /// `None` for a shape without edges.
    const fn new(shape: &'a Shape, slack: f64) -> Option<Self> {
        let surface = match shape {
            Shape::Compound(compound) => Surface::Parts(compound),
            Shape::Convex(polyhedron) => Surface::Single(polyhedron),
            Shape::TriangleMesh(mesh) => Surface::Mesh(mesh),
            _ => return None,
        };
        Some(Self { surface, slack })
    }

    /// Collects the parts or triangles whose boxes are near a place.
    fn collect_near(&self, x: DVec3, near: &mut Vec<u32>) {
        near.clear();
        let here = Aabb::of_point(x).widened(self.slack);
        match self.surface {
            Surface::Parts(compound) => compound.tree.overlaps(&here, &mut |part| near.push(part)),
            Surface::Single(_) => near.push(0),
            Surface::Mesh(mesh) => mesh.tree.overlaps(&here, &mut |triangle| near.push(triangle)),
        }
        near.sort_unstable();
    }

    /// The polyhedra among the nearby parts, each with the number of its first edge.
    fn polyhedra(&self, near: &'a [u32]) -> impl Iterator<Item = (&'a ConvexPolyhedron, u32)> {
        let surface = self.surface;
        near.iter().filter_map(move |&part| match surface {
            Surface::Parts(compound) => match compound.parts.get(part as usize)? {
                Shape::Convex(polyhedron) => Some((polyhedron, compound.first.get(part as usize)?.edge)),
                _ => None,
            },
            Surface::Single(polyhedron) => Some((polyhedron, 0)),
            Surface::Mesh(_) => None,
        })
    }

    /// Collects the edges that pass through or end at a place.
    fn edges_at(&self, x: DVec3, near: &mut Vec<u32>, found: &mut Vec<EdgeHere>) {
        self.collect_near(x, near);
        found.clear();
        let mut offer = |number: u32, (from, along, length): (DVec3, DVec3, f64), size: f64| {
            let at = along.dot(x - from);
            if (x - from - along * at.clamp(0.0, length)).length() > self.slack {
                return;
            }
            let probe = probe_length(size, self.slack);
            let beside = [at - probe, at + probe].map(|s| (0.0..=length).contains(&s).then_some(from + along * s));
            found.push(EdgeHere { number, beside, along });
        };
        if let Surface::Mesh(mesh) = self.surface {
            for &triangle in near.iter() {
                for &number in &mesh.edges_of[triangle as usize] {
                    let edge = mesh.edges[number as usize];
                    let from = mesh.vertices[edge.vertices[0] as usize];
                    if !edge.flat {
                        offer(number, (from, edge.direction, edge.length), edge.length);
                    }
                }
            }
            found.sort_unstable_by_key(|edge| edge.number);
            found.dedup_by_key(|edge| edge.number);
            return;
        }
        for (polyhedron, first) in self.polyhedra(near) {
            for (number, edge) in (first..).zip(&polyhedron.edges) {
                let from = polyhedron.vertices[edge.vertices[0] as usize];
                offer(number, (from, edge.direction, edge.length), polyhedron.size);
            }
        }
    }

    /// The line of an edge, by its number in the whole body.
    fn line(&self, number: u32) -> Option<EdgeLine> {
        match self.surface {
            Surface::Parts(compound) => {
                let (_, part, number) = compound.owner(number, |first| first.edge)?;
                part.edge_line(number)
            }
            Surface::Single(polyhedron) => EdgeLine::of_polyhedron(polyhedron, number),
            Surface::Mesh(mesh) => EdgeLine::of_mesh(mesh, number),
        }
    }

    /// Whether the whole surface at a place on an edge lies below the plane with normal `v`, and does not lie in it on
    /// both sides of the edge.
    fn lies_below(&self, x: DVec3, edge: &EdgeHere, v: DVec3, near: &mut Vec<u32>) -> bool {
        if let Surface::Mesh(mesh) = self.surface {
            return mesh.supports_at_edge(edge.number, v, self.slack, SAME_DIRECTION);
        }
        self.collect_near(x, near);
        let level = v.dot(x) + self.slack;
        let containing = || self.polyhedra(near).map(|(p, _)| p).filter(|p| p.outside(x) <= self.slack);
        let below =
            |p: &ConvexPolyhedron| p.vertices.iter().all(|w| w.dot(v) <= level + SAME_DIRECTION * w.distance(x));
        if !containing().all(below) {
            return false;
        }
        let across = edge.along.cross(v).normalize_or_zero() * (LEAST_PROBE * self.slack);
        let is_filled = |y: DVec3| containing().any(|p| p.outside(y) <= self.slack);
        !(is_filled(x + across) && is_filled(x - across))
    }

    /// Whether the surface at a place rises above the plane with normal `v`.
    fn rises(&self, x: DVec3, v: DVec3, near: &mut Vec<u32>) -> bool {
        self.collect_near(x, near);
        let above = |w: &DVec3| w.dot(v) > v.dot(x) + LEAST_PROBE * self.slack;
        if let Surface::Mesh(mesh) = self.surface {
            return near.iter().any(|&triangle| {
                let corners = mesh.corners(triangle);
                from_triangle(&corners, x).0.length() <= self.slack && corners.iter().any(above)
            });
        }
        let mut containing = self.polyhedra(near).map(|(p, _)| p).filter(|p| p.outside(x) <= self.slack);
        containing.any(|p| p.vertices.iter().any(above))
    }
}
