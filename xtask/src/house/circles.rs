//! Circles of files: files of a crate that import each other, through others or not.
//!
//! The files of a circle can be read, moved and tested only together. Each is in one circle at the most: those that it
//! reaches by the arrows of `imports.rs` and that reach it.

use super::imports::Imports;
use super::rust_source::RustSource;
use super::violation::Violation;
use std::collections::{BTreeMap, BTreeSet};

/// Circles that are right as they are: one file of each, and why.
const EXCEPTIONS: &[(&str, &str)] = &[];

/// Every circle of files of a crate that has no reason to be one.
pub(super) fn check(sources: &[RustSource]) -> Vec<Violation> {
    let folder =
        |source: &RustSource| source.path().find("/src/").map(|at| source.path()[..at + "/src".len()].to_owned());
    let folders: BTreeSet<String> = sources.iter().filter_map(folder).collect();
    let found = folders.iter().flat_map(|folder| {
        let imports = Imports::of(sources, folder);
        circles(&imports.arrows()).iter().map(|circle| violation(circle)).collect::<Vec<_>>()
    });
    found.filter(|violation| !EXCEPTIONS.iter().any(|(file, _)| violation.what.contains(file))).collect()
}

/// The circles of a graph, each ascending.
fn circles<'a>(arrows: &BTreeMap<&'a str, BTreeSet<&'a str>>) -> BTreeSet<Vec<&'a str>> {
    let reached: BTreeMap<&str, BTreeSet<&str>> =
        arrows.keys().map(|&file| (file, reached_from(file, arrows))).collect();
    let both = |file: &str| {
        let others = reached[file].iter().copied().filter(|other| reached.get(other).is_some_and(|r| r.contains(file)));
        others.collect::<Vec<_>>()
    };
    arrows.keys().map(|&file| both(file)).filter(|circle| circle.len() > 1).collect()
}

/// What the arrows lead to from a file; the file itself only if they lead back.
fn reached_from<'a>(file: &'a str, arrows: &BTreeMap<&'a str, BTreeSet<&'a str>>) -> BTreeSet<&'a str> {
    let (mut reached, mut open) = (BTreeSet::new(), vec![file]);
    while let Some(from) = open.pop() {
        for &to in arrows.get(from).into_iter().flatten() {
            if reached.insert(to) {
                open.push(to);
            }
        }
    }
    reached
}

fn violation(circle: &[&str]) -> Violation {
    let first = circle.first().copied().unwrap_or_default();
    let what = format!("{} files import each other in a circle: {}", circle.len(), circle.join(", "));
    Violation::in_file(first, format!("{what}; move what they share into a file below them"))
}

#[cfg(test)]
mod tests {
    //! A circle is found whole, however long, and what only leads to it is none of it.
    use super::*;

    #[test]
    fn a_circle_is_found_whole() {
        let arrows = [("a", vec!["b"]), ("b", vec!["c"]), ("c", vec!["a", "e"]), ("d", vec!["a"]), ("e", vec![])];
        let arrows = arrows.map(|(from, to)| (from, to.into_iter().collect::<BTreeSet<_>>())).into();
        assert_eq!(circles(&arrows), BTreeSet::from([vec!["a", "b", "c"]]));
    }

    #[test]
    fn files_that_import_each_other_break_the_rule() {
        let sources = [
            RustSource::new("crates/x/src/lib.rs", "mod a;\nmod b;\n"),
            RustSource::new("crates/x/src/a.rs", "use crate::b::B;\npub struct A(B);\n"),
            RustSource::new("crates/x/src/b.rs", "pub struct B;\nfn f() -> Option<super::a::A> { None }\n"),
        ];
        let found = check(&sources);
        assert_eq!(found.len(), 1);
        assert!(found[0].what.contains("crates/x/src/a.rs, crates/x/src/b.rs"), "{found:?}");
    }
}
