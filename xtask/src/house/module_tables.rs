//! Every module of a room stands in the table of its room.
//!
//! The docs of a file that declares modules say in a table what each of them holds: by the module's name between
//! backticks, its file or the type of its name (`` `drag` ``, `` `drag.rs` ``, `` [`Drag`] ``). A row `the others`
//! stands for all that are alike. Modules of tests need no row.

use super::rust_source::RustSource;
use super::violation::Violation;
use std::collections::BTreeSet;

/// Every module that is missing from the table of its room.
pub(super) fn check(sources: &[RustSource]) -> Vec<Violation> {
    sources.iter().flat_map(missing).collect()
}

fn missing(source: &RustSource) -> Vec<Violation> {
    let rows: Vec<&str> = source.text().iter().filter_map(|line| line.strip_prefix("//! |")).map(str::trim).collect();
    if rows.iter().any(|row| row.starts_with("the others |")) {
        return Vec::new();
    }
    let named: BTreeSet<String> = rows
        .iter()
        .flat_map(|row| row.split('`').skip(1).step_by(2))
        .map(|name| plain(name.trim_start_matches("mod@").trim_end_matches(".rs")))
        .collect();
    let modules = source.product_code().filter_map(|(number, line)| Some((number, declared(line)?)));
    let missing = modules.filter(|(_, module)| !named.contains(&plain(module)));
    missing
        .map(|(number, module)| {
            let what = format!("{module} is not in the table of modules in the docs of this file: say what it holds");
            Violation::at_line(source, number, what)
        })
        .collect()
}

/// The module that a line declares, whose code stands in a file of its own.
fn declared(line: &str) -> Option<&str> {
    let item = line.strip_prefix("pub").map_or(line, |rest| rest.find("mod ").map_or(rest, |at| &rest[at..]));
    item.strip_prefix("mod ")?.trim_end().strip_suffix(';')
}

/// A name without what tells a module from a type.
fn plain(name: &str) -> String {
    name.chars().filter(|c| c.is_alphanumeric()).map(|c| c.to_ascii_lowercase()).collect()
}

#[cfg(test)]
mod tests {
    //! A module is found in the table by its name, its file or its type; one that is missing is told.
    use super::*;

    #[test]
    fn a_module_without_a_row_is_missing() {
        let text = "//! A room.\n//!\n//! | module | holds |\n//! |---|---|\n//! | `one`, `two.rs` | a |\n\
            //! | [`FourFive`] | b |\n\n\
                    mod one;\npub mod two;\npub(crate) mod three;\nmod four_five;\n#[cfg(test)]\nmod tests;\n\
                    mod inner {\n}\n";
        let found = check(&[RustSource::new("crates/a/src/lib.rs", text)]);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].what.starts_with("three "));
        let others = text.replace("//! | `one`", "//! | the others | c |\n//! | `one`");
        assert_eq!(check(&[RustSource::new("crates/a/src/lib.rs", &others)]), []);
    }
}
