//! Rules about one source file at a time.

use super::layers::CORE;
use super::one_dependency;
use super::rust_source::RustSource;
use super::violation::Violation;

/// Longest line, columns; `rustfmt` keeps to it where it can break a line, which it does not in comments, texts and
/// macros.
pub(super) const LONGEST_LINE: usize = 120;
/// Longest file, lines.
const LONGEST_FILE: usize = 700;
/// Longest function, lines, braces included.
const LONGEST_FUNCTION: usize = 70;
/// A function with this comment in it or above it may be longer; the reason follows.
const LONG_BECAUSE: &str = "// Long because: ";

/// The crate of oracles.
const ORACLES: &str = "xtask/polhode-oracles/src/";
/// What oracles judge, as code names it; a mesh of triangles is data and may go in.
const JUDGED: [&str; 6] =
    ["polhode_contact", "polhode::contact", "polhode_mesh", "polhode::mesh", "polhode_response", "polhode::response"];
const DATA: &str = "polhode::mesh::TriangleMesh";

/// The one file of the core with a global: the table of `cargo xtask census`, which exists with the feature of that
/// name alone.
const CENSUS: &str = "crates/polhode-response/src/census/mod.rs";

/// A rule about one source file at a time.
#[derive(Debug)]
pub(super) struct Rule {
    /// What is right.
    pub(super) name: &'static str,
    find: fn(&RustSource) -> Vec<Violation>,
}

impl Rule {
    /// Every place in the sources that breaks it.
    pub(super) fn check(&self, sources: &[RustSource]) -> Vec<Violation> {
        sources.iter().flat_map(self.find).collect()
    }
}

/// All rules.
pub(super) const ALL: &[Rule] = &[
    Rule { name: "every file begins with module docs", find: module_docs },
    Rule { name: "lines of at most 120 columns", find: line_length },
    Rule { name: "files of at most 700 lines", find: file_length },
    Rule { name: "functions of at most 70 lines", find: function_length },
    Rule { name: "the core prints nothing", find: printing },
    Rule { name: "the core has no clock, files, threads, globals", find: outside_world },
    Rule { name: "the core computes the same bits everywhere", find: same_bits },
    Rule { name: "no unwrap or expect outside tests", find: unwraps },
    Rule { name: "no epsilon without a name", find: bare_epsilons },
    Rule { name: "oracles share no code with what they judge", find: oracles },
    Rule { name: "examples of a crate name that crate alone", find: one_dependency::check },
];

fn module_docs(source: &RustSource) -> Vec<Violation> {
    let first = source.text().iter().find(|line| !line.trim().is_empty());
    if first.is_some_and(|line| line.starts_with("//!")) {
        Vec::new()
    } else {
        vec![Violation::at_line(source, 0, "begins without module docs (//!): say what the file holds")]
    }
}

/// Lines that are too long: of code, comments, texts and tables alike.
fn line_length(source: &RustSource) -> Vec<Violation> {
    let lines = source.text().iter().map(|line| line.chars().count()).enumerate();
    let lines = lines.filter(|(_, columns)| *columns > LONGEST_LINE);
    lines
        .map(|(number, columns)| {
            Violation::at_line(source, number, format!("has {columns} columns, more than {LONGEST_LINE}: break it"))
        })
        .collect()
}

fn file_length(source: &RustSource) -> Vec<Violation> {
    let lines = source.text().len();
    if lines <= LONGEST_FILE {
        return Vec::new();
    }
    vec![Violation::in_file(source.path(), format!("has {lines} lines, more than {LONGEST_FILE}: split it by concept"))]
}

fn function_length(source: &RustSource) -> Vec<Violation> {
    let mut violations = Vec::new();
    for function in source.functions() {
        let lines = function.last_line - function.first_line + 1;
        let first_comment = (0..function.first_line)
            .rev()
            .take_while(|&line| {
                let text = source.text()[line].trim();
                text.starts_with("//") || text.starts_with("#[")
            })
            .last()
            .unwrap_or(function.first_line);
        let excused = source.text()[first_comment..=function.last_line].iter().any(|line| line.contains(LONG_BECAUSE));
        if lines > LONGEST_FUNCTION && !excused {
            let what = format!("fn {} has {lines} lines, more than {LONGEST_FUNCTION}", function.name);
            violations.push(Violation::at_line(source, function.first_line, what));
        }
    }
    violations
}

/// Words of code that the core may not contain outside tests, and why.
fn forbidden_in_core(source: &RustSource, words: &[&str], why: &str) -> Vec<Violation> {
    if !CORE.contains(&source.crate_name()) {
        return Vec::new();
    }
    forbidden(source, words, why)
}

/// Words of code that may not be there outside tests, and why.
fn forbidden(source: &RustSource, words: &[&str], why: &str) -> Vec<Violation> {
    let mut violations = Vec::new();
    for (number, line) in source.product_code() {
        for word in words.iter().filter(|word| contains_word(line, word)) {
            violations.push(Violation::at_line(source, number, format!("{word}: {why}")));
        }
    }
    violations
}

/// Whether `word` stands in `line` and is not the end of a longer name.
fn contains_word(line: &str, word: &str) -> bool {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    line.match_indices(word).any(|(at, _)| {
        !word.starts_with(is_name) || line[..at].chars().next_back().is_none_or(|before| !is_name(before))
    })
}

fn printing(source: &RustSource) -> Vec<Violation> {
    let words = ["println!", "eprintln!", "print!", "eprint!", "dbg!"];
    forbidden_in_core(source, &words, "the core prints nothing; return a value")
}

fn outside_world(source: &RustSource) -> Vec<Violation> {
    let modules = ["std::time", "std::fs", "std::thread", "std::io", "std::net", "std::process", "std::env"];
    let globals = ["thread_local!", "OnceLock", "LazyLock", "LazyCell"];
    let why = "the core does no input or output, reads no clock, starts no thread and has no global";
    let mut violations = forbidden_in_core(source, &modules, why);
    if source.path() == CENSUS {
        return violations;
    }
    violations.extend(forbidden_in_core(source, &globals, why));
    if CORE.contains(&source.crate_name()) {
        // A lock in a value, as one around a cache, is no global; anything static is.
        let is_static = |line: &str| {
            let item = line.trim_start();
            let item = item.strip_prefix("pub ").or_else(|| item.strip_prefix("pub(crate) ")).unwrap_or(item);
            item.starts_with("static ")
        };
        let found = source.product_code().filter(|(_, line)| is_static(line));
        violations.extend(found.map(|(number, _)| Violation::at_line(source, number, format!("static: {why}"))));
    }
    violations
}

fn same_bits(source: &RustSource) -> Vec<Violation> {
    let inexact = [
        ".sin()",
        ".cos()",
        ".tan()",
        ".sin_cos()",
        ".asin()",
        ".acos()",
        ".atan()",
        ".atan2(",
        ".sinh()",
        ".cosh()",
        ".tanh()",
        ".exp()",
        ".exp2()",
        ".exp_m1()",
        ".ln()",
        ".ln_1p()",
        ".log10()",
        ".log2()",
        ".log(",
        ".powf(",
        ".powi(",
        ".cbrt()",
        ".hypot(",
    ];
    let rotations = [
        "from_axis_angle",
        "from_scaled_axis",
        "from_rotation_x",
        "from_rotation_y",
        "from_rotation_z",
        "from_euler",
        "slerp(",
        "angle_between(",
    ];
    let mut violations =
        forbidden_in_core(source, &inexact, "its bits depend on the platform; take it from libm, or multiply");
    violations.extend(forbidden_in_core(
        source,
        &rotations,
        "its bits depend on the platform; use polhode-spatial's Rotation",
    ));
    violations.extend(forbidden_in_core(
        source,
        &["mul_add("],
        "fused multiply-add rounds differently from two operations",
    ));
    violations.extend(forbidden_in_core(
        source,
        &["HashMap", "HashSet"],
        "its order changes from run to run; sort by key",
    ));
    violations
}

fn unwraps(source: &RustSource) -> Vec<Violation> {
    forbidden(source, &[".unwrap()", ".expect("], "a panic is a bug; return an error")
}

fn oracles(source: &RustSource) -> Vec<Violation> {
    if !source.path().starts_with(ORACLES) {
        return Vec::new();
    }
    let mut violations = Vec::new();
    for (number, line) in source.product_code() {
        let line = line.replace(DATA, "");
        for judged in JUDGED.iter().filter(|judged| contains_word(&line, judged)) {
            let what = format!("{judged}: an oracle has code and tolerances of its own; {DATA} may go in");
            violations.push(Violation::at_line(source, number, what));
        }
    }
    violations
}

fn bare_epsilons(source: &RustSource) -> Vec<Violation> {
    let mut violations = Vec::new();
    let mut in_const = false;
    // The defaults of settings are named by their fields, whose docs give unit, reason and range.
    let mut end_of_defaults = None;
    for (number, line) in source.product_code() {
        let code = line.trim_start();
        let code = code.strip_prefix("pub").map_or(code, |rest| rest.find("const ").map_or(rest, |at| &rest[at..]));
        in_const |= code.starts_with("const ") && !code.starts_with("const fn");
        if code.starts_with("impl Default for ") {
            end_of_defaults = Some(source.end_of_block(number));
        }
        if !in_const
            && end_of_defaults.is_none_or(|end| number > end)
            && let Some(literal) = negative_exponent(line)
        {
            let what = format!("{literal} has no name: make it a const with unit and reason, or a settings field");
            violations.push(Violation::at_line(source, number, what));
        }
        // Constants of several lines end with the semicolon that ends their last line.
        if in_const && line.trim_end().ends_with(';') {
            in_const = false;
        }
    }
    violations
}

/// The first float literal with a negative exponent in a line of code.
fn negative_exponent(line: &str) -> Option<&str> {
    line.match_indices("e-").find_map(|(at, _)| {
        let digits_before =
            line[..at].bytes().rev().take_while(|b| b.is_ascii_digit() || *b == b'.' || *b == b'_').count();
        let digits_after = line[at + 2..].bytes().take_while(u8::is_ascii_digit).count();
        let start = at - digits_before;
        let starts_number = line[start..].starts_with(|c: char| c.is_ascii_digit());
        let starts_word = line[..start].chars().next_back().is_none_or(|c| !c.is_alphanumeric() && c != '_');
        (digits_before > 0 && digits_after > 0 && starts_number && starts_word)
            .then(|| &line[start..at + 2 + digits_after])
    })
}

#[cfg(test)]
mod tests {
    //! Each rule finds what breaks it and leaves alone what only looks like it.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    fn lines_found(find: fn(&RustSource) -> Vec<Violation>, text: &str) -> Vec<String> {
        let source = RustSource::new("crates/polhode/src/a.rs", text);
        find(&source).into_iter().map(|violation| violation.place.rsplit(':').next().unwrap().to_owned()).collect()
    }

    #[test]
    fn epsilons_need_a_name() {
        let text = "const A: f64 = 1e-9;\nlet b = 1e-9;\n// 1e-9\nlet c = \"1e-9\";\nlet d = some-1;\n\
            pub(crate) const E: [f64; 2] = [\n    2.5e-3,\n    1.0e-3,\n];\nlet f = 3.5_0e-12;\n\
            const fn g() -> f64 { 1e-9 }\nlet h = 1e9;\n\
            impl Default for S {\n    fn default() -> Self {\n        Self { a: 1e-9 }\n    }\n}\nlet i = 1e-9;\n";
        assert_eq!(lines_found(bare_epsilons, text), ["2", "10", "11", "18"]);
    }

    #[test]
    fn every_line_has_at_most_120_columns() {
        let long = "x".repeat(LONGEST_LINE - 4);
        let text = format!("//! {long}\n//! | {long} |\n    {long}\n/// {long}y\nlet t = \"{long}\";\n");
        assert_eq!(lines_found(line_length, &text), ["2", "4", "5"]);
    }

    #[test]
    fn long_functions_need_a_reason() {
        let body = "    a();\n".repeat(LONGEST_FUNCTION);
        assert_eq!(lines_found(function_length, &format!("fn f() {{\n{body}}}\n")), ["1"]);
        assert_eq!(
            lines_found(function_length, &format!("// Long because: one table.\nfn f() {{\n{body}}}\n")),
            Vec::<String>::new()
        );
        let short = "    a();\n".repeat(LONGEST_FUNCTION - 2);
        assert_eq!(lines_found(function_length, &format!("fn f() {{\n{short}}}\n")), Vec::<String>::new());
    }

    #[test]
    fn oracles_take_data_alone() {
        let text = "use polhode::mesh::TriangleMesh;\nuse polhode::mesh::convex_decomposition;\n\
            use polhode_contact::{Side};\n\
                    use polhode_spatial::Pose;\n#[cfg(test)]\nmod tests {\n    use polhode::mesh::box_mesh;\n}\n";
        let found = |path: &str| oracles(&RustSource::new(path, text)).len();
        assert_eq!([found("xtask/polhode-oracles/src/exact/a.rs"), found("xtask/polhode-oracles/src/b.rs")], [2, 2]);
        assert_eq!(found("xtask/polhode-cases/src/cases/a.rs"), 0);
    }

    #[test]
    fn unwrap_is_for_tests() {
        let text = "fn f() { a.unwrap(); }\nfn g() { a.unwrap_or(1); }\n#[cfg(test)]\n\
            mod tests {\n    fn h() { a.unwrap(); b.expect(\"c\"); }\n}\n";
        assert_eq!(lines_found(unwraps, text), ["1"]);
    }

    #[test]
    fn the_core_is_silent_and_the_program_is_not() {
        assert_eq!(lines_found(printing, "fn f() { println!(\"x\"); }\n"), ["1"]);
        let program = RustSource::new("crates/polhode-cli/src/main.rs", "fn f() { println!(\"x\"); }\n");
        assert_eq!(printing(&program), vec![]);
    }

    #[test]
    fn platform_functions_are_found() {
        assert_eq!(
            lines_found(
                same_bits,
                "let a = x.sin();\nlet b = libm::sin(x);\nlet c = x.powi(2);\nlet d = my_slerp();\n"
            ),
            ["1", "3"]
        );
    }
}
