//! PLY files from meshes: coordinates as `double`, indices as `uint`.

use crate::triangle_mesh::TriangleMesh;
use std::fmt::Write;

/// The header of a mesh's file.
fn header(mesh: &TriangleMesh, encoding: &str) -> String {
    format!(
        "ply\nformat {encoding} 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
        mesh.vertices().len(),
        mesh.triangles().len()
    )
}

/// The text of an ASCII PLY file. Numbers have the fewest digits that read back as the same bits.
pub fn write_text(mesh: &TriangleMesh) -> String {
    let mut text = header(mesh, "ascii");
    // Writing to a string cannot fail.
    for v in mesh.vertices() {
        let _ = writeln!(text, "{:?} {:?} {:?}", v.x, v.y, v.z);
    }
    for [a, b, c] in mesh.triangles() {
        let _ = writeln!(text, "3 {a} {b} {c}");
    }
    text
}

/// The bytes of a little-endian binary PLY file, which hold every bit of the mesh.
pub fn write_binary(mesh: &TriangleMesh) -> Vec<u8> {
    let mut bytes = header(mesh, "binary_little_endian").into_bytes();
    // 24 bytes a vertex and 13 a triangle.
    bytes.reserve(24 * mesh.vertices().len() + 13 * mesh.triangles().len());
    for number in mesh.vertices().iter().flat_map(glam::DVec3::to_array) {
        bytes.extend_from_slice(&number.to_le_bytes());
    }
    for triangle in mesh.triangles() {
        bytes.push(3);
        for index in triangle {
            bytes.extend_from_slice(&index.to_le_bytes());
        }
    }
    bytes
}
