//! The program that prints strict hashes, built for a platform.

use super::tools::Tools;
use polhode_cases::cargo::cargo;
use serde::Deserialize;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Name of the program and of its crate.
const NAME: &str = "strict-hash";

/// A line that cargo prints about what it makes (The Cargo Book, "External tools", JSON messages); other lines have no
/// executable.
#[derive(Debug, Deserialize)]
struct Message {
    executable: Option<PathBuf>,
}

/// A program that has been built, and how it is run.
#[derive(Debug)]
pub(super) struct Program {
    words: Vec<String>,
    root: PathBuf,
}

impl Program {
    /// Builds it; what the compiler says goes to stderr.
    ///
    /// # Errors
    /// When it cannot be built.
    pub(super) fn build(root: &Path, tools: &Tools) -> Result<Self, String> {
        let mut command = cargo(root);
        command.args(["rustc", "--release", "--package", NAME, "--bin", NAME]);
        command.args(["--message-format", "json-render-diagnostics"]);
        if let Tools::Cross(tools) = tools {
            command.args(["--target", tools.target]).arg("--").args(tools.codegen);
            command.envs(tools.environment.iter().map(|(name, value)| (name, value)));
        }
        let output = command.stdin(Stdio::null()).stderr(Stdio::inherit()).output();
        let output = output.map_err(|error| format!("cargo does not run: {error}"))?;
        if !output.status.success() {
            return Err(format!("{NAME} cannot be built ({}); what the compiler says is above", output.status));
        }
        let built = executable(&String::from_utf8_lossy(&output.stdout));
        let built = built.ok_or_else(|| format!("cargo names no program that it built for {NAME}"))?;
        let mut words = match tools {
            Tools::Here => Vec::new(),
            Tools::Cross(tools) => tools.runner.clone(),
        };
        words.push(built.display().to_string());
        Ok(Self { words, root: root.to_owned() })
    }

    /// The command that runs it in the folder of the workspace.
    pub(super) fn command(&self) -> Command {
        let mut command = Command::new(&self.words[0]);
        command.args(&self.words[1..]).current_dir(&self.root);
        command
    }
}

/// The program among the lines that cargo printed.
fn executable(lines: &str) -> Option<PathBuf> {
    lines.lines().filter_map(|line| serde_json::from_str::<Message>(line).ok()?.executable).next_back()
}

#[cfg(test)]
mod tests {
    //! The program is found among what cargo says.
    use super::*;

    #[test]
    fn the_program_is_the_one_with_an_executable() {
        let lines = "{\"reason\":\"compiler-artifact\",\"executable\":null}\n\
                     {\"reason\":\"compiler-artifact\",\"executable\":\"a/strict-hash.wasm\"}\n\
                     {\"reason\":\"build-finished\",\"success\":true}\n";
        assert_eq!(executable(lines), Some(PathBuf::from("a/strict-hash.wasm")));
        assert_eq!(executable("words"), None);
    }
}
