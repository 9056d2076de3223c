//! Formats of mesh files: which one a file is in, and reading and writing any of them.

use crate::read_error::{Place, ReadError, ReadErrorKind};
use crate::triangle_mesh::TriangleMesh;
use crate::words::{Joining, Words};
use crate::{obj, off, ply, stl};
use glam::DVec3;
use std::fmt;
use std::path::Path;
use thiserror::Error;

/// A format of mesh files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum MeshFormat {
    /// Wavefront OBJ: [`obj`](mod@crate::obj).
    Obj,
    /// STL, text or binary: [`stl`](mod@crate::stl).
    Stl,
    /// OFF: [`off`](mod@crate::off).
    Off,
    /// PLY, text or binary: [`ply`](mod@crate::ply).
    Ply,
}

/// How a file is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// Decimal numbers that read back as the same bits.
    Text,
    /// Bytes; of STL f32, of PLY f64. OBJ and OFF have none.
    Binary,
}

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

impl MeshFormat {
    /// All formats.
    pub const ALL: [Self; 4] = [Self::Obj, Self::Stl, Self::Off, Self::Ply];

    /// Their names in a sentence.
    pub const LIST: &str = "OBJ, STL, OFF, PLY";

    /// By the ending of a file's name, in either case.
    pub fn of_path(path: &Path) -> Option<Self> {
        let ending = path.extension()?;
        Self::ALL.into_iter().find(|format| ending.eq_ignore_ascii_case(format.ending()))
    }

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

    /// The ending of file names, without the dot.
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Obj => "obj",
            Self::Stl => "stl",
            Self::Off => "off",
            Self::Ply => "ply",
        }
    }

    /// The encoding that keeps every bit of a mesh in the least room: binary for PLY, text for the others (binary STL
    /// is f32).
    pub const fn exact_encoding(self) -> Encoding {
        match self {
            Self::Ply => Encoding::Binary,
            Self::Obj | Self::Stl | Self::Off => Encoding::Text,
        }
    }
}

impl fmt::Display for MeshFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Obj => "OBJ",
            Self::Stl => "STL",
            Self::Off => "OFF",
            Self::Ply => "PLY",
        })
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
