//! Stretches of crowded events (intervals passed by time steps), each with a number. Those of two islands may overlap
//! in time.

use crate::accounting::time_step_report::TimeStepReport;
use crate::report::run_report::CrowdedStretch;

/// The stretches of a run, in the order in which they began.
#[derive(Debug, Clone, Default)]
pub(crate) struct Stretches(pub(super) Vec<CrowdedStretch>);

impl Stretches {
    /// Begins a stretch of this many bodies at `t` (s) and returns its number. A stretch that ended there is continued.
    pub(crate) fn begin(&mut self, t: f64, bodies: usize) -> usize {
        if let Some(number) = self.0.iter().rposition(|stretch| stretch.to_s == t && stretch.from_s < t) {
            self.0[number].bodies = self.0[number].bodies.max(bodies);
            return number;
        }
        self.0.push(CrowdedStretch { from_s: t, to_s: t, bodies, steps: 0, error: 0.0, max_residual: 0.0 });
        self.0.len() - 1
    }

    /// The length of all stretches, s; where two overlap in time both count.
    pub(crate) fn length_s(&self) -> f64 {
        self.0.iter().map(|stretch| stretch.to_s - stretch.from_s).sum()
    }

    /// The sum of the estimated errors of all time steps, relative to the size of a body.
    pub(crate) fn errors(&self) -> f64 {
        self.0.iter().map(|stretch| stretch.error).sum()
    }

    /// Records a time step of a stretch that ends at `t` (s), with its estimated error. Those of parts of a crowd that
    /// advance side by side add up: their sum is more than the error of any body.
    pub(crate) fn step(&mut self, number: usize, t: f64, report: &TimeStepReport, error: f64) {
        if let Some(stretch) = self.0.get_mut(number) {
            stretch.steps += report.steps;
            stretch.max_residual = stretch.max_residual.max(report.residual);
            stretch.error += error;
            stretch.to_s = stretch.to_s.max(t);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use polhode_spatial::DVec3;

    /// A report of this many steps with this residual.
    fn report(steps: u64, residual: f64) -> TimeStepReport {
        let mut report = TimeStepReport::new(DVec3::ZERO);
        (report.steps, report.residual) = (steps, residual);
        report
    }

    /// The steps of two islands are recorded in separate stretches at the same time; a stretch that continues where it
    /// ended is one stretch.
    #[test]
    fn stretches_side_by_side() {
        let mut stretches = Stretches::default();
        let first = stretches.begin(0.1, 3);
        stretches.step(first, 0.2, &report(1, 1e-9), 1e-7);
        let second = stretches.begin(0.15, 5);
        stretches.step(first, 0.3, &report(2, 1e-10), 2e-7);
        stretches.step(second, 0.25, &report(4, 1e-7), 1e-8);
        assert_eq!(stretches.begin(0.3, 4), first);
        stretches.step(first, 0.35, &report(1, 0.0), 0.0);
        let first =
            CrowdedStretch { from_s: 0.1, to_s: 0.35, bodies: 4, steps: 4, error: 1e-7 + 2e-7, max_residual: 1e-9 };
        let second = CrowdedStretch { from_s: 0.15, to_s: 0.25, bodies: 5, steps: 4, error: 1e-8, max_residual: 1e-7 };
        assert_eq!(stretches.0, [first, second]);
    }
}
