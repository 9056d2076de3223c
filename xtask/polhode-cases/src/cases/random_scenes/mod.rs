//! Random scenes: every run ends, keeps the laws that the judge holds against it, and is the same run as that of the
//! scene mirrored, turned, moved, in other units, of all effects, and paused.
//!
//! How far a copy may differ is measured by a run that starts a little elsewhere: what grows from that grows from
//! rounding.
//!
//! | module | holds |
//! |---|---|
//! | `compare` | a scene and its copies |
//! | `trial` | one run of a random scene |
//! | `verdict` | the verdict on one random scene |

mod compare;
mod trial;
mod verdict;

use super::{Amount, CaseResult, Context};
use crate::row::Row;
use clap::Args;
use polhode_oracles::random_scene::generate;
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
pub use verdict::{Copies, Verdict};

const CASE: &str = "random scenes";
/// Scenes of a full run, and of a plain one.
const SCENES: u64 = 2000;
/// Seeds beyond those of the plain run in which a panic was found.
const FOUND: &[u64] = &[522];

const FEW_SCENES: u64 = 100;
/// Share of the scenes that may end degraded or failed, and that may be slow.
const MOST_FAILED: f64 = 0.02;
const MOST_SLOW: f64 = 0.01;

/// The verdicts on the scenes of some seeds, by one thread for each processor; `each` is called as they come.
///
/// # Errors
/// When one of the scenes cannot be written or read.
pub fn verdicts(
    seeds: std::ops::Range<u64>,
    copies: Copies,
    each: impl Fn(&Verdict) + Sync,
) -> Result<Vec<Verdict>, Box<dyn Error>> {
    let next = AtomicU64::new(seeds.start);
    let all: Mutex<Vec<Result<Verdict, String>>> = Mutex::default();
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let seed = next.fetch_add(1, Ordering::Relaxed);
                    if seed >= seeds.end {
                        break;
                    }
                    let verdict = Verdict::of(&generate::scene(seed), copies).map_err(|error| error.to_string());
                    if let Ok(verdict) = &verdict {
                        each(verdict);
                    }
                    if let Ok(mut all) = all.lock() {
                        all.push(verdict);
                    }
                }
            });
        }
    });
    let mut found = all.into_inner().map_err(|_| "a panic: a bug, whatever the input was")?;
    let mut verdicts = found.drain(..).collect::<Result<Vec<_>, _>>()?;
    verdicts.sort_by_key(|verdict| verdict.seed);
    Ok(verdicts)
}

/// Seeds, one after the other.
fn or_none(seeds: &[String]) -> String {
    if seeds.is_empty() { "none".to_owned() } else { seeds.join(" ") }
}

/// Random scenes are judged.
pub(super) fn scenes(context: &Context) -> CaseResult {
    let (count, copies) = match context.amount {
        Amount::Full => (SCENES, Copies::All),
        Amount::Part => (FEW_SCENES, Copies::One),
    };
    let mut found = Vec::new();
    for &seed in FOUND {
        found.extend(
            verdicts(seed..seed + 1, Copies::One, |_| {})?
                .iter()
                .filter(|own| own.panics())
                .map(|own| own.seed.to_string()),
        );
    }
    let verdicts = verdicts(0..count, copies, |_| {})?;
    let list = |is_meant: &dyn Fn(&Verdict) -> bool| {
        let seeds: Vec<String> =
            verdicts.iter().filter(|verdict| is_meant(verdict)).map(|verdict| verdict.seed.to_string()).collect();
        or_none(&seeds)
    };
    let share = |is_meant: &dyn Fn(&Verdict) -> bool| {
        verdicts.iter().filter(|verdict| is_meant(verdict)).count() as f64 / count as f64
    };
    let named = |what: &str| format!("{what}, of {count} scenes");
    for verdict in verdicts.iter().filter(|verdict| !verdict.is_right()) {
        eprintln!("{CASE}: {verdict}");
    }
    let slowest = verdicts.iter().map(|verdict| verdict.wall_s).fold(0.0, f64::max);
    let most_steps = verdicts.iter().map(|verdict| verdict.steps).max().unwrap_or_default();
    Ok(vec![
        Row::exact(CASE, &named("seeds that end well and break a law"), "none", list(&|v| v.breaks_a_law())),
        Row::exact(CASE, &named("seeds whose copies are other runs"), "none", list(&|v| v.differs())),
        Row::exact(CASE, &named("seeds that panic"), "none", list(&|v| v.panics())),
        Row::exact(CASE, "seeds that panicked once and do again", "none", or_none(&found)),
        Row::exact(CASE, &named("seeds that are refused"), "none", list(&|v| v.is_refused())),
        Row::at_most(CASE, &named("share that is degraded or fails"), MOST_FAILED, share(&|v| v.fails())),
        Row::at_most(CASE, &named("share that takes very many steps"), MOST_SLOW, share(&|v| v.is_slow())),
        Row::info(CASE, &named("one of several motions, as told"), "", list(&|v| v.is_one_of_several())),
        Row::info(CASE, &named("degraded or failed"), "", list(&|v| v.fails())),
        Row::info(CASE, &named("very many steps"), "", list(&|v| v.is_slow())),
        Row::info(CASE, &named("share that takes longer than 20 s here"), MOST_SLOW, share(&|v| v.is_late())),
        Row::info(CASE, &named("longer than 20 s here"), "", list(&|v| v.is_late())),
        Row::info(CASE, &named("longest run, s; most steps"), "", [slowest, most_steps as f64]),
    ])
}

/// What the command that judges takes.
#[derive(Debug, Args)]
pub struct Options {
    /// First seed.
    #[arg(default_value_t = 0)]
    first: u64,
    /// Number of seeds.
    #[arg(default_value_t = 1)]
    count: u64,
    /// Scene files that are judged instead.
    #[arg(long, num_args = 1.., conflicts_with_all = ["first", "count", "output"])]
    files: Vec<PathBuf>,
    /// Run every kind of copy of every scene instead of one.
    #[arg(long)]
    all_copies: bool,
    /// Folder that gets each scene that is not right.
    #[arg(short, long)]
    output: Option<PathBuf>,
}

/// Judges the scenes of some seeds and prints a line for each that is not right.
///
/// # Errors
/// When files cannot be written.
pub fn run(options: &Options) -> Result<ExitCode, Box<dyn Error>> {
    if !options.files.is_empty() {
        for path in &options.files {
            match Verdict::of_file(path) {
                Ok(verdict) => println!("{}: {verdict}", path.display()),
                Err(error) => println!("{}: not judged: {error}", path.display()),
            }
        }
        return Ok(ExitCode::SUCCESS);
    }
    let copies = if options.all_copies { Copies::All } else { Copies::One };
    let each = |verdict: &Verdict| {
        if verdict.is_right() {
            return;
        }
        println!("{verdict}");
        if let Some(folder) = &options.output {
            let stem = format!("random-{}", verdict.seed);
            let written = generate::scene(verdict.seed).written(&stem);
            let mut files = written.meshes;
            files.push((format!("{stem}.toml"), written.text));
            for (name, text) in files {
                if let Err(error) = std::fs::write(folder.join(&name), text) {
                    eprintln!("{name}: {error}");
                }
            }
        }
    };
    let verdicts = verdicts(options.first..options.first + options.count, copies, each)?;
    let right = verdicts.iter().filter(|verdict| verdict.is_right()).count();
    println!("{right} of {} right", verdicts.len());
    Ok(ExitCode::SUCCESS)
}
