//! Errors of snapshots: why bytes cannot be read, or a simulation refuses to restore them.

use crate::scene::effects::Effects;
use thiserror::Error;

/// Why bytes are not a snapshot, or why a snapshot does not belong to a simulation.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SnapshotError {
    /// The bytes are not those of a snapshot.
    #[error("these bytes are not a snapshot of a simulation: they do not begin with its magic word")]
    NotASnapshot,
    /// The snapshot has another version of the format.
    #[error(
        "the snapshot has format {found}, and this version of the program reads format {known}: run the scene again \
         from its start"
    )]
    Version {
        /// Version of the format of the bytes.
        found: u32,
        /// Version of the format that can be read.
        known: u32,
    },
    /// Bytes are missing, or there are too many.
    #[error(
        "the snapshot should have {expected} bytes and has {found}: it was not written or copied completely; copy it \
         again"
    )]
    Length {
        /// How many bytes it should have.
        expected: u64,
        /// How many bytes there are.
        found: u64,
    },
    /// Bytes have changed since they were written.
    #[error("the snapshot has been altered or damaged: the checksum in it is not that of its bytes")]
    Damaged,
    /// The checksum is right, but the content cannot be decoded.
    #[error("the content of the snapshot cannot be decoded: {0}")]
    Unreadable(String),
    /// The snapshot was taken from another scene.
    #[error(
        "the snapshot is of scene {scene:?} with the hash {found:016x}, and the scene of the simulation has the hash \
         {own:016x}: restore it into a simulation of the same scene, with the same method, duration and output interval"
    )]
    OtherScene {
        /// Name of the scene that it was taken from.
        scene: String,
        /// Hash of that scene.
        found: u64,
        /// Hash of the simulation's scene.
        own: u64,
    },
    /// The simulation was made with other effects than the snapshot.
    #[error(
        "the snapshot was taken with the effects {found:?}, and the simulation was made with {own:?}: make the \
         simulation with Effects::{found:?}"
    )]
    OtherEffects {
        /// Effects of the snapshot.
        found: Effects,
        /// Effects of the simulation.
        own: Effects,
    },
    /// The content contradicts itself or the scene, as no snapshot of a run does.
    #[error("the snapshot contradicts itself or its scene: {0}")]
    Invalid(&'static str),
}
