//! Penetration of what is written: the separation of all pairs of a sample, measured by the distance of their shapes.
//!
//! The ends of steps are measured where they are made. A sample within a step is another pose, given by the dense output
//! or by a shorter time step, and is measured by itself, against the same promised limit.

use crate::SimulationError;
use crate::accounting::measures::Measure;
use crate::collision::boxes::Boxes;
use crate::core::Core;
use polhode_contact::aabb_of;
use polhode_dynamics::BodyState;

impl Core {
    /// The pairs that overlap in these states at `t` (s), each with the limit that the tier promises for it.
    ///
    /// # Errors
    /// When a box is not finite.
    pub(crate) fn overlaps_of(&self, t: f64, states: &[BodyState]) -> Result<Vec<Measure>, SimulationError> {
        let world = &self.world;
        let mut boxes = Boxes::new(&self.settings, world.bodies.len());
        for (body, own) in world.bodies.iter().enumerate().filter(|(_, own)| !own.removed) {
            boxes.put(body, own.shape.as_ref().and_then(|shape| aabb_of(shape, &states[body].pose).ok()));
        }
        let mut overlaps = Vec::new();
        boxes.all_pairs(world, |a, b| {
            let Some(separation) = world.separation_without_memory(states, a, b) else { return };
            if separation < 0.0 {
                let rate = world.point_speed(states, a) + world.point_speed(states, b);
                let allowed = self.penetration_allowed(t, states, (a, b), rate);
                overlaps.push(Measure { t, pair: (a, b), value: -separation, allowed });
            }
        })?;
        Ok(overlaps)
    }
}
