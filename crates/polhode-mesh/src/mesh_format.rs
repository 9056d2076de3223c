//! The formats of mesh files: their names, the endings of their files, and text or binary.

use std::fmt;
use std::path::Path;

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
