//! Why a primitive, its mass properties or its mesh does not exist, and the checks of lengths that say so.

use crate::triangle_mesh::MeshError;
use glam::DVec3;
use polhode_spatial::MassPropertiesError;
use thiserror::Error;

/// Most halvings of the edges of a mesh: [`Refinement::FINEST`](super::Refinement::FINEST).
pub(super) const MOST_HALVINGS: u32 = 8;

/// Why a primitive, its mass properties or its mesh does not exist.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum PrimitiveError {
    /// An edge is not positive and finite.
    #[error("the edges of a box must be positive and finite, found ({}, {}, {}) m", .0.x, .0.y, .0.z)]
    Size(DVec3),
    /// The radius is not positive and finite.
    #[error("a radius must be positive and finite, found {0} m")]
    Radius(f64),
    /// The height is not positive and finite.
    #[error("a height must be positive and finite, found {0} m")]
    Height(f64),
    /// A semi-axis is not positive and finite.
    #[error("the semi-axes of an ellipsoid must be positive and finite, found ({}, {}, {}) m", .0.x, .0.y, .0.z)]
    SemiAxes(DVec3),
    /// The tube closes the hole.
    #[error("the tube of a torus (radius {minor} m) must be thinner than its ring (radius {major} m)")]
    Tube {
        /// Radius of the ring, m.
        major: f64,
        /// Radius of the tube, m.
        minor: f64,
    },
    /// More refined than memory holds.
    #[error("a mesh can be refined {} times at the most, found {}", MOST_HALVINGS, .0)]
    Refinement(u32),
    /// Mass or inertia over- or underflow.
    #[error(transparent)]
    MassProperties(#[from] MassPropertiesError),
    /// The primitive is so thin that its mesh is flat to rounding.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// Whether a length is one.
fn is_length(length: f64) -> bool {
    length > 0.0 && length.is_finite()
}

/// `radius` (m), when it is positive and finite.
pub(super) fn checked_radius(radius: f64) -> Result<f64, PrimitiveError> {
    if is_length(radius) { Ok(radius) } else { Err(PrimitiveError::Radius(radius)) }
}

/// `height` (m), when it is positive and finite.
pub(super) fn checked_height(height: f64) -> Result<f64, PrimitiveError> {
    if is_length(height) { Ok(height) } else { Err(PrimitiveError::Height(height)) }
}
