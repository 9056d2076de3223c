//! Bounding spheres.

use super::axis_aligned_box::ROUNDING_ULPS;
use crate::{Aabb, AabbError, Shape};
use glam::DVec3;
use polhode_spatial::Pose;

/// A ball that contains a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundingSphere {
    center: DVec3,
    radius: f64,
}

impl BoundingSphere {
    /// A ball about a shape, in the shape's frame; none for a half-space. It is the smallest one, but for rounding,
    /// except about a compound with round parts, where it is one about the parts' smallest balls.
    ///
    /// That of points is found by Welzl's algorithm (docs/REFERENCES.md, Welzl 1991), and the radius is then the largest
    /// distance of a point from the centre, rounded up: containment does not rest on the algorithm.
    pub fn of(shape: &Shape) -> Option<Self> {
        match shape {
            Shape::HalfSpace(_) => None,
            Shape::Cylinder(c) => Some(Self::rounded_up(c.center, libm::hypot(c.radius, c.half_height))),
            Shape::Cone(c) if c.height > c.radius => {
                let radius = 0.5 * (c.height + c.radius * (c.radius / c.height));
                Some(Self::rounded_up(c.base + c.axis * (c.height - radius), radius))
            }
            Shape::Cone(c) => Some(Self::rounded_up(c.base, c.radius)),
            Shape::Torus(t) => Some(Self::rounded_up(t.center, t.major + t.minor)),
            Shape::Compound(c) => of_parts(&c.parts),
            Shape::TriangleMesh(mesh) => {
                of_points(&mut mesh.places().collect::<Vec<_>>()).map(|core| Self::rounded_up(core.center, core.radius))
            }
            Shape::Convex(_) | Shape::Sphere(_) | Shape::Points(_) | Shape::Capsule(_) => {
                let (centers, rounding) = shape.centers();
                let core = of_points(&mut centers.to_vec())?;
                Some(Self::rounded_up(core.center, core.radius + rounding))
            }
        }
    }

    /// Centre, m.
    pub const fn center(&self) -> DVec3 {
        self.center
    }

    /// Radius, m.
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// Volume, m^3.
    pub fn volume(&self) -> f64 {
        4.0 / 3.0 * std::f64::consts::PI * self.radius * self.radius * self.radius
    }

    /// Whether the point (m) is in the ball; a point outside by rounding counts.
    pub fn contains(&self, point: DVec3) -> bool {
        self.center.distance(point) <= self.radius * (1.0 + ROUNDING_ULPS * f64::EPSILON)
    }

    /// Whether the balls share a point; balls that are apart by rounding count.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.center.distance(other.center) <= (self.radius + other.radius) * (1.0 + ROUNDING_ULPS * f64::EPSILON)
    }

    /// The smallest ball that contains both.
    pub fn merged(&self, other: &Self) -> Self {
        let (large, small) = if self.radius >= other.radius { (self, other) } else { (other, self) };
        let distance = large.center.distance(small.center);
        if distance + small.radius <= large.radius {
            return *large;
        }
        let radius = 0.5 * (distance + large.radius + small.radius);
        let center = large.center + (small.center - large.center) * ((radius - large.radius) / distance);
        Self::rounded_up(center, radius)
    }

    /// The ball of the shape at a pose.
    pub fn transformed(&self, pose: &Pose) -> Self {
        Self::rounded_up(pose.transform_point(self.center), self.radius)
    }

    /// The box about the ball, along the axes.
    ///
    /// # Errors
    /// When a coordinate is NaN.
    pub fn aabb(&self) -> Result<Aabb, AabbError> {
        Aabb::new(self.center - self.radius, self.center + self.radius)
    }

    /// With the rounding of the centre and of the radius added.
    fn rounded_up(center: DVec3, radius: f64) -> Self {
        let rounding = ROUNDING_ULPS * f64::EPSILON * (center.abs().max_element() + radius);
        Self { center, radius: radius + rounding }
    }
}

/// About the points of all parts when they are all angular, else about the parts' balls.
fn of_parts(parts: &[Shape]) -> Option<BoundingSphere> {
    let is_angular = |part: &Shape| matches!(part, Shape::Convex(_) | Shape::Points(_) | Shape::TriangleMesh(_));
    if parts.iter().all(is_angular) {
        let mut points: Vec<_> = parts.iter().flat_map(|part| part.centers().0).copied().collect();
        let core = of_points(&mut points)?;
        return Some(BoundingSphere::rounded_up(core.center, core.radius));
    }
    let balls = parts.iter().map(BoundingSphere::of).collect::<Option<Vec<_>>>()?;
    balls.into_iter().reduce(|merged, ball| merged.merged(&ball))
}

/// The smallest ball about points, none when there are none. The points are put into another order.
fn of_points(points: &mut [DVec3]) -> Option<BoundingSphere> {
    let first = *points.first()?;
    shuffle(points);
    let mut fixed = [first; 4];
    let ball = smallest_through(points, &mut fixed, 0);
    let radius = points.iter().map(|point| ball.center.distance(*point)).fold(0.0, f64::max);
    Some(BoundingSphere { center: ball.center, radius })
}

/// A fixed order that no arrangement of points is likely to be bad for: expected time is proportional to the count.
fn shuffle(points: &mut [DVec3]) {
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    for i in (1..points.len()).rev() {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        points.swap(i, (state % (i as u64 + 1)) as usize);
    }
}

/// The smallest ball about `points` with the first `count` of the `fixed` ones on its surface.
fn smallest_through(points: &[DVec3], fixed: &mut [DVec3; 4], count: usize) -> BoundingSphere {
    let mut ball = circumscribed(&fixed[..count]);
    if count == 4 {
        return ball;
    }
    for (i, &point) in points.iter().enumerate() {
        if !(count + i > 0 && ball.contains(point)) {
            fixed[count] = point;
            ball = smallest_through(&points[..i], fixed, count + 1);
        }
    }
    ball
}

/// The smallest ball with up to four points on its surface: the centre is `p0 + sum x_k e_k` with `e_k = p_k - p0` and
/// `2 sum_k (e_j . e_k) x_k = e_j . e_j`. Where the points do not determine it, the last one is left out.
fn circumscribed(points: &[DVec3]) -> BoundingSphere {
    let Some((&origin, others)) = points.split_first() else {
        return BoundingSphere { center: DVec3::ZERO, radius: 0.0 };
    };
    let mut offset = DVec3::ZERO;
    // Gram-Schmidt: the part of each edge across the others decides how far the centre moves along it.
    let mut across = [DVec3::ZERO; 3];
    for (k, &point) in others.iter().enumerate() {
        let edge = point - origin;
        let mut part = edge;
        for _ in 0..2 {
            for &axis in across[..k].iter().filter(|axis| **axis != DVec3::ZERO) {
                part -= axis * part.dot(axis);
            }
        }
        let length = part.length();
        if length > DEGENERATE * edge.length() {
            let axis = part / length;
            // |offset - edge| = |offset| with the parts along the earlier axes already fixed.
            offset += axis * ((0.5 * edge.length_squared() - edge.dot(offset)) / length);
            across[k] = axis;
        }
    }
    BoundingSphere { center: origin + offset, radius: offset.length() }
}

/// An edge whose part across the others is below this share of its length does not determine a ball (dimensionless):
/// the centre would be known to fewer than six digits.
const DEGENERATE: f64 = 1e-10;
