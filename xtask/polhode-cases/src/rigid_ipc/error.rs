//! Why a scene cannot be taken over.

use polhode::mesh::MeshError;
use polhode_scene::MeshFileError;
use std::path::PathBuf;

/// Why a scene of the suite cannot be turned into one of ours.
#[derive(Debug, thiserror::Error)]
pub enum ImportError {
    /// The file cannot be read.
    #[error("{}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A file of the result cannot be written.
    #[error("{}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// The file is no JSON.
    #[error("{}: {source}", path.display())]
    Json {
        /// The file.
        path: PathBuf,
        /// Why, with line and column.
        source: serde_json::Error,
    },
    /// A key has a value that is not understood, or one that is needed is absent.
    #[error("{}: {key}: {message}", path.display())]
    Key {
        /// The file.
        path: PathBuf,
        /// Where in it.
        key: String,
        /// What was found and what is accepted.
        message: String,
    },
    /// A mesh file is not there.
    #[error("{}: {key}: no file `{mesh}` beside the scene or in a folder `meshes` above it: name its folder with \
        --meshes", path.display())]
    NoMesh {
        /// The scene file.
        path: PathBuf,
        /// Where in it.
        key: String,
        /// The mesh file that it names.
        mesh: String,
    },
    /// A mesh file is refused.
    #[error(transparent)]
    MeshFile(#[from] MeshFileError),
    /// A mesh is refused.
    #[error("{}: {key}: {source}", path.display())]
    Mesh {
        /// The scene file.
        path: PathBuf,
        /// Where in it.
        key: String,
        /// Why.
        source: MeshError,
    },
    /// The result cannot be written as TOML.
    #[error("the scene cannot be written: {0}")]
    Text(#[from] toml::ser::Error),
}
