//! Tori: the distance of a circle from another body, less the radius of the tube.
//!
//! A ring is not convex and may touch a body at several places. Of another ring those are the common normals of the two
//! circles. Of other bodies the signed distance is sampled along the middle line (`ring_samples.rs`, which says what samples
//! may miss) and every minimum is polished: as the common normals of the circle and the element that is nearest there
//! (`pairs.rs`), or, where the nearest element changes (a corner between two of them), by a golden-section search.
//!
//! Where the middle line itself runs through the other body the separation is that of its deepest place: no more than a
//! lower bound of how far the ring would have to be moved.

use super::branch::{Branch, is_one_place, is_told};
use super::element::{Element, Locus};
use super::gap::{self, Body, Gap};
use super::pairs::{Place, Places, nearest_on, places};
use super::ring_samples::{Dip, Sample, Wanted, each_minimum};
use super::stationary::chosen;
use crate::clearance::place_tolerance;
use crate::narrow_phase::nearest_feature;
use crate::shape::round::{Circle, circles};
use crate::{Shape, SurfaceFeature};
use glam::DVec3;
use polhode_spatial::Pose;

/// Steps of the golden-section search: each keeps 0.618 of the interval, and this many bring an angle to its square root
/// of rounding.
const GOLDEN_STEPS: usize = 44;

/// `(sqrt(5) - 1)/2`.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// A place found on the circle and one sampled are the same minimum within this many times the way to the next sample.
const NEAR_SAMPLES: f64 = 1.5;

/// Least angle, rad, within which places are the same minimum: the lowest of samples is no nearer to it than the square root
/// of rounding.
const LOCATED: f64 = 1e-6;

/// The distance at a polished place is that of the nearest element within this, relative to the ring's radius, or within
/// the rounding of places.
const CONSISTENT: f64 = 1e-10;

/// Distance of a point from a body: the nearest element, and the unit vector from there to the point.
pub(crate) struct FromPoint {
    distance: f64,
    feature: SurfaceFeature,
    pub(crate) normal: DVec3,
}

impl FromPoint {
    /// The direction in which the nearest element of the body is straight, if it is.
    pub(crate) fn along(&self, body: &Shape) -> Option<DVec3> {
        match Element::of(body, self.feature, &Pose::IDENTITY)?.locus {
            Locus::Line(_, along) => Some(along),
            Locus::Cone(side) => Some(side.axis - self.normal * self.normal.dot(side.axis)),
            _ => None,
        }
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

/// Calls `visit` with every minimum of the distance of a ring from another shape that is the least or at most `reach` (m);
/// normals in the world. Of minima beside a lower one, on another element of a convex body, some may be missing. Nothing for a
/// half-space, and when neither shape is a ring.
pub(crate) fn each(
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
    reach: f64,
    mut visit: impl FnMut(Gap),
) {
    match (shape_a, shape_b) {
        (Shape::Torus(_), other) => of_ring((shape_a, pose_a), (other, pose_b), reach, visit),
        (other, Shape::Torus(_)) => of_ring((shape_b, pose_b), (other, pose_a), reach, |gap| {
            visit(Gap { normal: -gap.normal, a: gap.b, b: gap.a, ..gap });
        }),
        _ => {}
    }
}

/// As [`each`], for the least one.
pub(crate) fn least(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose) -> Option<Gap> {
    let mut least: Option<Gap> = None;
    each(shape_a, pose_a, shape_b, pose_b, f64::NEG_INFINITY, |gap| {
        if least.is_none_or(|least| gap.separation < least.separation) {
            least = Some(gap);
        }
    });
    least
}

fn of_ring(
    (shape, pose): (&Shape, &Pose),
    (other, other_pose): (&Shape, &Pose),
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
    /// A torus at a pose in the frame of the other shape; nothing for other shapes.
    pub(crate) fn new(shape: &Shape, x: &Pose, other: &'a Shape) -> Option<Self> {
        let (Shape::Torus(torus), Some(own)) = (shape, circles(shape).first().copied()) else { return None };
        let circle = own.placed(x);
        let east = circle.axis.any_orthonormal_vector();
        let sizes = if other.size() > 0.0 { shape.size().min(other.size()) } else { shape.size() };
        let tolerance = place_tolerance(sizes, shape.size().max(other.size()), x.translation);
        Some(Self { circle, tube: torus.minor, east, north: circle.axis.cross(east), other, tolerance })
    }

    /// The corners of a triangle that holds the arc of the middle line between two angles, less than half a turn apart: its
    /// ends, and where the tangents there meet.
    pub(crate) fn corners(&self, from: f64, to: f64) -> [DVec3; 3] {
        let middle = self.place(0.5 * (from + to)) - self.circle.center;
        let tip = self.circle.center + middle / libm::cos(0.5 * (to - from));
        [self.place(from), tip, self.place(to)]
    }

    pub(crate) fn place(&self, angle: f64) -> DVec3 {
        let (sine, cosine) = libm::sincos(angle);
        self.circle.center + (self.east * cosine + self.north * sine) * self.circle.radius
    }

    /// The angle of the place that is nearest to a point; some angle on the axis.
    pub(crate) fn angle_of(&self, point: DVec3) -> f64 {
        let arm = point - self.circle.center;
        libm::atan2(self.north.dot(arm), self.east.dot(arm))
    }

    /// The unit tangent at an angle.
    pub(crate) fn tangent(&self, angle: f64) -> DVec3 {
        let (sine, cosine) = libm::sincos(angle);
        self.north * cosine - self.east * sine
    }

    /// Of the middle line.
    pub(crate) const fn center(&self) -> DVec3 {
        self.circle.center
    }

    /// Of the middle line, m.
    pub(crate) const fn radius(&self) -> f64 {
        self.circle.radius
    }

    /// The one contact with a ball.
    fn to_point(&self, point: DVec3, radius: f64, b: SurfaceFeature) -> Gap {
        let f = nearest_on(&self.circle, point) - point;
        let distance = f.length();
        let normal = if distance > 0.0 { f / distance } else { self.circle.axis };
        let separation = distance - radius - self.tube;
        Gap { separation, normal, a: SurfaceFeature::Rim(0), b, tolerance: self.tolerance }
    }

    pub(crate) fn nearest(&self, p: DVec3) -> FromPoint {
        match self.other {
            Shape::Convex(polyhedron) => {
                let nearest = nearest_feature(polyhedron, p, self.tolerance);
                FromPoint { distance: nearest.distance, feature: nearest.feature, normal: nearest.direction }
            }
            Shape::Torus(torus) => {
                let ring = Circle { center: torus.center, axis: torus.axis, radius: torus.major };
                let f = p - nearest_on(&ring, p);
                let distance = f.length();
                let normal = if distance > 0.0 { f / distance } else { ring.axis };
                FromPoint { distance: distance - torus.minor, feature: SurfaceFeature::Rim(0), normal }
            }
            other => {
                let point = Body::at_point(other, p);
                let gap = gap::search(point, Body::whole(other, Pose::IDENTITY), f64::INFINITY);
                FromPoint { distance: gap.separation, feature: gap.b, normal: gap.normal }
            }
        }
    }

    fn each_minimum(&self, x: &Pose, shape: &Shape, reach: f64, mut report: impl FnMut(Gap)) {
        if let Shape::Torus(_) = self.other {
            let mut found = false;
            self.each_common_normal(x, shape, SurfaceFeature::Rim(0), |_, gap| {
                found = true;
                report(gap);
            });
            // Where the middle lines are one they have no common normal, and all places are as near.
            if !found {
                report(self.corner(0.0));
            }
            return;
        }
        let sample = |angle: f64| {
            let place = self.place(angle);
            let FromPoint { distance, feature, normal } = self.nearest(place);
            Sample { angle, arm: place - self.circle.center, distance, normal, feature }
        };
        let wanted = Wanted { reach: reach + self.tube, tolerance: self.tolerance };
        let mut best = f64::INFINITY;
        let mut seen = None;
        each_minimum(&self.circle, sample, wanted, |dip, lowest: &Sample, width: f64, least: f64| {
            best = best.min(least);
            // The distance changes no faster than the place moves.
            if lowest.distance - self.circle.radius * width <= best.max(wanted.reach) {
                let mut visit = |gap: Gap| {
                    best = best.min(gap.separation + self.tube);
                    report(gap);
                };
                match dip {
                    Dip::Sampled => self.polished(x, shape, (lowest.angle, width), visit),
                    Dip::Hidden if seen == Some(lowest.feature) => {}
                    Dip::Hidden => self.each_common_normal(x, shape, lowest.feature, |_, gap| visit(gap)),
                }
                seen = Some(lowest.feature);
            }
        });
    }

    /// Reports the minimum at a sampled angle, no farther from it than the next samples, and others of the same element.
    fn polished(&self, x: &Pose, shape: &Shape, (angle, step): (f64, f64), mut report: impl FnMut(Gap)) {
        let sampled = self.place(angle);
        let close = (NEAR_SAMPLES * step).max(LOCATED) * self.circle.radius;
        let mut found = false;
        let mut visit = |feature: SurfaceFeature| {
            self.each_common_normal(x, shape, feature, |place, gap| {
                found |= place.on_a.distance(sampled) <= close;
                report(gap);
            });
            found
        };
        // First with the element that is nearest at the sample, then, further down, at the minimum.
        if visit(self.nearest(sampled).feature) {
            return;
        }
        let lowest = self.golden(angle, step);
        if !visit(self.nearest(self.place(lowest)).feature) {
            report(self.corner(lowest));
        }
    }

    /// The contact at an angle that is no common normal.
    fn corner(&self, angle: f64) -> Gap {
        let from = self.nearest(self.place(angle));
        let separation = from.distance - self.tube;
        Gap { separation, normal: from.normal, a: SurfaceFeature::Rim(0), b: from.feature, tolerance: self.tolerance }
    }

    /// Calls `visit` with the common normals of the middle line and an element of the other body where that is the nearest,
    /// each named so that it is told from others of the two.
    fn each_common_normal(&self, x: &Pose, shape: &Shape, feature: SurfaceFeature, mut visit: impl FnMut(&Place, Gap)) {
        use Branch::{Entry, Exit, Nearest};
        let elements =
            (Element::of(shape, SurfaceFeature::Rim(0), x), Element::of(self.other, feature, &Pose::IDENTITY));
        let (Some(rim), Some(element)) = elements else { return };
        let all = places(&rim, &element);
        // The element is the nearest at its place, and on the side that the place says.
        let consistent = |place: &Place| {
            let there = self.nearest(place.on_a).distance - self.tube;
            (place.separation(&rim, &element) - there).abs() <= self.tolerance.max(CONSISTENT * self.circle.radius)
        };
        let round = matches!(feature, SurfaceFeature::Rim(_));
        let names = [[Exit, Nearest], [Entry, Nearest], [Exit, Entry], [Entry, Exit], [Nearest; 2]];
        let mut known = Places::none();
        for [own, other] in names.into_iter().filter(|&[_, other]| round || other == Nearest) {
            let (rim, element) = (Element { branch: own, ..rim }, Element { branch: other, ..element });
            let told = chosen(&all, &rim, &element).filter(|place| is_told(place, &all, &rim, &element));
            let Some(place) = told else { continue };
            if known.iter().any(|known| is_one_place(known, &place, self.circle.radius)) || !consistent(&place) {
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

    /// Golden-section search for a least distance no farther than `step` from an angle, and no higher than there.
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
