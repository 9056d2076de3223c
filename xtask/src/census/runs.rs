//! One run of a scene by one tier, bounded in steps and time, with what can be asked on the way.

use super::options::Options;
use super::subjects::{Source, Subject};
use polhode::{BodySample, ErrorEstimation, Event, Flow, Observer, Simulation};
use polhode_response::census;
use std::collections::BTreeMap;
use std::error::Error;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Steps and events after which a run is ended.
const MOST_STEPS: u64 = 20_000;

/// Pieces of a run, after each of which forces and loads are asked for.
const PIECES: u32 = 4;

/// Bodies of scenes that are asked how firmly they stand.
const MOST_STANDING: usize = 30;

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Ending {
    Completed,
    /// Ended after many steps or a long time.
    Late,
    /// The tier does not take the scene.
    Refused,
    Failed,
    Panicked,
}

/// How runs ended.
#[derive(Debug, Default)]
pub(super) struct Ends(BTreeMap<Ending, u32>);

impl Ends {
    pub(super) fn add(&mut self, ending: Ending) {
        *self.0.entry(ending).or_default() += 1;
    }
}

impl fmt::Display for Ends {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, (ending, count)) in self.0.iter().enumerate() {
            let word = format!("{ending:?}").to_lowercase();
            write!(f, "{}{word} {count}", if place == 0 { "" } else { ", " })?;
        }
        Ok(())
    }
}

struct Watch {
    steps: u64,
    start: Instant,
    most: Duration,
}

impl Watch {
    fn is_late(&self) -> bool {
        self.steps > MOST_STEPS || self.start.elapsed() > self.most
    }
}

impl Observer for Watch {
    fn sample(&mut self, _: f64, _: &[BodySample]) {}

    fn event(&mut self, _: &Event) {
        self.steps += 1;
    }

    fn progress(&mut self, _: f64) -> Flow {
        self.steps += 1;
        if self.is_late() { Flow::Stop } else { Flow::Continue }
    }
}

/// Runs all scenes in all tiers asked for.
pub(super) fn all(subjects: &[Subject], options: &Options) -> Ends {
    let (next, ends) = (AtomicUsize::new(0), Mutex::new(Ends::default()));
    let work = || {
        while let Some(subject) = subjects.get(next.fetch_add(1, Ordering::Relaxed)) {
            eprint!("\r{} of {} ", next.load(Ordering::Relaxed).min(subjects.len()), subjects.len());
            for tier in subject.tiers(&options.tiers) {
                let ending = run(subject, tier, options.seconds);
                ends.lock().unwrap_or_else(PoisonError::into_inner).add(ending);
            }
        }
    };
    std::thread::scope(|scope| {
        (0..options.threads.max(1)).for_each(|_| {
            scope.spawn(work);
        });
    });
    eprintln!();
    ends.into_inner().unwrap_or_else(PoisonError::into_inner)
}

/// Runs a scene by a tier; none is its own.
fn run(subject: &Subject, tier: Option<&str>, seconds: f64) -> Ending {
    census::set_scene(&format!("{} ({})", subject.name, tier.unwrap_or("its own tier")));
    catch_unwind(AssertUnwindSafe(|| started(subject, tier, seconds).unwrap_or(Ending::Refused)))
        .unwrap_or(Ending::Panicked)
}

fn started(subject: &Subject, tier: Option<&str>, seconds: f64) -> Result<Ending, Box<dyn Error>> {
    let text = subject.text(tier)?;
    let folder = tempfile::tempdir()?;
    for (name, mesh) in &text.meshes {
        std::fs::write(folder.path().join(name), mesh)?;
    }
    let origin = match &subject.from {
        Source::File(path) => path.clone(),
        _ => folder.path().join("scene.toml"),
    };
    let most = Duration::try_from_secs_f64(seconds)?;
    let watch = Watch { steps: 0, start: Instant::now(), most };
    simulate(&origin, &text.toml, subject, tier, watch)
}

fn simulate(
    origin: &Path,
    text: &str,
    subject: &Subject,
    tier: Option<&str>,
    mut watch: Watch,
) -> Result<Ending, Box<dyn Error>> {
    let loaded = polhode_scene::load_text(&origin.display().to_string(), text, &subject.overrides(tier))?;
    let mut simulation = Simulation::new(&loaded.scene)?.estimating(ErrorEstimation::Off);
    let is_small = loaded.scene.bodies().len() <= MOST_STANDING;
    for piece in 1..=PIECES {
        ask(&mut simulation, is_small && piece == 1);
        let end = loaded.scene.duration_s() * f64::from(piece) / f64::from(PIECES);
        if simulation.advance_to_observed(end, &mut watch).is_err() {
            return Ok(Ending::Failed);
        }
        if watch.is_late() {
            return Ok(Ending::Late);
        }
    }
    ask(&mut simulation, false);
    Ok(if simulation.report_so_far().is_ok() { Ending::Completed } else { Ending::Failed })
}

/// Asks for all that is solved for on demand; what cannot be told is no matter here.
fn ask(simulation: &mut Simulation, and_stability: bool) {
    let _ = simulation.accelerations();
    let _ = simulation.contacts();
    let _ = simulation.pivots();
    let _ = simulation.joint_loads();
    if and_stability {
        let _ = simulation.stability();
    }
}
