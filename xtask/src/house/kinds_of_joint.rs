//! Whoever adds a kind of joint adds files that make it, and names it nowhere else.
//!
//! In the facade the kinds of joint stand in the folder of constraints and in the files of the scene about joints. All
//! other files take what holds bodies together as rows and reactions, so that a further kind changes none of them.

use super::rust_source::RustSource;
use super::violation::Violation;

/// The crate with the rule.
const CRATE: &str = "polhode";

/// The file that lists the kinds, as variants of [`LIST`].
const KINDS: &str = "crates/polhode/src/scene/joint.rs";

/// The enumeration of the kinds.
const LIST: &str = "JointKind";

/// Where kinds may be named.
const HOMES: [&str; 2] = ["crates/polhode/src/constraint/", "crates/polhode/src/scene/joint"];

/// Lines of product code elsewhere that name a kind of joint.
pub(super) fn check(sources: &[RustSource]) -> Vec<Violation> {
    let mut violations = Vec::new();
    let is_elsewhere = |source: &&RustSource| {
        source.crate_name() == CRATE && !HOMES.iter().any(|home| source.path().starts_with(home))
    };
    let uses = format!("{LIST}::");
    for source in sources.iter().filter(is_elsewhere) {
        for (number, line) in source.product_code() {
            if line.contains(&uses) {
                let what = format!("a kind of joint is named outside of {}: {}", HOMES[0], line.trim());
                violations.push(Violation::at_line(source, number, what));
            }
        }
    }
    if !sources.iter().any(|source| source.path() == KINDS) {
        violations.push(Violation::in_file(KINDS, "the list of the kinds of joint is not there"));
    }
    violations
}

#[cfg(test)]
mod tests {
    //! A kind that is named in another file is found; in its homes, and in tests, it may be.
    use super::*;

    #[test]
    fn a_kind_named_elsewhere_is_a_violation() {
        let source = |path: &str, text: &str| RustSource::new(path, text);
        let list = source(KINDS, "pub enum JointKind { Ball }\n");
        let home = source("crates/polhode/src/constraint/joint.rs", "match kind { JointKind::Ball => 3 }\n");
        let elsewhere = source("crates/polhode/src/plan/decisions.rs", "if kind == JointKind::Ball {}\n");
        assert_eq!(check(&[list, home]).len(), 0);
        assert_eq!(check(&[source(KINDS, ""), elsewhere]).len(), 1);
        assert_eq!(check(&[]).len(), 1);
    }
}
