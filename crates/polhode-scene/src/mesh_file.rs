//! Mesh files.

use crate::files::{Fault, Files};
use crate::mesh_file_error::MeshFileError;
use polhode::mesh::{MeshFormat, TriangleMesh, format};
use std::path::Path;

/// Largest mesh file read, bytes: some ten million triangles, beyond which a text file is the wrong way.
pub const LARGEST_MESH_FILE: u64 = 1 << 30;

/// Reads a triangle mesh from an OBJ, STL, OFF or PLY file; lengths in m. The ending of its name says the format, and
/// where it says none the content does.
///
/// # Errors
/// When the file cannot be read, is too large, is in no known format, or its content is refused.
pub fn read_mesh(path: &Path) -> Result<TriangleMesh, MeshFileError> {
    read_mesh_of(Files::Disk, path)
}

/// As [`read_mesh`], from where the files are.
pub(crate) fn read_mesh_of(files: Files, path: &Path) -> Result<TriangleMesh, MeshFileError> {
    let bytes = files.bounded(path, LARGEST_MESH_FILE).map_err(|fault| match fault {
        Fault::Io(source) => MeshFileError::Read { path: path.to_owned(), source },
        Fault::TooLarge => MeshFileError::TooLarge { path: path.to_owned(), limit: LARGEST_MESH_FILE },
    })?;
    let format = MeshFormat::of_path(path)
        .or_else(|| MeshFormat::of_content(&bytes))
        .ok_or_else(|| MeshFileError::Format { path: path.to_owned() })?;
    format::read(&bytes, format).map_err(|source| MeshFileError::Content { path: path.to_owned(), source })
}
