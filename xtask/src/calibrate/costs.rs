//! `cargo xtask calibrate --costs`: what estimates of the error cost, in instructions of whole runs of the program
//! (which repeat exactly), over the scenes that ship.
//!
//! Each scene is run by `valgrind --tool=cachegrind --cache-sim=no` without an estimate, with a quick and with a full
//! one. Scenes that take long are left out and named.

use polhode::ErrorEstimation;
use polhode_cases::cargo::cargo;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

/// A run that takes longer without counting is left out.
const LONG: Duration = Duration::from_secs(2);

/// At most so many times the instructions of a run without an estimate, by quick and full ones.
const MOST: [(ErrorEstimation, f64); 2] = [(ErrorEstimation::Quick, 1.3), (ErrorEstimation::Full, 4.0)];

/// Counts, and prints a line for each of the scenes whose names begin so, of them one in so many.
///
/// # Errors
/// When the program cannot be built, or the scenes cannot be listed.
pub(super) fn print(root: &Path, only: &str, every: usize) -> Result<ExitCode, Box<dyn Error>> {
    let built = cargo(root).args(["build", "--release", "--quiet", "--package", "polhode-cli"]).status()?;
    if !built.success() {
        return Err("the program cannot be built".into());
    }
    let program = root.join("target/release/polhode");
    let mut within = [0_usize; MOST.len()];
    let mut counted = 0;
    for scene in scenes(root, only, every)? {
        let name = scene.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let start = Instant::now();
        run(Command::new(&program), &scene, ErrorEstimation::Off).stderr(Stdio::null()).status()?;
        if start.elapsed() > LONG {
            println!("{name:36} left out: it takes {:.0} s", start.elapsed().as_secs_f64());
            continue;
        }
        let own = instructions(&program, &scene, ErrorEstimation::Off)?;
        let mut line = format!("{name:36} {:9.1} million", own as f64 / 1e6);
        for ((effort, most), within) in MOST.into_iter().zip(&mut within) {
            let times = instructions(&program, &scene, effort)? as f64 / own as f64;
            *within += usize::from(times <= most);
            let _ = write!(line, ", {} {times:.2}", effort.name());
        }
        counted += 1;
        println!("{line}");
    }
    for ((effort, most), within) in MOST.into_iter().zip(within) {
        println!("{}: {within} of {counted} scenes take at most {most} times the instructions", effort.name());
    }
    Ok(ExitCode::SUCCESS)
}

/// The scenes that ship and are meant, by name.
fn scenes(root: &Path, only: &str, every: usize) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let entries = fs::read_dir(root.join("fixtures/scenes"))?.collect::<Result<Vec<_>, _>>()?;
    let mut paths: Vec<PathBuf> = entries.into_iter().map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|kind| kind == "toml"));
    paths.retain(|path| path.file_name().is_some_and(|name| name.to_string_lossy().starts_with(only)));
    paths.sort();
    Ok(paths.into_iter().step_by(every.max(1)).collect())
}

/// The instructions of a run.
fn instructions(program: &Path, scene: &Path, effort: ErrorEstimation) -> Result<u64, Box<dyn Error>> {
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"]).arg(program);
    let output = run(valgrind, scene, effort).output().map_err(|error| format!("valgrind: {error}"))?;
    let text = String::from_utf8_lossy(&output.stderr);
    let line = text.lines().find(|line| line.contains('I') && line.contains("refs:"));
    let digits: Option<String> = line
        .and_then(|line| line.split("refs:").nth(1))
        .map(|count| count.chars().filter(char::is_ascii_digit).collect());
    Ok(digits.ok_or("valgrind printed no count of instructions")?.parse()?)
}

/// A run by this program.
fn run(mut program: Command, scene: &Path, effort: ErrorEstimation) -> Command {
    program.arg("run").arg(scene).args(["--quiet", "--error", effort.name()]).stdout(Stdio::null());
    program
}
