//! Smooth shapes as Minkowski sums of a ball and the hull of points and circles.
//!
//! A sphere is a point plus a ball, a capsule the hull of two points plus a ball; a cylinder is the hull of two
//! circles, a cone that of a point and a circle. Along a unit vector `n` the support of a circle (centre `c`, axis `a`,
//! radius `R`) is `n.c + R |a x n|`, so that heights above planes and separations along axes are closed forms. A torus
//! is a circle plus a ball; its height above a plane is that of its hull.
//!
//! **Features.** A capsule has caps 0 and 1 at its ends and side 0 between; a cylinder has faces and rims 0 (towards
//! `-axis`) and 1, and side 0; a cone has face and rim 0, side 0, and its apex as vertex 0; a torus has rim 0, the
//! centre circle of its tube.
//!
//! **Sample points.** A disc that lies on a plane touches it everywhere. [`RIM_POINTS`] points of each rim, fixed in
//! the body, represent it. Eight equal forces there have the same resultant as a uniform pressure, and eight forces can
//! represent any pressure whose centre lies in the octagon of these points. They are vertices: of a cylinder 0 to 7 on
//! rim 0 and 8 to 15 on rim 1, of a cone 1 to 8; of a torus 0 to 7 on its centre circle (centres of balls that just
//! fill the tube).

use super::circle::Circle;
pub use super::circle::RIM_POINTS;
use crate::Shape;
use glam::DVec3;

/// The circles of a smooth shape, at most two.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Circles {
    items: [Circle; 2],
    count: usize,
}

impl Circles {
    pub(crate) const NONE: Self = {
        let none = Circle { center: DVec3::ZERO, axis: DVec3::Z, radius: 0.0 };
        Self { items: [none, none], count: 0 }
    };
}

impl std::ops::Deref for Circles {
    type Target = [Circle];
    fn deref(&self) -> &[Circle] {
        &self.items[..self.count]
    }
}

/// The circles of a shape in its body's frame: rims, or the centre circle of a torus.
pub(crate) fn circles(shape: &Shape) -> Circles {
    match shape {
        Shape::Cylinder(c) => Circles { items: c.rims(), count: 2 },
        Shape::Cone(c) => Circles { items: [c.rim(); 2], count: 1 },
        Shape::Torus(t) => Circles { items: [t.ring(); 2], count: 1 },
        _ => Circles::NONE,
    }
}

/// A point fixed in the body that a contact can name as a vertex or centre, and the radius of the ball about it, m: a
/// vertex of a polyhedron, a point of a cloud, the centre of a sphere, an end of a capsule's axis, a cone's apex, a
/// sample point.
pub(crate) fn fixed_point(shape: &Shape, index: u32) -> Option<(DVec3, f64)> {
    match shape {
        Shape::Cylinder(_) => {
            let rims = circles(shape);
            Some((rims.get((index / RIM_POINTS) as usize)?.point(index % RIM_POINTS)?, 0.0))
        }
        Shape::Cone(c) if index == 0 => Some((c.apex(), 0.0)),
        Shape::Cone(_) => Some((circles(shape).first()?.point(index - 1)?, 0.0)),
        Shape::Torus(t) => Some((circles(shape).first()?.point(index)?, t.minor)),
        _ => {
            let (centers, radius) = shape.centers();
            Some((*centers.get(index as usize)?, radius))
        }
    }
}

/// Points, circles and a radius (m): the hull of the points and circles plus a ball is the shape's hull.
pub(crate) fn hull_points(shape: &Shape) -> (HullPoints<'_>, f64) {
    match shape {
        Shape::Cone(c) => (HullPoints::Apex(c.apex()), 0.0),
        Shape::Torus(t) => (HullPoints::Listed(&[]), t.minor),
        _ => {
            let (centers, radius) = shape.centers();
            (HullPoints::Listed(centers), radius)
        }
    }
}

/// A shape as the hull of points and circles plus a ball (radius in m).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hull<'a> {
    pub(crate) points: HullPoints<'a>,
    pub(crate) circles: Circles,
    pub(crate) ball: f64,
}

impl<'a> Hull<'a> {
    pub(crate) fn of(shape: &'a Shape) -> Self {
        let (points, ball) = hull_points(shape);
        Self { points, circles: circles(shape), ball }
    }

    /// Points and a ball (radius in m).
    pub(crate) const fn of_points(points: &'a [DVec3], ball: f64) -> Self {
        Self { points: HullPoints::Listed(points), circles: Circles::NONE, ball }
    }

    /// One point of a cloud.
    pub(crate) fn of_point(self, index: u32) -> Self {
        match self.points {
            HullPoints::Listed(points) => {
                let index = index as usize;
                Self { points: HullPoints::Listed(points.get(index..=index).unwrap_or(&[])), ..self }
            }
            HullPoints::Apex(_) => self,
        }
    }
}

/// Points that a shape lists, or the apex that a cone computes.
#[derive(Debug, Clone, Copy)]
pub(crate) enum HullPoints<'a> {
    Listed(&'a [DVec3]),
    Apex(DVec3),
}

impl std::ops::Deref for HullPoints<'_> {
    type Target = [DVec3];
    fn deref(&self) -> &[DVec3] {
        match self {
            Self::Listed(points) => points,
            Self::Apex(apex) => std::slice::from_ref(apex),
        }
    }
}

/// Largest coordinate of a shape's hull along a unit vector of its frame, m; minus infinity where it has no points.
pub(crate) fn support(shape: &Shape, n: DVec3) -> f64 {
    let (points, ball) = hull_points(shape);
    let points = points.iter().map(|p| n.dot(*p)).fold(f64::NEG_INFINITY, f64::max);
    circles(shape).iter().map(|circle| circle.support(n)).fold(points, f64::max) + ball
}

/// The support point of a shape's hull along a direction of its frame; the origin where there is none.
pub(crate) fn support_point(shape: &Shape, n: DVec3) -> DVec3 {
    let (points, ball) = hull_points(shape);
    let mut best = (f64::NEG_INFINITY, DVec3::ZERO);
    let mut offer = |point: DVec3| {
        let height = n.dot(point);
        if height > best.0 {
            best = (height, point);
        }
    };
    points.iter().copied().for_each(&mut offer);
    for circle in circles(shape).iter() {
        offer(circle.farthest(n));
    }
    best.1 + n.try_normalize().unwrap_or(DVec3::ZERO) * ball
}

/// Whether the shape is a capsule, cylinder or cone: the smooth convex shapes whose contacts are found by elements.
#[inline]
pub(crate) const fn is_round(shape: &Shape) -> bool {
    matches!(shape, Shape::Capsule(_) | Shape::Cylinder(_) | Shape::Cone(_))
}
