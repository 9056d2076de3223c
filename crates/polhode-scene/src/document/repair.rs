//! All errors of a document at once.
//!
//! The reader of the format stops at its first error. To find the next ones, what is refused is taken out of the tree
//! and the rest is read again. What then fails only because something was taken out (a shape without its size) is no
//! error of its own and is not told.

use super::key_path::{KeyPath, Step};
use super::tree;
use crate::error::Refusal;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// What has been taken out of a tree.
#[derive(Debug, Default)]
pub(super) struct Damage {
    /// Ranges of the tables from which something was taken.
    tables: Vec<Range<usize>>,
    /// Ranges of the tables that a key was taken from.
    keys: Vec<Range<usize>>,
    /// Tables at the top of which an element or a name may be missing, so that it is unknown to others.
    names: Vec<String>,
}

impl Damage {
    /// Takes out what is refused at `path`; false when there is nothing to take out.
    pub(super) fn take(&mut self, root: &mut Spanned<DeTable<'_>>, path: &KeyPath, cause: &Refusal) -> bool {
        if let (Refusal::MissingKey(key), true) = (cause, path.steps().is_empty()) {
            return supply(root, key);
        }
        let mut path = path.clone();
        // A number of a vector goes with the vector: a shorter one would be an error too.
        while matches!(path.steps().last(), Some(Step::Index(_))) && !tree::is_table(root, &path) {
            path.pop();
        }
        let Some(last) = path.steps().last().cloned() else { return false };
        let mut parent = path.clone();
        parent.pop();
        for depth in 0..path.steps().len() {
            self.tables.push(tree::spans(root, &KeyPath::from(&path.steps()[..depth])).value);
        }
        if let Step::Key(_) = &last {
            self.keys.push(tree::spans(root, &parent).value);
        }
        let is_name = path.steps().len() <= 2 || last == Step::key("name");
        if let (Some(Step::Key(top)), true) = (path.steps().first(), is_name) {
            self.names.push(top.to_string());
        }
        tree::take(root.get_mut(), &path)
    }

    /// Whether an error is only a consequence of what was taken out.
    pub(super) fn explains(&self, root: &Spanned<DeTable<'_>>, path: &KeyPath, cause: &Refusal) -> bool {
        let span = tree::spans(root, path).value;
        match cause {
            // What was taken out may have been the key that is missing, or a misspelling of it.
            // A table that lost its only key is too short.
            Refusal::MissingKey(_) | Refusal::Type { .. } => self.keys.contains(&span),
            Refusal::ShapeKinds
            | Refusal::ForceKinds
            | Refusal::MotionKinds
            | Refusal::JointKinds
            | Refusal::CurveKinds
            | Refusal::LayoutKinds => self.tables.contains(&span),
            _ => false,
        }
    }

    /// Whether an error of the scene that the rest of the tree describes is only a consequence.
    pub(super) fn explains_later(&self, root: &Spanned<DeTable<'_>>, path: &KeyPath, cause: &Refusal) -> bool {
        if self.tables.is_empty() {
            return false;
        }
        let element = KeyPath::from(&path.steps()[..path.steps().len().min(2)]);
        let is_damaged = !path.steps().is_empty() && self.tables.contains(&tree::spans(root, &element).value);
        let unknown = match cause {
            Refusal::UnknownName { kind, .. } => match *kind {
                "body" => self.names.iter().any(|top| top == "bodies" || top == "arrays"),
                _ => self.names.iter().any(|top| top == "materials"),
            },
            _ => false,
        };
        is_damaged || unknown || path.steps().is_empty()
    }
}

/// Gives the root a key that it must have; only the version of the format is one.
fn supply(root: &mut Spanned<DeTable<'_>>, key: &str) -> bool {
    if key != "format" {
        return false;
    }
    let Ok(value) = DeValue::parse("1") else { return false };
    let is_new = !root.get_ref().contains_key(key);
    root.get_mut().insert(Spanned::new(0..0, "format".into()), value);
    is_new
}
