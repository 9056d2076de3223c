//! Each crate alone: its examples, and the programs in its documentation, name no crate but their own.
//!
//! What the public functions of a crate take and return is re-exported by it, so that a user depends on it alone. An
//! example that needed a second crate would show that something is missing. An example that takes other files of the
//! crate in by `#[path = ...]` is a tool of ours for measuring and no program of a user's.

use super::layers::CORE;
use super::rust_source::RustSource;
use super::violation::Violation;

/// Libraries that crates of the core depend on, by the names under which code speaks of them.
const LIBRARIES: [&str; 7] = ["glam", "libm", "robust", "thiserror", "wide", "parry3d", "clarabel"];

/// Where examples name a second crate.
pub(super) fn check(source: &RustSource) -> Vec<Violation> {
    let own = source.crate_name().replace('-', "_");
    if !CORE.contains(&source.crate_name()) {
        return Vec::new();
    }
    let lines: Vec<(usize, &str)> =
        if is_example(source) { numbered(source.code()).collect() } else { programs_in_docs(source) };
    let mut violations = Vec::new();
    for (number, line) in lines {
        for name in roots_of_paths(line).filter(|name| *name != own && is_crate(name)) {
            let what = format!("names {name}: a user of {own} depends on it alone; re-export from it what is needed");
            violations.push(Violation::at_line(source, number, what));
        }
    }
    violations
}

/// Whether the file is an example that a user could have written.
pub(super) fn is_example(source: &RustSource) -> bool {
    let parts: Vec<&str> = source.path().split('/').collect();
    matches!(parts[..], ["crates", _, "examples", _]) && !source.code().iter().any(|line| line.contains("#[path"))
}

fn numbered(lines: &[String]) -> impl Iterator<Item = (usize, &str)> {
    lines.iter().enumerate().map(|(number, line)| (number, line.as_str()))
}

/// Lines between the fences of documentation.
fn programs_in_docs(source: &RustSource) -> Vec<(usize, &str)> {
    let mut inside = false;
    let mut lines = Vec::new();
    for (number, line) in numbered(source.text()) {
        let trimmed = line.trim_start();
        let Some(text) = trimmed.strip_prefix("//!").or_else(|| trimmed.strip_prefix("///")) else {
            inside = false;
            continue;
        };
        if text.trim_start().starts_with("```") {
            inside = !inside;
        } else if inside {
            lines.push((number, text));
        }
    }
    lines
}

/// The first names of the paths in a line of code: what stands before `::` and not behind it, or behind `use`.
fn roots_of_paths(line: &str) -> impl Iterator<Item = &str> {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    line.match_indices(is_name).filter_map(move |(at, _)| {
        let before = &line[..at];
        let starts = !before.ends_with(is_name) && !before.ends_with("::");
        let end = line[at..].find(|c| !is_name(c)).map_or(line.len(), |length| at + length);
        let is_root = line[end..].starts_with("::") || before.ends_with("use ");
        (starts && is_root).then(|| &line[at..end])
    })
}

fn is_crate(name: &str) -> bool {
    name == "polhode" || name.starts_with("polhode_") || LIBRARIES.contains(&name)
}

#[cfg(test)]
mod tests {
    //! A second crate is found in code and in documented programs, and nowhere else; the examples are there.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::super::project_file::project_files;
    use super::*;
    use std::path::Path;

    fn lines_found(path: &str, text: &str) -> Vec<String> {
        let found = check(&RustSource::new(path, text));
        found.into_iter().map(|violation| violation.place.rsplit(':').next().unwrap().to_owned()).collect()
    }

    #[test]
    fn an_example_names_its_own_crate() {
        let text = "//! Of glam::DVec3.\nuse polhode_mesh::{Mass, spatial::DVec3};\nuse polhode_spatial::Pose;\n\
                    let a = glam::DVec3::X;\nlet b = polhode_mesh::spatial::glam::c();\nuse polhode as p;\n";
        assert_eq!(lines_found("crates/polhode-mesh/examples/a.rs", text), ["3", "4", "6"]);
        assert_eq!(lines_found("crates/polhode-cli/examples/a.rs", text), Vec::<String>::new());
        let tool = format!("#[path = \"../tests/b.rs\"]\nmod b;\n{text}");
        assert_eq!(lines_found("crates/polhode-mesh/examples/a.rs", &tool), Vec::<String>::new());
    }

    #[test]
    fn a_program_in_docs_names_its_own_crate() {
        let text = "//! See polhode_spatial::Pose.\n//! ```\n//! use polhode_spatial::Pose;\n//! ```\n\
            use glam::DVec3;\n\
                    /// ```\n/// # let a = polhode_mesh::obj::read(b)?;\n/// let c = glam::DVec3::X;\n/// ```\n";
        assert_eq!(lines_found("crates/polhode-mesh/src/a.rs", text), ["3", "8"]);
    }

    #[test]
    fn every_crate_alone_has_an_example() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let files = project_files(root).unwrap();
        let sources: Vec<RustSource> =
            files.iter().filter(|f| f.is_rust()).map(|f| RustSource::new(&f.path, &f.text)).collect();
        for name in CORE.into_iter().filter(|name| *name != "polhode") {
            assert!(sources.iter().any(|s| s.crate_name() == name && is_example(s)), "{name} has no example");
        }
        for source in &sources {
            assert_eq!(check(source), vec![]);
        }
    }
}
