//! A measure over many runs: mean, standard deviation and quantiles, and the shares of outcomes.

/// Shares of runs whose quantiles are told.
const QUANTILES: [f64; 3] = [0.05, 0.5, 0.95];

/// A measure over all runs that have it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Band {
    /// How many runs have it.
    pub count: u64,
    /// Their mean.
    pub mean: f64,
    /// Standard error of the mean; none of one run.
    pub standard_error: Option<f64>,
    /// Standard deviation of the runs; none of one run.
    pub deviation: Option<f64>,
    /// The values below which 5, 50 and 95 % of the runs lie, between runs by a line.
    pub quantiles: [f64; 3],
    /// The smallest value.
    pub least: f64,
    /// The largest value.
    pub most: f64,
}

impl Band {
    /// Of these values, of which those that are not known are left out; none where none is left.
    pub fn of(values: &[f64]) -> Option<Self> {
        let mut known: Vec<f64> = values.iter().copied().filter(|value| !value.is_nan()).collect();
        known.sort_by(f64::total_cmp);
        let (least, most) = (*known.first()?, *known.last()?);
        let (mut mean, mut squares) = (0.0, 0.0);
        // In the order of the runs (Welford 1962).
        for (before, value) in values.iter().filter(|value| !value.is_nan()).enumerate() {
            let from_mean = value - mean;
            mean += from_mean / (before + 1) as f64;
            squares += from_mean * (value - mean);
        }
        let count = known.len() as f64;
        let variance = (known.len() > 1).then(|| squares / (count - 1.0));
        let quantile = |share: f64| {
            let place = share * (count - 1.0);
            let below = known[place as usize];
            let above = known[(place as usize + 1).min(known.len() - 1)];
            below + (above - below) * place.fract()
        };
        Some(Self {
            count: known.len() as u64,
            mean,
            standard_error: variance.map(|own| libm::sqrt(own / count)),
            deviation: variance.map(libm::sqrt),
            quantiles: QUANTILES.map(quantile),
            least,
            most,
        })
    }
}

/// How often runs ended in one way.
#[derive(Debug, Clone, PartialEq)]
pub struct Share {
    /// How they ended.
    pub outcome: String,
    /// How many.
    pub count: u64,
    /// Of all runs.
    pub share: f64,
    /// The standard error of the share, `sqrt(p (1 - p) / n)`.
    pub standard_error: f64,
}

impl Share {
    pub(super) fn new(outcome: &str, count: u64, all: u64) -> Self {
        let share = count as f64 / all as f64;
        let standard_error = libm::sqrt(share * (1.0 - share) / all as f64);
        Self { outcome: outcome.to_owned(), count, share, standard_error }
    }
}

#[cfg(test)]
mod tests {
    //! Quantiles are those of numpy, and what is not known is left out.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;

    #[test]
    fn a_band_of_a_few_numbers() {
        let band = Band::of(&[4.0, 1.0, f64::NAN, 3.0, 2.0]).unwrap();
        assert_eq!((band.count, band.mean, band.least, band.most), (4, 2.5, 1.0, 4.0));
        let off = band.quantiles.iter().zip([1.15, 2.5, 3.85]).map(|(own, exact)| (own - exact).abs());
        assert!(off.fold(0.0, f64::max) < 1e-15, "{:?}", band.quantiles);
        assert!((band.deviation.unwrap() - (5.0_f64 / 3.0).sqrt()).abs() < 1e-15);
        assert_eq!(Band::of(&[f64::NAN]), None);
        assert_eq!(Band::of(&[1.0]).unwrap().deviation, None);
    }
}
