//! Samples of the distance of a circle from a body, as many as are needed to isolate its lowest minima.
//!
//! The signed distance `d` of a convex body is a convex function of the place: with its gradient `g` at a sample `x_k`,
//! `d(x) >= d(x_k) + g.(x - x_k)` everywhere. Along a circle `x = c + R u(a)` (`a` the angle) this bound is a cosine, and
//! between two samples the larger of their two cosines bounds the distance from below. A stretch whose bound lies below what
//! is asked for, and below the distance at both of its ends, is divided where the bound is least, until one element of the
//! body is nearest to both ends of a stretch no longer than a forty-eighth of the circle: there the minima are that
//! element's, which are known otherwise. The places to which one element of a convex body is nearest form a convex set,
//! which holds the chord of the stretch, but for its arc, which strays from the chord by 0.002 of the radius at most,
//! that is no proof: an element that reaches in between may be overlooked. Fails too where more than [`MOST`] divisions
//! would be needed.

use crate::SurfaceFeature;
use crate::shape::circle::Circle;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Samples at the beginning: stretches are shorter than the half circle that two cosines can bound.
const FIRST: usize = 16;

/// Parts of the circle that are not divided further when both of their ends see one element.
const FINE: u32 = 48;

/// Most divisions within each other; beyond, angles are no longer told apart.
const DEEPEST: usize = 64;

/// Most divisions in all: a ring around a hundred corners takes some 350.
const MOST: u32 = 4096;

/// Stretches below this are not divided, rad: places so near to each other are one to the square root of rounding.
const SHORTEST: f64 = 1e-8;

/// A stretch is divided no nearer to its ends than this part of it.
const LEAST_PART: f64 = 0.03125;

/// The distance at one place of the circle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sample {
    pub(crate) angle: f64,
    /// From the circle's centre to the place, m.
    pub(crate) arm: DVec3,
    /// Of the other body from the place, m; negative inside.
    pub(crate) distance: f64,
    /// Its gradient: unit vector from the other body to the place. Not finite where there is none.
    pub(crate) normal: DVec3,
    /// The element of the other body that is nearest.
    pub(crate) feature: SurfaceFeature,
}

/// The limits of the search.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wanted {
    /// Minima up to this, m, and the least one.
    pub(crate) reach: f64,
    /// Distance known of some place, m.
    pub(crate) least: f64,
    /// Distances that differ by less are equal, m.
    pub(crate) tolerance: f64,
}

/// Calls `visit` with the minima of the distance from a convex body, as samples, with the angle to the farther one of the
/// samples beside each and the least distance known so far.
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
        if !unseen || of_one_element || width <= SHORTEST || divisions >= MOST {
            return None;
        }
        divisions += 1;
        // Well inside, so that both parts are a good deal shorter where the bound is least at an end.
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

/// Visits all stretches once around the circle, and divides those that need it.
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
    let mut ends = [first; DEEPEST];
    let (mut before, mut from, mut second) = (None, first, None);
    for next in samples.iter().skip(1).copied().chain([turned(&first, TAU)]) {
        ends[0] = next;
        let mut count = 1;
        while count > 0 {
            let to = ends[count - 1];
            if let Some(new) = divide(&from, &to).filter(|_| count < DEEPEST) {
                ends[count] = new;
                count += 1;
                continue;
            }
            count -= 1;
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
    // All equal: a ring that lies flat on a face.
    if is_lowest(three) || highest - lowest <= wanted.tolerance {
        visit(&first, width(three), least);
    }
}

/// `value + amplitude cos(a - phase)`: the bound of the distance that a sample gives.
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

/// The least value of the larger of two samples' bounds between them, and where.
fn least_between(from: &Sample, to: &Sample, circle: &Circle) -> (f64, f64) {
    let middle = 0.5 * (from.angle + to.angle);
    if !(from.normal.is_finite() && to.normal.is_finite()) {
        // Without a gradient, the bound follows from the distances at the ends and the length of the stretch.
        let way = circle.radius * (to.angle - from.angle);
        return (0.5 * (from.distance + to.distance - way), middle);
    }
    // Angles are counted from the first sample, so that nothing is lost in a short stretch.
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
