//! Shares of random throws: how often a body comes to rest on its faces.

use super::runs::SceneRun;
use crate::cases::Amount;
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
    /// How many; one in a hundred of them where not everything is run.
    pub throws: u32,
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
    /// On how many faces it can rest, by statics: nothing is thrown.
    Statics,
}

/// The shares.
///
/// # Errors
/// When the scene cannot be thrown, or a throw fails.
pub(super) fn shares(run: &SceneRun, landings: &Landings, amount: Amount) -> Result<Vec<Value>, Box<dyn Error>> {
    let scene = run.loaded()?.scene;
    let setting = Setting::of_scene(&scene, None, Effects::Planned, Start::default())?;
    if landings.of == Of::Statics {
        let holding = setting.facets().list().iter().filter(|facet| facet.holds()).count();
        return Ok(vec![Value::Count(holding as u64)]);
    }
    let count = amount.of(landings.throws as usize) as u64;
    let throws = Throws { count, seed: landings.seed, workers: NonZeroUsize::MIN, corner_radius_m: None };
    let poses = RestPoses::of(&setting, &throws, &|| false, |_| Ok(()))?;
    if let Some((throw, why)) = &poses.reason {
        return Err(format!("throw {throw}: {why}").into());
    }
    let most = poses.on.iter().copied().max().unwrap_or(0);
    let faces = poses.on.iter().filter(|&&times| times > 0).count();
    Ok(vec![Value::Count(faces as u64), Value::Number(most as f64 / count as f64)])
}
