//! How far shipped scenes are from moving, by limit analysis and by hand.
//!
//! - `brick-wall` on its slope of 15 degrees slides as bricks do on each other: it needs `tan 15`, and may be tilted by
//!   `atan 0.6 -+ 15` degrees down and up the slope.
//! - The flat ladder of `ladder`, at two degrees below the limit, needs `(L cot a - t)/(2 L)`.
//! - `pyramid-55` leans over sideways when the resultant leaves its base of 0.4 m: its centre of mass is `0.2 + 9
//!   0.4/3` high; in its plane it slides first.
//! - A box on a slope of any angle and friction needs `tan a / mu`.

use super::rough_plane::Plane;
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::{Effects, Scene, Simulation, Stability};
use polhode_oracles::random::Random;
use std::error::Error;

const CASE: &str = "stability";

/// Margins are told to six digits, relative.
const RELATIVE: f64 = 2e-6;

/// Slopes at full count.
const SLOPES: usize = 2000;

fn of(scene: &Scene) -> Result<Stability, Box<dyn Error>> {
    Ok(Simulation::with_effects(scene, Effects::All)?.stability()?)
}

/// The tilts towards +x, -x and +y, degrees.
fn tilts(stability: &Stability) -> Result<[f64; 3], Box<dyn Error>> {
    let towards = |direction: DVec3| -> Result<f64, Box<dyn Error>> {
        let push = stability.pushes.iter().find(|push| push.direction.dot(direction) > 0.999);
        Ok(push.and_then(polhode::stability::PushMargin::tilt_rad).ok_or("no margin")?.to_degrees())
    };
    Ok([towards(DVec3::X)?, towards(DVec3::NEG_X)?, towards(DVec3::Y)?])
}

pub(super) fn rows(context: &Context) -> CaseResult {
    let compared = |quantity: &str, expected: f64, found: f64| {
        Row::compared(CASE, quantity, expected, found, Tolerance::Relative(RELATIVE))
    };
    let wall = of(&context.shipped.load("brick-wall")?)?;
    let [down, up, _] = tilts(&wall)?;
    let steepest = 0.6_f64.atan().to_degrees();
    let needed = |stability: &Stability| stability.friction.needed.ok_or("friction holds nothing");
    let flat = of(&context.shipped.load("ladder")?)?;
    let (length, thickness) = (3.0_f64, 0.08_f64);
    let angle = (length / (2.0 * 0.3 * length + thickness)).atan() - 2.0_f64.to_radians();
    let of_ladder = (length / angle.tan() - thickness) / (2.0 * length) / 0.3;
    let pyramid = of(&context.shipped.load("pyramid-55")?)?;
    let [along, _, across] = tilts(&pyramid)?;
    Ok(vec![
        compared("brick-wall: part of friction needed", 15.0_f64.to_radians().tan() / 0.6, needed(&wall)?),
        compared("brick-wall: tilt down its slope (deg)", steepest - 15.0, down),
        compared("brick-wall: tilt up its slope (deg)", steepest + 15.0, up),
        compared("ladder, flat: part of friction needed", of_ladder, needed(&flat)?),
        compared("pyramid-55: tilt in its plane (deg)", 0.5_f64.atan().to_degrees(), along),
        compared(
            "pyramid-55: tilt across its plane (deg)",
            (0.2_f64 / (0.2 + 9.0 * 0.4 / 3.0)).atan().to_degrees(),
            across,
        ),
        Row::compared(
            CASE,
            "random slopes: largest relative difference from tan a / mu",
            0.0,
            worst_slope(context.amount.of(SLOPES))?,
            Tolerance::Absolute(RELATIVE),
        ),
    ])
}

/// The largest relative difference of the friction that a low box on a slope needs.
fn worst_slope(count: usize) -> Result<f64, Box<dyn Error>> {
    let mut random = Random(34);
    let mut worst: f64 = 0.0;
    for _ in 0..count {
        let (angle, friction) = (random.between(0.05, 0.8), random.between(0.1, 2.0));
        let plane = Plane::inclined(angle);
        // Low enough not to tip: twice as long as high, on slopes below 45 degrees.
        let body = plane.lying_box(DVec3::new(2.0, 1.0, 0.5), 0.0, DVec3::ZERO)?;
        let found = of(&plane.with(body, friction)?.build()?)?.friction.needed.ok_or("friction holds nothing")?;
        worst = worst.max((found / (angle.tan() / friction) - 1.0).abs());
    }
    Ok(worst)
}
