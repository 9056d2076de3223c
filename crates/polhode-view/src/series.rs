//! Quantities over time, one value a frame.

use crate::penetration::Penetration;
use crate::text;
use polhode::Frame;
use serde_json::{Value, json};

/// Group, name and unit of each quantity, in the order of [`values`].
const QUANTITIES: [(&str, &str, &str); 13] = [
    ("energy", "kinetic", "J"),
    ("energy", "potential", "J"),
    ("energy", "total", "J"),
    ("ledger", "impact", "J"),
    ("ledger", "friction", "J"),
    ("ledger", "rest", "J"),
    ("ledger", "damping", "J"),
    ("ledger", "external", "J"),
    ("ledger", "projection", "J"),
    ("ledger", "numerical", "J"),
    ("penetration", "deepest so far", "m"),
    ("residual", "largest so far", ""),
    ("steps", "mean step", "s"),
];

/// The quantities of a run.
#[derive(Debug, Default)]
pub struct Series {
    values: Vec<Vec<f64>>,
    penetration: Penetration,
    last: Option<(f64, u64)>,
}

impl Series {
    /// Adds those of a frame.
    pub fn add(&mut self, frame: &Frame) {
        let mean_step = match self.last {
            Some((t, steps)) if frame.steps > steps => (frame.t_s - t) / (frame.steps - steps) as f64,
            _ => f64::NAN,
        };
        self.last = Some((frame.t_s, frame.steps));
        self.values.resize_with(QUANTITIES.len(), Vec::new);
        let deepest_m = self.penetration.of(frame).largest_m;
        for (list, value) in self.values.iter_mut().zip(values(frame, deepest_m, mean_step)) {
            list.push(value);
        }
    }

    /// As a page has them. Those that show nothing are left out: fewer than two numbers, which make no line, and those
    /// that are zero throughout, but for energies.
    pub fn json(&self) -> Value {
        let list = QUANTITIES.iter().zip(&self.values);
        let has_line = |values: &[f64]| values.iter().filter(|value| value.is_finite()).nth(1).is_some();
        let seen = list.filter(|((group, ..), values)| {
            *group == "energy" || (has_line(values) && values.iter().any(|&value| value != 0.0))
        });
        let one = |((group, name, unit), values): (&(&str, &str, &str), &Vec<f64>)| {
            json!({
                "group": group, "name": name, "unit": unit, "values": text::base64_f64(values)
            })
        };
        Value::Array(seen.map(one).collect())
    }
}

fn values(frame: &Frame, deepest_m: f64, mean_step: f64) -> [f64; QUANTITIES.len()] {
    let (energy, ledger, certificate) = (&frame.energy, &frame.ledger, &frame.certificate);
    [
        energy.kinetic_j,
        energy.potential_j,
        energy.final_j,
        ledger.impact.value(),
        ledger.friction.value(),
        ledger.rest.value(),
        ledger.damping.value(),
        ledger.external.value(),
        ledger.projection.value(),
        ledger.numerical.value(),
        deepest_m,
        certificate.max_residual,
        mean_step,
    ]
}
