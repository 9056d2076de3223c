//! `strict-hash [--repeat-steps] SCENE.toml...`: prints the strict hash of each scene file, in a line of its own that
//! stands as soon as the scene has been run.
//!
//! Exit code 1 when a scene has none, 2 when the arguments are not understood or the output cannot be written.

use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;
use strict_hash::{Line, Repeat, record_of, strict_hash};

/// The option that makes each step twice.
const REPEAT_STEPS: &str = "--repeat-steps";

/// Exit code when a scene has no hash.
const EXIT_FAILED: u8 = 1;

/// Exit code when the program cannot do what it was asked for.
const EXIT_USAGE: u8 = 2;

fn main() -> ExitCode {
    let (options, files): (Vec<String>, Vec<String>) = std::env::args().skip(1).partition(|word| word.starts_with('-'));
    if files.is_empty() || options.iter().any(|option| option != REPEAT_STEPS) {
        eprintln!("usage: strict-hash [{REPEAT_STEPS}] SCENE.toml...");
        return ExitCode::from(EXIT_USAGE);
    }
    let repeat = if options.is_empty() { Repeat::No } else { Repeat::EachStep };
    let mut code = ExitCode::SUCCESS;
    for file in files {
        let line = match record_of(Path::new(&file), repeat) {
            Ok(record) => Line::Hash { file, hash: strict_hash(&record) },
            Err(failure) => {
                code = ExitCode::from(EXIT_FAILED);
                Line::failed(&file, &failure)
            }
        };
        let mut out = io::stdout().lock();
        if let Err(error) = writeln!(out, "{line}").and_then(|()| out.flush()) {
            eprintln!("cannot write: {error}");
            return ExitCode::from(EXIT_USAGE);
        }
    }
    code
}
