//! Why a mesh file could not be used.

use polhode::mesh::{MeshFormat, ReadError};
use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// Why a mesh file could not be used.
#[derive(Debug, Error)]
pub enum MeshFileError {
    /// The file could not be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The file is too large.
    #[error("{} is larger than {limit} bytes", path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// The largest size accepted, bytes.
        limit: u64,
    },
    /// Neither the ending of the name nor the content is that of a format.
    #[error("{}: this is no mesh file: accepted are {}, by the ending of the name or by \
        content", path.display(), MeshFormat::LIST)]
    Format {
        /// The file.
        path: PathBuf,
    },
    /// The content is not that of the format.
    #[error("{}: {source}", path.display())]
    Content {
        /// The file.
        path: PathBuf,
        /// What is wrong, with its line or byte.
        source: ReadError,
    },
}
