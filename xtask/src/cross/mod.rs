//! `cargo xtask cross`: whether the golden trajectories have the same bits on other platforms.
//!
//! The program `strict-hash` (`xtask/strict-hash`) is built for each platform and runs the shipped scenes there: as it
//! is on the platform of this machine, emulated by qemu or in wasmtime on others. Its hashes are compared with those in
//! `fixtures/golden`. A platform whose tools are not on this machine is skipped, and the reason says what to install.
//! With `--repeat-steps` each step of a run is made twice from a snapshot.
//!
//! `cargo xtask verify` leaves this out: the builds alone take minutes.
//!
//! | module | holds |
//! |---|---|
//! | `platform` | the platforms, and what each needs |
//! | `machine` | what can be asked of this machine |
//! | `tools` | the tools of a platform, or what is missing |
//! | `program` | the program, built for a platform |
//! | `runs` | its runs over many scenes |

mod machine;
mod platform;
mod program;
mod runs;
mod tools;

use crate::golden;
use crate::table::Counts;
use crate::verify::EXIT_FAILED;
use clap::{Args, ValueEnum};
use machine::ThisMachine;
use platform::Platform;
use polhode_cases::row::{Row, Verdict};
use polhode_cases::{Amount, Context};
use program::Program;
use std::error::Error;
use std::path::Path;
use std::process::{Command, ExitCode};
use strict_hash::hash_words;
use tools::Tools;

/// What the help says after the options.
const HELP: &str = "\
Tools are looked for on the path. The platform of this machine needs none; others need
  aarch64  aarch64-linux-gnu-gcc (or CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER) with a static C library,
           qemu-aarch64-static or qemu-aarch64 (or CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER)
  x86-64   x86_64-linux-gnu-gcc, qemu-x86_64-static or qemu-x86_64 (or the variables of its target)
  wasm32   wasmtime, or python3 with the package wasmtime (or CARGO_TARGET_WASM32_WASIP1_RUNNER)
and the standard library of the target: rustup target add aarch64-unknown-linux-gnu wasm32-wasip1. Where that is not
installed for cargo's rustc, CROSS_RUSTC names another one that has it. A platform without its tools is skipped.
Exit code 1 when a hash differs or a run fails.";

/// Why a golden is skipped; which tools, and what to install, is said once for each platform.
const TOOLS_ARE_MISSING: &str = "tools are missing";

/// Which goldens are run where.
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct Options {
    /// Run only the goldens whose name contains PATTERN (whatever the case of its letters).
    #[arg(long, value_name = "PATTERN")]
    only: Option<String>,
    /// Run on this platform only; may be repeated.
    #[arg(long, value_name = "NAME")]
    platform: Vec<Platform>,
    /// Make each step twice from a snapshot and compare the bits.
    #[arg(long)]
    repeat_steps: bool,
}

/// A golden trajectory.
#[derive(Debug)]
struct Golden {
    scene: String,
    /// The scene file, as the program is given it: relative to the workspace, which a sandbox may have as its only
    /// folder.
    file: String,
    hash: u64,
}

/// Runs the command.
///
/// # Errors
/// When goldens cannot be read, or none has a name that contains the pattern.
pub(crate) fn run(options: &Options, root: &Path) -> Result<ExitCode, Box<dyn Error>> {
    let goldens = selected(options.only.as_deref(), root)?;
    let platforms = if options.platform.is_empty() { Platform::value_variants() } else { &options.platform };
    let mut rows = Vec::new();
    for &platform in platforms {
        check(platform, options, root, &goldens, &mut |row| {
            println!("{}", line(&row));
            rows.push(row);
        });
    }
    println!("{}", Counts::of(&rows).closing_line());
    let failed = rows.iter().any(|row| row.verdict.fails_the_run());
    Ok(if failed { ExitCode::from(EXIT_FAILED) } else { ExitCode::SUCCESS })
}

/// The goldens whose name contains the pattern.
fn selected(pattern: Option<&str>, root: &Path) -> Result<Vec<Golden>, Box<dyn Error>> {
    let context = Context::new(root, Amount::Part)?;
    let pattern = pattern.unwrap_or_default().to_lowercase();
    let mut goldens = Vec::new();
    for scene in context.shipped.names()? {
        if golden::case_name(&scene).to_lowercase().contains(&pattern) {
            let path = context.shipped.path(&scene);
            let file = path.strip_prefix(root)?.to_string_lossy().replace('\\', "/");
            goldens.push(Golden { file, hash: golden::stored_hash(root, &scene)?, scene });
        }
    }
    if goldens.is_empty() {
        return Err(format!("no golden trajectory has a name that contains \"{pattern}\"").into());
    }
    Ok(goldens)
}

/// Tells a row for each golden on a platform.
fn check(platform: Platform, options: &Options, root: &Path, goldens: &[Golden], tell: &mut dyn FnMut(Row)) {
    let case = platform.to_string();
    let tools = match Tools::find(platform, &ThisMachine) {
        Ok(tools) => tools,
        Err(reason) => {
            println!("{case} is skipped: {reason}");
            return goldens.iter().for_each(|golden| tell(Row::skipped(&case, &golden.scene, TOOLS_ARE_MISSING)));
        }
    };
    eprintln!("{case}: building");
    let program = match Program::build(root, &tools) {
        Ok(program) => program,
        Err(reason) => return goldens.iter().for_each(|golden| tell(broken(&case, golden, &reason))),
    };
    let files: Vec<String> = goldens.iter().map(|golden| golden.file.clone()).collect();
    let command = || -> Command {
        let mut command = program.command();
        command.args(options.repeat_steps.then_some("--repeat-steps"));
        command
    };
    runs::all(&files, command, &mut |file, outcome| {
        let Some(golden) = goldens.iter().find(|golden| golden.file == file) else { return };
        tell(match outcome {
            Ok(hash) => Row::exact(&case, &golden.scene, hash_words(golden.hash), hash_words(hash)),
            Err(reason) => broken(&case, golden, &reason),
        });
    });
}

/// The row of a golden that has no hash here.
fn broken(case: &str, golden: &Golden, reason: &str) -> Row {
    let mut row = Row::exact(case, &golden.scene, hash_words(golden.hash), "none");
    row.note = Some(reason.to_owned());
    row
}

/// A row as a line.
fn line(row: &Row) -> String {
    let mut line = format!("{:<7}  {:<7}  {}", row.verdict.word(), row.case, row.quantity);
    if let Some(note) = &row.note {
        line = format!("{line}: {note}");
    } else if row.verdict == Verdict::Fails {
        let words = |value: Option<&polhode_cases::row::Value>| value.map_or_else(String::new, crate::table::words);
        line = format!("{line}: golden {}, there {}", words(row.reference.as_ref()), words(Some(&row.measured)));
    }
    line
}

#[cfg(test)]
mod tests {
    //! Goldens are selected by name, and lines say what is to be known.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use clap::Parser;

    #[derive(Debug, Parser)]
    struct Command {
        #[command(flatten)]
        options: Options,
    }

    fn root() -> std::path::PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
    }

    #[test]
    fn goldens_are_selected_by_name() {
        let chosen = selected(Some("Golden box-DROP-sink"), &root()).unwrap();
        assert_eq!(chosen.len(), 1);
        assert_eq!(chosen[0].file, "fixtures/scenes/box-drop-sinking.toml");
        assert!(selected(None, &root()).unwrap().len() > 50);
        assert!(selected(Some("no such golden"), &root()).is_err());
    }

    #[test]
    fn a_line_says_what_differs_or_why_not() {
        let same = Row::exact("wasm32", "box-drop", hash_words(1), hash_words(1));
        assert_eq!(line(&same), "ok       wasm32   box-drop");
        let differs = Row::exact("wasm32", "box-drop", hash_words(1), hash_words(2));
        assert_eq!(line(&differs), "FAILS    wasm32   box-drop: golden 0000000000000001, there 0000000000000002");
        let skipped = Row::skipped("aarch64", "box-drop", TOOLS_ARE_MISSING);
        assert_eq!(line(&skipped), "skipped  aarch64  box-drop: tools are missing");
    }

    #[test]
    fn platforms_are_asked_for_by_name() {
        let asked = Command::try_parse_from(["cross", "--platform", "wasm32", "--platform", "x86-64"]).unwrap();
        assert_eq!(asked.options.platform, [Platform::Wasm, Platform::X86]);
        assert!(Command::try_parse_from(["cross", "--platform", "vax"]).is_err());
    }
}
