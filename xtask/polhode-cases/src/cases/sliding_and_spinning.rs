//! FC-05, FC-06: bodies on several feet that slide and spin at once (Coulomb-Contensou friction).
//!
//! Each foot slides in a direction of its own, so that force and torque depend on the ratio of the two speeds. The
//! centre of mass is at the height of the feet, so that all feet of a symmetric body press alike.

use super::rough_plane::{Plane, end_of, events_of, first_acceleration};
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::contact::Shape;
use polhode::spatial::{Inertia, Mass, MassProperties, Velocity};
use polhode::{Body, Scene};
use std::error::Error;
use std::f64::consts::TAU;

/// A body slower than this stands, m/s.
const STANDS_M_S: f64 = 1e-6;

/// How long before the stop the ratio of speeds is taken, s.
const BEFORE_STOP_S: f64 = 1e-4;

/// Tolerance of forces and torques, relative.
const FORCES: f64 = 1e-12;

/// Tolerance of positions and velocities, as in the catalogue of cases.
const STATES: f64 = 1e-9;

/// A flat body of 1 kg on point feet, with this moment about the vertical, kg m^2.
fn on_feet(feet: Vec<DVec3>, moment: f64, velocity: Velocity) -> Result<Body, Box<dyn Error>> {
    let moments = Inertia::from_diagonal(DVec3::new(0.5 * moment, 0.5 * moment, moment))?;
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, moments);
    Ok(Body::movable("feet", properties).geometry(Shape::points(feet)?.into()).velocity(velocity))
}

/// A tripod.
pub(super) fn tripod(duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let feet = (0..3).map(|k| {
        let angle = TAU * f64::from(k) / 3.0;
        DVec3::new(angle.cos(), angle.sin(), 0.0) * 0.5
    });
    let velocity = Velocity::new(DVec3::X, DVec3::Z * 4.0);
    Ok(Plane::LEVEL.with(on_feet(feet.collect(), 0.1, velocity)?, 0.3)?.duration_s(duration_s).build()?)
}

/// A tripod slides and spins: its place and velocity against an independent integration.
pub(super) fn fc_06(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for t in [0.1, 0.25] {
        let end = end_of(&tripod(t)?)?;
        let (place, velocity) = (end.pose.translation, end.velocity);
        let angle = end.pose.rotation.to_rotation_vector().z;
        let quantity = format!("t={t}: x,y,theta,vx,vy,w (feet at theta+0,120,240deg)");
        let measured = [place.x, place.y, angle, velocity.linear.x, velocity.linear.y, velocity.angular.z];
        rows.push(context.reference.row("FC-06", &quantity, measured)?);
    }
    Ok(rows)
}

/// Rings of feet, each of which stands for as much of the disc as any other.
const RINGS: u32 = 6;

/// Feet of a disc of radius 1 m: ring `k` holds the middle of the area between circles `k/n` and `(k + 1)/n`, and
/// `2 k + 1` times as many feet as the first.
fn disc_feet() -> Vec<DVec3> {
    let mut feet = Vec::new();
    for ring in 0..RINGS {
        let (inner, outer) = (f64::from(ring) / f64::from(RINGS), f64::from(ring + 1) / f64::from(RINGS));
        let radius = (0.5 * (inner * inner + outer * outer)).sqrt();
        let count = 3 * (2 * ring + 1);
        for k in 0..count {
            let angle = TAU * (f64::from(k) + 0.5 * f64::from(ring % 2)) / f64::from(count);
            feet.push(DVec3::new(angle.cos(), angle.sin(), 0.0) * radius);
        }
    }
    feet
}

/// A disc of many feet with speed and spin 1, under g = 1 and with friction 1.
fn disc(duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let velocity = Velocity::new(DVec3::X, DVec3::Z);
    let scene = Plane::LEVEL.with(on_feet(disc_feet(), 0.5, velocity)?, 1.0)?;
    Ok(scene.gravity(-DVec3::Z).duration_s(duration_s).build()?)
}

/// Rates of angle, velocity along x and y, and spin of a disc whose feet press alike: the mean of their frictions.
fn disc_rates(feet: &[DVec3], [angle, x, y, spin]: [f64; 4]) -> [f64; 4] {
    let (sin, cos) = angle.sin_cos();
    let mut rates = [spin, 0.0, 0.0, 0.0];
    for foot in feet {
        let arm = DVec3::new(cos * foot.x - sin * foot.y, sin * foot.x + cos * foot.y, 0.0);
        let slip = DVec3::new(x - spin * arm.y, y + spin * arm.x, 0.0);
        let force = -slip / (slip.length() * feet.len() as f64);
        rates[1] += force.x;
        rates[2] += force.y;
        rates[3] += 2.0 * arm.cross(force).z;
    }
    rates
}

/// The disc's angle, velocity and spin after one second by the classical method of order four.
fn disc_by_classical_steps() -> [f64; 4] {
    const STEPS: u32 = 4000;
    let feet = disc_feet();
    let h = 1.0 / f64::from(STEPS);
    let moved = |state: [f64; 4], rates: [f64; 4], h: f64| [0, 1, 2, 3].map(|k| state[k] + h * rates[k]);
    let mut state = [0.0, 1.0, 0.0, 1.0];
    for _ in 0..STEPS {
        let a = disc_rates(&feet, state);
        let b = disc_rates(&feet, moved(state, a, 0.5 * h));
        let c = disc_rates(&feet, moved(state, b, 0.5 * h));
        let d = disc_rates(&feet, moved(state, c, h));
        state = [0, 1, 2, 3].map(|k| state[k] + h / 6.0 * (a[k] + 2.0 * (b[k] + c[k]) + d[k]));
    }
    state
}

/// A disc that slides and spins stops sliding and spinning at once, at a ratio of the speeds that is always the same.
pub(super) fn fc_05(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let start = first_acceleration(&disc(1.0)?)?;
    let [_, x, y, turning] = disc_rates(&disc_feet(), [0.0, 1.0, 0.0, 1.0]);
    let middle = end_of(&disc(1.0)?)?;
    let measured = [
        middle.pose.rotation.to_rotation_vector().z,
        middle.velocity.linear.x,
        middle.velocity.linear.y,
        middle.velocity.angular.z,
    ];
    let events = events_of(&disc(2.0)?)?;
    let (stop, _) =
        events.iter().find(|(_, s)| s.velocity.linear.length() < STANDS_M_S).ok_or("the disc does not stop")?;
    let before = end_of(&disc(stop - BEFORE_STOP_S)?)?.velocity;
    let ratio = before.linear.length() / before.angular.length();
    let force = [start.linear.length(), 0.5 * start.angular.length()];
    let of_feet = [x.hypot(y), -0.5 * turning];
    Ok(vec![
        Row::compared("FC-05", "force and torque of the feet at eps=1", of_feet, force, Tolerance::Relative(FORCES)),
        Row::compared(
            "FC-05",
            "angle, velocity, spin of the feet at t=1",
            disc_by_classical_steps(),
            measured,
            Tolerance::Absolute(STATES),
        ),
        reference.row("FC-05", "eps0 = v/(R w) at stop, disc I=mR^2/2", ratio)?,
        reference.row("FC-05", "F/(mu m g), T/(mu m g R) at eps=1", force)?,
        reference.row("FC-05", "stop time for v0=1,w0=1,R=1,mu g=1 (common to v and w)", *stop)?,
    ])
}
