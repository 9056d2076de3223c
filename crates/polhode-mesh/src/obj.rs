//! Wavefront OBJ in f64, from bytes.
//!
//! Read are `v x y z` and `f` with `v`, `v/t`, `v//n`, `v/t/n`; a polygon becomes the fan of triangles from its first
//! vertex, which is right for flat convex polygons and what every renderer does with the others. Indices count from 1,
//! negative ones back from the last vertex; a positive one may name a vertex that comes later. Ignored are texture
//! coordinates, normals, groups, materials, points, lines and comments; weights and colours after `x y z` are checked to
//! be numbers and ignored. Free-form curves and surfaces, which would be missing from the solid, are refused, and so is
//! every keyword the format does not have. A `\` at the end of a line joins it to the next, except in comments.
//!
//! One pass over the bytes that stops at the first bad token; memory is that of the mesh. Bytes that are not UTF-8 are
//! fine in comments and names. Source: docs/REFERENCES.md, Wavefront, Advanced Visualizer manual, appendix B1.

mod tokens;

use crate::triangle_mesh::{MeshError, TriangleMesh};
use glam::DVec3;
use thiserror::Error;
use tokens::{Token, Tokens};

/// Keywords that say nothing about the shape of a polygon mesh.
const IGNORED: [&[u8]; 19] = [
    b"vt",
    b"vn",
    b"vp",
    b"g",
    b"o",
    b"s",
    b"usemtl",
    b"mtllib",
    b"l",
    b"p",
    b"mg",
    b"usemap",
    b"maplib",
    b"bevel",
    b"c_interp",
    b"d_interp",
    b"lod",
    b"shadow_obj",
    b"trace_obj",
];

/// Most numbers of a `v`: a position, a weight and a colour.
const MAX_VERTEX_NUMBERS: usize = 7;

/// What is wrong with an OBJ file, and in which line (from 1).
#[derive(Debug, Clone, PartialEq, Error)]
#[error("line {line}: {kind}")]
pub struct ObjError {
    /// The line of the offending token, from 1; the last one when something is missing.
    pub line: usize,
    /// What is wrong.
    pub kind: ObjErrorKind,
}

/// What can be wrong with an OBJ file. Tokens are shortened to [`MAX_TOKEN`] characters.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ObjErrorKind {
    /// A line begins with a word that the format does not have, or that makes free-form geometry.
    #[error(
        "'{0}' is no statement of a polygon mesh; accepted are v and f, and ignored vt, vn, g, o, s, usemtl, mtllib, l, p and comments"
    )]
    UnknownStatement(String),
    /// A coordinate is not a number.
    #[error("'{0}' is not a number")]
    BadNumber(String),
    /// A coordinate is NaN, infinite or beyond f64.
    #[error("'{0}' is not a finite number")]
    NotFinite(String),
    /// A `v` has fewer than three or more than seven numbers.
    #[error(
        "a vertex has 3 coordinates (and at most a weight and a colour, {MAX_VERTEX_NUMBERS} numbers), found {0} numbers"
    )]
    VertexNumbers(usize),
    /// A corner of an `f` is not of the form v, v/t, v//n or v/t/n with whole numbers.
    #[error("'{0}' is no corner of a face; accepted are v, v/t, v//n and v/t/n with whole numbers that are not 0")]
    BadCorner(String),
    /// A corner names a vertex beyond the last of the file.
    #[error("'{token}' names a vertex that does not exist: the file has {vertices} vertices")]
    NoSuchVertex {
        /// The corner.
        token: String,
        /// Number of vertices in the file.
        vertices: usize,
    },
    /// A corner counts back beyond the first vertex.
    #[error("'{token}' counts back beyond the first vertex: {vertices} vertices come before it")]
    NoEarlierVertex {
        /// The corner.
        token: String,
        /// Number of vertices before the corner.
        vertices: usize,
    },
    /// An `f` has fewer than three corners.
    #[error("a face needs at least 3 vertices, found {0}")]
    TooFewVertices(usize),
    /// More vertices than 32-bit indices can name.
    #[error("the file has more than {} vertices", u32::MAX)]
    TooManyVertices,
    /// The file has no face.
    #[error("the file has no faces ({vertices} vertices)")]
    Empty {
        /// Number of vertices.
        vertices: usize,
    },
    /// The mesh was refused for another reason.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// Most characters of a token that an error repeats.
pub const MAX_TOKEN: usize = 40;

/// Reads a mesh from the bytes of an OBJ file.
///
/// ```
/// let quad = polhode_mesh::obj::read(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1 # a square")?;
/// assert_eq!(quad.triangles(), [[0, 1, 2], [0, 2, 3]]);
///
/// let error = polhode_mesh::obj::read(b"v 0 0 0\nv 1 0 zero\n").unwrap_err();
/// assert_eq!(error.to_string(), "line 2: 'zero' is not a number");
/// # Ok::<(), polhode_mesh::ObjError>(())
/// ```
///
/// # Errors
/// [`ObjError`] with the line and the first offending token.
pub fn read(bytes: &[u8]) -> Result<TriangleMesh, ObjError> {
    let mut reader = Reader::default();
    let mut tokens = Tokens::new(bytes);
    while let Some(keyword) = tokens.next_statement() {
        match keyword.text {
            b"v" => reader.vertex(&mut tokens, keyword.line)?,
            b"f" => reader.face(&mut tokens, keyword.line)?,
            word if IGNORED.contains(&word) => tokens.skip_statement(),
            _ => return Err(keyword.error(ObjErrorKind::UnknownStatement)),
        }
    }
    reader.finish(tokens.line())
}

/// What has been read so far.
#[derive(Default)]
struct Reader<'a> {
    vertices: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    /// Corners that name a vertex still to come, each beyond all before it; so the first of the file that stays
    /// unresolved is among them.
    forward: Vec<Forward<'a>>,
}

/// A corner that names a vertex still to come.
struct Forward<'a> {
    token: Token<'a>,
    index: u32,
}

impl<'a> Reader<'a> {
    fn vertex(&mut self, tokens: &mut Tokens<'a>, line: usize) -> Result<(), ObjError> {
        let mut position = [0.0; 3];
        let mut count = 0;
        while let Some(token) = tokens.next_word() {
            let number = number(token)?;
            if let Some(coordinate) = position.get_mut(count) {
                *coordinate = number;
            }
            count += 1;
            if count > MAX_VERTEX_NUMBERS {
                break;
            }
        }
        if !(3..=MAX_VERTEX_NUMBERS).contains(&count) {
            return Err(ObjError { line, kind: ObjErrorKind::VertexNumbers(count) });
        }
        if self.vertices.len() >= u32::MAX as usize {
            return Err(ObjError { line, kind: ObjErrorKind::TooManyVertices });
        }
        self.vertices.push(DVec3::from_array(position));
        Ok(())
    }

    fn face(&mut self, tokens: &mut Tokens<'a>, line: usize) -> Result<(), ObjError> {
        let (mut first, mut last) = (0, 0);
        let mut count = 0;
        while let Some(token) = tokens.next_word() {
            let index = self.corner(token)?;
            match count {
                0 => first = index,
                1 => {}
                _ => self.triangles.push([first, last, index]),
            }
            last = index;
            count += 1;
        }
        if count < 3 {
            return Err(ObjError { line, kind: ObjErrorKind::TooFewVertices(count) });
        }
        Ok(())
    }

    /// Index, from 0, of the vertex that a corner names.
    fn corner(&mut self, token: Token<'a>) -> Result<u32, ObjError> {
        let reference = vertex_of_corner(token.text).ok_or_else(|| token.error(ObjErrorKind::BadCorner))?;
        let vertices = self.vertices.len();
        if reference < 0 {
            // Counted back from the end: -1 is the latest vertex.
            let index = usize::try_from(reference.unsigned_abs()).ok().and_then(|back| vertices.checked_sub(back));
            return match index {
                Some(index) => Ok(index as u32),
                None => Err(token.error(|token| ObjErrorKind::NoEarlierVertex { token, vertices })),
            };
        }
        let index = u32::try_from(reference - 1)
            .map_err(|_| token.error(|token| ObjErrorKind::NoSuchVertex { token, vertices }))?;
        if index as usize >= vertices && self.forward.last().is_none_or(|forward| index > forward.index) {
            self.forward.push(Forward { token, index });
        }
        Ok(index)
    }

    fn finish(self, last_line: usize) -> Result<TriangleMesh, ObjError> {
        let vertices = self.vertices.len();
        if let Some(forward) = self.forward.into_iter().find(|forward| forward.index as usize >= vertices) {
            return Err(forward.token.error(|token| ObjErrorKind::NoSuchVertex { token, vertices }));
        }
        if self.triangles.is_empty() {
            return Err(ObjError { line: last_line, kind: ObjErrorKind::Empty { vertices } });
        }
        TriangleMesh::new(self.vertices, self.triangles)
            .map_err(|error| ObjError { line: last_line, kind: error.into() })
    }
}

/// A finite number.
fn number(token: Token<'_>) -> Result<f64, ObjError> {
    let number: Option<f64> = std::str::from_utf8(token.text).ok().and_then(|text| text.parse().ok());
    match number {
        Some(number) if number.is_finite() => Ok(number),
        Some(_) => Err(token.error(ObjErrorKind::NotFinite)),
        None => Err(token.error(ObjErrorKind::BadNumber)),
    }
}

/// The vertex number of `v`, `v/t`, `v//n` or `v/t/n`; none when the corner is of another form or names number 0.
fn vertex_of_corner(corner: &[u8]) -> Option<i64> {
    let mut parts = corner.split(|&byte| byte == b'/');
    let vertex = parts.next().and_then(whole_number)?;
    let (texture, normal) = (parts.next(), parts.next());
    let is_sound = match (texture, normal) {
        (None, _) => true,
        (Some(texture), None) => whole_number(texture).is_some(),
        (Some(texture), Some(normal)) => {
            (texture.is_empty() || whole_number(texture).is_some()) && whole_number(normal).is_some()
        }
    };
    (is_sound && parts.next().is_none()).then_some(vertex)
}

/// A whole number that is not 0.
fn whole_number(text: &[u8]) -> Option<i64> {
    std::str::from_utf8(text).ok()?.parse().ok().filter(|&number| number != 0)
}
