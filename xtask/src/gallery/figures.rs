//! What a run took and how exact it was, in words and few digits.

use super::shown::Shown;
use polhode::Outcome;
use polhode_scene::names;

/// Figures of a run: what each is, and its value with unit; energies are fractions of the largest of the run.
pub(super) fn figures(shown: &Shown) -> Vec<(&'static str, String)> {
    let (run, report) = (&shown.run, &shown.run.report);
    let ledger = &report.ledger;
    let energy = |joule: f64| if joule == 0.0 { "0".to_owned() } else { format!("{:.1e}", joule / ledger.scale_j) };
    let ended = if report.outcome == Outcome::Degraded { ", degraded" } else { "" };
    vec![
        ("Method", format!("{}, {}", names::tier(report.plan.tier), report.plan.response.name())),
        ("Simulated", format!("{} s in {} steps{ended}", short(report.simulated_s), report.steps)),
        ("Run time", format!("{:.3} s", run.wall_s)),
        ("Energy lost by the method", energy(ledger.numerical.value())),
        ("Energy taken by projection", energy(ledger.projection.value())),
        ("Deepest penetration", length(report.certificate.max_penetration_m)),
    ]
}

/// A number in at most six digits.
fn short(value: f64) -> String {
    let text = format!("{value:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Lengths of at least this are given in millimetres, m.
const MILLIMETRES: f64 = 1e-5;

/// A length, m.
fn length(metres: f64) -> String {
    match metres {
        m if m <= 0.0 => "none".to_owned(),
        m if m < MILLIMETRES => format!("{m:.1e} m"),
        m => format!("{:.2} mm", 1e3 * m),
    }
}

#[cfg(test)]
mod tests {
    //! Lengths are readable from rounding to centimetres.
    use super::*;

    #[test]
    fn lengths() {
        assert_eq!(length(0.0), "none");
        assert_eq!(length(1.2e-16), "1.2e-16 m");
        assert_eq!(length(0.0123), "12.30 mm");
        assert_eq!(short(9952.014050), "9952.014");
        assert_eq!(short(4.0), "4");
    }
}
