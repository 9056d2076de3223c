//! `polhode run`: simulates a scene.

use crate::args::RunArgs;
use crate::failure::{self, Failure};
use crate::{cost, scene, stdout, text};
use indicatif::{ProgressBar, ProgressStyle};
use polhode::{BodySample, Event, Flow, Observer, Outcome, RunReport};
use polhode_scene::{Outputs, load_with, report_json};
use std::io::IsTerminal;
use std::time::Instant;

/// Simulates, writes the files asked for and prints the report.
pub(crate) fn run(args: &RunArgs) -> Result<(), Failure> {
    let mut changes = scene::overrides(&args.scene)?;
    if let Some(accuracy) = args.accuracy {
        changes.extend(cost::settings_for(&args.scene, accuracy)?);
    }
    let loaded = load_with(&args.scene.scene, &changes)?;
    let outputs = Outputs::create(&loaded.scene, &args.output, args.events.as_deref())?;
    let started = Instant::now();
    let mut simulation = scene::prepare(&loaded, &args.scene)?;
    if !args.json {
        match stdout::text(&text::plan(loaded.scene.name(), simulation.plan())) {
            // Files are still wanted when nobody reads the report.
            Err(Failure::StdoutClosed) => {}
            printed => printed?,
        }
    }
    let mut watch = Watch { outputs, bar: Bar::new(loaded.scene.duration_s()) };
    let outcome = simulation.run(&mut watch);
    let wall_s = started.elapsed().as_secs_f64();
    watch.bar.clear();
    match outcome {
        Ok(report) => {
            watch.outputs.finish()?;
            if args.json {
                stdout::json(&report_json(&report, wall_s))?;
            } else {
                stdout::text(&text::report(&report, wall_s))?;
            }
            match report.outcome {
                Outcome::Completed | Outcome::Stopped => Ok(()),
                Outcome::Degraded => Err(Failure::Check(degraded(&report))),
            }
        }
        Err(error) => {
            // A run that has diverged is worth looking at: what it had written is kept beside the name asked for.
            for path in watch.outputs.keep_partial()? {
                failure::note(&format!("note: what was computed is in {}", path.display()));
            }
            Err(scene::failed(&loaded, error))
        }
    }
}

/// What a run that has not kept its promise says on stderr.
fn degraded(report: &RunReport) -> String {
    let first = report.warnings.first().map_or("", String::as_str);
    format!("degraded: {}: the run has not kept what its method promises: {first}", report.scene)
}

/// Writes files and shows progress.
struct Watch {
    outputs: Outputs,
    bar: Bar,
}

impl Observer for Watch {
    fn sample(&mut self, t: f64, bodies: &[BodySample]) {
        self.outputs.sample(t, bodies);
    }

    fn event(&mut self, event: &Event) {
        self.outputs.event(event);
    }

    fn progress(&mut self, t: f64) -> Flow {
        self.bar.advance(t);
        self.outputs.progress(t)
    }
}

/// Parts that the bar divides the duration into.
const PARTS: f64 = 1000.0;

/// A progress bar on stderr, when that is a terminal.
struct Bar {
    bar: Option<ProgressBar>,
    duration_s: f64,
}

impl Bar {
    fn new(duration_s: f64) -> Self {
        let bar = std::io::stderr().is_terminal().then(|| {
            let bar = ProgressBar::new(PARTS as u64);
            match ProgressStyle::with_template("{wide_bar} {msg} {elapsed} (eta {eta})") {
                Ok(style) => bar.with_style(style),
                Err(_) => bar,
            }
        });
        Self { bar, duration_s }
    }

    fn advance(&self, t: f64) {
        if let Some(bar) = &self.bar {
            bar.set_position((PARTS * t / self.duration_s) as u64);
            bar.set_message(format!("{t:.3} of {} s", self.duration_s));
        }
    }

    fn clear(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
