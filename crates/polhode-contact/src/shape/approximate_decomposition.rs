//! Approximate convex decomposition: few convex parts that nearly fill a solid.
//!
//! V-HACD (docs/REFERENCES.md, Mamou) as implemented in parry3d: the solid is filled with voxels, these are split by
//! axis-aligned planes until each part is nearly convex, and each part is replaced by the hull of its surface. The
//! parts extend into dents, omit what is thinner than a voxel, fill voids, and overlap where their hulls do; the
//! overlap is not measured. The volume of all parts is compared with that of the solid. Where the parts must be exact,
//! and for few reflex edges, use [`convex_decomposition`](polhode_mesh::convex_decomposition).
//!
//! The library has tolerances in metres, so it is given the solid scaled to size one; the result does not depend on the
//! units. Time and memory grow as the cube of the resolution.

use crate::backend::{ClusterSettings, convex_clusters};
use glam::DVec3;
use polhode_mesh::{ConvexHull, ConvexSolid, SolidMesh};
use thiserror::Error;

/// Limits of the cost and the error of an approximate decomposition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ApproximateSettings {
    /// Largest concavity of a part: the volume between its voxels and their hull relative to the hull of the whole,
    /// from 0 to 1. The default is 0.01.
    pub concavity: f64,
    /// Voxels along the longest side, from 8 to 512; the default is 64.
    pub resolution: u32,
    /// Most parts, from 1 to 4096; the default is 256. The library halves parts, so it may stop at up to twice as many.
    pub max_parts: u32,
}

impl Default for ApproximateSettings {
    fn default() -> Self {
        Self { concavity: 0.01, resolution: 64, max_parts: 256 }
    }
}

/// Why a solid could not be decomposed.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum ApproximateError {
    /// The concavity is out of its range.
    #[error("the concavity must be from 0 to 1, found {0}")]
    Concavity(f64),
    /// The resolution is out of its range.
    #[error("the resolution must be from {low} to {high} voxels, found \
        {0}", low = RESOLUTIONS[0], high = RESOLUTIONS[1])]
    Resolution(u32),
    /// The number of parts is out of its range.
    #[error("the number of parts must be from {low} to {high}, found {0}", low = PARTS[0], high = PARTS[1])]
    MaxParts(u32),
    /// The library failed, or found no part that has a volume.
    #[error("V-HACD found no parts: try another resolution, or the exact decomposition")]
    NoParts,
}

/// Fewest and most voxels along the longest side; 512 need about a gigabyte.
const RESOLUTIONS: [u32; 2] = [8, 512];

/// Fewest and most parts.
const PARTS: [u32; 2] = [1, 4096];

/// Convex parts that nearly fill a solid.
#[derive(Debug, Clone, PartialEq)]
pub struct ApproximateDecomposition {
    /// The parts, in the order of the library.
    pub parts: Vec<ConvexSolid>,
    /// Sum of the volumes of the parts, m^3; regions where parts overlap are counted for each of them.
    pub volume: f64,
    /// Difference from the volume of the solid, relative to it.
    pub volume_error: f64,
    /// Number of parts omitted because they are flat.
    pub flat_parts: usize,
}

/// Decomposes a solid into convex solids that nearly fill it; a convex solid is its only part.
///
/// ```
/// use polhode_contact::{ApproximateSettings, DVec3, approximate_decomposition};
/// use polhode_contact::mesh::box_mesh;
/// let brick = box_mesh(DVec3::new(1.0, 2.0, 3.0))?;
/// let found = approximate_decomposition(&brick, ApproximateSettings::default())?;
/// assert!(found.parts.len() == 1 && found.volume_error.abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ApproximateError`] for settings out of their ranges, and when the library fails.
pub fn approximate_decomposition(
    solid: &SolidMesh,
    settings: ApproximateSettings,
) -> Result<ApproximateDecomposition, ApproximateError> {
    let ApproximateSettings { concavity, resolution, max_parts } = settings;
    if !(0.0..=1.0).contains(&concavity) {
        return Err(ApproximateError::Concavity(concavity));
    }
    if !(RESOLUTIONS[0]..=RESOLUTIONS[1]).contains(&resolution) {
        return Err(ApproximateError::Resolution(resolution));
    }
    if !(PARTS[0]..=PARTS[1]).contains(&max_parts) {
        return Err(ApproximateError::MaxParts(max_parts));
    }
    if let Ok(part) = ConvexSolid::new(solid.clone()) {
        let volume = part.volume_integrals().volume;
        return Ok(ApproximateDecomposition { parts: vec![part], volume, volume_error: 0.0, flat_parts: 0 });
    }
    let mesh = solid.mesh();
    let (center, size) = (mesh.bounds().center(), mesh.bounds().diagonal());
    let scaled: Vec<DVec3> = mesh.vertices().iter().map(|&v| (v - center) / size).collect();
    let clusters = convex_clusters(&scaled, mesh.triangles(), &ClusterSettings { concavity, resolution, max_parts })
        .ok_or(ApproximateError::NoParts)?;
    let count = clusters.len();
    let parts: Vec<ConvexSolid> = clusters
        .into_iter()
        .filter_map(|cluster| {
            let points: Vec<DVec3> = cluster.into_iter().map(|p| center + p * size).collect();
            ConvexHull::of(&points).ok().map(ConvexHull::into_solid)
        })
        .collect();
    if parts.is_empty() {
        return Err(ApproximateError::NoParts);
    }
    let volume: f64 = parts.iter().map(|part| part.volume_integrals().volume).sum();
    let whole = solid.volume_integrals().volume;
    let flat_parts = count - parts.len();
    Ok(ApproximateDecomposition { parts, volume, volume_error: (volume - whole) / whole, flat_parts })
}
