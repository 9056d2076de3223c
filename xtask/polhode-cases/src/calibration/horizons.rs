//! Horizons: when a difference of rounding at the start has grown to a hundredth of a body.
//!
//! The true horizon is the median over nine runs whose starts are disturbed: every coordinate of places and velocities
//! of bodies that move is one unit in its last place larger or smaller. A run has left where any body is a hundredth of
//! its size from where it is in the undisturbed run.

use super::chaotic::{self, Chaotic};
use super::distance::Sizes;
use super::trial::{NoTrial, Trial};
use polhode::{ErrorEstimation, Scene};
use polhode_oracles::random::Random;
use polhode_scene::Override;
use std::error::Error;
use std::fmt;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Runs whose starts are disturbed.
const DISTURBED: u64 = 9;
/// A body has left where it is this part of its size away.
const LEFT: f64 = 1e-2;
/// Samples of a run: times are found to a part of this.
const SAMPLES: f64 = 400.0;
/// A told horizon is right within this factor of the true one.
pub const WITHIN: f64 = 1.5;
/// Keys of what is disturbed.
const KEYS: [&str; 3] = ["position", "velocity", "angular_velocity"];

/// What came of a chaotic scene.
#[derive(Debug, Clone)]
pub struct Horizon {
    /// Name of the scene, and its tier.
    pub name: String,
    /// The median, s; none where fewer than half of the runs have left.
    pub true_s: Option<f64>,
    /// The earliest and the latest that have left, s.
    pub range_s: [f64; 2],
    /// The one told, s.
    pub told_s: Option<f64>,
    /// Duration of the run, s.
    pub duration_s: f64,
    /// The largest distance at the end, median, of a body's size.
    pub apart: f64,
    /// Why there is none.
    pub why: Option<String>,
}

impl Horizon {
    /// Whether the told horizon is within a factor of the true one.
    pub fn is_right(&self) -> bool {
        let within = |(told, truth): (f64, f64)| told <= WITHIN * truth && truth <= WITHIN * told;
        self.told_s.zip(self.true_s).is_some_and(within)
    }
}

impl fmt::Display for Horizon {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:48} ", self.name)?;
        if let Some(why) = &self.why {
            return write!(f, "failed: {why}");
        }
        let [first, last] = self.range_s;
        match self.true_s {
            Some(truth) => write!(f, "true {truth:7.3} s ({first:.3} to {last:.3}, of {}) ", self.duration_s)?,
            None => write!(f, "not reached in {} s: {:.1e} of a body at its end ", self.duration_s, self.apart)?,
        }
        match self.told_s {
            Some(told) => write!(f, "told {told:7.3} s{}", if self.is_right() { "" } else { ": wrong" }),
            None => write!(f, "not told"),
        }
    }
}

/// The horizons of all chaotic scenes, by one thread for each processor; `each` is called as they come.
pub fn horizons(root: &Path, only: &str, estimation: ErrorEstimation, each: impl Fn(&Horizon) + Sync) -> Vec<Horizon> {
    let all: Vec<Chaotic> = chaotic::all(root).into_iter().filter(|one| one.name.starts_with(only)).collect();
    let next = AtomicUsize::new(0);
    let found: Mutex<Vec<(usize, Horizon)>> = Mutex::default();
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let place = next.fetch_add(1, Ordering::Relaxed);
                    let Some(chaotic) = all.get(place) else { break };
                    let horizon = horizon(chaotic, estimation);
                    each(&horizon);
                    if let Ok(mut found) = found.lock() {
                        found.push((place, horizon));
                    }
                }
            });
        }
    });
    let mut found = found.into_inner().unwrap_or_default();
    found.sort_by_key(|(place, _)| *place);
    found.into_iter().map(|(_, horizon)| horizon).collect()
}

fn horizon(chaotic: &Chaotic, estimation: ErrorEstimation) -> Horizon {
    let name = format!("{} ({})", chaotic.name, chaotic.tier.name());
    let duration_s = chaotic.duration_s;
    let none =
        Horizon { name, true_s: None, range_s: [f64::NAN; 2], told_s: None, duration_s, apart: f64::NAN, why: None };
    match measured(chaotic, estimation) {
        Err(error) => Horizon { why: Some(error.to_string().replace('\n', " ")), ..none },
        Ok(Measured { told_s, mut left_s, mut apart }) => {
            left_s.sort_by(f64::total_cmp);
            apart.sort_by(f64::total_cmp);
            let left = left_s;
            let finite = || left.iter().copied().filter(|t| t.is_finite());
            let range_s = [finite().next().unwrap_or(f64::NAN), finite().next_back().unwrap_or(f64::NAN)];
            let true_s = left.get(left.len() / 2).copied().filter(|t| t.is_finite());
            let apart = apart.get(apart.len() / 2).copied().unwrap_or(f64::NAN);
            Horizon { true_s, range_s, told_s, apart, ..none }
        }
    }
}

/// What is measured of a scene.
struct Measured {
    /// The horizon that the undisturbed run tells, s.
    told_s: Option<f64>,
    /// When each disturbed run leaves it, s; infinite where it does not.
    left_s: Vec<f64>,
    /// How far each is from it at the end, of a body's size.
    apart: Vec<f64>,
}

/// Runs a scene undisturbed and disturbed.
fn measured(chaotic: &Chaotic, estimation: ErrorEstimation) -> Result<Measured, Box<dyn Error>> {
    let scene = loaded(chaotic, &chaotic.text)?;
    let sizes = Sizes::of(&scene);
    let undisturbed = run(&scene, estimation)?;
    let (mut left_s, mut apart) = (Vec::new(), Vec::new());
    for seed in 0..DISTURBED {
        let trial = run(&loaded(chaotic, &disturbed(&chaotic.text, seed)?)?, ErrorEstimation::Off)?;
        let rows = undisturbed.rows.iter().zip(&trial.rows);
        let far: Vec<f64> = rows.map(|(a, b)| sizes.between(a, b)).collect();
        let first = far.iter().zip(&trial.times_s).find(|(far, _)| **far >= LEFT);
        left_s.push(first.map_or(f64::INFINITY, |(_, t)| *t));
        apart.push(far.last().copied().unwrap_or(f64::NAN));
    }
    Ok(Measured { told_s: undisturbed.told.horizon_s, left_s, apart })
}

fn loaded(chaotic: &Chaotic, text: &str) -> Result<Scene, Box<dyn Error>> {
    let set = |key: &str, value: f64| Override::new("horizons", key, format!("{value:?}"));
    let duration_s = chaotic.duration_s;
    let sets = [set("duration", duration_s), set("output.interval", duration_s / SAMPLES)];
    Ok(polhode_scene::load_text(&chaotic.name, text, &sets)?.scene)
}

fn run(scene: &Scene, estimation: ErrorEstimation) -> Result<Trial, Box<dyn Error>> {
    Trial::of(scene, estimation).map_err(|why| match why {
        NoTrial::Refused(why) | NoTrial::Failed(why) => why.into(),
        NoTrial::Late => "it takes very many steps".into(),
    })
}

/// The scene file with places and velocities of bodies that move disturbed in their last places.
fn disturbed(text: &str, seed: u64) -> Result<String, Box<dyn Error>> {
    let mut file: toml::Table = toml::from_str(text)?;
    let mut random = Random(seed);
    let bodies = file.get_mut("bodies").and_then(toml::Value::as_array_mut).ok_or("no bodies")?;
    for body in bodies.iter_mut().filter_map(toml::Value::as_table_mut).filter(|body| body.contains_key("mass")) {
        for key in KEYS {
            for value in body.get_mut(key).and_then(toml::Value::as_array_mut).into_iter().flatten() {
                if let Some(number) = value.as_float() {
                    let sign = if random.below(2) == 0 { 1.0 } else { -1.0 };
                    *value = toml::Value::Float(number * (1.0 + sign * f64::EPSILON));
                }
            }
        }
    }
    Ok(toml::to_string(&file)?)
}

#[cfg(test)]
mod tests {
    //! Only what moves is disturbed, and only in its last place.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn only_what_moves_is_disturbed() {
        let text = "[[bodies]]\nname = \"a\"\nmass = 1.0\nposition = [0.1, 0.0, 3.0]\n[[bodies]]\nname = \"b\"\n\
                    fixed = true\nposition = [0.1, 0.2, 0.3]\n";
        let found: toml::Table = toml::from_str(&disturbed(text, 1).unwrap()).unwrap();
        let place = |body: usize| {
            let numbers = found["bodies"].as_array().unwrap()[body]["position"].as_array().unwrap();
            numbers.iter().map(|x| x.as_float().unwrap()).collect::<Vec<_>>()
        };
        assert_eq!(place(1), [0.1, 0.2, 0.3]);
        let off: Vec<f64> = place(0).iter().zip([0.1, 0.0, 3.0]).map(|(x, y)| (x - y).abs()).collect();
        assert!(off[0] > 0.0 && off[0] <= 2.0 * f64::EPSILON * 0.1 && off[1] == 0.0 && off[2] > 0.0, "{off:?}");
    }
}
