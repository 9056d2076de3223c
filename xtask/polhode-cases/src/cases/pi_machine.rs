//! Galperin's pi machine: two balls and a wall count the digits of pi. No collision may be missed or merged.

use super::bodies::{ball_on_x, bouncy, half_space};
use super::{CaseResult, Context};
use glam::DVec3;
use polhode::spatial::UnitVector;
use polhode::{BodySample, Event, EventKind, Observer, Scene, Simulation};
use std::error::Error;

/// Collisions for mass ratios 100^N, N = 0 to 4.
pub(super) fn im_06(context: &Context) -> CaseResult {
    let mut counts = Vec::new();
    for n in 0..=4 {
        counts.push(collisions(100f64.powi(n))? as f64);
    }
    Ok(vec![context.reference.row("IM-06", "collisions N=0..4", counts)?])
}

/// Counts impacts and keeps nothing else.
#[derive(Debug, Default)]
struct ImpactCounter(u64);

impl Observer for ImpactCounter {
    fn sample(&mut self, _t: f64, _bodies: &[BodySample]) {}

    fn event(&mut self, event: &Event) {
        self.0 += u64::from(event.kind == EventKind::Impact);
    }
}

/// A heavy ball comes at 1 m/s towards a light one at rest before a wall; all collisions are over long before 20 s.
fn collisions(mass_ratio: f64) -> Result<u64, Box<dyn Error>> {
    let scene = Scene::builder("pi machine")
        .gravity(DVec3::ZERO)
        .body(half_space("wall", UnitVector::X).material(bouncy(1.0)?))
        .body(ball_on_x("light", 0.5, 1.0, 2.0, 0.0)?.material(bouncy(1.0)?))
        .body(ball_on_x("heavy", 0.5, mass_ratio, 4.0, -1.0)?.material(bouncy(1.0)?))
        .duration_s(20.0)
        .output_interval_s(20.0)
        .build()?;
    let mut counter = ImpactCounter::default();
    Simulation::new(&scene)?.run_observed(&mut counter)?;
    Ok(counter.0)
}
