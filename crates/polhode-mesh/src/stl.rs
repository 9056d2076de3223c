//! STL, text and binary, from and to bytes.
//!
//! Either kind is a list of triangles by their corners, without indices: corners at exactly the same position (0 and -0
//! are the same) become one vertex, which is what closes the surface again. Nothing else is merged; see
//! [`weld`](crate::weld::weld) for a tolerance. Normals are ignored, because the corners say them.
//!
//! A file is binary when its length is what its triangle count asks for (`84 + 50 n` bytes), whatever it begins with:
//! many programs begin binary files with `solid`. Text is never as long as its bytes 80 to 83 would ask for below 6 GB.
//! Else it is text when it begins with `solid` and has no zero byte within its first [`LOOKED_AT`] bytes, and a binary
//! file of the wrong length otherwise. Binary coordinates are f32, text ones are read to the nearest f64.
//! Source: docs/REFERENCES.md, Burns 1993.
//!
//! | module | holds |
//! |---|---|
//! | `binary` | binary files |
//! | `normal` | the normal that a file gives each of its triangles |
//! | `text` | files of text |

mod binary;
mod normal;
mod text;

use crate::read_error::ReadError;
use crate::triangle_mesh::TriangleMesh;
pub use binary::write as write_binary;
pub use text::write as write_text;

/// Bytes in which a zero says that a file beginning with `solid` is binary.
pub const LOOKED_AT: usize = 1024;

/// Reads a mesh from the bytes of an STL file of either kind.
///
/// ```
/// let text = b"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n\
///              endloop\nendfacet\nendsolid";
/// let mesh = polhode_mesh::stl::read(text)?;
/// assert_eq!(mesh.triangles(), [[0, 1, 2]]);
/// assert_eq!(polhode_mesh::stl::read(&polhode_mesh::stl::write_binary(&mesh)?)?, mesh);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ReadError`] with the line, or in a binary file the byte, and the first offending value.
pub fn read(bytes: &[u8]) -> Result<TriangleMesh, ReadError> {
    if binary::has_length_of_count(bytes) || !begins_as_text(bytes) { binary::read(bytes) } else { text::read(bytes) }
}

/// Whether the bytes are those of an STL file of either kind.
pub(crate) fn is_likely(bytes: &[u8]) -> bool {
    binary::has_length_of_count(bytes) || begins_as_text(bytes)
}

/// Whether a file begins with `solid` and has no zero byte soon.
fn begins_as_text(bytes: &[u8]) -> bool {
    let head = &bytes[..bytes.len().min(LOOKED_AT)];
    let start = head.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(head).trim_ascii_start();
    start.len() >= 5 && start[..5].eq_ignore_ascii_case(b"solid") && !head.contains(&0)
}
