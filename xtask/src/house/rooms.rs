//! Rooms of the facade that may import a few others alone.
//!
//! The scene is the user's description: it stands below all that runs it, and knows what no tier is. A tier is held
//! against it in `tier/`. So `scene` imports no folder of a tier, nor `tier`, and asks no tier for its facts: the
//! methods that give them stand in `tier/list.rs`, and need no import.

use super::count::FACADE;
use super::imports::Imports;
use super::rust_source::RustSource;
use super::violation::Violation;

/// A room, and what its files may import.
struct Room {
    name: &'static str,
    /// Other rooms that it may import.
    may_import: &'static [&'static str],
    /// Methods that it must not call.
    must_not_call: &'static [&'static str],
}

/// The rooms with the rule.
const ROOMS: [Room; 1] = [Room {
    name: "scene",
    may_import: &["identity", "report"],
    must_not_call: &["facts", "names_with", "of_response", "named_tier"],
}];

/// Every import, and every call, that a room must not have.
pub(super) fn check(sources: &[RustSource]) -> Vec<Violation> {
    let imports = Imports::of(sources, FACADE);
    let mut violations = Vec::new();
    for room in &ROOMS {
        let arrows = imports.arrows().into_iter().filter(|(from, _)| room_of(from) == Some(room.name));
        for (from, to) in arrows {
            for to in to.into_iter().filter(|to| !room_of(to).is_some_and(|other| room.may_import(other))) {
                violations.push(Violation::in_file(from, format!("{} must not import {to}", room.name)));
            }
        }
        for source in sources.iter().filter(|source| room_of(source.path()) == Some(room.name)) {
            violations.extend(source.product_code().filter_map(|(number, line)| {
                let found = room.forbidden_in(line)?;
                Some(Violation::at_line(source, number, format!("{} must not name {found}", room.name)))
            }));
        }
    }
    violations
}

impl Room {
    fn may_import(&self, other: &str) -> bool {
        other == self.name || self.may_import.contains(&other)
    }

    /// The room that a path in a line leads to, of a re-export too, or the method called in it, if the room must have
    /// neither.
    fn forbidden_in<'a>(&self, line: &'a str) -> Option<&'a str> {
        let is_name = |c: char| c.is_ascii_lowercase() || c == '_';
        let word = |rest: &'a str| rest.split(|c: char| !is_name(c)).next().unwrap_or_default();
        let room = line.split("crate::").skip(1).map(word).find(|room| !room.is_empty() && !self.may_import(room));
        let called = line.split(['.', ':']).skip(1).map(word).find(|name| self.must_not_call.contains(name));
        room.or(called)
    }
}

/// The room of a file: the folder of the facade that it stands in.
fn room_of(path: &str) -> Option<&str> {
    path.strip_prefix(FACADE)?.strip_prefix('/')?.split_once('/').map(|(room, _)| room)
}

#[cfg(test)]
mod tests {
    //! An import of another room is found, through the root and as a re-export too, and so is a call; what is allowed,
    //! and what tests do, is not.
    use super::*;

    fn found_in(line: &str) -> usize {
        let source = |path: &str, text: &str| RustSource::new(&format!("{FACADE}/{path}"), text);
        let root = source("lib.rs", "mod identity;\nmod scene;\nmod tier;\npub use tier::facts::TierFacts;\n");
        let facts = source("tier/facts.rs", "use crate::scene::Promise;\npub struct TierFacts;\n");
        let [identity, scene, tier] = ["identity", "scene", "tier"].map(|room| source(&format!("{room}/mod.rs"), ""));
        check(&[root, facts, identity, scene, tier, source("scene/method.rs", line)]).len()
    }

    #[test]
    fn what_the_scene_must_not_know_is_found() {
        assert!(found_in("use crate::tier::facts::TierFacts;\nfn f(_: TierFacts) {}\n") > 0);
        assert!(found_in("pub use crate::tier::facts::TierFacts;\n") > 0);
        assert!(found_in("use crate::TierFacts;\nfn f(_: TierFacts) {}\n") > 0);
        assert!(found_in("fn f(tier: Tier) -> bool { tier.facts().controls_error() }\n") > 0);
        assert_eq!(found_in("use crate::identity::body_id::BodyId;\nuse crate::scene::Tier;\nfn f(_: BodyId) {}\n"), 0);
    }
}
