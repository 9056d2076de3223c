//! The tools of a platform on this machine, or what is missing.
//!
//! A platform that is not the one of this machine needs three: a rustc whose standard library is installed for the
//! target, a linker, and a command that runs programs for it. Cargo's own variables name a linker or a runner that is
//! not on the path or is another one. A rustc other than cargo's is named by [`RUSTC`]: `RUSTC` itself would also build
//! this program.

use super::machine::Machine;
use super::platform::{Facts, Platform};
use std::path::Path;

/// Names a rustc for the platforms that are not the one of this machine.
const RUSTC: &str = "CROSS_RUSTC";

/// With this variable cargo builds the standard library itself, for every target.
const STANDARD_LIBRARY_IS_BUILT: &str = "CARGO_UNSTABLE_BUILD_STD";

/// How the name of a file of the standard library begins.
const STANDARD_LIBRARY: &str = "libstd-";

/// The tools of a platform.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Tools {
    /// The machine is of this platform: cargo builds for it, and its programs run.
    Here,
    /// Those for another platform.
    Cross(CrossTools),
}

/// The tools for another platform than the one of this machine.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct CrossTools {
    /// The target, as rustc calls it.
    pub(super) target: &'static str,
    /// What rustc is asked for when it makes the program.
    pub(super) codegen: &'static [&'static str],
    /// Variables with which cargo builds for it.
    pub(super) environment: Vec<(String, String)>,
    /// The command that runs a program, and its arguments.
    pub(super) runner: Vec<String>,
}

impl Tools {
    /// Finds the tools of a platform.
    ///
    /// # Errors
    /// What is missing, and what to install.
    pub(super) fn find(platform: Platform, machine: &dyn Machine) -> Result<Self, String> {
        if platform.is_here() {
            return Ok(Self::Here);
        }
        CrossTools::find(platform.facts(), machine).map(Self::Cross)
    }
}

impl CrossTools {
    fn find(facts: &Facts, machine: &dyn Machine) -> Result<Self, String> {
        let mut missing = Vec::new();
        let mut environment = Vec::new();
        let other_rustc = machine.variable(RUSTC);
        let rustc = other_rustc.clone().or_else(|| machine.variable("RUSTC")).unwrap_or_else(|| "rustc".to_owned());
        if !has_standard_library(&rustc, facts.target, machine) {
            missing.push(format!("{rustc} has no standard library for {}", facts.target));
        }
        environment.extend(other_rustc.map(|rustc| ("RUSTC".to_owned(), rustc)));
        let linker = variable_of("LINKER", facts.target);
        if let Some(program) = facts.linker
            && machine.variable(&linker).is_none()
        {
            if machine.has(program) {
                environment.push((linker, program.to_owned()));
            } else {
                missing.push(format!("no {program} on the path, nor a linker in {linker}"));
            }
        }
        let runner = variable_of("RUNNER", facts.target);
        // Words are parted at blanks, as cargo does.
        let words = |text: String| text.split_whitespace().map(str::to_owned).collect();
        let command = machine.variable(&runner).map(words).or_else(|| runner_on_path(facts, machine));
        if command.is_none() {
            let programs: Vec<&str> = facts.runners.iter().map(|words| words[0]).collect();
            missing.push(format!("no {} that runs it, nor a command in {runner}", programs.join(" or ")));
        }
        match command {
            Some(runner) if missing.is_empty() => {
                Ok(Self { target: facts.target, codegen: facts.codegen, environment, runner })
            }
            _ => Err(format!("{}; install: {}", missing.join("; "), facts.install)),
        }
    }
}

/// The first of the commands that is there.
fn runner_on_path(facts: &Facts, machine: &dyn Machine) -> Option<Vec<String>> {
    let is_there = |words: &&&[&str]| match words {
        // What runs WebAssembly here is a package of the interpreter.
        [interpreter @ "python3", _] => machine.printed(&[interpreter, "-c", "import wasmtime"]).is_some(),
        [program, ..] => machine.has(program),
        [] => false,
    };
    facts.runners.iter().find(is_there).map(|words| words.iter().map(|&word| word.to_owned()).collect())
}

fn has_standard_library(rustc: &str, target: &str, machine: &dyn Machine) -> bool {
    let folder = || machine.printed(&[rustc, "--print", "target-libdir", "--target", target]);
    machine.variable(STANDARD_LIBRARY_IS_BUILT).is_some()
        || folder().is_some_and(|folder| machine.holds(Path::new(&folder), STANDARD_LIBRARY))
}

/// Cargo's variable for a tool of a target (The Cargo Book, "Configuration", `target.<triple>`).
fn variable_of(tool: &str, target: &str) -> String {
    format!("CARGO_TARGET_{}_{tool}", target.to_uppercase().replace('-', "_"))
}

#[cfg(test)]
mod tests {
    //! Tools are found on the path or by cargo's variables, and all that are missing are named.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    /// A machine with these programs and variables; the standard library of every target is there or not.
    #[derive(Debug, Default)]
    struct MadeUp {
        programs: &'static [&'static str],
        variables: &'static [(&'static str, &'static str)],
        libraries: &'static [&'static str],
    }

    impl Machine for MadeUp {
        fn variable(&self, name: &str) -> Option<String> {
            self.variables.iter().find(|(known, _)| *known == name).map(|(_, value)| (*value).to_owned())
        }

        fn printed(&self, words: &[&str]) -> Option<String> {
            self.programs.contains(&words[0]).then(|| (*words.last().unwrap_or(&"")).to_owned())
        }

        fn holds(&self, folder: &Path, _beginning: &str) -> bool {
            self.libraries.iter().any(|library| Path::new(library) == folder)
        }
    }

    const ARM: &str = "aarch64-unknown-linux-gnu";

    fn arm(machine: &MadeUp) -> Result<CrossTools, String> {
        CrossTools::find(Platform::Arm.facts(), machine)
    }

    #[test]
    fn what_is_on_the_path_is_taken() {
        let machine = MadeUp {
            programs: &["rustc", "aarch64-linux-gnu-gcc", "qemu-aarch64"],
            libraries: &[ARM],
            ..MadeUp::default()
        };
        let tools = arm(&machine).unwrap();
        assert_eq!(tools.runner, ["qemu-aarch64"]);
        let linker = ("CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER".to_owned(), "aarch64-linux-gnu-gcc".to_owned());
        assert_eq!(tools.environment, [linker]);
    }

    #[test]
    fn what_variables_name_comes_first() {
        let machine = MadeUp {
            programs: &["other-rustc", "qemu-aarch64"],
            variables: &[
                ("CROSS_RUSTC", "other-rustc"),
                ("CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER", "lld"),
                ("CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER", "emulate -L root"),
            ],
            libraries: &[ARM],
        };
        let tools = arm(&machine).unwrap();
        assert_eq!(tools.runner, ["emulate", "-L", "root"]);
        // Cargo reads the linker itself.
        assert_eq!(tools.environment, [("RUSTC".to_owned(), "other-rustc".to_owned())]);
    }

    #[test]
    fn all_that_is_missing_is_named() {
        let missing = arm(&MadeUp { programs: &["rustc"], ..MadeUp::default() }).unwrap_err();
        for words in ["standard library", "no aarch64-linux-gnu-gcc", "qemu-aarch64", "rustup target add", "apt-get"] {
            assert!(missing.contains(words), "{words}: {missing}");
        }
        let with_compiler =
            MadeUp { programs: &["rustc", "qemu-aarch64-static"], libraries: &[ARM], ..MadeUp::default() };
        let missing = arm(&with_compiler).unwrap_err();
        assert!(missing.starts_with("no aarch64-linux-gnu-gcc") && !missing.contains("no qemu"), "{missing}");
    }

    #[test]
    fn web_assembly_runs_in_python_where_there_is_no_other_runtime() {
        let machine = |programs| MadeUp { programs, libraries: &["wasm32-wasip1"], ..MadeUp::default() };
        let runner = |programs| CrossTools::find(Platform::Wasm.facts(), &machine(programs)).unwrap().runner;
        assert_eq!(runner(&["rustc", "wasmtime", "python3"])[0], "wasmtime");
        assert_eq!(runner(&["rustc", "python3"])[0], "python3");
    }

    #[test]
    fn cargo_may_build_the_standard_library() {
        let machine = MadeUp {
            programs: &["rustc", "wasmtime"],
            variables: &[("CARGO_UNSTABLE_BUILD_STD", "std,panic_abort")],
            ..MadeUp::default()
        };
        assert!(CrossTools::find(Platform::Wasm.facts(), &machine).is_ok());
    }
}
