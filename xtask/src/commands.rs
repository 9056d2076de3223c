//! Child processes: formatting, lints, documentation, tests. Their output is shown when they fail.

use polhode_cases::cargo::cargo;
use polhode_cases::row::Row;
use std::error::Error;
use std::path::Path;
use std::process::{ExitCode, Stdio};

/// Crates that are optimised in full. Their tests beside the sources are few, and for these the whole crate is compiled
/// a second time: without optimisation, which takes a third of the processor time.
const SIMULATION: [&str; 5] = ["polhode-mesh", "polhode-dynamics", "polhode-contact", "polhode-response", "polhode"];
/// Crates beside which others ask the same features of libraries as all crates together do, so that nothing is compiled
/// anew for a part of the tests.
const ALL_FEATURES: [&str; 2] = ["polhode-cli", "one-build"];
/// Crates that are not published.
const UNPUBLISHED: [&str; 6] = ["xtask", "one-build", "strict-hash", "polhode-cases", "polhode-oracles", "polhode-py"];

/// A command that must succeed.
#[derive(Debug)]
pub(crate) struct Check {
    /// Arguments of cargo.
    arguments: Vec<String>,
    /// Variables of its environment.
    environment: &'static [(&'static str, &'static str)],
}

/// What cargo must be content with, the cheapest first.
pub(crate) fn checks() -> Vec<Check> {
    let mut checks = vec![
        Check::new(&["fmt", "--all", "--check"]),
        Check::new(&["clippy", "--workspace", "--all-targets", "--quiet", "--", "-D", "warnings"]),
        // The Python package is documented by its stubs.
        Check {
            environment: &[("RUSTDOCFLAGS", "-D warnings")],
            ..Check::new(&["doc", "--workspace", "--exclude", "polhode-py", "--no-deps", "--quiet"])
        },
    ];
    checks.extend(tests());
    // Every crate but those of development can be published: manifests, readmes and versions of what they depend on are
    // complete.
    checks.push(
        Check::new(&["package", "--workspace", "--no-verify", "--offline", "--allow-dirty", "--quiet"])
            .with("--exclude", &UNPUBLISHED),
    );
    // The program that some cases run.
    checks.push(Check::new(&["build", "--quiet"]).with("--package", &ALL_FEATURES));
    checks
}

/// All tests: of the crates around the simulation, of the simulation and the program from outside, and those of the
/// simulation beside its sources. What `cargo xtask` was built from is not compiled again.
fn tests() -> Vec<Check> {
    let test = |arguments: &[&str]| Check::new(&["test", "--no-fail-fast", "--quiet"]).and(arguments);
    let around = test(&["--workspace", "--exclude", "polhode-py", "--exclude", "polhode-cli"]);
    let from_outside =
        |arguments: &[&str]| test(arguments).with("--package", &SIMULATION).with("--package", &ALL_FEATURES);
    let mut tests =
        vec![around.with("--exclude", &SIMULATION), from_outside(&["--bins", "--test", "*"]), from_outside(&["--doc"])];
    tests.extend(SIMULATION.iter().map(|name| {
        let plain = format!("profile.dev.package.{name}.opt-level=0");
        test(&["--lib", "--config", &plain, "--package", name]).with("--package", &ALL_FEATURES)
    }));
    tests
}

/// The same for `--quick`: what takes seconds when nothing has to be compiled.
pub(crate) fn quick_checks() -> Vec<Check> {
    vec![
        Check::new(&["fmt", "--all", "--check"]),
        Check::new(&["test", "--workspace", "--exclude", "polhode-py", "--lib", "--bins", "--no-fail-fast", "--quiet"]),
    ]
}

impl Check {
    /// A command of cargo with these arguments.
    fn new(arguments: &[&str]) -> Self {
        Self { arguments: Vec::new(), environment: &[] }.and(arguments)
    }

    /// With further arguments.
    fn and(mut self, arguments: &[&str]) -> Self {
        self.arguments.extend(arguments.iter().map(|&argument| argument.to_owned()));
        self
    }

    /// With an option for each of these names.
    fn with(self, option: &str, names: &[&str]) -> Self {
        names.iter().fold(self, |check, name| check.and(&[option, name]))
    }

    /// The command as one types it.
    pub(crate) fn name(&self) -> String {
        format!("cargo {}", self.arguments.join(" ").replace(" --quiet", ""))
    }

    /// Runs it in `root`; what it printed goes to stderr when it fails.
    pub(crate) fn run(&self, root: &Path) -> Row {
        let mut command = cargo(root);
        command.args(&self.arguments).envs(self.environment.iter().copied());
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
