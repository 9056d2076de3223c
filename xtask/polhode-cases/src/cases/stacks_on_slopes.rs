//! Stacks of boxes of very different masses on slopes: they stand by friction, and rest is certified at once.
//!
//! The residual of the contact forces is relative to the accelerations without them. A body of mass m under bodies of
//! mass M gains `M g / m` from each of two forces that cancel, so that forces in working precision leave some `4 eps
//! M/m` of it: that is the limit. The forces are found in twice the working precision and leave less.

use super::rough_plane::{Plane, rough};
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::spatial::{Pose, Rotation, Velocity};
use polhode::{Scene, Simulation};
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
    /// Light and heavy ones in turns, a light one at the bottom.
    Alternating,
}

/// How a stack stands.
#[derive(Debug, Clone, Copy)]
struct Placing {
    /// Of the slope to the level plane, degrees.
    degrees: f64,
    /// Of the slope about the vertical, degrees.
    azimuth_degrees: f64,
    /// Of each box about the normal to the one below, degrees.
    twist_degrees: f64,
}

impl Placing {
    /// Straight, with the slope downhill along the length of the boxes.
    fn straight(degrees: f64) -> Self {
        Self { degrees, azimuth_degrees: 0.0, twist_degrees: 0.0 }
    }

    /// In a direction that no axis has.
    fn turned(degrees: f64) -> Self {
        Self { degrees, azimuth_degrees: 37.0, twist_degrees: 6.0 }
    }
}

/// A stack of `count` boxes at rest on a slope, whose largest mass is `ratio` times the smallest.
fn stack(count: usize, ratio: f64, masses: Masses, placing: Placing) -> Result<Scene, Box<dyn Error>> {
    let plane = Plane::inclined(placing.degrees.to_radians()).turned(placing.azimuth_degrees.to_radians());
    let mut builder = Scene::builder("stack on a slope").body(plane.ground(FRICTION)?);
    let share = |level: usize| level as f64 / (count - 1) as f64;
    for level in 0..count {
        let mass = match masses {
            Masses::Rising => libm::pow(ratio, share(level)),
            Masses::Falling => libm::pow(ratio, share(count - 1 - level)),
            Masses::HeavyTop if level + 1 == count => ratio,
            Masses::Alternating if level % 2 == 1 => ratio,
            Masses::HeavyTop | Masses::Alternating => 1.0,
        };
        let body = super::bodies::cuboid(&format!("box {level}"), SIZE, mass, DVec3::ZERO)?;
        let twist = Rotation::from_rotation_vector(DVec3::Z * (placing.twist_degrees.to_radians() * level as f64));
        let pose = Pose::new(twist, DVec3::Z * (SIZE.z * (level as f64 + 0.5)));
        builder = builder.body(plane.place(body, pose, Velocity::ZERO).material(rough(FRICTION)?));
    }
    Ok(builder.duration_s(1.0).build()?)
}

/// Stacks of five boxes that stand, with mass ratios from 1 to 1e4.
pub(crate) fn standing() -> Result<Vec<(String, Scene)>, Box<dyn Error>> {
    let mut all = Vec::new();
    for ratio in [1.0, 1e2, 1e4] {
        for masses in [Masses::Rising, Masses::HeavyTop, Masses::Alternating] {
            let scene = stack(5, ratio, masses, Placing::turned(10.0))?;
            all.push((format!("stack on a slope, {masses:?}, ratio {ratio:e}"), scene));
        }
    }
    Ok(all)
}

/// Whether all bodies are put to rest at once, and the residual of their forces.
fn rests(scene: &Scene) -> Result<(bool, f64), Box<dyn Error>> {
    let mut simulation = Simulation::new(scene)?;
    simulation.step()?;
    let still = simulation.bodies().iter().all(|body| body.velocity == Velocity::ZERO);
    Ok((still && simulation.time() >= FIRST_S, simulation.frame().certificate.max_residual))
}

/// The rows of `stacks`, which have these counts and mass ratios.
fn push_rows(
    rows: &mut Vec<Row>,
    (count, ratio, how): (usize, f64, &str),
    stacks: &[(Masses, Placing)],
) -> Result<(), Box<dyn Error>> {
    let mut not_at_rest = 0_u64;
    let mut worst = 0.0f64;
    for &(masses, placing) in stacks {
        match rests(&stack(count, ratio, masses, placing)?)? {
            (true, residual) => worst = worst.max(residual),
            (false, _) => not_at_rest += 1,
        }
    }
    let named = |what: &str| format!("{count} boxes, mass ratio {ratio:.0e}{how}: {what}");
    rows.push(Row::exact(CASE, &named(&format!("of {} stacks not at rest at once", stacks.len())), 0_u64, not_at_rest));
    let limit = RESIDUAL.max(UNITS * f64::EPSILON * ratio);
    rows.push(Row::at_most(CASE, &named("residual of those at rest"), limit, worst));
    Ok(())
}

/// Stacks of 5 and 10 boxes, mass ratios 1 to 1e6, on slopes that a stack of equal boxes does not tip over on.
pub(super) fn rows(_context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for (count, slopes) in [(5, [5.0, 15.0]), (10, [5.0, 10.0])] {
        for ratio in [1.0, 1e2, 1e4, 1e6] {
            let all = |of: &[Masses], placing: fn(f64) -> Placing| -> Vec<(Masses, Placing)> {
                of.iter().flat_map(|masses| slopes.map(|degrees| (*masses, placing(degrees)))).collect()
            };
            let straight = all(&[Masses::Rising, Masses::Falling, Masses::HeavyTop], Placing::straight);
            push_rows(&mut rows, (count, ratio, ""), &straight)?;
            let turned = all(&[Masses::Falling, Masses::Alternating], Placing::turned);
            push_rows(&mut rows, (count, ratio, ", turned"), &turned)?;
        }
    }
    Ok(rows)
}
