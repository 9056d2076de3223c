//! Distributions that a sweep draws from.
//!
//! A draw is the value `F^-1(u)` below which a share `u` of all draws lies. The share of a run depends on nothing but
//! the seed, the number of the run and the key: it is a hash of the three (BLAKE2b), so that shards and workers draw
//! alike, and the first draws of more runs are those of fewer. It is a multiple of `2^-53`, and neither 0 nor 1.
//!
//! The inverse of the normal distribution is that of Wichura 1988 (algorithm AS 241), which is right to about 1e-16
//! (docs/REFERENCES.md).

use super::error::SweepError;
use super::gauss::{self, Weight};
use blake2::digest::consts::U8;
use blake2::{Blake2b, Digest};
use polhode_scene::Distribution;

/// Bits of a share: with half of its last place added it is a float exactly.
const BITS: u32 = 52;

/// A node of a quadrature.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Node {
    /// Deviations from the mean, a place from -1 to 1, or the number of a choice.
    pub(super) at: f64,
    /// Its weight; the sum of all is 1.
    pub(super) weight: f64,
    /// The value, as a scene has it.
    pub(super) value: String,
}

/// What distributions are accepted, for messages.
pub(super) const ACCEPTED: &str =
    "normal(MEAN, DEVIATION), lognormal(MEDIAN, SPREAD), uniform(LOW, HIGH), LOW..HIGH or choice(A, B, ...)";

/// From its name and what stands in its brackets. None where no distribution bears the name.
///
/// # Errors
/// When a number is missing, is none or is out of its limits.
pub(super) fn parse(name: &str, arguments: &[String]) -> Option<Result<Distribution, SweepError>> {
    let two = |make: fn(f64, f64) -> Distribution| numbers(name, arguments).and_then(|[a, b]| make(a, b).checked());
    Some(match name {
        "normal" => two(|mean, deviation| Distribution::Normal { mean, deviation }),
        "lognormal" => two(|median, spread| Distribution::LogNormal { median, spread }),
        "uniform" => two(|low, high| Distribution::Uniform { low, high }),
        "choice" => Distribution::Choice(arguments.to_vec()).checked(),
        _ => return None,
    })
}

/// How values are drawn from a distribution, and integrals over it taken.
pub(super) trait Drawing: Sized {
    /// The same, if its numbers are within their limits.
    ///
    /// # Errors
    /// When one is not.
    fn checked(self) -> Result<Self, SweepError>;

    /// The value, as a scene file has it, that this share of all draws lies below; `share` is between 0 and 1.
    fn at(&self, share: f64) -> String;

    /// The value of a run: it depends on nothing but seed, run and key.
    fn draw(&self, seed: u64, run: u64, key: &str) -> String {
        self.at(share(seed, run, key))
    }

    /// The standard deviation, near enough to choose a step by; none where values are no numbers.
    fn deviation(&self) -> Option<f64>;

    /// Nodes of Gauss's quadrature; all values of a choice, whatever their number.
    fn nodes(&self, count: usize) -> Vec<Node>;

    /// Where a value is among the nodes: as [`Node::at`].
    fn place_of(&self, value: &str) -> Option<f64>;
}

impl Drawing for Distribution {
    fn checked(self) -> Result<Self, SweepError> {
        let (what, is_accepted) = match &self {
            Self::Normal { mean, deviation } => (
                format!("normal({mean}, {deviation}): a finite mean and a deviation that is not negative are needed"),
                mean.is_finite() && deviation.is_finite() && *deviation >= 0.0,
            ),
            Self::LogNormal { median, spread } => (
                format!(
                    "lognormal({median}, {spread}): a positive median and a spread that is not negative are needed"
                ),
                median.is_finite() && *median > 0.0 && spread.is_finite() && *spread >= 0.0,
            ),
            Self::Uniform { low, high } => (
                format!("{low}..{high}: two finite numbers are needed, the smaller one first"),
                low.is_finite() && high.is_finite() && low <= high,
            ),
            Self::Choice(values) => (
                "choice(): at least one value is needed".to_owned(),
                values.iter().all(|value| !value.is_empty()) && !values.is_empty(),
            ),
        };
        if is_accepted { Ok(self) } else { Err(SweepError::Vary(what)) }
    }

    fn at(&self, share: f64) -> String {
        let number = match self {
            Self::Normal { mean, deviation } => mean + deviation * inverse_normal(share),
            Self::LogNormal { median, spread } => median * libm::exp(spread * inverse_normal(share)),
            Self::Uniform { low, high } => low + (high - low) * share,
            Self::Choice(values) => {
                let place = (share * values.len() as f64) as usize;
                return values[place.min(values.len() - 1)].clone();
            }
        };
        format!("{number:?}")
    }

    fn deviation(&self) -> Option<f64> {
        match self {
            Self::Normal { deviation, .. } => Some(*deviation),
            Self::LogNormal { median, spread } => Some(median * spread),
            Self::Uniform { low, high } => Some((high - low) / libm::sqrt(12.0)),
            Self::Choice(_) => None,
        }
    }

    fn nodes(&self, count: usize) -> Vec<Node> {
        if self.deviation() == Some(0.0) {
            return vec![Node { at: 0.0, weight: 1.0, value: self.at(0.5) }];
        }
        let weight = match self {
            Self::Normal { .. } | Self::LogNormal { .. } => Weight::Normal,
            Self::Uniform { .. } => Weight::Even,
            Self::Choice(values) => {
                let each = 1.0 / values.len() as f64;
                let node =
                    |(place, value): (usize, &String)| Node { at: place as f64, weight: each, value: value.clone() };
                return values.iter().enumerate().map(node).collect();
            }
        };
        let value = |at: f64| match self {
            Self::Normal { mean, deviation } => mean + deviation * at,
            Self::LogNormal { median, spread } => median * libm::exp(spread * at),
            Self::Uniform { low, high } => low + (high - low) * (0.5 * (at + 1.0)),
            Self::Choice(_) => f64::NAN,
        };
        let node = |[at, weight]: [f64; 2]| Node { at, weight, value: format!("{:?}", value(at)) };
        gauss::rule(weight, count).into_iter().map(node).collect()
    }

    fn place_of(&self, value: &str) -> Option<f64> {
        let number = || value.parse::<f64>().ok();
        match self {
            _ if self.deviation() == Some(0.0) => Some(0.0),
            Self::Normal { mean, deviation } => number().map(|own| (own - mean) / deviation),
            Self::LogNormal { median, spread } => number().map(|own| libm::log(own / median) / spread),
            Self::Uniform { low, high } => number().map(|own| 2.0 * ((own - low) / (high - low)) - 1.0),
            Self::Choice(values) => values.iter().position(|own| own == value).map(|place| place as f64),
        }
    }
}

/// The share of a run, between 0 and 1 without both.
pub(crate) fn share(seed: u64, run: u64, key: &str) -> f64 {
    let digest = Blake2b::<U8>::digest(format!("{seed}\n{run}\n{key}").as_bytes());
    let whole = digest.iter().fold(0_u64, |whole, byte| (whole << 8) | u64::from(*byte));
    ((whole >> (u64::BITS - BITS)) as f64 + 0.5) / (1_u64 << BITS) as f64
}

/// The two numbers of a distribution.
fn numbers(name: &str, arguments: &[String]) -> Result<[f64; 2], SweepError> {
    let all: Option<Vec<f64>> = arguments.iter().map(|own| own.parse().ok()).collect();
    all.and_then(|all| all.try_into().ok()).ok_or_else(|| {
        SweepError::Vary(format!("{name}({}): two numbers are needed; accepted: {ACCEPTED}", arguments.join(", ")))
    })
}

/// Quotients of polynomials in the middle, near the ends, and at the ends (Wichura 1988); from the highest power down.
const MIDDLE: [[f64; 8]; 2] = [
    [
        2.509_080_928_730_122_6e3,
        3.343_057_558_358_813e4,
        6.726_577_092_700_87e4,
        4.592_195_393_154_987e4,
        1.373_169_376_550_946e4,
        1.971_590_950_306_551_3e3,
        1.331_416_678_917_843_8e2,
        3.387_132_872_796_366_5,
    ],
    [
        5.226_495_278_852_854e3,
        2.872_908_573_572_194_3e4,
        3.930_789_580_009_271e4,
        2.121_379_430_158_659_7e4,
        5.394_196_021_424_751e3,
        6.871_870_074_920_579e2,
        4.231_333_070_160_091e1,
        1.0,
    ],
];
const NEAR: [[f64; 8]; 2] = [
    [
        7.745_450_142_783_414e-4,
        2.272_384_498_926_918_4e-2,
        2.417_807_251_774_506e-1,
        1.270_458_252_452_368_4,
        3.647_848_324_763_204_5,
        5.769_497_221_460_691,
        4.630_337_846_156_546,
        1.423_437_110_749_683_5,
    ],
    [
        1.050_750_071_644_416_9e-9,
        5.475_938_084_995_345e-4,
        1.519_866_656_361_645_7e-2,
        1.481_039_764_274_800_8e-1,
        6.897_673_349_851e-1,
        1.676_384_830_183_803_8,
        2.053_191_626_637_759,
        1.0,
    ],
];
const FAR: [[f64; 8]; 2] = [
    [
        2.010_334_399_292_288_1e-7,
        2.711_555_568_743_487_6e-5,
        1.242_660_947_388_078_4e-3,
        2.653_218_952_657_612_4e-2,
        2.965_605_718_285_049e-1,
        1.784_826_539_917_291_3,
        5.463_784_911_164_114,
        6.657_904_643_501_103,
    ],
    [
        2.044_263_103_389_939_8e-15,
        1.421_511_758_316_446e-7,
        1.846_318_317_510_054_8e-5,
        7.868_691_311_456_133e-4,
        1.487_536_129_085_061_5e-2,
        1.369_298_809_227_358e-1,
        5.998_322_065_558_88e-1,
        1.0,
    ],
];

/// The number of standard deviations below which a share of a normal distribution lies.
fn inverse_normal(share: f64) -> f64 {
    let quotient = |[over, under]: &[[f64; 8]; 2], x: f64| {
        let value = |all: &[f64; 8]| all.iter().fold(0.0, |sum, own| sum * x + own);
        value(over) / value(under)
    };
    let q = share - 0.5;
    if q.abs() <= 0.425 {
        return q * quotient(&MIDDLE, 0.180_625 - q * q);
    }
    let r = libm::sqrt(-libm::log(share.min(1.0 - share)));
    let size = if r <= 5.0 { quotient(&NEAR, r - 1.6) } else { quotient(&FAR, r - 5.0) };
    if q < 0.0 { -size } else { size }
}

#[cfg(test)]
mod tests {
    //! The inverse of the normal distribution is that of tables, and symmetric; shares are those of Python's library.
    use super::*;

    #[test]
    fn the_inverse_of_the_normal_distribution() {
        // Abramowitz and Stegun 26.2; beyond them by arithmetic of 30 digits.
        for (share, deviations) in [
            (0.5, 0.0),
            (0.975, 1.959_963_984_540_054_2),
            (0.841_344_746_068_542_9, 1.0),
            (1e-3, -3.090_232_306_167_813_5),
            (1e-12, -7.034_483_825_301_132),
        ] {
            let error = inverse_normal(share) - deviations;
            assert!(error.abs() <= 4e-15 * deviations.abs(), "{share}: {error:e}");
        }
        for k in 1..100 {
            let share = f64::from(k) / 128.0;
            assert_eq!(inverse_normal(share), -inverse_normal(1.0 - share), "{share}");
        }
    }

    /// The same seed, run and key give what the module for Python draws.
    #[test]
    fn draws_depend_on_seed_run_and_key() {
        let of = |seed, run, key| share(seed, run, key);
        assert_eq!(of(1, 7, "a"), 0.226_977_463_168_971_5);
        assert!(of(1, 7, "a") != of(2, 7, "a") && of(1, 7, "a") != of(1, 8, "a") && of(1, 7, "a") != of(1, 7, "b"));
        let mean = (0..4000).map(|run| of(3, run, "bodies.a.mass")).sum::<f64>() / 4000.0;
        assert!((mean - 0.5).abs() < 4.0 * 0.289 / 63.2, "{mean}");
    }
}
