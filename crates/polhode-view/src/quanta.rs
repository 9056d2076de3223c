//! Units of the integers that frames are packed as.
//!
//! A position is a whole number of quanta, and 2^31 quanta must reach as far as the bodies get. Where that is unknown
//! (the page is written while the run goes on) it is bounded by the speeds at the start, by gravity and by the
//! duration. A body that leaves that range stays at its border in the page.

use crate::shown_scene::ShownScene;
use polhode::Scene;
use polhode::spatial::DVec3;

/// A position quantum as a fraction of the size of the smallest body that moves: far less than a pixel.
const POSITION_RELATIVE: f64 = 1e-6;
/// Where bodies have no size, m.
const POSITION_WITHOUT_SIZE_M: f64 = 1e-6;
/// Times that a body may be carried by speed and gravity, as a multiple of the size of the whole scene: what goes
/// farther is out of sight.
const FARTHEST: f64 = 1e4;
/// The smallest position quantum is one divided by this, m.
const MOST_PER_M: f64 = 1e12;
/// Velocity quanta per position quantum, 1/s.
const VELOCITY_PER_POSITION: f64 = 100.0;
/// Quantum of angular velocities, rad/s: 2^31 of them are 210,000 rad/s.
const SPIN_RAD_S: f64 = 1e-4;
/// Quanta that the reach of a scene may take: half of 2^31, for what the bound leaves out.
const MOST_QUANTA: f64 = 1_073_741_824.0;

/// Units of integers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quanta {
    /// Of positions, m.
    pub position_m: f64,
    /// Of velocities, m/s.
    pub velocity_m_s: f64,
    /// Of angular velocities, rad/s.
    pub spin_rad_s: f64,
}

impl Quanta {
    /// Fit for a scene.
    pub fn for_scene(scene: &Scene, shown: &ShownScene) -> Self {
        let sizes = shown.moving.iter().map(|&body| shown.bodies[body].size_m()).filter(|&size| size > 0.0);
        let smallest = sizes.fold(f64::INFINITY, f64::min);
        let fine = if smallest.is_finite() { POSITION_RELATIVE * smallest } else { POSITION_WITHOUT_SIZE_M };
        let position_m = round_up_to_power_of_ten(fine.max(reach_m(scene, shown) / MOST_QUANTA));
        Self { position_m, velocity_m_s: VELOCITY_PER_POSITION * position_m, spin_rad_s: SPIN_RAD_S }
    }
}

/// A bound on coordinates, m: where bodies are at the start, and how far speed and gravity carry them.
fn reach_m(scene: &Scene, shown: &ShownScene) -> f64 {
    let places = shown.bodies.iter().map(|body| body.initial.translation);
    let farthest = places.clone().map(DVec3::length).fold(0.0, f64::max);
    let first = places.clone().next().unwrap_or(DVec3::ZERO);
    let spread = places.map(|place| place.distance(first)).fold(0.0, f64::max);
    let largest = shown.moving.iter().map(|&body| shown.bodies[body].size_m()).fold(0.0, f64::max);
    let speed = scene.bodies().iter().map(|body| body.initial_velocity().linear.length()).fold(0.0, f64::max);
    let t = shown.duration_s;
    let carried = speed * t + 0.5 * shown.gravity.length() * t * t;
    farthest + spread + largest + carried.min(FARTHEST * (spread + largest).max(POSITION_WITHOUT_SIZE_M))
}

fn round_up_to_power_of_ten(value: f64) -> f64 {
    // Powers with positive exponents are exact, so that each quotient is the nearest number to its power.
    let mut per_unit = MOST_PER_M;
    while 1.0 / per_unit < value && per_unit > f64::MIN_POSITIVE {
        per_unit /= 10.0;
    }
    1.0 / per_unit
}
