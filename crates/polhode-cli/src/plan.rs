//! `polhode plan`: which effects are on or off, why, and what that saves.

use crate::args::PlanArgs;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::{scene, stdout, text};
use polhode::{Effects, Simulation, Stability};
use polhode_scene::{LoadedScene, plan_with_accelerations_json, stability_json};
use polhode_study::Threads;
use std::sync::Arc;

/// Derives and prints the plan and the accelerations at t = 0.
pub(crate) fn plan(args: &PlanArgs) -> Result<(), Failure> {
    let progress = Progress::new("making the plan");
    let loaded = scene::load(&args.scene)?;
    let mut simulation = scene::prepare(&loaded, &args.scene.changes)?;
    let accelerations = simulation.accelerations().map_err(|error| scene::failed(&loaded, error))?;
    let stability = stability(args, &loaded)?;
    drop(progress);
    scene::tell_of_robots(&loaded);
    let plan = scene::with_origins(&loaded, simulation.plan());
    if args.json {
        let mut value = plan_with_accelerations_json(&loaded.scene, &plan, &accelerations);
        if let Some(stability) = stability {
            value["stability"] = stability_json(&loaded.scene, &stability);
        }
        return stdout::json(&value);
    }
    let mut page = text::plan(&loaded, &plan);
    page.push_str(&text::accelerations(&loaded.scene, &accelerations));
    if let Some(stability) = stability {
        page.push('\n');
        page.push_str(&text::stability(&loaded.scene, &stability));
    }
    stdout::text(&page)
}

/// How far the bodies at rest are from moving, if it is asked for: in space, also where the motion is planar.
fn stability(args: &PlanArgs, loaded: &LoadedScene) -> Result<Option<Stability>, Failure> {
    if !args.stability {
        return Ok(None);
    }
    let simulation = Simulation::with_effects(&loaded.scene, Effects::All);
    let stability = simulation.and_then(|mut simulation| {
        simulation.set_executor(Arc::new(Threads::of_machine()));
        simulation.stability()
    });
    stability.map(Some).map_err(|error| scene::failed(loaded, error))
}
