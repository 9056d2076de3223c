//! Mesh files.

use crate::mesh_file_error::MeshFileError;
use polhode::mesh::{MeshFormat, TriangleMesh, format};
use std::io;
use std::path::{Path, PathBuf};

/// Largest mesh file read, bytes: some ten million triangles, beyond which a text file is the wrong way.
pub const LARGEST_MESH_FILE: u64 = 1 << 30;

/// Where the mesh files of a scene are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum MeshFolder {
    /// In a folder.
    Disk(PathBuf),
    /// With the text of the scene, by name.
    Inside(&'static [(&'static str, &'static [u8])]),
}

impl MeshFolder {
    /// The folder of a scene file.
    pub(crate) fn beside(scene: &Path) -> Self {
        Self::Disk(scene.parent().map(Path::to_owned).unwrap_or_default())
    }

    /// Files that are there without a folder.
    pub(crate) fn inside(files: &'static [(&'static str, &'static [u8])]) -> Self {
        Self::Inside(files)
    }

    /// The path of a mesh file; none when it is in no folder.
    pub(crate) fn path(&self, file: &str) -> Option<PathBuf> {
        match self {
            Self::Disk(folder) => Some(folder.join(file)),
            Self::Inside(_) => None,
        }
    }

    /// Reads a mesh file named relative to the folder.
    pub(crate) fn read(&self, file: &str) -> Result<TriangleMesh, MeshFileError> {
        match self {
            Self::Disk(folder) => read_mesh(&folder.join(file)),
            Self::Inside(files) => {
                let found = files.iter().find(|(name, _)| *name == file);
                let missing = || io::Error::new(io::ErrorKind::NotFound, "it is not among the files of the example");
                let (_, bytes) =
                    found.ok_or_else(|| MeshFileError::Read { path: PathBuf::from(file), source: missing() })?;
                parsed(Path::new(file), bytes)
            }
        }
    }
}

/// Reads a triangle mesh from an OBJ, STL, OFF or PLY file; lengths in m. The ending of its name says the format, and
/// where it says none the content does.
///
/// # Errors
/// When the file cannot be read, is too large, is in no known format, or its content is refused.
pub fn read_mesh(path: &Path) -> Result<TriangleMesh, MeshFileError> {
    let bytes = crate::read::bounded(path, LARGEST_MESH_FILE).map_err(|fault| match fault {
        crate::read::Fault::Io(source) => MeshFileError::Read { path: path.to_owned(), source },
        crate::read::Fault::TooLarge => MeshFileError::TooLarge { path: path.to_owned(), limit: LARGEST_MESH_FILE },
    })?;
    parsed(path, &bytes)
}

/// The mesh in a file of this name.
fn parsed(path: &Path, bytes: &[u8]) -> Result<TriangleMesh, MeshFileError> {
    let format = MeshFormat::of_path(path)
        .or_else(|| MeshFormat::of_content(bytes))
        .ok_or_else(|| MeshFileError::Format { path: path.to_owned() })?;
    format::read(bytes, format).map_err(|source| MeshFileError::Content { path: path.to_owned(), source })
}
