//! No two tolerances of one name with two values.
//!
//! A reader who knows what `SAME_NORMAL` is in one file takes it for the same in the next. In the crates that say what
//! bodies do to each other a name of a number stands for one value, wherever it is defined. The other crates compute
//! one thing a file, and their names need not differ.

use super::rust_source::RustSource;
use super::violation::Violation;
use std::collections::BTreeMap;

/// The crates that say what bodies do to each other.
const CRATES: [&str; 2] = ["polhode", "polhode-response"];

/// Constants whose value differs from that of another one with the same name.
pub(super) fn check(sources: &[RustSource]) -> Vec<Violation> {
    let mut values: BTreeMap<&str, (&str, &str)> = BTreeMap::new();
    let mut violations = Vec::new();
    for source in sources.iter().filter(|source| CRATES.contains(&source.crate_name())) {
        for (number, line) in source.product_code() {
            let Some((name, value)) = tolerance(line) else { continue };
            let (first, path) = *values.entry(name).or_insert((value, source.path()));
            if first != value {
                let what = format!("{name} is {value} here and {first} in {path}: names of two values differ");
                violations.push(Violation::at_line(source, number, what));
            }
        }
    }
    violations
}

/// Name and value of a constant number that a line defines.
fn tolerance(line: &str) -> Option<(&str, &str)> {
    let item = line.trim_start();
    let item = match item.strip_prefix("pub") {
        Some(public) => public.split_once(' ')?.1,
        None => item,
    };
    let (name, rest) = item.strip_prefix("const ")?.split_once(": f64 = ")?;
    Some((name, rest.trim_end().strip_suffix(';')?))
}

#[cfg(test)]
mod tests {
    //! Two values of one name are found across files; other types, other crates and tests are left alone.
    use super::*;

    #[test]
    fn a_name_with_two_values_is_a_violation() {
        let source = |path: &str, text: &str| RustSource::new(path, text);
        let first = source("crates/polhode/src/a.rs", "pub(crate) const SAME: f64 = 1e-9;\nconst MOST: usize = 3;\n");
        let second = source("crates/polhode-response/src/b.rs", "const SAME: f64 = 1e-10;\nconst MOST: usize = 4;\n");
        let agrees = source("crates/polhode/src/c.rs", "const SAME: f64 = 1e-9;\n");
        let elsewhere = source("crates/polhode-view/src/d.rs", "const SAME: f64 = 2.0;\n");
        assert_eq!(check(&[first, second, agrees, elsewhere]).len(), 1);
    }
}
