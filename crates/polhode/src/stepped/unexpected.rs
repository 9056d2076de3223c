//! Pairs of bodies that met within a step although they were not expected to.
//!
//! The pairs of a step are those whose boxes overlap, enlarged by twice the way that each body makes by itself
//! ([`travel_of`]). A body that a faster one strikes goes farther, and may meet one beyond that. Such bodies are known
//! after the step: those that went out of their boxes. Where one of them overlaps a body at the end that it was no pair
//! with, the step is made again with that pair.

use super::islands::{Island, IslandSearch, travel_of};
use crate::model::{Model, prescribed};
use crate::solve::overlap::{Overlaps, displacement};
use crate::time_stepping::{SHARE_OF_SIZE, drift};
use polhode_contact::{Aabb, BroadPhaseError, swept_aabb};
use polhode_dynamics::BodyState;
use polhode_spatial::Still;

/// A step that has been made.
pub(super) struct Unexpected<'a> {
    /// The states of all bodies at its start.
    pub(super) begin: &'a [BodyState],
    /// Those at its end, of the bodies of islands.
    pub(super) end: &'a [BodyState],
    pub(super) islands: &'a [Island],
    /// The pairs that were expected to touch, ascending.
    pub(super) pairs: &'a [(usize, usize)],
    pub(super) interval: (f64, f64),
}

impl Unexpected<'_> {
    /// The pairs that overlap at its end and were not expected to.
    ///
    /// # Errors
    /// When there are more bodies than the broad phase can number.
    pub(super) fn find(
        &self,
        model: &Model,
        search: &mut IslandSearch,
    ) -> Result<Vec<(usize, usize)>, BroadPhaseError> {
        let (t, h) = self.interval;
        let mut is_out = vec![false; model.bodies.len()];
        let mut in_island = vec![false; model.bodies.len()];
        for &body in self.islands.iter().flat_map(|island| &island.bodies) {
            in_island[body] = true;
            let way = displacement(model, body, &self.begin[body], &self.end[body]);
            is_out[body] = model.bodies[body].shape.is_some() && way > travel_of(model, self.begin, body, h);
        }
        if !is_out.contains(&true) {
            return Ok(Vec::new());
        }
        let mut end = self.end.to_vec();
        for &body in model.movable.iter().filter(|&&body| !in_island[body] && model.bodies[body].moves()) {
            end[body] = drift(model, body, &self.begin[body], h);
        }
        prescribed::prescribe(model, t + h, &mut end);
        let of = |body: usize| {
            let shape = model.bodies[body].shape.as_ref();
            let swept = shape.and_then(|shape| swept_aabb(shape, &Still(end[body].pose), 0.0, 0.0).ok());
            swept.unwrap_or(Aabb::UNBOUNDED)
        };
        let mut pairs = search.pairs_of_boxes(model, of)?;
        pairs.retain(|pair| (is_out[pair.0] || is_out[pair.1]) && self.pairs.binary_search(pair).is_err());
        let overlaps = |&(a, b): &(usize, usize)| {
            !Overlaps::find(model, &end, &[(a, b)]).deeper_than(model, &end, SHARE_OF_SIZE).is_empty()
        };
        pairs.retain(overlaps);
        Ok(pairs)
    }
}
