//! Triangle meshes: an array of vertices and an array of triples of indices into it (thesis 3.2, Figure 8).
//!
//! The three vertices a, b, c of a triangle run anticlockwise seen from outside, so that `(b - a) x (c - a)` points
//! away from the material (thesis 3.2; the worked normal of its Figure 8 is that of c = (5, 0, 0), erratum E4).
//! A [`TriangleMesh`] is readable, no more: its numbers are finite and its indices exist. Whether it bounds a solid
//! is asked by [`diagnose`](crate::diagnose) and guaranteed by [`SolidMesh`](crate::SolidMesh).

pub use crate::mesh_error::MeshError;

use glam::DVec3;
use polhode_spatial::Pose;

/// Rounding of a length, relative to the largest coordinate (dimensionless): rounding three coordinates of two points
/// to f64 moves their distance by up to `2 sqrt(3) u = 3.5 u`, `u = 2^-53`; twice that leaves room for the arithmetic.
/// Whatever is smaller cannot be told from zero.
pub(crate) const COORDINATE_ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Vertices (m) and triangles of a surface, in the axes of the file or body they come from.
///
/// ```
/// use polhode_mesh::{DVec3, TriangleMesh};
/// let triangle = TriangleMesh::new(vec![DVec3::ZERO, DVec3::X, DVec3::Y], vec![[0, 1, 2]])?;
/// let [a, b, c] = triangle.corners(triangle.triangles()[0]);
/// assert_eq!((b - a).cross(c - a), DVec3::Z);
/// # Ok::<(), polhode_mesh::MeshError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct TriangleMesh {
    vertices: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
}

/// An axis-aligned box, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Smallest coordinates.
    pub min: DVec3,
    /// Largest coordinates.
    pub max: DVec3,
}

impl TriangleMesh {
    /// From positions (m) and triangles, anticlockwise seen from outside.
    ///
    /// # Errors
    /// [`MeshError::Empty`] without triangles, [`MeshError::TooLarge`], [`MeshError::IndexOutOfRange`],
    /// [`MeshError::NotFinite`].
    pub fn new(vertices: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        if triangles.is_empty() {
            return Err(MeshError::Empty);
        }
        if vertices.len().max(triangles.len()) > u32::MAX as usize {
            return Err(MeshError::TooLarge { vertices: vertices.len(), triangles: triangles.len() });
        }
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&index) = corners.iter().find(|&&index| index as usize >= vertices.len()) {
                return Err(MeshError::IndexOutOfRange { triangle, index, vertices: vertices.len() });
            }
        }
        Self::with_finite(vertices, triangles)
    }

    /// From positions that arithmetic may have overflowed and triangles that are known to be in range.
    fn with_finite(vertices: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        match vertices.iter().position(|v| !v.is_finite()) {
            Some(index) => Err(MeshError::NotFinite { index, position: vertices[index] }),
            None => Ok(Self { vertices, triangles }),
        }
    }

    /// Positions, m.
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// Indices of the corners of each triangle; all are in range.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Positions of the corners of one of this mesh's triangles, m; NaN for an index that is out of range.
    pub fn corners(&self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|index| self.vertices.get(index as usize).copied().unwrap_or(DVec3::NAN))
    }

    /// Positions of the corners of all triangles in order, m.
    pub fn corner_positions(&self) -> impl Iterator<Item = [DVec3; 3]> + '_ {
        self.triangles.iter().map(|&triangle| self.corners(triangle))
    }

    /// The box around the triangles. Vertices that no triangle uses do not count: they are no part of the surface.
    pub fn bounds(&self) -> Bounds {
        Bounds::of(self.corner_positions().flatten())
    }

    /// Every vertex moved by `offset` (m).
    ///
    /// # Errors
    /// [`MeshError::NotFinite`] when a coordinate overflows or `offset` is not finite.
    pub fn translated(&self, offset: DVec3) -> Result<Self, MeshError> {
        self.map(|v| v + offset)
    }

    /// In frame A, given the pose `X_AB` of the frame B that the mesh is in.
    ///
    /// # Errors
    /// [`MeshError::NotFinite`] when a coordinate overflows or `pose` is not finite.
    pub fn in_frame(&self, pose: &Pose) -> Result<Self, MeshError> {
        self.map(|v| pose.transform_point(v))
    }

    /// Every coordinate times `factor`.
    ///
    /// # Errors
    /// [`MeshError::Factor`] when `factor` is not positive and finite (a mirror image needs its triangles
    /// [flipped](Self::flipped) too), [`MeshError::NotFinite`] when a coordinate overflows.
    pub fn scaled(&self, factor: f64) -> Result<Self, MeshError> {
        if factor > 0.0 && factor.is_finite() { self.map(|v| v * factor) } else { Err(MeshError::Factor(factor)) }
    }

    /// The same surface turned inside out: every triangle runs the other way round.
    pub fn flipped(&self) -> Self {
        Self { vertices: self.vertices.clone(), triangles: self.triangles.iter().map(|&[a, b, c]| [a, c, b]).collect() }
    }

    fn map(&self, f: impl Fn(DVec3) -> DVec3) -> Result<Self, MeshError> {
        Self::with_finite(self.vertices.iter().map(|&v| f(v)).collect(), self.triangles.clone())
    }
}

impl Bounds {
    /// Around points; of none it is inside out (`min` infinite, `max` minus infinite).
    pub fn of(points: impl IntoIterator<Item = DVec3>) -> Self {
        points.into_iter().fold(Self { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY }, |b, p| Self {
            min: b.min.min(p),
            max: b.max.max(p),
        })
    }

    /// The middle, m: the local reference point of the integrals. Halved before it is added, so that it is finite.
    pub fn center(&self) -> DVec3 {
        0.5 * self.min + 0.5 * self.max
    }

    /// Length of the diagonal, m.
    pub fn diagonal(&self) -> f64 {
        (self.max - self.min).length()
    }

    /// Largest coordinate by magnitude, m: what rounding of the coordinates is relative to.
    pub fn largest_coordinate(&self) -> f64 {
        self.min.abs().max_element().max(self.max.abs().max_element())
    }

    /// Whether `point` lies in the box or on it.
    pub fn contains(&self, point: DVec3) -> bool {
        self.min.cmple(point).all() && point.cmple(self.max).all()
    }
}
