//! The first instant: what touches, and that nothing overlaps.

use super::engine::Engine;
use super::impact_search::swept_box;
use super::projection;
use crate::SimulationError;
use crate::interaction::contact_set::{Hold, Touch};
use crate::interaction::groups::groups;
use crate::scene::SceneError;
use crate::world::INITIAL_OVERLAP_RELATIVE;
use polhode_spatial::Still;

impl Engine {
    /// Finds what touches at the start and moves out of each other what overlaps within touch.
    ///
    /// # Errors
    /// When two bodies overlap by more than touch.
    pub(super) fn find_initial_contacts(&mut self) -> Result<(), SimulationError> {
        for body in 0..self.world.bodies.len() {
            self.take_off(body);
            self.speed_scale = self.speed_scale.max(self.speed(body));
            let gravity_speed = (self.world.gravity().length() * self.world.bodies[body].size).sqrt();
            self.speed_scale = self.speed_scale.max(gravity_speed);
        }
        for (a, b) in self.initial_pairs()? {
            let touch_distance = self.world.touch_distance(&self.states, a, b);
            let contacts = self.world.contacts_of_pair(&self.states, a, b, touch_distance);
            self.check_overlap(a, b, &contacts)?;
            self.touches.extend(contacts);
        }
        self.touches.sort_by_key(|touch| touch.id);
        self.separate_overlaps()?;
        for i in 0..self.touches.len() {
            // Every contact that lasts is a first guess for a contact that holds.
            if self.is_sustained(&self.touches[i]) {
                self.touches[i].hold = Hold::Held;
            }
        }
        Ok(())
    }

    /// Pairs whose boxes meet, within the overlap that counts as touch.
    fn initial_pairs(&mut self) -> Result<Vec<(usize, usize)>, SimulationError> {
        let mut colliders = Vec::new();
        let mut boxes = Vec::new();
        for (body, (world_body, state)) in self.world.bodies.iter().zip(&self.states).enumerate() {
            if let Some(shape) = &world_body.shape {
                let margin = self.world.touch_distance(&self.states, body, body);
                colliders.push(body);
                boxes.push(swept_box(shape, &Still(state.pose), (0.0, 0.0), margin));
            }
        }
        self.broad_phase.pairs(&boxes, &mut self.box_pairs).map_err(SimulationError::BroadPhase)?;
        let mut pairs: Vec<_> = self
            .box_pairs
            .iter()
            .map(|&(i, j)| (colliders[i as usize], colliders[j as usize]))
            .map(|(a, b)| (a.min(b), a.max(b)))
            .filter(|&(a, b)| self.world.scene.may_collide(a, b))
            .collect();
        pairs.sort_unstable();
        Ok(pairs)
    }

    fn check_overlap(&self, a: usize, b: usize, contacts: &[Touch]) -> Result<(), SimulationError> {
        let Some((shape_a, shape_b)) = self.world.shapes(a, b) else { return Ok(()) };
        let separation = polhode_contact::separation(shape_a, &self.states[a].pose, shape_b, &self.states[b].pose);
        let deepest = contacts.iter().fold(separation, |s, touch| s.min(touch.kinematics.geometry.separation));
        let allowed_m = INITIAL_OVERLAP_RELATIVE * self.world.pair_size(a, b) + self.world.rounding(&self.states, a, b);
        if separation < -allowed_m {
            return Err(SceneError::InitialOverlap {
                body_a: self.world.bodies[a].name.clone(),
                body_b: self.world.bodies[b].name.clone(),
                depth_m: -deepest.min(separation),
                allowed_m,
            }
            .into());
        }
        Ok(())
    }

    /// Moves bodies that overlap within touch until they just touch, and says so.
    fn separate_overlaps(&mut self) -> Result<(), SimulationError> {
        let overlapping = |touch: &Touch| {
            touch.kinematics.geometry.separation < -self.world.rounding(&self.states, touch.id.a, touch.id.b)
        };
        let deepest = self
            .touches
            .iter()
            .filter(|touch| overlapping(touch))
            .fold(0.0f64, |depth, touch| depth.max(-touch.kinematics.geometry.separation));
        if deepest == 0.0 {
            return Ok(());
        }
        self.warn(&format!("bodies overlapped by up to {deepest:e} m at the start, within touch: moved apart"));
        let all = self.touches.iter().enumerate().map(|(i, touch)| (i, touch.id.a, touch.id.b));
        for group in groups(&self.world, all) {
            let ids: Vec<_> = group.contacts.iter().map(|&i| self.touches[i].id).collect();
            let before = self.books.balance(&self.world, &self.states, &group.bodies);
            projection::project_positions(&self.world, &mut self.states, &group.bodies, &ids)
                .map_err(|source| self.response_error(source))?;
            let after = self.books.balance(&self.world, &self.states, &group.bodies);
            self.books.projection(before, after);
        }
        for body in 0..self.world.bodies.len() {
            self.take_off(body);
        }
        self.refresh_kinematics();
        Ok(())
    }
}
