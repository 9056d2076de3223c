//! Chooses the common normal of two elements that is the contact named by them.

use crate::clearance::COINCIDENCE;
use crate::narrow_phase::common_normal::branch_offset::is_named;
use crate::narrow_phase::common_normal::place::Place;
use crate::narrow_phase::feature::element::{Border, Element, Locus};
use glam::DVec3;

/// The common normal that is a contact: on the named branch, and within the borders of both elements if there is such a
/// one. Of several it is the one with the nearest points of the two loci; on a cone the one with the largest
/// separation; for a torus the one whose centre circle is nearest to the surface.
pub(crate) fn chosen(all: &[Place], a: &Element<'_>, b: &Element<'_>) -> Option<Place> {
    let cones = matches!(a.locus, Locus::Cone(_)) || matches!(b.locus, Locus::Cone(_));
    let score = |place: &Place| {
        if a.is_ring() || b.is_ring() {
            -(place.separation(a, b) + a.ball + b.ball).abs()
        } else if cones {
            place.separation(a, b)
        } else {
            -place.on_a.distance_squared(place.on_b)
        }
    };
    let border = |place: &Place| COINCIDENCE * (place.on_a.length() + place.on_b.length());
    let within = |place: &Place| margin(place, a, b) >= -border(place);
    let fitting = all.iter().filter(|place| is_named(place, a, b)).map(|place| oriented(*place, a, b));
    // An edge of a polyhedron has two common normals with a cone, one of which points into the polyhedron.
    let outwards = |place: &Place| place.normal.dot(b.outward - a.outward) >= 0.0;
    let keys = |place: &Place| (outwards(place), within(place));
    fitting.max_by(|p, q| keys(p).cmp(&keys(q)).then(score(p).total_cmp(&score(q))))
}

/// Distance from the border of either element, m.
pub(crate) fn margin(place: &Place, a: &Element<'_>, b: &Element<'_>) -> f64 {
    let apart = place.on_a.distance(place.on_b);
    a.margin(place.on_a, -place.normal, apart).min(b.margin(place.on_b, place.normal, apart))
}

/// The common normal of two curves with the right sign. The curves may have passed through each other: outward
/// directions of the bodies decide the sign. Axes and tori have no outward direction; their normal points from B to A.
fn oriented(place: Place, a: &Element<'_>, b: &Element<'_>) -> Place {
    let curve = |e: &Element<'_>| matches!(e.locus, Locus::Line(..) | Locus::Circle(_));
    if !(curve(a) && curve(b)) {
        return place;
    }
    let outward = |element: &Element<'_>, at: DVec3| match (element.locus, element.border) {
        (Locus::Circle(circle), Border::Rim { radial, axial }) => {
            // The bisector of the disc's normal and the side's normal: all normals of the rim are within a right angle
            // of it, also for a flat cone, whose side normal points away from the disc.
            (at - circle.center) / circle.radius * axial + circle.axis * (1.0 - radial)
        }
        (Locus::Circle(circle), _) if element.ball == 0.0 => (at - circle.center) / circle.radius + circle.axis,
        _ => element.outward,
    };
    let toward_a = outward(b, place.on_b) - outward(a, place.on_a);
    if place.normal.dot(toward_a) < 0.0 { place.reversed() } else { place }
}
