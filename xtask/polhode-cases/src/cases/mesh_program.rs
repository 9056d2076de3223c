//! What the program `polhode mesh` prints about a mesh.

use super::Context;
use polhode::mesh::TriangleMesh;
use serde_json::Value;
use std::error::Error;
use std::fmt::Write as _;
use std::process::Command;

/// The report of the program.
pub(super) struct Reported(Value);

/// Runs `polhode mesh --json` on a file of this mesh, with further arguments.
///
/// # Errors
/// When the program does not build or run, or refuses the mesh.
pub(super) fn report(
    context: &Context,
    name: &str,
    mesh: &TriangleMesh,
    arguments: &[&str],
) -> Result<Reported, Box<dyn Error>> {
    let program = context.program.path(&context.root)?;
    let file = program.with_file_name(format!("verify-{name}.obj"));
    let mut text = String::new();
    for v in mesh.vertices() {
        writeln!(text, "v {:?} {:?} {:?}", v.x, v.y, v.z)?;
    }
    for [a, b, c] in mesh.triangles() {
        writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1)?;
    }
    std::fs::write(&file, text)?;
    let output = Command::new(program).arg("mesh").arg(&file).arg("--json").args(arguments).output()?;
    std::fs::remove_file(&file)?;
    if !output.status.success() {
        return Err(format!("polhode mesh: {}", String::from_utf8_lossy(&output.stderr)).into());
    }
    Ok(Reported(serde_json::from_slice(&output.stdout)?))
}

impl Reported {
    /// A number.
    pub(super) fn number(&self, key: &str) -> Result<f64, Box<dyn Error>> {
        self.0[key].as_f64().ok_or_else(|| format!("the program prints no number {key}").into())
    }

    /// Three numbers.
    pub(super) fn vector(&self, key: &str) -> Result<[f64; 3], Box<dyn Error>> {
        Ok(serde_json::from_value(self.0[key].clone())?)
    }

    /// Elements xx, yy, zz, xy, xz, yz of a symmetric matrix.
    pub(super) fn six(&self, key: &str) -> Result<[f64; 6], Box<dyn Error>> {
        let m: [[f64; 3]; 3] = serde_json::from_value(self.0[key].clone())?;
        Ok([m[0][0], m[1][1], m[2][2], m[0][1], m[0][2], m[1][2]])
    }
}
