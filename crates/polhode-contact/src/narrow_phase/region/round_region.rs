//! All contacts of the region in which two bodies touch, at least one of them round.
//!
//! The support set of each body along the separating normal is flat (a face, a disc or a torus whose normal or axis is
//! within 0.01 rad of it), a line (a side or edge perpendicular to it within 0.01 rad), or a point. The overlap of the
//! two sets has corners of three kinds, as for polygons (thesis 3.4, figure 17): a corner of A's set over B's, one of
//! B's over A's, and crossings of their borders.
//!
//! | support set | corners | border |
//! |---|---|---|
//! | face | its vertices | its edges |
//! | disc | its sample points ([`crate::shape::round`]) and the lowest point of its rim when it is tilted | its rim |
//! | torus that lies flat | its sample points and its lowest point | its centre circle |
//! | side of a capsule | the caps | the line |
//! | side of a cylinder | the lowest points of its rims | the line |
//! | side of a cone | the apex and the lowest point of its rim | the line |
//! | edge | its vertices | the edge |
//!
//! A line that lies along the border of a face, and has passed it, touches the edge all along, and no crossing of the
//! two is defined. There the corners of the line are tried against that edge too.
//!
//! Every candidate is evaluated; those with a negative margin or a separation beyond the reach are dropped. Of two at
//! one point the first in this order is kept: corners, crossings, the pair of elements with the largest separation
//! itself.

use crate::narrow_phase::axis::gap::Gap;
use crate::narrow_phase::feature::alike::{ALIKE, ALIKE_SINE};
use crate::narrow_phase::feature::contact_name::named;
use crate::narrow_phase::feature::element::Element;
use crate::narrow_phase::feature::placed::Placed;
use crate::narrow_phase::region::same_place::SAME_PLACE;
use crate::narrow_phase::terms::evaluate::evaluate;
use crate::shape::circle::RIM_POINTS;
use crate::shape::round::circles;
use crate::{Contact, ContactFeature, Shape, SurfaceFeature};
use glam::DVec3;

/// The support set of a body along a direction, up to 0.01 rad.
#[derive(Debug, Clone, Copy, PartialEq)]
enum SupportSet {
    /// A face or disc.
    Flat(u32),
    /// A torus that lies flat.
    Ring,
    /// A side or an edge.
    Line(SurfaceFeature),
    /// Neither.
    Point,
}

/// The bodies of a region and the candidates found so far.
struct Region<'a> {
    a: Placed<'a>,
    b: Placed<'a>,
    features: &'a mut Vec<ContactFeature>,
}

/// Adds the contacts of a pair whose best axis is known (`gap`, normal in the world) to `contacts`, sorted by feature:
/// those with a separation of at most `reach` (m) and a feature for which `wanted` is true.
pub(crate) fn contacts(
    features: &mut Vec<ContactFeature>,
    a: Placed<'_>,
    b: Placed<'_>,
    gap: &Gap,
    reach: f64,
    wanted: impl Fn(ContactFeature) -> bool,
    contacts: &mut Vec<Contact>,
) {
    features.clear();
    let mut region = Region { a, b, features };
    region.collect(gap.normal);
    region.features.push(named(gap.a, gap.b));
    region.features.retain(|&feature| wanted(feature));
    let measure = |feature: ContactFeature| {
        evaluate(feature, a.shape, a.pose, b.shape, b.pose).map(|geometry| Contact { feature, geometry })
    };
    // The contacts before `first` belong to other regions of the pair.
    let first = contacts.len();
    for contact in features.iter().filter_map(|&feature| measure(feature)) {
        let geometry = &contact.geometry;
        let fits = geometry.separation <= reach
            && geometry.margin >= -gap.tolerance
            && geometry.normal.dot(gap.normal) >= ALIKE;
        let near = |other: &Contact| {
            let between = other.geometry.point - geometry.point;
            let lateral = between - gap.normal * gap.normal.dot(between);
            lateral.length() <= SAME_PLACE * gap.tolerance
        };
        if fits && !contacts[first..].iter().any(near) && !grazes(&contact, a, b, gap) {
            contacts.push(contact);
        }
    }
    for feature in level_points(a.shape, b.shape, gap) {
        let Some(contact) = measure(feature) else { continue };
        let geometry = &contact.geometry;
        let level = (geometry.separation - gap.separation).abs() <= SAME_PLACE * gap.tolerance;
        let is_within = geometry.margin >= -gap.tolerance;
        let near = |other: &Contact| other.geometry.point.distance(geometry.point) <= SAME_PLACE * gap.tolerance;
        if level && is_within && geometry.separation <= reach && !contacts[first..].iter().any(near) {
            contacts.push(contact);
        }
    }
    if contacts.len() == first && gap.separation <= gap.tolerance {
        // Bodies that touch have a contact, also where tolerances left none. The deepest point of a torus inside a body
        // may be equally near to two elements; it is then no common normal of either, and the common normal of the pair
        // may be far away.
        let touches = |contact: &Contact| contact.geometry.separation <= reach.max(gap.tolerance);
        contacts.extend(measure(named(gap.a, gap.b)).filter(touches));
    }
    contacts[first..].sort_unstable_by_key(|contact| contact.feature);
}

/// The sample points of a torus against the element that it is nearest to: coaxial bodies touch all along a circle,
/// which these points represent.
fn level_points<'a>(shape_a: &'a Shape, shape_b: &'a Shape, gap: &'a Gap) -> impl Iterator<Item = ContactFeature> + 'a {
    use SurfaceFeature::{Rim, Vertex};
    let rings = [shape_a.is_ring(), shape_b.is_ring()];
    let along = [rings[0] && gap.a == Rim(0), rings[1] && gap.b == Rim(0) && !rings[0]];
    (0..RIM_POINTS).flat_map(move |k| {
        let of_a = along[0].then(|| named(Vertex(k), gap.b));
        let of_b = along[1].then(|| named(gap.a, Vertex(k)));
        of_a.into_iter().chain(of_b)
    })
}

/// Whether the two crossings of a rim coincide, so that the other curve only grazes the disc, within the tolerance.
fn grazes(contact: &Contact, placed_a: Placed<'_>, placed_b: Placed<'_>, gap: &Gap) -> bool {
    use SurfaceFeature::{RimEntry, RimExit};
    let ContactFeature::Elements { a, b } = contact.feature else { return false };
    let other_branch = |feature| match feature {
        RimExit(rim) => RimEntry(rim),
        RimEntry(rim) => RimExit(rim),
        _ => feature,
    };
    let radius = |shape: &Shape, feature| match feature {
        RimExit(rim) | RimEntry(rim) => circles(shape).get(rim as usize).map_or(f64::INFINITY, |circle| circle.radius),
        _ => f64::INFINITY,
    };
    let least = radius(placed_a.shape, a).min(radius(placed_b.shape, b));
    if least.is_infinite() {
        return false;
    }
    let twin = ContactFeature::Elements { a: other_branch(a), b: other_branch(b) };
    let twin = evaluate(twin, placed_a.shape, placed_a.pose, placed_b.shape, placed_b.pose);
    // On the centre circle of a torus two nearby points are one contact of the tube, which may have no twin.
    let Some(twin) = twin else { return !(placed_a.shape.is_ring() || placed_b.shape.is_ring()) };
    // The height of an arc over its chord `c` is `c^2/(8 r)`.
    let chord = twin.point.distance_squared(contact.geometry.point);
    chord <= 8.0 * least * SAME_PLACE * gap.tolerance
}

/// The support set of a shape along an outward unit vector in the world.
fn support_set(Placed { shape, pose }: Placed<'_>, outward: DVec3) -> SupportSet {
    let outward = pose.rotation.inverse_rotate(outward);
    let side = |axis: DVec3, sine: f64| {
        let lies = (outward.dot(axis) - sine).abs() <= ALIKE_SINE;
        if lies { SupportSet::Line(SurfaceFeature::Side(0)) } else { SupportSet::Point }
    };
    match shape {
        Shape::HalfSpace(_) => SupportSet::Flat(0),
        Shape::Convex(polyhedron) => {
            let along = |f: &usize| polyhedron.faces[*f].normal.dot(outward);
            let best = (0..polyhedron.faces.len()).max_by(|f, g| along(f).total_cmp(&along(g)));
            match best.filter(|f| along(f) >= ALIKE) {
                Some(face) => SupportSet::Flat(face as u32),
                None => edge_along(polyhedron, outward),
            }
        }
        Shape::Cylinder(c) if outward.dot(c.axis).abs() >= ALIKE => {
            SupportSet::Flat(u32::from(outward.dot(c.axis) > 0.0))
        }
        Shape::Cone(c) if -outward.dot(c.axis) >= ALIKE => SupportSet::Flat(0),
        Shape::Torus(t) if outward.dot(t.axis).abs() >= ALIKE => SupportSet::Ring,
        Shape::Cylinder(c) => side(c.axis, 0.0),
        Shape::Cone(c) => side(c.axis, c.radius / libm::hypot(c.radius, c.height)),
        Shape::Capsule(c) => side((c.ends[1] - c.ends[0]).normalize(), 0.0),
        _ => SupportSet::Point,
    }
}

/// The edge of a polyhedron that is perpendicular to a direction at the support point, if there is one.
fn edge_along(polyhedron: &crate::ConvexPolyhedron, outward: DVec3) -> SupportSet {
    let height = |v: u32| outward.dot(polyhedron.vertices[v as usize]);
    let top = (0..polyhedron.vertices.len() as u32).map(height).fold(f64::NEG_INFINITY, f64::max);
    let drop = |edge: &crate::Edge| top - height(edge.vertices[0]).min(height(edge.vertices[1]));
    let lying = polyhedron.edges.iter().enumerate().filter(|(_, edge)| drop(edge) <= ALIKE_SINE * edge.length);
    lying
        .min_by(|(_, e), (_, f)| drop(e).total_cmp(&drop(f)))
        .map_or(SupportSet::Point, |(index, _)| SupportSet::Line(SurfaceFeature::Edge(index as u32)))
}

/// Calls `visit` with the corners of a support set.
fn each_corner(shape: &Shape, set: SupportSet, mut visit: impl FnMut(SurfaceFeature)) {
    use SurfaceFeature::{Cap, Edge, Rim, Vertex};
    match (shape, set) {
        (Shape::Convex(polyhedron), SupportSet::Flat(face)) => {
            let face = polyhedron.face(face as usize);
            face.iter().flat_map(|face| face.vertices).for_each(|&v| visit(Vertex(v)));
        }
        (Shape::Convex(polyhedron), SupportSet::Line(Edge(edge))) => {
            let edge = polyhedron.edges.get(edge as usize);
            edge.iter().flat_map(|edge| edge.vertices).for_each(|v| visit(Vertex(v)));
        }
        (Shape::Cylinder(_), SupportSet::Flat(face)) => {
            (0..RIM_POINTS).for_each(|k| visit(Vertex(face * RIM_POINTS + k)));
            visit(Rim(face));
        }
        (Shape::Cone(_), SupportSet::Flat(_)) => {
            (1..=RIM_POINTS).for_each(|k| visit(Vertex(k)));
            visit(Rim(0));
        }
        (Shape::Torus(_), SupportSet::Ring) => {
            (0..RIM_POINTS).for_each(|k| visit(Vertex(k)));
            visit(Rim(0));
        }
        (Shape::Cylinder(_), SupportSet::Line(_)) => [Rim(0), Rim(1)].into_iter().for_each(visit),
        (Shape::Cone(_), SupportSet::Line(_)) => [Vertex(0), Rim(0)].into_iter().for_each(visit),
        (Shape::Capsule(_), SupportSet::Line(_)) => [Cap(0), Cap(1)].into_iter().for_each(visit),
        _ => {}
    }
}

/// Calls `visit` with each border of a support set as a pair of features: an edge or side twice, or the two crossings
/// of a rim.
fn each_border(shape: &Shape, set: SupportSet, mut visit: impl FnMut([SurfaceFeature; 2])) {
    use SurfaceFeature::{Edge, RimEntry, RimExit};
    match (shape, set) {
        (Shape::Convex(polyhedron), SupportSet::Flat(face)) => {
            let face = polyhedron.face(face as usize);
            face.iter().flat_map(|face| face.edges).for_each(|&edge| visit([Edge(edge); 2]));
        }
        (Shape::Cylinder(_) | Shape::Cone(_), SupportSet::Flat(face)) => visit([RimExit(face), RimEntry(face)]),
        (Shape::Torus(_), SupportSet::Ring) => visit([RimExit(0), RimEntry(0)]),
        (_, SupportSet::Line(line)) => visit([line; 2]),
        _ => {}
    }
}

impl Region<'_> {
    /// Lists the candidates.
    fn collect(&mut self, normal: DVec3) {
        let (set_a, set_b) = (support_set(self.a, -normal), support_set(self.b, normal));
        let (shape_a, shape_b) = (self.a.shape, self.b.shape);
        let base = |set: SupportSet| match set {
            SupportSet::Flat(face) => Some(SurfaceFeature::Face(face)),
            SupportSet::Line(line) => Some(line),
            SupportSet::Ring | SupportSet::Point => None,
        };
        // The corners of a line lie on a plane under it; of two lines each has its corners on the other when they are
        // parallel.
        let wider = |this: SupportSet, other: SupportSet| {
            matches!(this, SupportSet::Flat(_)) || matches!(other, SupportSet::Line(_))
        };
        if let Some(base_b) = base(set_b).filter(|_| wider(set_b, set_a)) {
            each_corner(shape_a, set_a, |corner| self.features.push(named(corner, base_b)));
        }
        if let Some(base_a) = base(set_a).filter(|_| wider(set_a, set_b)) {
            each_corner(shape_b, set_b, |corner| self.features.push(named(base_a, corner)));
        }
        each_border(shape_a, set_a, |[first_a, second_a]| {
            each_border(shape_b, set_b, |[first_b, second_b]| {
                self.features.push(named(first_a, first_b));
                if (first_a, first_b) != (second_a, second_b) {
                    self.features.push(named(second_a, second_b));
                }
            });
        });
        self.collect_beyond_border([set_a, set_b], normal);
    }

    /// Lists the corners of a line that lies along an edge of a face and has passed it: the normal from the edge to the
    /// corner leans out of the face.
    fn collect_beyond_border(&mut self, sets: [SupportSet; 2], normal: DVec3) {
        let (flat, round, face, line, upward) = match sets {
            [SupportSet::Flat(face), SupportSet::Line(line)] => (self.a, self.b, face, line, -normal),
            [SupportSet::Line(line), SupportSet::Flat(face)] => (self.b, self.a, face, line, normal),
            _ => return,
        };
        let Shape::Convex(polyhedron) = flat.shape else { return };
        let along = Element::of(round.shape, line, round.pose).and_then(|side| side.straight_direction(-upward));
        let (Some(face), Some(along)) = (polyhedron.face(face as usize), along) else { return };
        let along = flat.pose.rotation.inverse_rotate(along);
        for (&edge, &side) in face.edges.iter().zip(face.sides) {
            if polyhedron.edges[edge as usize].direction.cross(along).length() > ALIKE_SINE {
                continue;
            }
            let outward = flat.pose.rotation.rotate(side);
            each_corner(round.shape, SupportSet::Line(line), |corner| {
                let edge = SurfaceFeature::Edge(edge);
                let (feature, toward) = match sets[0] {
                    SupportSet::Flat(_) => (named(edge, corner), -outward),
                    _ => (named(corner, edge), outward),
                };
                let found = evaluate(feature, self.a.shape, self.a.pose, self.b.shape, self.b.pose);
                if found.is_some_and(|geometry| geometry.normal.dot(toward) > 0.0) {
                    self.features.push(feature);
                }
            });
        }
    }
}
