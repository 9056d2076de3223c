//! What was measured of one engine in one scene.

use super::judge::{Depths, Moved, Verdict};
use super::scenes::Scene;

/// What was measured.
#[derive(Debug, Clone, Default)]
pub(crate) struct Measured {
    /// To prepare the run, s.
    pub(crate) start: f64,
    /// Of the steps, s.
    pub(crate) times: Vec<f64>,
    /// The deepest overlap, m.
    pub(crate) penetration: f64,
    /// From the start, of the body that moved farthest, m.
    pub(crate) drift: f64,
    pub(crate) residuals: Vec<f64>,
    pub(crate) contacts: usize,
    /// The upward impulse of half-spaces over the weight in the last step judged.
    pub(crate) carried: f64,
    /// In each step.
    pub(crate) factorisations: Vec<f64>,
}

impl Measured {
    /// A quantile of the times of its steps, ms.
    pub(crate) fn milliseconds(&self, part: f64) -> f64 {
        quantile(&self.times, part) * 1e3
    }

    pub(crate) fn residual(&self, part: f64) -> f64 {
        quantile(&self.residuals, part)
    }

    pub(crate) fn factorisations(&self, part: f64) -> f64 {
        quantile(&self.factorisations, part)
    }

    /// Looks at the bodies after a step, and at what its contacts did.
    pub(crate) fn look(&mut self, scene: &Scene, depths: &mut Depths, bodies: &[Moved], verdict: Verdict) {
        self.penetration = self.penetration.max(depths.deepest(scene, bodies));
        self.residuals.push(verdict.residual);
        (self.contacts, self.carried) = (verdict.contacts, verdict.carried);
        let moved = bodies.iter().zip(&scene.members);
        self.drift =
            moved.map(|(body, from)| from.pose.translation.distance(body.pose.translation)).fold(0.0, f64::max);
    }
}

/// The least value that this part of all does not exceed.
pub(crate) fn quantile(values: &[f64], part: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let place = (part * sorted.len() as f64).ceil() as usize;
    sorted.get(place.saturating_sub(1)).copied().unwrap_or(f64::NAN)
}
