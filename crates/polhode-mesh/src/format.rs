//! Formats of mesh files: which one a file is in, and reading and writing any of them.

pub use crate::mesh_format::{Encoding, MeshFormat};
pub use crate::write_error::WriteError;

use crate::read_error::{Place, ReadError, ReadErrorKind};
use crate::triangle_mesh::TriangleMesh;
use crate::words::{Joining, Words};
use crate::{obj, off, ply, stl};

impl MeshFormat {
    /// By what a file holds: `ply` in its first line, a header of OFF, the length of a binary STL or `solid`, or a
    /// statement of OBJ as the first.
    ///
    /// ```
    /// use polhode_mesh::MeshFormat;
    /// assert_eq!(MeshFormat::of_content(b"# made by hand\nCOFF\n8 12 0\n"), Some(MeshFormat::Off));
    /// assert_eq!(MeshFormat::of_content(b"a letter"), None);
    /// ```
    pub fn of_content(bytes: &[u8]) -> Option<Self> {
        if bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r") {
            return Some(Self::Ply);
        }
        if stl::is_likely(bytes) {
            return Some(Self::Stl);
        }
        let word = Words::new(bytes, Joining::Backslash).next_statement()?.text;
        if off::is_keyword(word) {
            return Some(Self::Off);
        }
        (word == b"v" || word == b"f" || obj::IGNORED.contains(&word)).then_some(Self::Obj)
    }
}

/// Reads a mesh from the bytes of a file in a known format.
///
/// # Errors
/// [`ReadError`] with the place and the first offending value.
pub fn read(bytes: &[u8], format: MeshFormat) -> Result<TriangleMesh, ReadError> {
    match format {
        MeshFormat::Obj => obj::read(bytes),
        MeshFormat::Stl => stl::read(bytes),
        MeshFormat::Off => off::read(bytes),
        MeshFormat::Ply => ply::read(bytes),
    }
}

/// Reads a mesh from the bytes of a file in the format that its [content](MeshFormat::of_content) shows.
///
/// # Errors
/// As [`read`]; [`ReadErrorKind::UnknownFormat`].
pub fn read_any(bytes: &[u8]) -> Result<TriangleMesh, ReadError> {
    let unknown = ReadError { place: Place::Line(1), kind: ReadErrorKind::UnknownFormat };
    read(bytes, MeshFormat::of_content(bytes).ok_or(unknown)?)
}

/// The bytes of a file of a mesh. What is read from them has the same corners, bit by bit, but for binary STL, which
/// rounds to f32, and for STL of either encoding the same triangles in order with vertices in another order.
///
/// # Errors
/// [`WriteError`] when the encoding does not exist or cannot hold the mesh.
pub fn write(mesh: &TriangleMesh, format: MeshFormat, encoding: Encoding) -> Result<Vec<u8>, WriteError> {
    match (format, encoding) {
        (MeshFormat::Obj, Encoding::Text) => Ok(obj::write(mesh).into_bytes()),
        (MeshFormat::Off, Encoding::Text) => Ok(off::write(mesh).into_bytes()),
        (MeshFormat::Stl, Encoding::Text) => Ok(stl::write_text(mesh).into_bytes()),
        (MeshFormat::Ply, Encoding::Text) => Ok(ply::write_text(mesh).into_bytes()),
        (MeshFormat::Stl, Encoding::Binary) => stl::write_binary(mesh),
        (MeshFormat::Ply, Encoding::Binary) => Ok(ply::write_binary(mesh)),
        (MeshFormat::Obj | MeshFormat::Off, Encoding::Binary) => Err(WriteError::NoBinary(format)),
    }
}
