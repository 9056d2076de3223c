//! Mesh files.

use crate::error::MeshFileError;
use polhode::mesh::{TriangleMesh, obj};
use std::path::{Path, PathBuf};

/// Largest mesh file read, bytes: some ten million triangles, beyond which a text file is the wrong way.
pub const LARGEST_MESH_FILE: u64 = 1 << 30;

/// Where the mesh files of a scene are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct MeshFolder(PathBuf);

impl MeshFolder {
    /// The folder of a scene file.
    pub(crate) fn beside(scene: &Path) -> Self {
        Self(scene.parent().map(Path::to_owned).unwrap_or_default())
    }

    /// Reads a mesh file named relative to the folder.
    pub(crate) fn read(&self, file: &str) -> Result<TriangleMesh, MeshFileError> {
        read_mesh(&self.0.join(file))
    }
}

/// Reads a triangle mesh from a Wavefront OBJ file; lengths in m.
///
/// # Errors
/// When the file cannot be read, is too large, is not named `.obj`, or its content is refused.
pub fn read_mesh(path: &Path) -> Result<TriangleMesh, MeshFileError> {
    let is_obj = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("obj"));
    if !is_obj {
        return Err(MeshFileError::Ending { path: path.to_owned() });
    }
    let bytes = crate::read::bounded(path, LARGEST_MESH_FILE).map_err(|fault| match fault {
        crate::read::Fault::Io(source) => MeshFileError::Read { path: path.to_owned(), source },
        crate::read::Fault::TooLarge => MeshFileError::TooLarge { path: path.to_owned(), limit: LARGEST_MESH_FILE },
    })?;
    obj::read(&bytes).map_err(|source| MeshFileError::Content { path: path.to_owned(), source })
}
