//! The estimated errors of samples, for the observer of a run.
//!
//! A run is compared with its references now and then (`accompany`). A sample between two comparisons has the larger
//! errors of both, one before the first comparison those of the first.

use crate::error_estimate::references::References;
use crate::report::observer::Observer;
use crate::report::run_error::BodyError;
use crate::run::simulation::Simulation;
use crate::scene::ErrorEstimation;

impl Simulation {
    /// Tells the observer the errors of the samples that lie before the last comparison. At the end of the run, and
    /// where nothing is estimated, no later comparison will say more: it is told of all.
    pub(super) fn tell_errors(&mut self, observer: &mut dyn Observer) {
        let References { effort, course, errors_before, .. } = &self.references;
        let is_known = *effort != ErrorEstimation::Off && !course.errors.is_empty();
        let is_over = self.ended || *effort == ErrorEstimation::Off;
        let until_s = match (is_over, is_known) {
            (true, _) => f64::INFINITY,
            (false, true) => course.compared_s,
            (false, false) => return,
        };
        // A body that was added since the comparison before has no errors there.
        let before = |body: usize| errors_before.get(body).copied().unwrap_or_default();
        let larger = || course.errors.iter().enumerate().map(|(body, error)| error.max(before(body))).collect();
        let mut between: Option<Vec<BodyError>> = None;
        while let Some(sample) = self.core.accounts.take_without_errors(until_s) {
            let is_between = sample.t_s < course.compared_s;
            let errors = if is_between { between.get_or_insert_with(larger) } else { &course.errors };
            // Bodies that were added since then were not in it.
            let errors = &errors[..sample.bodies.min(errors.len())];
            observer.errors(sample.t_s, is_known.then_some(errors));
        }
    }
}
