//! FC-03, FC-04, FC-20: boxes that slide on level ground in any direction, on a plate that circles, and on a plank.

use super::bodies::{GRAVITY, cuboid, half_space};
use super::rough_plane::{Plane, end_of, first_event, is_in_equilibrium, rough, threshold};
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::contact::Shape;
use polhode::scene::{Force, Frame, Interpolation, MotionTable, PrescribedMotion, Signal};
use polhode::spatial::{Pose, UnitVector, Velocity};
use polhode::{Body, BodyId, BodySample, Effects, Scene};
use polhode_oracles::random::Random;
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Tolerance of distances, speeds and times, as in the catalogue of cases, relative.
const DISTANCE: f64 = 1e-10;

/// Tolerance of the deviation from a straight line, of the distance.
const STRAIGHT: f64 = 1e-11;

/// A body slower than this fraction of its first speed stands.
const STANDS: f64 = 1e-6;

/// Two bodies move together when their speeds differ by less than this fraction of the first.
const TOGETHER: f64 = 1e-9;

/// Tolerance of the difference of two speeds, m/s.
const APART_M_S: f64 = 1e-13;

/// Length, depth and height of the boxes, m.
const SIZE: DVec3 = DVec3::new(0.4, 0.3, 0.2);

/// A box stops at the same distance in any direction, on a straight line.
pub(super) fn fc_03(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for degrees in [0.0, 15.0, 30.0, 45.0f64] {
        let stop = stop_of(SIZE, 2.0, degrees.to_radians(), 0.0, 0.3)?;
        for mut row in [
            context.reference.row("FC-03", "stopping distance, time", [stop.distance, stop.t])?,
            context.reference.row("FC-03", "lateral deviation", stop.deviation)?,
        ] {
            row.quantity = format!("{degrees} deg: {}", row.quantity);
            rows.push(row);
        }
    }
    rows.extend(random_directions(context)?);
    Ok(rows)
}

/// Boxes of any size and heading, with any speed and friction.
fn random_directions(context: &Context) -> CaseResult {
    /// Boxes at full count.
    const BOXES: usize = 1000;
    let mut random = Random(3);
    let (mut worst, mut deviation) = (0.0f64, 0.0f64);
    let count = context.amount.of(BOXES);
    for _ in 0..count {
        // Flat enough not to tip.
        let size = DVec3::new(random.between(0.5, 2.0), random.between(0.5, 2.0), random.between(0.05, 0.25));
        let (speed, friction) = (random.between(0.1, 10.0), random.between(0.05, 1.5));
        let stop = stop_of(size, speed, random.between(0.0, TAU), random.between(0.0, TAU), friction)?;
        let (t, distance) = (speed / (friction * GRAVITY), speed * speed / (2.0 * friction * GRAVITY));
        worst = worst.max((stop.t / t - 1.0).abs()).max((stop.distance / distance - 1.0).abs());
        deviation = deviation.max(stop.deviation / distance);
    }
    Ok(vec![
        Row::at_most("FC-03", &format!("{count} boxes: error of distance and time, relative"), DISTANCE, worst),
        Row::at_most("FC-03", "deviation from the straight line, of the distance", STRAIGHT, deviation),
    ])
}

/// Where and when a box stopped.
#[derive(Debug)]
struct Stop {
    t: f64,
    distance: f64,
    deviation: f64,
}

/// A box of 1 kg that slides at `speed` along `direction` (rad), turned by `heading` (rad), until it stops.
fn stop_of(size: DVec3, speed: f64, direction: f64, heading: f64, friction: f64) -> Result<Stop, Box<dyn Error>> {
    let along = DVec3::new(direction.cos(), direction.sin(), 0.0);
    let sliding = Plane::LEVEL.lying_box(size, heading, along * speed)?;
    let duration_s = 1.5 * speed / (friction * GRAVITY);
    let scene = Plane::LEVEL.with(sliding, friction)?.duration_s(duration_s).build()?;
    let (t, _) = first_event(&scene, |sample| sample.velocity.linear.length() < STANDS * speed)?;
    let end = end_of(&scene)?.pose.translation;
    Ok(Stop { t, distance: end.dot(along), deviation: along.cross(end - DVec3::Z * end.z).length() })
}

/// Radius and angular velocity of the circle of FC-04, m and rad/s, and the friction on the plate.
const CIRCLE: (f64, f64, f64) = (0.5, 5.0, 0.2);

/// A block on a plate whose points move on circles.
///
/// As seen from the plate, which does not turn, the plate rests and the block bears the force `m A w^2` outwards, which
/// turns with the plate's motion. That is exact; the moving plate itself is a table of poses.
pub(super) fn fc_04(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let seen_from_plate = orbit_of(&plate_at_rest(2.0, CIRCLE.2, true)?, |t| on_circle(t, 0))?;
    let on_moving_plate = orbit_of(&moving_plate(2.0)?, |_| DVec3::ZERO)?;
    let sticks = threshold(1.5, 1.0, |friction| {
        let scene = plate_at_rest(1.0, friction, false)?;
        is_in_equilibrium(&scene)
    })?;
    let mut moving = reference.row("FC-04", "radius, lag (rad), slip speed", on_moving_plate)?;
    moving.quantity = format!("plate moved by a table: {}", moving.quantity);
    Ok(vec![
        reference.row("FC-04", "radius, lag (rad), slip speed", seen_from_plate)?,
        moving,
        reference.row("FC-04", "stick threshold mu = A w^2/g", sticks)?,
    ])
}

/// The place of the plate at `t` (s), or its derivative of this order.
fn on_circle(t: f64, derivative: i32) -> DVec3 {
    let (radius, rate, _) = CIRCLE;
    let angle = rate * t + f64::from(derivative) * FRAC_PI_2;
    DVec3::new(angle.cos(), angle.sin(), 0.0) * (radius * rate.powi(derivative))
}

/// The place of the block in steady motion at t = 0, or its derivative of this order.
fn steady(derivative: i32) -> DVec3 {
    let (radius, rate, friction) = CIRCLE;
    let own = friction * GRAVITY / (rate * rate);
    let angle = -(own / radius).acos() + f64::from(derivative) * FRAC_PI_2;
    DVec3::new(angle.cos(), angle.sin(), 0.0) * (own * rate.powi(derivative))
}

/// A flat block of 1 kg.
fn block(start: DVec3, velocity: DVec3) -> Result<Body, Box<dyn Error>> {
    let size = DVec3::new(0.2, 0.2, 0.02);
    let body = cuboid("block", size, 1.0, start + DVec3::Z * (0.5 * size.z))?;
    Ok(body.velocity(Velocity::new(velocity, DVec3::ZERO)))
}

/// The block as seen from the plate: in steady motion, or at rest.
fn plate_at_rest(duration_s: f64, friction: f64, is_moving: bool) -> Result<Scene, Box<dyn Error>> {
    let (radius, rate, _) = CIRCLE;
    let push = |force: DVec3, phase: f64| -> Result<Force, Box<dyn Error>> {
        let signal = Signal::sinusoid(1.0, rate / TAU, phase)?;
        Ok(Force::Applied {
            body: BodyId::new(0),
            force,
            torque: DVec3::ZERO,
            frame: Frame::World,
            point: None,
            signal,
        })
    };
    let strength = radius * rate * rate;
    let (start, velocity) =
        if is_moving { (steady(0) - on_circle(0.0, 0), steady(1) - on_circle(0.0, 1)) } else { Default::default() };
    let scene = Plane::LEVEL.with(block(start, velocity)?, friction)?.duration_s(duration_s);
    Ok(scene.force(push(DVec3::X * strength, FRAC_PI_2)?).force(push(DVec3::Y * strength, 0.0)?).build()?)
}

/// The block in steady motion on the moving plate.
fn moving_plate(duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    /// Time between samples of the plate's place, s: the cubic spline through them is off by 1e-11 m.
    const SPACING: f64 = 0.002;
    /// The table begins before the run, since at its ends it is at rest.
    const BEFORE: f64 = 0.1;
    let count = ((duration_s + 2.0 * BEFORE) / SPACING).ceil() as usize;
    let times_s: Vec<f64> = (0..=count).map(|k| k as f64 * SPACING - BEFORE).collect();
    let positions_m = Some(times_s.iter().map(|&t| on_circle(t, 0)).collect());
    let interpolation = Interpolation::Spline;
    let motion = PrescribedMotion::table(&MotionTable { times_s, positions_m, orientations: None, interpolation })?;
    let plate = Body::kinematic("plate", motion).geometry(Shape::half_space(UnitVector::Z).into());
    let plate = plate.pose(Pose::from_translation(on_circle(0.0, 0)));
    let friction = CIRCLE.2;
    let scene =
        Scene::builder("block on a circling plate").body(block(steady(0), steady(1))?.material(rough(friction)?));
    Ok(scene.body(plate.material(rough(friction)?)).duration_s(duration_s).build()?)
}

/// Radius, lag and slip speed of the block at the end of a scene: `frame` is where the origin of its coordinates is.
fn orbit_of(scene: &Scene, frame: impl Fn(f64) -> DVec3) -> Result<[f64; 3], Box<dyn Error>> {
    let t = scene.duration_s();
    let end: BodySample = end_of(scene)?;
    let origin = frame(t);
    let place = end.pose.translation + origin;
    let plate = on_circle(t, 0);
    let place = DVec3::new(place.x, place.y, 0.0);
    let plate_velocity = if origin == DVec3::ZERO { on_circle(t, 1) } else { DVec3::ZERO };
    let lag = place.cross(plate).z.atan2(place.dot(plate));
    Ok([place.length(), lag, (end.velocity.linear - plate_velocity).length()])
}

/// A block of `light` kg with a speed (m/s) on a plank of `heavy` kg that slides freely.
fn block_on_plank(light: f64, heavy: f64, friction: f64, speed: f64, duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let length = 4.0 * speed * speed / (friction * GRAVITY) + 1.0;
    let plank_size = DVec3::new(length, 1.0, 0.1);
    let block_size = DVec3::new(0.4, 0.2, 0.05);
    let plank = cuboid("plank", plank_size, heavy, DVec3::Z * (0.5 * plank_size.z))?.material(rough(friction)?);
    let block = cuboid("block", block_size, light, DVec3::Z * (plank_size.z + 0.5 * block_size.z))?;
    let block = block.material(rough(friction)?).velocity(Velocity::new(DVec3::X * speed, DVec3::ZERO));
    let floor = half_space("floor", UnitVector::Z);
    let scene = Scene::builder("block on a plank").body(block).body(plank).body(floor);
    Ok(scene.duration_s(duration_s).build()?)
}

/// Common speed, slip length, and when both have one speed, s; and the difference of the speeds at the end, m/s.
fn slide_on_plank(light: f64, heavy: f64, friction: f64, speed: f64) -> Result<([f64; 3], f64), Box<dyn Error>> {
    let common = light * speed / (light + heavy);
    let expected_s = heavy * speed / (friction * GRAVITY * (light + heavy));
    let scene = block_on_plank(light, heavy, friction, speed, 1.5 * expected_s)?;
    let run = Run::of(&scene, Effects::Planned)?;
    let (block, plank) = (run.last("block")?, run.last("plank")?);
    let (t, _) = first_event(&scene, |sample| (sample.velocity.linear.x - common).abs() < TOGETHER * speed)?;
    let slip = block.pose.translation.x - plank.pose.translation.x;
    let apart = (block.velocity.linear - plank.velocity.linear).length();
    Ok(([block.velocity.linear.x, slip, t], apart))
}

/// A block slides on a plank that slides freely, until both have one speed.
pub(super) fn fc_20(context: &Context) -> CaseResult {
    /// Planks at full count.
    const PLANKS: usize = 300;
    let (found, apart) = slide_on_plank(1.0, 2.0, 0.3, 3.0)?;
    let mut random = Random(20);
    let mut worst = 0.0f64;
    let count = context.amount.of(PLANKS);
    for _ in 0..count {
        let (light, heavy) = (random.between(0.1, 10.0), random.between(0.1, 10.0));
        let (friction, speed) = (random.between(0.05, 0.9), random.between(0.2, 5.0));
        let (found, _) = slide_on_plank(light, heavy, friction, speed)?;
        let all = light + heavy;
        let t = heavy * speed / (friction * GRAVITY * all);
        let expected = [light * speed / all, 0.5 * speed * t, t];
        worst =
            found.iter().zip(expected).map(|(found, expected)| (found / expected - 1.0).abs()).fold(worst, f64::max);
    }
    Ok(vec![
        context.reference.row("FC-20", "common speed, slip length, time", found)?,
        Row::compared("FC-20", "difference of the speeds at the end, m/s", 0.0, apart, Tolerance::Absolute(APART_M_S)),
        Row::at_most("FC-20", &format!("{count} planks: error of speed, slip and time, relative"), DISTANCE, worst),
    ])
}
