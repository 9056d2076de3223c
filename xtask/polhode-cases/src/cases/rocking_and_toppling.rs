//! FC-12, FC-18: blocks that rock or topple about an edge on ground so rough that it does not slip.
//!
//! Energy gives the rates: `w^2 = w0^2 + 2 m g (z0 - z)/I`, `I` about the edge. An impact of the other edge that does
//! not bounce keeps the angular momentum about that edge (Housner 1963).

use super::bodies::{GRAVITY, cuboid};
use super::motion::zero;
use super::rough_plane::{Plane, end_of, first_acceleration, rough};
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::spatial::{Pose, Rotation, Velocity};
use polhode::{Body, BodySample, Effects, EventKind, Scene};
use std::error::Error;

/// Tolerance of rates, relative.
const RATE: f64 = 1e-10;

/// Tolerance of the ratio of two rates, and how much earlier than a contact a state is taken, relative.
const RATIO: f64 = 1e-9;

/// How much earlier than an impact a state is taken, relative: before it by more than the rounding of its time.
const JUST_BEFORE: f64 = 1e-13;

/// Friction that never lets an edge slip.
const ROUGH: f64 = 3.0;

/// A box of 1 kg tipped about its lower edge towards +x by an angle (rad), turning on at a rate (rad/s). The edge is
/// the origin.
fn tipped(name: &str, size: DVec3, angle: f64, rate: f64) -> Result<Body, Box<dyn Error>> {
    let turn = Rotation::from_rotation_vector(DVec3::Y * angle);
    // From the edge to the centre.
    let arm = turn.rotate(DVec3::new(-0.5 * size.x, 0.0, 0.5 * size.z));
    let spin = DVec3::Y * rate;
    let body = cuboid(name, size, 1.0, DVec3::ZERO)?.pose(Pose::new(turn, arm));
    Ok(body.velocity(Velocity::new(spin.cross(arm), spin)).material(rough(ROUGH)?))
}

/// The angle by which a body is tipped about +y, rad.
fn tip_of(sample: &BodySample) -> f64 {
    sample.pose.rotation.to_rotation_vector().y
}

/// Half the width and half the height of a block, m.
type Half = [f64; 2];

/// The rocking block of FC-12.
const BLOCK: Half = [0.25, 1.0];

/// A block released at rest from a tip, rad.
fn rocking([width, height]: Half, tip: f64, duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let size = DVec3::new(2.0 * width, 0.5, 2.0 * height);
    Ok(Scene::builder("rocking block")
        .body(tipped("block", size, tip, 0.0)?)
        .body(Plane::LEVEL.ground(ROUGH)?)
        .duration_s(duration_s)
        .build()?)
}

fn rocking_block(tip: f64, duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    rocking(BLOCK, tip, duration_s)
}

/// Other blocks, released from a part of the angle at which they would topple: the rate at which they fall back by
/// energy, and what the impact leaves of it (Housner 1963).
fn other_blocks() -> CaseResult {
    let mut rows = Vec::new();
    for (half, part) in [([0.2, 0.5], 0.3), ([0.3, 2.0], 0.8), ([0.1, 0.8], 0.6)] {
        let [width, height]: Half = half;
        let critical = width.atan2(height);
        let tip = part * critical;
        let run = Run::of(&rocking(half, tip, 3.0)?, Effects::Planned)?;
        let impact = run.events(EventKind::Impact).first().ok_or("the block does not fall back")?.t_s;
        let [before, after] = around(impact, |t| Ok(end_of(&rocking(half, tip, t)?)?.velocity))?;
        let (before, after) = (before.angular.length(), after.angular.length());
        let fallen = (critical - tip).cos() - critical.cos();
        let expected = (1.5 * GRAVITY / width.hypot(height) * fallen).sqrt();
        let kept = 1.0 - 1.5 * critical.sin().powi(2);
        let block = format!("block {} x {} m", 2.0 * width, 2.0 * height);
        let rate = Tolerance::Relative(RATE);
        rows.push(Row::compared("FC-12", &format!("{block}: w- at impact"), expected, before, rate));
        rows.push(Row::compared("FC-12", &format!("{block}: w+/w-"), kept, after / before, Tolerance::Relative(RATIO)));
    }
    Ok(rows)
}

/// A block released from half the angle at which it would topple rocks from one edge to the other.
pub(super) fn fc_12(context: &Context) -> CaseResult {
    let reference = &context.reference;
    // Balanced on its edge it does not accelerate.
    let critical = zero([0.2, 0.3], |tip| Ok(first_acceleration(&rocking_block(tip, 1.0)?)?.angular.y))?;
    // The rate with which a tip away from that grows: p^2 = 3 g/(4 R).
    let growth = |step: f64| -> Result<f64, Box<dyn Error>> {
        Ok(first_acceleration(&rocking_block(critical + step, 1.0)?)?.angular.y / step.sin())
    };
    let rate = growth(0.1)?.sqrt();
    let scene = rocking_block(0.5 * critical, 2.0)?;
    let run = Run::of(&scene, Effects::Planned)?;
    let impact = run.events(EventKind::Impact).first().ok_or("the block does not fall back")?.t_s;
    let [before, after] = around(impact, |t| Ok(end_of(&rocking_block(0.5 * critical, t)?)?.velocity))?;
    let (fast, slow) = (before.angular.length(), after.angular.length());
    let ratio = slow / fast;
    // It tips on until it stands still for an instant: about as long after the impact as before, or less.
    let still =
        zero([impact * 1.1, impact * 2.0], |t| Ok(end_of(&rocking_block(0.5 * critical, t)?)?.velocity.angular.y))?;
    let highest = tip_of(&end_of(&rocking_block(0.5 * critical, still)?)?).abs();
    let start = reference.row("FC-12", "alpha, p", [critical, rate])?;
    let change = after.linear - before.linear;
    let impulse = change.x.abs() / change.z.abs();
    let mut rows = vec![
        start,
        Row::compared(
            "FC-12",
            "quarter period over that of the linearised theory",
            1.0,
            impact / (2.0f64.acosh() / rate),
            Tolerance::Relative(0.01),
        ),
        reference.row("FC-12", "exact time to first impact, w- at impact, w+", [impact, fast, slow])?,
        reference.row("FC-12", "w+/w-, energy ratio", [ratio, ratio * ratio])?,
        reference.row("FC-12", "next maximum angle", highest)?,
        reference.row(
            "FC-12",
            "ratio horizontal/vertical impulse at the corner impact = (3/4) sin 2al/(2-(3/2) sin^2 al): smallest mu \
             for no slip at impact",
            impulse,
        )?,
    ];
    rows.extend(other_blocks()?);
    Ok(rows)
}

/// The velocities just before and just after an impact at `t` (s): on straight lines through those of runs that end
/// near it.
fn around(t: f64, velocity: impl Fn(f64) -> Result<Velocity, Box<dyn Error>>) -> Result<[Velocity; 2], Box<dyn Error>> {
    /// Distance of the times of these runs, s: its square is lost in rounding.
    const SPACING: f64 = 1e-7;
    let limit = |spacing: f64| -> Result<Velocity, Box<dyn Error>> {
        let (near, far) = (velocity(t + spacing)?, velocity(t + 2.0 * spacing)?);
        Ok(Velocity::new(near.linear * 2.0 - far.linear, near.angular * 2.0 - far.angular))
    };
    Ok([limit(-SPACING)?, limit(SPACING)?])
}

/// A domino: thickness, height, and the gap to the next, m.
const DOMINO: [f64; 3] = [0.0075, 0.048, 0.02];

fn domino_size() -> DVec3 {
    DVec3::new(DOMINO[0], 0.024, DOMINO[1])
}

/// A domino tipped about its leading edge, turning on at `rate` (rad/s), before another one that stands.
fn dominoes(tip: f64, rate: f64, duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let size = domino_size();
    let next = cuboid("next", size, 1.0, DVec3::new(DOMINO[2] + 0.5 * size.x, 0.0, 0.5 * size.z))?;
    Ok(Scene::builder("dominoes")
        .body(tipped("first", size, tip, rate)?)
        .body(next.material(rough(ROUGH)?))
        .body(Plane::LEVEL.ground(ROUGH)?)
        .duration_s(duration_s)
        .build()?)
}

/// When the first domino strikes the next one, s.
fn strike_of(scene: &Scene) -> Result<f64, Box<dyn Error>> {
    let impacts = Run::of(scene, Effects::Planned)?.events(EventKind::Impact);
    let strike =
        impacts.iter().find(|event| event.body_a.index() < 2 && event.body_b.is_some_and(|other| other.index() < 2));
    Ok(strike.ok_or("the domino does not strike the next one")?.t_s)
}

/// A domino topples onto the next one.
pub(super) fn fc_18(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let balance = zero([0.1, 0.2], |tip| Ok(first_acceleration(&dominoes(tip, 0.0, 1.0)?)?.angular.y))?;
    let t = strike_of(&dominoes(balance, 1.0, 0.2)?)?;
    let before = end_of(&dominoes(balance, 1.0, t * (1.0 - JUST_BEFORE))?)?;
    let angles = [balance.to_degrees(), tip_of(&before).to_degrees()];
    let mut rows = vec![
        reference.row("FC-18", "tip angle, contact angle (deg)", angles)?,
        reference.row(
            "FC-18",
            "w at first contact if released at the tip angle with w0=1 rad/s, com height energy; I_edge=m(d^2+h^2)/3",
            before.velocity.angular.y,
        )?,
    ];
    // Other rates, by energy.
    for rate in [0.5, 2.0, 7.0] {
        let t = strike_of(&dominoes(balance, rate, 0.5)?)?;
        let end = end_of(&dominoes(balance, rate, t * (1.0 - RATIO))?)?;
        let [d, h, _] = DOMINO;
        let fallen = 0.5 * (d.hypot(h) - (d * tip_of(&end).sin() + h * tip_of(&end).cos()));
        let expected = (rate * rate + 6.0 * GRAVITY * fallen / (d * d + h * h)).sqrt();
        let quantity = format!("w at first contact if released with {rate} rad/s");
        rows.push(Row::compared("FC-18", &quantity, expected, end.velocity.angular.y, Tolerance::Relative(RATE)));
    }
    Ok(rows)
}
