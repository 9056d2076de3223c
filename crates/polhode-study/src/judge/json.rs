//! A judgement as one JSON object.

use super::judgement::Judgement;
use super::law::Finding;
use serde_json::{Value, json};

impl Judgement {
    /// All of it.
    pub fn json(&self) -> Value {
        let truth = self.truth.as_ref().map(|own| {
            let at = |own: &super::truth::TruthAt| json!([own.t_s, own.distance_m, own.error_m]);
            json!({
                "columns": ["t", "distance_m", "error_m"],
                "over_time": own.over_time.iter().map(at).collect::<Vec<_>>(),
                "ended": own.ended,
            })
        });
        json!({
            "trajectory": self.trajectory,
            "scene": self.scene,
            "kept": self.is_kept(),
            "broken": self.broken().iter().map(|own| own.law.name()).collect::<Vec<_>>(),
            "tolerance": self.tolerance,
            "from_s": self.span_s[0],
            "to_s": self.span_s[1],
            "samples": self.samples,
            "velocities": self.velocities.words(),
            "velocity_error_m_s": self.velocity_error_m_s,
            "gaps_s": self.gaps_s,
            "cut_off": self.cut_off,
            "energy": {
                "initial_j": self.energy_j[0],
                "final_j": self.energy_j[1],
                "unexplained_j": self.unexplained_energy_j,
            },
            "unexplained_impulse_ns": self.unexplained_impulse_ns,
            "notes": self.notes,
            "laws": self.findings.iter().map(finding).collect::<Vec<_>>(),
            "truth": truth,
        })
    }
}

fn finding(own: &Finding) -> Value {
    let is_seen = own.limit.is_finite();
    json!({
        "law": own.law.name(),
        "is": own.law.value(),
        "unit": own.law.unit(),
        "kept": own.is_kept(),
        "broken": own.broken,
        "first_s": own.first_s,
        "worst": is_seen.then_some(own.worst),
        "limit": is_seen.then_some(own.limit),
        "at_s": is_seen.then_some(own.at_s),
        "bodies": own.bodies,
        "what": own.what,
        "over_time": own.over_time,
    })
}
