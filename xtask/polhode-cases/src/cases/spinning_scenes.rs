//! Scenes of bodies that spin and roll with friction, as they ship: coins, Euler's disc, tippe top, rattleback.
//!
//! | scene | what is known |
//! |---|---|
//! | coins | a thin coin that spins upright is stable above `sqrt(4 g/(5 r))` (Routh) |
//! | Euler's discs | steady rolling with the centre at rest, see [`disc_rate`] |
//! | tippe top | Jellett's number `-L . p` stays: `L` about the centre of mass, `p` from there to the contact |
//! | rattleback | turns round; where it rolls, no energy is lost |

use super::bodies::GRAVITY;
use super::motion::counted_on;
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::{BodySample, EventKind};
use std::error::Error;

const CASE: &str = "scenes of spinning";

/// Tolerance of the rates of the discs, relative.
const RATE: f64 = 1e-9;

/// Limit of the change of Jellett's number, relative.
const JELLETT: f64 = 1e-9;

/// Limit of the energy that changes where a body rolls without slip, relative: the local errors of 1e-11 a step.
const ROLLING_LOSS: f64 = 1e-8;

/// A coin whose axis is steeper than this has fallen over, rad above the horizontal.
const FALLEN: f64 = 0.7;

/// All rows.
pub(super) fn rows(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for part in [coins, discs, tippe_top, rattleback] {
        rows.extend(part(context)?);
    }
    Ok(rows)
}

/// The samples of a body with their times, s.
fn samples(run: &Run, name: &str) -> Result<Vec<(f64, BodySample)>, Box<dyn Error>> {
    let index = run.scene.bodies().iter().position(|body| body.name() == name);
    let index = index.ok_or_else(|| format!("no body {name}"))?;
    let rows = run.record.times_s.iter().zip(&run.record.samples);
    Ok(rows.filter_map(|(t, row)| row.get(index).map(|sample| (*t, *sample))).collect())
}

/// The axis of a body of revolution, its z.
fn axis(sample: &BodySample) -> DVec3 {
    sample.pose.rotation.rotate(DVec3::Z)
}

/// The fast coin stays up, the slow one falls over.
fn coins(context: &Context) -> CaseResult {
    let run = context.shipped.run("spinning-coin")?;
    let mut fallen = Vec::new();
    for name in ["fast coin", "slow coin"] {
        fallen.push(samples(&run, name)?.iter().any(|(_, sample)| axis(sample).z.abs().asin() > FALLEN));
    }
    Ok(vec![Row::exact(CASE, "spinning-coin: which falls over", vec![false, true], fallen)])
}

/// Radius and height of the discs, m.
const DISC_RADIUS_M: f64 = 0.0375;
const DISC_HEIGHT_M: f64 = 0.006;

/// The rate at which the contact of a disc goes round while its centre rests, rad/s, at the inclination `a`.
///
/// The disc turns about the line from its contact to its centre; `W` about the vertical turns its angular momentum, and
/// the moment of its weight about the contact does that: `W^2 sin(a) (A cos(a) - C h sin(a)/(2 r)) = m g (r cos(a) -
/// h sin(a)/2)`, `A = m (r^2/4 + h^2/12)` across the axis, `C = m r^2/2` along it. A thin disc: `W^2 sin(a) = 4 g/r`.
fn disc_rate(inclination: f64) -> f64 {
    let (r, h) = (DISC_RADIUS_M, DISC_HEIGHT_M);
    let (sine, cosine) = inclination.sin_cos();
    let across = r * r / 4.0 + h * h / 12.0;
    let along = r * r / 2.0;
    let moment = GRAVITY * (r * cosine - 0.5 * h * sine);
    (moment / (sine * (across * cosine - along * h * sine / (2.0 * r)))).sqrt()
}

/// Euler's discs: the rates at five inclinations.
fn discs(context: &Context) -> CaseResult {
    let run = context.shipped.run("eulers-disc")?;
    let mut rows = Vec::new();
    for degrees in [60.0, 40.0, 20.0, 10.0, 5.0f64] {
        let name = format!("disc at {degrees} degrees");
        let angles: Vec<f64> = samples(&run, &name)?.iter().map(|(_, s)| axis(s).y.atan2(axis(s).x)).collect();
        let first = *angles.first().ok_or("no sample")?;
        let rate = (counted_on(angles) - first) / run.report.duration_s;
        let quantity = format!("eulers-disc, {degrees} degrees: rate of precession, rad/s");
        rows.push(Row::compared(CASE, &quantity, disc_rate(degrees.to_radians()), rate, Tolerance::Relative(RATE)));
    }
    Ok(rows)
}

/// Tippe top: Jellett's number until the stem touches; and the centre of mass ends up higher.
fn tippe_top(context: &Context) -> CaseResult {
    let run = context.shipped.run("tippe-top")?;
    let body = run.scene.bodies().iter().find(|body| body.name() == "top").ok_or("no top")?;
    let properties = *body.mass_properties().ok_or("no mass")?;
    let center = properties.center_of_mass();
    let radius = body.initial_pose().translation.z;
    let jellett = |sample: &BodySample| {
        let rotation = sample.pose.rotation;
        let local = properties.inertia().matrix() * rotation.inverse_rotate(sample.velocity.angular);
        -rotation.rotate(local).dot(DVec3::Z * -radius - rotation.rotate(center))
    };
    let stem_touches = run.events(EventKind::Impact).first().map_or(f64::INFINITY, |event| event.t_s);
    let samples = samples(&run, "top")?;
    let numbers: Vec<f64> = samples.iter().filter(|(t, _)| *t < stem_touches).map(|(_, s)| jellett(s)).collect();
    let first = *numbers.first().ok_or("no sample")?;
    let drift = numbers.iter().map(|number| (number / first - 1.0).abs()).fold(0.0, f64::max);
    let last = samples.last().ok_or("no sample")?.1;
    let quantity = format!("tippe-top: change of Jellett's number before the stem touches ({stem_touches:.3} s)");
    Ok(vec![
        Row::at_most(CASE, &quantity, JELLETT, drift),
        Row::exact(CASE, "tippe-top: turns over", true, axis(&last).z < -0.5),
    ])
}

/// Rattleback: its spin changes sign, and no energy goes where it does not slip.
fn rattleback(context: &Context) -> CaseResult {
    let run = context.shipped.run("rattleback")?;
    let samples = samples(&run, "rattleback")?;
    let spin = |sample: &BodySample| sample.velocity.angular.z;
    let first = spin(&samples.first().ok_or("no sample")?.1);
    let turns_round = samples.iter().any(|(_, sample)| spin(sample) * first < -REVERSED * first * first);
    let energy = &run.report.energy;
    let kinetic = samples.first().ok_or("no sample")?.1;
    let loss = (energy.final_j - energy.initial_j).abs() / (kinetic.velocity.angular.length_squared() * ENERGY_SCALE);
    Ok(vec![
        Row::exact(CASE, "rattleback: turns round, to a quarter of its spin or more", true, turns_round),
        Row::at_most(CASE, "rattleback: change of energy while it rolls, of its kinetic energy", ROLLING_LOSS, loss),
    ])
}

/// Part of its first spin with which the rattleback turns the other way.
const REVERSED: f64 = 0.25;

/// Half the moment of inertia of the rattleback about the vertical, kg m^2.
const ENERGY_SCALE: f64 = 0.5 * 0.0042;
