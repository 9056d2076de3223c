//! Each crate alone, as a user has it: every example of a crate, in a package whose only dependency is that crate, compiles
//! and finds what it asserts.
//!
//! Inside the workspace an example sees all that its crate depends on, for tests too, so that compiling there shows
//! nothing. The packages stand in the folder of build products and are kept, so that only the first run compiles much.

use super::{CaseResult, Context};
use crate::commands;
use crate::row::Row;
use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Stdio;

/// The crates that a user may depend on alone.
const CRATES: [&str; 6] =
    ["polhode-spatial", "polhode-mesh", "polhode-dynamics", "polhode-contact", "polhode-response", "polhode"];

/// What an example that takes in other files of its crate contains: a tool of ours, and no program of a user's.
const OTHER_FILES: &str = "#[path";

/// Runs every example of every crate.
pub(super) fn examples(context: &Context) -> CaseResult {
    let own = std::env::current_exe()?;
    let folder = own.ancestors().nth(2).ok_or("this program lies in no folder of build products")?;
    let users = folder.join("one-dependency");
    let mut programs = Vec::new();
    for name in CRATES {
        let found = examples_of(&context.root, name)?;
        write_package(&context.root, &users, name, &found)?;
        programs.extend(found.into_iter().map(|example| (name, example)));
    }
    let members = CRATES.map(|name| format!("\"user-of-{name}\"")).join(", ");
    // They are run once: nothing is gained by symbols for a debugger, nor by what makes the next build shorter.
    let profile = "[profile.dev]\ndebug = false\nincremental = false\n";
    let manifest = format!("[workspace]\nresolver = \"3\"\nmembers = [{members}]\n\n{profile}");
    std::fs::write(users.join("Cargo.toml"), manifest)?;
    std::fs::copy(context.root.join("Cargo.lock"), users.join("Cargo.lock"))?;
    for name in CRATES {
        build(&users, name)?;
    }
    programs.iter().map(|(name, example)| run(&users, name, example)).collect()
}

/// Compiles all programs of a package beside each other. What does not compile is reported where it is run.
fn build(users: &Path, name: &str) -> Result<(), Box<dyn Error>> {
    let package = format!("user-of-{name}");
    let mut command = commands::cargo(users);
    command.args(["build", "--quiet", "--offline", "--package", &package, "--bins"]);
    command.stdin(Stdio::null()).stderr(Stdio::null()).status()?;
    Ok(())
}

/// The examples of a crate that a user could have written, in order of their names.
fn examples_of(root: &Path, name: &str) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let folder = root.join("crates").join(name).join("examples");
    let mut found = Vec::new();
    if folder.is_dir() {
        for entry in std::fs::read_dir(folder)? {
            let path = entry?.path();
            let is_rust = path.extension().is_some_and(|extension| extension == "rs");
            if is_rust && !std::fs::read_to_string(&path)?.contains(OTHER_FILES) {
                found.push(path);
            }
        }
    }
    found.sort();
    Ok(found)
}

/// A package that depends on one crate, with the examples of that crate as its programs.
fn write_package(root: &Path, users: &Path, name: &str, examples: &[PathBuf]) -> Result<(), Box<dyn Error>> {
    let folder = users.join(format!("user-of-{name}"));
    std::fs::create_dir_all(folder.join("src"))?;
    std::fs::write(folder.join("src/lib.rs"), "")?;
    let path = root.join("crates").join(name);
    let mut manifest = format!("[package]\nname = \"user-of-{name}\"\nedition = \"2024\"\n\n[dependencies]\n");
    writeln!(manifest, "{name} = {{ path = \"{}\" }}", path.display())?;
    for example in examples {
        write!(manifest, "\n[[bin]]\nname = {:?}\npath = \"{}\"\n", stem(example), example.display())?;
    }
    std::fs::write(folder.join("Cargo.toml"), manifest)?;
    Ok(())
}

fn run(users: &Path, name: &str, example: &Path) -> Result<Row, Box<dyn Error>> {
    let mut command = commands::cargo(users);
    let package = format!("user-of-{name}");
    command.args(["run", "--quiet", "--offline", "--package", &package, "--bin", &stem(example)]);
    let output = command.stdin(Stdio::null()).output()?;
    if !output.status.success() {
        eprintln!("\n{}", String::from_utf8_lossy(&output.stderr));
    }
    let measured = if output.status.success() { "success".to_owned() } else { output.status.to_string() };
    Ok(Row::exact("one dependency", &format!("{name} alone: {}", stem(example)), "success", measured))
}

/// Name of a file without its ending.
fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}
