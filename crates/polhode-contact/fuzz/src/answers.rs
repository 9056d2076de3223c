//! The second fuzz target: results of the crate are consistent. Distance, separation and manifold of a pair agree, also
//! with A and B swapped; rays end on surfaces and pass through none; no time of impact is late.

use crate::screw::Screw;
use crate::{LARGE, Numbers, ROUNDING};
use polhode_contact::clearance::joint_size;
use polhode_contact::{
    ContactFeature, ImpactSearch, Manifold, Ray, Shape, SurfaceFeature, closest_point, distance, evaluate, find_impact,
    manifold, ray_cast, separation,
};
use polhode_spatial::{DVec3, Motion, Pose, UnitVector, Velocity};

/// A pair at its poses, and the length up to which its results may differ, m.
struct Pair {
    shapes: [Shape; 2],
    poses: [Pose; 2],
    tolerance: f64,
}

/// Number of samples along a ray or a motion.
const SAMPLES: u32 = 24;

/// Reads bytes as two shapes, poses, a ray and velocities, and compares the results.
///
/// # Panics
/// When two results contradict each other.
pub fn check_answers(bytes: &[u8]) {
    let mut numbers = Numbers(bytes.iter());
    let (Some(a), Some(b)) = (numbers.shape(1), numbers.shape(1)) else { return };
    let poses = [numbers.pose(), numbers.pose()];
    let ray = UnitVector::new(numbers.vector()).ok().and_then(|along| Ray::new(numbers.vector(), along).ok());
    let velocities = [(); 2].map(|()| Velocity::new(numbers.vector(), numbers.vector()));
    if is_sliver(&a) || is_sliver(&b) {
        return;
    }
    let length = |shape: &Shape| match shape {
        Shape::HalfSpace(half_space) => half_space.offset().abs(),
        _ => shape.radius(),
    };
    let largest = length(&a) + length(&b) + poses.iter().map(|pose| pose.translation.length()).sum::<f64>();
    if !(largest < LARGE) {
        return;
    }
    let pair = Pair { shapes: [a, b], poses, tolerance: ROUNDING * (1.0 + largest) };
    if let Some(ray) = ray {
        pair.check_ray(&ray);
    }
    pair.check_distance();
    pair.check_swapped();
    pair.check_impact(velocities);
}

/// Whether a shape is so thin that its slopes are lost in rounding.
fn is_sliver(shape: &Shape) -> bool {
    if matches!(shape, Shape::HalfSpace(_) | Shape::Points(_) | Shape::TriangleMesh(_)) {
        return false;
    }
    let parts = if let Shape::Compound(compound) = shape { compound.parts() } else { &[] };
    let width = match shape {
        Shape::Convex(polyhedron) => {
            let height = |normal: DVec3, offset: f64| {
                polyhedron.vertices().iter().map(|&v| offset - normal.dot(v)).fold(0.0, f64::max)
            };
            polyhedron.faces().map(|face| height(face.normal, face.offset)).fold(f64::INFINITY, f64::min)
        }
        Shape::Capsule(capsule) => 2.0 * capsule.radius(),
        Shape::Cylinder(cylinder) => cylinder.height().min(2.0 * cylinder.radius()),
        Shape::Cone(cone) => cone.height().min(2.0 * cone.radius()),
        Shape::Torus(torus) => 2.0 * torus.minor(),
        _ => f64::INFINITY,
    };
    width < SLIVER * shape.size() || parts.iter().any(is_sliver)
}

/// Shapes thinner than this fraction of their length are skipped.
const SLIVER: f64 = 1e-4;

/// Whether a shape is convex with an inside, so that its depth of penetration is unique.
fn is_convex(shape: &Shape) -> bool {
    !matches!(shape, Shape::Torus(_) | Shape::TriangleMesh(_) | Shape::Compound(_) | Shape::Points(_))
}

/// Whether a predicate holds for a shape or one of its parts.
fn any_part(shape: &Shape, is_of_kind: fn(&Shape) -> bool) -> bool {
    match shape {
        Shape::Compound(compound) => compound.parts().iter().any(|part| any_part(part, is_of_kind)),
        _ => is_of_kind(shape),
    }
}

/// The smallest part of a compound, or the shape itself.
fn smallest_part(shape: &Shape) -> &Shape {
    let parts = if let Shape::Compound(compound) = shape { compound.parts() } else { &[] };
    let extended = parts.iter().map(smallest_part).filter(|part| part.size() > 0.0);
    extended.min_by(|p, q| p.size().total_cmp(&q.size())).unwrap_or(shape)
}

fn has_points(shape: &Shape) -> bool {
    any_part(shape, |part| matches!(part, Shape::Points(_)))
}

/// Whether a contact names two different branches of two circles, which may mean another place when A and B are
/// swapped.
fn has_an_order(feature: ContactFeature) -> bool {
    use SurfaceFeature::{RimEntry, RimExit};
    let ContactFeature::Elements { a, b } = feature else { return false };
    matches!((a, b), (RimExit(_), RimEntry(_)) | (RimEntry(_), RimExit(_)))
}

/// Whether a contact names the nearest point of a circle, which is any of its points when the bodies are coaxial.
fn is_nearest_rim(feature: ContactFeature) -> bool {
    use SurfaceFeature::Rim;
    matches!(feature, ContactFeature::Elements { a: Rim(_), .. } | ContactFeature::Elements { b: Rim(_), .. })
}

impl Pair {
    /// Whether separation and distance are different quantities. Two clouds never touch, though their points have a
    /// distance; a point behind a mesh counts as below its outer side, also when it came there around the border.
    fn differs_from_distance(&self) -> bool {
        let sheet = |shape: &Shape| matches!(shape, Shape::TriangleMesh(_)) || has_points(shape);
        let [a, b] = &self.shapes;
        (has_points(a) && sheet(b)) || (sheet(a) && has_points(b))
    }

    fn check_distance(&self) {
        let ([a, b], [pose_a, pose_b]) = (&self.shapes, &self.poses);
        let Ok(found) = distance(a, pose_a, b, pose_b) else { return };
        let normal = found.normal.length();
        assert!(found.distance.is_finite() && (normal - 1.0).abs() < ROUNDING, "{found:?}");
        let closing = found.point_b + found.normal * found.distance - found.point_a;
        assert!(closing.length() <= self.tolerance, "points apart: {found:?}");
        let apart = separation(a, pose_a, b, pose_b);
        if apart.is_infinite() || self.differs_from_distance() {
            return;
        }
        assert!(apart <= found.distance.max(0.0) + self.tolerance, "separated by more: {apart} {found:?}");
        if found.distance > self.tolerance {
            assert!(apart > -self.tolerance, "apart and overlapping: {apart} {found:?}");
        } else if is_convex(a) && is_convex(b) {
            assert!((apart - found.distance).abs() <= self.tolerance, "two depths: {apart} {found:?}");
        }
        if let Ok(swapped) = distance(b, pose_b, a, pose_a) {
            assert!((found.distance - swapped.distance).abs() <= self.tolerance, "swapped: {found:?} {swapped:?}");
        }
    }

    /// Compares the manifold with that of the swapped pair.
    fn check_swapped(&self) {
        let ([a, b], [pose_a, pose_b]) = (&self.shapes, &self.poses);
        let reach = self.tolerance;
        let found = manifold(a, pose_a, b, pose_b, reach);
        let swapped = manifold(b, pose_b, a, pose_a, reach);
        let apart = separation(a, pose_a, b, pose_b);
        if apart <= reach {
            assert!((found.separation - apart).abs() <= self.tolerance, "{apart} {found:?}");
        }
        let deep = -SHALLOW * joint_size(smallest_part(a), smallest_part(b));
        for contact in found.contacts.iter().filter(|c| !has_an_order(c.feature) && c.geometry.separation > deep) {
            let again = evaluate(contact.feature.swapped(), b, pose_b, a, pose_a);
            let again = again.unwrap_or_else(|| panic!("not found swapped: {contact:?}"));
            let (one, other) = (&contact.geometry, &again);
            let in_place = one.normal.dot(other.normal) < 0.0
                && one.point.distance(other.point) <= self.tolerance * SWAPPED_POINTS;
            let same = (one.separation - other.separation).abs() <= self.tolerance;
            let same = same && (in_place || is_nearest_rim(contact.feature));
            assert!(same, "swapped: {contact:?} {again:?}");
        }
        let none = |manifold: &Manifold| manifold.contacts.is_empty();
        // Deeper, an axis or a torus's centre circle may be inside, where no direction of separation is unique.
        if apart <= 0.0 && apart > deep {
            assert!(!none(&found) && !none(&swapped), "{apart} {found:?} {swapped:?}");
        }
    }

    fn check_ray(&self, ray: &Ray) {
        for (shape, pose) in self.shapes.iter().zip(&self.poses) {
            if matches!(shape, Shape::Points(_)) {
                continue;
            }
            let tolerance = self.tolerance + ROUNDING * ray.origin().length();
            let away = |point: DVec3| closest_point(shape, pose, point).map_or(f64::NAN, |near| near.distance);
            let at_start = away(ray.origin());
            let hit = ray_cast(shape, pose, ray, LARGE);
            let end = hit.map_or(4.0 / ROUNDING * self.tolerance, |hit| hit.distance);
            if let Some(hit) = hit {
                assert!(hit.distance >= 0.0 && (hit.normal.length() - 1.0).abs() < ROUNDING, "{hit:?}");
                let tolerance = tolerance + ROUNDING * hit.distance;
                assert!(hit.feature.is_some() || (hit.distance == 0.0 && at_start <= tolerance), "{hit:?} {at_start}");
                // The end of a grazing ray is known only to the square root of rounding.
                assert!(hit.feature.is_none() || away(hit.point).abs() <= tolerance, "{hit:?} {}", away(hit.point));
            }
            if hit.is_none_or(|hit| hit.feature.is_some()) {
                for k in 0..SAMPLES {
                    let place = ray.at(end * f64::from(k) / f64::from(SAMPLES));
                    assert!(!(away(place) < -tolerance), "{} inside {shape:?} before {hit:?}", away(place));
                }
            }
        }
    }

    fn check_impact(&self, velocities: [Velocity; 2]) {
        let ([a, b], [pose_a, pose_b]) = (&self.shapes, self.poses);
        let motions = [Screw(pose_a, velocities[0]), Screw(pose_b, velocities[1])];
        let travel: f64 = velocities.iter().map(|v| v.linear.length()).sum();
        let turns: f64 = velocities.iter().map(|v| v.angular.length()).sum();
        if !(travel < FASTEST && turns < FASTEST) || self.differs_from_distance() {
            return;
        }
        let tolerance = self.tolerance * (1.0 + travel + turns);
        let apart = |t: f64| separation(a, &motions[0].pose(t), b, &motions[1].pose(t));
        if apart(0.0) <= tolerance {
            return;
        }
        let settings = ImpactSearch { max_evaluations: 1000, ..ImpactSearch::default() };
        let Ok(report) = find_impact(a, &motions[0], b, &motions[1], 0.0, 1.0, &settings) else { return };
        let end = report.time.unwrap_or(1.0);
        for k in 0..SAMPLES {
            let t = end * f64::from(k) / f64::from(SAMPLES);
            assert!(apart(t) > -tolerance, "overlap {} at {t} before {report:?}", apart(t));
        }
        let touch = apart(end);
        assert!(report.time.is_none() || touch.abs() <= tolerance, "{touch} at the impact {report:?}");
    }
}

/// Contact points may differ by this factor more than separations do, along a flat region.
const SWAPPED_POINTS: f64 = 1e3;

/// Penetrations up to this, relative to the joint size of the smallest parts, must have contacts: in a thin part of a
/// compound a body may be on the part's axis although it is not deep in the compound.
const SHALLOW: f64 = 0.01;

/// Larger speeds and spins, m/s and rad/s, are skipped.
const FASTEST: f64 = 1e3;
