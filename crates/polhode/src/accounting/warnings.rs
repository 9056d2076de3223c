//! Warnings of a run: each text once, with the times of its first and last occasion and how often it came.

use crate::snapshot::content;

/// Warnings in the order in which each was first given.
#[derive(Debug, Clone, Default)]
pub(crate) struct Warnings {
    list: Vec<Warning>,
}

/// A warning that was given one or more times.
#[derive(Debug, Clone, PartialEq)]
struct Warning {
    what: String,
    first_s: f64,
    last_s: f64,
    count: u64,
}

impl Warnings {
    /// Gives a warning at `t` (s).
    pub(crate) fn add(&mut self, t: f64, what: String) {
        match self.list.iter_mut().find(|warning| warning.what == what) {
            Some(warning) => {
                warning.last_s = t;
                warning.count += 1;
            }
            None => self.list.push(Warning { what, first_s: t, last_s: t, count: 1 }),
        }
    }

    /// The warnings as plain data.
    pub(super) fn save(&self) -> Vec<content::Warning> {
        let save = |Warning { what, first_s, last_s, count }: &Warning| content::Warning {
            what: what.clone(),
            first_s: *first_s,
            last_s: *last_s,
            count: *count,
        };
        self.list.iter().map(save).collect()
    }

    /// The warnings of such data.
    pub(super) fn restored(saved: &[content::Warning]) -> Self {
        let restored = |content::Warning { what, first_s, last_s, count }: &content::Warning| Warning {
            what: what.clone(),
            first_s: *first_s,
            last_s: *last_s,
            count: *count,
        };
        Self { list: saved.iter().map(restored).collect() }
    }

    /// The warnings as they are reported.
    pub(crate) fn texts(&self) -> Vec<String> {
        self.list.iter().map(Warning::text).collect()
    }
}

impl Warning {
    fn text(&self) -> String {
        let Self { what, first_s, last_s, count } = self;
        if *count == 1 {
            format!("t = {first_s} s: {what}")
        } else {
            format!("t = {first_s} s to {last_s} s, {count} times: {what}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Warnings;

    #[test]
    fn a_warning_that_is_given_again_is_counted_and_keeps_its_first_and_last_time() {
        let mut warnings = Warnings::default();
        warnings.add(0.5, "a".to_owned());
        warnings.add(0.75, "b".to_owned());
        warnings.add(1.5, "a".to_owned());
        assert_eq!(warnings.texts(), ["t = 0.5 s to 1.5 s, 2 times: a", "t = 0.75 s: b"]);
    }
}
