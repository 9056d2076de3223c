//! What can be asked of the machine that the command runs on: its environment, and which programs run.

use std::path::Path;
use std::process::{Command, Stdio};

/// A machine; tests make one up.
pub(super) trait Machine {
    /// The value of a variable of the environment, unless it is empty.
    fn variable(&self, name: &str) -> Option<String>;

    /// What a command prints, if it succeeds.
    fn printed(&self, words: &[&str]) -> Option<String>;

    /// Whether a folder holds a file whose name begins so.
    fn holds(&self, folder: &Path, beginning: &str) -> bool;

    /// Whether a program is on the path: every one that is asked for here says its version.
    fn has(&self, program: &str) -> bool {
        self.printed(&[program, "--version"]).is_some()
    }
}

/// The machine that the command runs on.
#[derive(Debug, Clone, Copy)]
pub(super) struct ThisMachine;

impl Machine for ThisMachine {
    fn variable(&self, name: &str) -> Option<String> {
        std::env::var(name).ok().filter(|value| !value.trim().is_empty())
    }

    fn printed(&self, words: &[&str]) -> Option<String> {
        let (program, arguments) = words.split_first()?;
        let output = Command::new(program).args(arguments).stdin(Stdio::null()).output().ok()?;
        output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
    }

    fn holds(&self, folder: &Path, beginning: &str) -> bool {
        let Ok(entries) = std::fs::read_dir(folder) else { return false };
        entries.flatten().any(|entry| entry.file_name().to_string_lossy().starts_with(beginning))
    }
}
