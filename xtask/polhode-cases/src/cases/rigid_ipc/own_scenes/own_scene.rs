//! A scene in the format of the suite.

use serde_json::{Value, json};

/// A scene in the suite's format.
pub(crate) struct OwnScene {
    pub name: &'static str,
    pub document: Value,
}

impl OwnScene {
    /// With samples every 0.01 s, and without restitution.
    pub(super) fn new(name: &'static str, duration_s: f64, gravity: f64, bodies: &Value) -> Self {
        let document = json!({
            "scene_type": "distance_barrier_rb_problem",
            "timestep": 0.01,
            "max_time": duration_s,
            "rigid_body_problem": { "coefficient_restitution": -1, "gravity": [0, -gravity, 0], "rigid_bodies": bodies }
        });
        Self { name, document }
    }

    /// With samples this often, s: where bodies are fast or turn fast, the way between two samples is not straight.
    pub(super) fn with_samples_every(mut self, interval_s: f64) -> Self {
        self.document["timestep"] = json!(interval_s);
        self
    }

    /// With this restitution of all contacts.
    pub(super) fn with_restitution(mut self, restitution: f64) -> Self {
        self.document["rigid_body_problem"]["coefficient_restitution"] = json!(restitution);
        self
    }
}
