//! Why a snapshot is refused.

use crate::Effects;
use thiserror::Error;

/// Why bytes are no snapshot, or a snapshot is none of this simulation.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SnapshotError {
    /// The bytes are of something else.
    #[error("these bytes are no snapshot of a simulation: they do not begin as one does")]
    NotASnapshot,
    /// The format is of another version.
    #[error(
        "the snapshot is of format {found}, and this version reads format {known}: make it anew by running the scene"
    )]
    Version {
        /// The format of the bytes.
        found: u32,
        /// The format that can be read.
        known: u32,
    },
    /// Bytes are missing, or there are too many.
    #[error("the snapshot should have {expected} bytes and has {found}: it was not written or copied completely")]
    Length {
        /// The bytes that belong to it.
        expected: u64,
        /// The bytes given.
        found: u64,
    },
    /// Bytes have changed since they were written.
    #[error("the snapshot has been altered or damaged: its checksum does not fit its bytes")]
    Damaged,
    /// The bytes are whole but say nothing that can be read.
    #[error("the content of the snapshot cannot be read: {0}")]
    Unreadable(String),
    /// It was taken of another scene.
    #[error(
        "the snapshot is of scene {scene:?} with the hash {found:016x}, and the simulation's has {own:016x}: restore it \
         into a simulation of the same scene, with the same method, duration and output"
    )]
    OtherScene {
        /// Name of the scene that it was taken of.
        scene: String,
        /// Hash of that scene.
        found: u64,
        /// Hash of the simulation's scene.
        own: u64,
    },
    /// It was taken with other effects.
    #[error("the snapshot was taken with the effects {found:?}, and the simulation was made with {own:?}")]
    OtherEffects {
        /// Effects of the snapshot.
        found: Effects,
        /// Effects of the simulation.
        own: Effects,
    },
    /// It contains what no run can have written.
    #[error("the snapshot contradicts itself or its scene: {0}")]
    Invalid(&'static str),
}
