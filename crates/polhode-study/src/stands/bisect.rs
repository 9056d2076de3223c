//! Up to which value of a key a scene stands.
//!
//! The interval between a value with which it stands and one with which it does not is halved until both agree to the
//! digits that are asked for. One with which it does not stand must lie beyond the limit: where a scene stands again
//! farther on, one of its limits is found.
//!
//! A key whose values are whole numbers, such as a count, is halved among whole numbers.

use super::error::StandsError;
use super::standing::Question;
use polhode_scene::Override;

/// Most digits: the analysis is good to about six, and a number has no more than these.
pub const MOST_DIGITS: u32 = 12;

/// What errors name as the place of a value.
const ORIGIN: &str = "command line (--bisect)";

/// Halvings at the most: all bits of a number.
const MOST_HALVINGS: usize = 64;

/// Among which numbers a limit is sought.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Numbers {
    /// All.
    Any,
    /// Whole ones alone.
    Whole,
}

/// A key of a scene and the interval in which a limit of it is sought.
#[derive(Debug, Clone, PartialEq)]
pub struct Interval {
    /// The key.
    pub key: String,
    /// The ends, the smaller one first, finite.
    ends: [f64; 2],
    /// Whole, where both are written so.
    numbers: Numbers,
}

/// The limit of a key.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Bisection {
    /// The key.
    pub key: String,
    /// The value nearest to the limit with which the scene stands.
    pub stands: f64,
    /// The value nearest to it with which the scene does not.
    pub falls: f64,
    /// Digits to which the two agree.
    pub digits: u32,
    /// How often the question was asked.
    pub asked: usize,
    /// Among which numbers it was sought.
    pub numbers: Numbers,
}

impl Bisection {
    /// The limit: the middle of both, or of whole numbers the last one that stands.
    pub fn limit(&self) -> f64 {
        match self.numbers {
            Numbers::Whole => self.stands,
            Numbers::Any => middle([self.stands, self.falls]),
        }
    }
}

impl Interval {
    /// From `KEY=LOW..HIGH`.
    ///
    /// # Errors
    /// When it has another form, or the numbers are not finite and in order.
    pub fn parse(text: &str) -> Result<Self, StandsError> {
        let refused = || StandsError::Interval(text.to_owned());
        let Override { key, value: ends, .. } = Override::parse(ORIGIN, text).ok_or_else(refused)?;
        let (low, high) = ends.split_once("..").ok_or_else(refused)?;
        let [low, high] = [low.trim(), high.trim()];
        let is_whole = [low, high].iter().all(|end| end.parse::<i64>().is_ok());
        let ends = [low, high].map(|end| end.parse::<f64>().ok().filter(|number| number.is_finite()));
        match ends {
            [Some(low), Some(high)] if low < high && !key.is_empty() => {
                let numbers = if is_whole { Numbers::Whole } else { Numbers::Any };
                Ok(Self { key, ends: [low, high], numbers })
            }
            _ => Err(refused()),
        }
    }

    /// Finds the limit to so many digits. `asked` is called before every question, and ends the search with an error.
    ///
    /// # Errors
    /// When the scene is refused with one of the values, stands at both ends or at neither, the engine ends, or the
    /// caller ends it.
    pub fn bisect(
        &self,
        question: &Question<'_>,
        digits: u32,
        mut asked: impl FnMut() -> Result<(), StandsError>,
    ) -> Result<Bisection, StandsError> {
        if !(1..=MOST_DIGITS).contains(&digits) {
            return Err(StandsError::Digits { found: digits, most: MOST_DIGITS });
        }
        let mut count = 0;
        let mut stands = |value: f64, numbers: Numbers| {
            asked()?;
            count += 1;
            question.stands_with(&[self.change(value, numbers)])
        };
        let [low, high] = self.ends;
        let at_low = stands(low, self.numbers)?;
        if stands(high, self.numbers)? == at_low {
            let [low, high] = self.ends.map(|value| written(value, self.numbers));
            let does = if at_low { "stands" } else { "does not stand" };
            return Err(StandsError::SameAtBothEnds { key: self.key.clone(), low, high, does });
        }
        // Only of a key that takes no fraction the scene is refused with one.
        let between = self.change(low + 0.5, Numbers::Any);
        let is_whole = self.numbers == Numbers::Whole && question.loaded(&[between]).is_err();
        let numbers = if is_whole { Numbers::Whole } else { Numbers::Any };
        let mut ends = if at_low { [low, high] } else { [high, low] };
        let is_found = |[a, b]: [f64; 2]| {
            let apart = (a - b).abs();
            if is_whole { apart <= 1.0 } else { apart <= libm::pow(10.0, -f64::from(digits)) * a.abs().max(b.abs()) }
        };
        for _ in 0..MOST_HALVINGS {
            let value = middle(ends);
            let value = if is_whole { value.floor() } else { value };
            if is_found(ends) || ends.contains(&value) {
                break;
            }
            let side = usize::from(!stands(value, numbers)?);
            ends[side] = value;
        }
        let [stands, falls] = ends;
        Ok(Bisection { key: self.key.clone(), stands, falls, digits, asked: count, numbers })
    }

    fn change(&self, value: f64, numbers: Numbers) -> Override {
        Override::new(ORIGIN, &self.key, written(value, numbers))
    }
}

/// A value as a scene has it.
fn written(value: f64, numbers: Numbers) -> String {
    match numbers {
        Numbers::Whole => format!("{value:.0}"),
        Numbers::Any => format!("{value:?}"),
    }
}

fn middle([a, b]: [f64; 2]) -> f64 {
    a + 0.5 * (b - a)
}

#[cfg(test)]
mod tests {
    //! A limit is that of statics, also of a key of whole numbers; what is no interval is told.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;

    const BOX: &str = "format = 1
gravity = [0, 0, -9.81]
[materials.wood]
friction = 0.5
[[bodies]]
name = \"floor\"
fixed = true
shape.half_space.normal = [0, 0, 1]
material = \"wood\"
[[arrays]]
name = \"a\"
mass = 1
shape.box.size = [1, 1, 0.2]
position = [0, 0, 0.1]
material = \"wood\"
layout.grid = { counts = [1, 1, 1], spacing = [1, 1, 0.2] }
";

    fn bisect(text: &str, digits: u32) -> Result<Bisection, StandsError> {
        let load = |changes: &[Override]| polhode_scene::load_text("box", BOX, changes);
        Interval::parse(text)?.bisect(&Question { load: &load, given: &[] }, digits, || Ok(()))
    }

    /// A box slides at the friction that is the slope of gravity.
    #[test]
    fn a_limit_is_that_of_statics() {
        let found = bisect("gravity.0=1..9", 6).unwrap();
        assert!((found.limit() / (0.5 * 9.81) - 1.0).abs() < 2e-6, "{found:?}");
        assert!(found.stands < found.falls && found.numbers == Numbers::Any);
    }

    /// A tower of n boxes, each 0.2 m high, tips at the slope 1 / (0.2 n): with a slope of 0.245 it stands up to 20.
    #[test]
    fn whole_numbers_are_halved_among_themselves() {
        let load = |changes: &[Override]| polhode_scene::load_text("box", BOX, changes);
        let given = [Override::new("test", "gravity", "[2.4, 0, -9.81]")];
        let question = Question { load: &load, given: &given };
        let found = Interval::parse("arrays.0.layout.grid.counts.2=1..40").unwrap().bisect(&question, 6, || Ok(()));
        let found = found.unwrap();
        assert!(found.numbers == Numbers::Whole && found.limit() == 20.0 && found.falls == 21.0, "{found:?}");
    }

    #[test]
    fn what_has_no_limit_is_told() {
        let told = |text: &str| bisect(text, 6).unwrap_err().to_string();
        assert!(told("gravity.0=0..1").contains("it stands at 0 and at 1"));
        assert!(told("gravity.0=6..9").contains("it does not stand at 6 and at 9"));
        for text in ["gravity.0", "gravity.0=1", "gravity.0=2..1", "gravity.0=1..1", "=1..2", "a=1..nan", "a=x..2"] {
            assert!(told(text).contains("KEY=LOW..HIGH is needed"), "{text}");
        }
        assert!(bisect("gravity.0=1..9", 0).unwrap_err().to_string().contains("1 to 12"));
        assert!(told("gravities=1..9").contains("gravities"));
    }
}
