//! Leaving out samples that come too often.

/// How much closer than asked for samples may come, as a fraction: times of samples are rounded.
const ROUNDING: f64 = 1e-6;

/// Which samples of a run are shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Thinning {
    least_interval_s: f64,
    last_s: Option<f64>,
}

impl Thinning {
    /// Of samples that come at least this far apart, s, all are shown.
    pub(crate) fn new(least_interval_s: f64) -> Self {
        Self { least_interval_s, last_s: None }
    }

    /// Whether the sample at `t` (s) is shown.
    pub(crate) fn shows(&mut self, t: f64) -> bool {
        let is_due = self.last_s.is_none_or(|last| t - last >= self.least_interval_s * (1.0 - ROUNDING));
        if is_due {
            self.last_s = Some(t);
        }
        is_due
    }
}
