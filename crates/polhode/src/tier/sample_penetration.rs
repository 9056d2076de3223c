//! Penetration of what is written: the separation of all pairs of a sample, measured by the distance of their shapes.
//!
//! The ends of steps are measured where they are made. A sample within a step is another pose, given by the dense
//! output or by a shorter time step, and is measured by itself, against the same promised limit. Bodies at rest are
//! measured once: the last measure is kept with its states. It is a cache, and no part of the simulation state.

use crate::accounting::last_sample::LastSample;
use crate::accounting::measures::Measure;
use crate::collision::boxes::Boxes;
use crate::collision::contact_set;
use crate::error::SimulationError;
use crate::model::tolerances;
use crate::tier::core::Core;
use polhode_contact::aabb_of;
use polhode_dynamics::BodyState;

impl Core {
    /// The pairs that overlap in these states at `t` (s), each with the limit that the tier promises for it.
    ///
    /// # Errors
    /// When a box is not finite.
    pub(crate) fn overlaps_of(&mut self, t: f64, states: &[BodyState]) -> Result<&[Measure], SimulationError> {
        let model = &self.model;
        let removed = model.bodies.iter().filter(|own| own.removed).count();
        if self.last_sample.removed == removed && self.last_sample.states == states {
            return Ok(&self.last_sample.overlaps);
        }
        let mut boxes = Boxes::new(self.settings.broad_phase, model.bodies.len());
        for (body, own) in model.bodies.iter().enumerate().filter(|(_, own)| !own.removed) {
            boxes.put(body, own.shape.as_ref().and_then(|shape| aabb_of(shape, &states[body].pose).ok()));
        }
        let mut overlaps = Vec::new();
        boxes.all_pairs(model, |a, b| {
            let Some(separation) = contact_set::separation_without_memory(model, states, a, b) else { return };
            if separation < 0.0 {
                let rate = tolerances::point_speed(model, states, a) + tolerances::point_speed(model, states, b);
                let allowed = self.penetration_allowed(t, states, (a, b), rate);
                overlaps.push(Measure { t, pair: (a, b), value: -separation, allowed });
            }
        })?;
        self.last_sample = LastSample { states: states.to_vec(), removed, overlaps };
        Ok(&self.last_sample.overlaps)
    }
}
