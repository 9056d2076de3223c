//! What pages and plots say of a run: its outcome, its methods, and the report that stands in a page.

use crate::names;
use crate::report::report_json;
use polhode::{Outcome, Plan, RunReport};
use serde_json::Value;

/// The report that stands in a page: without the time that the run took, so that a page has the same bytes every time.
pub fn page_report_json(report: &RunReport) -> Value {
    let mut value = report_json(report, 0.0);
    if let Some(object) = value.as_object_mut() {
        object.remove("wall_s");
    }
    value
}

/// How a page says that a run ended.
pub fn shown_outcome(report: &RunReport) -> String {
    match report.outcome {
        Outcome::Completed => "completed".to_owned(),
        Outcome::Degraded => "degraded".to_owned(),
        Outcome::Stopped => {
            shown_failure(&format!("stopped at t = {} s of {} s", report.simulated_s, report.duration_s))
        }
        other => shown_failure(other.name()),
    }
}

/// How a page says that a run failed.
pub fn shown_failure(message: &str) -> String {
    format!("failed: {}", message.trim_start_matches("error: "))
}

/// The methods of a run, in the line below the title of its plots.
pub fn methods_line(plan: &Plan) -> String {
    let (tier, integrator) = (names::tier(plan.tier), names::integrator(plan.integrator));
    format!(
        "tier {tier}, integrator {integrator}, impact {}, tolerance {:e}",
        names::impact(plan.impact),
        plan.tolerance
    )
}

/// The line below the title of the plots of a run that has ended.
pub fn ended_line(report: &RunReport) -> String {
    let degraded = if report.outcome == Outcome::Degraded { "; degraded, see the report" } else { "" };
    format!("{}{degraded}", methods_line(&report.plan))
}
