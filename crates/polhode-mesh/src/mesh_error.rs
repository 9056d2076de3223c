//! Why numbers are no mesh, or a mesh no solid.

use crate::defect::Defect;
use glam::DVec3;
use polhode_spatial::MassPropertiesError;
use thiserror::Error;

/// Why numbers are no mesh, or a mesh no solid. Indices count from 0.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MeshError {
    /// There is no triangle.
    #[error("the mesh has no triangles")]
    Empty,
    /// More vertices or triangles than 32-bit indices can name.
    #[error("the mesh has {vertices} vertices and {triangles} triangles, at most {} of each are possible", u32::MAX)]
    TooLarge {
        /// Number of vertices.
        vertices: usize,
        /// Number of triangles.
        triangles: usize,
    },
    /// A coordinate is NaN or infinite, or became so when the mesh was moved.
    #[error("vertex {index} is ({}, {}, {}), every coordinate must be finite", .position.x, .position.y, .position.z)]
    NotFinite {
        /// The vertex.
        index: usize,
        /// Its position.
        position: DVec3,
    },
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} names vertex {index}, but the mesh has {vertices} vertices (counted from 0)")]
    IndexOutOfRange {
        /// The triangle.
        triangle: usize,
        /// The index it names.
        index: u32,
        /// Number of vertices.
        vertices: usize,
    },
    /// A factor that is not positive and finite.
    #[error("a mesh can be scaled by a positive, finite factor only, found {0}")]
    Factor(f64),
    /// A distance within which vertices are merged that is negative, NaN or infinite.
    #[error("vertices are merged within a distance that is finite and at least 0 m, found {0} m")]
    Tolerance(f64),
    /// A largest hole that is no fraction.
    #[error("the largest hole to fill is a fraction of the mesh's diagonal from 0 to 1, found {0}")]
    HoleSize(f64),
    /// The surface does not part space into inside and outside, or is inside out.
    #[error("the mesh bounds no solid: {} (indices count from 0)", list(.0))]
    NotSolid(Vec<Defect>),
    /// The surface is open along seams, at which vertices are doubled, as textured files have them: merged, they make
    /// it a solid.
    #[error(
        "the mesh bounds no solid: {} (indices count from 0); its vertices are doubled at seams, {}",
        list(.defects), seams(*.distance_m)
    )]
    Seams {
        /// What prevents a solid.
        defects: Vec<Defect>,
        /// Distance within which vertices must be merged, m; zero where doubled ones are equal.
        distance_m: f64,
    },
    /// The surface is closed but encloses nothing that rounding of its coordinates could not make.
    #[error(
        "the mesh encloses a volume of {volume} m^3 under an area of {area} m^2: it is flat, or too small or large for \
         f64"
    )]
    NoVolume {
        /// Signed volume, m^3.
        volume: f64,
        /// Area, m^2.
        area: f64,
    },
    /// The triangles have no area.
    #[error("the triangles have a total area of {0} m^2: they are degenerate, or too small or large for f64")]
    NoArea(f64),
    /// The integrals are no mass properties (a rod without thickness, numbers beyond f64).
    #[error(transparent)]
    MassProperties(#[from] MassPropertiesError),
}

/// How far doubled vertices are apart.
fn seams(distance_m: f64) -> String {
    if distance_m == 0.0 {
        "as those of textured files are".to_owned()
    } else {
        format!("up to {distance_m:e} m apart")
    }
}

/// The defects in one line.
fn list(defects: &[Defect]) -> String {
    defects.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}
