//! Compares two snapshots number by number within the tolerance that the old one states.

use super::trajectory::HASH_LINE;
use insta::{Comparator, Snapshot};
use std::sync::{Arc, Mutex};

/// Tolerance and reason of a new snapshot; those of an old one are kept.
pub(super) const DEFAULT_DESCRIPTION: &str = "tolerance 1e-9 of max(1, |number|): a change of the order of operations \
moves the last digits, and impacts and falls amplify that; anything larger is a change of the method";

/// How two snapshots compare.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Comparison {
    /// The largest difference of two numbers, relative to max(1, |number|).
    pub(super) error: f64,
    /// Where that is; empty when nothing differs.
    pub(super) place: String,
    /// The tolerance that the old snapshot states; zero when it states none.
    pub(super) tolerance: f64,
    /// Something other than a number differs.
    pub(super) mismatch: Option<String>,
    /// The strict hash of the old snapshot.
    pub(super) hash: Option<String>,
}

impl Comparison {
    fn passes(&self) -> bool {
        self.mismatch.is_none() && self.error <= self.tolerance
    }
}

/// insta's comparator by tolerance; what it found is left in [`ToleranceComparator::result`].
#[derive(Debug, Clone, Default)]
pub(super) struct ToleranceComparator {
    result: Arc<Mutex<Option<Comparison>>>,
}

impl ToleranceComparator {
    /// Where the result of the next comparison will be.
    pub(super) fn result(&self) -> Arc<Mutex<Option<Comparison>>> {
        Arc::clone(&self.result)
    }
}

impl Comparator for ToleranceComparator {
    fn matches(&self, reference: &Snapshot, test: &Snapshot) -> bool {
        let text = |snapshot: &Snapshot| snapshot.as_text().map(ToString::to_string).unwrap_or_default();
        let tolerance = reference.metadata().description().and_then(stated_tolerance).unwrap_or_default();
        let comparison = compare(&text(reference), &text(test), tolerance);
        let passes = comparison.passes();
        if let Ok(mut result) = self.result.lock() {
            *result = Some(comparison);
        }
        passes
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

/// The number after the word `tolerance` at the beginning of a description.
fn stated_tolerance(description: &str) -> Option<f64> {
    let tolerance: f64 = description.strip_prefix("tolerance ")?.split_whitespace().next()?.parse().ok()?;
    (tolerance >= 0.0).then_some(tolerance)
}

/// Compares two texts line by line and word by word.
fn compare(old: &str, new: &str, tolerance: f64) -> Comparison {
    let mut found = Comparison { tolerance, ..Comparison::default() };
    let (mut old_lines, mut new_lines) = (old.trim().lines(), new.trim().lines());
    let mut number = 0;
    loop {
        number += 1;
        match (old_lines.next(), new_lines.next()) {
            (None, None) => return found,
            (Some(old), Some(_)) if old.starts_with(HASH_LINE) => {
                found.hash = old.split_whitespace().nth(1).map(str::to_owned);
            }
            (Some(old), Some(new)) => compare_line(&mut found, number, old, new),
            (Some(_), None) | (None, Some(_)) => {
                found.mismatch.get_or_insert_with(|| format!("line {number} is in one of the two only"));
                return found;
            }
        }
    }
}

fn compare_line(found: &mut Comparison, number: usize, old: &str, new: &str) {
    let (old_words, new_words): (Vec<&str>, Vec<&str>) = (old.split(' ').collect(), new.split(' ').collect());
    if old_words.len() != new_words.len() {
        found.mismatch.get_or_insert_with(|| format!("line {number}: {old} is now {new}"));
        return;
    }
    for (a, b) in old_words.into_iter().zip(new_words).filter(|(a, b)| a != b) {
        let (Ok(x), Ok(y)) = (a.parse::<f64>(), b.parse::<f64>()) else {
            found.mismatch.get_or_insert_with(|| format!("line {number}: {a} is now {b}"));
            continue;
        };
        let error = (x - y).abs() / x.abs().max(1.0);
        if error.is_nan() {
            found.mismatch.get_or_insert_with(|| format!("line {number}: {a} is now {b}"));
        } else if error > found.error {
            found.error = error;
            found.place = format!("line {number}");
        }
    }
}

#[cfg(test)]
mod tests {
    //! Numbers may differ by the stated tolerance, nothing else may differ at all.
    use super::*;

    #[test]
    fn numbers_differ_by_the_tolerance() {
        let old = "energy 1000 0.5\nstrict-hash 01\nt 2";
        let near = compare(old, "energy 1000.0000001 0.5\nstrict-hash 02\nt 2", 1e-9);
        assert!(near.passes());
        assert_eq!(near.hash.as_deref(), Some("01"));
        let far = compare(old, "energy 1000 0.50000001\nstrict-hash 01\nt 2", 1e-9);
        assert!(!far.passes());
        assert!((far.error - 1e-8).abs() < 1e-12 && far.place.contains("line 1"));
    }

    #[test]
    fn words_lines_and_nan_must_be_equal() {
        for new in ["b 1", "a 1 1", "a 1\nb", "a NaN"] {
            assert!(compare("a 1", new, 0.5).mismatch.is_some(), "{new}");
        }
    }

    #[test]
    fn the_tolerance_stands_in_the_description() {
        assert_eq!(stated_tolerance("tolerance 1e-9 of max(1, |number|): because"), Some(1e-9));
        assert_eq!(stated_tolerance("within 1e-9"), None);
        assert_eq!(stated_tolerance(DEFAULT_DESCRIPTION), Some(1e-9));
    }
}
