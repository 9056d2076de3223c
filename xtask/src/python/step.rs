//! The step of a verification that builds, installs and tests the Python package.

use super::environment::{Environment, OLDEST, done, newest};
use super::licences;
use polhode_cases::row::Row;
use polhode_cases::{CaseResult, Context, guarded};
use std::path::Path;

/// Name of the step, as of a case.
pub(crate) const NAME: &str = "python";
/// The folder of the package.
const PACKAGE: &str = "crates/polhode-py";
/// The folder of its environment, below the one of what is built.
const FOLDER: &str = "target/python";
/// The part that stubs describe.
const NATIVE: &str = "polhode._polhode";

/// Builds and installs the package as a wheel, and runs its tests and checks.
pub(crate) fn check(context: &Context) -> Vec<Row> {
    guarded(NAME, || rows(context))
}

fn rows(context: &Context) -> CaseResult {
    let package = context.root.join(PACKAGE);
    let environment = match Environment::made(context.root.join(FOLDER), &package) {
        Ok(environment) => environment,
        Err(reason) => return Ok(vec![Row::skipped(NAME, "wheel, tests, stubs, notebooks", &reason)]),
    };
    let mut rows = licences::rows(NAME, &context.root);
    rows.push(wheel(context, &environment, &package)?);
    let program = context.program.path(&context.root)?;
    let mut tests = environment.module("pytest");
    tests.args(["-q", "-p", "no:cacheprovider", "tests"]).env("POLHODE", program);
    let mut types = environment.module("mypy");
    types
        .args(["--strict", "--python-version", OLDEST, "--package", "polhode"])
        .arg("--cache-dir")
        .arg(environment.folder.join("mypy"));
    let mut stubs = environment.module("mypy.stubtest");
    stubs.args([NATIVE, "--concise"]);
    let mut notebooks = environment.module("tests.notebooks");
    for (what, command) in [
        ("tests and examples pass", &mut tests),
        ("types, strictly", &mut types),
        ("stubs are what is built", &mut stubs),
        ("notebooks run", &mut notebooks),
    ] {
        let measured = done(command.current_dir(&package)).map(|_| "success".to_owned());
        rows.push(Row::exact(NAME, what, "success", measured.unwrap_or_else(|reason| reason)));
    }
    Ok(rows)
}

/// Builds the wheel by the profile for development and installs it.
fn wheel(context: &Context, environment: &Environment, package: &Path) -> Result<Row, Box<dyn std::error::Error>> {
    let folder = environment.folder.join("wheels");
    let mut build = environment.module("maturin");
    build.args(["build", "--quiet", "--profile", "dev", "--out"]).arg(&folder).current_dir(package);
    let built = done(&mut build);
    let quantity = "a wheel is built and installed";
    if let Err(reason) = built {
        return Ok(Row::exact(NAME, quantity, "success", reason));
    }
    let mut install = environment.module("pip");
    install.args(["install", "--quiet", "--disable-pip-version-check", "--force-reinstall", "--no-deps", "--no-index"]);
    let installed = done(install.arg(newest(&folder, "whl")?).current_dir(&context.root));
    Ok(Row::exact(NAME, quantity, "success", installed.map_or_else(|reason| reason, |_| "success".to_owned())))
}
