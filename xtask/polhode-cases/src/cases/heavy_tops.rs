//! Heavy tops: HT-01 to HT-03 and HT-05 about a fixed tip, HT-04 on a frictionless floor (elliptic integrals).
//!
//! Lagrange's top of these cases: 1 kg, centre of mass 0.5 m from the tip, moments about the tip 1 kg m^2 across the
//! axis and 0.5 along it. Angles are Euler's about z, x, z; phi = 0 is the axis leaning towards -y. The inclination is
//! largest where its rate falls through zero; the cusps of nutation, where it is smallest, are no good for that.

use super::bodies::half_space;
use super::motion::{Crossing, angle_between, counted_on, least_turn, state_at, zeros};
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::contact::Shape;
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodySample, Effects, Scene, SceneBuilder};
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, TAU};

/// Distance of the centre of mass from the tip, m.
const LENGTH: f64 = 0.5;
/// Moments about the centre of mass, kg m^2.
const MOMENTS: DVec3 = DVec3::new(0.75, 0.75, AXIAL);
/// Moment about the axis, kg m^2.
pub(crate) const AXIAL: f64 = 0.5;
/// Moment across the axis about the tip, kg m^2.
pub(crate) const ACROSS: f64 = 1.0;
/// `m g l`, N m.
pub(crate) const WEIGHT: f64 = 4.905;

/// How far the axis may be from that of the reduced motion after ten seconds by rows: what the reference is held to.
const BY_ROWS: f64 = 1e-9;

fn properties(center_of_mass: DVec3) -> Result<MassProperties, Box<dyn Error>> {
    Ok(MassProperties::new(Mass::new(1.0)?, center_of_mass, Inertia::from_diagonal(MOMENTS)?))
}

/// A top on a fixed tip, its axis inclined towards -y.
pub(super) fn top(inclination: f64, angular_velocity: DVec3) -> Result<SceneBuilder, Box<dyn Error>> {
    let body = Body::movable("top", properties(DVec3::Z * LENGTH)?)
        .pose(Pose::new(lean(inclination), DVec3::ZERO))
        .pivot(DVec3::ZERO)
        .velocity(Velocity::new(DVec3::ZERO, angular_velocity));
    Ok(Scene::builder("heavy top").body(body))
}

/// A top with this spin (total angular velocity along its axis) that precesses at this rate without nodding.
pub(crate) fn precessing(inclination: f64, spin: f64, rate: f64) -> Result<SceneBuilder, Box<dyn Error>> {
    let axis = lean(inclination).rotate(DVec3::Z);
    top(inclination, axis * spin + (DVec3::Z - axis * axis.z) * rate)
}

pub(crate) fn lean(inclination: f64) -> Rotation {
    Rotation::from_rotation_vector(DVec3::X * inclination)
}

fn axis(sample: &BodySample) -> DVec3 {
    sample.pose.rotation.rotate(DVec3::Z)
}

fn inclination(sample: &BodySample) -> f64 {
    angle_between(axis(sample), DVec3::Z)
}

/// The rate of the inclination, rad/s.
fn inclination_rate(sample: &BodySample) -> f64 {
    let axis = axis(sample);
    -sample.velocity.angular.cross(axis).z / axis.x.hypot(axis.y)
}

/// phi: where the axis leans to.
fn azimuth(sample: &BodySample) -> f64 {
    let axis = axis(sample);
    axis.x.atan2(-axis.y)
}

/// psi: how far the top is turned about its axis.
fn proper_rotation(sample: &BodySample) -> f64 {
    let turn = sample.pose.rotation;
    turn.rotate(DVec3::X).z.atan2(turn.rotate(DVec3::Y).z)
}

/// An angle of the first body at the end of a run, counted on through the samples.
fn turned(run: &Run, angle: impl Fn(&BodySample) -> f64) -> f64 {
    counted_on(run.record.samples.iter().filter_map(|bodies| bodies.first()).map(angle))
}

/// Mean rate of precession over some time, rad/s.
fn precession_rate(scene: &Scene) -> Result<f64, Box<dyn Error>> {
    Ok(turned(&Run::of(scene, Effects::Planned)?, azimuth) / scene.duration_s())
}

/// The two steady precessions, and a small nutation about the slow one.
pub(super) fn ht_01(context: &Context) -> CaseResult {
    /// Rate of nodding at the start, rad/s: its square is what the small-angle formula leaves out.
    const NODDING: f64 = 1e-4;
    let (lean_by, spin) = (FRAC_PI_6, 20.0);
    // Steady precession: A rate^2 cos(theta) - C spin rate + m g l = 0.
    let (a, b) = (ACROSS * lean_by.cos(), AXIAL * spin);
    let root = (b * b - 4.0 * a * WEIGHT).sqrt();
    let (slow, fast) = (2.0 * WEIGHT / (b + root), (b + root) / (2.0 * a));
    let measured = |rate: f64| precession_rate(&precessing(lean_by, spin, rate)?.duration_s(10.0).build()?);
    let axis = lean(lean_by).rotate(DVec3::Z);
    let nodding = axis * spin + (DVec3::Z - axis * axis.z) * slow + DVec3::X * NODDING;
    let scene = top(lean_by, nodding)?.duration_s(3.0).build()?;
    let times = zeros(&scene, 4, Crossing::Falling, inclination_rate)?;
    let row = |quantity: &str, measured: f64| context.reference.row("HT-01", quantity, measured);
    Ok(vec![
        row("slow precession rate, rad/s", measured(slow)?)?,
        row("fast precession rate, rad/s", measured(fast)?)?,
        row("small-nutation frequency about the slow precession, rad/s", 3.0 * TAU / (times[3] - times[0]))?,
    ])
}

/// The largest inclination (deg), the period of nutation (s) and the precession in a period (rad), from the first two
/// times at which the inclination is largest.
fn nutation(scene: &Scene) -> Result<[f64; 3], Box<dyn Error>> {
    let times = zeros(scene, 2, Crossing::Falling, inclination_rate)?;
    let (first, second) = (state_at(scene, times[0])?, state_at(scene, times[1])?);
    let precession = least_turn(azimuth(&second) - azimuth(&first));
    Ok([inclination(&first).to_degrees(), times[1] - times[0], precession])
}

/// Let go with nothing but its spin: the axis falls, turns aside and rises to a cusp.
pub(super) fn ht_02(context: &Context) -> CaseResult {
    let spin = lean(FRAC_PI_6).rotate(DVec3::Z) * 20.0;
    let scene = top(FRAC_PI_6, spin)?.duration_s(10.0).build()?;
    let [largest, period, precession] = nutation(&scene)?;
    let run = Run::of(&scene, Effects::Planned)?;
    let end = run.last("top")?;
    let angles = [inclination(&end), inclination_rate(&end), turned(&run, azimuth), turned(&run, proper_rotation)];
    let row = |quantity: &str, measured: f64| context.reference.row("HT-02", quantity, measured);
    // With all effects on rows hold the tip, with forces of constraint at every stage.
    let by_rows = axis(&Run::of(&scene, Effects::All)?.last("top")?);
    Ok(vec![
        row("largest inclination, deg", largest)?,
        row("nutation period, s", period)?,
        row("precession in a nutation period, rad", precession)?,
        row("mean precession rate, rad/s", precession / period)?,
        context.reference.row("HT-02", "theta, theta', phi, psi at t = 10 s", angles)?,
        context.reference.row("HT-02", "axis at t = 10 s", axis(&end).to_array())?,
        Row::at_most(
            "HT-02",
            "axis at t = 10 s by rows at the tip: difference",
            BY_ROWS,
            (by_rows - axis(&end)).length(),
        ),
    ])
}

/// A top that sleeps upright: stable above a critical spin, falling exponentially below it.
pub(super) fn ht_03(context: &Context) -> CaseResult {
    /// Inclination at the start, rad: its square is what the small-angle formulas leave out.
    const SEED: f64 = 1e-7;
    /// The inclination of a top that is stable never exceeds that of the start, but for that square and rounding.
    const STABLE: f64 = 1e-6;
    // In axes that turn at C spin / (2 A) a top at rest falls as cosh(rate t), or swings as cos(rate t).
    let start = |spin: f64, duration_s: f64| {
        let scene = precessing(SEED, spin, 0.5 * AXIAL * spin / ACROSS)?.duration_s(duration_s).build()?;
        Ok::<_, Box<dyn Error>>(scene)
    };
    let growth = |spin: f64, duration_s: f64| -> Result<f64, Box<dyn Error>> {
        let end = Run::of(&start(spin, duration_s)?, Effects::Planned)?.last("top")?;
        Ok((inclination(&end) / SEED).acosh() / duration_s)
    };
    let critical = 2.0 * (ACROSS * WEIGHT).sqrt() / AXIAL;
    // Near the critical spin the square of the rate is as good as straight.
    let below = [0.995 * critical, 0.999 * critical];
    let squares = [growth(below[0], 20.0)?.powi(2), growth(below[1], 20.0)?.powi(2)];
    let measured = below[1] + squares[1] * (below[1] - below[0]) / (squares[0] - squares[1]);
    let above = Run::of(&start(1.001 * critical, 60.0)?, Effects::Planned)?;
    let largest = above.record.samples.iter().filter_map(|bodies| bodies.first()).map(inclination).fold(0.0, f64::max);
    let falling = start(0.9 * critical, 25.0)?;
    let lowest = zeros(&falling, 1, Crossing::Falling, inclination_rate)?[0];
    let lowest = inclination(&state_at(&falling, lowest)?).to_degrees();
    let row = |quantity: &str, measured: f64| context.reference.row("HT-03", quantity, measured);
    Ok(vec![
        row("critical spin, rad/s", measured)?,
        row("growth rate at 0.9 of the critical spin, 1/s", growth(0.9 * critical, 6.0)?)?,
        row("largest inclination at 0.9 of the critical spin, deg", lowest)?,
        Row::at_most(
            "HT-03",
            "growth of the inclination at 1.001 of the critical spin, 60 s",
            STABLE,
            (largest / SEED - 1.0).max(0.0),
        ),
    ])
}

/// A top whose tip slides on a frictionless floor: its centre of mass moves up and down only.
pub(super) fn ht_04(context: &Context) -> CaseResult {
    /// Largest movement of the centre of mass sideways, m: nothing pushes it.
    const SIDEWAYS_M: f64 = 1e-12;
    let scene = top_on_floor()?.duration_s(1.2).build()?;
    let [largest, period, precession] = nutation(&scene)?;
    let run = Run::of(&scene, Effects::Planned)?;
    let centers = run.record.samples.iter().filter_map(|bodies| bodies.first()).map(|top| top.pose.translation);
    let sideways = centers.map(|center| center.x.hypot(center.y)).fold(0.0, f64::max);
    let row = |quantity: &str, measured: f64| context.reference.row("HT-04", quantity, measured);
    Ok(vec![
        row("largest inclination, deg", largest)?,
        row("nutation period, s", period)?,
        row("precession in a nutation period, rad", precession)?,
        Row::at_most("HT-04", "sideways movement of the centre of mass in 1.2 s, m", SIDEWAYS_M, sideways),
    ])
}

/// The top of HT-04: its tip is a point on the floor.
pub(super) fn top_on_floor() -> Result<SceneBuilder, Box<dyn Error>> {
    let turn = lean(FRAC_PI_6);
    let axis = turn.rotate(DVec3::Z);
    let tip = Shape::points(vec![DVec3::NEG_Z * LENGTH])?;
    let body = Body::movable("top", properties(DVec3::ZERO)?)
        .geometry(tip.into())
        .pose(Pose::new(turn, DVec3::Z * (axis.z * LENGTH)))
        .velocity(Velocity::new(DVec3::ZERO, axis * 20.0));
    Ok(Scene::builder("top on a floor").body(body).body(half_space("floor", UnitVector::Z)))
}

/// A wheel on a horizontal axle.
pub(super) fn ht_05(context: &Context) -> CaseResult {
    let (spin, rate) = (50.0, WEIGHT / (AXIAL * 50.0));
    let rate = precession_rate(&precessing(FRAC_PI_2, spin, rate)?.duration_s(10.0).build()?)?;
    Ok(vec![context.reference.row("HT-05", "precession rate, rad/s", rate)?])
}
