//! Motion through samples: a curve of positions and orientations.
//!
//! **Position.** Between two samples the position is a polynomial of degree five, determined by position, velocity and
//! acceleration at both ends. At the first and the last sample both are zero. At inner samples they depend on the
//! interpolation ([`Interpolation`]):
//!
//! | interpolation | velocity and acceleration at an inner sample | continuous | order for smooth samples |
//! |---|---|---|---|
//! | spline | those of the clamped cubic spline (velocity zero at both ends) | pose, velocity, acceleration | 4 |
//! | monotone | the same, limited (`monotone`) | pose, velocity, acceleration | 4; 2 next to where a coordinate turns |
//! | linear | none: the velocity is constant between samples | pose | 2 |
//!
//! With `spline` the path is that spline away from the ends. `monotone` limits what would make a coordinate leave the
//! range of two neighbouring samples.
//!
//! **Orientation.** The same for rotation vectors: between samples k and k + 1 `R(t) = exp(theta(t)) R_k`, theta of
//! degree five from zero to the rotation vector `phi_k` of `R_(k+1) R_k^-1`, with the angular velocity and acceleration
//! of both ends ([`super::turning`]). Those come from the clamped cubic spline whose steps are
//! `phi_k + h_k^2 (w_k x w_(k+1))/12`, the integral of the angular velocity but for terms of order h^5 (the commutator
//! of Magnus' expansion), with w from a first spline through the `phi_k` themselves. About one axis this is the spline
//! of the angle, over any number of turns. Monotone interpolation limits the rates as it does those of positions, with
//! the steps `phi_k`: about one axis the angle is monotone where its samples are, and equal samples are a hold. Linear
//! interpolation turns with constant angular velocity from sample to sample.
//!
//! Before the first and after the last sample the body stands still. At samples the third derivatives jump, with linear
//! interpolation the velocities. Orders of the error are those of samples of a smooth motion that starts and ends with
//! zero velocity and acceleration. Spline and linear interpolation do not depend on the frames of world and body;
//! monotone interpolation depends on the axes of the world, since it treats each coordinate alone.
//!
//! **Limits.** From one sample to the next the body may turn by less than half a turn: quaternions do not determine
//! more, and rotation vectors must not change by more. Like every cubic spline the spline overshoots where samples that
//! are close in time and far in position follow others that are not ([`SampledCurve::excursion`] says how far).
//!
//! Sources: docs/REFERENCES.md, de Boor 1978; Park and Ravani 1997 for splines of rotations in rotation vectors from
//! sample to sample.

use super::displacement::Displacement;
use super::error::{LARGEST_TURN, MotionError, number, vector, within_reach};
use super::excursion::Excursion;
use super::interpolation::Interpolation;
use super::monotone;
use super::polynomial::{Jet, Quintic, knot_rates};
use super::turning;
use crate::report::acceleration::Acceleration;
use polhode_spatial::rounding;
use polhode_spatial::{DVec3, Isometry, MotionBounds, Pose, Rotation, Velocity};

/// The orientations of a table.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum SampledOrientations {
    /// Rotations of the body's axes into the world's.
    Rotations(Vec<Rotation>),
    /// The same as rotation vectors, rad. Their lengths may exceed a turn, so that a table can count turns.
    RotationVectors(Vec<DVec3>),
}

impl SampledOrientations {
    fn len(&self) -> usize {
        match self {
            Self::Rotations(rotations) => rotations.len(),
            Self::RotationVectors(vectors) => vectors.len(),
        }
    }

    /// The rotations, when no two successive ones differ by more than [`LARGEST_TURN`].
    fn checked(&self) -> Result<Vec<Rotation>, MotionError> {
        let too_far = |angles: &mut dyn Iterator<Item = f64>| {
            // Written so that NaN is refused.
            let found = angles.enumerate().find(|(_, angle)| !matches!(angle, 0.0..=LARGEST_TURN));
            found.map_or(Ok(()), |(step, angle)| Err(MotionError::Turn { index: step + 1, angle }))
        };
        match self {
            Self::Rotations(rotations) => {
                for rotation in rotations {
                    for component in rotation.to_wxyz() {
                        number("an orientation", component)?;
                    }
                }
                too_far(&mut rotations.windows(2).map(|pair| pair[0].angle_to(pair[1])))?;
                Ok(rotations.clone())
            }
            Self::RotationVectors(vectors) => {
                for &rotation in vectors {
                    vector("a rotation vector", rotation)?;
                }
                too_far(&mut vectors.windows(2).map(|pair| (pair[1] - pair[0]).length()))?;
                Ok(vectors.iter().map(|&rotation| Rotation::from_rotation_vector(rotation)).collect())
            }
        }
    }
}

/// Samples of a motion at increasing times: positions of the body's own origin and orientations, in the world. What is
/// absent stays as in the body's initial pose.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MotionTable {
    /// Times, s; two or more, increasing.
    pub times_s: Vec<f64>,
    /// Positions of the body's own origin, m; one for each time.
    pub positions_m: Option<Vec<DVec3>>,
    /// Orientations; one for each time.
    pub orientations: Option<SampledOrientations>,
    /// What is between the samples.
    pub interpolation: Interpolation,
}

/// Positions and the polynomials between them.
#[derive(Debug, Clone, PartialEq)]
struct Path {
    knots: Vec<DVec3>,
    between: Vec<Quintic>,
}

/// Orientations and the polynomials of the rotation vectors between them.
#[derive(Debug, Clone, PartialEq)]
struct Turns {
    knots: Vec<Rotation>,
    between: Vec<Quintic>,
}

/// How a body begins a motion: its pose, velocity and acceleration of its own origin.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Departure<'a> {
    pub(crate) pose: &'a Pose,
    pub(crate) velocity: &'a Velocity,
    pub(crate) acceleration: &'a Acceleration,
}

/// A motion through samples.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SampledCurve {
    interpolation: Interpolation,
    times: Vec<f64>,
    path: Option<Path>,
    turns: Option<Turns>,
}

/// The place of a time among the samples.
enum Place {
    /// Before the first or after the last sample: at this sample, standing still.
    Standing(usize),
    /// Between this sample and the next one, after this fraction of the time between them.
    Between(usize, f64),
}

impl SampledCurve {
    pub(super) fn new(table: &MotionTable) -> Result<Self, MotionError> {
        let times = checked_times(&table.times_s)?;
        let count = |quantity, found: Option<usize>| match found {
            Some(found) if found != times.len() => Err(MotionError::Count { quantity, found, times: times.len() }),
            _ => Ok(()),
        };
        count("positions", table.positions_m.as_ref().map(Vec::len))?;
        count("orientations", table.orientations.as_ref().map(SampledOrientations::len))?;
        if table.positions_m.is_none() && table.orientations.is_none() {
            return Err(MotionError::EmptyTable);
        }
        let spacings: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let kind = table.interpolation;
        let path = table.positions_m.as_ref().map(|positions| Path::new(&spacings, positions, kind)).transpose()?;
        let turns = table.orientations.as_ref().map(|turns| Turns::new(&spacings, turns, kind)).transpose()?;
        let curve = Self { interpolation: kind, times, path, turns };
        within_reach(&curve.bounds(f64::NEG_INFINITY, f64::INFINITY))?;
        Ok(curve)
    }

    /// The motion from one pose at the first time to another at the second, which begins with this velocity and
    /// acceleration and ends with none.
    ///
    /// # Errors
    /// When the times do not increase, or a number, a speed or an acceleration is too large.
    pub(super) fn approach(times: [f64; 2], start: &Departure<'_>, end: &Pose) -> Result<Self, MotionError> {
        let times = checked_times(&times)?;
        let h = times[1] - times[0];
        let places = [start.pose.translation, end.translation];
        for place in places {
            vector("a position", place)?;
        }
        let between = |value: DVec3, velocity: DVec3, acceleration: DVec3| {
            // What the motion ends with is the same for a position and for a rotation vector: no rate.
            let end = Jet { value, first: DVec3::ZERO, second: DVec3::ZERO };
            vec![Quintic::between(velocity * h, acceleration * h * h, &end)]
        };
        let turns = [start.pose.rotation, end.rotation];
        let turn = (turns[1] * turns[0].inverse()).to_rotation_vector();
        let (velocity, acceleration) = (start.velocity, start.acceleration);
        let path = Path {
            between: between(places[1] - places[0], velocity.linear, acceleration.linear),
            knots: places.to_vec(),
        };
        let turns = Turns { between: between(turn, velocity.angular, acceleration.angular), knots: turns.to_vec() };
        let curve = Self { interpolation: Interpolation::Spline, times, path: Some(path), turns: Some(turns) };
        within_reach(&curve.bounds(f64::NEG_INFINITY, f64::INFINITY))?;
        Ok(curve)
    }

    /// The same in a space set otherwise: what is between the samples is moved as they are, whatever the axes by which
    /// it was found.
    pub(super) fn moved(&self, space: &Isometry) -> Self {
        let path = self.path.as_ref().map(|path| Path {
            knots: path.knots.iter().map(|&knot| space.point(knot)).collect(),
            between: path.between.iter().map(|own| own.mapped(|v| space.vector(v))).collect(),
        });
        let turns = self.turns.as_ref().map(|turns| Turns {
            knots: turns.knots.iter().map(|&knot| space.rotation(knot)).collect(),
            between: turns.between.iter().map(|own| own.mapped(|v| space.axial(v))).collect(),
        });
        Self { interpolation: self.interpolation, times: self.times.clone(), path, turns }
    }

    pub(super) const fn interpolation(&self) -> Interpolation {
        self.interpolation
    }

    /// Whether the table has positions, and whether it has orientations.
    pub(super) const fn gives(&self) -> (bool, bool) {
        (self.path.is_some(), self.turns.is_some())
    }

    fn place(&self, t: f64) -> Place {
        let next = self.times.partition_point(|&time| time <= t);
        match (next.checked_sub(1), self.times.get(next)) {
            (Some(k), Some(&end)) => {
                let start = self.times[k];
                Place::Between(k, (t - start) / (end - start))
            }
            (Some(last), None) => Place::Standing(last),
            (None, _) => Place::Standing(0),
        }
    }

    fn spacing(&self, k: usize) -> f64 {
        self.times[k + 1] - self.times[k]
    }

    /// Position and orientation at `t` (s), not relative to the initial pose; zero and the identity where the table has
    /// none.
    pub(super) fn at(&self, t: f64) -> Displacement {
        let mut at = Displacement::default();
        match self.place(t) {
            Place::Standing(k) => {
                at.translation = self.path.as_ref().map_or(DVec3::ZERO, |path| path.knots[k]);
                at.rotation = self.turns.as_ref().map_or(Rotation::IDENTITY, |turns| turns.knots[k]);
            }
            Place::Between(k, x) => {
                let h = self.spacing(k);
                if let Some(path) = &self.path {
                    let jet = path.between[k].at(x);
                    at.translation = path.knots[k] + jet.value;
                    at.velocity = jet.first / h;
                    at.acceleration = jet.second / h / h;
                }
                if let Some(turns) = &self.turns {
                    let jet = turns.between[k].at(x);
                    at.rotation = Rotation::from_rotation_vector(jet.value) * turns.knots[k];
                    let (velocity, acceleration) = turning::rates(&jet);
                    at.angular_velocity = velocity / h;
                    at.angular_acceleration = acceleration / h / h;
                }
            }
        }
        at
    }

    pub(super) fn bounds(&self, t0: f64, t1: f64) -> MotionBounds {
        let (from, to) = (t0.min(t1), t0.max(t1));
        let mut bounds = MotionBounds::default();
        let first = self.times.partition_point(|&time| time <= from).saturating_sub(1);
        for k in first..self.times.len() - 1 {
            let (start, end) = (self.times[k], self.times[k + 1]);
            if start > to {
                break;
            }
            if end <= from {
                continue;
            }
            let at = |t: f64| (t.clamp(start, end) - start) / (end - start);
            bounds = larger(&bounds, &self.bounds_between(k, at(from), at(to)));
        }
        // There is no bound for a time that is not a number.
        if t0.is_nan() || t1.is_nan() { infinite() } else { bounds }
    }

    /// Bounds between sample `k` and the next one, from the fraction `x0` of the time between them to `x1`.
    fn bounds_between(&self, k: usize, x0: f64, x1: f64) -> MotionBounds {
        let h = self.spacing(k);
        let mut bounds = MotionBounds::default();
        if let Some(path) = &self.path {
            let rates = path.between[k].rates(x0, x1);
            bounds.speed = rates.first / h;
            bounds.acceleration = rates.second / h / h;
        }
        if let Some(turns) = &self.turns {
            let polynomial = &turns.between[k];
            let rates = polynomial.rates(x0, x1);
            let acceleration = rates.second + 0.5 * rates.first * rates.first.min(rates.aside);
            let middle = turning::rates(&polynomial.at(0.5 * (x0 + x1))).0.length();
            let near = middle + acceleration * (0.5 * (x1 - x0).abs()) + turning::ANGLE_ROUNDING * rates.first;
            bounds.angular_speed = rates.first.min(near) / h;
            bounds.angular_acceleration = acceleration / h / h;
        }
        bounds
    }

    /// The farthest that the curve comes from the range of two neighbouring samples, in the largest of its coordinates
    /// of one unit; positions before orientations. None where it stays within, but for rounding.
    pub(super) fn excursion(&self) -> Option<Excursion> {
        const POSITION: [&str; 3] = ["x", "y", "z"];
        const TURN: [&str; 3] = ["the rotation vector's x", "the rotation vector's y", "the rotation vector's z"];
        let none: &[Quintic] = &[];
        let path = self.path.as_ref().map_or(none, |path| &path.between);
        let turns = self.turns.as_ref().map_or(none, |turns| &turns.between);
        let start = |k: usize| self.path.as_ref().map_or(DVec3::ZERO, |path| path.knots[k]);
        let farthest = self.farthest(path, POSITION, "m").map(|found| {
            let axis = POSITION.iter().position(|name| *name == found.coordinate).unwrap_or_default();
            Excursion { value: found.value + start(found.sample)[axis], ..found }
        });
        farthest.or_else(|| self.farthest(turns, TURN, "rad"))
    }

    /// The farthest that polynomials, each from zero to a step, come from the range of both; values relative to their
    /// starts.
    fn farthest(&self, polynomials: &[Quintic], names: [&'static str; 3], unit: &'static str) -> Option<Excursion> {
        let mut farthest: Option<Excursion> = None;
        for (sample, polynomial) in polynomials.iter().enumerate() {
            let end = polynomial.at(1.0).value;
            for (axis, coordinate) in names.into_iter().enumerate() {
                for x in polynomial.extremes(axis) {
                    let value = polynomial.at(x).value[axis];
                    let beyond = (value - end[axis].max(0.0)).max(end[axis].min(0.0) - value);
                    let least = farthest.map_or(0.0, |found| found.beyond);
                    if beyond > polynomial.rounding() && beyond > least {
                        let t_s = self.times[sample] + x * self.spacing(sample);
                        farthest = Some(Excursion { coordinate, unit, value, beyond, t_s, sample });
                    }
                }
            }
        }
        farthest
    }

    /// The first sample strictly between the times `from` and `to` (s, `from < to`) at which the velocity jumps, by
    /// more than the digits of the samples leave open: its time, s. Only linear interpolation has any.
    pub(super) fn jump_between(&self, from: f64, to: f64) -> Option<f64> {
        if self.interpolation != Interpolation::Linear {
            return None;
        }
        let samples = self.times.iter().enumerate().filter(|&(_, &t)| from < t && t < to);
        samples.filter(|&(k, _)| self.jumps_at(k)).map(|(_, &t)| t).next()
    }

    fn jumps_at(&self, k: usize) -> bool {
        let path = self.path.as_ref().map(|path| {
            let size = path.knots[k].length();
            (&path.between, size)
        });
        let turns = self.turns.as_ref().map(|turns| (&turns.between, LARGEST_TURN));
        path.into_iter().chain(turns).any(|(between, size)| {
            let velocity = |k: usize| (between[k].at(0.0).first / self.spacing(k), self.spacing(k));
            let still = (DVec3::ZERO, f64::INFINITY);
            let (before, h_before) = k.checked_sub(1).map_or(still, velocity);
            let (after, h_after) = if k < between.len() { velocity(k) } else { still };
            let digits = rounding::FEW_TERMS * (size + before.length().max(after.length()) * self.times[k].abs());
            let steps = rounding::FEW_TERMS * (before.length() + after.length());
            (after - before).length() > digits * (1.0 / h_before + 1.0 / h_after) + steps
        })
    }

    pub(super) fn corner_between(&self, from: f64, to: f64) -> Option<f64> {
        let times = &self.times;
        let corner = if from < to {
            times.get(times.partition_point(|&time| time <= from))
        } else {
            times.partition_point(|&time| time < from).checked_sub(1).and_then(|last| times.get(last))
        };
        corner.copied().filter(|&time| from.min(to) < time && time < from.max(to))
    }
}

impl Path {
    fn new(spacings: &[f64], positions: &[DVec3], kind: Interpolation) -> Result<Self, MotionError> {
        for &position in positions {
            vector("a position", position)?;
        }
        let steps: Vec<DVec3> = positions.windows(2).map(|pair| pair[1] - pair[0]).collect();
        if kind == Interpolation::Linear {
            let between = steps.into_iter().map(Quintic::line).collect();
            return Ok(Self { knots: positions.to_vec(), between });
        }
        let rates = rates_of(kind, spacings, &steps, &steps);
        let between = spacings.iter().zip(&steps).zip(rates.windows(2)).map(|((&h, &value), rates)| {
            let (start, end) = (rates[0], rates[1]);
            let end = Jet { value, first: end.0 * h, second: end.1 * h * h };
            Quintic::between(start.0 * h, start.1 * h * h, &end)
        });
        Ok(Self { knots: positions.to_vec(), between: between.collect() })
    }
}

impl Turns {
    fn new(spacings: &[f64], orientations: &SampledOrientations, kind: Interpolation) -> Result<Self, MotionError> {
        let knots = orientations.checked()?;
        let steps: Vec<DVec3> =
            knots.windows(2).map(|pair| (pair[1] * pair[0].inverse()).to_rotation_vector()).collect();
        if kind == Interpolation::Linear {
            let between = steps.into_iter().map(Quintic::line).collect();
            return Ok(Self { knots, between });
        }
        let rough = knot_rates(spacings, &steps);
        let integrals: Vec<DVec3> = spacings
            .iter()
            .zip(&steps)
            .zip(rough.windows(2))
            .map(|((&h, &step), rates)| step + (rates[0].0 * h).cross(rates[1].0 * h) / 12.0)
            .collect();
        let rates = rates_of(kind, spacings, &integrals, &steps);
        let between = spacings.iter().zip(&steps).zip(rates.windows(2)).map(|((&h, &step), rates)| {
            let (start, end) = (rates[0], rates[1]);
            Quintic::between(start.0 * h, start.1 * h * h, &turning::jet(step, end.0 * h, end.1 * h * h))
        });
        let between = between.collect();
        Ok(Self { knots, between })
    }
}

/// Rates at the samples: those of the spline through `splined` steps, limited where `kind` is monotone so that the
/// `steps` of the samples are not overshot.
fn rates_of(kind: Interpolation, spacings: &[f64], splined: &[DVec3], steps: &[DVec3]) -> Vec<(DVec3, DVec3)> {
    let rates = knot_rates(spacings, splined);
    match kind {
        Interpolation::Monotone => monotone::limited(spacings, steps, &rates),
        Interpolation::Spline | Interpolation::Linear => rates,
    }
}

fn checked_times(times: &[f64]) -> Result<Vec<f64>, MotionError> {
    for &time in times {
        number("a time", time)?;
    }
    if times.len() < 2 {
        return Err(MotionError::TooFewSamples(times.len()));
    }
    for (index, pair) in times.windows(2).enumerate() {
        if pair[1] <= pair[0] {
            return Err(MotionError::TimeOrder { index: index + 1, t: pair[1], before: pair[0] });
        }
    }
    Ok(times.to_vec())
}

fn larger(a: &MotionBounds, b: &MotionBounds) -> MotionBounds {
    // f64::max of a number and NaN is the number; a bound that is NaN must be kept.
    let most = |a: f64, b: f64| if a >= b { a } else { b };
    MotionBounds {
        speed: most(a.speed, b.speed),
        acceleration: most(a.acceleration, b.acceleration),
        angular_speed: most(a.angular_speed, b.angular_speed),
        angular_acceleration: most(a.angular_acceleration, b.angular_acceleration),
    }
}

const fn infinite() -> MotionBounds {
    MotionBounds {
        speed: f64::INFINITY,
        acceleration: f64::INFINITY,
        angular_speed: f64::INFINITY,
        angular_acceleration: f64::INFINITY,
    }
}
