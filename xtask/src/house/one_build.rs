//! One build of each library: whatever command builds it, for the tests, for `cargo xtask`, for the program or for the
//! Python package, asks the same features of it. Else cargo compiles it, and all that depends on it, once for each.

use super::violation::Violation;
use polhode_cases::cargo::cargo;
use std::collections::BTreeMap;
use std::path::Path;

/// The crate that asks for what others lack.
const MANIFEST: &str = "xtask/one-build/Cargo.toml";
/// What the tests are built from.
const TESTS: &[&str] = &["--workspace", "--exclude", "polhode-py", "--edges", "normal,build,dev"];
/// What else is built, each by a command of its own.
const OTHERS: [&[&str]; 3] = [
    &["--package", "xtask", "--edges", "normal,build"],
    &["--package", "polhode-cli", "--package", "one-build", "--edges", "normal,build"],
    &["--package", "polhode-py", "--edges", "normal,build"],
];

/// Features by library and version.
type Features = BTreeMap<String, String>;

/// Every library that another build asks other features of than the tests do.
pub(super) fn check(root: &Path) -> Vec<Violation> {
    let found = features(root, TESTS).and_then(|tests| {
        let others: Result<Vec<Features>, String> = OTHERS.iter().map(|build| features(root, build)).collect();
        Ok(others?.iter().zip(OTHERS).flat_map(|(other, build)| differences(&tests, other, build[1])).collect())
    });
    found.unwrap_or_else(|error| vec![Violation::in_file("Cargo.toml", error)])
}

/// The libraries of two builds whose features differ.
fn differences(tests: &Features, other: &Features, built: &str) -> Vec<Violation> {
    let differs = |(library, own): &(&String, &String)| tests.get(*library).is_some_and(|asked| asked != *own);
    let different = other.iter().filter(differs);
    different
        .map(|(library, own)| {
            let asked = &tests[library];
            let what =
                format!("{library} is built for {built} with {own}, and for the tests with {asked}: ask for all");
            Violation::in_file(MANIFEST, what)
        })
        .collect()
}

/// What a build asks of each library, by `cargo tree`.
fn features(root: &Path, build: &[&str]) -> Result<Features, String> {
    let mut command = cargo(root);
    command.args(["tree", "--prefix", "none", "--no-dedupe", "--format", "{p}|{f}"]).args(build);
    let output = command.output().map_err(|error| format!("cargo tree: {error}"))?;
    if !output.status.success() {
        return Err(format!("cargo tree: {}", String::from_utf8_lossy(&output.stderr)));
    }
    Ok(parsed(&String::from_utf8_lossy(&output.stdout)))
}

/// Lines of a library, its version and its features; a library of macros says so behind its version.
fn parsed(printed: &str) -> Features {
    let lines = printed.lines().filter_map(|line| line.split_once('|'));
    let named = lines.filter_map(|(package, features)| {
        let mut words = package.split_whitespace();
        Some((format!("{} {}", words.next()?, words.next()?), format!("[{}]", features.trim())))
    });
    named.collect()
}

#[cfg(test)]
mod tests {
    //! Libraries with other features are found, and those that a build has alone are not.
    use super::*;

    #[test]
    fn other_features_of_a_shared_library_are_found() {
        let tests = parsed("a v1.0.0 (/a)|\nb v1.0.0|std\nb v2.0.0 (proc-macro)|\n");
        let other = parsed("b v1.0.0|alloc,std\nb v2.0.0 (proc-macro)|\nc v1.0.0|std\n");
        let found = differences(&tests, &other, "c");
        assert_eq!(found.len(), 1);
        assert!(found[0].what.starts_with("b v1.0.0 is built for c with [alloc,std]"), "{}", found[0].what);
    }
}
