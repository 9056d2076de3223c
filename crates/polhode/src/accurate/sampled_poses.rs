//! Poses of samples within the steps of islands.
//!
//! The dense output of an integrator is of lower order than its step: between the ends of a step, bodies in contact may
//! overlap by more than they do at its ends. Where they do, the sampled poses are
//! projected onto touch, by the smallest displacement in the metric of mass. The step, and the states from which the
//! run continues, stay as they are.

use super::island::Step;
use super::motions::Motions;
use crate::error::SimulationError;
use crate::solve::overlap::Overlaps;
use crate::tier::core::Core;
use polhode_dynamics::BodyState;
use std::collections::BTreeSet;
use std::sync::Arc;

impl Motions {
    /// These states at `t` (s), with the bodies of integrated islands moved out of each other where they overlap by
    /// more than a step leaves.
    ///
    /// # Errors
    /// When the overlaps cannot be measured or removed.
    pub(super) fn kept_apart(
        &self,
        core: &mut Core,
        t: f64,
        states: Arc<Vec<BodyState>>,
    ) -> Result<Arc<Vec<BodyState>>, SimulationError> {
        let overlaps = core.overlaps_of(t, &states)?.to_vec();
        let deep = overlaps.iter().filter(|overlap| core.overlaps_beyond_aim(overlap));
        let deep: Vec<(usize, usize)> = deep.map(|overlap| overlap.pair).collect();
        if deep.is_empty() {
            return Ok(states);
        }
        let mut apart = states.to_vec();
        for island in self.islands.values().filter(|island| island.t < t) {
            let Step::Constrained(step) = &island.step else { continue };
            let is_member = |body: usize| island.bodies.binary_search(&body).is_ok();
            let stays = |body: usize| is_member(body) || !core.model.bodies[body].moves();
            let overlaps =
                deep.iter().copied().filter(|&(a, b)| (is_member(a) || is_member(b)) && stays(a) && stays(b));
            let overlaps: BTreeSet<(usize, usize)> = overlaps.collect();
            if overlaps.is_empty() {
                continue;
            }
            let pairs: Vec<(usize, usize)> = overlaps
                .into_iter()
                .chain(step.watched_pairs(&core.model))
                .collect::<BTreeSet<_>>()
                .into_iter()
                .collect();
            let found = Overlaps::find(&core.model, &apart, &pairs);
            let problem = &mut core.memory;
            found
                .remove(&core.model, &mut apart, (&island.bodies, &pairs), problem)
                .map_err(|source| SimulationError::of_response(t, source))?;
        }
        Ok(Arc::new(apart))
    }
}
