//! Crossings of ridges that end where the bodies meet.
//!
//! A ridge of a body (a convex edge of its whole surface) may bend: at the vertex between its two pieces the surface rises
//! beside each of them, as on the inner side of a ring of straight pieces. What rests in such a bend touches both pieces,
//! and neither the normals of a part nor those of the vertex say so: the body rises above the plane of every crossing there,
//! so that each alone looks like one of a hidden edge, and the vertex has no normal at all. Two bends may also meet, as in a
//! taut chain, and cross in four places at once.
//!
//! At a place where the bodies meet at the border of their features, every edge of A that passes or ends there is crossed
//! with every one of B. The crossing is a contact when both whole surfaces fall away from its plane right beside the
//! place, along either edge, and when one of the bodies rises above the plane at the place itself: where neither does, the
//! normal is one of many that a convex vertex or edge has, of which the separating axes choose.
//!
//! Fails where a piece of a ridge is shorter than a probe (`surface_probe.rs`), or bends by less than rounding shows over a probe.

use crate::bounding::Bounds;
use crate::narrow_phase::feature::edge_line::EdgeLine;
use crate::narrow_phase::parts::surface_probe::{LEAST_PROBE, SLOPE, probe_length};
use crate::narrow_phase::terms::crossed_edges::CrossedEdges;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::shape::triangle::from_triangle;
use crate::shape::{Compound, TriangleMesh};
use crate::{Contact, ContactFeature, ContactGeometry, Shape};
use glam::DVec3;
use polhode_spatial::Pose;

/// Buffers of [`crossings`].
#[derive(Debug, Clone, Default)]
pub(crate) struct RidgeBuffers {
    /// Places at which the bodies meet at the border of a feature, in the frame of the poses.
    pub(crate) places: Vec<DVec3>,
    near: Vec<u32>,
    here: [Vec<EdgeHere>; 2],
}

/// An edge of a body that passes or ends at a place.
#[derive(Debug, Clone, Copy)]
struct EdgeHere {
    number: u32,
    /// A probe away from the place along the edge, in the body's frame; nothing beyond its end.
    beside: [Option<DVec3>; 2],
    along: DVec3,
}

/// Two bodies that touch.
#[derive(Clone, Copy)]
pub(crate) struct TouchingPair<'a> {
    pub(crate) shapes: [&'a Shape; 2],
    pub(crate) poses: [&'a Pose; 2],
    /// Places nearer than this are one, m.
    pub(crate) same_place: f64,
}

impl TouchingPair<'_> {
    /// Whether the bodies meet in a contact of two of their parts at the border of its features.
    pub(crate) fn is_at_border(&self, contact: &ContactGeometry) -> bool {
        contact.separation.abs() <= self.same_place && contact.margin.abs() <= self.same_place
    }
}

/// What a body's surface is made of.
#[derive(Clone, Copy)]
enum Surface<'a> {
    Parts(&'a Compound),
    Single(&'a ConvexPolyhedron),
    Mesh(&'a TriangleMesh),
}

/// A surface near a place.
#[derive(Clone, Copy)]
struct Looked<'a> {
    surface: Surface<'a>,
    /// Up to this a place lies in a part, m.
    slack: f64,
}

/// Adds the contacts at the places that the buffers hold; the places are forgotten. Some occur more than once.
pub(crate) fn crossings(buffers: &mut RidgeBuffers, pair: TouchingPair<'_>, contacts: &mut Vec<Contact>) {
    let RidgeBuffers { places, near, here } = buffers;
    let looked = [0, 1].map(|at| Looked::new(pair.shapes[at], pair.same_place));
    let [Some(a), Some(b)] = looked else { return places.clear() };
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

/// The crossing of two edges at a place, when it is a contact of the whole surfaces.
fn crossing(
    pair: TouchingPair<'_>,
    bodies: [Looked<'_>; 2],
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
    let mut stands = |k: usize| {
        let mut beside = edges[k].beside.iter().flatten();
        beside.any(|&x| bodies[k].falls_away(x, edges[k], outward[k], near))
    };
    if !(stands(0) && stands(1)) {
        return None;
    }
    let mut rises = |k: usize| bodies[k].rises(own[k], outward[k], near);
    let feature = ContactFeature::EdgeEdge { edge_a: edges[0].number, edge_b: edges[1].number };
    (rises(0) || rises(1)).then_some(Contact { feature, geometry })
}

impl<'a> Looked<'a> {
    /// Nothing for a shape without edges.
    const fn new(shape: &'a Shape, slack: f64) -> Option<Self> {
        let surface = match shape {
            Shape::Compound(compound) => Surface::Parts(compound),
            Shape::Convex(polyhedron) => Surface::Single(polyhedron),
            Shape::TriangleMesh(mesh) => Surface::Mesh(mesh),
            _ => return None,
        };
        Some(Self { surface, slack })
    }

    /// The parts or triangles whose boxes come near a place.
    fn look(&self, x: DVec3, near: &mut Vec<u32>) {
        near.clear();
        let here = Bounds { min: x, max: x }.inflated(self.slack);
        match self.surface {
            Surface::Parts(compound) => compound.tree.overlaps(&here, &mut |part| near.push(part)),
            Surface::Single(_) => near.push(0),
            Surface::Mesh(mesh) => mesh.tree.overlaps(&here, &mut |triangle| near.push(triangle)),
        }
        near.sort_unstable();
    }

    /// The polyhedra among the parts looked at, with the number of their first edge.
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

    /// The edges that pass or end at a place.
    fn edges_at(&self, x: DVec3, near: &mut Vec<u32>, found: &mut Vec<EdgeHere>) {
        self.look(x, near);
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

    /// An edge by its number among all of the body.
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

    /// Whether at a place on an edge the whole surface falls away from the plane across `v`, and is not flush with it.
    fn falls_away(&self, x: DVec3, edge: &EdgeHere, v: DVec3, near: &mut Vec<u32>) -> bool {
        if let Surface::Mesh(mesh) = self.surface {
            return mesh.supports_at_edge(edge.number, v, self.slack, SLOPE);
        }
        self.look(x, near);
        let level = v.dot(x) + self.slack;
        let holding = || self.polyhedra(near).map(|(p, _)| p).filter(|p| p.outside(x) <= self.slack);
        let falls = |p: &ConvexPolyhedron| p.vertices.iter().all(|w| w.dot(v) <= level + SLOPE * w.distance(x));
        if !holding().all(falls) {
            return false;
        }
        let across = edge.along.cross(v).normalize_or_zero() * (LEAST_PROBE * self.slack);
        let is_filled = |y: DVec3| holding().any(|p| p.outside(y) <= self.slack);
        !(is_filled(x + across) && is_filled(x - across))
    }

    /// Whether the surface at a place rises above the plane across `v`.
    fn rises(&self, x: DVec3, v: DVec3, near: &mut Vec<u32>) -> bool {
        self.look(x, near);
        let above = |w: &DVec3| w.dot(v) > v.dot(x) + LEAST_PROBE * self.slack;
        if let Surface::Mesh(mesh) = self.surface {
            return near.iter().any(|&triangle| {
                let corners = mesh.corner_places(triangle);
                from_triangle(&corners, x).0.length() <= self.slack && corners.iter().any(above)
            });
        }
        let mut holding = self.polyhedra(near).map(|(p, _)| p).filter(|p| p.outside(x) <= self.slack);
        holding.any(|p| p.vertices.iter().any(above))
    }
}
