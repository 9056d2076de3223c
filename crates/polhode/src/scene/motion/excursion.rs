//! Where a motion through samples leaves the range of two neighbouring samples.

use crate::scene::few_digits::number;
use std::fmt;

/// The farthest that a coordinate of a table comes from the range of the two samples before and after it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Excursion {
    /// What leaves the range: a coordinate of the position, or of the rotation vector from the sample before.
    pub coordinate: &'static str,
    /// Unit of the coordinate: m or rad.
    pub unit: &'static str,
    /// Its value there.
    pub value: f64,
    /// By how much it is out of the range.
    pub beyond: f64,
    /// When, s.
    pub t_s: f64,
    /// Number of the sample before, from 0.
    pub sample: usize,
}

impl fmt::Display for Excursion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { coordinate, unit, sample, .. } = self;
        let [value, beyond, t] = [self.value, self.beyond, self.t_s].map(number);
        write!(
            f,
            "it leaves the range of its samples between sample {sample} and sample {}: {coordinate} = {value} {unit} \
             at t = {t} s, {beyond} {unit} beyond both",
            sample + 1
        )
    }
}
