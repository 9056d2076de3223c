//! `cargo xtask house --counts`: how much of the house there is, counted from its sources.
//!
//! The counts of the last review of the house beside those of today and what is aimed at. A count says how far the
//! design is kept: how many places choose a solver, how large the largest type is, how many tolerances and caps there
//! are. All are of code outside tests, unless a count says otherwise. None may grow beyond its number in [`LIMITS`], so
//! that growth needs a reason, which stands there.
//!
//! | module | holds |
//! |---|---|
//! | `solvers` | places that name, call and choose solvers, and form dense matrices |
//! | `types` | types of results, and the type `World` |
//! | `rooms` | loose files, and arrows between rooms that run back up |
//! | `numbers` | lines, tolerances, caps, known failures |

mod numbers;
mod rooms;
mod solvers;
mod types;

use super::project_file::ProjectFile;
use super::rust_source::RustSource;
use super::violation::Violation;
use crate::house::count::{Count, LIMITS};
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// All counts.
pub(super) fn counts(sources: &[RustSource]) -> Vec<Count> {
    let mut counts = solvers::counts(sources);
    counts.extend(types::counts(sources));
    counts.extend(rooms::counts(sources));
    counts.extend(numbers::counts(sources));
    counts
}

/// What the counts cannot be trusted without: every threshold of the list stands where the list says.
pub(super) fn lists_hold(sources: &[RustSource]) -> Result<(), String> {
    let gone = solvers::thresholds_gone(sources);
    if gone.is_empty() { Ok(()) } else { Err(gone.join("\n")) }
}

/// Every count that has grown beyond its limit, or has none.
pub(super) fn check(files: &[ProjectFile], sources: &[RustSource], counts: &[Count]) -> Vec<Violation> {
    let Some(file) = files.iter().find(|file| file.path == LIMITS) else {
        return vec![Violation::in_file(LIMITS, "is missing")];
    };
    let limits: BTreeMap<String, u64> = match toml::from_str(&file.text) {
        Ok(limits) => limits,
        Err(error) => return vec![Violation::in_file(LIMITS, error.to_string())],
    };
    let mut violations = grown(counts, &limits);
    let gone = solvers::thresholds_gone(sources);
    violations.extend(gone.into_iter().map(|gone| Violation::in_file("xtask/src/house/counts/solvers.rs", gone)));
    violations
}

fn grown(counts: &[Count], limits: &BTreeMap<String, u64>) -> Vec<Violation> {
    let mut violations = Vec::new();
    for count in counts {
        let what = match limits.get(count.key) {
            None => format!("says nothing of {}: {}", count.key, count.check),
            Some(limit) if count.now > *limit => {
                format!(
                    "{} have grown from {limit} to {}: {}; a number grows with its reason only",
                    count.key, count.now, count.check
                )
            }
            Some(_) => continue,
        };
        violations.push(Violation::in_file(LIMITS, what));
    }
    let unknown = limits.keys().filter(|key| !counts.iter().any(|count| count.key == *key));
    violations.extend(unknown.map(|key| Violation::in_file(LIMITS, format!("{key} is no count"))));
    violations
}

/// The counts as a table for people.
pub(super) fn table(counts: &[Count]) -> String {
    let number = |number: Option<u64>| number.map_or_else(|| "-".to_owned(), |number| number.to_string());
    let goal = |goal: Option<u64>| {
        goal.map_or_else(|| "-".to_owned(), |goal| if goal == 0 { "0".to_owned() } else { format!("<= {goal}") })
    };
    let widest = counts.iter().map(|count| count.check.chars().count()).max().unwrap_or_default();
    let mut text = format!("{:<widest$}  {:>10}  {:>7}  {:>8}\n", "check", "at review", "now", "goal");
    for count in counts {
        let cells = (count.check, number(count.review), count.now, goal(count.goal));
        let _ = writeln!(text, "{:<widest$}  {:>10}  {:>7}  {:>8}", cells.0, cells.1, cells.2, cells.3);
    }
    let met = counts.iter().filter(|count| count.goal.is_some_and(|goal| count.now <= goal)).count();
    let aimed = counts.iter().filter(|count| count.goal.is_some()).count();
    let _ = writeln!(text, "{met} of {aimed} goals are met");
    text
}

#[cfg(test)]
mod tests {
    //! A count that grows breaks the rule, as one without a limit and a limit without a count do.
    use super::*;

    #[test]
    fn a_count_may_not_grow() {
        let count = |key, now| Count { key, check: "lines", review: None, now, goal: Some(1) };
        let limits = BTreeMap::from([("a".to_owned(), 2), ("b".to_owned(), 2), ("gone".to_owned(), 2)]);
        let found = grown(&[count("a", 2), count("b", 3), count("c", 0)], &limits);
        let what: Vec<&str> =
            found.iter().map(|violation| violation.what.split(' ').next().unwrap_or_default()).collect();
        assert_eq!(what, ["b", "says", "gone"]);
    }

    #[test]
    fn the_table_says_how_many_goals_are_met() {
        let count = |now, goal| Count { key: "k", check: "lines", review: Some(7), now, goal };
        let text = table(&[count(1, Some(1)), count(2, Some(0)), count(3, None)]);
        assert!(text.ends_with("1 of 2 goals are met\n"), "{text}");
    }
}
