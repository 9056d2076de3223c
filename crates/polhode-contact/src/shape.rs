//! Shapes that can touch.
//!
//! A shape stands in a frame of its body; the engine uses the central frame, origin at the centre of mass, into which
//! [`Shape::translated`] brings it. Values are checked when a shape is made ("parse, don't validate"), so that the
//! algorithms meet only finite, closed and convex shapes.

use crate::ConvexPolyhedron;
use glam::DVec3;
use polhode_spatial::UnitVector;
use thiserror::Error;

/// Smallest length of a shape, m. Below it products of four lengths, as areas squared, leave the range of f64.
pub const SMALLEST_LENGTH: f64 = 1e-60;
/// Largest coordinate of a shape, m, for the same reason.
pub const LARGEST_LENGTH: f64 = 1e60;

/// Why numbers make no shape.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ShapeError {
    /// A number is NaN, infinite, or beyond [`LARGEST_LENGTH`].
    #[error("{what} is {value}: a finite number of magnitude at most {LARGEST_LENGTH:e} m is needed")]
    NotFinite {
        /// What the number is.
        what: &'static str,
        /// The number.
        value: f64,
    },
    /// A length is not positive.
    #[error("{what} is {value} m: it must be at least {SMALLEST_LENGTH:e} m")]
    TooSmall {
        /// What the length is.
        what: &'static str,
        /// The length, m.
        value: f64,
    },
    /// Too few points.
    #[error("{count} points are given, at least {limit} are needed")]
    TooFewPoints {
        /// How many were given.
        count: usize,
        /// How many are needed.
        limit: usize,
    },
    /// Too many elements for the indices.
    #[error("{count} points are given, at most {limit} are possible")]
    TooManyPoints {
        /// How many were given.
        count: usize,
        /// How many are possible.
        limit: usize,
    },
    /// The points lie in a plane, on a line or in one place, or so nearly that they enclose no volume.
    #[error(
        "the points are flat: their thickness is {thickness:e} m, at least {limit:e} m (relative to their size) is needed"
    )]
    Flat {
        /// Extent along the thinnest direction, m.
        thickness: f64,
        /// Least extent, m.
        limit: f64,
    },
    /// The convex hull of the points could not be built.
    #[error("no convex hull of {points} points: {reason}; give the faces as a mesh instead")]
    Hull {
        /// How many points there were.
        points: usize,
        /// What went wrong.
        reason: String,
    },
    /// A vertex stands outside a face.
    #[error(
        "not convex: vertex {vertex} stands {height:e} m outside the plane of face {face}, at most {limit:e} m is \
         allowed; decompose the mesh or use the convex hull of its points"
    )]
    NotConvex {
        /// The vertex.
        vertex: usize,
        /// The face.
        face: usize,
        /// How far it stands outside, m.
        height: f64,
        /// How far it may, m.
        limit: f64,
    },
    /// The vertices of a face do not lie in one plane.
    #[error("face {face} is not plane: vertex {vertex} is {distance:e} m off, at most {limit:e} m is allowed")]
    FaceNotPlane {
        /// The face.
        face: usize,
        /// The vertex.
        vertex: usize,
        /// Its distance from the plane, m.
        distance: f64,
        /// The largest distance allowed, m.
        limit: f64,
    },
    /// The faces do not close a simple surface.
    #[error(
        "the faces do not close a surface like a sphere's: {vertices} vertices - {edges} edges + {faces} faces must be 2 ({reason})"
    )]
    NotClosed {
        /// How many vertices the faces use.
        vertices: usize,
        /// How many edges they have.
        edges: usize,
        /// How many faces there are.
        faces: usize,
        /// What is wrong.
        reason: &'static str,
    },
}

/// A ball.
#[derive(Debug, Clone, PartialEq)]
pub struct Sphere {
    pub(crate) center: DVec3,
    pub(crate) radius: f64,
}

impl Sphere {
    /// With its centre at a place in the body's frame, m.
    ///
    /// # Errors
    /// When the radius is not positive or a number is not finite.
    pub fn new(center: DVec3, radius: f64) -> Result<Self, ShapeError> {
        check_length("radius", radius)?;
        check_point("centre", center)?;
        Ok(Self { center, radius })
    }

    /// Centre in the body's frame, m.
    pub const fn center(&self) -> DVec3 {
        self.center
    }

    /// Radius, m.
    pub const fn radius(&self) -> f64 {
        self.radius
    }
}

/// All points `x` with `normal . x <= offset`: a floor that fills everything below its surface.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfSpace {
    pub(crate) normal: DVec3,
    pub(crate) offset: f64,
}

impl HalfSpace {
    /// With the outward normal of its surface and the surface's signed distance from the frame's origin, m.
    ///
    /// # Errors
    /// When the offset is not finite.
    pub fn new(normal: UnitVector, offset: f64) -> Result<Self, ShapeError> {
        check_finite("offset", offset)?;
        Ok(Self { normal: normal.get(), offset })
    }

    /// Outward unit normal in the body's frame.
    pub const fn normal(&self) -> DVec3 {
        self.normal
    }

    /// Signed distance of the surface from the frame's origin along the normal, m.
    pub const fn offset(&self) -> f64 {
        self.offset
    }
}

/// Points that are fixed to each other: they touch faces, edges, vertices and spheres, never each other.
#[derive(Debug, Clone, PartialEq)]
pub struct PointCloud {
    pub(crate) points: Vec<DVec3>,
    size: f64,
}

impl PointCloud {
    /// From positions in the body's frame, m.
    ///
    /// # Errors
    /// When there is no point, more than 2^32 - 1, or a coordinate is not finite.
    pub fn new(points: Vec<DVec3>) -> Result<Self, ShapeError> {
        if points.is_empty() {
            return Err(ShapeError::TooFewPoints { count: 0, limit: 1 });
        }
        if u32::try_from(points.len()).is_err() {
            return Err(ShapeError::TooManyPoints { count: points.len(), limit: u32::MAX as usize });
        }
        for &point in &points {
            check_point("point", point)?;
        }
        let size = largest_distance(&points);
        Ok(Self { points, size })
    }

    /// Positions in the body's frame, m.
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }
}

/// A shape in its body's frame. Kinds will be added; match with a wildcard.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
#[allow(clippy::large_enum_variant, reason = "polyhedra are the common case, and a box would cost every query a jump")]
pub enum Shape {
    /// A convex polyhedron; a box is one.
    Convex(ConvexPolyhedron),
    /// A ball.
    Sphere(Sphere),
    /// A plane with everything below it.
    HalfSpace(HalfSpace),
    /// Points.
    Points(PointCloud),
}

impl Shape {
    /// A box about the origin with full edge lengths, m.
    ///
    /// # Errors
    /// When a length is not positive and finite.
    pub fn cuboid(size: DVec3) -> Result<Self, ShapeError> {
        ConvexPolyhedron::cuboid(size).map(Self::Convex)
    }

    /// A convex polyhedron.
    pub const fn convex(polyhedron: ConvexPolyhedron) -> Self {
        Self::Convex(polyhedron)
    }

    /// A ball about the origin, m.
    ///
    /// # Errors
    /// When the radius is not positive and finite.
    pub fn sphere(radius: f64) -> Result<Self, ShapeError> {
        Sphere::new(DVec3::ZERO, radius).map(Self::Sphere)
    }

    /// Everything below the plane through the origin with this outward normal.
    pub const fn half_space(normal: UnitVector) -> Self {
        Self::HalfSpace(HalfSpace { normal: normal.get(), offset: 0.0 })
    }

    /// Points at these places, m.
    ///
    /// # Errors
    /// When there are none or a coordinate is not finite.
    pub fn points(points: Vec<DVec3>) -> Result<Self, ShapeError> {
        PointCloud::new(points).map(Self::Points)
    }

    /// The same shape moved by a vector, m: brings a shape given about a body's origin into the central frame.
    ///
    /// # Errors
    /// When a coordinate becomes too large or is not finite.
    pub fn translated(&self, by: DVec3) -> Result<Self, ShapeError> {
        check_point("translation", by)?;
        match self {
            Self::Convex(polyhedron) => polyhedron.translated(by).map(Self::Convex),
            Self::Sphere(s) => Sphere::new(s.center + by, s.radius).map(Self::Sphere),
            Self::HalfSpace(h) => {
                let offset = h.offset + h.normal.dot(by);
                check_finite("offset", offset)?;
                Ok(Self::HalfSpace(HalfSpace { normal: h.normal, offset }))
            }
            Self::Points(c) => Self::points(c.points.iter().map(|&p| p + by).collect()),
        }
    }

    /// Largest distance between two points of the shape, m; 0 for a half-space, whose extent says nothing.
    pub fn size(&self) -> f64 {
        match self {
            Self::Convex(polyhedron) => polyhedron.size(),
            Self::Sphere(s) => 2.0 * s.radius,
            Self::HalfSpace(_) => 0.0,
            Self::Points(c) => c.size,
        }
    }

    /// Largest distance of a point of the shape from the frame's origin, m; infinite for a half-space.
    pub fn radius(&self) -> f64 {
        if let Self::HalfSpace(_) = self {
            return f64::INFINITY;
        }
        let (centers, rounding) = self.centers();
        centers.iter().map(|c| c.length()).fold(0.0, f64::max) + rounding
    }

    /// The shape as the convex hull of points, blown up by a radius, m; no points for a half-space.
    pub(crate) fn centers(&self) -> (&[DVec3], f64) {
        match self {
            Self::Convex(polyhedron) => (polyhedron.vertices(), 0.0),
            Self::Sphere(s) => (std::slice::from_ref(&s.center), s.radius),
            Self::HalfSpace(_) => (&[], 0.0),
            Self::Points(c) => (&c.points, 0.0),
        }
    }
}

/// Up to this many points the largest distance is found over all pairs; beyond it the diagonal of the bounding box,
/// which is at most sqrt(3) times too large, stands in. The value only scales tolerances.
const EXACT_SIZE_LIMIT: usize = 1024;

/// Largest distance between two of some points, m.
pub(crate) fn largest_distance(points: &[DVec3]) -> f64 {
    if points.len() > EXACT_SIZE_LIMIT {
        let (low, high) = points.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(l, h), &p| (l.min(p), h.max(p)));
        return (high - low).length();
    }
    let mut largest: f64 = 0.0;
    for (i, a) in points.iter().enumerate() {
        for b in &points[i + 1..] {
            largest = largest.max(a.distance_squared(*b));
        }
    }
    largest.sqrt()
}

/// A finite number that is not too large.
pub(crate) fn check_finite(what: &'static str, value: f64) -> Result<(), ShapeError> {
    // The negated comparison also refuses NaN.
    if value.abs() <= LARGEST_LENGTH { Ok(()) } else { Err(ShapeError::NotFinite { what, value }) }
}

/// A finite point that is not too far away.
pub(crate) fn check_point(what: &'static str, point: DVec3) -> Result<(), ShapeError> {
    point.to_array().into_iter().try_for_each(|c| check_finite(what, c))
}

/// A positive finite length.
pub(crate) fn check_length(what: &'static str, value: f64) -> Result<(), ShapeError> {
    check_finite(what, value)?;
    if value >= SMALLEST_LENGTH { Ok(()) } else { Err(ShapeError::TooSmall { what, value }) }
}
