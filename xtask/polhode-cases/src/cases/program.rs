//! The program `polhode`, which some cases run.
//!
//! It is built once: each call of cargo waits until no other one builds, and cases would wait with it while lints and
//! tests are built.

use crate::cargo::cargo;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// Folder of what is built with the profile for development.
const DEBUG_FOLDER: &str = "debug";

/// The program, built when it is first asked for.
#[derive(Debug, Default)]
pub struct Program {
    built: OnceLock<Result<PathBuf, String>>,
}

impl Program {
    /// Where the program of the workspace in `root` is: beside this one, built with the same profile.
    ///
    /// # Errors
    /// When it does not build.
    pub fn path(&self, root: &Path) -> Result<&Path, Box<dyn Error>> {
        let built = self.built.get_or_init(|| build(root).map_err(|error| error.to_string()));
        Ok(built.as_ref().map_err(Clone::clone)?)
    }
}

fn build(root: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let own = std::env::current_exe()?;
    let folder = own.parent().ok_or("this program lies in no folder")?;
    let mut command = cargo(root);
    command.args(["build", "--quiet", "--package", "polhode-cli", "--package", "one-build"]);
    if !folder.ends_with(DEBUG_FOLDER) {
        command.arg("--release");
    }
    if !command.status()?.success() {
        return Err("the program polhode does not build".into());
    }
    Ok(folder.join(format!("polhode{}", std::env::consts::EXE_SUFFIX)))
}
