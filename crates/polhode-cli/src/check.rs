//! `polhode check`: validates a scene, and tells what was found in its robot files.

use crate::args::CheckArgs;
use crate::failure::{self, Failure};
use crate::progress::Progress;
use crate::{scene, stdout, text};
use std::fmt::Write as _;

/// Loads the scene and prepares it, which finds bodies that overlap.
pub(crate) fn check(args: &CheckArgs) -> Result<(), Failure> {
    let progress = Progress::new("checking the scene");
    let loaded = scene::load(&args.scene)?;
    let findings = loaded.examine_robots();
    let mut page = String::new();
    for finding in loaded.findings().chain(&findings) {
        let _ = writeln!(page, "{finding}");
    }
    let prepared = scene::prepare(&loaded, &args.scene.changes);
    drop(progress);
    if let Err(failure) = prepared {
        stdout::text(&page)?;
        return Err(failure);
    }
    for warning in loaded.scene.warnings() {
        failure::remark(&format!("warning: {}: {warning}", loaded.scene.name()));
    }
    let bodies = loaded.scene.bodies();
    let fixed = bodies.iter().filter(|body| body.is_fixed()).count();
    let (path, name, duration) = (args.scene.scene.display(), loaded.scene.name(), loaded.scene.duration_s());
    let _ = writeln!(page, "{path}: {name}: fine; bodies: {} ({fixed} fixed); duration: {duration} s", bodies.len());
    page.push_str(&text::approximations(&loaded.scene));
    stdout::text(&page)
}
