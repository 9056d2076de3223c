//! Everything as one JSON object.

use crate::options::Counting;
use crate::reference::Reference;
use crate::study::{Entry, Study};
use polhode_scene::Override;
use serde_json::{Map, Value, json};

/// The study, and which candidate reaches the target when one is asked for.
pub fn value(study: &Study, target: Option<f64>) -> Value {
    let counting = match study.counting {
        Counting::Time => "time_ratio",
        Counting::Instructions => "instructions",
    };
    let mut value = json!({
        "scene": study.scene,
        "duration_s": study.duration_s,
        "samples": study.samples,
        "cost": counting,
        "base": study.base_name(),
        "references": (0..study.references.len()).map(|number| reference(study, number)).collect::<Vec<_>>(),
        "candidates": study.entries.iter().map(|entry| candidate(study, entry)).collect::<Vec<_>>(),
    });
    if let Some(target) = target {
        let cheapest = study.cheapest(target);
        let found = cheapest.map(|entry| {
            json!({
                "name": entry.candidate.name(),
                "toml": entry.candidate.toml(),
                "changes": changes(&entry.candidate.changes),
                "known_error": study.known_error(entry),
            })
        });
        let ties: Vec<String> = study.ties(target).iter().map(|entry| entry.candidate.name()).collect();
        value["target"] = json!({ "error": target, "cheapest": found, "ties": ties });
    }
    value
}

fn reference(study: &Study, number: usize) -> Value {
    let reference: &Reference = &study.references[number];
    let closest = study.closest_other(number);
    let told = |(error, by): &(f64, String)| json!({ "error": error, "by": by });
    json!({
        "kind": reference.kind.word(),
        "method": reference.method,
        "model": changes(&reference.model),
        "error": reference.error,
        "basis": reference.basis,
        "confirmed": closest.as_ref().filter(|(error, _)| crate::study::confirms(*error)).map(told),
        "closest_other": closest.as_ref().map(told),
        "length_m": reference.scales.length_m,
        "length_is": reference.scales.length_is,
        "speed_m_s": reference.scales.speed_m_s,
    })
}

fn candidate(study: &Study, entry: &Entry) -> Value {
    let mut value = json!({
        "method": entry.candidate.series,
        "setting": entry.candidate.rung,
        "changes": changes(&entry.candidate.changes),
        "reference": entry.reference,
    });
    match &entry.outcome {
        Ok(measured) => {
            let errors = &measured.errors;
            value["error"] = json!(errors.headline());
            // Below this nothing is known: it is the error of the reference.
            value["known_error"] = json!(study.known_error(entry));
            value["estimated_error"] = json!(measured.estimated);
            value["law"] = json!(measured.law.map(|other| other.law.name()));
            value["law_difference"] = json!(measured.law.map(|other| other.difference));
            value["position_error"] = json!(errors.position);
            value["attitude_error_rad"] = json!(errors.attitude);
            let [millimetres, degrees] = study.errors_in_units(entry, errors);
            value["position_error_mm"] = json!(millimetres);
            value["attitude_error_deg"] = json!(degrees);
            value["final_position_error"] = json!(errors.final_position);
            value["final_attitude_error_rad"] = json!(errors.final_attitude);
            value["final_velocity_error"] = json!(errors.final_velocity);
            value["energy_error"] = json!(measured.energy_error);
            value["time_ratio"] = json!(measured.timing.ratio);
            value["time_ratio_spread"] = json!(measured.timing.spread);
            value["us_per_simulated_s"] = json!(study.microseconds(measured));
            value["time_s"] = json!(measured.timing.seconds);
            value["rounds"] = json!(measured.timing.rounds);
            value["instructions"] = json!(measured.instructions);
            value["steps"] = json!(measured.steps);
            value["pareto"] = json!(measured.on_front);
        }
        Err(reason) => value["failure"] = json!(reason),
    }
    value
}

fn changes(changes: &[Override]) -> Map<String, Value> {
    changes.iter().map(|change| (change.key.clone(), json!(change.value))).collect()
}
