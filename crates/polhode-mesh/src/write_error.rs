//! Why a mesh cannot be written.

use crate::mesh_format::MeshFormat;
use glam::DVec3;
use thiserror::Error;

/// Why a mesh cannot be written.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum WriteError {
    /// A coordinate is too large for f32, which binary STL has.
    #[error(
        "vertex {vertex} is ({}, {}, {}), which f32 cannot hold: write STL as text, or another format",
        .position.x, .position.y, .position.z
    )]
    BeyondF32 {
        /// The vertex.
        vertex: u32,
        /// Its position, m.
        position: DVec3,
    },
    /// The format is text.
    #[error("{0} has no binary encoding: write text")]
    NoBinary(MeshFormat),
}
