//! Binary STL: 80 bytes that mean nothing, the number of triangles as u32, and for each its normal and corners as
//! twelve f32 and two bytes that mean nothing; little endian.

use super::normal::unit_normal;
use crate::mesh_builder::MeshBuilder;
use crate::read_error::{Place, ReadError, ReadErrorKind};
use crate::triangle_mesh::TriangleMesh;
use crate::weld::merged_exactly;
use crate::write_error::WriteError;
use glam::DVec3;

/// Bytes before the first triangle.
const HEADER: usize = 84;
/// Bytes of a triangle.
const TRIANGLE: usize = 50;
/// Bytes of a vector.
const VECTOR: usize = 12;

/// The number of triangles that the header says.
fn claimed(bytes: &[u8]) -> Option<u32> {
    bytes.get(HEADER - 4..HEADER)?.try_into().ok().map(u32::from_le_bytes)
}

/// Whether a file is as long as its header says.
pub(super) fn has_length_of_count(bytes: &[u8]) -> bool {
    claimed(bytes).is_some_and(|count| bytes.len() as u64 == HEADER as u64 + TRIANGLE as u64 * u64::from(count))
}

pub(super) fn read(bytes: &[u8]) -> Result<TriangleMesh, ReadError> {
    let end = Place::Byte(bytes.len());
    let count = claimed(bytes).ok_or(ReadError {
        place: end,
        kind: ReadErrorKind::Ended { expected: "the 84 bytes of a binary STL header" },
    })?;
    let body = &bytes[HEADER..];
    let (claimed, found) = (u64::from(count), (body.len() / TRIANGLE) as u64);
    let items = || "triangles".to_owned();
    if found < claimed {
        return Err(ReadError { place: end, kind: ReadErrorKind::Truncated { items: items(), claimed, found } });
    }
    if !has_length_of_count(bytes) {
        let place = Place::Byte(HEADER + TRIANGLE * count as usize);
        return Err(ReadError { place, kind: ReadErrorKind::Trailing { items: items(), claimed } });
    }
    let mut mesh = MeshBuilder::with_room_for(3 * count as usize, count as usize);
    for (triangle, record) in body.chunks_exact(TRIANGLE).enumerate() {
        let at = HEADER + triangle * TRIANGLE;
        for (corner, numbers) in record[VECTOR..4 * VECTOR].chunks_exact(VECTOR).enumerate() {
            let at = at + (corner + 1) * VECTOR;
            let index = mesh.vertices() as u32;
            mesh.vertex(position(numbers, at)?, Place::Byte(at))?;
            mesh.corner(index);
        }
        mesh.end_face(Place::Byte(at))?;
    }
    mesh.finish(end).map(merged_exactly)
}

/// Three finite numbers, the first at byte `at` of the file.
fn position(numbers: &[u8], at: usize) -> Result<[f64; 3], ReadError> {
    let mut position = [0.0; 3];
    for (axis, (coordinate, bytes)) in position.iter_mut().zip(numbers.chunks_exact(4)).enumerate() {
        *coordinate = f64::from(f32::from_le_bytes(bytes.try_into().unwrap_or_default()));
        if !coordinate.is_finite() {
            let kind = ReadErrorKind::NotFinite(coordinate.to_string());
            return Err(ReadError { place: Place::Byte(at + 4 * axis), kind });
        }
    }
    Ok(position)
}

/// The bytes of a binary STL file. Every coordinate is rounded to f32, by up to 6e-8 of itself (2^-24); vertices that
/// no triangle uses are left out.
///
/// # Errors
/// [`WriteError::BeyondF32`] when a coordinate has no f32.
pub fn write(mesh: &TriangleMesh) -> Result<Vec<u8>, WriteError> {
    let mut bytes = Vec::with_capacity(HEADER + TRIANGLE * mesh.triangles().len());
    // Not beginning with `solid`, for readers that judge by that.
    bytes.extend_from_slice(b"binary STL");
    bytes.resize(HEADER - 4, b' ');
    bytes.extend_from_slice(&(mesh.triangles().len() as u32).to_le_bytes());
    for (corners, &indices) in mesh.corner_positions().zip(mesh.triangles()) {
        extend(&mut bytes, unit_normal(corners));
        for (corner, index) in corners.into_iter().zip(indices) {
            if !corner.as_vec3().is_finite() {
                return Err(WriteError::BeyondF32 { vertex: index, position: corner });
            }
            extend(&mut bytes, corner);
        }
        bytes.extend_from_slice(&[0, 0]);
    }
    Ok(bytes)
}

/// A vector as three f32.
fn extend(bytes: &mut Vec<u8>, vector: DVec3) {
    for number in vector.as_vec3().to_array() {
        bytes.extend_from_slice(&number.to_le_bytes());
    }
}
