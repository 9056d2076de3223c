//! STL as text: `solid`, then `facet normal`, `outer loop`, three `vertex`, `endloop`, `endfacet` for each triangle.
//!
//! Keywords in any case and line ends anywhere; several solids in one file are one mesh.

use super::normal::unit_normal;
use crate::mesh_builder::MeshBuilder;
use crate::read_error::{Place, ReadError, ReadErrorKind};
use crate::triangle_mesh::TriangleMesh;
use crate::weld::merged_exactly;
use crate::words::{Joining, Word, Words};
use std::fmt::Write;

pub(super) fn read(bytes: &[u8]) -> Result<TriangleMesh, ReadError> {
    let mut words = Words::new(bytes, Joining::Never);
    let mut mesh = MeshBuilder::default();
    while let Some(word) = words.next_statement() {
        if !word.text.eq_ignore_ascii_case(b"solid") {
            return Err(word.error(|found| ReadErrorKind::Expected { expected: "'solid'", found }));
        }
        words.skip_statement();
        solid(&mut words, &mut mesh)?;
    }
    mesh.finish(words.place()).map(merged_exactly)
}

/// Everything from the name of a solid to its end.
fn solid(words: &mut Words<'_>, mesh: &mut MeshBuilder) -> Result<(), ReadError> {
    loop {
        let word = next(words, "'facet' or 'endsolid'")?;
        if word.text.eq_ignore_ascii_case(b"endsolid") {
            words.skip_statement();
            return Ok(());
        }
        if !word.text.eq_ignore_ascii_case(b"facet") {
            return Err(word.error(|found| ReadErrorKind::Expected { expected: "'facet' or 'endsolid'", found }));
        }
        facet(words, mesh)?;
    }
}

fn facet(words: &mut Words<'_>, mesh: &mut MeshBuilder) -> Result<(), ReadError> {
    keyword(words, b"normal", "'normal'")?;
    for _ in 0..3 {
        // Ignored, and in real files often NaN.
        next(words, "the normal of a facet")?;
    }
    keyword(words, b"outer", "'outer loop'")?;
    keyword(words, b"loop", "'outer loop'")?;
    for _ in 0..3 {
        let line = keyword(words, b"vertex", "'vertex' (a facet has three)")?;
        let mut position = [0.0; 3];
        for coordinate in &mut position {
            *coordinate = next(words, "a coordinate")?.finite()?;
        }
        let index = mesh.vertices() as u32;
        mesh.vertex(position, Place::Line(line))?;
        mesh.corner(index);
    }
    let line = keyword(words, b"endloop", "'endloop' (a facet has three vertices)")?;
    keyword(words, b"endfacet", "'endfacet'")?;
    mesh.end_face(Place::Line(line))
}

/// The next word, on whatever line.
fn next<'a>(words: &mut Words<'a>, expected: &'static str) -> Result<Word<'a>, ReadError> {
    words.next_statement().ok_or(ReadError { place: words.place(), kind: ReadErrorKind::Ended { expected } })
}

/// Passes over a keyword; its line.
fn keyword(words: &mut Words<'_>, keyword: &[u8], expected: &'static str) -> Result<usize, ReadError> {
    let word = next(words, expected)?;
    if word.text.eq_ignore_ascii_case(keyword) {
        Ok(word.line)
    } else {
        Err(word.error(|found| ReadErrorKind::Expected { expected, found }))
    }
}

/// The text of an STL file. Numbers have the fewest digits that read back as the same bits; vertices that no triangle
/// uses are left out, as the format has no place for them.
pub fn write(mesh: &TriangleMesh) -> String {
    let mut text = String::from("solid\n");
    // Writing to a string cannot fail.
    for corners in mesh.corner_positions() {
        let n = unit_normal(corners);
        let _ = writeln!(text, "facet normal {:?} {:?} {:?}\nouter loop", n.x, n.y, n.z);
        for v in corners {
            let _ = writeln!(text, "vertex {:?} {:?} {:?}", v.x, v.y, v.z);
        }
        text.push_str("endloop\nendfacet\n");
    }
    text.push_str("endsolid\n");
    text
}
