//! The first instant: finds touching contacts. That no bodies overlap by more has been checked
//! (`crate::run::start_overlap`).

use super::contact_change::ContactChange;
use super::engine::Engine;
use super::instant::Instant;
use super::motions::Mode;
use crate::collision::boxes::Boxes;
use crate::collision::touch::{Hold, Touch};
use crate::collision::{contact_kinematics, contact_set};
use crate::error::SimulationError;
use crate::model::tolerances;
use crate::rows::groups::{coupled_groups, groups};
use crate::scene::few_digits::length;
use crate::solve::projection;
use crate::tier::core::Core;
use polhode_spatial::Still;
use std::collections::{BTreeMap, BTreeSet};

impl Engine {
    /// Finds the touching contacts at the start and removes overlaps within the touch distance.
    ///
    /// # Errors
    /// When contacts within the touch distance cannot be projected.
    pub(super) fn find_initial_contacts(&mut self, core: &mut Core) -> Result<(), SimulationError> {
        for body in 0..self.motions.tracks.len() {
            self.motions.begin_free_motion(core, body, core.t);
            let gravity_speed = (core.model.gravity().length() * core.model.bodies[body].size).sqrt();
            self.motions.tracks[body].speed_scale =
                tolerances::point_speed(&core.model, &self.motions.states, body).max(gravity_speed);
        }
        let mut contacts = Vec::new();
        for (a, b) in self.initial_pairs(core)? {
            let touch_distance = tolerances::touch_distance(&core.model, &self.motions.states, a, b);
            let of_pair = contact_set::contacts_of_pair(&core.model, &self.motions.states, a, b, touch_distance);
            contacts.extend(of_pair.into_iter().map(Touch::from));
        }
        contacts.sort_by_key(|touch| touch.id);
        self.separate_overlaps(core, &mut contacts)?;
        for touch in &mut contacts {
            let scale = self.motions.tracks[touch.id.a].speed_scale.max(self.motions.tracks[touch.id.b].speed_scale);
            // Every contact that neither approaches nor separates is a first guess for an active contact.
            if self.motions.is_sustained(core, scale, touch) {
                touch.hold = Hold::Held;
            }
        }
        for of_pair in contacts.chunk_by(|x, y| (x.id.a, x.id.b) == (y.id.a, y.id.b)) {
            self.schedule.contacts.set((of_pair[0].id.a, of_pair[0].id.b), of_pair.to_vec());
        }
        Ok(())
    }

    /// Resolves the first instant, for each connected group of bodies separately, and begins their motion.
    ///
    /// # Errors
    /// When an impact or the contact forces cannot be solved.
    pub(super) fn resolve_start(&mut self, core: &mut Core) -> Result<(), SimulationError> {
        let movable: Vec<usize> =
            (0..self.motions.tracks.len()).filter(|&body| core.model.bodies[body].moves()).collect();
        let touches: Vec<Touch> = self.schedule.contacts.all().copied().collect();
        let numbered = touches.iter().enumerate().map(|(index, touch)| (index, touch.id.a, touch.id.b));
        let mut firsts = Vec::new();
        for group in coupled_groups(&core.model, numbered, &movable) {
            let own: Vec<Touch> = group.contacts.iter().map(|&i| touches[i]).collect();
            let mut instant = self.start_of(core, group.bodies, own);
            self.resolve(core, &mut instant)?;
            firsts.extend(self.form_islands(core, instant)?);
        }
        if !core.model.prescribed.is_empty() {
            self.schedule.begin_flight_boxes(core, core.t);
        }
        for &body in &core.model.prescribed {
            self.schedule.expect_corner(core, body, core.t);
        }
        let unmoved = |body: &usize| matches!(self.motions.tracks[*body].mode, Mode::Fixed | Mode::Prescribed);
        let unmoved: Vec<usize> = (0..self.motions.tracks.len()).filter(unmoved).collect();
        self.schedule.renew_boxes(core, &self.motions, &unmoved, core.t)?;
        self.look_ahead(core, &movable, &firsts, core.t)
    }

    /// The first instant of some bodies with these contacts.
    fn start_of(&self, core: &Core, bodies: Vec<usize>, touches: Vec<Touch>) -> Instant {
        let mut pairs: Vec<_> = touches.iter().map(|touch| (touch.id.a, touch.id.b)).collect();
        pairs.dedup();
        let speed_scale = bodies.iter().fold(0.0, |most, &body| self.motions.tracks[body].speed_scale.max(most));
        Instant {
            t: core.t,
            bodies,
            pairs,
            touches,
            change: ContactChange::default(),
            woken: BTreeSet::new(),
            rest_times: BTreeMap::new(),
            slip_ends: BTreeMap::new(),
            speed_scale,
        }
    }

    /// Pairs whose boxes, enlarged by the touch distance, overlap.
    fn initial_pairs(&self, core: &Core) -> Result<Vec<(usize, usize)>, SimulationError> {
        let mut boxes = Boxes::new(core.settings.broad_phase, self.motions.states.len());
        for (body, state) in self.motions.states.iter().enumerate() {
            let margin = tolerances::touch_distance(&core.model, &self.motions.states, body, body);
            boxes.set(&core.model, body, &Still(state.pose), (core.t, core.t), margin);
        }
        let mut pairs = Vec::new();
        boxes.all_pairs(&core.model, |a, b| pairs.push((a, b)))?;
        pairs.extend(core.model.joints.joint_contact_pairs());
        Ok(pairs)
    }

    /// Moves bodies that overlap within the touch distance until they just touch, with a warning.
    fn separate_overlaps(&mut self, core: &mut Core, contacts: &mut Vec<Touch>) -> Result<(), SimulationError> {
        let overlapping = |touch: &&Touch| {
            touch.kinematics.geometry.separation
                < -tolerances::rounding(&core.model, &self.motions.states, touch.id.a, touch.id.b)
        };
        let depths = contacts.iter().filter(overlapping).map(|touch| -touch.kinematics.geometry.separation);
        let deepest = depths.fold(0.0f64, f64::max);
        if deepest == 0.0 {
            return Ok(());
        }
        let what = format!(
            "bodies overlapped by up to {} at the start, which counts as touch: they were moved apart",
            length(deepest)
        );
        core.accounts.warn(core.t, what);
        let all: Vec<_> = contacts.iter().enumerate().map(|(i, touch)| (i, touch.id.a, touch.id.b)).collect();
        for group in groups(&core.model, all.into_iter()) {
            let ids: Vec<_> = group.contacts.iter().map(|&i| contacts[i].id).collect();
            let before = core.accounts.books.balance(&core.model, &self.motions.states, &group.bodies);
            let done = projection::project_positions(&core.model, &mut self.motions.states, &group.bodies, &ids)
                .map_err(|source| SimulationError::of_response(core.t, source))?;
            let after = core.accounts.books.balance(&core.model, &self.motions.states, &group.bodies);
            core.book_initial_projection(core.t, &done, (before, after));
        }
        for body in 0..self.motions.tracks.len() {
            self.motions.begin_free_motion(core, body, core.t);
        }
        contacts.retain_mut(|touch| {
            match contact_kinematics::kinematics(&core.model, &self.motions.states, touch.id) {
                Some(kinematics) => {
                    touch.kinematics = kinematics;
                    true
                }
                None => false,
            }
        });
        Ok(())
    }
}
