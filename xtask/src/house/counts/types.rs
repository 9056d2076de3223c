//! Types of results, and the type `World`, which is to become `Model`.

use crate::house::count::{Count, FACADE, is_in, starts_of};
use crate::house::rust_source::RustSource;

/// The type that holds the bodies, now and when it is divided.
const MODELS: [&str; 2] = ["World", "Model"];

pub(super) fn counts(sources: &[RustSource]) -> Vec<Count> {
    let facade: Vec<&RustSource> = sources.iter().filter(|source| is_in(source, FACADE)).collect();
    let blocks = |source: &RustSource| impl_blocks(source).len();
    let is_of_model =
        |source: &&&RustSource| ["/world/", "/model/"].iter().any(|folder| source.path().contains(folder));
    let sum = |count: fn(&RustSource) -> usize| facade.iter().map(|source| count(source)).sum::<usize>() as u64;
    vec![
        Count {
            key: "result_types",
            check: "structs of polhode with a field tangential and one of reactions or bilaterals",
            review: Some(5),
            now: sum(result_types),
            goal: Some(1),
        },
        Count {
            key: "friction_at",
            check: "calls of friction_at in polhode (contact, fast, penalty)",
            review: Some(9),
            now: sum(calls_of_friction_at),
            goal: Some(3),
        },
        Count {
            key: "impl_world_files",
            check: "files of polhode with an `impl World` or `impl Model`",
            review: Some(28),
            now: facade.iter().filter(|source| blocks(source) > 0).count() as u64,
            goal: None,
        },
        Count {
            key: "impl_world_files_outside",
            check: "those of them outside of world/ and model/ (the review's sources, counted by this command)",
            review: Some(21),
            now: facade.iter().filter(|source| blocks(source) > 0).filter(|source| !is_of_model(source)).count() as u64,
            goal: Some(0),
        },
        Count {
            key: "world_methods",
            check: "methods of World (Model)",
            review: Some(200),
            now: sum(methods),
            goal: Some(59),
        },
        Count {
            key: "world_fields",
            check: "fields of World (Model)",
            review: Some(39),
            now: sum(model_fields),
            goal: Some(14),
        },
    ]
}

fn result_types(source: &RustSource) -> usize {
    let is_result = |fields: &Vec<String>| {
        let has = |name: &str| fields.iter().any(|field| field == name);
        has("tangential") && (has("reactions") || has("bilaterals"))
    };
    structs(source).iter().filter(|(_, fields)| is_result(fields)).count()
}

fn calls_of_friction_at(source: &RustSource) -> usize {
    let called = |line: &str| {
        let calls = starts_of(line, "friction_at").filter(|&at| !line[..at].ends_with("fn "));
        calls.filter(|at| line[*at..].starts_with("friction_at(")).count()
    };
    source.product_code().map(|(_, line)| called(line)).sum()
}

/// First and last line of every `impl World` and `impl Model` that implements no trait.
fn impl_blocks(source: &RustSource) -> Vec<(usize, usize)> {
    let is_impl = |line: &str| {
        let after = |name: &&str| line.strip_prefix("impl ").and_then(|rest| rest.strip_prefix(*name));
        MODELS.iter().filter_map(after).any(|rest| rest.starts_with([' ', '<']))
    };
    let starts = source.product_code().filter(|(_, line)| is_impl(line));
    starts.map(|(number, _)| (number, source.end_of_block(number))).collect()
}

fn methods(source: &RustSource) -> usize {
    let blocks = impl_blocks(source);
    // Methods stand one level inside their block; functions in functions stand deeper.
    let is_method = |line: &str| line.starts_with("    ") && !line.starts_with("     ");
    let inside = |line: usize| blocks.iter().any(|&(first, last)| (first..=last).contains(&line));
    let functions = source.functions();
    functions.iter().filter(|f| inside(f.first_line) && is_method(&source.code()[f.first_line])).count()
}

fn model_fields(source: &RustSource) -> usize {
    structs(source).iter().filter(|(name, _)| MODELS.contains(&name.as_str())).map(|(_, fields)| fields.len()).sum()
}

/// The structs with named fields that a file defines outside tests: names, and those of their fields.
fn structs(source: &RustSource) -> Vec<(String, Vec<String>)> {
    let mut found = Vec::new();
    for (number, line) in source.product_code() {
        let Some(at) = starts_of(line, "struct").next() else { continue };
        let name: String = name_at(line[at + "struct".len()..].trim_start());
        let last = source.end_of_block(number);
        if last == number && !line.contains('{') {
            continue;
        }
        let fields = source.code()[number + 1..=last.max(number + 1).min(source.code().len() - 1)].iter();
        found.push((name, fields.filter_map(|line| field(line)).collect()));
    }
    found
}

/// The name of the field that a line of a struct begins with.
fn field(line: &str) -> Option<String> {
    let item = line.trim_start();
    let item = match item.strip_prefix("pub") {
        Some(rest) if rest.starts_with('(') => rest.split_once(')')?.1.trim_start(),
        Some(rest) if rest.starts_with(' ') => rest.trim_start(),
        _ => item,
    };
    let name = name_at(item);
    let after = item[name.len()..].trim_start();
    (!name.is_empty() && after.starts_with(':') && !after.starts_with("::")).then_some(name)
}

fn name_at(text: &str) -> String {
    text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

#[cfg(test)]
mod tests {
    //! Structs, fields and methods are told from what only looks like them.
    use super::*;

    const TEXT: &str = "pub(crate) struct World {\n    /// A: b.\n    pub(crate) bodies: Vec<a::B>,\n    joints: \
        usize,\n}\n\
        struct Struck {\n    pub tangential: u8,\n    pub reactions: u8,\n}\nstruct Other {\n    tangential: u8,\n}\n\
        struct Unit;\n\
        impl World {\n    pub(crate) fn a(&self) {\n        fn inner() {}\n    }\n\n    const fn b() {}\n}\n\
        impl Drop for World {\n    fn drop(&mut self) {}\n}\n\
        impl WorldJoint {\n    fn c() {}\n}\n";

    #[test]
    fn the_type_world_is_counted() {
        let source = RustSource::new("crates/polhode/src/a.rs", TEXT);
        assert_eq!([model_fields(&source), methods(&source), result_types(&source)], [2, 2, 1]);
    }

    #[test]
    fn calls_are_told_from_the_definition() {
        let source =
            RustSource::new("crates/polhode/src/a.rs", "fn friction_at(a: u8) {}\nfn f() { w.friction_at(b); }\n");
        assert_eq!(calls_of_friction_at(&source), 1);
    }
}
