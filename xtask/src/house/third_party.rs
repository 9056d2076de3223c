//! parry3d and clarabel: each named in one private module, and in no public signature of it.

use super::rust_source::RustSource;
use super::violation::Violation;

/// A library that one private module hides.
#[derive(Debug)]
struct Hidden {
    library: &'static str,
    home: &'static str,
    module: &'static str,
}

const HIDDEN: [Hidden; 2] = [
    Hidden { library: "parry3d", home: "polhode-contact", module: "backend" },
    Hidden { library: "clarabel", home: "polhode-response", module: "interior_point" },
];

/// Every place that names one of the libraries and should not.
pub(super) fn check(sources: &[RustSource]) -> Vec<Violation> {
    HIDDEN.iter().flat_map(|hidden| check_library(hidden, sources)).collect()
}

fn check_library(hidden: &Hidden, sources: &[RustSource]) -> Vec<Violation> {
    let Hidden { library, home, module } = hidden;
    let mut violations = Vec::new();
    let users: Vec<&RustSource> =
        sources.iter().filter(|s| !is_task(s) && s.product_code().any(|(_, line)| names(line, library))).collect();
    let file_ends = [format!("/{module}.rs"), format!("/{module}/mod.rs")];
    for user in &users {
        if user.crate_name() != *home || !file_ends.iter().any(|end| user.path().ends_with(end)) {
            violations.push(Violation::in_file(
                user.path(),
                format!("names {library}: only the module {module} of {home} may"),
            ));
        }
        violations.extend(public_signatures(user, library));
    }
    if users.len() != 1 {
        violations.push(Violation::in_file(*home, format!("{} files name {library}, and one must", users.len())));
    }
    let public = format!("pub mod {module}");
    for source in sources.iter().filter(|source| source.crate_name() == *home) {
        for (number, line) in source.product_code().filter(|(_, line)| line.trim_start().starts_with(&public)) {
            let _ = line;
            violations.push(Violation::at_line(
                source,
                number,
                format!("the module that names {library} must be private"),
            ));
        }
    }
    violations
}

/// Whether the file belongs to the development tasks, which are no part of the product and may hold a library against
/// the crate that hides it.
fn is_task(source: &RustSource) -> bool {
    source.path().starts_with("xtask/")
}

/// Public items of the file whose signature names the library or something imported from it.
fn public_signatures(source: &RustSource, library: &str) -> Vec<Violation> {
    let mut foreign = imported_names(source, library);
    foreign.push(library.to_owned());
    let mut violations = Vec::new();
    for (number, line) in source.product_code() {
        if !line.trim_start().starts_with("pub ") || line.trim_start().starts_with("pub(") {
            continue;
        }
        let signature: String = source.code()[number..]
            .iter()
            .scan(false, |ended, line| {
                let more = !*ended;
                *ended |= line.contains(['{', ';']);
                more.then_some(line.as_str())
            })
            .collect::<Vec<_>>()
            .join(" ");
        let signature = signature.split(['{', ';']).next().unwrap_or_default();
        for name in foreign.iter().filter(|name| names(signature, name)) {
            violations.push(Violation::at_line(source, number, format!("{name} of {library} in a public signature")));
        }
    }
    violations
}

/// Names that `use library::...;` brings into the file.
fn imported_names(source: &RustSource, library: &str) -> Vec<String> {
    let code = source.code().join(" ");
    let mut names = Vec::new();
    for (at, _) in code.match_indices(&format!("use {library}::")) {
        let import = code[at..].split(';').next().unwrap_or_default();
        names.extend(
            import
                .split(|c: char| !c.is_alphanumeric() && c != '_')
                .filter(|word| word.starts_with(|c: char| c.is_ascii_uppercase()))
                .map(str::to_owned),
        );
    }
    names
}

/// Whether `name` stands in `code` as a whole word.
fn names(code: &str, name: &str) -> bool {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    code.match_indices(name).any(|(at, _)| {
        code[..at].chars().next_back().is_none_or(|c| !is_word(c))
            && code[at + name.len()..].chars().next().is_none_or(|c| !is_word(c))
    })
}

#[cfg(test)]
mod tests {
    //! One private module may name the library, in private items only.
    use super::*;

    const HOME: &str = "crates/polhode-contact/src/backend.rs";

    fn violations(files: &[(&str, &str)]) -> usize {
        let sources: Vec<RustSource> = files.iter().map(|(path, text)| RustSource::new(path, text)).collect();
        check_library(&HIDDEN[0], &sources).len()
    }

    #[test]
    fn one_private_module_is_right() {
        let backend = "//! Docs on parry3d.\nuse parry3d::bounding_volume::Aabb;\npub(crate) fn f(a: Aabb) {}\n\
            pub fn g(a: f64) {}\n";
        assert_eq!(
            violations(&[(HOME, backend), ("crates/polhode-contact/src/lib.rs", "//! About parry3d.\nmod backend;\n")]),
            0
        );
    }

    #[test]
    fn a_public_signature_a_second_file_and_a_public_module_are_wrong() {
        let backend = "use parry3d::bounding_volume::Aabb;\npub fn f(a: &Aabb) -> f64 {\n";
        assert_eq!(violations(&[(HOME, backend)]), 1);
        let other = ("crates/polhode-contact/src/other.rs", "use parry3d::math::Real;\n");
        assert_eq!(violations(&[(HOME, "use parry3d::math::Real;\n"), other]), 2);
        assert_eq!(
            violations(&[
                (HOME, "use parry3d::math::Real;\n"),
                ("crates/polhode-contact/src/lib.rs", "pub mod backend;\n")
            ]),
            1
        );
    }
}
