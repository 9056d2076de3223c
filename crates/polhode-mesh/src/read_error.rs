//! What can be wrong with a mesh file, and where.

use crate::mesh_format::MeshFormat;
use crate::triangle_mesh::MeshError;
use std::fmt;
use thiserror::Error;

/// What is wrong with a mesh file, and where.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{place}: {kind}")]
pub struct ReadError {
    /// Where the offending token begins; the end of the file when something is missing.
    pub place: Place,
    /// What is wrong.
    pub kind: ReadErrorKind,
}

/// A place in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// A line of a text file, from 1.
    Line(usize),
    /// A byte of a binary file, from 0.
    Byte(usize),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
        }
    }
}

/// Most numbers of a `v` of OBJ: a position, a weight and a colour.
pub(crate) const MAX_VERTEX_NUMBERS: usize = 7;

/// What can be wrong with a mesh file. Tokens are shortened to [`MAX_TOKEN`] characters.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ReadErrorKind {
    /// OBJ: a line begins with a word that the format does not have, or that makes free-form geometry.
    #[error(
        "'{0}' is no statement of a polygon mesh; accepted are v and f, and ignored vt, vn, g, o, s, usemtl, mtllib, \
         l, p and comments"
    )]
    UnknownStatement(String),
    /// A coordinate is not a number.
    #[error("'{0}' is not a number")]
    BadNumber(String),
    /// A coordinate is NaN, infinite or beyond f64.
    #[error("'{0}' is not a finite number")]
    NotFinite(String),
    /// A number that counts something is not a whole number of at least 0.
    #[error("'{0}' is not a count: a whole number of at least 0 is needed")]
    BadCount(String),
    /// OBJ: a `v` has fewer than three or more than seven numbers.
    #[error(
        "a vertex has 3 coordinates (and at most a weight and a colour, {MAX_VERTEX_NUMBERS} numbers), found {0} \
         numbers"
    )]
    VertexNumbers(usize),
    /// OFF: the line of a vertex has fewer than three numbers.
    #[error("the line of a vertex begins with its 3 coordinates, found {0} numbers")]
    TooFewCoordinates(usize),
    /// OBJ: a corner of an `f` is not of the form v, v/t, v//n or v/t/n with whole numbers.
    #[error("'{0}' is no corner of a face; accepted are v, v/t, v//n and v/t/n with whole numbers that are not 0")]
    BadCorner(String),
    /// OBJ: a corner names a vertex beyond the last of the file.
    #[error("'{token}' names a vertex that does not exist: the file has {vertices} vertices")]
    NoSuchVertex {
        /// The corner.
        token: String,
        /// Number of vertices in the file.
        vertices: usize,
    },
    /// OBJ: a corner counts back beyond the first vertex.
    #[error("'{token}' counts back beyond the first vertex: {vertices} vertices come before it")]
    NoEarlierVertex {
        /// The corner.
        token: String,
        /// Number of vertices before the corner.
        vertices: usize,
    },
    /// A face names a vertex that the file does not have; indices count from 0.
    #[error("a face names vertex {index}, but the file has {vertices} vertices, counted from 0")]
    IndexOutOfRange {
        /// What the face names.
        index: String,
        /// Number of vertices in the file.
        vertices: usize,
    },
    /// A face has fewer than three corners.
    #[error("a face needs at least 3 vertices, found {0}")]
    TooFewVertices(usize),
    /// A face that is not convex has more corners than are triangulated in reasonable time.
    #[error("a face of {corners} corners is not convex, and such faces may have at most {limit}: split it")]
    LargeFace {
        /// Its corners.
        corners: usize,
        /// The most accepted.
        limit: usize,
    },
    /// More vertices than 32-bit indices can name.
    #[error("the file has more than {} vertices", u32::MAX)]
    TooManyVertices,
    /// The file has no face.
    #[error("the file has no faces ({vertices} vertices)")]
    Empty {
        /// Number of vertices.
        vertices: usize,
    },
    /// Another word, or value, than the format has here.
    #[error("expected {expected}, found '{found}'")]
    Expected {
        /// What the format has here.
        expected: &'static str,
        /// What the file has.
        found: String,
    },
    /// The file ends where something must follow.
    #[error("the file ends where {expected} must follow: it is cut off")]
    Ended {
        /// What the format has here.
        expected: &'static str,
    },
    /// The file has fewer items than its header says.
    #[error("the file ends after {found} of {claimed} {items}: it is cut off, or its header is wrong")]
    Truncated {
        /// What is counted: vertices, faces, the rows of an element.
        items: String,
        /// The number in the header.
        claimed: u64,
        /// The whole ones that are there.
        found: u64,
    },
    /// The file goes on after everything that its header announces.
    #[error("the file goes on after the {claimed} {items} that its header says: the header is wrong")]
    Trailing {
        /// What came last.
        items: String,
        /// The number in the header.
        claimed: u64,
    },
    /// A header lacks something.
    #[error("the header has no {0}")]
    Missing(&'static str),
    /// A header says something twice.
    #[error("the header has {0} twice")]
    Repeated(String),
    /// A variant of the format that is not read.
    #[error("{what} is not read: {instead}")]
    Unsupported {
        /// The variant.
        what: &'static str,
        /// What to do.
        instead: &'static str,
    },
    /// The content is that of no format.
    #[error("the content is none of {}; name the format", MeshFormat::LIST)]
    UnknownFormat,
    /// The mesh was refused for another reason.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// Most characters of a token that an error repeats.
pub const MAX_TOKEN: usize = 40;

/// A token as text, with at most [`MAX_TOKEN`] characters; control characters and bytes that are not UTF-8 are
/// replaced, so that it can be shown.
pub(crate) fn shown(token: &[u8]) -> String {
    // A character has at most four bytes.
    let head = &token[..token.len().min(4 * MAX_TOKEN)];
    let text = String::from_utf8_lossy(head);
    let visible = |c: char| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c };
    let mut shown: String = text.chars().take(MAX_TOKEN).map(visible).collect();
    if text.chars().nth(MAX_TOKEN).is_some() || head.len() < token.len() {
        shown.push_str("...");
    }
    shown
}
