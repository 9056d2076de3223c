//! How far the joints of the shipped scenes are from what they keep, at samples and at least once in a longest step.

use crate::cases::{CaseResult, Context};
use crate::row::Row;

/// What joints may be apart (m; the scenes have sizes of some metres at most) or turned (rad).
const DRIFT: f64 = 1e-12;

/// A row for the displacements and one for the rotations of each scene with joints.
pub(crate) fn drift(context: &Context) -> CaseResult {
    const CASE: &str = "joints of shipped scenes";
    let mut rows = Vec::new();
    for name in context.shipped.names()? {
        if context.shipped.load(&name)?.joints().is_empty() {
            continue;
        }
        match context.shipped.run(&name) {
            Ok(run) => {
                let certificate = &run.report.certificate;
                let errors =
                    [("apart, m", certificate.max_joint_error_m), ("turned, rad", certificate.max_joint_error_rad)];
                for (what, error) in errors {
                    rows.push(Row::at_most(CASE, &format!("{name}: {what}"), DRIFT, error.unwrap_or(f64::NAN)));
                }
            }
            Err(error) => rows.push(Row::broken(CASE, &name, error.to_string())),
        }
    }
    Ok(rows)
}
