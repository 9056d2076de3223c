//! Cost as instructions executed, which repeats exactly: the program runs itself under valgrind's cachegrind.
//!
//! A run is counted twice, once with and once without its steps; the difference leaves out starting the program,
//! reading the scene and preparing it.

use crate::args::ProbeArgs;
use crate::failure::Failure;
use crate::scene::{self, SceneText};
use polhode::Effects;
use polhode_scene::Override;
use std::io;
use std::process::{Command, Stdio};

/// The program that counts.
const VALGRIND: &str = "valgrind";

/// Whether it is there.
///
/// # Errors
/// What to do when it is not.
pub(crate) fn available() -> Result<(), Failure> {
    let found = Command::new(VALGRIND).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    match found {
        Ok(status) if status.success() => Ok(()),
        _ => Err(Failure::Usage(
            "error: --instructions needs valgrind, which is not found on PATH: install it, or leave the option out"
                .to_owned(),
        )),
    }
}

/// Instructions of the steps of one run.
///
/// # Errors
/// Why they could not be counted, in a line.
pub(crate) fn count(text: &SceneText<'_>, effects: Effects, changes: &[&Override]) -> Result<u64, String> {
    let started = counted(text, effects, changes, None)?;
    let whole = counted(text, effects, changes, Some("--run"))?;
    // At least one: a cost is positive.
    Ok(whole.saturating_sub(started).max(1))
}

fn counted(text: &SceneText<'_>, effects: Effects, changes: &[&Override], run: Option<&str>) -> Result<u64, String> {
    let program = std::env::current_exe().map_err(|error| fault(&error))?;
    let mut command = Command::new(VALGRIND);
    command.args(["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"]);
    command.arg(program).arg("probe").arg(text.name()).args(run);
    if effects == Effects::All {
        command.args(["--effects", "all"]);
    }
    for Override { key, value, .. } in changes {
        command.arg("--set").arg(format!("{key}={value}"));
    }
    let output = command.stdin(Stdio::null()).stdout(Stdio::null()).output().map_err(|error| fault(&error))?;
    let text = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Err(format!("counting instructions failed ({})", output.status));
    }
    instructions(&text).ok_or_else(|| "valgrind printed no count of instructions".to_owned())
}

fn fault(error: &io::Error) -> String {
    format!("counting instructions failed: {error}")
}

/// The number after `I refs:`.
fn instructions(text: &str) -> Option<u64> {
    let line = text.lines().find(|line| line.contains("refs:") && line.contains(" I "))?;
    let digits: String = line.split("refs:").nth(1)?.chars().filter(char::is_ascii_digit).collect();
    digits.parse().ok()
}

/// `polhode probe`: prepares a scene and, with `--run`, runs it, printing nothing. What valgrind counts.
pub(crate) fn probe(args: &ProbeArgs) -> Result<(), Failure> {
    let loaded = scene::load(&args.scene)?;
    let mut simulation = scene::prepare(&loaded, &args.scene.changes)?;
    if args.run {
        simulation.run().map_err(|error| scene::failed(&loaded, error))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    //! What valgrind prints is understood.
    use super::*;

    #[test]
    fn the_count_is_read() {
        let text = "==12== Cachegrind, a high-precision tracing profiler\n==12== I refs:        1,234,567\n";
        assert_eq!(instructions(text), Some(1_234_567));
        assert_eq!(instructions("==12== I   refs:      42"), Some(42));
        assert_eq!(instructions("==12== D refs: 42"), None);
    }
}
