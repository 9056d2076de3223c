//! Leaving out what a scene does not call for, and skipping what rests, changes no bit of the result.

use super::free_rotation::bits;
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use polhode::Effects;
use std::error::Error;

/// Every sample of every shipped scene, with the planned effects and with all.
pub(super) fn planned_equals_all(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for name in context.shipped.names()? {
        let quantity = format!("{name}: first sample that differs from effects = all");
        rows.push(match compare(context, &name) {
            Ok(difference) => Row::exact("effects", &quantity, "none", difference.as_deref().unwrap_or("none")),
            Err(error) => Row::broken("effects", &quantity, error.to_string()),
        });
    }
    Ok(rows)
}

fn compare(context: &Context, scene: &str) -> Result<Option<String>, Box<dyn Error>> {
    let planned = context.shipped.run(scene)?;
    let all = Run::of(&planned.scene, Effects::All)?;
    Ok(first_difference(&planned, &all))
}

/// Time and body of the first sample in which two runs differ in a bit.
fn first_difference(a: &Run, b: &Run) -> Option<String> {
    if a.record.times.len() != b.record.times.len() {
        return Some(format!("{} and {} samples", a.record.times.len(), b.record.times.len()));
    }
    for (number, (sample_a, sample_b)) in a.record.samples.iter().zip(&b.record.samples).enumerate() {
        for (body, (state_a, state_b)) in sample_a.iter().zip(sample_b).enumerate() {
            if bits(state_a) != bits(state_b) || a.record.times[number] != b.record.times[number] {
                return Some(format!("t = {} s, body {}", a.record.times[number], a.scene.bodies()[body].name()));
            }
        }
    }
    None
}
