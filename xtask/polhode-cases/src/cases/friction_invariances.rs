//! Motions with friction set differently in the world: larger and smaller, heavier and lighter, turned, and moved.

use super::rolling_disc::tippe_top;
use super::setting::{Setting, largest_difference};
use super::sliding_and_spinning::tripod;
use super::slipping_and_rolling::ball;
use super::slopes::puck;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::Scene;
use polhode::spatial::Rotation;
use std::error::Error;

/// A scene of millimetres in the place of metres.
const SMALL_LENGTH: f64 = 1e-3;

/// Masses of micrograms in the place of kilograms.
const SMALL_MASS: f64 = 1e-9;

/// The same motion to rounding; far from the origin to what poses there can hold.
pub(super) fn settings(_: &Context) -> CaseResult {
    /// Distance allowed near the origin, m and rad, of scenes that move by some 0.1 to 1.
    const NEAR: f64 = 1e-9;
    /// Distance allowed at 1e6 m, where positions have a spacing of 1e-10 m.
    const FAR: f64 = 1e-6;
    let turn = Rotation::from_wxyz([1.0, 2.0, 3.0, 4.0].map(|c: f64| c / 30.0f64.sqrt()))?;
    let here = Setting::default();
    let settings = [
        ("lengths x SMALL_LENGTH", Setting { length: SMALL_LENGTH, ..here }, NEAR),
        ("lengths x 1e3", Setting { length: 1e3, ..here }, NEAR),
        ("masses x SMALL_MASS", Setting { mass: SMALL_MASS, ..here }, NEAR),
        ("masses x 1e9", Setting { mass: 1e9, ..here }, NEAR),
        ("turned by (1, 2, 3, 4)", Setting { turn, ..here }, NEAR),
        ("moved by 1e6 m", Setting { offset: DVec3::new(1e6, -1e6, 1e6), ..here }, FAR),
    ];
    let mut rows = Vec::new();
    for (name, scene) in scenes()? {
        for (how, setting, limit) in &settings {
            let found = largest_difference(&scene, setting)?;
            rows.push(Row::at_most(
                "friction elsewhere",
                &format!("{name}, {how}: difference, m or rad"),
                *limit,
                found,
            ));
        }
    }
    Ok(rows)
}

fn scenes() -> Result<[(&'static str, Scene); 4], Box<dyn Error>> {
    let shot = ball(0.0286, DVec3::X * 2.0, DVec3::new(30.0, -60.0, 50.0), 0.2, 0.7)?;
    Ok([
        ("puck on a slope", puck(30.0f64.to_radians(), 1.0, 0.5)?),
        ("tripod", tripod(0.25)?),
        ("billiard shot", shot),
        ("tippe top", tippe_top(0.3, 60.0, 0.3, 0.1)?.with_duration(0.3)?),
    ])
}
