//! The environment that insta needs: this program runs again with it, and its children do without it.

use std::error::Error;
use std::process::{Command, ExitCode};

/// What insta is told by its environment: never to stop the run, never to print, and when to write.
const ENVIRONMENT: [&str; 3] = ["INSTA_UPDATE", "INSTA_FORCE_PASS", "INSTA_OUTPUT"];

/// Whether goldens are written anew.
pub fn is_blessed() -> bool {
    std::env::var(ENVIRONMENT[0]).is_ok_and(|value| value == "force")
}

/// Runs this program again with the environment that insta needs, unless it is there already; returns the exit code
/// of that run.
///
/// # Errors
/// When the program cannot be started.
pub fn in_snapshot_environment(bless: bool) -> Result<Option<ExitCode>, Box<dyn Error>> {
    let values = [if bless { "force" } else { "no" }, "1", "none"];
    if ENVIRONMENT.iter().zip(values).all(|(name, value)| std::env::var(name).is_ok_and(|found| found == value)) {
        return Ok(None);
    }
    let status = Command::new(std::env::current_exe()?)
        .args(std::env::args_os().skip(1))
        .envs(ENVIRONMENT.into_iter().zip(values))
        .status()?;
    let code = status.code().and_then(|code| u8::try_from(code).ok());
    Ok(Some(code.map_or(ExitCode::FAILURE, ExitCode::from)))
}

/// Takes insta's environment away from a child, whose own snapshots are its own business.
pub fn without_snapshot_environment(command: &mut Command) {
    for name in ENVIRONMENT {
        command.env_remove(name);
    }
}
