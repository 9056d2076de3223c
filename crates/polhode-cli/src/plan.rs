//! `polhode plan`: which effects are on or off, why, and what that saves.

use crate::args::PlanArgs;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::{scene, stdout, text};
use polhode_scene::plan_with_accelerations_json;

/// Derives and prints the plan and the accelerations at t = 0.
pub(crate) fn plan(args: &PlanArgs) -> Result<(), Failure> {
    let progress = Progress::new("making the plan");
    let loaded = scene::load(&args.scene)?;
    let mut simulation = scene::prepare(&loaded, &args.scene.changes)?;
    let accelerations = simulation.accelerations().map_err(|error| scene::failed(&loaded, error))?;
    drop(progress);
    let plan = scene::with_origins(&loaded, simulation.plan());
    if args.json {
        return stdout::json(&plan_with_accelerations_json(&loaded.scene, &plan, &accelerations));
    }
    let mut page = text::plan(&loaded, &plan);
    page.push_str(&text::accelerations(&loaded.scene, &accelerations));
    stdout::text(&page)
}
