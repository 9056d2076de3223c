//! Repeated messages of a run: each text once, with the times of its first and last occurrence and their number.

use crate::report::run_report::Occurrence;
use crate::snapshot::content;
use std::collections::BTreeMap;

/// Occurrences in the order of the first of each.
#[derive(Debug, Clone, Default)]
pub(crate) struct Occurrences {
    list: Vec<Occurrence>,
    /// Index of each text in the list.
    places: BTreeMap<String, usize>,
}

impl Occurrences {
    /// Adds an occurrence at `t` (s).
    pub(crate) fn add(&mut self, t: f64, what: String) {
        if let Some(known) = self.places.get(&what).and_then(|&place| self.list.get_mut(place)) {
            known.last_s = t;
            known.count += 1;
            return;
        }
        self.places.insert(what.clone(), self.list.len());
        self.list.push(Occurrence { what, count: 1, first_s: t, last_s: t });
    }

    /// The occurrences as plain data.
    pub(super) fn save(&self) -> Vec<content::Warning> {
        let save = |Occurrence { what, count, first_s, last_s }: &Occurrence| content::Warning {
            what: what.clone(),
            first_s: *first_s,
            last_s: *last_s,
            count: *count,
        };
        self.list.iter().map(save).collect()
    }

    /// The occurrences of such data.
    pub(super) fn restored(saved: &[content::Warning]) -> Self {
        let restored = |content::Warning { what, first_s, last_s, count }: &content::Warning| Occurrence {
            what: what.clone(),
            count: *count,
            first_s: *first_s,
            last_s: *last_s,
        };
        let list: Vec<Occurrence> = saved.iter().map(restored).collect();
        let places = list.iter().enumerate().map(|(place, known)| (known.what.clone(), place)).collect();
        Self { list, places }
    }

    /// Total number of occurrences.
    pub(crate) fn total(&self) -> u64 {
        self.list.iter().map(|known| known.count).sum()
    }

    /// The occurrences, in the order of the first of each.
    pub(crate) fn list(&self) -> &[Occurrence] {
        &self.list
    }

    /// The same as printed texts.
    pub(crate) fn texts(&self) -> Vec<String> {
        self.list.iter().map(ToString::to_string).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Occurrences;

    #[test]
    fn repeated_messages_are_counted_with_first_and_last_time() {
        let mut warnings = Occurrences::default();
        warnings.add(0.5, "a".to_owned());
        warnings.add(0.75, "b".to_owned());
        warnings.add(1.5, "a".to_owned());
        assert_eq!(warnings.texts(), ["t = 0.5 s to 1.5 s, 2 times: a", "t = 0.75 s: b"]);
        assert_eq!(warnings.total(), 3);
    }
}
