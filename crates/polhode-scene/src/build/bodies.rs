//! Bodies by name, for what refers to them.

use super::fault::Fault;
use crate::document::KeyPath;
use crate::error::{Refusal, nearest};
use polhode::{Body, BodyId};
use std::collections::BTreeMap;

/// The bodies of a scene and the names they go by.
pub(super) struct Bodies<'a> {
    bodies: &'a [Body],
    numbers: BTreeMap<&'a str, usize>,
}

impl<'a> Bodies<'a> {
    /// Bodies whose names differ.
    pub(super) fn new(bodies: &'a [Body]) -> Self {
        Self { bodies, numbers: bodies.iter().enumerate().map(|(number, body)| (body.name(), number)).collect() }
    }

    /// All of them, in the order of the scene.
    pub(super) fn all(&self) -> &'a [Body] {
        self.bodies
    }

    /// The body of this name, given at `path`, and its handle.
    pub(super) fn get(&self, name: &str, path: &KeyPath) -> Result<(BodyId, &'a Body), Fault> {
        let found = self.numbers.get(name).and_then(|&number| Some((BodyId::new(number), self.bodies.get(number)?)));
        found.ok_or_else(|| {
            let names: Vec<_> = self.bodies.iter().map(Body::name).collect();
            let known = nearest(name, &names, "none, the scene has no bodies");
            (path.clone(), Refusal::UnknownName { kind: "body", name: name.to_owned(), known })
        })
    }

    /// The handle of the body of this name, which forces must move: on another one, `key` (a kind of force) does
    /// nothing.
    pub(super) fn movable(&self, name: &str, key: &'static str, path: &KeyPath) -> Result<BodyId, Fault> {
        let (number, body) = self.get(name, path)?;
        if body.is_fixed() {
            let what = if body.motion().is_some() { "a body with a prescribed motion" } else { "a fixed body" };
            return Err((path.clone(), Refusal::Meaningless { key, what }));
        }
        Ok(number)
    }
}
