//! The virtual environment in which the package is built and tested. It is made once, and again when its requirements
//! change.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// The interpreter that makes it.
const INTERPRETER: &str = "python3";
/// The oldest one that the package supports.
pub(super) const OLDEST: &str = "3.10";
/// Prints whether an interpreter is new enough.
const IS_NEW_ENOUGH: &str = "import sys; print(sys.version_info >= (3, 10))";
/// What it holds, in the folder of the package.
const REQUIREMENTS: &str = "requirements.txt";
/// The requirements that an environment was made from, in its folder.
const MADE_FROM: &str = "requirements-installed.txt";
/// Where programs of an environment are.
const PROGRAMS: &str = if cfg!(windows) { "Scripts" } else { "bin" };

/// A virtual environment.
#[derive(Debug)]
pub(super) struct Environment {
    /// Its folder.
    pub(super) folder: PathBuf,
}

impl Environment {
    /// The environment in this folder for the package in that one.
    ///
    /// # Errors
    /// The reason why there is none: no interpreter, or what it needs cannot be had.
    pub(super) fn made(folder: PathBuf, package: &Path) -> Result<Self, String> {
        let version = Command::new(INTERPRETER).args(["-c", IS_NEW_ENOUGH]).stdin(Stdio::null()).output();
        if !version.is_ok_and(|output| output.stdout.starts_with(b"True")) {
            return Err(format!(
                "{INTERPRETER} {OLDEST} or later is not here: python.org or the system's packages have it"
            ));
        }
        let wanted = package.join(REQUIREMENTS);
        let text = fs::read_to_string(&wanted).map_err(|error| format!("{REQUIREMENTS}: {error}"))?;
        let environment = Self { folder };
        let made_from = environment.folder.join(MADE_FROM);
        if fs::read_to_string(&made_from).is_ok_and(|installed| installed == text) {
            return Ok(environment);
        }
        let mut make = Command::new(INTERPRETER);
        make.args(["-m", "venv", "--clear"]).arg(&environment.folder);
        done(&mut make).map_err(|reason| format!("no virtual environment can be made: {reason}"))?;
        let mut install = environment.module("pip");
        install.args(["install", "--quiet", "--disable-pip-version-check", "--requirement"]).arg(&wanted);
        done(&mut install).map_err(|reason| {
            format!("its requirements cannot be installed, which needs a network or PIP_FIND_LINKS: {reason}")
        })?;
        fs::write(&made_from, text).map_err(|error| error.to_string())?;
        Ok(environment)
    }

    /// Runs a module of its interpreter.
    pub(super) fn module(&self, module: &str) -> Command {
        let mut command = Command::new(self.programs().join(format!("python{}", std::env::consts::EXE_SUFFIX)));
        command.args(["-m", module]).env("PYTHONDONTWRITEBYTECODE", "1").stdin(Stdio::null());
        command
    }

    /// The folder of its programs.
    fn programs(&self) -> PathBuf {
        self.folder.join(PROGRAMS)
    }
}

/// Runs a command; what it said last when it fails.
pub(super) fn done(command: &mut Command) -> Result<Output, String> {
    let output = command.stdin(Stdio::null()).output().map_err(|error| error.to_string())?;
    if output.status.success() {
        return Ok(output);
    }
    let said = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned()).concat();
    eprintln!("{said}");
    Err(said.lines().rfind(|line| !line.trim().is_empty()).unwrap_or_default().to_owned())
}

/// The newest file of a folder with this ending.
pub(super) fn newest(folder: &Path, ending: &str) -> Result<PathBuf, Box<dyn Error>> {
    let files = fs::read_dir(folder)?.filter_map(Result::ok).map(|entry| entry.path());
    let wheels = files.filter(|path| path.extension().is_some_and(|own| own == ending));
    let newest = wheels.max_by_key(|path| fs::metadata(path).and_then(|file| file.modified()).ok());
    newest.ok_or_else(|| format!("there is no .{ending} in {}", folder.display()).into())
}
