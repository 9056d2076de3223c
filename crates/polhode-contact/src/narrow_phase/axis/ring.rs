//! The distance of a torus, called a ring here, from another body. It is the distance of its centre circle minus the
//! tube radius.
//!
//! A ring is not convex and may touch a body at several places: at every local minimum of the distance along its centre
//! circle. Outside a convex body this distance is continuously differentiable, so that each minimum is a common normal
//! of the centre circle and the closest element of the body (`places.rs`). All elements that are near enough are
//! searched, and a common normal is used if its element is the closest one there. So no minimum is missed, even one
//! beside a lower one. Exception: of several minima over the rim of one disc, some may have no name that distinguishes
//! them from the others (`branch_offset.rs`).
//!
//! Where the centre circle passes through the other body, the separation is that at its deepest point. This is only a
//! lower bound of the translation that would separate the ring. The distance then has kinks, where the closest element
//! changes. The signed distance is sampled to find them (`ring_samples.rs` states which ones may be missed), and a
//! golden-section search locates each. This is not needed when a plane perpendicular to the deciding normal separates
//! the centre circle from the body.

use crate::clearance::ONE_PLACE;
use crate::clearance::place_tolerance_of_sizes;
use crate::narrow_phase::axis::body::Body;
use crate::narrow_phase::axis::gap::{self, Gap};
use crate::narrow_phase::axis::ring_samples::{Sample, Wanted, each_minimum};
use crate::narrow_phase::common_normal::branch_offset::{is_distinguished, is_one_place};
use crate::narrow_phase::common_normal::chosen_place::chosen;
use crate::narrow_phase::common_normal::place::{Place, Places};
use crate::narrow_phase::common_normal::places::places;
use crate::narrow_phase::feature::branch::Branch;
use crate::narrow_phase::feature::closest_feature::{NearestFeature, nearest_feature};
use crate::narrow_phase::feature::element::{Element, Locus};
use crate::narrow_phase::feature::placed::Placed;
use crate::shape::circle::Circle;
use crate::shape::round::{circles, support};
use crate::shape::support::across;
use crate::{Shape, SurfaceFeature};
use glam::DVec3;
use polhode_spatial::Pose;

/// Steps of the golden-section search: each reduces the interval to 0.618 of it, and this many determine an angle to
/// the square root of epsilon, the limit of the method.
const GOLDEN_STEPS: usize = 44;

/// `(sqrt(5) - 1)/2`.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// A common normal and a sampled minimum are the same when they are nearer than this many times the distance to the
/// next sample.
const NEAR_SAMPLES: f64 = 1.5;

/// Largest difference between the separation at a common normal and the distance of the nearest element there, relative
/// to the ring's radius; the place tolerance if that is larger.
const CONSISTENT: f64 = 1e-10;

/// Number of parts of an edge for the test whether it is near enough.
const LINE_PARTS: f64 = 4.0;

/// The limits of the search for minima, and the lowest minimum so far.
#[derive(Debug, Clone, Copy)]
struct Limits {
    /// Largest distance of the centre circle at which minima are wanted, m.
    reach: f64,
    /// Upper bound of the least distance of the centre circle, with its rounding, m.
    least: f64,
    /// The normal at the lowest minimum so far.
    above: Option<DVec3>,
}

impl Limits {
    /// Minima with larger distances of the centre circle are not needed, m.
    const fn limit(&self) -> f64 {
        self.least.max(self.reach)
    }
}

/// A ring in the frame of another body.
pub(crate) struct Ring<'a> {
    circle: Circle,
    tube: f64,
    east: DVec3,
    north: DVec3,
    other: &'a Shape,
    tolerance: f64,
}

/// Calls `visit` with every minimum of the distance of a ring from another shape that is the least or at most `reach`
/// (m); normals in the world. Where the centre circle is inside the other body, some minima beside a lower one may be
/// missing. There are none for a half-space, and when neither shape is a ring.
pub(crate) fn each(a: Placed<'_>, b: Placed<'_>, reach: f64, mut visit: impl FnMut(Gap)) {
    match (a.shape, b.shape) {
        (Shape::Torus(_), _) => of_ring(a, b, reach, visit),
        (_, Shape::Torus(_)) => of_ring(b, a, reach, |gap| {
            visit(Gap { normal: -gap.normal, a: gap.b, b: gap.a, ..gap });
        }),
        _ => {}
    }
}

/// As [`each`], for the least one.
pub(crate) fn least(a: Placed<'_>, b: Placed<'_>) -> Option<Gap> {
    let mut least = None;
    each(a, b, f64::NEG_INFINITY, |gap| gap.take_if_less(&mut least));
    least
}

fn of_ring(
    Placed { shape, pose }: Placed<'_>,
    Placed { shape: other, pose: other_pose }: Placed<'_>,
    reach: f64,
    mut visit: impl FnMut(Gap),
) {
    let x = other_pose.relative(pose);
    if !x.is_finite() {
        return;
    }
    let Some(ring) = Ring::new(shape, &x, other) else { return };
    let mut report = |gap: Gap| visit(Gap { normal: other_pose.rotation.rotate(gap.normal), ..gap });
    match other {
        Shape::Points(cloud) => {
            for (index, &point) in cloud.points.iter().enumerate() {
                report(ring.to_point(point, 0.0, SurfaceFeature::Vertex(index as u32)));
            }
        }
        Shape::Sphere(sphere) => report(ring.to_point(sphere.center, sphere.radius, SurfaceFeature::Sphere)),
        Shape::HalfSpace(_) | Shape::TriangleMesh(_) | Shape::Compound(_) => {}
        _ => ring.each_minimum(&x, shape, reach, report),
    }
}

impl<'a> Ring<'a> {
    /// A torus at a pose in the frame of the other shape; none for other shapes.
    pub(crate) fn new(shape: &Shape, x: &Pose, other: &'a Shape) -> Option<Self> {
        let (Shape::Torus(torus), Some(own)) = (shape, circles(shape).first().copied()) else { return None };
        let circle = own.placed(x);
        let east = circle.axis.any_orthonormal_vector();
        let tolerance = place_tolerance_of_sizes(shape.size(), other.size(), x.translation);
        Some(Self { circle, tube: torus.minor, east, north: circle.axis.cross(east), other, tolerance })
    }

    /// The corners of a triangle that contains the arc of the centre circle between two angles, less than half a turn
    /// apart: its ends, and the intersection of the tangents there.
    pub(crate) fn corners(&self, from: f64, to: f64) -> [DVec3; 3] {
        let middle = self.place(0.5 * (from + to)) - self.circle.center;
        let tip = self.circle.center + middle / libm::cos(0.5 * (to - from));
        [self.place(from), tip, self.place(to)]
    }

    pub(crate) fn place(&self, angle: f64) -> DVec3 {
        let (sine, cosine) = libm::sincos(angle);
        self.circle.center + (self.east * cosine + self.north * sine) * self.circle.radius
    }

    /// The angle of the circle's point nearest to a point; an arbitrary angle for a point on the axis.
    pub(crate) fn angle_of(&self, point: DVec3) -> f64 {
        let arm = point - self.circle.center;
        libm::atan2(self.north.dot(arm), self.east.dot(arm))
    }

    /// The unit tangent at an angle.
    pub(crate) fn tangent(&self, angle: f64) -> DVec3 {
        let (sine, cosine) = libm::sincos(angle);
        self.north * cosine - self.east * sine
    }

    /// Centre of the centre circle, frame of the other body, m.
    pub(crate) const fn center(&self) -> DVec3 {
        self.circle.center
    }

    /// Radius of the centre circle, m.
    pub(crate) const fn radius(&self) -> f64 {
        self.circle.radius
    }

    /// The one contact with a ball.
    fn to_point(&self, point: DVec3, radius: f64, b: SurfaceFeature) -> Gap {
        let f = self.circle.nearest(point) - point;
        let distance = f.length();
        let normal = if distance > 0.0 { f / distance } else { self.circle.axis };
        let separation = distance - radius - self.tube;
        Gap { separation, normal, a: SurfaceFeature::Rim(0), b, tolerance: self.tolerance }
    }

    /// The element of the other body that is nearest to a point, both in the other body's frame.
    pub(crate) fn nearest(&self, p: DVec3) -> NearestFeature {
        match self.other {
            Shape::Convex(polyhedron) => nearest_feature(polyhedron, p, self.tolerance),
            Shape::Torus(torus) => {
                let ring = torus.ring();
                let f = p - ring.nearest(p);
                let distance = f.length();
                let normal = if distance > 0.0 { f / distance } else { ring.axis };
                NearestFeature { feature: SurfaceFeature::Rim(0), distance: distance - torus.minor, normal }
            }
            other => {
                let point = Body::at_point(other, p);
                let gap = gap::search(point, Body::whole(other, Pose::IDENTITY), f64::INFINITY);
                NearestFeature { feature: gap.b, distance: gap.separation, normal: gap.normal }
            }
        }
    }

    fn each_minimum(&self, x: &Pose, shape: &Shape, reach: f64, mut report: impl FnMut(Gap)) {
        if let Shape::Torus(_) = self.other {
            let mut found = false;
            let rims = (
                Element::of(shape, SurfaceFeature::Rim(0), x),
                Element::of(self.other, SurfaceFeature::Rim(0), &Pose::IDENTITY),
            );
            if let (Some(own), Some(other)) = rims {
                self.each_common_normal(&own, &other, SurfaceFeature::Rim(0), f64::INFINITY, |_, gap| {
                    found = true;
                    report(gap);
                });
            }
            // Coincident centre circles have no common normal, and all of their points are equally near.
            if !found {
                report(self.gap_at(0.0));
            }
            return;
        }
        let Some(rim) = Element::of(shape, SurfaceFeature::Rim(0), x) else { return };
        let least = self.nearest(self.place(0.0)).distance + self.tolerance;
        let wanted = Limits { reach: reach + self.tube, least, above: None };
        let wanted = self.each_of_elements(&rim, wanted, &mut report);
        // Some places over a rim have no name of their own (`branch_offset.rs`): their distance follows from the
        // samples.
        let all_named = circles(self.other).is_empty();
        if !(all_named && wanted.above.is_some_and(|normal| self.is_above(normal))) {
            self.each_kink(&rim, wanted, report);
        }
    }

    /// Reports the common normals with all elements of the other body that come near enough to the centre circle.
    fn each_of_elements(&self, rim: &Element<'_>, wanted: Limits, mut report: impl FnMut(Gap)) -> Limits {
        let (mut now, mut parallel) = (wanted, false);
        let body = Body::whole(self.other, Pose::IDENTITY);
        body.each_other(|feature| now.least = now.least.min(self.distance_bounds(feature).1));
        let mut visit = |feature: SurfaceFeature| {
            let asked = self.comes_within(feature, now.limit());
            let Some(element) = body.element(feature).filter(|_| asked) else { return };
            if let Locus::Plane(_, normal) = element.locus {
                parallel |= self.circle.lowest(normal).is_none();
            }
            let limit = now.limit();
            self.each_common_normal(rim, &element, feature, limit, |_, gap| {
                let distance = gap.separation + self.tube;
                if now.above.is_none() || distance + self.tolerance < now.least {
                    now.above = Some(gap.normal);
                }
                now.least = now.least.min(distance + self.tolerance);
                report(gap);
            });
        };
        body.each_plane(&mut visit);
        body.each_other(&mut visit);
        // When the ring is parallel to a face, all of its points are equally near, and the slope locates no minimum.
        if parallel { Limits { above: None, ..now } } else { now }
    }

    /// Whether an element may be the nearest one to some point of the centre circle, at a distance of at most `limit`
    /// (m).
    fn comes_within(&self, feature: SurfaceFeature, limit: f64) -> bool {
        self.may_be_nearest_along(feature) && self.distance_bounds(feature).0 <= limit
    }

    /// A lower bound of the distance of the centre circle from a vertex or an edge of a polyhedron, and an upper bound
    /// of its distance from the polyhedron, m; infinite bounds for other elements.
    fn distance_bounds(&self, feature: SurfaceFeature) -> (f64, f64) {
        let Shape::Convex(polyhedron) = self.other else { return (f64::NEG_INFINITY, f64::INFINITY) };
        let distance = |point: DVec3| {
            let from = point - self.circle.center;
            let height = self.circle.axis.dot(from);
            let beside = (from - self.circle.axis * height).length() - self.circle.radius;
            (beside * beside + height * height).sqrt()
        };
        let (nearest, half) = match feature {
            SurfaceFeature::Vertex(index) => (distance(polyhedron.vertices[index as usize]), 0.0),
            // The middles of the parts of the edge: every point of it is at most half a part from one of them.
            SurfaceFeature::Edge(index) => {
                let edge = &polyhedron.edges[index as usize];
                let (from, half) = (polyhedron.vertices[edge.vertices[0] as usize], 0.5 * edge.length / LINE_PARTS);
                let places = (0..LINE_PARTS as u32).map(|k| from + edge.direction * (half * f64::from(2 * k + 1)));
                (places.map(distance).fold(f64::INFINITY, f64::min), half)
            }
            _ => return (f64::NEG_INFINITY, f64::INFINITY),
        };
        (nearest - half - self.tolerance, nearest + self.tolerance)
    }

    /// Whether an edge of a polyhedron may be the nearest element to some point of the centre circle: such a point lies
    /// in the edge's Voronoi region, beyond the border of each of its two faces. True for other elements.
    fn may_be_nearest_along(&self, feature: SurfaceFeature) -> bool {
        let (Shape::Convex(polyhedron), SurfaceFeature::Edge(index)) = (self.other, feature) else { return true };
        let edge = &polyhedron.edges[index as usize];
        let [first, second] = edge.faces.map(|face| polyhedron.faces[face as usize].normal);
        let from = self.circle.center - polyhedron.vertices[edge.vertices[0] as usize];
        let beyond = |own: DVec3, other: DVec3| {
            let outward = across(other, own);
            outward.dot(from) + self.circle.radius * across(outward, self.circle.axis).length() >= -self.tolerance
        };
        beyond(first, second) && beyond(second, first)
    }

    /// A lower bound of the distance of a point: for a polyhedron its largest height above a face.
    fn above_faces(&self, place: DVec3) -> f64 {
        let Shape::Convex(polyhedron) = self.other else { return f64::NEG_INFINITY };
        polyhedron.outside(place)
    }

    /// Whether a plane with this unit normal separates the whole centre circle from the other body.
    fn is_above(&self, normal: DVec3) -> bool {
        -self.circle.support(-normal) > support(self.other, normal) + self.tolerance
    }

    /// Reports the minima at which the nearest element changes, so that the distance has a kink.
    fn each_kink(&self, rim: &Element<'_>, wanted: Limits, mut report: impl FnMut(Gap)) {
        let sample = |angle: f64| {
            let place = self.place(angle);
            let NearestFeature { distance, feature, normal } = self.nearest(place);
            Sample { angle, arm: place - self.circle.center, distance, normal, feature }
        };
        let mut best = wanted.least;
        let limits = Wanted { reach: wanted.reach, least: wanted.least, tolerance: self.tolerance };
        each_minimum(&self.circle, sample, limits, |lowest: &Sample, width: f64, least: f64| {
            best = best.min(least);
            // The distance changes by at most the displacement of the point.
            if lowest.distance - self.circle.radius * width > best.max(wanted.reach) {
                return;
            }
            if let Some(kink) = self.kink_near(rim, (lowest.angle, width), wanted.limit()) {
                best = best.min(kink.separation + self.tube);
                report(kink);
            }
        });
    }

    /// The minimum at a sampled angle, no farther from it than the next samples, unless it is a common normal that is
    /// known within a limit (m).
    fn kink_near(&self, rim: &Element<'_>, (angle, step): (f64, f64), limit: f64) -> Option<Gap> {
        let sampled = self.place(angle);
        let close = (NEAR_SAMPLES * step).max(ONE_PLACE) * self.circle.radius;
        let is_common_normal = |feature: SurfaceFeature| {
            let mut found = false;
            let element = Element::of(self.other, feature, &Pose::IDENTITY);
            if let Some(element) = element.filter(|_| self.comes_within(feature, limit)) {
                self.each_common_normal(rim, &element, feature, limit, |place, _| {
                    found |= place.on_a.distance(sampled) <= close;
                });
            }
            found
        };
        // Both the element nearest to the sample and the one nearest to the minimum are tried.
        if is_common_normal(self.nearest(sampled).feature) {
            return None;
        }
        let lowest = self.golden(angle, step);
        let known = is_common_normal(self.nearest(self.place(lowest)).feature);
        (!known).then(|| self.gap_at(lowest))
    }

    /// The contact at an angle at which there is no common normal.
    fn gap_at(&self, angle: f64) -> Gap {
        let from = self.nearest(self.place(angle));
        let separation = from.distance - self.tube;
        Gap { separation, normal: from.normal, a: SurfaceFeature::Rim(0), b: from.feature, tolerance: self.tolerance }
    }

    /// Calls `visit` with the common normals of the centre circle and an element of the other body that are no longer
    /// than `limit` (m) and at which that element is the nearest, each with a name that distinguishes it from the
    /// others of the two.
    fn each_common_normal(
        &self,
        rim: &Element<'_>,
        element: &Element<'_>,
        feature: SurfaceFeature,
        limit: f64,
        mut visit: impl FnMut(&Place, Gap),
    ) {
        use Branch::{Entry, Exit, Nearest};
        let all = places(rim, element);
        // The element must be the nearest one at the place, on the side of the normal.
        let tolerance = self.tolerance.max(CONSISTENT * self.circle.radius);
        let possible = |place: &Place| {
            let claimed = place.separation(rim, element) + self.tube;
            claimed <= limit && self.above_faces(place.on_a) <= claimed + tolerance
        };
        if !all.iter().any(possible) {
            return;
        }
        let consistent = |place: &Place| {
            let there = self.nearest(place.on_a).distance - self.tube;
            (place.separation(rim, element) - there).abs() <= tolerance
        };
        let round = matches!(feature, SurfaceFeature::Rim(_));
        let names = [[Exit, Nearest], [Entry, Nearest], [Exit, Entry], [Entry, Exit], [Nearest; 2]];
        let mut known = Places::none();
        for [own, other] in names.into_iter().filter(|&[_, other]| round || other == Nearest) {
            let (rim, element) = (Element { branch: own, ..*rim }, Element { branch: other, ..*element });
            let distinguished =
                chosen(&all, &rim, &element).filter(|place| is_distinguished(place, &all, &rim, &element));
            let Some(place) = distinguished else { continue };
            if place.separation(&rim, &element) + self.tube > limit
                || known.iter().any(|known| is_one_place(known, &place, self.circle.radius))
                || !consistent(&place)
            {
                continue;
            }
            known.push(place);
            let gap = Gap {
                separation: place.separation(&rim, &element),
                normal: place.normal,
                a: own.of_rim(0),
                b: if let SurfaceFeature::Rim(index) = feature { other.of_rim(index) } else { feature },
                tolerance: self.tolerance,
            };
            visit(&place, gap);
        }
    }

    /// Golden-section search for a minimum of the distance within `step` of an angle, with a distance no larger than
    /// there.
    fn golden(&self, angle: f64, step: f64) -> f64 {
        let value = |angle: f64| self.nearest(self.place(angle)).distance;
        let [mut left, mut lowest, mut right] = [angle - step, angle, angle + step];
        let mut least = value(lowest);
        for _ in 0..GOLDEN_STEPS {
            let farther = if right - lowest > lowest - left { right } else { left };
            let new = lowest + (1.0 - GOLDEN) * (farther - lowest);
            let found = value(new);
            let (kept, bound) = if found < least { (new, lowest) } else { (lowest, new) };
            if bound < kept {
                left = bound;
            } else {
                right = bound;
            }
            (lowest, least) = (kept, least.min(found));
        }
        lowest
    }
}
