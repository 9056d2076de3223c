//! Shares of random throws: how often a body comes to rest on its faces.

use super::runs::SceneRun;
use crate::row::Value;
use polhode::Effects;
use polhode_study::drop::{RestPoses, Setting, Start, Throws};
use serde::Deserialize;
use std::error::Error;
use std::num::NonZeroUsize;

/// Throws of the one body of a scene that moves.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Landings {
    /// How many.
    pub throws: u64,
    /// Seed of the attitudes.
    #[serde(default)]
    pub seed: u64,
    /// What is read.
    pub of: Of,
}

/// What is read of the throws.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Of {
    /// On how many faces any has come to rest, and the share of the most frequent one.
    Faces,
    /// The share that has come to rest on the mantle of a round body.
    Mantle,
}

/// The shares.
///
/// # Errors
/// When the scene cannot be thrown, or a throw fails.
pub(super) fn shares(run: &SceneRun, landings: &Landings) -> Result<Vec<Value>, Box<dyn Error>> {
    let scene = run.loaded()?.scene;
    let setting = Setting::of_scene(&scene, None, Effects::Planned, Start::default())?;
    let throws =
        Throws { count: landings.throws, seed: landings.seed, workers: NonZeroUsize::MIN, corner_radius_m: None };
    let poses = RestPoses::of(&setting, &throws, &|| false, |_| Ok(()))?;
    if let Some((throw, why)) = &poses.reason {
        return Err(format!("throw {throw}: {why}").into());
    }
    let count = landings.throws as f64;
    let most = poses.on.iter().copied().max().unwrap_or(0);
    Ok(match landings.of {
        Of::Faces => {
            let faces = poses.on.iter().filter(|&&times| times > 0).count();
            vec![Value::Count(faces as u64), Value::Number(most as f64 / count)]
        }
        Of::Mantle => vec![Value::Number(poses.leaning as f64 / count)],
    })
}
