//! Axes: from values to places, and the values that are marked.
//!
//! A linear axis goes between round numbers, a logarithmic one between whole powers of ten. Both are made for whatever
//! values there are: none, one, equal ones, zeros, huge ones, and what is not a number.

/// Values beyond this are drawn at it: differences of larger ones overflow.
const LARGEST: f64 = 1e300;

/// Positive numbers below this count as zero: what is smaller has no digits left.
const SMALLEST: f64 = 1e-290;

/// Values that differ by less than this, of the largest, are drawn as equal: an axis of their difference would show
/// rounding, with labels of ten digits.
const EQUAL: f64 = 1e-9;

/// Marks on a linear axis at the most, about.
const MOST_MARKS: f64 = 6.0;

/// Powers of ten on a logarithmic axis at the most: smaller values are drawn at its foot.
const MOST_DECADES: i32 = 24;

/// Room that the foot of a logarithmic axis takes, decades for every decade shown.
const FOOT_SHARE: f64 = 0.11;

/// Sizes of numbers that are written without an exponent.
const PLAIN: std::ops::Range<f64> = 1e-4..1e6;

/// The label of a mark.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// A number.
    Number(String),
    /// A power of ten.
    Power(i32),
    /// What is too small for a logarithmic axis: below this power of ten, or zero.
    Foot {
        /// The lowest power of ten.
        lowest: i32,
        /// Whether all that is drawn there is zero.
        all_zero: bool,
    },
}

/// How values become places.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scale {
    /// Evenly.
    Linear {
        /// Value at the beginning.
        low: f64,
        /// Value at the end.
        high: f64,
        /// Between marks.
        step: f64,
    },
    /// By their logarithm, of their magnitude.
    Logarithmic {
        /// Power of ten at the beginning, above the foot.
        low: i32,
        /// Power of ten at the end.
        high: i32,
        /// Where zero and what is too small is drawn, if there is any.
        foot: Option<Foot>,
    },
}

/// The foot of a logarithmic axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Foot {
    /// Whether all that is drawn there is zero.
    pub all_zero: bool,
}

impl Scale {
    /// A linear one around values; it begins or ends at zero when they are equal.
    pub fn linear(values: impl Iterator<Item = f64>) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in values.filter(|value| value.is_finite()) {
            let value = value.clamp(-LARGEST, LARGEST);
            (low, high) = (low.min(value), high.max(value));
        }
        if low > high {
            return Self::Linear { low: 0.0, high: 1.0, step: 0.2 };
        }
        let size = low.abs().max(high.abs());
        if size < SMALLEST {
            return Self::Linear { low: 0.0, high: 1.0, step: 0.2 };
        }
        if high - low <= EQUAL * size {
            (low, high) = if high > 0.0 { (0.0, high) } else { (low, 0.0) };
        }
        let step = round_step((high - low) / MOST_MARKS);
        let [first, last] = [(low / step + EQUAL).floor(), (high / step - EQUAL).ceil()];
        Self::Linear { low: first * step, high: last * step, step }
    }

    /// A linear one of whole numbers, from zero on.
    pub fn count(values: impl Iterator<Item = f64>) -> Self {
        match Self::linear(values.chain([0.0])) {
            Self::Linear { high, step, .. } if step < 1.0 => Self::Linear { low: 0.0, high: high.max(1.0), step: 1.0 },
            scale => scale,
        }
    }

    /// A linear one that ends where the values end, such as that of time.
    pub fn linear_within(values: impl Iterator<Item = f64> + Clone) -> Self {
        let ends = |low: f64, high: f64| Self::Linear { low, high, step: round_step((high - low) / MOST_MARKS) };
        let finite = values.filter(|value| value.is_finite() && value.abs() <= LARGEST);
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in finite {
            (low, high) = (low.min(value), high.max(value));
        }
        let size = low.abs().max(high.abs());
        match high - low {
            _ if low > high => ends(0.0, 1.0),
            length if length <= EQUAL * size || length < SMALLEST => {
                ends(low, low + if size > 1.0 { size } else { 1.0 })
            }
            _ => ends(low, high),
        }
    }

    /// A logarithmic one around the magnitudes of values.
    pub fn logarithmic(values: impl Iterator<Item = f64>) -> Self {
        let (mut low, mut high) = (i32::MAX, i32::MIN);
        let (mut zeros, mut least) = (false, f64::INFINITY);
        for value in values.map(f64::abs).filter(|value| value.is_finite()) {
            if value < SMALLEST {
                zeros = true;
                continue;
            }
            let decades = libm::log10(value);
            (low, high) = (low.min(decades.floor() as i32), high.max(decades.ceil() as i32));
            least = least.min(decades);
        }
        if low > high {
            // Of zeros alone there is a foot and nothing above it.
            let foot = zeros.then_some(Foot { all_zero: true });
            return Self::Logarithmic { low: if zeros { 0 } else { -1 }, high: 0, foot };
        }
        let high = high.max(low + 1);
        let low = low.max(high - MOST_DECADES);
        let cut = least < f64::from(low);
        Self::Logarithmic { low, high, foot: (zeros || cut).then_some(Foot { all_zero: !cut }) }
    }

    /// Where a value is: 0 at the beginning, 1 at the end. A value beyond an end is at that end.
    pub fn part(&self, value: f64) -> f64 {
        match *self {
            Self::Linear { low, high, .. } => ((value - low) / (high - low)).clamp(0.0, 1.0),
            Self::Logarithmic { low, high, foot } => {
                let room = f64::from(high - low);
                let foot_room = foot.map_or(0.0, |_| FOOT_SHARE * room);
                let decades = libm::log10(value.abs()) - f64::from(low);
                if room == 0.0 || (decades < 0.0 && foot.is_some()) {
                    0.0
                } else {
                    ((decades.clamp(0.0, room) + foot_room) / (room + foot_room)).clamp(0.0, 1.0)
                }
            }
        }
    }

    /// What is marked, with its place from 0 to 1; of powers of ten not more than `most`.
    pub fn marks(&self, most: usize) -> Vec<(f64, Mark)> {
        match *self {
            Self::Linear { low, high, step } => linear_marks(self, low, high, step),
            Self::Logarithmic { low, high, foot } => {
                let most = most.max(2) as i32;
                let stride = stride((high - low + most - 1) / most);
                let power = |decade: i32| (self.part_of_power(decade), Mark::Power(decade));
                let powers = (low..=high).filter(|decade| low < high && decade % stride == 0);
                let mut marks: Vec<_> = powers.map(power).collect();
                if let Some(Foot { all_zero }) = foot {
                    marks.insert(0, (0.0, Mark::Foot { lowest: low, all_zero }));
                }
                marks
            }
        }
    }

    fn part_of_power(&self, decade: i32) -> f64 {
        match *self {
            Self::Linear { .. } => 0.0,
            Self::Logarithmic { low, high, foot } => {
                let room = f64::from(high - low);
                let foot_room = foot.map_or(0.0, |_| FOOT_SHARE * room);
                (f64::from(decade - low) + foot_room) / (room + foot_room)
            }
        }
    }
}

/// Decades between marks: numbers that people count in.
fn stride(least: i32) -> i32 {
    [1, 2, 3, 4, 5, 10, 20, 50].into_iter().find(|&stride| stride >= least).unwrap_or(100)
}

fn linear_marks(scale: &Scale, low: f64, high: f64, step: f64) -> Vec<(f64, Mark)> {
    if !(step > 0.0 && step.is_finite()) {
        return Vec::new();
    }
    let size = low.abs().max(high.abs());
    let first = (low / step - EQUAL).ceil();
    let count = ((high / step + EQUAL).floor() - first).clamp(0.0, 2.0 * MOST_MARKS) as usize;
    let mark = |number: usize| {
        let value = (first + number as f64) * step;
        // Half a step off zero by rounding is zero.
        let value = if value.abs() < 0.5 * step { 0.0 } else { value };
        (scale.part(value), Mark::Number(marked(value, step, size)))
    };
    (0..=count).map(mark).collect()
}

/// A number with the digits that tell it from the next mark; `size` is the largest that is marked.
fn marked(value: f64, step: f64, size: f64) -> String {
    let decade = |number: f64| libm::floor(libm::log10(number) + EQUAL);
    if value == 0.0 {
        return "0".to_owned();
    }
    let text = if PLAIN.contains(&size) {
        format!("{value:.*}", (-decade(step)).max(0.0) as usize)
    } else {
        let digits = (decade(value.abs()) - decade(step)).clamp(0.0, MOST_DIGITS) as usize;
        format!("{value:.digits$e}")
    };
    text.replace('-', "\u{2212}")
}

/// Digits after the first of a number with an exponent at the most.
const MOST_DIGITS: f64 = 9.0;

/// 1, 2 or 5 times a power of ten, not below `least`, which is positive.
fn round_step(least: f64) -> f64 {
    let power = libm::exp10(libm::floor(libm::log10(least)));
    [1.0, 2.0, 5.0].map(|digit| digit * power).into_iter().find(|&step| step >= least).unwrap_or(10.0 * power)
}

#[cfg(test)]
mod tests {
    //! Every axis has two ends, whatever the values, and its marks are between them.
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_linear_axis_goes_between_round_numbers() {
        let Scale::Linear { low, high, step } = Scale::linear([0.3, 9.2].into_iter()) else { return };
        assert_eq!((low, high, step), (0.0, 10.0, 2.0));
        assert_eq!(Scale::linear([5.0, 5.0 + 1e-12].into_iter()), Scale::Linear { low: 0.0, high: 5.0, step: 1.0 });
        assert_eq!(Scale::linear([f64::NAN].into_iter()), Scale::Linear { low: 0.0, high: 1.0, step: 0.2 });
    }

    #[test]
    fn a_logarithmic_axis_has_whole_decades_and_a_foot_for_zero() {
        let scale = Scale::logarithmic([3e-5, -20.0].into_iter());
        assert_eq!(scale, Scale::Logarithmic { low: -5, high: 2, foot: None });
        let with_zero = Scale::logarithmic([0.0, 1e-3, 1.0].into_iter());
        assert_eq!(with_zero, Scale::Logarithmic { low: -3, high: 0, foot: Some(Foot { all_zero: true }) });
        assert!(with_zero.part(0.0) == 0.0 && with_zero.part(1e-3) > 0.0 && with_zero.part(1.0) == 1.0);
        let wide = Scale::logarithmic([1e-200, 1.0].into_iter());
        let zeros = Scale::logarithmic([0.0, -0.0].into_iter());
        assert_eq!((zeros.part(0.0), zeros.marks(5).len()), (0.0, 1));
        assert_eq!(Scale::count([2.0].into_iter()), Scale::Linear { low: 0.0, high: 2.0, step: 1.0 });
        assert_eq!(Scale::count([0.0].into_iter()), Scale::Linear { low: 0.0, high: 1.0, step: 1.0 });
        assert_eq!(wide, Scale::Logarithmic { low: -24, high: 0, foot: Some(Foot { all_zero: false }) });
    }

    proptest! {
        #[test]
        fn places_and_marks_are_between_the_ends(
            values in prop::collection::vec(prop_oneof![
                prop::num::f64::ANY,
                -1.0..1.0_f64,
                prop::sample::select(vec![0.0, -0.0, 1.0, f64::MAX, f64::MIN_POSITIVE, 5e-324, f64::NAN]),
            ], 0..6),
        ) {
            let all = || values.iter().copied();
            for scale in [Scale::linear(all()), Scale::linear_within(all()), Scale::logarithmic(all())] {
                for value in all().filter(|value| value.is_finite()) {
                    let part = scale.part(value);
                    prop_assert!((0.0..=1.0).contains(&part), "{:?} {} {}", scale, value, part);
                }
                let marks = scale.marks(6);
                prop_assert!(marks.len() < 30, "{:?}", scale);
                prop_assert!(marks.iter().all(|(part, _)| (0.0..=1.0).contains(part)), "{:?}", scale);
            }
        }
    }
}
