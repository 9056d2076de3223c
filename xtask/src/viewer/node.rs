//! What the viewer's tests need besides Rust: node, npm, the viewer's packages, and a browser.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// Folder of the viewer's sources in the workspace.
const FOLDER: &str = "crates/polhode-view/viewer";
/// How to get node and npm.
const INSTALL_NODE: &str = "install Node.js 20 or later with npm (Debian: apt-get install nodejs npm)";
/// How to get a browser.
const INSTALL_BROWSER: &str =
    "install Chromium (Debian: apt-get install chromium), or name a browser by the variable CHROMIUM";

/// Node, with the packages of the viewer.
#[derive(Debug)]
pub(crate) struct Node {
    folder: PathBuf,
}

impl Node {
    /// Finds node and npm, and installs the packages that are missing.
    ///
    /// # Errors
    /// Why that is not possible here, and what to install.
    pub(crate) fn with_packages(root: &Path) -> Result<Self, String> {
        let node = Self { folder: root.join(FOLDER) };
        for program in ["node", "npm"] {
            let runs = node.succeeds(program, &["--version"]);
            runs.map_err(|reason| format!("{program} does not run ({reason}): {INSTALL_NODE}"))?;
        }
        // `npm ls` fails where a package is missing or of another version than is asked for.
        if node.succeeds("npm", &["ls"]).is_err() {
            let installed = node.succeeds("npm", &["ci", "--no-audit", "--no-fund"]);
            installed.map_err(|reason| {
                format!("`npm ci` in {FOLDER} fails ({reason}): it takes the viewer's packages from the npm registry")
            })?;
        }
        Ok(node)
    }

    /// Folder of the viewer's sources.
    pub(super) fn folder(&self) -> &Path {
        &self.folder
    }

    /// The browser.
    ///
    /// # Errors
    /// That there is none, and what to install.
    pub(crate) fn browser(&self) -> Result<PathBuf, String> {
        let found = self.succeeds("node", &["test/chromium.mjs"]);
        found.map(|place| PathBuf::from(place.trim())).map_err(|_| format!("there is no browser: {INSTALL_BROWSER}"))
    }

    /// A command that runs a script of the viewer.
    pub(crate) fn script(&self, script: &str) -> Command {
        let mut command = self.command("node");
        command.arg(script);
        command
    }

    fn command(&self, program: &str) -> Command {
        let mut command = Command::new(program);
        command.current_dir(&self.folder).stdin(Stdio::null());
        command
    }

    /// Runs a program that must succeed; what it printed, or why it did not.
    fn succeeds(&self, program: &str, arguments: &[&str]) -> Result<String, String> {
        let output = self.command(program).args(arguments).output().map_err(|error| error.to_string())?;
        if output.status.success() {
            Ok(String::from_utf8_lossy(&output.stdout).into_owned())
        } else {
            Err(complaint(&output))
        }
    }
}

/// Characters of a complaint at the most.
const LONGEST_COMPLAINT: usize = 300;

/// How a program ended and what it wrote to stderr, on one line.
pub(super) fn complaint(output: &Output) -> String {
    let words = String::from_utf8_lossy(&output.stderr).split_whitespace().collect::<Vec<_>>().join(" ");
    let words: String = words.chars().take(LONGEST_COMPLAINT).collect();
    format!("{}; {words}", output.status)
}

#[cfg(test)]
mod tests {
    //! Where something is missing, the reason says what and how to get it.
    use super::*;

    #[test]
    fn a_program_that_is_not_there_is_a_reason() {
        let node = Node { folder: std::env::temp_dir() };
        assert!(node.succeeds("polhode-no-such-program", &[]).is_err());
        assert!(node.browser().is_err_and(|reason| reason.contains("CHROMIUM")));
    }
}
