//! What a value is refused for and where it stands, and the checks of numbers that entries of every kind share.

use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::Exactly;
use glam::DVec3;
use polhode::spatial::UnitVector;
use std::collections::BTreeSet;

/// A refusal and the path of the key it is about.
pub(crate) type Fault = (KeyPath, Refusal);

/// All that is refused of a scene.
#[derive(Debug, Default)]
pub(super) struct Faults(Vec<Fault>);

impl Faults {
    /// One more.
    pub(super) fn add(&mut self, fault: Fault) {
        self.0.push(fault);
    }

    /// What was made; nothing where it is refused, which is noted.
    pub(super) fn note<T>(&mut self, made: Result<T, Fault>) -> Option<T> {
        made.map_err(|fault| self.add(fault)).ok()
    }

    /// Nothing is refused.
    ///
    /// # Errors
    /// All that is: a file that many bodies name is refused once.
    pub(super) fn none(mut self) -> Result<(), Vec<Fault>> {
        let mut files = BTreeSet::new();
        self.0.retain(|(_, cause)| {
            let is_of_file = matches!(cause, Refusal::Solid { .. } | Refusal::MeshFile(_));
            !is_of_file || files.insert(cause.to_string())
        });
        if self.0.is_empty() { Ok(()) } else { Err(self.0) }
    }
}

/// `value`, when it is positive and finite.
pub(super) fn positive(value: f64, path: &KeyPath) -> Result<f64, Fault> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err((path.clone(), Refusal::Number { value, accepted: "a positive, finite number" }))
    }
}

/// `value`, when it is finite and not negative.
pub(super) fn not_negative(value: f64, path: &KeyPath) -> Result<f64, Fault> {
    if value >= 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err((path.clone(), Refusal::Number { value, accepted: "a finite number of at least 0" }))
    }
}

/// `value`, when it is finite.
pub(super) fn finite(value: f64, path: &KeyPath) -> Result<f64, Fault> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err((path.clone(), Refusal::Number { value, accepted: "a finite number" }))
    }
}

/// Three numbers, when all are finite.
pub(super) fn vector(value: &Exactly<f64, 3>, path: &KeyPath) -> Result<DVec3, Fault> {
    for (index, &component) in value.0.iter().enumerate() {
        finite(component, &path.index(index))?;
    }
    Ok(DVec3::from_array(value.0))
}

/// A direction of any length but zero.
pub(super) fn direction(entry: &Exactly<f64, 3>, path: &KeyPath) -> Result<UnitVector, Fault> {
    UnitVector::new(vector(entry, path)?).map_err(|error| (path.clone(), error.into()))
}
