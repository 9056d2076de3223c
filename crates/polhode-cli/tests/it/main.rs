//! The program: what it prints, what it writes, and its exit codes.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod bad_input;
mod check;
mod compare;
mod cost;
mod drop;
mod elastic;
mod every_day;
#[cfg(unix)]
mod help_examples;
#[cfg(unix)]
mod interrupts;
mod judge;
mod mechanisms;
mod mesh;
mod plan;
mod play;
mod plots;
mod report;
mod resume;
mod robots;
mod run;
mod second_opinion;
mod stands;
mod sweep;
mod uncertain;
mod usage;
mod view;
mod view_bad_input;

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

/// A body that is thrown and spins, and touches nothing.
pub(crate) const FLIGHT: &str = r#"
format = 1
name = "flight"
duration = 0.5

[output]
interval = 0.125

[[bodies]]
name = "stone, \"flat\""
mass = 2.0
inertia = [1, 2, 2.5]
velocity = [3, 0, 4]
angular_velocity = [0.5, 0.25, 0]
"#;

/// What the program has done.
pub(crate) struct Run {
    pub(crate) code: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Run {
    /// What it has printed, as JSON.
    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).unwrap_or_else(|error| panic!("{error}: {}{}", self.stdout, self.stderr))
    }
}

impl From<Output> for Run {
    fn from(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).unwrap();
        Self { code: output.status.code(), stdout: text(output.stdout), stderr: text(output.stderr) }
    }
}

/// A folder to run the program in.
pub(crate) struct Place(TempDir);

impl Place {
    pub(crate) fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    /// With a scene of this text as `scene.toml`.
    pub(crate) fn with_scene(text: &str) -> Self {
        let place = Self::new();
        place.write("scene.toml", text);
        place
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap()
    }

    /// Names of the files, sorted.
    pub(crate) fn list(&self) -> Vec<String> {
        let name = |entry: std::io::Result<std::fs::DirEntry>| entry.unwrap().file_name().into_string().unwrap();
        let mut names: Vec<_> = std::fs::read_dir(self.0.path()).unwrap().map(name).collect();
        names.sort();
        names
    }

    pub(crate) fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_polhode"));
        command.current_dir(self.0.path()).args(args);
        command
    }

    /// Runs the program in the folder.
    pub(crate) fn run(&self, args: &[&str]) -> Run {
        self.command(args).output().unwrap().into()
    }

    /// Runs the program and checks its exit code.
    #[track_caller]
    pub(crate) fn expect(&self, code: i32, args: &[&str]) -> Run {
        let run = self.run(args);
        assert_eq!(run.code, Some(code), "{args:?}\n{}{}", run.stdout, run.stderr);
        assert!(!run.stderr.contains("panicked"), "{}", run.stderr);
        run
    }
}

/// A file of the project's fixtures.
pub(crate) fn fixture(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures").join(name);
    path.to_str().unwrap().to_owned()
}
