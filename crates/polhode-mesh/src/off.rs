//! OFF as text, from and to bytes.
//!
//! A header `OFF`, or with `ST`, `C`, `N` before it for texture coordinates, colours and normals after the position of
//! each vertex; the numbers of vertices, faces and edges; then a line for each vertex, which begins with x, y, z, and
//! for each face, which begins with its number of corners and their indices, from 0. What follows in these lines must
//! be numbers and is ignored (normals, colours). Comments begin with `#`. Polygons are cut as in
//! [`obj`](mod@crate::obj). Not read are `4OFF` and `nOFF`, which are not of this space, and `OFF BINARY`.
//! Source: docs/REFERENCES.md, Geomview.

use crate::mesh_builder::MeshBuilder;
use crate::read_error::{Place, ReadError, ReadErrorKind};
use crate::triangle_mesh::TriangleMesh;
use crate::words::FEWEST_BYTES;
use crate::words::{Joining, Word, Words};
use std::fmt::Write;

/// Reads a mesh from the bytes of an OFF file.
///
/// ```
/// let mesh = polhode_mesh::off::read(b"OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")?;
/// assert_eq!(mesh.triangles(), [[0, 1, 2], [0, 2, 3]]);
/// assert_eq!(polhode_mesh::off::read(polhode_mesh::off::write(&mesh).as_bytes())?, mesh);
/// # Ok::<(), polhode_mesh::ReadError>(())
/// ```
///
/// # Errors
/// [`ReadError`] with the line and the first offending token.
pub fn read(bytes: &[u8]) -> Result<TriangleMesh, ReadError> {
    let mut words = Words::new(bytes, Joining::Never);
    let header = words
        .next_statement()
        .ok_or(ReadError { place: words.place(), kind: ReadErrorKind::Ended { expected: "'OFF'" } })?;
    check_keyword(header)?;
    let [vertices, faces] = counts(&mut words)?;
    let room = |claimed: u64, bytes: usize| claimed.min((words.remaining() / bytes) as u64) as usize;
    // A vertex has three numbers, a face as many and how many there are.
    let mut mesh = MeshBuilder::with_room_for(room(vertices, 3 * FEWEST_BYTES), room(faces, 4 * FEWEST_BYTES));
    for found in 0..vertices {
        let word = statement(&mut words, "vertices", vertices, found)?;
        vertex(word, &mut words, &mut mesh)?;
    }
    for found in 0..faces {
        let word = statement(&mut words, "faces", faces, found)?;
        face(word, &mut words, &mut mesh)?;
    }
    if let Some(word) = words.next_statement() {
        let kind = ReadErrorKind::Trailing { items: "faces".into(), claimed: faces };
        return Err(word.error(|_| kind));
    }
    mesh.finish(words.place())
}

/// Whether the word that a file begins with is a header of OFF.
pub(crate) fn is_keyword(word: &[u8]) -> bool {
    let word = word.strip_prefix(b"ST").unwrap_or(word);
    let word = word.strip_prefix(b"C").unwrap_or(word);
    let word = word.strip_prefix(b"N").unwrap_or(word);
    let word = word.strip_prefix(b"4").unwrap_or(word);
    word.strip_prefix(b"n").unwrap_or(word) == b"OFF"
}

fn check_keyword(header: Word<'_>) -> Result<(), ReadError> {
    if !is_keyword(header.text) {
        return Err(header.error(|found| ReadErrorKind::Expected { expected: "'OFF'", found }));
    }
    if header.text.iter().any(|byte| matches!(byte, b'4' | b'n')) {
        let (what, instead) = ("OFF of other than three dimensions", "write it as OFF with x y z");
        return Err(header.error(|_| ReadErrorKind::Unsupported { what, instead }));
    }
    Ok(())
}

/// Numbers of vertices and faces; that of edges is often wrong, and may be missing.
fn counts(words: &mut Words<'_>) -> Result<[u64; 2], ReadError> {
    let mut counts = [0; 2];
    for (i, count) in counts.iter_mut().enumerate() {
        // The first may stand in the line of the header.
        let word = if i == 0 { words.next_statement() } else { words.next_word() };
        let word = word.ok_or(ReadError {
            place: words.place(),
            kind: ReadErrorKind::Missing("line with the numbers of vertices and faces"),
        })?;
        if word.text == b"BINARY" {
            let (what, instead) = ("binary OFF", "write it as text");
            return Err(word.error(|_| ReadErrorKind::Unsupported { what, instead }));
        }
        *count = word.count()?;
    }
    if let Some(edges) = words.next_word() {
        edges.count()?;
    }
    if let Some(word) = words.next_word() {
        return Err(word.error(|found| ReadErrorKind::Expected { expected: "a new line for the first vertex", found }));
    }
    Ok(counts)
}

/// The first word of the next line.
fn statement<'a>(words: &mut Words<'a>, items: &'static str, claimed: u64, found: u64) -> Result<Word<'a>, ReadError> {
    words.next_statement().ok_or_else(|| ReadError {
        place: words.place(),
        kind: ReadErrorKind::Truncated { items: items.into(), claimed, found },
    })
}

fn vertex(first: Word<'_>, words: &mut Words<'_>, mesh: &mut MeshBuilder) -> Result<(), ReadError> {
    let mut position = [0.0; 3];
    let mut count = 0;
    let mut word = Some(first);
    while let Some(current) = word {
        let number = current.finite()?;
        if let Some(coordinate) = position.get_mut(count) {
            *coordinate = number;
        }
        count += 1;
        word = words.next_word();
    }
    let place = Place::Line(first.line);
    if count < 3 {
        return Err(ReadError { place, kind: ReadErrorKind::TooFewCoordinates(count) });
    }
    mesh.vertex(position, place)
}

fn face(first: Word<'_>, words: &mut Words<'_>, mesh: &mut MeshBuilder) -> Result<(), ReadError> {
    let place = Place::Line(first.line);
    let corners = first.count()?;
    let vertices = mesh.vertices();
    for found in 0..corners {
        let word = words.next_word().ok_or_else(|| ReadError {
            place,
            kind: ReadErrorKind::Truncated { items: "corners of the face in its line".into(), claimed: corners, found },
        })?;
        let index = word.count()?;
        if index >= vertices as u64 {
            return Err(word.error(|index| ReadErrorKind::IndexOutOfRange { index, vertices }));
        }
        mesh.corner(index as u32);
    }
    while let Some(color) = words.next_word() {
        color.finite()?;
    }
    mesh.end_face(place)
}

/// The text of an OFF file. Numbers have the fewest digits that read back as the same bits.
pub fn write(mesh: &TriangleMesh) -> String {
    // Writing to a string cannot fail.
    let mut text = format!("OFF\n{} {} 0\n", mesh.vertices().len(), mesh.triangles().len());
    for v in mesh.vertices() {
        let _ = writeln!(text, "{:?} {:?} {:?}", v.x, v.y, v.z);
    }
    for [a, b, c] in mesh.triangles() {
        let _ = writeln!(text, "3 {a} {b} {c}");
    }
    text
}
