//! From paths to byte ranges and back.

use super::key_path::{self, KeyPath, Step};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

/// Ranges of an entry.
pub(super) struct Spans {
    /// Of its key; of the element itself in an array.
    pub(super) key: Range<usize>,
    /// Of its value.
    pub(super) value: Range<usize>,
}

/// Ranges of the entry at `path`, or of the nearest one above it that is there.
pub(super) fn spans(root: &Spanned<DeTable<'_>>, path: &KeyPath) -> Spans {
    let mut spans = Spans { key: root.span(), value: root.span() };
    let mut container = Container::Table(root.get_ref());
    for step in path.steps() {
        let Some((key, value)) = container.entry(step) else { break };
        spans = Spans { key, value: value.span() };
        container = Container::of(value.get_ref());
    }
    spans
}

/// Whether the value at `path` is a table.
pub(super) fn is_table(root: &Spanned<DeTable<'_>>, path: &KeyPath) -> bool {
    let mut container = Container::Table(root.get_ref());
    for step in path.steps() {
        let Some((_, value)) = container.entry(step) else { return false };
        container = Container::of(value.get_ref());
    }
    matches!(container, Container::Table(_))
}

/// Takes the entry at `path` out; false when it is not there.
pub(super) fn take(root: &mut DeTable<'_>, path: &KeyPath) -> bool {
    let Some((last, above)) = path.steps().split_last() else { return false };
    let Some((Step::Key(first), above)) = above.split_first() else {
        return matches!(last, Step::Key(key) if root.remove(&**key).is_some());
    };
    let mut value = root.get_mut(&**first).map(Spanned::get_mut);
    for step in above {
        value = match (value, step) {
            (Some(DeValue::Table(table)), Step::Key(key)) => table.get_mut(&**key).map(Spanned::get_mut),
            (Some(DeValue::Array(array)), Step::Index(index)) => array.get_mut(*index).map(Spanned::get_mut),
            _ => None,
        };
    }
    match (value, last) {
        (Some(DeValue::Table(table)), Step::Key(key)) => table.remove(&**key).is_some(),
        (Some(DeValue::Array(array)), Step::Index(index)) if *index < array.len() => {
            let all = std::mem::replace(array, DeArray::new()).into_iter().enumerate();
            *array = all.filter(|(number, _)| number != index).map(|(_, value)| value).collect();
            true
        }
        _ => false,
    }
}

/// The path of the innermost key or value whose range holds `span`; the root when there is none.
pub(super) fn path_at(root: &Spanned<DeTable<'_>>, span: &Range<usize>) -> KeyPath {
    let mut search = Search { span: span.clone(), at: KeyPath::root(), length: usize::MAX, found: KeyPath::root() };
    search.table(root.get_ref());
    search.found
}

/// A path as it can be typed after `--set`: bodies and arrays by name where they have one, by number otherwise.
pub(super) fn written(root: &DeTable<'_>, path: &KeyPath) -> String {
    let steps = path.steps();
    let mut text = String::new();
    for (depth, step) in steps.iter().enumerate() {
        if depth > 0 {
            text.push('.');
        }
        match step {
            Step::Key(key) => text.push_str(&key_path::written(key)),
            Step::Index(index) => {
                let named = ["bodies", "arrays"].into_iter().find(|key| depth == 1 && steps[0] == Step::key(*key));
                let name = named.and_then(|key| name_of(root, key, *index));
                text.push_str(&name.map_or_else(|| index.to_string(), key_path::written));
            }
        }
    }
    text
}

fn name_of<'t>(root: &'t DeTable<'_>, key: &str, index: usize) -> Option<&'t str> {
    root.get(key)?.get_ref().get(index)?.get_ref().get("name")?.get_ref().as_str().filter(|name| !name.is_empty())
}

/// A value that holds others.
enum Container<'t, 'i> {
    Table(&'t DeTable<'i>),
    Array(&'t [Spanned<DeValue<'i>>]),
    Leaf,
}

impl<'t, 'i> Container<'t, 'i> {
    fn of(value: &'t DeValue<'i>) -> Self {
        match value {
            DeValue::Table(table) => Self::Table(table),
            DeValue::Array(array) => Self::Array(array),
            _ => Self::Leaf,
        }
    }

    fn entry(&self, step: &Step) -> Option<(Range<usize>, &'t Spanned<DeValue<'i>>)> {
        match (self, step) {
            (Self::Table(table), Step::Key(key)) => {
                table.get_key_value(&**key).map(|(found, value)| (found.span(), value))
            }
            (Self::Array(array), Step::Index(index)) => array.get(*index).map(|value| (value.span(), value)),
            _ => None,
        }
    }
}

/// Looks for the shortest range that holds `span`.
struct Search {
    span: Range<usize>,
    /// Where the search is.
    at: KeyPath,
    length: usize,
    found: KeyPath,
}

impl Search {
    fn table(&mut self, table: &DeTable<'_>) {
        for (key, value) in table {
            self.at.push(Step::key(key.get_ref().to_string()));
            self.consider(&key.span());
            self.value(value);
            self.at.pop();
        }
    }

    fn value(&mut self, value: &Spanned<DeValue<'_>>) {
        self.consider(&value.span());
        match value.get_ref() {
            DeValue::Table(table) => self.table(table),
            DeValue::Array(array) => {
                for (index, element) in array.iter().enumerate() {
                    self.at.push(Step::Index(index));
                    self.consider_element(&element.span());
                    self.value(element);
                    self.at.pop();
                }
            }
            _ => {}
        }
    }

    fn holds(&self, range: &Range<usize>) -> bool {
        range.start <= self.span.start && self.span.end <= range.end && !self.span.is_empty()
    }

    /// The header `[[bodies]]` of a lone element is the range of the array too; the element is meant.
    fn consider_element(&mut self, range: &Range<usize>) {
        if self.holds(range) && range.len() <= self.length {
            self.length = range.len();
            self.found = self.at.clone();
        }
    }

    fn consider(&mut self, range: &Range<usize>) {
        // Of equal ranges the first wins: the header `[[bodies]]` is the range of the body and of nothing inside it,
        // while a dotted key is the range of the key itself and of the table it makes.
        if self.holds(range) && range.len() < self.length {
            self.length = range.len();
            self.found = self.at.clone();
        }
    }
}
