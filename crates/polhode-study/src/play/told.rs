//! What a playground tells of its run: energies that add up, the promise of the tier, the horizon, and the hash.

use super::error::PlayError;
use super::playground::Playground;
use polhode_scene::{broken_json, certificate_json};
use serde_json::{Map, Value, json};

/// The ending of the names of measures that are relative to their limit.
const OF_LIMIT: &str = "_of_limit";

impl Playground {
    /// The report up to the present as one JSON object, without the bodies.
    ///
    /// # Errors
    /// When what holds at present cannot be measured.
    pub fn told_json(&mut self) -> Result<Value, PlayError> {
        let report = self.report()?;
        let (energy, ledger) = (&report.energy, &report.ledger);
        let limits: Map<String, Value> = match certificate_json(&report) {
            Value::Object(all) => all
                .into_iter()
                .filter_map(|(name, value)| {
                    let name = name.strip_suffix(OF_LIMIT)?.trim_start_matches("max_").replace('_', " ");
                    Some((name, value))
                })
                .collect(),
            _ => Map::new(),
        };
        Ok(json!({
            "t": report.simulated_s,
            "duration": report.duration_s,
            "ended": self.has_ended(),
            "tier": report.plan.tier.name(),
            "steps": report.steps,
            "events": report.events,
            "initial_j": energy.initial_j,
            "kinetic_j": energy.kinetic_j,
            "potential_j": energy.potential_j,
            "lost": {
                "impacts": ledger.impact.value(),
                "friction": ledger.friction.value(),
                "rest": ledger.rest.value(),
                "damping": ledger.damping.value(),
                "projection": ledger.projection.value(),
                "numerical": ledger.numerical.value(),
            },
            "external_j": ledger.external.value(),
            "closure_relative": ledger.closure_relative(),
            "scale_j": ledger.scale_j,
            "kept": report.broken.is_empty() && report.outcome != polhode::Outcome::Degraded,
            "broken": broken_json(&report),
            "limits": limits,
            "warnings": report.warnings.iter().take(MOST_WARNINGS).collect::<Vec<_>>(),
            "estimated_error": report.error.relative(),
            "horizon_s": report.error.horizon_s,
            "hash": format!("{:016x}", self.hash().value()),
            "samples": self.hash().samples(),
            "untouched": self.is_untouched(),
        }))
    }
}

/// Warnings that are told (1 to 10): more do not fit beside a picture.
const MOST_WARNINGS: usize = 3;
