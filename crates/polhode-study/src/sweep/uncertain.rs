//! The sweep of what a scene says is uncertain: each uncertain key, and each direction in which a body may be moved or
//! turned, is a value that is drawn.

use super::design::{Design, Sensitivities};
use super::error::SweepError;
use super::measure::Measure;
use super::plan::Sweep;
use super::scene::SweepScene;
use super::varied::{Acts, Values, Varied};
use crate::candidate::change;
use polhode_scene::{Distribution, Draw, SceneFileError, StartPose, Uncertain};
use std::num::NonZeroU64;

impl Sweep {
    /// The sweep that draws what the scene says is uncertain, so often, with what sensitivities need.
    ///
    /// # Errors
    /// When nothing is uncertain, there are too many runs, or the scene refuses an end of a range.
    pub fn uncertain(
        scene: &SweepScene<'_>,
        draws: Option<NonZeroU64>,
        seed: u64,
        measures: Vec<Measure>,
        asked: Sensitivities,
    ) -> Result<Self, SweepError> {
        let loaded = scene.loaded(&[])?;
        if loaded.uncertain().is_empty() {
            let what = "nothing is varied: give --vary KEY=VALUES, or [[uncertain]] keys in the scene";
            return Err(SweepError::Draws(what.to_owned()));
        }
        let (varied, poses) = drawn_of(loaded.uncertain());
        check_ends(scene, &varied)?;
        let is_accepted = |key: usize, value: &str| {
            let own: &Varied = &varied[key];
            !matches!(own.acts, Acts::Sets) || scene.loaded(&[change(&own.key, value)]).is_ok()
        };
        // Where nothing is measured, nothing hangs on anything.
        let needed = if measures.is_empty() { Sensitivities::Off } else { asked };
        let design = Design::new(&varied, needed, is_accepted);
        if needed == Sensitivities::Gauss && design.nodes().is_empty() {
            return Err(SweepError::Draws(format!(
                "--sensitivities gauss: {} uncertain values are too many for a grid, or the scene refuses its nodes; \
                 use --sensitivities saltelli",
                varied.len()
            )));
        }
        Self::designed((varied, poses), design, draws, (seed, measures))
    }
}

/// The values that are drawn, and the bodies that are moved.
fn drawn_of(uncertain: &[Uncertain]) -> (Vec<Varied>, Vec<StartPose>) {
    let (mut varied, mut poses) = (Vec::new(), Vec::new());
    for (number, own) in uncertain.iter().enumerate() {
        match own {
            Uncertain::Key { key, drawn } => {
                let values = Values::Drawn(drawn.clone());
                varied.push(Varied { key: key.clone(), values, acts: Acts::Sets });
            }
            Uncertain::Poses { bodies, position_deviation_m, rotation_deviation_rad, draw } => {
                let first = poses.len();
                poses.extend(bodies.iter().cloned());
                let groups: Vec<(String, Vec<usize>)> = match draw {
                    Draw::Each => (first..poses.len())
                        .map(|place| (format!("bodies.{}", poses[place].body()), vec![place]))
                        .collect(),
                    _ => vec![(format!("uncertain.{number}"), (first..poses.len()).collect())],
                };
                for (name, places) in groups {
                    varied.extend(moved(&name, &places, *position_deviation_m, Acts::Shifts));
                    varied.extend(moved(&name, &places, *rotation_deviation_rad, Acts::Turns));
                }
            }
            _ => {}
        }
    }
    (varied, poses)
}

/// The directions in which bodies are moved or turned.
fn moved(name: &str, places: &[usize], deviations: [f64; 3], acts: fn(Vec<usize>, usize) -> Acts) -> Vec<Varied> {
    let of_axis = |(axis, deviation): (usize, &f64)| {
        let acts = acts(places.to_vec(), axis);
        let word = if matches!(acts, Acts::Turns(..)) { "turn" } else { "shift" };
        let values = Values::Drawn(Distribution::Normal { mean: 0.0, deviation: *deviation });
        Varied { key: format!("{name}.{word}[{axis}]"), values, acts }
    };
    deviations.iter().enumerate().filter(|(_, own)| **own > 0.0).map(of_axis).collect()
}

/// The scene takes both ends of every range, and each value of a choice.
fn check_ends(scene: &SweepScene<'_>, varied: &[Varied]) -> Result<(), SweepError> {
    for own in varied {
        let values = match &own.values {
            Values::Drawn(Distribution::Uniform { low, high }) => [low, high].map(|end| format!("{end:?}")).to_vec(),
            Values::Drawn(Distribution::Choice(values)) => values.clone(),
            _ => continue,
        };
        for value in values {
            if let Err(error) = scene.loaded(&[change(&own.key, &value)]) {
                return Err(SweepError::Reach { key: own.key.clone(), value, why: reason_of(&error) });
            }
        }
    }
    Ok(())
}

/// What is refused first, in one line: the key, why, and what is accepted.
pub(super) fn reason_of(error: &SceneFileError) -> String {
    let Some(refused) = error.refused() else { return error.to_string() };
    let cure = refused.cure().map_or_else(String::new, |cure| format!(" ({cure})"));
    format!("{}: {}{cure}", refused.place.key, refused.cause)
}
