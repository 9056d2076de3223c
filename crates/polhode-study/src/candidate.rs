//! Candidates: a scene changed by settings of the scene format, the same that `--set` changes.
//!
//! Any key can be varied, so the same command compares integrators, steps, contact methods, or masses.

use polhode_scene::Override;
use std::fmt::Write as _;

/// What errors name as the place of a value that is varied.
const ORIGIN: &str = "study";

/// Candidates at the most: more is a mistake in a product of axes.
const MOST_CANDIDATES: usize = 10_000;

/// One way to run the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// What its curve in the figure is called: its settings but for the one that is stepped through.
    pub series: String,
    /// The setting that is stepped through, such as `step 0.01`; may be empty.
    pub rung: String,
    /// The changes to the scene.
    pub changes: Vec<Override>,
    /// About how much longer it takes than the candidate of its series before it; `None` for one that is to be run
    /// however long it takes.
    pub growth: Option<f64>,
}

impl Candidate {
    /// Series and rung.
    pub fn name(&self) -> String {
        format!("{} {}", self.series, self.rung).trim_end().to_owned()
    }

    /// The changes that make it another model of the world and not another method: they decide which reference it is
    /// compared with. An impact law is a model; all else under `method` is a means to compute it.
    pub fn model(&self) -> Vec<Override> {
        self.changes.iter().filter(|change| is_model(&change.key)).cloned().collect()
    }

    /// The value that it gives a key.
    pub fn value(&self, key: &str) -> Option<&str> {
        self.changes.iter().find(|change| change.key == key).map(|change| change.value.as_str())
    }

    /// The lines of a scene file that select it: a table `[method]`, and `--set` for what stands elsewhere.
    pub fn toml(&self) -> String {
        let mut text = "[method]\n".to_owned();
        let mut elsewhere = String::new();
        for Override { key, value, .. } in &self.changes {
            let _ = match key.strip_prefix("method.") {
                Some(key) => writeln!(text, "{key} = {}", toml_value(value)),
                None => writeln!(elsewhere, "# and --set {key}={value}"),
            };
        }
        text + &elsewhere
    }
}

fn is_model(key: &str) -> bool {
    key == "method.impact" || !(key.starts_with("method.") || key.starts_with("output."))
}

/// A value as TOML writes it: a bare word is a string.
fn toml_value(value: &str) -> String {
    let is_toml =
        value.parse::<f64>().is_ok() || value == "true" || value == "false" || value.starts_with(['"', '\'', '[', '{']);
    if is_toml { value.to_owned() } else { format!("\"{value}\"") }
}

/// A change that a candidate makes.
pub fn change(key: &str, value: impl Into<String>) -> Override {
    Override::new(ORIGIN, key, value)
}

/// A key and the values it takes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Axis {
    key: String,
    values: Vec<String>,
}

impl Axis {
    /// From `key=value,value,...`; commas within quotes and brackets of any kind belong to a value.
    ///
    /// # Errors
    /// When there is no `=`, the key is empty or a value is.
    pub fn parse(text: &str) -> Result<Self, String> {
        let form = "KEY=VALUE,VALUE,... such as method.step=0.1,0.01";
        let whole = Override::parse(ORIGIN, text).ok_or_else(|| format!("{text}: not of the form {form}"))?;
        let values = split(&whole.value);
        if whole.key.is_empty() || values.iter().any(String::is_empty) {
            return Err(format!("{text}: a key or a value is empty; the form is {form}"));
        }
        Ok(Self { key: whole.key, values })
    }

    /// The key and its values.
    pub(crate) fn into_parts(self) -> (String, Vec<String>) {
        (self.key, self.values)
    }

    fn is_numeric(&self) -> bool {
        self.values.iter().all(|value| value.parse::<f64>().is_ok())
    }

    /// Last part of the key: enough to recognise it by.
    fn word(&self) -> &str {
        self.key.rsplit('.').next().unwrap_or(&self.key)
    }
}

/// Values between commas outside quotes and brackets.
fn split(text: &str) -> Vec<String> {
    let (mut values, mut start, mut depth, mut quote) = (Vec::new(), 0, 0_usize, None);
    for (at, c) in text.char_indices() {
        match (quote, c) {
            (Some(open), c) if open == c => quote = None,
            (None, '"' | '\'') => quote = Some(c),
            (None, '[' | '{' | '(') => depth += 1,
            (None, ']' | '}' | ')') => depth = depth.saturating_sub(1),
            (None, ',') if depth == 0 => {
                values.push(text[start..at].trim().to_owned());
                start = at + 1;
            }
            _ => {}
        }
    }
    values.push(text[start..].trim().to_owned());
    values
}

/// Every combination of the values: the last axis of numbers is the one that is stepped through.
///
/// # Errors
/// When a key is given twice or the combinations are too many.
pub fn product(axes: &[Axis]) -> Result<Vec<Candidate>, String> {
    for (number, axis) in axes.iter().enumerate() {
        if axes[..number].iter().any(|other| other.key == axis.key) {
            return Err(format!("{}: the key is varied twice", axis.key));
        }
    }
    let count = axes.iter().try_fold(1_usize, |count, axis| count.checked_mul(axis.values.len()));
    let Some(count) = count.filter(|&count| count <= MOST_CANDIDATES) else {
        return Err(format!("more than {MOST_CANDIDATES} combinations"));
    };
    let stepped = axes.iter().rposition(Axis::is_numeric);
    // The stepped axis runs fastest, so that a series stands together.
    let mut order: Vec<usize> = (0..axes.len()).filter(|&axis| Some(axis) != stepped).collect();
    order.extend(stepped);
    let mut candidates = Vec::with_capacity(count);
    for number in 0..count {
        let mut rest = number;
        let mut chosen = vec![0; axes.len()];
        for &axis in order.iter().rev() {
            chosen[axis] = rest % axes[axis].values.len();
            rest /= axes[axis].values.len();
        }
        candidates.push(combination(axes, &chosen, stepped));
    }
    Ok(candidates)
}

fn combination(axes: &[Axis], chosen: &[usize], stepped: Option<usize>) -> Candidate {
    let (mut words, mut rung, mut changes) = (Vec::new(), String::new(), Vec::new());
    for (number, (axis, &choice)) in axes.iter().zip(chosen).enumerate() {
        let value = &axis.values[choice];
        changes.push(change(&axis.key, value));
        if Some(number) == stepped {
            rung = format!("{} {value}", axis.word());
        } else if axis.is_numeric() {
            words.push(format!("{}={value}", axis.word()));
        } else {
            words.push(value.trim_matches(['"', '\'']).to_owned());
        }
    }
    let series = if words.is_empty() { "scene's method".to_owned() } else { words.join(" ") };
    Candidate { series, rung, changes, growth: None }
}

#[cfg(test)]
mod tests {
    //! Axes give every combination, and a candidate says how to ask for it.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;

    fn candidates(axes: &[&str]) -> Vec<Candidate> {
        product(&axes.iter().map(|text| Axis::parse(text).unwrap()).collect::<Vec<_>>()).unwrap()
    }

    #[test]
    fn every_combination_with_the_numbers_stepped_through() {
        let all = candidates(&["method.step=0.1,0.01", "method.integrator=rk4,cf4"]);
        let names: Vec<_> = all.iter().map(Candidate::name).collect();
        assert_eq!(names, ["rk4 step 0.1", "rk4 step 0.01", "cf4 step 0.1", "cf4 step 0.01"]);
        assert_eq!(all[1].toml(), "[method]\nstep = 0.01\nintegrator = \"rk4\"\n");
        assert!(all.iter().all(|candidate| candidate.model().is_empty()));
    }

    #[test]
    fn commas_in_brackets_and_quotes_belong_to_the_value() {
        let all = candidates(&["bodies.a.velocity=[1, 0, 0],[2, 0, 0]"]);
        assert_eq!(all.len(), 2);
        assert_eq!(all[1].series, "[2, 0, 0]");
        assert_eq!(all[1].model().len(), 1, "another velocity is another motion, not another method");
        assert!(all[1].toml().contains("--set bodies.a.velocity=[2, 0, 0]"));
        assert_eq!(split("\"a,b\",{x = 1, y = 2}"), ["\"a,b\"", "{x = 1, y = 2}"]);
    }

    #[test]
    fn an_impact_law_is_a_model() {
        let all = candidates(&["method.impact=propagation,reflection", "method.contact=active-set"]);
        assert_eq!(all[0].model(), [change("method.impact", "propagation")]);
        assert_eq!(all[0].series, "propagation active-set");
    }

    #[test]
    fn mistakes_are_told() {
        for text in ["method.step", "=1", "method.step=", "method.step=1,,2"] {
            assert!(Axis::parse(text).is_err(), "{text}");
        }
        let axis = Axis::parse("a=1,2").unwrap();
        assert!(product(&[axis.clone(), axis]).is_err());
        let many = |key: &str| Axis { key: key.to_owned(), values: vec!["1".to_owned(); 1 << 10] };
        assert!(product(&[many("a"), many("b"), many("c"), many("d"), many("e"), many("f"), many("g")]).is_err());
    }
}
