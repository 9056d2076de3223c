//! What limits the accuracy of a run, and what to do.
//!
//! Every measure of the certificate is held against its limit, `measured / limit`, and so is the estimated error
//! against the promised one: the largest of these ratios limits the run. Where a limit is exceeded, the worst one does,
//! and its cure is what to do.

use super::words::{about, place};
use crate::text::table::number;
use polhode::{BrokenPromise, ErrorEstimation, Outcome, RunReport};

/// The exceeded limit that is exceeded most; what was not solved at all counts more than any number.
pub(super) fn worst(report: &RunReport) -> Option<&BrokenPromise> {
    let times = |broken: &BrokenPromise| match (broken.value, broken.limit) {
        (Some(value), Some(limit)) => value / limit,
        _ => f64::INFINITY,
    };
    report.broken.iter().reduce(|worst, other| if times(other) > times(worst) { other } else { worst })
}

/// What limits the run: the limit exceeded most; else that which it comes nearest to, with crowded events and what was
/// tolerated.
pub(super) fn limit(report: &RunReport) -> Option<String> {
    if let Some(broken) = worst(report) {
        return Some(exceeded(report, broken));
    }
    let mut parts: Vec<String> = nearest(report).into_iter().collect();
    if !report.crowded.is_empty() {
        let (count, length) = (counted(report.crowded.len() as u64, "stretch", "stretches"), about(report.crowded_s()));
        parts.push(format!("events that crowd, passed by time steps: {count}, {length} s in all"));
    }
    let tolerated = report.certificate.fallbacks;
    if tolerated > 0 {
        let count = counted(tolerated, "fallback or postponed contact", "fallbacks and postponed contacts");
        parts.push(format!("{count}, named below"));
    }
    (!parts.is_empty()).then(|| parts.join("; "))
}

fn counted(count: u64, one: &str, many: &str) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{count} {many}") }
}

/// An exceeded limit, and how many others there are.
fn exceeded(report: &RunReport, broken: &BrokenPromise) -> String {
    let what = if is_estimated_error(report, broken) {
        let times = broken.value.unwrap_or_default() / broken.limit.unwrap_or(f64::NAN);
        format!("the estimated error, {} times what is promised", about(times))
    } else {
        let at = broken.t_s.map_or_else(String::new, |t_s| format!("t = {} s: ", number(t_s)));
        format!("{at}{}", broken.what)
    };
    match report.broken.len() - 1 {
        0 => what,
        1 => format!("{what}; one more limit is exceeded"),
        others => format!("{what}; {others} more limits are exceeded"),
    }
}

/// Whether what is exceeded is the limit of the estimated error, which the lines above have told in full.
fn is_estimated_error(report: &RunReport, broken: &BrokenPromise) -> bool {
    broken.value.is_some() && broken.value == report.error.relative()
}

/// What comes nearest to its limit, where none is exceeded.
fn nearest(report: &RunReport) -> Option<String> {
    let certificate = &report.certificate;
    let error = report.error.relative().map_or(0.0, |error| error / report.plan.promise.error);
    let measures = [
        ("the estimated error", error, None),
        ("an overlap", certificate.max_penetration_of_limit, certificate.max_penetration_at),
        ("an overlap in a sample", certificate.max_sample_penetration_of_limit, certificate.max_sample_penetration_at),
        ("a displacement by projection", certificate.max_projection_of_limit, certificate.max_projection_at),
        ("a gap of a joint", certificate.max_joint_error_of_limit, certificate.max_joint_error_at),
        (
            "a violation of friction's law",
            certificate.max_friction_violation_of_limit,
            certificate.max_friction_violation_at,
        ),
        ("a residual of a contact problem", certificate.max_residual_of_limit, None),
        ("a load that is told", certificate.max_load_defect_of_limit, None),
    ];
    let measured = measures.into_iter().filter(|&(_, of_limit, _)| of_limit > 0.0);
    let (what, of_limit, at) = measured.reduce(|most, other| if other.1 > most.1 { other } else { most })?;
    let at = at.map_or_else(String::new, |at| format!(" ({})", place(report, at)));
    let of_limit = about(of_limit);
    // A warning says why, where the run is degraded for another reason than a limit.
    let kept = if report.outcome == Outcome::Degraded { "" } else { "nothing is beyond its limit; " };
    Some(format!("{kept}closest to it is {what}{at}, at {of_limit} of it"))
}

/// What to do: the cure of the worst limit exceeded, or that of the tier; how an error is estimated that is not known.
pub(super) fn cure(report: &RunReport) -> Option<String> {
    if report.outcome == Outcome::Degraded {
        let cure = worst(report).and_then(|broken| broken.cure.clone());
        return Some(cure.unwrap_or_else(|| report.plan.tier.facts().remedy.to_owned()));
    }
    if report.error.largest.is_some() {
        return None;
    }
    match report.error.estimation {
        ErrorEstimation::Off => Some("--error quick estimates the error".to_owned()),
        ErrorEstimation::Quick => Some("--error full compares with whole runs".to_owned()),
        _ => None,
    }
}
