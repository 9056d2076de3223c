//! Dependencies that nothing names: each one of a manifest stands in the code of its crate, and one of tests and
//! benches alone stands among the dev-dependencies.

use super::project_file::ProjectFile;
use super::rust_source::RustSource;
use super::violation::Violation;
use toml::Table;

/// The manifest of the workspace, whose own list says what its crates may depend on.
const WORKSPACE: &str = "Cargo.toml";

/// Manifests of test data, which are no crates.
const TEST_DATA: &str = "fixtures/";

/// Every dependency that nothing names.
pub(super) fn check(files: &[ProjectFile], sources: &[RustSource]) -> Vec<Violation> {
    let mut violations = Vec::new();
    let mut manifests = Vec::new();
    for file in files.iter().filter(|file| is_manifest(&file.path)) {
        match file.text.parse::<Table>() {
            Ok(manifest) => manifests.push((file.path.as_str(), manifest)),
            Err(error) => violations.push(Violation::in_file(&file.path, format!("is no manifest: {error}"))),
        }
    }
    let folders: Vec<&str> = manifests.iter().map(|(path, _)| folder(path)).collect();
    for (path, manifest) in &manifests {
        // A crate inside the folder of another has sources of its own.
        let is_own = |source: &RustSource| innermost(&folders, source.path()) == Some(folder(path));
        let own: Vec<&RustSource> = sources.iter().filter(|source| is_own(source)).collect();
        for name in names_in(manifest, "dependencies") {
            if !own.iter().any(|source| source.product_code().any(|(_, line)| speaks_of(line, name))) {
                let what = format!("no code outside tests speaks of {name}: remove it, or make it a dev-dependency");
                violations.push(Violation::in_file(*path, what));
            }
        }
        for name in names_in(manifest, "dev-dependencies") {
            if !own.iter().any(|source| source.code().iter().any(|line| speaks_of(line, name))) {
                violations.push(Violation::in_file(*path, format!("nothing speaks of {name}: remove it")));
            }
        }
    }
    violations.extend(unused_by_all(&manifests));
    violations
}

/// Libraries of the workspace that no crate depends on.
fn unused_by_all(manifests: &[(&str, Table)]) -> Vec<Violation> {
    let Some((_, workspace)) = manifests.iter().find(|(path, _)| *path == WORKSPACE) else { return Vec::new() };
    let Some(workspace) = workspace.get("workspace").and_then(toml::Value::as_table) else { return Vec::new() };
    let asked_for = |name: &str| {
        let lists = ["dependencies", "dev-dependencies", "build-dependencies"];
        manifests.iter().any(|(_, manifest)| lists.iter().any(|list| names_in(manifest, list).any(|own| own == name)))
    };
    let unused = names_in(workspace, "dependencies").filter(|name| !asked_for(name));
    unused.map(|name| Violation::in_file(WORKSPACE, format!("no crate depends on {name}: remove it"))).collect()
}

fn is_manifest(path: &str) -> bool {
    (path == WORKSPACE || path.ends_with("/Cargo.toml")) && !path.starts_with(TEST_DATA)
}

/// The folder of a manifest, with its last slash.
fn folder(manifest: &str) -> &str {
    manifest.trim_end_matches(WORKSPACE)
}

/// The smallest of some folders that a file stands in.
fn innermost<'a>(folders: &[&'a str], path: &str) -> Option<&'a str> {
    folders.iter().filter(|folder| path.starts_with(**folder)).max_by_key(|folder| folder.len()).copied()
}

/// The names in a list of dependencies: those of every platform, and those of some alone.
fn names_in<'a>(manifest: &'a Table, list: &str) -> impl Iterator<Item = &'a str> {
    let platforms = manifest.get("target").and_then(toml::Value::as_table).into_iter().flat_map(Table::values);
    let tables = std::iter::once(manifest).chain(platforms.filter_map(toml::Value::as_table));
    let lists = tables.filter_map(move |table| table.get(list).and_then(toml::Value::as_table));
    lists.flat_map(|list| list.keys().map(String::as_str))
}

/// Whether a line of code speaks of a crate: in a path, an import or an attribute.
fn speaks_of(line: &str, dependency: &str) -> bool {
    let name = dependency.replace('-', "_");
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    line.match_indices(&name).any(|(at, _)| {
        let (before, after) = (&line[..at], &line[at + name.len()..]);
        let is_whole = !before.ends_with(is_word) && !after.starts_with(is_word);
        is_whole && (after.starts_with("::") || before.ends_with("use ") || before.ends_with("#["))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn violations(manifest: &str, files: &[(&str, &str)]) -> Vec<String> {
        let manifest = ProjectFile { path: "crates/a/Cargo.toml".to_owned(), text: manifest.to_owned() };
        let sources: Vec<RustSource> = files.iter().map(|(path, text)| RustSource::new(path, text)).collect();
        check(&[manifest], &sources).into_iter().map(|violation| violation.what).collect()
    }

    #[test]
    fn what_code_names_is_used() {
        let manifest = "[dependencies]\nlib-m = \"1\"\nserde = \"1\"\n[dev-dependencies]\nproptest = \"1\"\n";
        let source = ("crates/a/src/lib.rs", "use lib_m;\n#[serde(flatten)]\nfn f() {}\n");
        let test = ("crates/a/tests/it.rs", "use proptest::prelude::*;\n");
        assert_eq!(violations(manifest, &[source, test]), Vec::<String>::new());
    }

    #[test]
    fn what_only_comments_tests_or_other_crates_name_is_not() {
        let manifest = "[dependencies]\nlibm = \"1\"\nglam = \"1\"\n[dev-dependencies]\nproptest = \"1\"\n";
        let source = ("crates/a/src/lib.rs", "//! Uses libm::sin.\nfn f(glam: f64) {}\n");
        let test = ("crates/a/tests/it.rs", "use glam::DVec3;\n");
        let other = ("crates/b/src/lib.rs", "use proptest::prelude::*;\nuse libm;\n");
        assert_eq!(violations(manifest, &[source, test, other]).len(), 3);
    }

    #[test]
    fn dependencies_of_a_platform_count_too() {
        let manifest = "[target.'cfg(unix)'.dependencies]\nlibm = \"1\"\nglam = \"1\"\n";
        let found = violations(manifest, &[("crates/a/src/lib.rs", "use libm::sin;\n")]);
        assert!(found.len() == 1 && found[0].contains("glam"), "{found:?}");
    }

    #[test]
    fn a_library_of_the_workspace_that_no_crate_asks_for_is_unused() {
        let file = |path: &str, text: &str| ProjectFile { path: path.to_owned(), text: text.to_owned() };
        let workspace = file("Cargo.toml", "[workspace.dependencies]\nlibm = \"1\"\nglam = \"1\"\n");
        let own = file("crates/a/Cargo.toml", "[dependencies]\nlibm.workspace = true\n");
        let sources = [RustSource::new("crates/a/src/lib.rs", "use libm::sin;\n")];
        let found = check(&[workspace, own], &sources);
        assert_eq!(found.len(), 1);
        assert!(found[0].what.contains("glam"), "{found:?}");
    }
}
