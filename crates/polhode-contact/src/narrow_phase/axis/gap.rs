//! The axis of largest separation of two convex bodies, at least one of them round.
//!
//! The separation of the bodies is the maximum over all unit vectors `n` from B to A of `s(n) = -h_A(-n) - h_B(n)` (`h`
//! the support function): the distance when they are apart, minus the depth of penetration when they overlap. `s` is
//! largest along the normal of a face or disc, or at a common normal of two other elements (`places.rs`), since it is
//! smooth elsewhere. All of these are candidates. The value `s` along any direction is a lower bound of the separation,
//! so that an unnecessary candidate does no harm. When two candidates are equal, a face or disc is preferred.

use crate::clearance::{RESOLUTION_ULPS, place_tolerance, place_tolerance_of_sizes};
use crate::narrow_phase::axis::body::{Body, framed};
use crate::narrow_phase::axis::half_space::height_above;
use crate::narrow_phase::axis::sieve::{Pass, Sieve, is_worse};
use crate::narrow_phase::common_normal::place::Place;
use crate::narrow_phase::common_normal::places::places;
use crate::narrow_phase::feature::element::{Element, Locus};
use crate::narrow_phase::feature::placed::Placed;
use crate::{Shape, SurfaceFeature};
use glam::DVec3;

/// The best axis.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Gap {
    /// Signed separation, m.
    pub(crate) separation: f64,
    /// Unit vector from B to A in the frame of the search.
    pub(crate) normal: DVec3,
    /// The elements at the two ends of the gap.
    pub(crate) a: SurfaceFeature,
    pub(crate) b: SurfaceFeature,
    /// Distance up to which features coincide, m.
    pub(crate) tolerance: f64,
}

impl Gap {
    /// Replaces `least` if this separation is less; in a tie the earlier one stays.
    pub(crate) fn take_if_less(self, least: &mut Option<Self>) {
        if least.is_none_or(|least| self.separation < least.separation) {
            *least = Some(self);
        }
    }
}

/// The best axis. The search ends early, with the best face or disc so far, when its separation exceeds `stop` (m).
pub(crate) fn search(a: Body<'_>, b: Body<'_>, stop: f64) -> Gap {
    let between = a.pose.translation - b.pose.translation;
    let tolerance = place_tolerance_of_sizes(a.size(), b.size(), between);
    let start = SurfaceFeature::Vertex(0);
    let mut flat = Gap { separation: f64::NEG_INFINITY, normal: DVec3::Z, a: start, b: start, tolerance };
    a.each_plane(|feature| {
        let Some((separation, outward)) = above_plane(&a, feature, &b) else { return };
        if separation > flat.separation {
            flat = Gap { separation, normal: -outward, a: feature, b: start, tolerance };
        }
    });
    // Of two planes that separate equally well, A's is kept. The other one would lead to the same region of contact, so
    // that the contacts do not depend on which body is called A.
    b.each_plane(|feature| {
        let Some((separation, normal)) = above_plane(&b, feature, &a) else { return };
        if separation > flat.separation {
            flat = Gap { separation, normal, a: start, b: feature, tolerance };
        }
    });
    if let SurfaceFeature::Face(_) = flat.a {
        flat.b = b.farthest(flat.normal);
    } else if let SurfaceFeature::Face(_) = flat.b {
        flat.a = a.farthest(-flat.normal);
    }
    if flat.separation > stop || is_certain(&a, &b, &flat) {
        return flat;
    }
    best_of_elements(&a, &b, flat)
}

/// Whether a separating face is certainly the best axis: the other body's nearest point projects onto the face, so that
/// the separation is the distance.
fn is_certain(a: &Body<'_>, b: &Body<'_>, flat: &Gap) -> bool {
    let over = |owner: &Body<'_>, face: SurfaceFeature, outward: DVec3, lowest: DVec3| {
        owner.element(face).is_some_and(|element| element.margin(lowest, outward, 0.0) >= 0.0)
    };
    flat.separation > flat.tolerance
        && match (flat.a, flat.b) {
            (SurfaceFeature::Face(_), _) => over(a, flat.a, -flat.normal, b.support_point(flat.normal)),
            (_, SurfaceFeature::Face(_)) => over(b, flat.b, flat.normal, a.support_point(-flat.normal)),
            _ => false,
        }
}

/// Separation of a body from a face or disc of another along its normal, and that outward normal.
fn above_plane(owner: &Body<'_>, face: SurfaceFeature, other: &Body<'_>) -> Option<(f64, DVec3)> {
    let Locus::Plane(through, normal) = owner.element(face)?.locus else { return None };
    Some((-other.support(-normal) - normal.dot(through), normal))
}

/// The best common normal of two elements that are not planes, when it separates better than the planes do. Of equal
/// ones a pair is preferred whose elements are at the closest points of the bodies: for a sphere above a row of corners
/// at one height, the corner below it.
fn best_of_elements(a: &Body<'_>, b: &Body<'_>, flat: Gap) -> Gap {
    let between = a.pose.translation - b.pose.translation;
    let rounding = RESOLUTION_ULPS * f64::EPSILON * (a.size() + b.size() + between.length());
    let best = Gap { separation: flat.separation + flat.tolerance, ..flat };
    let mut search = Search { a, b, rounding, best, found: false, supporting: true, certain: false };
    let sieve = Sieve::new(a, b, flat.separation, flat.tolerance);
    for pass in [Pass::Near, Pass::All] {
        b.each_other(|feature_b| {
            let skipped = search.certain || !sieve.keeps_of_b(b, feature_b, pass);
            if skipped || is_worse(b, feature_b, a, search.best.separation - rounding) {
                return;
            }
            let Some(element_b) = b.element(feature_b) else { return };
            a.each_other(|feature_a| {
                let skipped = search.certain || !sieve.keeps_of_a(a, feature_a, pass);
                if skipped || is_worse(a, feature_a, b, search.best.separation - rounding) {
                    return;
                }
                let Some(element_a) = a.element(feature_a) else { return };
                search.offer((feature_a, &element_a), (feature_b, &element_b));
            });
        });
        if search.certain || sieve.is_empty() {
            break;
        }
    }
    if search.found { search.best } else { flat }
}

/// The best pair so far.
struct Search<'s, 'a> {
    a: &'s Body<'a>,
    b: &'s Body<'a>,
    /// Rounding of a separation, m.
    rounding: f64,
    best: Gap,
    found: bool,
    /// Whether the best pair's elements contain the support points of the bodies along its normal.
    supporting: bool,
    /// Whether no axis can be better: the distance of two points of the bodies equals the separation along the axis.
    certain: bool,
}

impl Search<'_, '_> {
    fn offer(
        &mut self,
        (feature_a, element_a): (SurfaceFeature, &Element<'_>),
        (feature_b, element_b): (SurfaceFeature, &Element<'_>),
    ) {
        for place in places(element_a, element_b).iter() {
            for place in orientations(*place, element_a, element_b).into_iter().flatten() {
                let claimed = place.separation(element_a, element_b);
                // The elements are subsets of the bodies, so that the separation of the bodies is at most theirs.
                let least = if self.supporting { self.best.separation } else { self.best.separation - self.rounding };
                if claimed.is_nan() || claimed <= least {
                    continue;
                }
                let normal = place.normal;
                let bodies = -self.a.support(-normal) - self.b.support(normal);
                let supports = bodies >= claimed - self.rounding;
                let separation = if supports { claimed } else { bodies };
                let better = match (supports, self.supporting) {
                    (true, false) => separation > self.best.separation - self.rounding,
                    (false, true) => separation > self.best.separation + self.rounding,
                    _ => separation > self.best.separation,
                };
                if better {
                    (self.found, self.supporting) = (true, supports);
                    self.best = Gap { separation, normal, a: feature_a, b: feature_b, ..self.best };
                    let apart = place.on_a.distance(place.on_b);
                    let within = element_a.margin(place.on_a, -normal, apart) >= 0.0
                        && element_b.margin(place.on_b, normal, apart) >= 0.0;
                    self.certain = supports && within && separation > self.best.tolerance;
                }
            }
        }
    }
}

/// A common normal; for two curves also the opposite one, because the curves may have passed through each other.
fn orientations(place: Place, a: &Element<'_>, b: &Element<'_>) -> [Option<Place>; 2] {
    let curve = |locus| matches!(locus, Locus::Line(..) | Locus::Circle(_));
    let curves = curve(a.locus) && curve(b.locus);
    [Some(place), curves.then(|| place.reversed())]
}

/// The best axis of a pair, at least one of them round, with the normal in the world; for a cloud that of its nearest
/// point. None for pairs of other kinds.
pub(crate) fn between(a: Placed<'_>, b: Placed<'_>, stop: f64) -> Option<Gap> {
    let mut least = None;
    each(a, b, stop, |gap| gap.take_if_less(&mut least));
    least
}

/// Calls `visit` with the best axis of a pair, or of each point of a cloud with the other body.
pub(crate) fn each(placed_a: Placed<'_>, placed_b: Placed<'_>, stop: f64, mut visit: impl FnMut(Gap)) {
    let convex = |shape: &Shape| {
        crate::shape::round::is_round(shape) || matches!(shape, Shape::Convex(_) | Shape::Sphere(_) | Shape::Points(_))
    };
    if !(convex(placed_a.shape) && convex(placed_b.shape)) {
        return;
    }
    let (a, b, frame) = framed(placed_a, placed_b);
    let mut report = |a: Body<'_>, b: Body<'_>| {
        let gap = search(a, b, stop);
        visit(Gap { normal: frame.rotation.rotate(gap.normal), ..gap });
    };
    match (a.shape, b.shape) {
        (Shape::Points(cloud), _) => {
            (0..).zip(&cloud.points).for_each(|(k, &p)| report(Body { point: Some((k, p)), ..a }, b));
        }
        (_, Shape::Points(cloud)) => {
            (0..).zip(&cloud.points).for_each(|(k, &p)| report(a, Body { point: Some((k, p)), ..b }));
        }
        _ => report(a, b),
    }
}

/// The one axis of a half-space and a round shape.
pub(crate) fn above_half_space(a: Placed<'_>, b: Placed<'_>) -> Gap {
    let on_a = a.shape.is_half_space();
    let (plane, Placed { shape, pose }) = if on_a { (a, b) } else { (b, a) };
    let (up, separation) = match plane.shape {
        Shape::HalfSpace(half_space) => {
            (plane.pose.rotation.rotate(half_space.normal), height_above(half_space, plane.pose, shape, pose))
        }
        _ => (DVec3::Z, f64::INFINITY),
    };
    let between = pose.translation - plane.pose.translation;
    let lowest = Body::whole(shape, *pose).farthest(-up);
    let face = SurfaceFeature::Face(0);
    Gap {
        separation,
        normal: if on_a { -up } else { up },
        a: if on_a { face } else { lowest },
        b: if on_a { lowest } else { face },
        tolerance: place_tolerance(shape.size(), shape.size(), between),
    }
}
