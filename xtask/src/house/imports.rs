//! Which files of a crate import which: by `use` and by paths in the code, each followed through re-exports to the file
//! that holds the name.
//!
//! A `pub use` alone is no import: a table of contents may name all its parts. Tests do not count. Fails: a name that
//! comes in by a glob is followed no further than the module named, and paths that a macro makes are not seen.

use super::rust_source::RustSource;
use std::collections::{BTreeMap, BTreeSet};

/// Re-exports that are followed from one to the next, at the most.
const MOST_REEXPORTS: usize = 10;

/// The files of a crate by their modules (`a::b`, the root the empty text), and what they import.
#[derive(Debug, Default)]
pub(super) struct Imports {
    files: BTreeMap<String, File>,
}

/// A file as far as its imports go.
#[derive(Debug, Default)]
struct File {
    path: String,
    /// Names that other files may come by through this one, and where they are.
    names: BTreeMap<String, Vec<String>>,
    /// Paths that its code uses, from the root of the crate.
    used: Vec<Vec<String>>,
}

/// A name that a `use` brings in.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Use {
    path: Vec<String>,
    name: String,
    is_public: bool,
}

impl Imports {
    /// Of the crate whose sources stand in `folder` (`crates/x/src`).
    pub(super) fn of(sources: &[RustSource], folder: &str) -> Self {
        let in_folder = |source: &&RustSource| source.path().strip_prefix(folder).is_some_and(|p| p.starts_with('/'));
        let codes: BTreeMap<String, (&str, String)> = sources
            .iter()
            .filter(in_folder)
            .map(|source| (module_of(source.path(), folder), (source.path(), product_text(source))))
            .collect();
        let modules: BTreeSet<&str> = codes.keys().map(String::as_str).collect();
        let files =
            codes.iter().map(|(module, (path, code))| (module.clone(), File::new(path, module, code, &modules)));
        Self { files: files.collect() }
    }

    /// For every file the files it imports, by their paths.
    pub(super) fn arrows(&self) -> BTreeMap<&str, BTreeSet<&str>> {
        let targets = |file: &File| {
            let own = file.path.as_str();
            let found = file.used.iter().filter_map(|path| self.holder(path)).map(|target| target.path.as_str());
            found.filter(|target| *target != own).collect::<BTreeSet<_>>()
        };
        self.files.values().map(|file| (file.path.as_str(), targets(file))).collect()
    }

    /// The file that holds what a path from the root names.
    fn holder(&self, path: &[String]) -> Option<&File> {
        let mut path = path.to_vec();
        for _ in 0..MOST_REEXPORTS {
            let depth = (0..=path.len()).rev().find(|&n| self.files.contains_key(&path[..n].join("::")))?;
            let file = self.files.get(&path[..depth].join("::"))?;
            let Some(source) = path.get(depth).and_then(|name| file.names.get(name)) else { return Some(file) };
            path = source.iter().chain(&path[depth + 1..]).cloned().collect();
        }
        None
    }
}

impl File {
    fn new(path: &str, module: &str, code: &str, modules: &BTreeSet<&str>) -> Self {
        let (uses, rest) = split_uses(code);
        let from_root = |path: &[String]| from_root(module, path, modules);
        let rest = words_of_paths(&rest);
        let mut file = Self { path: path.to_owned(), ..Self::default() };
        for Use { path, name, is_public } in &uses {
            let Some(path) = from_root(path) else { continue };
            let is_used = || rest.iter().any(|words| words.first() == Some(name));
            if !is_public || is_used() {
                file.used.push(path.clone());
            }
            file.names.insert(name.clone(), path);
        }
        // A path may begin with a name that a `use` has brought in.
        let through = |words: &[String]| {
            let source = file.names.get(words.first()?)?;
            Some(source.iter().chain(&words[1..]).cloned().collect::<Vec<_>>())
        };
        let paths = rest.iter().filter(|words| words.len() > 1);
        let used: Vec<_> = paths.filter_map(|words| from_root(words).or_else(|| through(words))).collect();
        file.used.extend(used);
        file
    }
}

/// The module of a file: `crates/x/src/a/b.rs` and `crates/x/src/a/b/mod.rs` hold `a::b`, `lib.rs` and `main.rs` the
/// root.
fn module_of(path: &str, folder: &str) -> String {
    let inner = path.strip_prefix(folder).unwrap_or(path).trim_start_matches('/').trim_end_matches(".rs");
    let inner = inner.strip_suffix("/mod").unwrap_or(inner);
    if matches!(inner, "lib" | "main") { String::new() } else { inner.replace('/', "::") }
}

/// The code outside tests, one text.
fn product_text(source: &RustSource) -> String {
    source.product_code().map(|(_, line)| line).collect::<Vec<_>>().join("\n")
}

/// A path from the root of the crate, of one that stands in a module; nothing for one into another crate.
fn from_root(module: &str, path: &[String], modules: &BTreeSet<&str>) -> Option<Vec<String>> {
    let mut own: Vec<String> = module.split("::").filter(|part| !part.is_empty()).map(str::to_owned).collect();
    let mut rest = path;
    match path.first().map(String::as_str)? {
        "crate" => {
            own.clear();
            rest = &path[1..];
        }
        "self" => rest = &path[1..],
        "super" => {
            while let Some(("super", after)) = rest.split_first().map(|(first, after)| (first.as_str(), after)) {
                own.pop();
                rest = after;
            }
        }
        first => {
            let child = own.iter().map(String::as_str).chain([first]).collect::<Vec<_>>().join("::");
            if !modules.contains(child.as_str()) {
                return None;
            }
        }
    }
    own.extend(rest.iter().filter(|part| *part != "self" && *part != "*").cloned());
    Some(own)
}

/// What the `use` items of a code bring in, and the code without them.
fn split_uses(code: &str) -> (Vec<Use>, String) {
    let (mut uses, mut rest, mut left) = (Vec::new(), String::new(), code);
    while let Some(at) = next_use(left) {
        let before = &left[..at];
        let is_public = before.trim_end().ends_with("pub") || before.trim_end().ends_with(')');
        let item = &left[at + "use ".len()..];
        let end = item.find(';').unwrap_or(item.len());
        expand(&item[..end].split_whitespace().collect::<Vec<_>>().join(" "), &[], is_public, &mut uses);
        rest.push_str(before);
        left = item.get(end + 1..).unwrap_or_default();
    }
    rest.push_str(left);
    (uses, rest)
}

/// Where the next item that begins with `use` stands.
fn next_use(code: &str) -> Option<usize> {
    let begins_item = |at: usize| {
        let before = code[..at].trim_end();
        let last = before.chars().next_back();
        let follows_visibility = before.ends_with("pub") || (last == Some(')') && before.rfind("pub(").is_some());
        last.is_none_or(|c| matches!(c, ';' | '{' | '}' | ']')) || follows_visibility
    };
    code.match_indices("use ").map(|(at, _)| at).find(|&at| begins_item(at))
}

/// The names of a tree `a::{b, c::{d, e as f}}`.
fn expand(tree: &str, prefix: &[String], is_public: bool, uses: &mut Vec<Use>) {
    let tree = tree.trim();
    let (path, group) = match tree.split_once('{') {
        Some((path, group)) => (path, Some(group.strip_suffix('}').unwrap_or(group))),
        None => (tree, None),
    };
    let (path, alias) = path.split_once(" as ").map_or((path, None), |(path, alias)| (path, Some(alias)));
    let parts = path.split("::").map(str::trim).filter(|part| !part.is_empty()).map(str::to_owned);
    let path: Vec<String> = prefix.iter().cloned().chain(parts).collect();
    if let Some(group) = group {
        for part in split_at_commas(group) {
            expand(part, &path, is_public, uses);
        }
        return;
    }
    let own_name = path.iter().rev().find(|part| *part != "self").cloned();
    if let Some(name) = alias.map(|alias| alias.trim().to_owned()).or(own_name) {
        uses.push(Use { path, name, is_public });
    }
}

/// The parts between the commas of a group that stand in no inner group.
fn split_at_commas(group: &str) -> Vec<&str> {
    let (mut parts, mut depth, mut start) = (Vec::new(), 0usize, 0);
    for (at, character) in group.char_indices() {
        match character {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            ',' if depth == 0 => {
                parts.push(&group[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&group[start..]);
    parts.retain(|part| !part.trim().is_empty());
    parts
}

/// The paths of a code, each as its words; a word alone is one too.
fn words_of_paths(code: &str) -> Vec<Vec<String>> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut paths: Vec<Vec<String>> = Vec::new();
    let (mut left, mut goes_on) = (code, false);
    while let Some(start) = left.find(is_word) {
        goes_on &= left[..start].trim().is_empty() || left[..start].trim() == "::";
        let word: String = left[start..].chars().take_while(|&c| is_word(c)).collect();
        let after = &left[start + word.len()..];
        match paths.last_mut().filter(|_| goes_on) {
            Some(path) => path.push(word),
            None => paths.push(vec![word]),
        }
        goes_on = after.starts_with("::");
        left = after;
    }
    paths
}

#[cfg(test)]
mod tests {
    //! Names are followed to the files that hold them, through re-exports; tests and tables of contents import nothing.
    use super::*;

    fn arrows(files: &[(&str, &str)]) -> Vec<(String, String)> {
        let sources: Vec<RustSource> = files.iter().map(|(path, text)| RustSource::new(path, text)).collect();
        let imports = Imports::of(&sources, "crates/x/src");
        let name = |path: &str| path.trim_start_matches("crates/x/src/").to_owned();
        let arrows = imports.arrows();
        arrows.iter().flat_map(|(from, to)| to.iter().map(|to| (name(from), name(to))).collect::<Vec<_>>()).collect()
    }

    #[test]
    fn names_are_followed_to_the_files_that_hold_them() {
        let found = arrows(&[
            ("crates/x/src/lib.rs", "mod a;\nmod b;\npub use a::{A, inner::{B as C}};\n"),
            ("crates/x/src/a/mod.rs", "pub mod inner;\npub struct A;\n"),
            ("crates/x/src/a/inner.rs", "use super::A;\npub struct B(A);\n"),
            ("crates/x/src/b.rs", "use crate::C;\nuse std::fmt;\nfn f() -> crate::a::A { crate::a::A }\n"),
        ]);
        let text = |(from, to): (&str, &str)| (from.to_owned(), to.to_owned());
        let expected = [("a/inner.rs", "a/mod.rs"), ("b.rs", "a/inner.rs"), ("b.rs", "a/mod.rs")].map(text);
        assert_eq!(found, expected);
    }

    #[test]
    fn a_path_that_begins_with_a_name_brought_in_is_followed() {
        let found = arrows(&[
            ("crates/x/src/lib.rs", "mod a;\nmod b;\n"),
            ("crates/x/src/a/mod.rs", "mod inner;\npub use inner::B;\n"),
            ("crates/x/src/a/inner.rs", "pub struct B;\n"),
            ("crates/x/src/b.rs", "use super::a;\nfn f() -> a::B { a::B }\n"),
        ]);
        let text = |(from, to): (&str, &str)| (from.to_owned(), to.to_owned());
        assert_eq!(found, [("b.rs", "a/inner.rs"), ("b.rs", "a/mod.rs")].map(text));
    }

    #[test]
    fn tests_and_tables_of_contents_import_nothing() {
        let tests = "fn f() {}\n#[cfg(test)]\nmod tests {\n  use crate::b::B;\n  #[test]\n  fn g() { let _ = B; }\n}\n";
        let found = arrows(&[
            ("crates/x/src/lib.rs", "mod a;\nmod b;\npub use b::B;\n"),
            ("crates/x/src/a.rs", tests),
            ("crates/x/src/b.rs", "pub struct B;\n"),
        ]);
        assert_eq!(found, []);
    }

    #[test]
    fn a_name_that_is_passed_on_and_used_is_imported() {
        let found = arrows(&[
            ("crates/x/src/lib.rs", "mod b;\npub(crate) use b::B;\nfn f() -> B { B }\n"),
            ("crates/x/src/b.rs", "pub struct B;\n"),
        ]);
        assert_eq!(found, [("lib.rs".to_owned(), "b.rs".to_owned())]);
    }
}
