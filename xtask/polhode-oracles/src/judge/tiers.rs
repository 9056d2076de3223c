//! Whether a run by fixed steps goes to the accurate motion as its steps become shorter, and whether two copies of a
//! scene are one motion. Nothing is known here but the poses that were sampled.
//!
//! Distances are in parts of a body: `|x - y|/size` and the angle (rad) between the attitudes, of the body that is
//! farthest off, at any sample so far.
//!
//! | symbol | unit | is |
//! |---|---|---|
//! | `h` | s | step |
//! | `e(h)` | - | distance of the run from the accurate one |
//! | `g` | - | growth: the distance of the accurate run from one that starts 1e-9 elsewhere, over 1e-9; at least 1 |
//! | `r` | 1/s | rate: the largest velocity of any body in its own sizes, and the largest angular velocity |
//!
//! An event that is seen a step late shifts a motion by at most what it moves meanwhile, so that an error of first
//! order is at most `C h r g`. Samples are judged up to the first at which that bound for the shortest step is a
//! quarter of a body, or `g` is above a thousand: what is beyond that is not known to better. A run is wrong if `e` at
//! the shortest step is above that bound and has not fallen to half of that at the longest step; between events, where
//! the order is 2, if `e` has fallen by less than the power 1.5 of the ratio of steps, unless it is rounding.
//!
//! It fails where growth is not that of the start but of something within the piece (a corner that just meets an edge):
//! growth is then underestimated, and the run is called wrong. Such scenes are told from others by shorter steps.

use glam::{DQuat, DVec3};

/// By this part the run that shows growth starts elsewhere (no unit, 1e-10 to 1e-8: above the errors of the tier
/// `accurate`, and below what changes the order of events).
pub const DISTURBED: f64 = 1e-9;
/// The factor of the bound of first order (no unit): two velocities, before an event and after, and one more body.
const LATE: f64 = 4.0;
/// Growth beyond which nothing is judged (no unit).
const MOST_GROWTH: f64 = 1e3;
/// Bound beyond which nothing is judged, in bodies.
const VAGUE: f64 = 0.25;
/// Distances below this are those of the accurate run and of rounding, in bodies.
const EXACT: f64 = 1e-8;
/// The least order between events (no unit): halfway between 1 and 2.
const LEAST_ORDER: f64 = 1.5;
/// Copies may be this far apart, in bodies, and this many times what grows from the disturbance.
const COPY: f64 = 1e-9;
const COPY_GROWN: f64 = 2.0;

/// Poses of all bodies at the times of samples; bodies whose size is not finite are not compared.
#[derive(Debug, Clone, Default)]
pub struct Poses {
    /// Position and orientation of every body, at every time.
    pub rows: Vec<Vec<(DVec3, DQuat)>>,
    /// The largest velocity in sizes and angular velocity, 1/s.
    pub rate: f64,
}

/// What is judged by.
#[derive(Debug)]
pub struct Standard {
    sizes: Vec<f64>,
    accurate: Poses,
    /// Growth at each sample.
    growth: Vec<f64>,
}

/// How far a row of runs goes to the accurate one.
#[derive(Debug, Clone, PartialEq)]
pub struct Convergence {
    /// Steps, s, and distances in bodies, the longest step first.
    pub errors: Vec<(f64, f64)>,
    /// Number of samples judged.
    pub judged: usize,
    /// The bound of first order at the shortest step, in bodies.
    pub bound: f64,
    /// Growth at the last sample judged.
    pub growth: f64,
    /// The number of the body that is farthest off at the shortest step.
    pub body: usize,
}

/// The distance of two poses, in sizes.
fn apart(size: f64, a: (DVec3, DQuat), b: (DVec3, DQuat)) -> f64 {
    if a == b {
        return 0.0;
    }
    let turned = (a.1.inverse() * b.1).normalize();
    let angle = 2.0 * libm::asin(turned.xyz().length().min(1.0));
    (a.0 - b.0).length() / size + angle
}

/// The largest distance so far, at every sample that both have, and the number of the body.
fn distances(sizes: &[f64], a: &Poses, b: &Poses) -> Vec<(f64, usize)> {
    let (mut most, mut body) = (0.0f64, 0);
    a.rows
        .iter()
        .zip(&b.rows)
        .map(|(a, b)| {
            let bodies = sizes.iter().zip(a.iter().zip(b)).enumerate();
            for (number, (size, (a, b))) in bodies.filter(|(_, (size, _))| size.is_finite()) {
                let here = apart(*size, *a, *b);
                // What is not a number is farthest.
                (most, body) = if here <= most { (most, body) } else { (here, number) };
            }
            (most, body)
        })
        .collect()
}

impl Standard {
    /// From the accurate run and the one that starts a little elsewhere.
    pub fn new(sizes: Vec<f64>, accurate: Poses, disturbed: &Poses) -> Self {
        let growth =
            distances(&sizes, &accurate, disturbed).into_iter().map(|(far, _)| (far / DISTURBED).max(1.0)).collect();
        Self { sizes, accurate, growth }
    }

    /// The same growth about another run.
    pub fn with(&self, poses: Poses) -> Self {
        Self { sizes: self.sizes.clone(), accurate: poses, growth: self.growth.clone() }
    }

    fn bound(&self, step: f64, sample: usize) -> f64 {
        LATE * step * self.accurate.rate * self.growth[sample]
    }

    /// The samples that can be judged with this shortest step.
    fn horizon(&self, step: f64) -> usize {
        (0..self.growth.len())
            .take_while(|&sample| self.growth[sample] < MOST_GROWTH && self.bound(step, sample) < VAGUE)
            .count()
    }

    /// How runs of some steps go to the accurate one; nothing if no sample after the start can be judged.
    pub fn convergence(&self, runs: &[(f64, &Poses)]) -> Option<Convergence> {
        let shortest = runs.last()?.0;
        let far: Vec<Vec<(f64, usize)>> =
            runs.iter().map(|(_, poses)| distances(&self.sizes, &self.accurate, poses)).collect();
        let judged = far.iter().map(Vec::len).min()?.min(self.horizon(shortest));
        let last = judged.checked_sub(1).filter(|last| *last > 0)?;
        let errors = runs.iter().zip(&far).map(|((step, _), far)| (*step, far[last].0)).collect();
        let body = far.last()?[last].1;
        Some(Convergence { errors, judged, bound: self.bound(shortest, last), growth: self.growth[last], body })
    }

    /// The first sample at which a copy is another motion: its number, the distance and the number of the body.
    pub fn departure(&self, copy: &Poses, floor: f64) -> Option<(usize, f64, usize)> {
        let far = distances(&self.sizes, &self.accurate, copy);
        far.iter()
            .zip(&self.growth)
            .take_while(|(_, growth)| **growth < MOST_GROWTH)
            .position(|((far, _), growth)| {
                let most = floor.max(COPY) + COPY_GROWN * (growth - 1.0) * DISTURBED;
                far.is_nan() || *far > most
            })
            .map(|sample| (sample, far[sample].0, far[sample].1))
    }

    /// The largest distance of a copy, in bodies.
    pub fn distance(&self, copy: &Poses) -> f64 {
        distances(&self.sizes, &self.accurate, copy).last().map_or(f64::INFINITY, |(far, _)| *far)
    }
}

impl Convergence {
    /// The order over all steps; infinite where nothing is left of the error.
    pub fn order(&self) -> f64 {
        let (Some((long, first)), Some((short, last))) = (self.errors.first(), self.errors.last()) else { return 0.0 };
        libm::log(first / last) / libm::log(long / short)
    }

    /// Whether the runs go to the accurate motion as they should.
    pub fn is_right(&self, is_smooth: bool) -> bool {
        let (Some((_, first)), Some((_, last))) = (self.errors.first(), self.errors.last()) else { return false };
        if *last <= EXACT * self.growth {
            return true;
        }
        if is_smooth { self.order() >= LEAST_ORDER } else { *last <= self.bound || *last <= 0.5 * first }
    }
}

#[cfg(test)]
mod tests {
    //! Errors of the first and the second order are right, errors that stay are wrong, and what grows is not judged
    //! beyond its horizon.
    use super::*;

    const STEPS: [f64; 3] = [4e-3, 2e-3, 1e-3];

    /// A body that moves at 1 m/s, of 1 m, with an error of its place that grows from zero to this, and a growth.
    fn track(error: f64) -> Poses {
        let rows = (0..=10).map(|k| {
            let t = 0.1 * f64::from(k);
            vec![(DVec3::X * (t + error * t), DQuat::IDENTITY)]
        });
        Poses { rows: rows.collect(), rate: 1.0 }
    }

    fn judged(errors: [f64; 3], growth: f64) -> Convergence {
        let standard = Standard::new(vec![1.0], track(0.0), &track(growth * DISTURBED));
        let runs: Vec<Poses> = errors.into_iter().map(track).collect();
        let runs: Vec<(f64, &Poses)> = STEPS.into_iter().zip(&runs).collect();
        standard.convergence(&runs).expect("a distance at some sample")
    }

    #[test]
    fn errors_that_fall_as_they_should_are_right() {
        assert!(judged([1.6e-3, 4e-4, 1e-4], 1.0).is_right(true));
        assert!(!judged([4e-3, 2e-3, 1e-3], 1.0).is_right(true));
        assert!(judged([4e-3, 2e-3, 1e-3], 1.0).is_right(false));
    }

    #[test]
    fn errors_that_stay_are_wrong_if_no_late_event_explains_them() {
        assert!(!judged([0.1, 0.1, 0.1], 1.0).is_right(false));
        assert!(judged([2e-3, 3e-3, 2e-3], 1.0).is_right(false));
        assert!(judged([0.1, 0.1, 0.1], 100.0).judged < 11);
    }

    #[test]
    fn rounding_is_right() {
        assert!(judged([1e-10, 3e-10, 2e-10], 1.0).is_right(true));
    }

    #[test]
    fn a_copy_departs_where_it_is_farther_than_what_grows() {
        let standard = Standard::new(vec![1.0], track(0.0), &track(5.0 * DISTURBED));
        assert_eq!(standard.departure(&track(4e-9), 0.0), None);
        assert!(standard.departure(&track(1e-7), 0.0).is_some());
    }
}
