//! The cargo that builds what a case or a check needs.

use crate::snapshot_environment::without_snapshot_environment;
use std::path::Path;
use std::process::Command;

/// The cargo that runs this program, in `root`.
pub fn cargo(root: &Path) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.current_dir(root);
    without_snapshot_environment(&mut command);
    command
}
