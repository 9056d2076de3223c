//! The Pareto front: what is not beaten in both cost and error.

use crate::difference::worst;

/// An error as large as the motion, or of a radian: what is worse is no answer, however cheap.
const NO_ANSWER: f64 = 1.0;

/// A candidate as the front sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Point {
    cost: f64,
    error: f64,
}

impl Point {
    /// What costs `cost`, in any unit, and is `error` from a reference that is itself known to `floor`: an error below
    /// that is equal to it.
    pub(crate) fn new(cost: f64, error: f64, floor: f64) -> Self {
        Self { cost, error: worst(error, floor) }
    }

    /// Its cost.
    #[cfg(test)]
    pub(crate) fn cost(self) -> f64 {
        self.cost
    }

    /// Whether it has a cost and an error, and the error leaves something of the answer.
    fn counts(self) -> bool {
        self.cost.is_finite() && self.error <= NO_ANSWER
    }

    /// Whether it is at least as good in both and better in one; costs closer than `resolution` (relative) are not
    /// told apart.
    fn beats(self, other: Self, resolution: f64) -> bool {
        let is_cheaper = self.cost < other.cost * (1.0 - resolution);
        (is_cheaper && self.error <= other.error) || (self.cost <= other.cost && self.error < other.error)
    }
}

/// Which of the points no other beats. Equal points stand on the front together, and so do equally accurate ones whose
/// costs are closer than `resolution`; one that is no answer never does.
pub(crate) fn front(points: &[Point], resolution: f64) -> Vec<bool> {
    let beaten = |point: &Point| points.iter().any(|other| other.counts() && other.beats(*point, resolution));
    points.iter().map(|point| point.counts() && !beaten(point)).collect()
}

/// Number of the cheapest point whose error is known to be at most `target`; the more accurate of equally cheap ones.
pub(crate) fn cheapest(points: &[Point], target: f64) -> Option<usize> {
    let reaching = points.iter().enumerate().filter(|(_, point)| point.counts() && point.error <= target);
    let order = |a: &Point, b: &Point| a.cost.total_cmp(&b.cost).then(a.error.total_cmp(&b.error));
    reaching.min_by(|(_, a), (_, b)| order(a, b)).map(|(number, _)| number)
}

/// Whether two costs cannot be told apart: the ranges between which half of the measurements of each are overlap.
pub(crate) fn is_tie(a: [f64; 2], b: [f64; 2]) -> bool {
    a[0] <= b[1] && b[0] <= a[1]
}

#[cfg(test)]
mod tests {
    //! Dominance with ties, with what is no answer, and below what is known about the reference.
    use super::*;

    fn points<const N: usize>(pairs: [(f64, f64); N], floor: f64) -> [Point; N] {
        pairs.map(|(cost, error)| Point::new(cost, error, floor))
    }

    #[test]
    fn what_is_beaten_in_both_is_not_on_it() {
        let points = points([(1.0, 1.0), (2.0, 0.1), (2.0, 0.5), (3.0, 0.1), (4.0, 0.01)], 0.0);
        assert_eq!(front(&points, 0.0), [true, true, false, false, true]);
    }

    #[test]
    fn equal_points_are_on_it_together() {
        assert_eq!(front(&points([(1.0, 0.1), (1.0, 0.1), (1.0, 0.2)], 0.0), 0.0), [true, true, false]);
        assert_eq!(front(&[], 0.0), [] as [bool; 0]);
    }

    #[test]
    fn costs_that_cannot_be_told_apart_are_equal() {
        let points = points([(1.0, 1e-9), (1.04, 1e-9), (1.2, 1e-9), (1.04, 1e-8)], 0.0);
        assert_eq!(front(&points, 0.05), [true, true, false, false]);
    }

    #[test]
    fn what_is_no_answer_is_not_on_it_and_beats_nothing() {
        let nan = f64::NAN;
        let points = points([(nan, 0.0), (1.0, nan), (f64::INFINITY, 0.0), (5.0, 0.5), (0.0, 1.5)], 0.0);
        assert_eq!(front(&points, 0.0), [false, false, false, true, false]);
    }

    #[test]
    fn no_error_below_the_reference_s_own_counts() {
        let pairs = [(1.0, 2e-13), (2.0, 1e-15), (0.5, 1e-3)];
        assert_eq!(front(&points(pairs, 1e-12), 0.0), [true, false, true]);
        assert_eq!(front(&points(pairs, 1e-14), 0.0), [true, true, true]);
    }

    #[test]
    fn costs_within_each_other_s_noise_are_a_tie() {
        assert!(is_tie([1.0, 1.2], [1.1, 1.4]) && is_tie([1.0, 2.0], [1.4, 1.5]) && is_tie([1.0, 1.1], [1.1, 1.2]));
        assert!(!is_tie([1.0, 1.1], [1.2, 1.3]) && !is_tie([f64::NAN; 2], [1.0, 1.0]));
    }

    #[test]
    fn the_cheapest_that_reaches_a_target() {
        let pairs = [(1.0, 1e-3), (3.0, 1e-9), (2.0, 1e-8), (2.0, 1e-9), (0.1, f64::NAN)];
        assert_eq!(cheapest(&points(pairs, 0.0), 1e-8), Some(3));
        assert_eq!(cheapest(&points(pairs, 0.0), 1e-2), Some(0));
        assert_eq!(cheapest(&points(pairs, 0.0), 1e-10), None);
        assert_eq!(cheapest(&points(pairs, 1e-7), 1e-8), None, "the reference is not known that well");
    }
}
