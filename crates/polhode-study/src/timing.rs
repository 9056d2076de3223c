//! Time as a ratio: every candidate in turn, round after round, and the median over the rounds.
//!
//! What slows a machine down (another program, heat, a changing clock) slows all candidates of a round alike, so the
//! ratio to a candidate of the same round repeats where seconds do not. What is left is the noise of timing: it is
//! given as the range that holds the middle half of a candidate's ratios.

use crate::source::Source;
use polhode::Scene;
use std::time::Duration;

/// How long timing goes on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effort {
    /// Rounds of every candidate at the least.
    pub fewest_rounds: usize,
    /// Rounds of a candidate at the most.
    pub most_rounds: usize,
    /// Once a candidate has run for this long, s, its rounds may end.
    pub enough_s: f64,
}

/// Rounds from which on the spread of the ratios says how noisy they are.
const FEWEST_FOR_NOISE: usize = 3;

/// Noise that is taken for fewer rounds, relative: what times differ by from run to run on a machine that does nothing
/// else.
const UNMEASURED_NOISE: f64 = 0.1;

/// What a candidate takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Timing {
    /// Of the time of the base candidate: median over the rounds.
    pub ratio: f64,
    /// The ratios between which the middle half of the rounds is; 10 % each way where there are fewer than three.
    pub spread: [f64; 2],
    /// Median, s.
    pub seconds: f64,
    /// Rounds.
    pub rounds: usize,
}

/// Times the scenes in rounds; one that fails has the reason instead. `base` is what ratios are relative to.
pub fn interleaved(source: &Source<'_>, scenes: &[Scene], base: usize, effort: Effort) -> Vec<Result<Timing, String>> {
    let mut taken: Vec<Result<Vec<f64>, String>> = vec![Ok(Vec::new()); scenes.len()];
    for round in 0..effort.most_rounds {
        let going: Vec<bool> = taken.iter().map(|times| goes_on(times, round, effort)).collect();
        if !going.contains(&true) {
            break;
        }
        for (number, scene) in scenes.iter().enumerate() {
            // The base runs in every round: ratios need it.
            if let (true, Ok(times)) = (going[number] || number == base, &mut taken[number]) {
                match source.run(scene) {
                    Ok((_, took)) => times.push(seconds(took)),
                    Err(reason) => taken[number] = Err(reason),
                }
                source.host.part_done();
            }
        }
    }
    let reference = taken.get(base).and_then(|times| times.clone().ok()).unwrap_or_default();
    taken.into_iter().map(|times| times.and_then(|times| timing(&times, &reference))).collect()
}

fn goes_on(times: &Result<Vec<f64>, String>, round: usize, effort: Effort) -> bool {
    times.as_ref().is_ok_and(|times| round < effort.fewest_rounds || times.iter().sum::<f64>() < effort.enough_s)
}

/// A time that a clock of coarse ticks calls zero is a tick of a nanosecond: a cost is positive.
fn seconds(took: Duration) -> f64 {
    took.max(Duration::from_nanos(1)).as_secs_f64()
}

fn timing(times: &[f64], base: &[f64]) -> Result<Timing, String> {
    let ratios: Vec<f64> = times.iter().zip(base).map(|(time, base)| time / base).collect();
    match (median(&ratios), median(times)) {
        (Some(ratio), Some(seconds)) => {
            Ok(Timing { ratio, spread: spread(&ratios, ratio), seconds, rounds: times.len() })
        }
        _ => Err("it was not timed: the candidate that ratios are relative to failed".to_owned()),
    }
}

/// The quartiles of the ratios, whose median is known.
fn spread(ratios: &[f64], median: f64) -> [f64; 2] {
    if ratios.len() < FEWEST_FOR_NOISE {
        return [median * (1.0 - UNMEASURED_NOISE), median * (1.0 + UNMEASURED_NOISE)];
    }
    let mut sorted = ratios.to_vec();
    sorted.sort_by(f64::total_cmp);
    // Between neighbours a quartile is interpolated (Hyndman and Fan 1996, definition 7).
    [0.25, 0.75].map(|part| {
        let place = part * (sorted.len() - 1) as f64;
        let below = place.floor() as usize;
        let above = (below + 1).min(sorted.len() - 1);
        sorted[below] + (place - place.floor()) * (sorted[above] - sorted[below])
    })
}

/// The middle of the sorted numbers; the mean of the two middle ones of an even count.
pub fn median(numbers: &[f64]) -> Option<f64> {
    let mut sorted = numbers.to_vec();
    sorted.sort_by(f64::total_cmp);
    let upper = *sorted.get(sorted.len() / 2)?;
    if sorted.len() % 2 == 1 { Some(upper) } else { Some(f64::midpoint(sorted[sorted.len() / 2 - 1], upper)) }
}

#[cfg(test)]
mod tests {
    //! Ratios are those of the same round; no clock is read.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;

    #[test]
    fn a_machine_that_slows_down_changes_no_ratio() {
        let base = [1.0, 2.0, 8.0];
        let slower = [3.0, 6.0, 24.0];
        let three = Timing { ratio: 3.0, spread: [3.0, 3.0], seconds: 6.0, rounds: 3 };
        assert_eq!(timing(&slower, &base), Ok(three));
        assert_eq!(timing(&base, &base).unwrap().ratio, 1.0);
        assert!(timing(&slower, &[]).is_err());
    }

    #[test]
    fn the_median_is_the_middle() {
        assert_eq!(median(&[]), None);
        assert_eq!(median(&[3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(&[4.0, 1.0, 2.0, 3.0]), Some(2.5));
    }

    #[test]
    fn the_noise_is_the_middle_half_of_the_rounds() {
        let base = [1.0; 5];
        assert_eq!(timing(&[5.0, 1.0, 2.0, 100.0, 3.0], &base).unwrap().spread, [2.0, 5.0]);
        assert_eq!(timing(&[1.0, 2.0, 4.0], &base).unwrap().spread, [1.5, 3.0]);
        assert_eq!(timing(&[2.0, 2.0], &base).unwrap().spread, [1.8, 2.2], "two rounds say nothing about noise");
    }

    #[test]
    fn rounds_end_when_enough_is_known() {
        let effort = Effort { fewest_rounds: 3, most_rounds: 10, enough_s: 0.2 };
        assert!(goes_on(&Ok(vec![1.0, 1.0]), 2, effort), "three rounds at the least");
        assert!(!goes_on(&Ok(vec![1.0; 3]), 3, effort));
        assert!(goes_on(&Ok(vec![0.01; 3]), 3, effort));
        assert!(!goes_on(&Err(String::new()), 0, effort));
    }
}
