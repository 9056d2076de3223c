//! A run as readable text.

use polhode::{BodySample, EventKind};
use polhode_cases::Run;
use std::fmt::Write as _;
use strict_hash::hash_words;

/// Samples of a snapshot: enough to see the motion, few enough to read.
const SAMPLES: usize = 20;

/// Kinds of event, in the order of the text.
const EVENT_KINDS: [EventKind; 6] = [
    EventKind::Impact,
    EventKind::ContactBegin,
    EventKind::ContactEnd,
    EventKind::Detach,
    EventKind::Rest,
    EventKind::Wake,
];

/// First word of the line with the strict hash.
pub(super) const HASH_LINE: &str = "strict-hash";

/// The text of a snapshot.
pub(super) fn text(run: &Run, hash: u64) -> String {
    let mut text = String::new();
    let energy = &run.report.energy;
    let _ =
        writeln!(text, "scene {}, {} s, {} samples", run.report.scene, run.report.duration_s, run.record.times_s.len());
    let _ = writeln!(
        text,
        "energy_j initial {} final {} kinetic {} potential {}",
        number(energy.initial_j),
        number(energy.final_j),
        number(energy.kinetic_j),
        number(energy.potential_j)
    );
    let counts = EVENT_KINDS
        .map(|kind| format!("{} {}", kind.word(), run.record.events.iter().filter(|event| event.kind == kind).count()));
    let _ = writeln!(text, "events {}", counts.join(" "));
    let _ = writeln!(text, "{HASH_LINE} {}", hash_words(hash));
    let _ = writeln!(text, "t body px py pz qw qx qy qz vx vy vz wx wy wz");
    for index in chosen(run.record.samples.len()) {
        let bodies = run.scene.bodies().iter().zip(&run.record.samples[index]);
        for (body, sample) in bodies.filter(|(body, _)| !body.is_fixed()) {
            let numbers: Vec<String> = components(sample).iter().map(|&component| number(component)).collect();
            let name = body.name().replace(char::is_whitespace, "_");
            let _ = writeln!(text, "{} {name} {}", number(run.record.times_s[index]), numbers.join(" "));
        }
    }
    text
}

/// The strict hash in the text of a snapshot, as it is written.
pub(super) fn hash_in(text: &str) -> Option<String> {
    text.lines().find_map(|line| line.strip_prefix(HASH_LINE)).map(|words| words.trim().to_owned())
}

/// Indices of the samples of a snapshot: evenly over the run, the first and the last among them.
fn chosen(count: usize) -> Vec<usize> {
    if count <= SAMPLES {
        return (0..count).collect();
    }
    (0..SAMPLES).map(|k| k * (count - 1) / (SAMPLES - 1)).collect()
}

/// Position, orientation (scalar first), velocity, angular velocity. Of the two quaternions of an orientation the one
/// whose first component that is not nearly zero is positive, so that the sign is not a matter of rounding.
fn components(sample: &BodySample) -> [f64; 13] {
    /// A component below this is too small to choose a sign by.
    const NEARLY_ZERO: f64 = 1e-6;
    let mut q = sample.pose.rotation.to_wxyz();
    if q.iter().find(|component| component.abs() > NEARLY_ZERO).is_some_and(|&component| component < 0.0) {
        q = q.map(|component| -component);
    }
    let (p, v, w) = (sample.pose.translation, sample.velocity.linear, sample.velocity.angular);
    [p.x, p.y, p.z, q[0], q[1], q[2], q[3], v.x, v.y, v.z, w.x, w.y, w.z]
}

/// A number with twelve digits and no more characters than it needs.
pub(crate) fn number(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{}", value + 0.0);
    }
    let rounded: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    let (plain, scientific) = (format!("{rounded}"), format!("{rounded:e}"));
    if plain.len() <= scientific.len() { plain } else { scientific }
}

#[cfg(test)]
mod tests {
    //! Numbers are short and keep twelve digits; samples cover the run.
    use super::*;

    #[test]
    fn numbers_keep_twelve_digits() {
        assert_eq!(number(0.1 + 0.2), "0.3");
        assert_eq!(number(-0.0), "0");
        assert_eq!(number(1.0 / 3.0), "0.333333333333");
        assert_eq!(number(1.25e-17), "1.25e-17");
        assert_eq!(number(f64::NAN), "NaN");
    }

    #[test]
    fn samples_begin_and_end_with_the_run() {
        assert_eq!(chosen(3), [0, 1, 2]);
        let many = chosen(6001);
        assert_eq!((many.len(), many[0], many[SAMPLES - 1]), (SAMPLES, 0, 6000));
    }
}
