//! Where a value stands in a document: `bodies.2.mass`.
//!
//! A reader makes a path for each value that it takes, and needs it only for those that it refuses: keys that the
//! program knows are not copied.

use std::borrow::Cow;

/// One step down.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Step {
    /// To a member of a table.
    Key(Cow<'static, str>),
    /// To an element of an array, from 0.
    Index(usize),
}

impl Step {
    pub(crate) fn key(name: impl Into<Cow<'static, str>>) -> Self {
        Self::Key(name.into())
    }
}

/// A path from the root of a document.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct KeyPath(Vec<Step>);

impl KeyPath {
    /// The whole document.
    pub(crate) fn root() -> Self {
        Self::default()
    }

    /// From keys alone, such as `method.step`.
    pub(crate) fn of(keys: &[&'static str]) -> Self {
        Self(keys.iter().map(|key| Step::key(*key)).collect())
    }

    /// The element `index` of the array `key` at the root.
    pub(crate) fn element(key: &'static str, index: usize) -> Self {
        Self(vec![Step::key(key), Step::Index(index)])
    }

    /// One step further.
    pub(crate) fn then(&self, step: Step) -> Self {
        let mut steps = Vec::with_capacity(self.0.len() + 1);
        steps.extend_from_slice(&self.0);
        steps.push(step);
        Self(steps)
    }

    /// One key further.
    pub(crate) fn key(&self, name: impl Into<Cow<'static, str>>) -> Self {
        self.then(Step::key(name))
    }

    /// One element further, from 0.
    pub(crate) fn index(&self, index: usize) -> Self {
        self.then(Step::Index(index))
    }

    /// Goes one step down.
    pub(crate) fn push(&mut self, step: Step) {
        self.0.push(step);
    }

    /// Goes one step up.
    pub(crate) fn pop(&mut self) {
        self.0.pop();
    }

    pub(crate) fn steps(&self) -> &[Step] {
        &self.0
    }
}

impl From<&[Step]> for KeyPath {
    fn from(steps: &[Step]) -> Self {
        Self(steps.to_vec())
    }
}

/// A key as TOML writes it: bare where that is allowed, quoted otherwise.
pub(crate) fn written(key: &str) -> String {
    let bare = !key.is_empty() && key.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-');
    if bare { key.to_owned() } else { format!("{key:?}") }
}
