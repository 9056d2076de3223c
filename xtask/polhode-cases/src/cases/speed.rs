//! Speed and memory, for information: figures of a machine never decide.

use super::diamonds::{Sides, diamond};
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use polhode::Effects;
use std::error::Error;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

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
    let program = context.program.path(&context.root)?;
    let scene = context.shipped.path("diamond-4");
    Ok(vec![match peak_of(Command::new(program).arg("run").arg(scene))? {
        Some(kilobytes) => Row::info("memory", quantity, MEGABYTES, kilobytes as f64 / 1000.0),
        None => Row::skipped("memory", quantity, "this system does not say how much memory a process has used"),
    }])
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
