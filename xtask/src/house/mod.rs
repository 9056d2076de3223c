//! Rules of the house: what docs/ARCHITECTURE.md promises and a compiler does not check.
//!
//! Each rule is one row, `0` violations being right; the violations themselves go to stderr with file and line.

mod docs;
mod layers;
mod one_dependency;
mod rules;
mod rust_source;
mod third_party;

use crate::commands;
use crate::row::Row;
use rust_source::RustSource;
use std::path::Path;

/// A place that breaks a rule.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Violation {
    /// File, relative to the workspace, with the line where there is one.
    place: String,
    /// What is wrong and what to do.
    what: String,
}

impl Violation {
    fn at_line(source: &RustSource, line: usize, what: impl Into<String>) -> Self {
        Self { place: format!("{}:{}", source.path(), line + 1), what: what.into() }
    }

    fn in_file(path: impl Into<String>, what: impl Into<String>) -> Self {
        Self { place: path.into(), what: what.into() }
    }
}

/// A file that belongs to the project.
#[derive(Debug)]
struct ProjectFile {
    /// Path relative to the workspace, with forward slashes.
    path: String,
    text: String,
}

impl ProjectFile {
    fn is_rust(&self) -> bool {
        Path::new(&self.path).extension().is_some_and(|extension| extension == "rs")
    }
}

/// Crates of the core: no input, output, clock, thread or global.
const CORE: [&str; 6] =
    ["polhode-spatial", "polhode-mesh", "polhode-dynamics", "polhode-contact", "polhode-response", "polhode"];

/// Checks every rule.
pub(crate) fn check(root: &Path) -> Vec<Row> {
    let files = match project_files(root) {
        Ok(files) => files,
        Err(error) => return vec![Row::broken("house", "files of the project", error)],
    };
    let sources: Vec<RustSource> =
        files.iter().filter(|file| file.is_rust()).map(|file| RustSource::new(&file.path, &file.text)).collect();
    let mut rows = vec![row("arrows between crates", &layers::check(root))];
    rows.push(row("parry3d and clarabel stay in their private module", &third_party::check(&sources)));
    rows.extend(rules::ALL.iter().map(|rule| row(rule.name, &rule.check(&sources))));
    rows.push(row("crates follow the lints of the workspace", &docs::lints(&files)));
    rows.push(row("paths named in the documents exist", &docs::paths_exist(&files, root)));
    rows.push(row("sources cited in modules stand in REFERENCES.md", &docs::citations(&files, &sources)));
    rows.push(row("no path of a machine in a file", &docs::machine_paths(&files)));
    rows
}

/// One rule as a row; its violations go to stderr.
fn row(rule: &str, violations: &[Violation]) -> Row {
    for violation in violations {
        eprintln!("\n  {}: {}", violation.place, violation.what);
    }
    Row::exact("house", rule, 0, violations.len() as u64)
}

/// All files that git knows or would add, with their text; files that are not text are left out.
fn project_files(root: &Path) -> Result<Vec<ProjectFile>, String> {
    let output = std::process::Command::new("git")
        .args(["ls-files", "--cached", "--others", "--exclude-standard"])
        .current_dir(root)
        .output()
        .map_err(|error| format!("git ls-files: {error}"))?;
    if !output.status.success() {
        return Err(format!("git ls-files: {}", String::from_utf8_lossy(&output.stderr).trim()));
    }
    let mut paths: Vec<String> = String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect();
    paths.sort();
    paths.dedup();
    // A path that git knows and that is gone from the folder has been deleted and not yet been committed.
    let read = |path: String| std::fs::read_to_string(root.join(&path)).ok().map(|text| ProjectFile { path, text });
    Ok(paths.into_iter().filter_map(read).collect())
}

/// What `cargo metadata` says about the workspace.
fn metadata(root: &Path) -> Result<cargo_metadata::Metadata, String> {
    let mut command = cargo_metadata::MetadataCommand::new();
    command.current_dir(root).no_deps();
    if let Some(program) = commands::cargo(root).get_program().to_str() {
        command.cargo_path(program);
    }
    command.exec().map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    //! The house keeps its own rules; the same check that `verify` makes.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn sources_of_this_program_keep_the_rules() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let files = project_files(root).unwrap();
        let own: Vec<RustSource> = files
            .iter()
            .filter(|file| file.path.starts_with("xtask/") && file.is_rust())
            .map(|file| RustSource::new(&file.path, &file.text))
            .collect();
        assert!(!own.is_empty());
        for rule in rules::ALL {
            assert_eq!(rule.check(&own), vec![], "{}", rule.name);
        }
    }
}
