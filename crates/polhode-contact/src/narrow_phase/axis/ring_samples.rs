//! Adaptive samples of the distance of a circle from a convex body, which isolate its lowest minima.
//!
//! The signed distance `d` from a convex body is a convex function of the point `x`: with its gradient `g` at a sample
//! `x_k`, `d(x) >= d(x_k) + g.(x - x_k)` everywhere. Along a circle `x = c + R u(a)` (`a` the angle) this bound is a
//! cosine, and between two samples the larger of their two cosines bounds the distance from below. An arc whose bound
//! is below the wanted distance, and below the distance at both of its ends, is divided where the bound is least. The
//! division ends when one element of the body is nearest to both ends of an arc no longer than a forty-eighth of the
//! circle: the minima there are common normals with that element, which are found otherwise (`ring.rs`). The points to
//! which one element of a convex body is nearest form a convex set, which contains the chord of the arc. The arc itself
//! deviates from the chord by up to 0.002 of the radius; so it fails where another element is nearest between arc and
//! chord only, and such a minimum may be missed. It also fails where more than [`MOST`] divisions would be needed.

use crate::SurfaceFeature;
use crate::shape::circle::Circle;
use glam::DVec3;
use polhode_spatial::rounding;
use smallvec::SmallVec;
use std::f64::consts::{PI, TAU};

/// Number of initial samples: arcs must be shorter than half the circle for two cosines to bound the distance.
const FIRST: usize = 16;

/// An arc no longer than the circle divided by this number is not divided further when one element is nearest to both
/// ends.
const FINE: u32 = 48;

/// Most divisions in all: a ring around a hundred corners needs about 350.
const MOST: u32 = 4096;

/// An arc is divided no nearer to its ends than this fraction of its length.
const LEAST_PART: f64 = 0.03125;

/// The distance at one point of the circle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sample {
    pub(crate) angle: f64,
    /// From the circle's centre to the point, m.
    pub(crate) arm: DVec3,
    /// Signed distance of the point from the other body, m; negative inside.
    pub(crate) distance: f64,
    /// Its gradient: unit vector from the other body to the point. Not finite where it does not exist.
    pub(crate) normal: DVec3,
    /// The element of the other body that is nearest.
    pub(crate) feature: SurfaceFeature,
}

/// The limits of the search.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wanted {
    /// Minima up to this distance are wanted, m, and the least one.
    pub(crate) reach: f64,
    /// An upper bound of the least distance, m.
    pub(crate) least: f64,
    /// Distances that differ by less are equal, m.
    pub(crate) tolerance: f64,
}

/// Calls `visit` with the minima of the distance from a convex body: the lowest sample of each, the larger angle from
/// it to the samples beside it (rad), and the least distance so far.
pub(crate) fn each_minimum(
    circle: &Circle,
    sample: impl Fn(f64) -> Sample,
    wanted: Wanted,
    visit: impl FnMut(&Sample, f64, f64),
) {
    let first: [Sample; FIRST] = equal(&sample);
    let mut least = first.iter().map(|sample| sample.distance).fold(wanted.least, f64::min);
    let mut divisions = 0;
    let divide = |from: &Sample, to: &Sample| {
        let (bound, angle) = least_between(from, to, circle);
        let width = to.angle - from.angle;
        let unseen = bound < from.distance.min(to.distance) - wanted.tolerance && bound < least.max(wanted.reach);
        let of_one_element = from.feature == to.feature && width <= TAU / f64::from(FINE);
        if !unseen || of_one_element || width <= rounding::HALF_OF_THE_DIGITS || divisions >= MOST {
            return None;
        }
        divisions += 1;
        // A margin from the ends makes both halves clearly shorter when the bound is least at an end.
        let margin = width * LEAST_PART;
        let new = sample(angle.clamp(from.angle + margin, to.angle - margin));
        least = least.min(new.distance);
        Some(new)
    };
    walk(&first, wanted, divide, visit);
}

fn equal<const N: usize>(sample: &impl Fn(f64) -> Sample) -> [Sample; N] {
    let step = TAU / N as f64;
    std::array::from_fn(|k| sample(step * k as f64))
}

/// Visits all arcs once around the circle, and divides those that need it.
fn walk(
    samples: &[Sample],
    wanted: Wanted,
    mut divide: impl FnMut(&Sample, &Sample) -> Option<Sample>,
    mut visit: impl FnMut(&Sample, f64, f64),
) {
    let Some(&first) = samples.first() else { return };
    let (mut lowest, mut highest) = (first.distance, first.distance);
    let mut least = samples.iter().map(|sample| sample.distance).fold(wanted.least, f64::min);
    let is_lowest = |[before, at, after]: [&Sample; 3]| at.distance <= before.distance && at.distance < after.distance;
    let width = |[before, at, after]: [&Sample; 3]| (at.angle - before.angle).max(after.angle - at.angle);
    let turned = |sample: &Sample, by: f64| Sample { angle: sample.angle + by, ..*sample };
    let mut ends: SmallVec<[Sample; 64]> = SmallVec::new();
    let (mut before, mut from, mut second) = (None, first, None);
    for next in samples.iter().skip(1).copied().chain([turned(&first, TAU)]) {
        ends.push(next);
        while let Some(&to) = ends.last() {
            if let Some(new) = divide(&from, &to) {
                ends.push(new);
                continue;
            }
            ends.pop();
            least = least.min(to.distance);
            if second.is_none() {
                second = Some(to);
            }
            if let Some(three) = before.as_ref().map(|before| [before, &from, &to]).filter(|&three| is_lowest(three)) {
                visit(&from, width(three), least);
            }
            (lowest, highest) = (lowest.min(to.distance), highest.max(to.distance));
            (before, from) = (Some(from), to);
        }
    }
    let (Some(last), Some(second)) = (before, second) else { return };
    let last = turned(&last, -TAU);
    let three = [&last, &first, &second];
    // All distances are equal for a ring that lies flat on a face.
    if is_lowest(three) || highest - lowest <= wanted.tolerance {
        visit(&first, width(three), least);
    }
}

/// `value + east cos(a) + north sin(a)`: the lower bound of the distance at the angle a from one sample.
#[derive(Clone, Copy)]
struct Cosine {
    value: f64,
    east: f64,
    north: f64,
}

impl Cosine {
    fn at(self, angle: f64) -> f64 {
        let (sine, cosine) = libm::sincos(angle);
        self.value + self.east * cosine + self.north * sine
    }

    /// The angle at which it is least.
    fn lowest(self) -> f64 {
        libm::atan2(-self.north, -self.east)
    }
}

/// The minimum, between two samples, of the larger of their two bounds, and its angle.
fn least_between(from: &Sample, to: &Sample, circle: &Circle) -> (f64, f64) {
    let middle = 0.5 * (from.angle + to.angle);
    if !(from.normal.is_finite() && to.normal.is_finite()) {
        // Without a gradient, the bound follows from the distances at the ends and the length of the arc.
        let way = circle.radius * (to.angle - from.angle);
        return (0.5 * (from.distance + to.distance - way), middle);
    }
    // Angles are relative to the first sample, so that a short arc loses no digits.
    let east = from.arm / circle.radius;
    let north = circle.axis.cross(east);
    let bound = |sample: &Sample| Cosine {
        value: sample.distance - sample.normal.dot(sample.arm),
        east: circle.radius * sample.normal.dot(east),
        north: circle.radius * sample.normal.dot(north),
    };
    let (first, second) = (bound(from), bound(to));
    let difference =
        Cosine { value: first.value - second.value, east: first.east - second.east, north: first.north - second.north };
    let width = to.angle - from.angle;
    let (phase, amplitude) = (difference.lowest() + PI, libm::hypot(difference.east, difference.north));
    let half = libm::acos((-difference.value / amplitude).clamp(-1.0, 1.0));
    let mut best = (f64::INFINITY, 0.5 * width);
    for angle in [0.0, width, phase - half, phase + half, first.lowest(), second.lowest()] {
        let angle = if angle == width { width } else { angle.rem_euclid(TAU) };
        let value = first.at(angle).max(second.at(angle));
        if (0.0..=width).contains(&angle) && value < best.0 {
            best = (value, angle);
        }
    }
    (best.0, from.angle + best.1)
}
