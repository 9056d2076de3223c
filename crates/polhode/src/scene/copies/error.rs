//! Why a scene cannot be set otherwise.

use crate::scene::SceneError;
use polhode_contact::ShapeError;
use polhode_mesh::MeshError;
use polhode_spatial::curve::CurveError;
use thiserror::Error;

/// Why a scene cannot be set otherwise.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum CopyError {
    /// A force is a field of the program.
    #[error(
        "force number {0} (counted from 0) is a field that the program defines, and what it would be elsewhere is not \
         known"
    )]
    Field(usize),
    /// What an impact does depends on the numbers of the bodies.
    #[error(
        "impact = \"propagation\" strikes contacts in the order of the numbers of their bodies, which another order \
         of the bodies would change"
    )]
    StruckByNumber,
    /// What an impact does depends on the digits of the velocities.
    #[error(
        "propagation_order = {{ random }} draws the order of the contacts of an impact from the digits of the \
         velocities, which are others in other axes"
    )]
    StruckAtRandom,
    /// A shape has no mirror image.
    #[error("the shape of body {body} cannot be mirrored: {source}")]
    Shape {
        /// The body.
        body: String,
        /// Why.
        source: ShapeError,
    },
    /// A mesh has no mirror image.
    #[error("the mesh of body {body} cannot be mirrored: {source}")]
    Mesh {
        /// The body.
        body: String,
        /// Why.
        source: MeshError,
    },
    /// A track does not keep its form elsewhere.
    #[error("track number {number} (counted from 0) cannot be set otherwise: {source}")]
    Track {
        /// Its number.
        number: usize,
        /// Why.
        source: CurveError,
    },
    /// The scene set otherwise is refused.
    #[error("the scene set otherwise is refused: {0}")]
    Scene(#[from] SceneError),
}
