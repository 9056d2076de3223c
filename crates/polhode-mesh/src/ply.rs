//! PLY, text and binary of either byte order, from and to bytes.
//!
//! A header names elements and their properties in the order in which they follow. Read are `x`, `y`, `z` of `vertex`,
//! of any type, and the list `vertex_indices` or `vertex_index` of `face`, of any integer type; all other properties
//! and elements are passed over. In text every row is a line, and numbers are read to the nearest f64 whatever type the
//! header names. Polygons are cut as in [`obj`](mod@crate::obj). Nothing is reserved by a number in the header alone,
//! so that a false one costs nothing. Source: docs/REFERENCES.md, Turk 1994.
//!
//! | module | holds |
//! |---|---|
//! | `header` | the header of a file |
//! | `rows` | its body, row by row |
//! | `writer` | files from meshes |

mod header;
mod rows;
mod writer;

use crate::mesh_builder::MeshBuilder;
use crate::read_error::{Place, ReadError, ReadErrorKind};
use crate::triangle_mesh::TriangleMesh;
use header::{Element, Encoding, Header, Kind};
use rows::{Binary, Rows, Text};
pub use writer::{write_binary, write_text};

/// Reads a mesh from the bytes of a PLY file.
///
/// ```
/// let file = b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
///     element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
/// let mesh = polhode_mesh::ply::read(file)?;
/// assert_eq!(mesh.triangles(), [[0, 1, 2]]);
/// assert_eq!(polhode_mesh::ply::read(&polhode_mesh::ply::write_binary(&mesh))?, mesh);
/// # Ok::<(), polhode_mesh::ReadError>(())
/// ```
///
/// # Errors
/// [`ReadError`] with the line, or in a binary body the byte, and the first offending value.
pub fn read(bytes: &[u8]) -> Result<TriangleMesh, ReadError> {
    let header = Header::read(bytes)?;
    match header.encoding {
        Encoding::Text => body(&header, Text::new(bytes, &header)),
        Encoding::LittleEndian => body(&header, Binary::little_endian(bytes, header.body)),
        Encoding::BigEndian => body(&header, Binary::big_endian(bytes, header.body)),
    }
}

fn body(header: &Header<'_>, mut rows: impl Rows) -> Result<TriangleMesh, ReadError> {
    let room = |name: &[u8]| header.element(name).map_or(0, |element| rows.most_rows(element));
    let mut mesh = MeshBuilder::with_room_for(room(b"vertex"), room(b"face"));
    // A face may come before the vertices, so the largest index is checked when all are known.
    let mut furthest = None;
    for element in &header.elements {
        match element.name {
            b"vertex" => vertices(element, &mut rows, &mut mesh)?,
            b"face" => furthest = faces(element, &mut rows, &mut mesh)?,
            _ => skip(element, &mut rows)?,
        }
    }
    let vertices = mesh.vertices();
    if let Some((index, place)) = furthest.filter(|&(index, _)| index as usize >= vertices) {
        let kind = ReadErrorKind::IndexOutOfRange { index: index.to_string(), vertices };
        return Err(ReadError { place, kind });
    }
    if let Some(place) = rows.trailing() {
        let last = header.elements.last();
        let items = last.map_or_else(String::new, Element::items);
        let kind = ReadErrorKind::Trailing { items, claimed: last.map_or(0, |element| element.count) };
        return Err(ReadError { place, kind });
    }
    mesh.finish(rows.place())
}

fn vertices(element: &Element<'_>, rows: &mut impl Rows, mesh: &mut MeshBuilder) -> Result<(), ReadError> {
    // Which coordinate each property is; 3 is none.
    let axis_of = |name: &[u8]| [b"x", b"y", b"z"].iter().position(|axis| *axis == name).unwrap_or(3);
    let axes: Vec<usize> = element.properties.iter().map(|property| axis_of(property.name)).collect();
    for row in 0..element.count {
        rows.begin_row(element, row)?;
        let place = rows.place();
        let mut position = [0.0; 4];
        for (property, &axis) in element.properties.iter().zip(&axes) {
            match property.kind {
                Kind::Scalar(_) if axis == 3 => rows.skip(property.kind),
                Kind::Scalar(scalar) => rows.finite(scalar).map(|number| position[axis] = number),
                Kind::List { .. } => rows.skip(property.kind),
            }
            .map_err(|fault| fault.in_row(element, row))?;
        }
        rows.end_row()?;
        let [x, y, z, _] = position;
        mesh.vertex([x, y, z], place)?;
    }
    Ok(())
}

/// The largest index that a face names, with the first place where it does.
fn faces(
    element: &Element<'_>,
    rows: &mut impl Rows,
    mesh: &mut MeshBuilder,
) -> Result<Option<(u32, Place)>, ReadError> {
    let mut furthest: Option<(u32, Place)> = None;
    for row in 0..element.count {
        rows.begin_row(element, row)?;
        let row_place = rows.place();
        for property in &element.properties {
            let Kind::List { count, item } = property.kind else {
                rows.skip(property.kind).map_err(|fault| fault.in_row(element, row))?;
                continue;
            };
            if !property.is_corners() {
                rows.skip(property.kind).map_err(|fault| fault.in_row(element, row))?;
                continue;
            }
            let corners = rows.whole(count).map_err(|fault| fault.in_row(element, row))?;
            for _ in 0..corners {
                let place = rows.place();
                let index = rows.whole(item).map_err(|fault| fault.in_row(element, row))?;
                let index = u32::try_from(index).unwrap_or(u32::MAX);
                if furthest.is_none_or(|(largest, _)| index > largest) {
                    furthest = Some((index, place));
                }
                mesh.corner(index);
            }
            mesh.end_face(row_place)?;
        }
        rows.end_row()?;
    }
    Ok(furthest)
}

/// Passes over an element that is of no interest.
fn skip(element: &Element<'_>, rows: &mut impl Rows) -> Result<(), ReadError> {
    // Rows without any property take no room, however many there are said to be.
    if element.properties.is_empty() {
        return Ok(());
    }
    for row in 0..element.count {
        rows.begin_row(element, row)?;
        for property in &element.properties {
            rows.skip(property.kind).map_err(|fault| fault.in_row(element, row))?;
        }
        rows.end_row()?;
    }
    Ok(())
}
