//! Measuring motions: the state of a body at any time, zeros of what is measured on it, angles that count their turns.
//!
//! A state at a time is that at the end of a run of its own up to there, so that what is measured is what users get and
//! no interpolation of the case's own comes in.

use super::run::Run;
use glam::DVec3;
use polhode::{BodySample, Effects, ErrorEstimation, Scene, Simulation};
use std::error::Error;
use std::f64::consts::{PI, TAU};

/// Evaluations in the search for a zero at most; some ten are needed.
const MOST_EVALUATIONS: usize = 60;

/// The state of the first body at a time, s.
///
/// # Errors
/// When the scene does not run.
pub(super) fn state_at(scene: &Scene, t: f64) -> Result<BodySample, Box<dyn Error>> {
    let scene = scene.clone().with_duration(t)?;
    let report = Simulation::new(&scene)?.estimating(ErrorEstimation::Off).run()?;
    Ok(report.bodies.first().ok_or("the scene has no body")?.state)
}

/// Angular velocity in body axes, rad/s.
pub(super) fn body_rate(sample: &BodySample) -> DVec3 {
    sample.pose.rotation.inverse_rotate(sample.velocity.angular)
}

/// Angular momentum of a body with these principal moments along its own axes, world, kg m^2/s.
pub(super) fn angular_momentum(moments: DVec3, sample: &BodySample) -> DVec3 {
    sample.pose.rotation.rotate(moments * body_rate(sample))
}

/// Angle between two vectors, rad, accurate also when it is tiny.
pub(super) fn angle_between(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// Which zeros count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Crossing {
    /// Every one.
    Any,
    /// From above zero to below: a maximum of what the function is the rate of.
    Falling,
}

/// The first `count` zeros of a function of the first body's state, s: bracketed by the samples of one run, and refined
/// by runs that end there.
///
/// # Errors
/// When there are fewer, or a run fails.
pub(crate) fn zeros(
    scene: &Scene,
    count: usize,
    crossing: Crossing,
    function: impl Fn(&BodySample) -> f64,
) -> Result<Vec<f64>, Box<dyn Error>> {
    let run = Run::of(scene, Effects::Planned)?;
    let values: Vec<f64> = run.record.samples.iter().filter_map(|bodies| bodies.first()).map(&function).collect();
    let mut found = Vec::new();
    for (times, values) in run.record.times_s.windows(2).zip(values.windows(2)) {
        let falls = values[0] > 0.0 && values[1] <= 0.0;
        let rises = values[0] < 0.0 && values[1] >= 0.0;
        if found.len() < count && (falls || (rises && crossing == Crossing::Any)) {
            found.push(zero([times[0], times[1]], |t| {
                // A run of no time is none: what is asked for at t = 0 is the first sample.
                if t == 0.0 { Ok(values[0]) } else { state_at(scene, t).map(|sample| function(&sample)) }
            })?);
        }
    }
    if found.len() < count {
        return Err(format!("only {} of {count} zeros within {} s", found.len(), scene.duration_s()).into());
    }
    Ok(found)
}

/// The zero of a function between two points of different sign: secants that keep it bracketed (Illinois), to rounding.
pub(super) fn zero(
    [mut a, mut b]: [f64; 2],
    mut function: impl FnMut(f64) -> Result<f64, Box<dyn Error>>,
) -> Result<f64, Box<dyn Error>> {
    let (mut at_a, mut at_b) = (function(a)?, function(b)?);
    if at_a == 0.0 {
        return Ok(a);
    }
    for _ in 0..MOST_EVALUATIONS {
        if at_b == 0.0 || (b - a).abs() <= f64::EPSILON * b.abs() {
            break;
        }
        let secant = b - at_b * (b - a) / (at_b - at_a);
        let inside = (secant - a) * (secant - b) < 0.0;
        let next = if inside { secant } else { 0.5 * (a + b) };
        if next == a || next == b {
            break;
        }
        let value = function(next)?;
        if value * at_b < 0.0 {
            (a, at_a) = (b, at_b);
        } else {
            at_a *= 0.5;
        }
        (b, at_b) = (next, value);
    }
    Ok(b)
}

/// The last of some angles (rad), counted on through all of them from the first; between two of them less than half a
/// turn.
pub(super) fn counted_on(angles: impl IntoIterator<Item = f64>) -> f64 {
    let mut angles = angles.into_iter();
    let Some(mut total) = angles.next() else { return f64::NAN };
    for angle in angles {
        total += least_turn(angle - total);
    }
    total
}

/// An angle as the same one in [-pi, pi).
pub(super) fn least_turn(angle: f64) -> f64 {
    (angle + PI).rem_euclid(TAU) - PI
}

#[cfg(test)]
mod tests {
    //! Zeros are found to rounding and angles count their turns, or nothing measured with them means anything.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn a_zero_is_found_to_rounding() {
        let root = zero([1.0, 4.0], |t| Ok(t * t * t - 5.0)).unwrap();
        assert!((root - 5.0f64.cbrt()).abs() < 1e-15, "{root}");
        assert!((zero([3.0, 3.5], |t: f64| Ok(t.sin())).unwrap() - PI).abs() < 1e-15);
    }

    #[test]
    fn angles_count_their_turns() {
        let angles = (0..=100).map(|k| least_turn(0.3 * f64::from(k)));
        assert!((counted_on(angles) - 30.0).abs() < 1e-12);
    }
}
