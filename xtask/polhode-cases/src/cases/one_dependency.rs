//! Every example of a crate does what it asserts, and needs no other crate.
//!
//! Inside the workspace an example sees all that its crate depends on, for tests too, and features that others switch
//! on. That it names no crate but its own is a rule of the house. In full, each example is also compiled as a user has
//! it: in a package whose only dependency is that crate. These packages stand in the folder of build products and are
//! kept, so that only the first run compiles much: some 80 s of processor time, which is why the plain run does
//! without.

use super::{Amount, CaseResult, Context};
use crate::cargo::cargo;
use crate::row::Row;
use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The crates that a user may depend on alone.
const CRATES: [&str; 7] = [
    "polhode-spatial",
    "polhode-mesh",
    "polhode-dynamics",
    "polhode-contact",
    "polhode-response",
    "polhode",
    "polhode-elastic",
];

/// What an example that takes in other files of its crate contains: a tool of ours, and no program of a user's.
const OTHER_FILES: &str = "#[path";

/// Runs every example of every crate.
pub(super) fn examples(context: &Context) -> CaseResult {
    match context.amount {
        Amount::Part => in_workspace(context),
        Amount::Full => in_packages(context),
    }
}

/// Runs the examples that `cargo test` compiles.
fn in_workspace(context: &Context) -> CaseResult {
    let mut build = cargo(&context.root);
    build.args(["build", "--quiet", "--workspace", "--exclude", "polhode-py", "--examples"]);
    build.stdin(Stdio::null()).status()?;
    let folder = build_products()?.join("debug").join("examples");
    let mut rows = Vec::new();
    for name in CRATES {
        for example in examples_of(&context.root, name)? {
            let mut program = Command::new(folder.join(stem(&example)));
            program.current_dir(&context.root);
            rows.push(run(&mut program, &format!("{name}: {}", stem(&example)))?);
        }
    }
    Ok(rows)
}

/// Runs the examples, each in a package that depends on its crate alone.
fn in_packages(context: &Context) -> CaseResult {
    let users = build_products()?.join("one-dependency");
    let mut programs = Vec::new();
    for name in CRATES {
        let found = examples_of(&context.root, name)?;
        write_package(&context.root, &users, name, &found)?;
        programs.extend(found.into_iter().map(|example| (name, stem(&example))));
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
    let rows = programs.iter().map(|(name, example)| {
        let mut program = cargo(&users);
        let package = format!("user-of-{name}");
        program.args(["run", "--quiet", "--offline", "--package", &package, "--bin", example]);
        run(&mut program, &format!("{name} alone: {example}"))
    });
    rows.collect()
}

/// The folder of build products that this program lies in.
fn build_products() -> Result<PathBuf, Box<dyn Error>> {
    let own = std::env::current_exe()?;
    Ok(own.ancestors().nth(2).ok_or("this program lies in no folder of build products")?.to_owned())
}

/// Compiles all programs of a package beside each other. What does not compile is reported where it is run.
fn build(users: &Path, name: &str) -> Result<(), Box<dyn Error>> {
    let package = format!("user-of-{name}");
    let mut command = cargo(users);
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

fn run(program: &mut Command, quantity: &str) -> Result<Row, Box<dyn Error>> {
    let output = program.stdin(Stdio::null()).output()?;
    if !output.status.success() {
        eprintln!("\n{}", String::from_utf8_lossy(&output.stderr));
    }
    let measured = if output.status.success() { "success".to_owned() } else { output.status.to_string() };
    Ok(Row::exact("one dependency", quantity, "success", measured))
}

/// Name of a file without its ending.
fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}
