//! What every fuzz target checks: any bytes give a mesh or an error, and a mesh can be diagnosed, mended, written and
//! read back as it was.
//!
//! With cargo-fuzz, from the folder of polhode-mesh, ten minutes of one reader:
//!
//! ```text
//! cargo fuzz run -s none ply fuzz/corpus/ply fuzz/seeds/ply -- -max_total_time=600 -timeout=5 -rss_limit_mb=1024
//! ```

use polhode_mesh::{Encoding, MeshFormat, RepairOptions, TriangleMesh, diagnose, format, repair};

/// Reads bytes as a file of one format, and checks what comes of them.
///
/// # Panics
/// When the mesh does not read back as it was: a finding.
pub fn check(bytes: &[u8], format: MeshFormat) {
    let mesh = match format::read(bytes, format) {
        Ok(mesh) => mesh,
        Err(error) => {
            assert!(error.to_string().len() < 1000, "an error of endless length");
            return;
        }
    };
    let _ = diagnose(&mesh);
    let _ = repair(&mesh, &RepairOptions { weld_tolerance: 0.01, largest_hole: 1.0 });
    for encoding in [Encoding::Text, Encoding::Binary] {
        let Ok(written) = format::write(&mesh, format, encoding) else { continue };
        let read = format::read(&written, format);
        if encoding == format.exact_encoding() {
            let read = read.as_ref().map(corners);
            assert_eq!(read, Ok(corners(&mesh)), "does not read back");
        } else {
            assert!(read.is_ok(), "does not read back: {read:?}");
        }
    }
}

/// Positions of all corners; 0 and -0 are the same position, of which STL keeps the first.
fn corners(mesh: &TriangleMesh) -> Vec<[f64; 9]> {
    mesh.corner_positions().map(|[a, b, c]| [a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z]).collect()
}
