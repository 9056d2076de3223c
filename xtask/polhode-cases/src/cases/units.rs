//! Scenes in other units: every number of a scaled copy is that of the original, scaled, to the last bit.
//!
//! Lengths are larger by a power of 4, times by the same power of 2, masses by a power of 4: nothing is rounded, no
//! square root either, so that a copy with other bits shows a number with a unit where none may be. Beside the shipped
//! scenes these are random ones that crowd.

use super::{Amount, CaseResult, Context};
use crate::row::Row;
use crate::scene_units::Units;
use polhode::{BodySample, Recorder, Simulation};
use polhode_oracles::random_scene::generate;
use std::error::Error;
use std::path::{Path, PathBuf};

/// Seconds of each scene that are compared in a plain run.
const PART_S: f64 = 0.2;

/// Seeds of random scenes that crowd, and the seconds of them that are compared.
const CROWDED_SEEDS: [u64; 4] = [53, 94, 97, 98];
const CROWDED_S: f64 = 0.8;

/// Powers of lengths and of masses.
const POWERS: [(i32, i32); 2] = [(-3, 2), (5, -1)];

/// The samples of a scene file in these units.
fn samples(path: &Path, units: Units, most_s: f64) -> Result<Recorder, Box<dyn Error>> {
    let text = units.text(&std::fs::read_to_string(path)?, most_s)?;
    let loaded = polhode_scene::load_text(&path.display().to_string(), &text, &[])?;
    let mut record = Recorder::default();
    Simulation::new(&loaded.scene)?.run_observed(&mut record)?;
    Ok(record)
}

/// Whether a state is another one in these units.
fn is_same(units: Units, original: &BodySample, copy: &BodySample) -> bool {
    let speed = units.length / units.time;
    copy.pose.rotation == original.pose.rotation
        && copy.pose.translation == original.pose.translation * units.length
        && copy.velocity.linear == original.velocity.linear * speed
        && copy.velocity.angular == original.velocity.angular / units.time
}

/// When the samples of a copy first are others, s of the original; none where they are the same.
fn departure(units: Units, original: &Recorder, copy: &Recorder) -> Option<f64> {
    let pairs = original.samples.iter().zip(&copy.samples).zip(&original.times_s);
    let is_other = |(before, after): (&Vec<BodySample>, &Vec<BodySample>)| {
        before.iter().zip(after).any(|(before, after)| !is_same(units, before, after))
    };
    let first = pairs.into_iter().find(|&((before, after), _)| is_other((before, after))).map(|(_, &t)| t);
    let is_shorter = original.samples.len() != copy.samples.len();
    first.or_else(|| is_shorter.then(|| original.times_s.last().copied().unwrap_or_default()))
}

/// Writes the random scene of a seed into a folder, and returns its file.
fn random_scene(folder: &Path, seed: u64) -> Result<PathBuf, Box<dyn Error>> {
    let stem = format!("random-{seed}");
    let written = generate::scene(seed).written(&stem);
    for (name, text) in written.meshes {
        std::fs::write(folder.join(name), text)?;
    }
    let path = folder.join(format!("{stem}.toml"));
    std::fs::write(&path, written.text)?;
    Ok(path)
}

/// Every shipped scene, and random ones that crowd, in other units.
pub(super) fn shipped(context: &Context) -> CaseResult {
    let most_s = if context.amount == Amount::Full { f64::INFINITY } else { PART_S };
    let mut others = vec![Vec::new(); POWERS.len()];
    let folder = tempfile::tempdir()?;
    let mut paths = Vec::new();
    for name in context.shipped.names()? {
        paths.push((context.shipped.path(&name), most_s));
    }
    for seed in CROWDED_SEEDS {
        paths.push((random_scene(folder.path(), seed)?, most_s.max(CROWDED_S)));
    }
    for (path, most_s) in &paths {
        let (most_s, name) = (*most_s, path.file_stem().unwrap_or_default().to_string_lossy());
        let original = samples(path, Units::of_powers(0, 0), most_s)?;
        for (&(power, mass_power), others) in POWERS.iter().zip(&mut others) {
            let units = Units::of_powers(power, mass_power);
            if let Some(t) = departure(units, &original, &samples(path, units, most_s)?) {
                others.push(format!("{name} ({t} s)"));
            }
        }
    }
    let row = |(&(power, mass_power), others): (&(i32, i32), &Vec<String>)| {
        let what = format!(
            "scenes with other bits, of {}: lengths x 4^{power}, times x 2^{power}, masses x 4^{mass_power}",
            paths.len()
        );
        let found = if others.is_empty() { "none".to_owned() } else { others.join(" ") };
        Row::exact("other units", &what, "none", found)
    };
    Ok(POWERS.iter().zip(&others).map(row).collect())
}
