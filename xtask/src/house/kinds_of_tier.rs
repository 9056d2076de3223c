//! Whoever adds a tier adds a folder and its line in one list, and names it nowhere else.
//!
//! What a tier is stands in its own folder, as facts; all other files of the facade, the scene format, the viewer and
//! the program read the facts.

use super::rust_source::RustSource;
use super::violation::Violation;

/// The crates with the rule.
const CRATES: [&str; 5] = ["polhode", "polhode-scene", "polhode-study", "polhode-view", "polhode-cli"];

/// The file that lists the tiers, as variants of the enumeration `Tier`.
const LIST: &str = "crates/polhode/src/scene/tiers.rs";

/// Where a tier may be named: the list, that of their facts, the choice among them, their engines, and each tier's own
/// folder.
const HOMES: [&str; 10] = [
    LIST,
    "crates/polhode/src/tier/list.rs",
    "crates/polhode/src/tier/choice.rs",
    "crates/polhode/src/run/engines.rs",
    "crates/polhode/src/accurate/",
    "crates/polhode/src/stepped/",
    "crates/polhode/src/fast/",
    "crates/polhode/src/micro_collisions/",
    "crates/polhode/src/thesis/",
    "crates/polhode/src/penalty/",
];

/// How the enumeration is named: in the engine, and in the scene format.
const NAMES: [&str; 2] = ["Tier::", "TierName::"];

/// Lines of product code elsewhere that name a kind of tier.
pub(super) fn check(sources: &[RustSource]) -> Vec<Violation> {
    let mut violations = Vec::new();
    let is_elsewhere = |source: &&RustSource| {
        CRATES.contains(&source.crate_name()) && !HOMES.iter().any(|home| source.path().starts_with(home))
    };
    for source in sources.iter().filter(is_elsewhere) {
        for (number, line) in source.product_code() {
            if names_a_kind(line) {
                let what =
                    format!("a kind of tier is named outside of its folder: {}; read a fact instead", line.trim());
                violations.push(Violation::at_line(source, number, what));
            }
        }
    }
    if !sources.iter().any(|source| source.path() == LIST) {
        violations.push(Violation::in_file(LIST, "the list of the tiers is not there"));
    }
    violations
}

/// Whether a line names a variant: a word in camel case after the name of the enumeration (`ALL`, `name` are none).
fn names_a_kind(line: &str) -> bool {
    NAMES.iter().flat_map(|name| line.split(name).skip(1)).any(|after| {
        let mut letters = after.chars();
        letters.next().is_some_and(char::is_uppercase) && letters.next().is_some_and(char::is_lowercase)
    })
}

#[cfg(test)]
mod tests {
    //! A tier that is named in another file is found; in its homes, and in tests, it may be. Its facts may be read
    //! anywhere.
    use super::*;

    #[test]
    fn a_tier_named_elsewhere_is_a_violation() {
        let source = |path: &str, text: &str| RustSource::new(path, text);
        let list = || source(LIST, "pub enum Tier { Thesis }\n");
        let home = source("crates/polhode/src/thesis/engine.rs", "content::Tier::Thesis(saved)\n");
        let reader =
            source("crates/polhode/src/plan/decisions.rs", "let tier = Tier::ALL[0].facts(); Tier::default();\n");
        assert_eq!(check(&[list(), home, reader]).len(), 0);
        for line in ["if tier == Tier::Thesis {}\n", "match name { TierName::Thesis => 3 }\n"] {
            assert_eq!(check(&[list(), source("crates/polhode-scene/src/names.rs", line)]).len(), 1, "{line}");
        }
        assert_eq!(check(&[]).len(), 1);
    }
}
