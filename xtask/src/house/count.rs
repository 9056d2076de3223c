//! One count, and what all are made with: folders, and words of a line.

use crate::house::rust_source::RustSource;
use crate::house::violation::Violation;
use serde::Serialize;

/// Where the largest number that each count may be stands, with the reasons of those that have grown.
pub(super) const LIMITS: &str = "xtask/src/house/counts/limits.toml";
/// Where the sources of the facade stand.
pub(super) const FACADE: &str = "crates/polhode/src";
/// Where those of the solvers stand.
pub(super) const RESPONSE: &str = "crates/polhode-response/src";

/// One count.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Count {
    /// Its name in the table of limits.
    pub(super) key: &'static str,
    /// What is counted.
    pub(super) check: &'static str,
    /// How many the review of commit ae0e5111 found; absent where it did not count.
    pub(super) review: Option<u64>,
    pub(super) now: u64,
    /// The most that is aimed at; absent where none is set.
    pub(super) goal: Option<u64>,
}

impl Count {
    /// What a row of its goal is called.
    pub(super) fn goal_in_words(&self) -> String {
        format!("goal: {}", self.key)
    }

    /// That it is beyond its goal; none without a goal.
    pub(super) fn beyond_goal(&self) -> Option<Vec<Violation>> {
        let goal = self.goal?;
        let what = || format!("{} are {}, where at most {goal} are aimed at: {}", self.key, self.now, self.check);
        Some(if self.now > goal { vec![Violation::in_file(LIMITS, what())] } else { Vec::new() })
    }
}

/// Whether the file stands in this folder, at any depth.
pub(super) fn is_in(source: &RustSource, folder: &str) -> bool {
    source.path().strip_prefix(folder).is_some_and(|rest| rest.starts_with('/'))
}

/// How often `word` stands in `line` as a word of its own.
pub(super) fn words(line: &str, word: &str) -> usize {
    starts_of(line, word).count()
}

/// Where `word` stands in `line` as a word of its own.
pub(super) fn starts_of<'a>(line: &'a str, word: &'a str) -> impl Iterator<Item = usize> + 'a {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    line.match_indices(word).map(|(at, _)| at).filter(move |&at| {
        line[..at].chars().next_back().is_none_or(|before| !is_name(before))
            && line[at + word.len()..].chars().next().is_none_or(|after| !is_name(after))
    })
}
