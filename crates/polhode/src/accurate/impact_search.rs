//! The first impact within a step: pairs that close on their true motion.
//!
//! Pairs held together by a contact are watched by the location of contact changes; every other pair whose swept
//! boxes meet is searched by conservative advancement, which is never late. So are the parts that are clear of each
//! other of held pairs that are fast: between two looks they could go through each other.

use super::engine::{Engine, Mode};
use super::locate::DIP_SAMPLES;
use super::trial::Trial;
use crate::SimulationError;
use crate::interaction::contact_set::Hold;
use polhode_contact::{Aabb, ImpactSearch, Shape, swept_aabb, time_of_further_impact, time_of_impact};
use polhode_spatial::Motion;
use std::collections::BTreeSet;

/// How far bodies that are held together may go between two looks at them, relative to the smaller of their sizes, before
/// their other parts are searched.
const FAST: f64 = 0.01;

impl Engine {
    /// The time of the first impact of the pairs `near` in `(t, limit]`.
    ///
    /// # Errors
    /// When a search does not end.
    pub(super) fn first_impact(
        &self,
        trial: &Trial,
        near: &[(usize, usize)],
        limit: f64,
    ) -> Result<Option<f64>, SimulationError> {
        let held: BTreeSet<_> = self
            .touches
            .iter()
            .filter(|touch| touch.hold == Hold::Held)
            .map(|touch| (touch.id.a, touch.id.b))
            .collect();
        let mut first = None;
        let mut limit = limit;
        for &(a, b) in near {
            let Some((shape_a, shape_b)) = self.world.shapes(a, b) else { continue };
            let (motion_a, motion_b) = (self.motion_within(trial, a), self.motion_within(trial, b));
            let search = match held.contains(&(a, b)) {
                false => time_of_impact,
                true if self.is_fast([(a, &*motion_a), (b, &*motion_b)], (trial.t, limit)) => time_of_further_impact,
                true => continue,
            };
            let found = search(shape_a, &*motion_a, shape_b, &*motion_b, trial.t, limit, &ImpactSearch::default())
                .map_err(|source| SimulationError::ImpactSearch {
                    t: self.t,
                    body_a: self.world.bodies[a].name.clone(),
                    body_b: self.world.bodies[b].name.clone(),
                    source,
                })?;
            if let Some(t) = found {
                let t = if self.puts_up() && self.is_stall(t) { self.looks_again().min(limit) } else { t };
                limit = t;
                first = Some(t);
            }
        }
        Ok(first)
    }

    /// Whether two bodies go so far between two of the looks by which their contacts are watched that they could go through
    /// each other.
    fn is_fast(&self, bodies: [(usize, &dyn Motion); 2], (start, end): (f64, f64)) -> bool {
        let speed = bodies.map(|(body, motion)| {
            let bounds = motion.bounds(start, end);
            bounds.speed + bounds.angular_speed * self.world.bodies[body].size
        });
        let between = (end - start) / f64::from(DIP_SAMPLES);
        (speed[0] + speed[1]) * between > FAST * self.world.pair_size(bodies[0].0, bodies[1].0)
    }

    /// Pairs that may collide, of which one moves and whose boxes, swept over the step, meet; ascending.
    ///
    /// # Errors
    /// When there are more bodies than the broad phase can number.
    pub(super) fn near_pairs(&mut self, trial: &Trial) -> Result<Vec<(usize, usize)>, SimulationError> {
        let colliders: Vec<usize> =
            (0..self.world.bodies.len()).filter(|&body| self.world.bodies[body].shape.is_some()).collect();
        let motions: Vec<Box<dyn Motion>> = colliders.iter().map(|&body| self.motion_within(trial, body)).collect();
        let boxes: Vec<_> = colliders
            .iter()
            .zip(&motions)
            .filter_map(|(&body, motion)| {
                let shape = self.world.bodies[body].shape.as_ref()?;
                let margin = self.world.touch_distance(&self.states, body, body);
                Some(swept_box(shape, &**motion, (trial.t, trial.end()), margin))
            })
            .collect();
        let moves = |body: usize| matches!(self.modes[body], Mode::Flight(_) | Mode::Constrained | Mode::Stepped);
        self.broad_phase.pairs(&boxes, &mut self.box_pairs).map_err(SimulationError::BroadPhase)?;
        let near = self
            .box_pairs
            .iter()
            .map(|&(i, j)| (colliders[i as usize], colliders[j as usize]))
            .map(|(a, b)| (a.min(b), a.max(b)))
            .filter(|&(a, b)| (moves(a) || moves(b)) && self.world.scene.may_collide(a, b))
            .collect();
        Ok(near)
    }
}

/// Box of a moving shape with a margin. What cannot be bounded may be anywhere: the search itself then says why.
pub(super) fn swept_box(shape: &Shape, motion: &dyn Motion, interval: (f64, f64), margin: f64) -> Aabb {
    swept_aabb(shape, motion, interval.0, interval.1).and_then(|aabb| aabb.inflated(margin)).unwrap_or(Aabb::UNBOUNDED)
}
