//! Reference values: the project's own copy of what it is compared with, in `fixtures/reference`.
//!
//! A file holds a group of cases; a case has an id, its source, its parameters and quantities; a quantity has a value,
//! a tolerance and the kind of the tolerance. The fields `exact`, `digits` and `note` are for people.

use crate::row::{Row, Tolerance, Value};
use serde::Deserialize;
use std::error::Error;
use std::path::Path;

/// All cases of all groups.
#[derive(Debug)]
pub struct Reference {
    cases: Vec<ReferenceCase>,
}

#[derive(Debug, Deserialize)]
struct ReferenceGroup {
    cases: Vec<ReferenceCase>,
}

#[derive(Debug, Deserialize)]
struct ReferenceCase {
    id: String,
    quantities: Vec<ReferenceQuantity>,
}

#[derive(Debug, Deserialize)]
struct ReferenceQuantity {
    quantity: String,
    value: Value,
    tolerance: f64,
    kind: Kind,
}

/// Words of the files for a kind of tolerance.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Kind {
    Rel,
    RelNorm,
    Abs,
    Exact,
}

impl Reference {
    /// Reads every file of the folder.
    ///
    /// # Errors
    /// When a file cannot be read or understood; the message names it.
    pub fn load(folder: &Path) -> Result<Self, Box<dyn Error>> {
        let mut paths: Vec<_> = std::fs::read_dir(folder)
            .map_err(|error| format!("{}: {error}", folder.display()))?
            .filter_map(|entry| entry.ok().map(|entry| entry.path()))
            .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
            .collect();
        paths.sort();
        let mut cases = Vec::new();
        for path in paths {
            let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
            let group: ReferenceGroup =
                serde_json::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))?;
            cases.extend(group.cases);
        }
        Ok(Self { cases })
    }

    /// A measured value against the reference of that case and quantity.
    ///
    /// # Errors
    /// When there is no such case or quantity.
    pub fn row(&self, case: &str, quantity: &str, measured: impl Into<Value>) -> Result<Row, Box<dyn Error>> {
        let found = self.quantity(case, quantity)?;
        let tolerance = match found.kind {
            Kind::Rel => Tolerance::Relative(found.tolerance),
            Kind::RelNorm => Tolerance::RelativeNorm(found.tolerance),
            Kind::Abs => Tolerance::Absolute(found.tolerance),
            Kind::Exact => Tolerance::Exact,
        };
        Ok(Row::compared(case, quantity, found.value.clone(), measured, tolerance))
    }

    /// The numbers of a reference value.
    ///
    /// # Errors
    /// When there is no such case or quantity, or it is not made of numbers.
    pub fn numbers(&self, case: &str, quantity: &str) -> Result<Vec<f64>, Box<dyn Error>> {
        let found = self.quantity(case, quantity)?.value.numbers();
        found.ok_or_else(|| format!("the reference value \"{quantity}\" of case {case} is not made of numbers").into())
    }

    fn quantity(&self, case: &str, quantity: &str) -> Result<&ReferenceQuantity, Box<dyn Error>> {
        let found = self.cases.iter().find(|candidate| candidate.id == case);
        let found = found.ok_or_else(|| format!("no reference values for case {case}"))?;
        let by_name = found.quantities.iter().find(|candidate| candidate.quantity == quantity);
        by_name.ok_or_else(|| format!("case {case} has no reference value \"{quantity}\"").into())
    }
}
