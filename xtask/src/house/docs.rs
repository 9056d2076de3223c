//! Rules about documents and manifests.

use super::project_file::ProjectFile;
use super::rules::LONGEST_LINE;
use super::rust_source::RustSource;
use super::violation::Violation;
use std::path::Path;

/// Documents whose paths must exist.
const DOCUMENTS: [&str; 4] = ["README.md", "docs/ARCHITECTURE.md", "docs/NOTATION.md", "docs/REFERENCES.md"];

/// Where sources stand.
const REFERENCES: &str = "docs/REFERENCES.md";

/// Crates whose manifest does not say `[lints] workspace = true`.
pub(super) fn lints(files: &[ProjectFile]) -> Vec<Violation> {
    let manifests =
        files.iter().filter(|file| file.path.ends_with("/Cargo.toml") && !file.path.starts_with("fixtures/"));
    manifests
        .filter(|file| {
            let mut lines = file.text.lines().skip_while(|line| line.trim() != "[lints]").skip(1);
            lines.next().is_none_or(|line| line.trim() != "workspace = true")
        })
        .map(|file| Violation::in_file(&file.path, "needs [lints] workspace = true"))
        .collect()
}

/// Lines of the Python package that are too long: as those of Rust.
pub(super) fn python_lines(files: &[ProjectFile]) -> Vec<Violation> {
    let is_python = |file: &&ProjectFile| {
        let ending = Path::new(&file.path).extension().and_then(std::ffi::OsStr::to_str);
        file.path.starts_with("crates/polhode-py/") && matches!(ending, Some("py" | "pyi"))
    };
    let mut violations = Vec::new();
    for file in files.iter().filter(is_python) {
        for (number, line) in file.text.lines().enumerate() {
            let columns = line.chars().count();
            if columns > LONGEST_LINE {
                let place = format!("{}:{}", file.path, number + 1);
                violations.push(Violation::in_file(place, format!("has {columns} columns, more than {LONGEST_LINE}")));
            }
        }
    }
    violations
}

/// Paths between backticks, or linked to, in the documents that do not exist.
pub(super) fn paths_exist(files: &[ProjectFile], root: &Path) -> Vec<Violation> {
    let mut violations = Vec::new();
    for name in DOCUMENTS {
        let Some(document) = files.iter().find(|file| file.path == name) else {
            violations.push(Violation::in_file(name, "is missing"));
            continue;
        };
        let folder = Path::new(name).parent().unwrap_or(Path::new(""));
        for (number, line) in document.text.lines().enumerate() {
            for path in paths_in(line) {
                let place = if path.is_link { root.join(folder).join(&path.text) } else { root.join(&path.text) };
                if !place.exists() {
                    violations.push(Violation::in_file(
                        format!("{name}:{}", number + 1),
                        format!("{} does not exist", path.text),
                    ));
                }
            }
        }
    }
    violations
}

/// A path in a document.
#[derive(Debug, PartialEq, Eq)]
struct NamedPath {
    text: String,
    /// Links are relative to the document; paths between backticks are relative to the workspace.
    is_link: bool,
}

/// Top folders and files of the workspace: a word between backticks that begins with one of them is a path.
const TOPS: [&str; 6] = ["crates/", "xtask/", "fixtures/", "docs/", ".ci/", ".cargo/"];

fn paths_in(line: &str) -> Vec<NamedPath> {
    let mut paths: Vec<NamedPath> = line
        .split('`')
        .skip(1)
        .step_by(2)
        // A command between backticks may name a path among its words.
        .flat_map(str::split_whitespace)
        .filter(|word| TOPS.iter().any(|top| word.starts_with(top)))
        .filter(|word| !word.contains(['<', '*', '{']))
        .map(|word| NamedPath { text: word.trim_end_matches([',', '.', ';', ':']).to_owned(), is_link: false })
        .collect();
    let links = line.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    paths.extend(
        links
            .map(|link| link.split('#').next().unwrap_or_default())
            .filter(|link| !link.is_empty() && !link.contains("://") && !link.starts_with("mailto:"))
            .map(|link| NamedPath { text: link.to_owned(), is_link: true }),
    );
    paths
}

/// Sources that modules cite as `docs/REFERENCES.md, Name ...` and that are not there.
pub(super) fn citations(files: &[ProjectFile], sources: &[RustSource]) -> Vec<Violation> {
    let Some(references) = files.iter().find(|file| file.path == REFERENCES) else {
        return vec![Violation::in_file(REFERENCES, "is missing")];
    };
    let mut violations = Vec::new();
    for source in sources.iter().filter(|source| !source.path().starts_with("xtask/")) {
        let docs = comment_text(source);
        for (line, key) in docs {
            let name: String = key.chars().take_while(|c| c.is_alphanumeric() || *c == '-').collect();
            if !name.is_empty() && !references.text.contains(&name) {
                violations.push(Violation::at_line(source, line, format!("{name} is not in {REFERENCES}")));
            }
        }
    }
    violations
}

/// What follows each `docs/REFERENCES.md, ` in the comments of a file, with its line.
fn comment_text(source: &RustSource) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let lines = source.text();
    for (number, line) in lines.iter().enumerate() {
        for (at, _) in line.match_indices(REFERENCES) {
            // The name may stand on the next line of the comment.
            let next = lines.get(number + 1).map_or("", |next| next.trim_start().trim_start_matches(['/', '!', ' ']));
            let rest = format!("{} {next}", line[at + REFERENCES.len()..].trim_end());
            if let Some(key) = rest.trim_start_matches([')', '`', ']']).strip_prefix([',', ':']) {
                found.push((number, key.trim_start_matches([' ', '"']).to_owned()));
            }
        }
    }
    found
}

/// Folders of machines. In pieces, so that this file does not contain them.
const MACHINE_FOLDERS: [[&str; 2]; 5] =
    [["/wo", "rk/"], ["/t", "mp/"], ["/ho", "me/"], ["/ro", "ot/"], ["/Us", "ers/"]];

/// Files that name a folder of somebody's machine.
pub(super) fn machine_paths(files: &[ProjectFile]) -> Vec<Violation> {
    let folders: Vec<String> = MACHINE_FOLDERS.iter().map(|parts| parts.concat()).collect();
    let mut violations = Vec::new();
    for file in files {
        for (number, line) in file.text.lines().enumerate() {
            for folder in folders.iter().filter(|folder| names_folder(line, folder)) {
                let place = format!("{}:{}", file.path, number + 1);
                violations.push(Violation::in_file(place, format!("names the folder {folder} of a machine")));
            }
        }
    }
    violations
}

/// Whether the folder stands at the root of a path, not inside another one (as in an address or a relative path).
fn names_folder(line: &str, folder: &str) -> bool {
    line.match_indices(folder).any(|(at, _)| {
        line[..at].chars().next_back().is_none_or(|before| !(before.is_alphanumeric() || "-_./".contains(before)))
            && line[at + folder.len()..].starts_with(|c: char| c.is_alphanumeric() || c == '.' || c == '_')
    })
}

#[cfg(test)]
mod tests {
    //! Paths, citations and folders are found where they stand and nowhere else.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn paths_of_a_line() {
        let found = paths_in(
            "See `crates/a/src/b.rs`, `a / b`, `cargo run -- run fixtures/x.toml`, [c](../d.md#e) and \
             [f](https://g.h/i).",
        );
        let texts: Vec<&str> = found.iter().map(|path| path.text.as_str()).collect();
        assert_eq!(texts, ["crates/a/src/b.rs", "fixtures/x.toml", "../d.md"]);
    }

    #[test]
    fn folders_of_a_machine() {
        let folder = MACHINE_FOLDERS[0].concat();
        assert!(names_folder(&format!("see {folder}main"), &folder));
        assert!(!names_folder(&format!("https://a.b{folder}main"), &folder));
        assert!(!names_folder("a framework", &folder));
    }

    #[test]
    fn citations_are_read_over_the_end_of_a_line() {
        let source = RustSource::new(
            "crates/a/src/b.rs",
            "//! Source: docs/REFERENCES.md, Neumaier 1974.\n//! And docs/REFERENCES.md,\n//! Golub and Van Loan.\n",
        );
        let keys: Vec<String> =
            comment_text(&source).into_iter().map(|(_, key)| key.split(' ').next().unwrap().to_owned()).collect();
        assert_eq!(keys, ["Neumaier", "Golub"]);
    }
}
