//! Stacks at and beyond the edge of stability: overhangs and staircases.

use super::bodies::{BRICK, GRAVITY, cuboid, fixed_cuboid, half_space};
use super::{CaseResult, Context};
use glam::DVec3;
use polhode::spatial::UnitVector;
use polhode::{Acceleration, Scene, Simulation};
use std::error::Error;

/// A stack counts as stable when no acceleration is larger than this part of gravity.
const STABLE: f64 = 1e-9;
/// Shift of the whole stack beyond the critical place, m.
const OFFSETS_M: [f64; 3] = [-1e-6, 0.0, 1e-6];

/// Harmonic overhangs: brick i from the top overhangs the one below by 1/(2i), which is exactly critical.
pub(super) fn rc_05(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for n in [1, 2, 3, 4, 5, 10, 20] {
        let mut stable = Vec::new();
        for offset in OFFSETS_M {
            stable.push(largest(&accelerations(&overhang(n, offset)?)?) < STABLE * GRAVITY);
        }
        rows.push(context.reference.row("RC-05", &format!("n={n}: stable at offset -1e-6, 0, +1e-6 m"), stable)?);
    }
    Ok(rows)
}

/// `n` bricks over the edge of a table at x = 0, all shifted outwards by `offset`, m.
pub(crate) fn overhang(n: usize, offset: f64) -> Result<Scene, Box<dyn Error>> {
    let table = DVec3::new(10.0, 4.0, 1.0);
    let table_center = DVec3::new(-0.5 * table.x, 0.0, -0.5 * table.z);
    let mut builder = Scene::builder("overhang").body(fixed_cuboid("table", table, table_center)?);
    for from_bottom in 0..n {
        // The right end of brick k from the top is beyond the edge by the overhangs of itself and all below it.
        let reach: f64 = (n - from_bottom..=n).map(|i| 0.5 / i as f64).sum();
        let center = DVec3::new(reach - 0.5 * BRICK.x + offset, 0.0, BRICK.z * (from_bottom as f64 + 0.5));
        builder = builder.body(cuboid(&format!("brick {from_bottom}"), BRICK, 1.0, center)?);
    }
    Ok(builder.build()?)
}

/// Staircases that fall (thesis, Figure 1 and Video 11): each brick is shifted to the right of the one below.
pub(super) fn rc_06(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for (shift, n) in [(0.3, 4), (0.3, 5), (0.4, 5)] {
        let accelerations = accelerations(&staircase(shift, n)?)?;
        for (number, acceleration) in accelerations[1..].iter().enumerate() {
            let quantity = format!("s={shift}, n={n} brick {}: ay, alpha", number + 1);
            // Anticlockwise, seen with x to the right and z up, is a turn about -y.
            let measured = [acceleration.linear.z, -acceleration.angular.y];
            rows.push(context.reference.row("RC-06", &quantity, measured)?);
        }
    }
    Ok(rows)
}

pub(super) fn staircase(shift: f64, n: usize) -> Result<Scene, Box<dyn Error>> {
    let mut builder = Scene::builder("staircase").body(half_space("floor", UnitVector::Z));
    for number in 0..n {
        let center = DVec3::new(shift * number as f64, 0.0, BRICK.z * (number as f64 + 0.5));
        builder = builder.body(cuboid(&format!("brick {number}"), BRICK, 1.0, center)?);
    }
    Ok(builder.build()?)
}

fn accelerations(scene: &Scene) -> Result<Vec<Acceleration>, Box<dyn Error>> {
    Ok(Simulation::new(scene)?.accelerations()?)
}

/// The largest component of all accelerations, m/s^2 or rad/s^2.
fn largest(accelerations: &[Acceleration]) -> f64 {
    let components = accelerations.iter().flat_map(|a| [a.linear, a.angular]).flat_map(|v| v.to_array());
    components.fold(0.0, |worst: f64, x| if x.is_nan() { f64::INFINITY } else { worst.max(x.abs()) })
}
