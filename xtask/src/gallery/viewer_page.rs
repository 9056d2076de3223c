//! Pages that play one scene, or two beside each other: what `polhode view` makes, with fewer frames.

use polhode::{Outcome, Simulation};
use polhode_scene::{LoadedScene, report_json};
use polhode_view::{FrameSource, Page};
use serde_json::Value;
use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

/// Frames a second.
const FRAMES_PER_SECOND: f64 = 60.0;
/// Frames of a run at the most: pages of a gallery are to be small.
const MOST_FRAMES: f64 = 1500.0;

/// Runs the scenes and writes the page that plays them.
///
/// # Errors
/// When a scene does not run to its end or the file cannot be written.
pub(super) fn write(
    path: &Path,
    title: &str,
    description: &str,
    scenes: &[&LoadedScene],
) -> Result<(), Box<dyn Error>> {
    let file = File::create(path).map_err(|error| format!("cannot write {}: {error}", path.display()))?;
    let mut page = Page::begin(BufWriter::new(file), title, description)?;
    let mut reports = Vec::new();
    for loaded in scenes {
        let scene = &loaded.scene;
        let interval_s = (1.0 / FRAMES_PER_SECOND).max(scene.duration_s() / MOST_FRAMES).min(scene.duration_s());
        let scene = scene.clone().with_output_interval(interval_s)?;
        let run = page.begin_run(&scene, scene.name(), FrameSource::Simulation)?;
        let mut run = run.shown_as(loaded.appearance());
        let report = Simulation::new(&scene)?.run_observed(&mut run)?;
        let outcome = if report.outcome == Outcome::Degraded { "degraded" } else { "completed" };
        page = run.end(outcome)?;
        let mut json = report_json(&report, 0.0);
        if let Some(object) = json.as_object_mut() {
            object.remove("wall_s");
        }
        reports.push(json);
    }
    let report = if reports.len() == 1 { reports.swap_remove(0) } else { Value::Array(reports) };
    page.finish(&report)?;
    Ok(())
}
