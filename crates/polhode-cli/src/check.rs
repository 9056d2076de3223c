//! `polhode check`: validates a scene.

use crate::args::CheckArgs;
use crate::failure::{self, Failure};
use crate::progress::Progress;
use crate::{scene, stdout, text};

/// Loads the scene and prepares it, which finds bodies that overlap.
pub(crate) fn check(args: &CheckArgs) -> Result<(), Failure> {
    let progress = Progress::new("checking the scene");
    let loaded = scene::load(&args.scene)?;
    scene::prepare(&loaded, &args.scene.changes)?;
    drop(progress);
    for warning in loaded.scene.warnings() {
        failure::remark(&format!("warning: {}: {warning}", loaded.scene.name()));
    }
    let bodies = loaded.scene.bodies();
    let fixed = bodies.iter().filter(|body| body.is_fixed()).count();
    let (path, name, duration) = (args.scene.scene.display(), loaded.scene.name(), loaded.scene.duration_s());
    let mut page = format!("{path}: {name}: fine; bodies: {} ({fixed} fixed); duration: {duration} s\n", bodies.len());
    page.push_str(&text::approximations(&loaded.scene));
    stdout::text(&page)
}
