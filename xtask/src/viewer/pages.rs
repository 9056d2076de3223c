//! The pages that the program writes, as its users get them.

use polhode_cases::Context;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Exit code of the program when all is well.
const FINE: i32 = 0;
/// Exit code of the program when a run has failed.
const RUN_FAILED: i32 = 1;

/// A page of a shipped scene.
struct ShippedPage {
    /// Its name, and that of its committed picture.
    name: &'static str,
    /// The scene.
    scene: &'static str,
    /// What is changed of it.
    changes: &'static [&'static str],
    /// The program's exit code.
    exit_code: i32,
}

/// Shapes of every kind with contacts; many bodies that fall in on each other; free rotation; a run that stops with an
/// error.
const PAGES: &[ShippedPage] = &[
    ShippedPage { name: "toppling-shapes", scene: "toppling-shapes", changes: &[], exit_code: FINE },
    ShippedPage { name: "diamond-5", scene: "diamond-5", changes: &[], exit_code: FINE },
    ShippedPage { name: "dzhanibekov", scene: "dzhanibekov", changes: &[], exit_code: FINE },
    ShippedPage {
        name: "stopped",
        // It falls into a point that attracts it, where the force is singular.
        scene: "dzhanibekov",
        changes: &["--set", "forces=[{type={point_gravity={center=[0,0,3],mu=1.0}}}]", "--duration", "10"],
        exit_code: RUN_FAILED,
    },
];

/// Writes the pages into a folder; where they are.
///
/// # Errors
/// When the program does not build, or ends otherwise than expected.
pub(super) fn write(context: &Context, folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let program = context.program.path(&context.root)?;
    let mut pages = Vec::new();
    for page in PAGES {
        let path = folder.join(page.name).with_extension("html");
        let mut command = Command::new(program);
        command.arg("view").arg(context.shipped.path(page.scene)).args(page.changes).arg("-o").arg(&path);
        let output = command.output()?;
        if output.status.code() != Some(page.exit_code) {
            let (status, words) = (output.status, String::from_utf8_lossy(&output.stderr));
            return Err(format!("polhode view, page {}: {status}, not {}: {words}", page.name, page.exit_code).into());
        }
        pages.push(path);
    }
    Ok(pages)
}
