//! Ray casts: the first point at which a ray hits a shape.
//!
//! The ray is transformed into the shape's frame, and parameters are computed relative to the point of its line nearest
//! to the shape's middle, so that a far ray loses no more than the rounding of its own origin. A convex shape is
//! intersected by clipping the ray with its planes and quadrics; a torus by bisection on the intervals on which its
//! quartic is monotone, with the exact distance from the tube. A triangle is tested by the signs of the volumes that
//! the ray spans with its edges. These signs are the same for both triangles of an edge, so that no ray passes between
//! them (docs/REFERENCES.md, Woop, Benthin and Wald 2013). There is no tolerance: for a ray that grazes a shape to
//! rounding, the rounded numbers decide between hit and miss, always in the same way.

use super::error::QueryError;
use super::feature::QueryFeature;
use super::piece::{Core, Piece};
use super::pieces::{entry_distance, offer_nearest};
use super::roots::{bisect, monotone_pieces};
use super::signed_distance::signed_distance;
use crate::bounding::aabb::Aabb;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::shape::support::across;
use crate::shape::triangle::area_vector;
use crate::{Cone, Cylinder, Shape, SurfaceFeature, Torus};
use glam::DVec3;
use polhode_spatial::{Pose, UnitVector};

/// A half-line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    origin: DVec3,
    direction: DVec3,
}

impl Ray {
    /// From a point (world, m) in a direction.
    ///
    /// # Errors
    /// When the origin is not finite.
    pub fn new(origin: DVec3, direction: UnitVector) -> Result<Self, QueryError> {
        if !origin.is_finite() {
            return Err(QueryError::NotFinite { what: "the origin of a ray" });
        }
        Ok(Self { origin, direction: direction.get() })
    }

    /// Its origin, world, m.
    pub const fn origin(&self) -> DVec3 {
        self.origin
    }

    /// Unit vector.
    pub const fn direction(&self) -> DVec3 {
        self.direction
    }

    /// The point at a distance (m) from the origin.
    pub fn at(&self, distance: f64) -> DVec3 {
        self.origin + self.direction * distance
    }
}

/// The first point at which a ray hits a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RayHit {
    /// Distance from the ray's origin, m; 0 when it starts inside.
    pub distance: f64,
    /// The point, world, m.
    pub point: DVec3,
    /// Outward unit normal of the surface, world; for a triangle on the side from which the ray comes. For a ray that
    /// starts inside it is opposite to the ray's direction.
    pub normal: DVec3,
    /// The feature hit; none for a ray that starts inside.
    pub feature: Option<QueryFeature>,
}

/// The first point at which a ray hits a shape, at most `max_distance` away (m, may be infinite).
///
/// Shapes are solid: a ray that starts inside, or on the surface and heading in, hits them at distance 0. Meshes are
/// surfaces and are hit from both sides. Points have no extent and are never hit. None for a miss, a pose that is not
/// finite, or a `max_distance` that is NaN or negative.
///
/// ```
/// use polhode_contact::{DVec3, Pose, Ray, Shape, UnitVector, ray_cast};
/// let ball = Shape::sphere(0.5)?;
/// let ray = Ray::new(DVec3::Z * 3.0, UnitVector::new(-DVec3::Z)?)?;
/// let hit = ray_cast(&ball, &Pose::IDENTITY, &ray, f64::INFINITY).ok_or("a miss")?;
/// assert_eq!((hit.distance, hit.normal), (2.5, DVec3::Z));
/// assert!(ray_cast(&ball, &Pose::IDENTITY, &ray, 2.0).is_none());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn ray_cast(shape: &Shape, pose: &Pose, ray: &Ray, max_distance: f64) -> Option<RayHit> {
    if !(pose.is_finite() && max_distance >= 0.0) {
        return None;
    }
    let local = Line {
        origin: pose.inverse_transform_point(ray.origin),
        direction: pose.rotation.inverse_rotate(ray.direction),
    };
    let mut best: Option<(f64, Met, u32)> = None;
    let bound = |bounds: &Aabb| entry_distance(bounds, local.origin, local.direction).unwrap_or(f64::INFINITY);
    // A missed box has an infinite bound; the limit must be finite to exclude it.
    let limit = max_distance.min(f64::MAX);
    offer_nearest(shape, &Pose::IDENTITY, limit, &bound, &mut |piece| {
        if let Some((distance, met)) = against(piece, &local)
            && distance <= max_distance
            && best.is_none_or(|best| (distance, piece.part) < (best.0, best.2))
        {
            best = Some((distance, met, piece.part));
        }
        best.map_or(limit, |best| best.0)
    });
    let (distance, met, part) = best?;
    let point = ray.at(distance);
    Some(match met {
        Met::Inside => RayHit { distance, point, normal: -ray.direction, feature: None },
        Met::Surface { normal, feature } => RayHit {
            distance,
            point,
            normal: pose.rotation.rotate(normal),
            feature: Some(QueryFeature { part, surface: feature }),
        },
    })
}

/// A ray in a shape's frame.
#[derive(Debug, Clone, Copy)]
struct Line {
    origin: DVec3,
    direction: DVec3,
}

/// What a ray hits: the inside of a shape (it starts there), or its surface.
#[derive(Debug, Clone, Copy)]
enum Met {
    Inside,
    Surface { normal: DVec3, feature: SurfaceFeature },
}

/// The distance of a hit from the ray's origin, m, and what is hit; none for a miss.
type Hit = Option<(f64, Met)>;

/// A hit on the surface.
#[allow(clippy::unnecessary_wraps, reason = "it ends functions that may also meet nothing")]
fn surface(distance: f64, normal: DVec3, feature: SurfaceFeature) -> Hit {
    Some((distance, Met::Surface { normal, feature }))
}

fn against(piece: &Piece<'_>, ray: &Line) -> Hit {
    match &piece.core {
        Core::Point(_) if piece.is_vertex() => None,
        Core::Point(center) => ball(*center, piece.radius, ray),
        Core::Segment(ends) => capsule(*ends, piece.radius, ray),
        Core::Triangle(corners) => triangle(corners, ray),
        Core::Polyhedron(polyhedron) => through_polyhedron(polyhedron, ray),
        Core::Cylinder(cylinder) => through_cylinder(cylinder, ray),
        Core::Cone(cone) => through_cone(cone, ray),
        Core::Circle(ring) => through_torus(ring, ray),
        Core::HalfSpace(h) => {
            let height = h.normal.dot(ray.origin) - h.offset;
            let rate = h.normal.dot(ray.direction);
            if height <= 0.0 {
                Some((0.0, Met::Inside))
            } else if rate < 0.0 {
                surface(-height / rate, h.normal, SurfaceFeature::Face(0))
            } else {
                None
            }
        }
    }
}

/// The interval in which a line is inside a ball, as two distances from its origin.
fn within_ball(center: DVec3, radius: f64, ray: &Line) -> Option<(f64, f64)> {
    let to = center - ray.origin;
    let middle = to.dot(ray.direction);
    let beside = across(to, ray.direction).length();
    let half_square = (radius - beside) * (radius + beside);
    (half_square >= 0.0).then(|| (middle - half_square.sqrt(), middle + half_square.sqrt()))
}

fn ball(center: DVec3, radius: f64, ray: &Line) -> Hit {
    if ray.origin.distance(center) <= radius {
        return Some((0.0, Met::Inside));
    }
    let (enter, _) = within_ball(center, radius, ray).filter(|(enter, _)| *enter >= 0.0)?;
    let normal = (ray.origin - center) + ray.direction * enter;
    surface(enter, normal.normalize_or(-ray.direction), SurfaceFeature::Sphere)
}

/// The interval in which a line is inside an infinite cylinder about an axis through `base`; all of it or none when it
/// is parallel.
fn within_tube(base: DVec3, axis: DVec3, radius: f64, ray: &Line) -> Option<(f64, f64)> {
    let (from, along) = (across(ray.origin - base, axis), across(ray.direction, axis));
    // For a ray almost parallel to the axis the squares would underflow, so the vector is scaled.
    let largest = along.abs().max_element();
    if largest == 0.0 {
        return (from.length() <= radius).then_some((f64::NEG_INFINITY, f64::INFINITY));
    }
    let scaled = along / largest;
    let rate = largest * scaled.length();
    let along = scaled / scaled.length();
    let middle = -from.dot(along);
    // The least distance from the axis as the area of a parallelogram, without cancellation for far rays.
    let beside = from.cross(along).length();
    let half_square = (radius - beside) * (radius + beside);
    (half_square >= 0.0).then(|| ((middle - half_square.sqrt()) / rate, (middle + half_square.sqrt()) / rate))
}

fn capsule(ends: [DVec3; 2], radius: f64, ray: &Line) -> Hit {
    let core = Core::Segment(ends);
    if signed_distance(&core, ray.origin).distance <= radius {
        return Some((0.0, Met::Inside));
    }
    let length = ends[0].distance(ends[1]);
    let axis = (ends[1] - ends[0]) / length;
    let mut first = f64::INFINITY;
    for end in ends {
        if let Some((enter, _)) = within_ball(end, radius, ray).filter(|(enter, _)| *enter >= 0.0) {
            first = first.min(enter);
        }
    }
    if let Some((enter, _)) = within_tube(ends[0], axis, radius, ray).filter(|(enter, _)| *enter >= 0.0) {
        let along = (ray.origin - ends[0]).dot(axis) + enter * ray.direction.dot(axis);
        if (0.0..=length).contains(&along) {
            first = first.min(enter);
        }
    }
    if first == f64::INFINITY {
        return None;
    }
    let place = signed_distance(&core, ray.origin + ray.direction * first);
    surface(first, place.normal, place.feature)
}

fn through_polyhedron(polyhedron: &ConvexPolyhedron, ray: &Line) -> Hit {
    let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut entered = None;
    let mut inside = true;
    for (index, face) in polyhedron.faces.iter().enumerate() {
        let height = face.normal.dot(ray.origin) - face.offset;
        let rate = face.normal.dot(ray.direction);
        inside &= height <= 0.0;
        if rate == 0.0 {
            if height > 0.0 {
                return None;
            }
        } else if rate < 0.0 {
            let t = -height / rate;
            if t > enter {
                enter = t;
                entered = Some(index);
            }
        } else {
            leave = leave.min(-height / rate);
        }
    }
    if inside {
        return Some((0.0, Met::Inside));
    }
    let index = entered.filter(|_| enter <= leave && enter >= 0.0)?;
    surface(enter, polyhedron.faces[index].normal, SurfaceFeature::Face(index as u32))
}

/// The interval in which a line is between two planes perpendicular to an axis.
fn within_slab(from: f64, rate: f64, low: f64, high: f64) -> Option<(f64, f64)> {
    if rate == 0.0 {
        return (low..=high).contains(&from).then_some((f64::NEG_INFINITY, f64::INFINITY));
    }
    let (s, t) = ((low - from) / rate, (high - from) / rate);
    Some((s.min(t), s.max(t)))
}

fn through_cylinder(cylinder: &Cylinder, ray: &Line) -> Hit {
    if signed_distance(&Core::Cylinder(cylinder), ray.origin).distance <= 0.0 {
        return Some((0.0, Met::Inside));
    }
    let rate = ray.direction.dot(cylinder.axis);
    let height = (ray.origin - cylinder.center).dot(cylinder.axis);
    let discs = within_slab(height, rate, -cylinder.half_height, cylinder.half_height)?;
    let side = within_tube(cylinder.center, cylinder.axis, cylinder.radius, ray)?;
    let (enter, leave) = (discs.0.max(side.0), discs.1.min(side.1));
    if enter > leave || enter < 0.0 {
        return None;
    }
    if discs.0 >= side.0 {
        let up = if rate < 0.0 { cylinder.axis } else { -cylinder.axis };
        return surface(enter, up, SurfaceFeature::Face(u32::from(rate < 0.0)));
    }
    let radial = across((ray.origin - cylinder.center) + ray.direction * enter, cylinder.axis);
    surface(enter, radial.normalize_or(-ray.direction), SurfaceFeature::Side(0))
}

/// The side is the zero of `f = (radius of the cone at the height)^2 - (distance from the axis)^2`, a quadratic.
fn through_cone(cone: &Cone, ray: &Line) -> Hit {
    let core = Core::Cone(cone);
    if signed_distance(&core, ray.origin).distance <= 0.0 {
        return Some((0.0, Met::Inside));
    }
    // From the point of the line nearest to the apex, so that the coefficients do not cancel.
    let shift = (cone.apex() - ray.origin).dot(ray.direction);
    let from = (ray.origin - cone.apex()) + ray.direction * shift;
    let (height, rate) = (from.dot(cone.axis), ray.direction.dot(cone.axis));
    let (out, along) = (across(from, cone.axis), across(ray.direction, cone.axis));
    let slope = cone.radius / cone.height;
    let square = slope * slope;
    let a = along.length_squared() - square * rate * rate;
    let b = out.dot(along) - square * height * rate;
    let c = out.length_squared() - square * height * height;
    let mut best: Hit = None;
    let mut offer = |hit: Hit| {
        if let Some((t, _)) = hit
            && t >= 0.0
            && best.is_none_or(|(first, _)| t < first)
        {
            best = hit;
        }
    };
    if rate != 0.0 {
        let t = (-cone.height - height) / rate;
        if (out + along * t).length() <= cone.radius {
            offer(surface(t + shift, -cone.axis, SurfaceFeature::Face(0)));
        }
    }
    for t in quadratic_roots(a, b, c).into_iter().flatten() {
        let above_apex = height + rate * t;
        if (-cone.height..=0.0).contains(&above_apex) {
            let radial = (out + along * t).normalize_or(along.normalize_or(-ray.direction));
            let normal = (radial * cone.height + cone.axis * cone.radius).normalize_or(-ray.direction);
            offer(surface(t + shift, normal, SurfaceFeature::Side(0)));
        }
    }
    best
}

/// Roots of `a t^2 + 2 b t + c`.
fn quadratic_roots(a: f64, b: f64, c: f64) -> [Option<f64>; 2] {
    let square = b * b - a * c;
    if square < 0.0 {
        return [None, None];
    }
    let sum = if b < 0.0 { -b + square.sqrt() } else { -b - square.sqrt() };
    let finite = |t: f64| t.is_finite().then_some(t);
    [finite(sum / a), finite(c / sum)]
}

/// Rounding of the area of a triangle projected along the ray, in epsilons of the distance of its corners times their
/// offset from the ray. A triangle with a smaller projected area is seen edge-on, and the signs of its volumes have no
/// meaning.
const SEEN_ULPS: f64 = 16.0;

/// Signs of the volumes that the ray spans with the edges; a corner or an edge that the ray hits exactly belongs to all
/// of its triangles. A ray in the plane of a triangle misses it, and hits its neighbours.
fn triangle(corners: &[DVec3; 3], ray: &Line) -> Hit {
    let d = ray.direction;
    let from_start = corners.map(|corner| corner - ray.origin);
    // The component of a corner along the ray adds only rounding to the volumes, and is removed from each corner
    // separately: the result is the same for both triangles of an edge.
    let along = from_start.map(|corner| d.dot(corner));
    let [p, q, r] = [0, 1, 2].map(|k: usize| from_start[k] - d * along[k]);
    let parts = [d.dot(q.cross(r)), d.dot(r.cross(p)), d.dot(p.cross(q))];
    let total: f64 = parts.iter().sum();
    let longest = |vectors: [DVec3; 3]| vectors.iter().map(|v| v.length()).fold(0.0, f64::max);
    let rounding = SEEN_ULPS * f64::EPSILON * longest(from_start) * longest([p, q, r]);
    if !(parts.iter().all(|&v| v >= 0.0) || parts.iter().all(|&v| v <= 0.0)) || total.abs() <= rounding {
        return None;
    }
    let normal = area_vector(*corners);
    let rate = normal.dot(d);
    // The distance follows from the plane, which is the same for every ray; for a needle, whose plane is uncertain,
    // from the corners.
    let by_plane = normal.dot(from_start[0]) / rate;
    let t = if by_plane.is_finite() {
        by_plane
    } else {
        (along[0] * parts[0] + along[1] * parts[1] + along[2] * parts[2]) / total
    };
    // Where the ray lies almost in the plane, that distance is inaccurate; it is clamped to the extent of the triangle
    // along the ray.
    let (nearest, farthest) = over(along, [p, q, r], rounding);
    let t = t.max(nearest).min(farthest);
    if !(t >= 0.0 && t.is_finite()) {
        return None;
    }
    let out = if rate < 0.0 { normal } else { -normal };
    surface(t, out.normalize_or(-d), SurfaceFeature::Face(0))
}

/// The interval of distances along a ray in which its line crosses a triangle, both projected on the plane of the ray
/// and the longest of `across`. `along` and `across` are the components of the corners along the ray and perpendicular
/// to it. Corners nearer to the ray than `rounding` (m^2: the longest offset times their own) count as on it.
fn over(along: [f64; 3], across: [DVec3; 3], rounding: f64) -> (f64, f64) {
    let longest = across.iter().fold(DVec3::ZERO, |most, v| if v.length() > most.length() { *v } else { most });
    let beside = across.map(|v| v.dot(longest));
    // When all corners are on one side of the ray, by rounding, the ray passes through the nearest one.
    let low = beside.iter().fold(f64::INFINITY, |least, &b| least.min(b));
    let high = beside.iter().fold(f64::NEG_INFINITY, |most, &b| most.max(b));
    let beside = beside.map(|b| b - low.max(0.0) - high.min(0.0));
    let beside = beside.map(|b| if b.abs() <= rounding { 0.0 } else { b });
    let (mut nearest, mut farthest) = (f64::INFINITY, f64::NEG_INFINITY);
    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
        if beside[i] == 0.0 {
            (nearest, farthest) = (nearest.min(along[i]), farthest.max(along[i]));
        } else if beside[i] * beside[j] < 0.0 {
            let crossing = along[i] + (along[j] - along[i]) * (beside[i] / (beside[i] - beside[j]));
            (nearest, farthest) = (nearest.min(crossing), farthest.max(crossing));
        }
    }
    if nearest <= farthest { (nearest, farthest) } else { (f64::NEG_INFINITY, f64::INFINITY) }
}

/// `F = (|p|^2 + R^2 - r^2)^2 - 4 R^2 rho^2`, with lengths in units of `R + r` and `t` measured from the ray's point
/// nearest to the centre.
fn through_torus(ring: &Torus, ray: &Line) -> Hit {
    let outside = |p: DVec3| signed_distance(&Core::Circle(ring), p).distance - ring.minor;
    if outside(ray.origin) <= 0.0 {
        return Some((0.0, Met::Inside));
    }
    let size = ring.major + ring.minor;
    let (enter, leave) = within_ball(ring.center, size, ray)?;
    if leave < 0.0 {
        return None;
    }
    let shift = (ring.center - ray.origin).dot(ray.direction);
    let p = ((ray.origin - ring.center) + ray.direction * shift) / size;
    let (major, minor) = (ring.major / size, ring.minor / size);
    let (height, rate) = (p.dot(ring.axis), ray.direction.dot(ring.axis));
    let b = p.dot(ray.direction);
    let k = p.length_squared() + (major - minor) * (major + minor);
    let fourfold = 4.0 * major * major;
    let coefficients = [
        k * k - fourfold * (p.length_squared() - height * height),
        4.0 * b * k - 2.0 * fourfold * (b - height * rate),
        2.0 * k + 4.0 * b * b - fourfold * (1.0 - rate * rate),
        4.0 * b,
        1.0,
    ];
    let (low, high) = ((enter.max(0.0) - shift) / size, (leave - shift) / size);
    let pieces = monotone_pieces(coefficients, low, high);
    // The root is found on the distance from the tube; the polynomial gives only the intervals.
    let at = |t: f64| outside(ray.origin + ray.direction * (shift + t * size));
    for ends in pieces.windows(2) {
        if at(ends[0]) <= 0.0 || at(ends[1]) <= 0.0 {
            let t = if at(ends[0]) <= 0.0 { ends[0] } else { bisect(ends[0], ends[1], &at)? };
            let distance = shift + t * size;
            let place = signed_distance(&Core::Circle(ring), ray.origin + ray.direction * distance);
            return surface(distance.max(0.0), place.normal, SurfaceFeature::Rim(0));
        }
    }
    None
}
