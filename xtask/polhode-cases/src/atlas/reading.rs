//! How a number is read out of runs.

use super::modes::Modes;
use super::runs::{Moves, SceneRun};
use super::throws::Landings;
use super::{modes, own, runs, throws};
use crate::cases::{ALL, Context};
use crate::row::Value;
use serde::Deserialize;
use std::error::Error;

/// How some numbers of an entry are read.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reading {
    /// The shipped scene that is run.
    pub scene: Option<String>,
    /// What is changed in it, as by `--set`.
    #[serde(default)]
    pub set: Vec<String>,
    /// What is read.
    pub read: Read,
}

/// What is read.
#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Read {
    /// Of a run, in the words of `polhode sweep --measure`.
    Measure(Vec<String>),
    /// Whether bodies move.
    Moves(Moves),
    /// How small disturbances grow or die away.
    Modes(Modes),
    /// How often a thrown body comes to rest on its faces.
    Landings(Landings),
    /// A row of a case of `cargo xtask verify`.
    Case(CaseRow),
    /// What is no quantity of the scene format: see the module of that name.
    Own(String),
}

/// A row of a case.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CaseRow {
    /// The case.
    pub case: String,
    /// Its quantity.
    pub quantity: String,
    /// Which of several numbers; all where it is absent.
    pub component: Option<usize>,
}

impl Reading {
    /// Reads it.
    ///
    /// # Errors
    /// When a scene does not run to its end as its method promises, or there is nothing of that name.
    pub(super) fn values(&self, context: &Context) -> Result<Vec<Value>, Box<dyn Error>> {
        match &self.read {
            Read::Case(row) => row.values(context),
            Read::Own(name) => own::values(name, &self.run(context)?),
            Read::Measure(measures) => runs::measured(&self.run(context)?, measures),
            Read::Moves(moves) => runs::moved(&self.run(context)?, moves),
            Read::Modes(modes) => modes::found(&self.run(context)?, modes),
            Read::Landings(landings) => throws::shares(&self.run(context)?, landings, context.amount),
        }
    }

    fn run(&self, context: &Context) -> Result<SceneRun, Box<dyn Error>> {
        let name = self.scene.as_deref().ok_or("this reading is of a scene, and names none")?;
        SceneRun::new(&context.shipped.path(name), &self.set)
    }

    /// The command that shows it.
    pub fn command(&self) -> String {
        let all = |option: &str, values: &[String]| {
            values.iter().fold(String::new(), |text, value| format!("{text} {option} '{value}'"))
        };
        let set = all("--set", &self.set);
        let scene = self.scene.as_deref().unwrap_or_default();
        match &self.read {
            Read::Measure(measures) => {
                let measures = all("--measure", measures);
                format!("polhode sweep example:{scene}{set} --vary method.error=off{measures}")
            }
            Read::Moves(_) | Read::Modes(_) | Read::Own(_) => format!("polhode run example:{scene}{set}"),
            Read::Landings(landings) => format!("polhode drop example:{scene}{set} -n {}", landings.throws),
            Read::Case(row) => format!("cargo xtask verify --only \"{}\"", row.case),
        }
    }
}

impl CaseRow {
    fn values(&self, context: &Context) -> Result<Vec<Value>, Box<dyn Error>> {
        let case = ALL.iter().find(|case| case.name == self.case);
        let case = case.ok_or_else(|| format!("there is no case {}", self.case))?;
        let rows = case.run(context);
        let row = rows.iter().find(|row| row.quantity == self.quantity);
        let row = row.ok_or_else(|| format!("the case {} has no row \"{}\"", self.case, self.quantity))?;
        let all = match &row.measured {
            Value::Numbers(numbers) => numbers.iter().map(|&number| Value::Number(number)).collect(),
            Value::Flags(flags) => flags.iter().map(|&flag| Value::Text(flag.to_string())).collect(),
            Value::Flag(flag) => vec![Value::Text(flag.to_string())],
            own => vec![own.clone()],
        };
        let Some(component) = self.component else { return Ok(all) };
        let one = all.into_iter().nth(component);
        Ok(vec![one.ok_or_else(|| format!("{}, {}: no component {component}", self.case, self.quantity))?])
    }
}
