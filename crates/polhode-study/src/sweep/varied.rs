//! What is varied in a sweep: keys of a scene, each with the values of a list or drawn from a distribution.

use super::distribution::{self, ACCEPTED, Drawing as _};
use super::error::SweepError;
use crate::candidate::Axis;
use polhode_scene::Distribution;

/// Values of a range at the most.
const MOST_VALUES: usize = 10_000_000;

/// A key that is varied.
#[derive(Debug, Clone, PartialEq)]
pub struct Varied {
    /// The key of the scene.
    pub key: String,
    /// Its values.
    pub values: Values,
    /// What a value does to the scene.
    pub acts: Acts,
}

/// What a value that is varied does to the scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Acts {
    /// The key has it.
    Sets,
    /// Bodies, by their numbers among those whose poses are uncertain, are moved by it along an axis of the world, m.
    Shifts(Vec<usize>, usize),
    /// They are turned by it about an axis of the world, rad.
    Turns(Vec<usize>, usize),
}

/// The values of a key.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Each of these, as a scene has them.
    Listed(Vec<String>),
    /// Drawn anew for each run.
    Drawn(Distribution),
}

impl Varied {
    /// From `KEY=VALUE,VALUE,...`, `KEY=LOW..HIGH:COUNT` (so many values, both ends among them), or `KEY=` and a
    /// distribution: `normal(MEAN, DEVIATION)`, `uniform(LOW, HIGH)` or `LOW..HIGH`, `lognormal(MEDIAN, SPREAD)`,
    /// `choice(A, B)`.
    ///
    /// # Errors
    /// When it has no such form, or a number is out of its limits.
    pub fn parse(text: &str) -> Result<Self, SweepError> {
        let (key, given) = Axis::parse(text).map_err(SweepError::Vary)?.into_parts();
        if let [one] = &given[..]
            && let Some(drawn) = drawn(one)?
        {
            return Ok(Self { key, values: Values::Drawn(drawn), acts: Acts::Sets });
        }
        let mut values = Vec::new();
        for own in &given {
            match range(own)? {
                Some(range) => values.extend(range),
                None if drawn(own)?.is_some() => {
                    return Err(SweepError::Vary(format!("{text}: a distribution stands alone, without other values")));
                }
                None => values.push(own.clone()),
            }
        }
        Ok(Self { key, values: Values::Listed(values), acts: Acts::Sets })
    }
}

/// The distribution that a value is, if it is one.
fn drawn(text: &str) -> Result<Option<Distribution>, SweepError> {
    if let Some((low, high)) = text.split_once("..").filter(|(_, high)| !high.contains(':')) {
        let [low, high] = [low, high].map(|end| end.trim().parse::<f64>());
        return match (low, high) {
            (Ok(low), Ok(high)) => Distribution::Uniform { low, high }.checked().map(Some),
            _ => Ok(None),
        };
    }
    let Some((name, rest)) = text.split_once('(') else { return Ok(None) };
    let is_name = !name.is_empty() && name.trim().bytes().all(|byte| byte.is_ascii_alphabetic());
    let Some(inner) = rest.trim().strip_suffix(')').filter(|_| is_name) else { return Ok(None) };
    let arguments: Vec<String> = inner.split(',').map(|own| own.trim().to_owned()).collect();
    let found = distribution::parse(name.trim(), &arguments);
    found
        .ok_or_else(|| SweepError::Vary(format!("{text}: no distribution is called that; accepted: {ACCEPTED}")))?
        .map(Some)
}

/// The values of `LOW..HIGH:COUNT`, if the text has this form.
fn range(text: &str) -> Result<Option<Vec<String>>, SweepError> {
    let Some(((low, high), count)) =
        text.split_once(':').and_then(|(ends, count)| Some((ends.split_once("..")?, count)))
    else {
        return Ok(None);
    };
    let refused =
        || SweepError::Vary(format!("{text}: a range is LOW..HIGH:COUNT, as 0.1..0.8:8, of 1 to {MOST_VALUES} values"));
    let [Ok(low), Ok(high)] = [low, high].map(|end| end.trim().parse::<f64>()) else { return Err(refused()) };
    let count: usize = count.trim().parse().map_err(|_| refused())?;
    let is_accepted = low.is_finite() && high.is_finite() && (1..=MOST_VALUES).contains(&count);
    if !is_accepted || (count == 1 && low != high) {
        return Err(refused());
    }
    let last = count.saturating_sub(1).max(1) as f64;
    let value = |k: usize| if k + 1 == count { high } else { low + (high - low) * (k as f64 / last) };
    Ok(Some((0..count).map(|k| format!("{:?}", value(k))).collect()))
}

#[cfg(test)]
mod tests {
    //! Lists, ranges and distributions are read, and mistakes are told.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;

    #[test]
    fn lists_ranges_and_distributions() {
        let listed = |text: &str| match Varied::parse(text).unwrap().values {
            Values::Listed(values) => values,
            Values::Drawn(drawn) => panic!("{drawn:?}"),
        };
        assert_eq!(listed("a.b=0.1..0.4:4"), ["0.1", "0.2", "0.30000000000000004", "0.4"]);
        assert_eq!(listed("a=1,5..6:2"), ["1", "5.0", "6.0"]);
        assert_eq!(listed("a=[1, 0, 0],[2, 0, 0]"), ["[1, 0, 0]", "[2, 0, 0]"]);
        assert_eq!(listed("m=newton,\"a..b\""), ["newton", "\"a..b\""]);
        let drawn = |text: &str| match Varied::parse(text).unwrap().values {
            Values::Drawn(drawn) => drawn,
            Values::Listed(values) => panic!("{values:?}"),
        };
        assert_eq!(drawn("a=normal(1, 0.5)"), Distribution::Normal { mean: 1.0, deviation: 0.5 });
        assert_eq!(drawn("a=-1..2"), Distribution::Uniform { low: -1.0, high: 2.0 });
        assert_eq!(drawn("a=choice(newton, poisson)"), Distribution::Choice(vec!["newton".into(), "poisson".into()]));
    }

    #[test]
    fn mistakes_are_told() {
        for text in [
            "a",
            "a=",
            "=1",
            "a=1..2:0",
            "a=1..x:3",
            "a=2..1",
            "a=nan..1",
            "a=1..2:1e9",
            "a=1..2:100000000",
            "a=normal(1)",
            "a=normal(1, -1)",
            "a=lognormal(-1, 1)",
            "a=gauss(1, 2)",
            "a=normal(1, 2),3",
            "a=choice()",
            "a=1..2:1",
        ] {
            assert!(Varied::parse(text).is_err(), "{text}: {:?}", Varied::parse(text));
        }
    }
}
