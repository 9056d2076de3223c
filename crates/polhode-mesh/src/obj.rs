//! Wavefront OBJ in f64, from and to bytes.
//!
//! Read are `v x y z` and `f` with `v`, `v/t`, `v//n`, `v/t/n`; a polygon becomes the fan of triangles from its first
//! vertex, or is cut by ears where that is wrong because it is not convex. Indices count from 1,
//! negative ones back from the last vertex; a positive one may name a vertex that comes later. Ignored are texture
//! coordinates, normals, groups, materials, points, lines and comments; weights and colours after `x y z` are checked
//! to be numbers and ignored. Free-form curves and surfaces, which would be missing from the solid, are refused, and so
//! is every keyword the format does not have. A `\` at the end of a line joins it to the next, except in comments.
//!
//! One pass over the bytes that stops at the first bad token; memory is that of the mesh. Bytes that are not UTF-8 are
//! fine in comments and names. Source: docs/REFERENCES.md, Wavefront, Advanced Visualizer manual, appendix B1.

use crate::decimal::whole;
use crate::mesh_builder::MeshBuilder;
use crate::read_error::{MAX_VERTEX_NUMBERS, Place, ReadError, ReadErrorKind};
use crate::triangle_mesh::TriangleMesh;
use crate::words::{Joining, Word, Words};
use std::fmt::Write;

/// Keywords that say nothing about the shape of a polygon mesh.
pub(crate) const IGNORED: [&[u8]; 19] = [
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

/// Reads a mesh from the bytes of an OBJ file.
///
/// ```
/// let quad = polhode_mesh::obj::read(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1 # a square")?;
/// assert_eq!(quad.triangles(), [[0, 1, 2], [0, 2, 3]]);
///
/// let error = polhode_mesh::obj::read(b"v 0 0 0\nv 1 0 zero\n").unwrap_err();
/// assert_eq!(error.to_string(), "line 2: 'zero' is not a number");
/// # Ok::<(), polhode_mesh::ReadError>(())
/// ```
///
/// # Errors
/// [`ReadError`] with the line and the first offending token.
pub fn read(bytes: &[u8]) -> Result<TriangleMesh, ReadError> {
    let mut reader = Reader::default();
    let mut words = Words::new(bytes, Joining::Backslash);
    while let Some(keyword) = words.next_statement() {
        match keyword.text {
            b"v" => reader.vertex(&mut words, keyword.line)?,
            b"f" => reader.face(&mut words, keyword.line)?,
            word if IGNORED.contains(&word) => words.skip_statement(),
            _ => return Err(keyword.error(ReadErrorKind::UnknownStatement)),
        }
    }
    reader.finish(words.place())
}

/// The text of an OBJ file. Numbers have the fewest digits that read back as the same bits.
pub fn write(mesh: &TriangleMesh) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    for v in mesh.vertices() {
        let _ = writeln!(text, "v {:?} {:?} {:?}", v.x, v.y, v.z);
    }
    for &[a, b, c] in mesh.triangles() {
        let _ = writeln!(text, "f {} {} {}", u64::from(a) + 1, u64::from(b) + 1, u64::from(c) + 1);
    }
    text
}

/// What has been read so far.
#[derive(Default)]
struct Reader<'a> {
    mesh: MeshBuilder,
    /// Corners that name a vertex still to come, each beyond all before it; so the first of the file that stays
    /// unresolved is among them.
    forward: Vec<Forward<'a>>,
}

/// A corner that names a vertex still to come.
struct Forward<'a> {
    word: Word<'a>,
    index: u32,
}

impl<'a> Reader<'a> {
    fn vertex(&mut self, words: &mut Words<'a>, line: usize) -> Result<(), ReadError> {
        let mut position = [0.0; 3];
        let mut count = 0;
        while let Some(word) = words.next_word() {
            let number = word.finite()?;
            if let Some(coordinate) = position.get_mut(count) {
                *coordinate = number;
            }
            count += 1;
            if count > MAX_VERTEX_NUMBERS {
                break;
            }
        }
        let place = Place::Line(line);
        if !(3..=MAX_VERTEX_NUMBERS).contains(&count) {
            return Err(ReadError { place, kind: ReadErrorKind::VertexNumbers(count) });
        }
        self.mesh.vertex(position, place)
    }

    fn face(&mut self, words: &mut Words<'a>, line: usize) -> Result<(), ReadError> {
        while let Some(word) = words.next_word() {
            let index = self.corner(word)?;
            self.mesh.corner(index);
        }
        self.mesh.end_face(Place::Line(line))
    }

    /// Index, from 0, of the vertex that a corner names.
    fn corner(&mut self, word: Word<'a>) -> Result<u32, ReadError> {
        let reference = vertex_of_corner(word.text).ok_or_else(|| word.error(ReadErrorKind::BadCorner))?;
        let vertices = self.mesh.vertices();
        if reference < 0 {
            // Counted back from the end: -1 is the latest vertex.
            let index = usize::try_from(reference.unsigned_abs()).ok().and_then(|back| vertices.checked_sub(back));
            return match index {
                Some(index) => Ok(index as u32),
                None => Err(word.error(|token| ReadErrorKind::NoEarlierVertex { token, vertices })),
            };
        }
        let index = u32::try_from(reference - 1)
            .map_err(|_| word.error(|token| ReadErrorKind::NoSuchVertex { token, vertices }))?;
        if index as usize >= vertices && self.forward.last().is_none_or(|forward| index > forward.index) {
            self.forward.push(Forward { word, index });
        }
        Ok(index)
    }

    fn finish(self, end: Place) -> Result<TriangleMesh, ReadError> {
        let vertices = self.mesh.vertices();
        if let Some(forward) = self.forward.into_iter().find(|forward| forward.index as usize >= vertices) {
            return Err(forward.word.error(|token| ReadErrorKind::NoSuchVertex { token, vertices }));
        }
        self.mesh.finish(end)
    }
}

/// The vertex number of `v`, `v/t`, `v//n` or `v/t/n`; none when the corner is of another form or names number 0.
fn vertex_of_corner(corner: &[u8]) -> Option<i64> {
    if !corner.contains(&b'/') {
        return not_zero(corner);
    }
    let mut parts = corner.split(|&byte| byte == b'/');
    let vertex = parts.next().and_then(not_zero)?;
    let (texture, normal) = (parts.next(), parts.next());
    let is_sound = match (texture, normal) {
        (None, _) => true,
        (Some(texture), None) => not_zero(texture).is_some(),
        (Some(texture), Some(normal)) => {
            (texture.is_empty() || not_zero(texture).is_some()) && not_zero(normal).is_some()
        }
    };
    (is_sound && parts.next().is_none()).then_some(vertex)
}

/// A whole number that is not 0.
fn not_zero(text: &[u8]) -> Option<i64> {
    whole(text).filter(|&number| number != 0)
}
