//! Tori: the distance of a circle from another body, less the radius of the tube.
//!
//! A ring is not convex and may touch a body at several places. Along its middle line the signed distance of the other
//! body is sampled; every minimum is polished: as the common normal of the circle and the element that is nearest there
//! (`pairs.rs`), or, where the nearest element changes (a corner between two of them), by a golden-section search. A minimum
//! is missed only when two lie within a sample of each other, nearer than an eighth of a radian.
//!
//! Where the middle line itself runs through the other body the separation is that of its deepest place: no more than a
//! lower bound of how far the ring would have to be moved.

use super::element::{Branch, Element};
use super::gap::{self, Body, Gap};
use super::pairs::nearest_on;
use super::stationary::chosen;
use crate::clearance::place_tolerance;
use crate::narrow_phase::nearest_feature;
use crate::shape::round::{Circle, circles};
use crate::{Shape, SurfaceFeature};
use glam::DVec3;
use polhode_spatial::Pose;
use std::f64::consts::TAU;

/// Places of the middle line at which the distance is sampled.
const SAMPLES: usize = 48;

/// Steps of the golden-section search: each keeps 0.618 of the interval, 40 bring an angle to its square root of rounding.
const GOLDEN_STEPS: usize = 40;

/// `(sqrt(5) - 1)/2`.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// A place found on the circle and one sampled are the same minimum within this many samples.
const NEAR_SAMPLES: f64 = 1.5;

/// The distance at a polished place is that of the nearest element within this, relative to the ring's radius.
const CONSISTENT: f64 = 1e-10;

/// Distance of a point from a body: the nearest element, and the unit vector from there to the point.
struct FromPoint {
    distance: f64,
    feature: SurfaceFeature,
    normal: DVec3,
}

/// A ring in the frame of another body.
struct Ring<'a> {
    circle: Circle,
    tube: f64,
    east: DVec3,
    north: DVec3,
    other: &'a Shape,
    tolerance: f64,
}

/// Calls `visit` with every minimum of the distance of a ring from another shape that is the least or at most `reach` (m);
/// normals in the world. Nothing for a half-space, and when neither shape is a ring.
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
    let (Shape::Torus(torus), Some(own)) = (shape, circles(shape).first().copied()) else { return };
    let x = other_pose.relative(pose);
    let circle = own.placed(&x);
    let east = circle.axis.any_orthonormal_vector();
    let sizes = if other.size() > 0.0 { shape.size().min(other.size()) } else { shape.size() };
    let ring = Ring {
        circle,
        tube: torus.minor,
        east,
        north: circle.axis.cross(east),
        other,
        tolerance: place_tolerance(sizes, shape.size().max(other.size()), x.translation),
    };
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

impl Ring<'_> {
    fn place(&self, angle: f64) -> DVec3 {
        let (sine, cosine) = libm::sincos(angle);
        self.circle.center + (self.east * cosine + self.north * sine) * self.circle.radius
    }

    /// The one contact with a ball.
    fn to_point(&self, point: DVec3, radius: f64, b: SurfaceFeature) -> Gap {
        let f = nearest_on(&self.circle, point) - point;
        let distance = f.length();
        let normal = if distance > 0.0 { f / distance } else { self.circle.axis };
        let separation = distance - radius - self.tube;
        Gap { separation, normal, a: SurfaceFeature::Rim(0), b, tolerance: self.tolerance }
    }

    fn distance(&self, p: DVec3) -> FromPoint {
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
        let step = TAU / SAMPLES as f64;
        let samples: [f64; SAMPLES] = std::array::from_fn(|k| self.distance(self.place(step * k as f64)).distance);
        // The distance changes no faster than the place moves.
        let spread = self.circle.radius * step;
        let mut best = samples.iter().copied().fold(f64::INFINITY, f64::min);
        for k in 0..SAMPLES {
            let (before, after) = (samples[(k + SAMPLES - 1) % SAMPLES], samples[(k + 1) % SAMPLES]);
            let lowest = samples[k] <= before && samples[k] < after;
            // All samples equal: the ring lies flat on a face.
            let level = k == 0 && samples.iter().all(|s| (s - samples[0]).abs() <= self.tolerance);
            if !(lowest || level) || samples[k] - spread > best.max(reach + self.tube) {
                continue;
            }
            let gap = self.polished(x, shape, step * k as f64, step);
            best = best.min(gap.separation + self.tube);
            report(gap);
        }
    }

    /// The minimum near a sampled angle.
    fn polished(&self, x: &Pose, shape: &Shape, angle: f64, step: f64) -> Gap {
        let sampled = self.place(angle);
        let mut from = self.distance(sampled);
        let ring = |branch: Branch| {
            let feature = match branch {
                Branch::Nearest => SurfaceFeature::Rim(0),
                Branch::Exit => SurfaceFeature::RimExit(0),
                Branch::Entry => SurfaceFeature::RimEntry(0),
            };
            Element::of(shape, feature, x).map(|element| (feature, element))
        };
        let close = NEAR_SAMPLES * step * self.circle.radius;
        let gap = |separation: f64, normal: DVec3, a: SurfaceFeature, b: SurfaceFeature| Gap {
            separation,
            normal,
            a,
            b,
            tolerance: self.tolerance,
        };
        // First as a common normal with the element that is nearest at the sample, then, further down, at the minimum.
        for _ in 0..2 {
            let element = Element::of(self.other, from.feature, &Pose::IDENTITY);
            for branch in [Branch::Nearest, Branch::Exit, Branch::Entry] {
                let (Some(element), Some((feature, rim))) = (element, ring(branch)) else { continue };
                let Some(place) = chosen(&rim, &element) else { continue };
                let separation = place.separation(&rim, &element);
                let there = self.distance(place.on_a).distance - self.tube;
                if place.on_a.distance(sampled) <= close
                    && (separation - there).abs() <= CONSISTENT * self.circle.radius
                {
                    return gap(separation, place.normal, feature, from.feature);
                }
            }
            from = self.distance(self.place(self.golden(angle - step, angle + step)));
        }
        gap(from.distance - self.tube, from.normal, SurfaceFeature::Rim(0), from.feature)
    }

    /// Golden-section search for the least distance between two angles.
    fn golden(&self, left: f64, right: f64) -> f64 {
        let value = |angle: f64| self.distance(self.place(angle)).distance;
        let (mut left, mut right) = (left, right);
        let (mut low, mut high) = (right - GOLDEN * (right - left), left + GOLDEN * (right - left));
        let (mut value_low, mut value_high) = (value(low), value(high));
        for _ in 0..GOLDEN_STEPS {
            if value_low <= value_high {
                right = high;
                (high, value_high) = (low, value_low);
                low = right - GOLDEN * (right - left);
                value_low = value(low);
            } else {
                left = low;
                (low, value_low) = (high, value_high);
                high = left + GOLDEN * (right - left);
                value_high = value(high);
            }
        }
        0.5 * (left + right)
    }
}
