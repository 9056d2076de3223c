//! Stacks of boxes of very different masses on slopes: they stand by friction, and rest is certified at once.
//!
//! The residual of the contact forces is relative to the accelerations without them. A body of mass m under bodies of mass
//! M gains `M g / m` from each of two forces that cancel, so that rounding leaves `4 eps M/m` of it.

use super::rough_plane::{Plane, rough};
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::spatial::{Pose, Velocity};
use polhode::{Effects, Scene, Simulation, Unobserved};
use std::error::Error;

const CASE: &str = "stacks on slopes";

/// Largest residual where the masses are alike, and rounding units for each unit of their ratio.
const RESIDUAL: f64 = 1e-12;
const UNITS: f64 = 4.0;

/// Length, depth and height of a box, m.
const SIZE: DVec3 = DVec3::new(1.0, 0.6, 0.2);

/// Friction of all pairs.
const FRICTION: f64 = 0.5;

/// The first instants decide: what is in certified equilibrium then never moves, s.
const FIRST_S: f64 = 1e-3;

/// Where the mass of a stack is.
#[derive(Debug, Clone, Copy)]
enum Masses {
    /// They rise by one factor from each box to the next above.
    Rising,
    /// They fall.
    Falling,
    /// One heavy box on light ones.
    HeavyTop,
}

/// A stack of `count` boxes at rest on a slope of `degrees`, whose largest mass is `ratio` times the smallest.
fn stack(count: usize, ratio: f64, masses: Masses, degrees: f64) -> Result<Scene, Box<dyn Error>> {
    let plane = Plane::inclined(degrees.to_radians());
    let mut builder = Scene::builder("stack on a slope").body(plane.ground(FRICTION)?);
    let share = |level: usize| level as f64 / (count - 1) as f64;
    for level in 0..count {
        let mass = match masses {
            Masses::Rising => libm::pow(ratio, share(level)),
            Masses::Falling => libm::pow(ratio, share(count - 1 - level)),
            Masses::HeavyTop if level + 1 == count => ratio,
            Masses::HeavyTop => 1.0,
        };
        let body = super::bodies::cuboid(&format!("box {level}"), SIZE, mass, DVec3::ZERO)?;
        let pose = Pose::from_translation(DVec3::Z * (SIZE.z * (level as f64 + 0.5)));
        builder = builder.body(plane.place(body, pose, Velocity::ZERO).material(rough(FRICTION)?));
    }
    Ok(builder.duration_s(1.0).build()?)
}

/// Whether all bodies are put to rest at once, and the residual of their forces.
fn rests(scene: &Scene) -> Result<(bool, f64), Box<dyn Error>> {
    let mut simulation = Simulation::new(scene, Effects::Planned)?;
    simulation.step(&mut Unobserved)?;
    let still = simulation.bodies().iter().all(|body| body.velocity == Velocity::ZERO);
    Ok((still && simulation.time() >= FIRST_S, simulation.frame().certificate.max_residual))
}

/// Stacks of 5 and 10 boxes, mass ratios 1 to 1e6, on slopes that a stack of equal boxes does not tip over on.
pub(super) fn rows(_context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for (count, slopes) in [(5, [5.0, 15.0]), (10, [5.0, 10.0])] {
        for ratio in [1.0, 1e2, 1e4, 1e6] {
            let mut not_at_rest = 0_u64;
            let mut worst = 0.0f64;
            for masses in [Masses::Rising, Masses::Falling, Masses::HeavyTop] {
                for degrees in slopes {
                    match rests(&stack(count, ratio, masses, degrees)?)? {
                        (true, residual) => worst = worst.max(residual),
                        (false, _) => not_at_rest += 1,
                    }
                }
            }
            let named = |what: &str| format!("{count} boxes, mass ratio {ratio:.0e}: {what}");
            rows.push(Row::exact(CASE, &named("of 6 stacks not at rest at once"), 0_u64, not_at_rest));
            let limit = RESIDUAL.max(UNITS * f64::EPSILON * ratio);
            rows.push(Row::at_most(CASE, &named("residual of those at rest"), limit, worst));
        }
    }
    Ok(rows)
}
