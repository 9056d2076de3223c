//! Lines, tolerances, caps and known failures.

use crate::house::count::{Count, FACADE, RESPONSE, is_in, starts_of};
use crate::house::rules::LONGEST_LINE;
use crate::house::rust_source::RustSource;

/// The crates whose constants are counted: the core without the elastic body, which is for comparison.
const COUNTED: [&str; 6] =
    ["polhode-spatial", "polhode-mesh", "polhode-dynamics", "polhode-contact", "polhode-response", "polhode"];
/// A constant of at least this size is no tolerance.
const LARGEST_TOLERANCE: f64 = 0.5;
/// What the names of caps begin with.
const CAPS: [&str; 8] = ["MOST", "MAX", "LONGEST", "LARGEST", "LIMIT", "DEEPEST", "WIDEST", "FEWEST"];
/// Where the list of rows that are known to fail stands.
const KNOWN: &str = "known.rs";

pub(super) fn counts(sources: &[RustSource]) -> Vec<Count> {
    let core: Vec<&RustSource> = sources
        .iter()
        .filter(|source| COUNTED.contains(&source.crate_name()) && source.path().contains("/src/"))
        .collect();
    let constants = |is: fn(&Constant) -> bool| {
        core.iter().map(|source| constants(source).iter().filter(|constant| is(constant)).count()).sum::<usize>() as u64
    };
    let solving = sources.iter().filter(|source| is_in(source, FACADE) || is_in(source, RESPONSE));
    let columns = |source: &RustSource| source.text().iter().map(|line| line.chars().count()).collect::<Vec<_>>();
    let columns: Vec<usize> = sources.iter().flat_map(columns).collect();
    vec![
        Count {
            key: "lines",
            check: "lines of polhode/src and polhode-response/src, tests too",
            review: Some(72_806),
            now: solving.map(|source| source.text().len()).sum::<usize>() as u64,
            goal: Some(67_999),
        },
        Count {
            key: "long_lines",
            check: "lines of more than 120 columns, comments and tests too",
            review: Some(2549),
            now: columns.iter().filter(|columns| **columns > LONGEST_LINE).count() as u64,
            goal: Some(0),
        },
        Count {
            key: "longest_line",
            check: "columns of the longest line",
            review: Some(641),
            now: columns.iter().copied().max().unwrap_or_default() as u64,
            goal: Some(LONGEST_LINE as u64),
        },
        Count {
            key: "tolerances",
            check: "f64 constants of the core below 0.5 or of an expression (tolerances and the like)",
            review: Some(420),
            now: constants(Constant::is_tolerance),
            goal: Some(329),
        },
        Count {
            key: "caps",
            check: "constants of the core named MOST, MAX, LONGEST, LARGEST, LIMIT, DEEPEST, WIDEST, FEWEST ..",
            review: Some(134),
            now: constants(Constant::is_cap),
            goal: Some(89),
        },
        Count {
            key: "known_failures",
            check: "entries of the list of rows that are known to fail",
            review: Some(56),
            now: sources.iter().map(known_failures).sum::<usize>() as u64,
            goal: None,
        },
    ]
}

/// A constant as its definition says.
#[derive(Debug)]
struct Constant {
    name: String,
    kind: String,
    value: String,
}

impl Constant {
    /// A number of f64 below a half, or one that is computed from others: 256 at commit d370e62 and 426 at ae0e5111,
    /// where the review counted 268 and 420 (its own definition is not known; this is the nearest).
    fn is_tolerance(&self) -> bool {
        let is_small = self.value.replace('_', "").parse::<f64>().is_ok_and(|value| value.abs() < LARGEST_TOLERANCE);
        let is_expression = self.value.replace('_', "").parse::<f64>().is_err();
        self.kind == "f64" && (is_small || is_expression)
    }

    /// By the name, whatever the type: 83 at commit d370e62 and 134 at ae0e5111, where the review counted 82 and 134.
    fn is_cap(&self) -> bool {
        CAPS.iter().any(|cap| self.name.starts_with(cap))
    }
}

/// The constants that a file defines outside tests, on one line or on several.
fn constants(source: &RustSource) -> Vec<Constant> {
    let code = source.product_code().map(|(_, line)| line).collect::<Vec<_>>().join("\n");
    let defined = |at: usize| {
        let rest = code[at + "const".len()..].trim_start();
        let (name, rest) = rest.split_once(": ")?;
        let is_name = name.chars().all(|c| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_');
        let (kind, rest) = rest.split_once(" = ").filter(|(kind, _)| is_name && !kind.contains('{'))?;
        let value = rest.get(..end_of_value(rest)?)?;
        Some(Constant { name: name.to_owned(), kind: kind.trim().to_owned(), value: value.trim().to_owned() })
    };
    starts_of(&code, "const").filter_map(defined).collect()
}

/// Where the semicolon that ends a value stands, outside of brackets.
fn end_of_value(rest: &str) -> Option<usize> {
    let mut depth = 0usize;
    for (at, character) in rest.char_indices() {
        match character {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.checked_sub(1)?,
            ';' if depth == 0 => return Some(at),
            _ => {}
        }
    }
    None
}

fn known_failures(source: &RustSource) -> usize {
    if !source.path().starts_with("xtask/") || source.path().rsplit('/').next() != Some(KNOWN) {
        return 0;
    }
    let entry = |line: &str| usize::from(line.trim_start().starts_with("KnownFailure {"));
    source.product_code().map(|(_, line)| entry(line)).sum()
}

#[cfg(test)]
mod tests {
    //! Constants are found with their values, on one line or on several, and told from what only looks like one.
    use super::*;

    #[test]
    fn tolerances_and_caps_are_told_apart() {
        let text = "const SMALL: f64 = 1e-9;\npub(crate) const HALF: f64 = 0.5;\n\
            const ROUNDING: f64 = 4.0 * f64::EPSILON;\n\
                    const PLACES: [f64; 2] = [\n    0.1,\n    0.2,\n];\nconst MOST_ROWS: usize = 3;\n\
                    const fn f<const N: usize>() -> f64 { 1.0 }\n\
                    #[cfg(test)]\nmod tests {\n    const IN_TESTS: f64 = 1e-9;\n}\n";
        let found = constants(&RustSource::new("crates/polhode/src/a.rs", text));
        let names =
            |is: fn(&Constant) -> bool| found.iter().filter(|c| is(c)).map(|c| c.name.as_str()).collect::<Vec<_>>();
        assert_eq!(names(Constant::is_tolerance), ["SMALL", "ROUNDING"]);
        assert_eq!(names(Constant::is_cap), ["MOST_ROWS"]);
    }
}
