//! Child processes: formatting, lints, documentation, tests. Their output is shown when they fail.

use polhode_cases::cargo::cargo;
use polhode_cases::row::Row;
use std::error::Error;
use std::path::Path;
use std::process::{ExitCode, Stdio};

/// A command that must succeed.
#[derive(Debug)]
pub(crate) struct Check {
    /// Arguments of cargo.
    arguments: &'static [&'static str],
    /// Variables of its environment.
    environment: &'static [(&'static str, &'static str)],
}

/// What cargo must be content with, the cheapest first.
pub(crate) const CHECKS: &[Check] = &[
    Check { arguments: &["fmt", "--all", "--check"], environment: &[] },
    Check {
        arguments: &["clippy", "--workspace", "--all-targets", "--quiet", "--", "-D", "warnings"],
        environment: &[],
    },
    // The Python package is documented by its stubs, and tested from Python.
    Check {
        arguments: &["doc", "--workspace", "--exclude", "polhode-py", "--no-deps", "--quiet"],
        environment: &[("RUSTDOCFLAGS", "-D warnings")],
    },
    Check {
        arguments: &["test", "--workspace", "--exclude", "polhode-py", "--no-fail-fast", "--quiet"],
        environment: &[],
    },
    // Every crate but those of development can be published: manifests, readmes and versions of what they depend on are
    // complete.
    Check {
        arguments: &[
            "package",
            "--workspace",
            "--exclude",
            "xtask",
            "--exclude",
            "one-build",
            "--exclude",
            "strict-hash",
            "--exclude",
            "polhode-cases",
            "--exclude",
            "polhode-oracles",
            "--exclude",
            "polhode-py",
            "--exclude",
            "polhode-web",
            "--no-verify",
            "--offline",
            "--allow-dirty",
            "--quiet",
        ],
        environment: &[],
    },
    // The program that some cases run, with the libraries that the tests were built with.
    Check { arguments: &["build", "--package", "polhode-cli", "--package", "one-build", "--quiet"], environment: &[] },
];

/// The same for `--quick`: what takes seconds when nothing has to be compiled.
pub(crate) const QUICK_CHECKS: &[Check] = &[
    Check { arguments: &["fmt", "--all", "--check"], environment: &[] },
    Check {
        arguments: &["test", "--workspace", "--exclude", "polhode-py", "--lib", "--bins", "--no-fail-fast", "--quiet"],
        environment: &[],
    },
];

impl Check {
    /// The command as one types it.
    pub(crate) fn name(&self) -> String {
        format!("cargo {}", self.arguments.join(" ").replace(" --quiet", ""))
    }

    /// Runs it in `root`; what it printed goes to stderr when it fails.
    pub(crate) fn run(&self, root: &Path) -> Row {
        let mut command = cargo(root);
        command.args(self.arguments).envs(self.environment.iter().copied());
        let measured = match command.stdin(Stdio::null()).output() {
            Ok(output) if output.status.success() => "success".to_owned(),
            Ok(output) => {
                eprintln!("{}", String::from_utf8_lossy(&output.stdout));
                eprintln!("{}", String::from_utf8_lossy(&output.stderr));
                output.status.to_string()
            }
            Err(error) => error.to_string(),
        };
        Row::exact("cargo", &self.name(), "success", measured)
    }
}

/// Goes on in a release build of this program, with the same arguments and in the same folder.
///
/// # Errors
/// When cargo cannot be run.
pub(crate) fn go_on_in_release() -> Result<ExitCode, Box<dyn Error>> {
    go_on_with(&["--release"])
}

/// Goes on in a build of this program with these arguments of cargo, with the same arguments and in the same folder.
///
/// # Errors
/// When cargo cannot be run.
pub(crate) fn go_on_with(build: &[&str]) -> Result<ExitCode, Box<dyn Error>> {
    let status = cargo(&std::env::current_dir()?)
        .args(["run", "--quiet", "--package", env!("CARGO_PKG_NAME")])
        .args(build)
        .arg("--")
        .args(std::env::args_os().skip(1))
        .status()?;
    Ok(if status.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
