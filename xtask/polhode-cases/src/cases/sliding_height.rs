//! Sliding bodies do not float.
//!
//! Engines that solve friction as one convex problem (Anitescu; MuJoCo, Drake's SAP) add `mu |u_t|` to the rate of
//! separation: a body that slides at `v` is held at a gap of some `mu v` times a time (the step, or that of their
//! softness). Coulomb's law with Signorini's condition has no such term. A flat box slides at several speeds and
//! coefficients; what is measured is the largest height of its centre above the one at which it touches, and the
//! largest depth below, over all samples. docs/peers.md has the gaps of other engines in the same scene.

use super::rough_plane::Plane;
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::Effects;
use polhode::scene::{Method, Tier};
use std::error::Error;

const CASE: &str = "sliding does not float";
/// A box that does not tip, m.
const SIZE: DVec3 = DVec3::new(1.0, 0.5, 0.1);
/// Rounding of coordinates of a few metres, m.
const ROUNDING_M: f64 = 1e-13;
/// How far the soft contacts of tier `fast` sag, m (docs/contact-methods/fast.md).
const SAG_M: f64 = 1e-3;
/// What falls freely in a step of micro-collisions (1 ms) falls by `g h^2/2`, m.
const FALL_M: f64 = 4.91e-6;

/// Heights above and depths below touch, m.
#[derive(Debug, Default)]
struct Heights {
    above: f64,
    below: f64,
}

fn heights(tier: Tier, friction: f64, speed: f64) -> Result<Heights, Box<dyn Error>> {
    let body = Plane::LEVEL.lying_box(SIZE, 0.0, DVec3::X * speed)?;
    let method = Method { tier: Some(tier), ..Method::default() };
    let scene = Plane::LEVEL.with(body, friction)?.method(method).duration_s(0.5).output_interval_s(0.01).build()?;
    let run = Run::of(&scene, Effects::Planned)?;
    let mut found = Heights::default();
    for sample in run.record.samples.iter().filter_map(|row| row.first()) {
        let height = sample.pose.translation.z - 0.5 * SIZE.z;
        found.above = if height.is_nan() { f64::INFINITY } else { found.above.max(height) };
        found.below = found.below.max(-height);
    }
    Ok(found)
}

fn worst(tier: Tier, frictions: &[f64], speeds: &[f64]) -> Result<Heights, Box<dyn Error>> {
    let mut most = Heights::default();
    for &friction in frictions {
        for &speed in speeds {
            let found = heights(tier, friction, speed)?;
            most = Heights { above: most.above.max(found.above), below: most.below.max(found.below) };
        }
    }
    Ok(most)
}

/// The rows.
pub(super) fn rows(_context: &Context) -> CaseResult {
    let (rough, speeds) = ([0.1, 0.5, 1.0], [0.1, 1.0, 10.0]);
    let mut rows = Vec::new();
    for (tier, frictions, above, below, speeds) in [
        (Tier::Accurate, &rough[..], ROUNDING_M, ROUNDING_M, &speeds[..]),
        (Tier::Stepped, &rough[..], ROUNDING_M, ROUNDING_M, &speeds[..]),
        (Tier::Thesis, &[0.0][..], ROUNDING_M, ROUNDING_M, &speeds[..]),
        (Tier::MicroCollisions, &rough[..], FALL_M, FALL_M, &speeds[..]),
        (Tier::Fast, &rough[..], ROUNDING_M, SAG_M, &speeds[..]),
    ] {
        let found = worst(tier, frictions, speeds)?;
        let of = format!("{}, mu {frictions:?}, {speeds:?} m/s", tier.name());
        rows.push(Row::at_most(CASE, &format!("{of}: height above the floor, m"), above, found.above));
        rows.push(Row::at_most(CASE, &format!("{of}: depth in the floor, m"), below, found.below));
    }
    Ok(rows)
}
