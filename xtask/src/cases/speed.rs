//! Speed and memory, for information: figures of a machine never decide.

use super::diamonds::{Sides, diamond};
use super::run::Run;
use super::{CaseResult, Context};
use crate::commands;
use crate::row::Row;
use polhode::Effects;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// Folder of what is built with the profile for development.
const DEBUG_FOLDER: &str = "debug";

/// Simulated seconds per second of wall time of the 4-diamond with every effect simulated.
pub(super) fn diamond_4(_context: &Context) -> CaseResult {
    /// Asked for.
    const RATE: f64 = 10.0;
    let run = Run::of(&diamond(4, Sides::Collide, 60.0)?, Effects::All)?;
    let rate = run.report.simulated_s / run.wall_s;
    Ok(vec![Row::info("speed", "4-diamond, all effects: simulated s per s (asked: 10)", RATE, rate)])
}

/// Peak memory of the program on the 4-diamond, as users run it.
pub(super) fn peak_memory(context: &Context) -> CaseResult {
    /// Asked for, MB.
    const MEGABYTES: f64 = 50.0;
    let quantity = "polhode run diamond-4: peak memory, MB (asked: < 50)";
    let program = build_program(&context.root)?;
    let scene = context.shipped.path("diamond-4");
    Ok(vec![match peak_of(Command::new(program).arg("run").arg(scene))? {
        Some(kilobytes) => Row::info("memory", quantity, MEGABYTES, kilobytes as f64 / 1000.0),
        None => Row::skipped("memory", quantity, "this system does not say how much memory a process has used"),
    }])
}

/// Builds the program and returns where it is: beside this one, which was built with the same profile.
pub(crate) fn build_program(root: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let own = std::env::current_exe()?;
    let folder = own.parent().ok_or("this program lies in no folder")?;
    let mut command = commands::cargo(root);
    command.args(["build", "--quiet", "--package", "polhode-cli"]);
    if !folder.ends_with(DEBUG_FOLDER) {
        command.arg("--release");
    }
    if !command.status()?.success() {
        return Err("the program polhode does not build".into());
    }
    Ok(folder.join(format!("polhode{}", std::env::consts::EXE_SUFFIX)))
}

/// Largest resident memory of a command until it ends, kB, where the system tells.
fn peak_of(command: &mut Command) -> Result<Option<u64>, Box<dyn Error>> {
    /// Between two looks.
    const INTERVAL: Duration = Duration::from_millis(2);
    let mut child = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn()?;
    let status_file = format!("/proc/{}/status", child.id());
    let mut peak = None;
    loop {
        let high_water = std::fs::read_to_string(&status_file).ok().and_then(|text| high_water_mark(&text));
        peak = peak.max(high_water);
        if let Some(status) = child.try_wait()? {
            return if status.success() { Ok(peak) } else { Err(format!("polhode run: {status}").into()) };
        }
        sleep(INTERVAL);
    }
}

/// The line `VmHWM: 1234 kB` of a process's status.
fn high_water_mark(status: &str) -> Option<u64> {
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.split_whitespace().next()?.parse().ok()
}
