//! A logarithmic axis that ends where its values end, with marks that suit its length.

use super::axes;
use super::scale::Mark;

/// Decades that an axis has at the least.
const FEWEST: f64 = 1.0;

/// Whole decades from which on only powers of ten are marked.
const POWERS_ALONE: usize = 3;

/// Digits that are marked on a short axis.
const DIGITS: [f64; 3] = [1.0, 2.0, 5.0];

/// A logarithmic axis; a value on it is its decimal logarithm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Decades {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

impl Decades {
    /// Around logarithms, with room (decades) on both sides.
    pub(crate) fn around(logarithms: impl Iterator<Item = f64>, room: f64) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in logarithms.filter(|value| value.is_finite()) {
            (low, high) = (low.min(value), high.max(value));
        }
        if low > high {
            return Self { low: -1.0, high: 0.0 };
        }
        let lacking = (0.5 * (FEWEST - (high - low))).max(0.0);
        Self { low: low - room.max(lacking), high: high + room.max(lacking) }
    }

    /// The same places in another unit, of which one of this axis has 10^`shift`.
    pub(crate) fn shifted(self, shift: f64) -> Self {
        Self { low: self.low + shift, high: self.high + shift }
    }

    /// Where a logarithm is: 0 at the beginning, 1 at the end.
    pub(crate) fn part(self, logarithm: f64) -> f64 {
        (logarithm - self.low) / (self.high - self.low)
    }

    /// What is marked, with its place from 0 to 1; at most about `most`.
    pub(crate) fn marks(self, most: usize) -> Vec<(f64, Mark)> {
        let (first, last) = (self.low.ceil() as i32, self.high.floor() as i32);
        let whole = (last - first + 1).max(0) as usize;
        if whole >= POWERS_ALONE {
            let stride = (whole.div_ceil(most.max(1)) as i32).max(1);
            let powers = (first..=last).filter(|decade| decade % stride == 0);
            return powers.map(|decade| (self.part(f64::from(decade)), Mark::Power(decade))).collect();
        }
        let mut marks = Vec::new();
        for decade in first - 1..=last {
            for digit in DIGITS {
                let part = self.part(f64::from(decade) + libm::log10(digit));
                if (0.0..=1.0).contains(&part) {
                    marks.push((part, Mark::Number(axes::value(digit * libm::exp10(f64::from(decade)), ""))));
                }
            }
        }
        marks
    }
}

#[cfg(test)]
mod tests {
    //! Every axis has a length and marks.
    use super::*;

    #[test]
    fn a_long_axis_has_powers_and_a_short_one_digits_between() {
        let long = Decades::around([-7.2, 0.3].into_iter(), 0.1).marks(12);
        assert_eq!(
            long.iter().map(|(_, mark)| mark.clone()).collect::<Vec<_>>(),
            (-7..=0).map(Mark::Power).collect::<Vec<_>>()
        );
        let short = Decades::around([0.0].into_iter(), 0.1);
        assert_eq!(short, Decades { low: -0.5, high: 0.5 });
        let marks: Vec<Mark> = short.marks(12).into_iter().map(|(_, mark)| mark).collect();
        assert_eq!(marks, ["0.5", "1", "2"].map(|number| Mark::Number(number.to_owned())));
        assert_eq!(Decades::around([f64::NAN].into_iter(), 0.1), Decades { low: -1.0, high: 0.0 });
    }

    #[test]
    fn another_unit_has_the_same_places() {
        let axis = Decades { low: -3.0, high: 0.0 };
        assert_eq!(axis.part(-1.5), axis.shifted(2.5).part(1.0));
    }
}
