//! At which value of a key a scene changes: by halving between a value at which it is one way and one at which it is
//! the other.

use super::runs;
use super::runs::{Moves, ORIGIN, SceneRun};
use crate::row::Value;
use polhode_scene::Override;
use polhode_study::stands::{Interval, Question};
use serde::Deserialize;
use std::error::Error;

/// Halvings at the most: all bits of a number.
const MOST_HALVINGS: usize = 64;

/// At which value of a key a scene changes.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Limit {
    /// The key.
    pub key: String,
    /// Between these values.
    pub between: [f64; 2],
    /// To so many digits.
    pub digits: u32,
    /// What changes.
    pub by: By,
}

/// What changes.
#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum By {
    /// Whether bodies stand, by statics and the first step.
    Statics,
    /// Whether bodies move in the run.
    Moves(Moves),
    /// Whether a measure of the run is above this.
    Above(Above),
}

/// Whether a measure is above a value.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Above {
    /// The measure, in the words of `polhode sweep --measure`.
    pub measure: String,
    /// The value.
    pub value: f64,
}

impl Limit {
    /// Whether `polhode stands` finds it.
    pub(super) fn is_of_statics(&self) -> bool {
        matches!(self.by, By::Statics)
    }

    /// Key and ends, as `polhode stands --bisect` takes them.
    pub(super) fn interval(&self) -> String {
        let [low, high] = self.between;
        format!("{}={low:?}..{high:?} --digits {}", self.key, self.digits)
    }

    /// A command that shows the change.
    pub(super) fn command(&self, scene: &str, set: &str) -> String {
        let [low, high] = self.between;
        let measure = match &self.by {
            By::Above(above) => format!(" --measure '{}'", above.measure),
            By::Moves(_) | By::Statics => String::new(),
        };
        format!("polhode sweep example:{scene}{set} --vary {}={low:?}..{high:?}:9{measure}", self.key)
    }
}

/// The value.
///
/// # Errors
/// When the scene does not run, or is the same way at both ends.
pub(super) fn found(run: &SceneRun, limit: &Limit) -> Result<Value, Box<dyn Error>> {
    let [low, high] = limit.between;
    if limit.is_of_statics() {
        let load = |changes: &[Override]| run.load(changes);
        let question = Question { load: &load, given: run.set() };
        let interval = Interval::parse(&format!("{}={low:?}..{high:?}", limit.key))?;
        return Ok(Value::Number(interval.bisect(&question, limit.digits, || Ok(()))?.limit()));
    }
    let is_one_way = |value: f64| -> Result<bool, Box<dyn Error>> {
        let run = run.with(&limit.key, &format!("{value:?}"));
        match &limit.by {
            By::Moves(moves) => Ok(runs::moved(&run, moves)? == [Value::Text("falls".to_owned())]),
            By::Above(above) => {
                let measured = runs::measured(&run, std::slice::from_ref(&above.measure))?;
                Ok(matches!(measured[..], [Value::Number(number)] if number > above.value))
            }
            By::Statics => Err(ORIGIN.into()),
        }
    };
    let (mut low, mut high) = (low, high);
    let at_low = is_one_way(low)?;
    if is_one_way(high)? == at_low {
        return Err(format!("{}: the scene is the same way at {low} and {high}", limit.key).into());
    }
    let close = libm::pow(10.0, -f64::from(limit.digits));
    for _ in 0..MOST_HALVINGS {
        let middle = 0.5 * (low + high);
        if high - low <= close * low.abs().max(high.abs()) {
            break;
        }
        if is_one_way(middle)? == at_low {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(Value::Number(0.5 * (low + high)))
}
