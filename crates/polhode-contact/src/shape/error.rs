//! Errors of the constructors of shapes, and the checks of single numbers.

use glam::DVec3;
use polhode_mesh::DecompositionError;
use thiserror::Error;

/// Smallest length of a shape, m. Below it products of four lengths, such as squared areas, underflow.
pub const SMALLEST_LENGTH: f64 = 1e-60;
/// Largest coordinate of a shape, m; above it such products overflow.
pub const LARGEST_LENGTH: f64 = 1e60;

/// Why a shape cannot be made from the given numbers.
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
    /// A length is less than [`SMALLEST_LENGTH`].
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
    /// Too many vertices, edges, faces or triangles for 32-bit indices.
    #[error("{count} vertices, edges, faces or triangles are given, at most {limit} are possible")]
    TooManyPoints {
        /// How many were given.
        count: usize,
        /// How many are possible.
        limit: usize,
    },
    /// The points are coplanar, collinear or coincident, or so nearly so that they enclose no volume.
    #[error(
        "the points are flat: their thickness is {thickness:e} m, and a polyhedron of this size needs at least \
         {limit:e} m"
    )]
    Flat {
        /// Extent along the thinnest direction, m.
        thickness: f64,
        /// Least extent, m.
        limit: f64,
    },
    /// A vertex is outside the plane of a face.
    #[error(
        "not convex: vertex {vertex} is {height:e} m outside the plane of face {face}, at most {limit:e} m is \
         allowed; decompose the mesh or use the convex hull of its points"
    )]
    NotConvex {
        /// The vertex.
        vertex: usize,
        /// The face.
        face: usize,
        /// Its distance from the plane, m.
        height: f64,
        /// The largest distance allowed, m.
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
    /// The tube of a torus closes its hole.
    #[error("minor radius {minor} m must be less than the major radius {major} m: the tube would close the hole")]
    NoHole {
        /// Radius of the centre circle of the tube, m.
        major: f64,
        /// Radius of the tube, m.
        minor: f64,
    },
    /// A mesh without triangles or a compound without parts.
    #[error("no {what} are given, at least one is needed")]
    NoPart {
        /// What is missing.
        what: &'static str,
    },
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} names vertex {vertex}, but there are only {vertices} vertices (counted from 0)")]
    NoSuchVertex {
        /// The triangle.
        triangle: usize,
        /// The vertex that it names.
        vertex: u32,
        /// How many there are.
        vertices: usize,
    },
    /// A triangle without area.
    #[error(
        "triangle {triangle} has no area: its height is {height:e} m over a side of {longest:e} m (counted from 0); \
         remove it"
    )]
    NoArea {
        /// The triangle.
        triangle: usize,
        /// Its least height, m.
        height: f64,
        /// Its longest side, m.
        longest: f64,
    },
    /// A triangle that is given twice.
    #[error("triangle {triangle} has the same corners as triangle {of} (counted from 0); remove one")]
    Double {
        /// The triangle.
        triangle: usize,
        /// The earlier one.
        of: usize,
    },
    /// A shape that cannot be a part of a compound.
    #[error("{what} cannot be a part of a compound: give it a body of its own")]
    NotAPart {
        /// What was given.
        what: &'static str,
    },
    /// A solid that is not convex could not be decomposed.
    #[error(transparent)]
    Decomposition(#[from] DecompositionError),
    /// A convex part of a solid has no polyhedron.
    #[error(
        "convex part {part} of {parts}, {size:e} m large at ({}, {}, {}) m, is refused: {reason}. Weld or repair the \
         mesh there, or let its parts be approximate",
        .at.x, .at.y, .at.z
    )]
    Part {
        /// The part, counted from 1.
        part: usize,
        /// How many there are.
        parts: usize,
        /// The centre of its bounding box, m.
        at: DVec3,
        /// The diagonal of its bounding box, m.
        size: f64,
        /// Why it has none.
        reason: Box<Self>,
    },
    /// The faces do not close a simple surface.
    #[error(
        "the faces do not close a surface like a sphere's: {reason} ({vertices} vertices, {edges} edges, {faces} faces)"
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
