//! Readings that are no quantity of the scene format.
//!
//! | name | is |
//! |---|---|
//! | `first-side` | the share of a turn for which the first body shows the side that is up at the start |

use super::runs::SceneRun;
use crate::cases::motion::{Crossing, zeros};
use crate::row::Value;
use polhode::BodySample;
use polhode::spatial::DVec3;
use std::error::Error;

/// The reading of this name.
///
/// # Errors
/// When there is none, or it cannot be read.
pub(super) fn values(name: &str, run: &SceneRun) -> Result<Vec<Value>, Box<dyn Error>> {
    match name {
        "first-side" => first_side(run).map(|share| vec![Value::Number(share)]),
        _ => Err(format!("there is no reading {name}").into()),
    }
}

/// The height of the tip of the axis goes as a cosine about a mean: it is zero at t1 and at T - t1 of a turn T.
fn first_side(run: &SceneRun) -> Result<f64, Box<dyn Error>> {
    let height = |sample: &BodySample| sample.pose.rotation.rotate(DVec3::Z).z;
    match zeros(&run.loaded()?.scene, 2, Crossing::Any, height)?[..] {
        [down, up] => Ok(2.0 * down / (down + up)),
        _ => Err("the axis does not cross the level".into()),
    }
}
