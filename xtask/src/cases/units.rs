//! Scenes in other units: every number of a scaled copy is that of the original, scaled, to the last bit.
//!
//! Lengths are larger by a power of 4, times by the same power of 2, masses by a power of 2: nothing is rounded, so that
//! a copy with other bits shows a number with a unit where none may be.

use super::{Amount, CaseResult, Context};
use crate::row::Row;
use crate::scene_units::Units;
use polhode::{BodySample, Effects, Recorder, Simulation};
use std::error::Error;
use std::path::Path;

/// Seconds of each scene that are compared in a plain run.
const PART_S: f64 = 0.3;

/// Powers of lengths and of masses.
const POWERS: [(i32, i32); 2] = [(-3, 4), (5, 3)];

/// The samples of a scene file in these units.
fn samples(path: &Path, units: Units, most_s: f64) -> Result<Recorder, Box<dyn Error>> {
    let text = units.text(&std::fs::read_to_string(path)?, most_s)?;
    let loaded = polhode_scene::load_text(&path.display().to_string(), &text, &[])?;
    let mut record = Recorder::default();
    Simulation::new(&loaded.scene, Effects::Planned)?.run(&mut record)?;
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
    let pairs = original.samples.iter().zip(&copy.samples).zip(&original.times);
    let is_other = |(before, after): (&Vec<BodySample>, &Vec<BodySample>)| {
        before.iter().zip(after).any(|(before, after)| !is_same(units, before, after))
    };
    let first = pairs.into_iter().find(|&((before, after), _)| is_other((before, after))).map(|(_, &t)| t);
    let is_shorter = original.samples.len() != copy.samples.len();
    first.or_else(|| is_shorter.then(|| original.times.last().copied().unwrap_or_default()))
}

/// Every shipped scene in other units.
pub(super) fn shipped(context: &Context) -> CaseResult {
    let most_s = if context.amount == Amount::Full { f64::INFINITY } else { PART_S };
    let mut others = vec![Vec::new(); POWERS.len()];
    let names = context.shipped.names()?;
    for name in &names {
        let path = context.shipped.path(name);
        let original = samples(&path, Units::of_powers(0, 0), most_s)?;
        for (&(power, mass_power), others) in POWERS.iter().zip(&mut others) {
            let units = Units::of_powers(power, mass_power);
            if let Some(t) = departure(units, &original, &samples(&path, units, most_s)?) {
                others.push(format!("{name} ({t} s)"));
            }
        }
    }
    let row = |(&(power, mass_power), others): (&(i32, i32), &Vec<String>)| {
        let what = format!(
            "shipped scenes with other bits, of {}: lengths x 4^{power}, times x 2^{power}, masses x 2^{mass_power}",
            names.len()
        );
        let found = if others.is_empty() { "none".to_owned() } else { others.join(" ") };
        Row::exact("other units", &what, "none", found)
    };
    Ok(POWERS.iter().zip(&others).map(row).collect())
}
