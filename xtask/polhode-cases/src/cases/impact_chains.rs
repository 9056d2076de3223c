//! Impacts that travel: the stick of the thesis's Appendix C and Newton's cradle.

use super::bodies::{ball_on_x, bouncy, half_space};
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::contact::Shape;
use polhode::scene::{ImpactLaw, Method};
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, UnitVector, Velocity};
use polhode::{Body, Effects, EventKind, Scene};
use std::error::Error;
use std::f64::consts::PI;

/// Inertias of the stick, with the name that the reference gives them.
const INERTIAS: [(&str, f64); 8] = [
    ("1/50", 0.02),
    ("1/20", 0.05),
    ("1/10", 0.1),
    ("1/5", 0.2),
    ("1/3", 1.0 / 3.0),
    ("1/2", 0.5),
    ("3/4", 0.75),
    ("1", 1.0),
];

/// What a stick did: impulses in order and velocities afterwards.
#[derive(Debug)]
struct Stick {
    impulses: Vec<f64>,
    /// Of the centre, upwards, m/s.
    speed: f64,
    /// Rate of turning, rad/s.
    spin: f64,
    /// Velocity of the end struck last, upwards, m/s.
    last_struck: f64,
    /// Velocity of the other end, m/s.
    other: f64,
    warnings: Vec<String>,
}

/// A stick of 1 kg and length 2 m that falls flat at 1 m/s; propagation strikes its ends in turn.
fn stick(inertia: f64, restitution: f64) -> Result<Stick, Box<dyn Error>> {
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, Inertia::from_diagonal(DVec3::splat(inertia))?);
    let body = Body::movable("stick", properties)
        .geometry(Shape::points(vec![-DVec3::X, DVec3::X])?.into())
        .pose(Pose::from_translation(DVec3::Z))
        .velocity(Velocity::new(-DVec3::Z, DVec3::ZERO))
        .material(bouncy(restitution)?);
    let scene = Scene::builder("stick")
        .gravity(DVec3::ZERO)
        .body(half_space("floor", UnitVector::Z))
        .body(body)
        .method(Method { impact: Some(ImpactLaw::Propagation), ..Method::default() })
        // The impact is at t = 1 s; afterwards the end struck last moves up for a while.
        .duration_s(1.0625)
        .build()?;
    let run = Run::of(&scene, Effects::Planned)?;
    let end = run.last("stick")?;
    let events = run.events(EventKind::Impact);
    let last = events.last().ok_or("the stick is not struck")?;
    // Right after the impact the stick lies flat and still has the rates that it has now: nothing acts on it. An end
    // at x = +-1 then moves upwards by v + (w x r).z = v -+ w_y.
    let (speed, spin) = (end.velocity.linear.z, end.velocity.angular.y);
    let side = last.point.x.signum();
    Ok(Stick {
        impulses: events.iter().map(|event| event.impulse).collect(),
        speed,
        spin: end.velocity.angular.length(),
        last_struck: speed - side * spin,
        other: speed + side * spin,
        warnings: run.report.warnings.clone(),
    })
}

/// Number of impulses and velocities at e = 1 for many inertias, those on the border between two numbers too.
pub(super) fn im_02(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let mut rows = Vec::new();
    for (name, inertia) in INERTIAS {
        let stick = stick(inertia, 1.0)?;
        let count = stick.impulses.len() as u64;
        rows.push(reference.row("IM-02", &format!("I={name}: N impulses"), count)?);
        let ends = [stick.last_struck, stick.other];
        rows.push(reference.row("IM-02", &format!("I={name}: end velocities (last struck, other), m/s"), ends)?);
        rows.push(reference.row("IM-02", &format!("I={name}: v', |w'|"), [stick.speed, stick.spin])?);
        if name == "1/3" {
            rows.push(reference.row("IM-02", "I=1/3: impulses in order, N s", stick.impulses)?);
        }
    }
    let border = |k: f64| (PI / (2.0 * k + 1.0)).tan().powi(2);
    let mut counts = Vec::new();
    for k in [2.0, 3.0, 4.0] {
        counts.push(stick(border(k), 1.0)?.impulses.len() as f64);
    }
    rows.push(reference.row("IM-02", "I=tan^2(pi/(2k+1)), k=2,3,4: N impulses", counts)?);
    let second = stick(border(2.0), 1.0)?;
    let ends = [second.last_struck, second.other];
    rows.push(reference.row("IM-02", "I=tan^2(36 deg): end velocities (last struck, other), m/s", ends)?);
    Ok(rows)
}

/// The stick with restitution below 1, down to where the sequence of impulses never ends.
pub(super) fn im_03(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let third = 1.0 / 3.0;
    let mut rows = Vec::new();
    for (name, inertia, restitution) in [
        ("I=1/3, e=1/2", third, 0.5),
        ("I=1/3, e=1/10", third, 0.1),
        ("I=1/3, e=2/25", third, 0.08),
        ("I=1/10, e=1/2", 0.1, 0.5),
    ] {
        let stick = stick(inertia, restitution)?;
        rows.push(reference.row("IM-03", &format!("{name}: N impulses"), stick.impulses.len() as u64)?);
        let ends = [stick.last_struck, stick.other];
        rows.push(reference.row("IM-03", &format!("{name}: end velocities (last struck, other), m/s"), ends)?);
    }
    let endless = stick(third, 0.07)?;
    let impulse: f64 = endless.impulses.iter().sum();
    rows.push(reference.row("IM-03", "I=1/3, e=0.07: total impulse, N s", impulse)?);
    let left = endless.last_struck.abs().max(endless.other.abs());
    rows.push(reference.row("IM-03", "I=1/3, e=0.07: largest end speed left, m/s", left)?);
    rows.push(Row::exact("IM-03", "I=1/3, e=0.07: a warning says so", true, !endless.warnings.is_empty()));
    Ok(rows)
}

/// Newton's cradle: what several touching balls do depends on the law, and each law must do its own.
pub(super) fn im_04(context: &Context) -> CaseResult {
    use ImpactLaw::{Propagation, Simultaneous};
    let equal = |count: usize| vec![1.0; count];
    let cases = [
        ("3 balls, 1 moving: propagation", equal(3), 1, 1.0, Propagation),
        ("3 balls, 1 moving: simultaneous", equal(3), 1, 1.0, Simultaneous),
        ("4 balls, 1 moving: simultaneous", equal(4), 1, 1.0, Simultaneous),
        ("5 balls, 1 moving: simultaneous", equal(5), 1, 1.0, Simultaneous),
        ("5 balls, 2 moving: propagation", equal(5), 2, 1.0, Propagation),
        ("5 balls, 2 moving: simultaneous", equal(5), 2, 1.0, Simultaneous),
        ("3 balls, 1 moving, e=1/2: propagation", equal(3), 1, 0.5, Propagation),
        ("3 balls, 1 moving, e=1/2: simultaneous", equal(3), 1, 0.5, Simultaneous),
        ("masses 1 2 4, 1 moving: propagation", vec![1.0, 2.0, 4.0], 1, 1.0, Propagation),
        ("masses 1 2 4, 1 moving: simultaneous", vec![1.0, 2.0, 4.0], 1, 1.0, Simultaneous),
    ];
    let mut rows = Vec::new();
    for (name, masses, moving, restitution, law) in cases {
        rows.push(context.reference.row("IM-04", name, cradle(&masses, moving, restitution, law)?)?);
    }
    // The thesis's own answer to its Figure 16 is one ball out for one ball in, which reflection gives too.
    let reflected = cradle(&equal(3), 1, 1.0, ImpactLaw::Reflection)?;
    let mut reflection = context.reference.row("IM-04", "3 balls, 1 moving: propagation", reflected)?;
    reflection.quantity = String::from("3 balls, 1 moving: reflection");
    rows.push(reflection);
    Ok(rows)
}

/// Velocities after the impact of balls in a row that touch; the first `moving` come at 1 m/s from 1 m away.
fn cradle(masses: &[f64], moving: usize, restitution: f64, law: ImpactLaw) -> Result<Vec<f64>, Box<dyn Error>> {
    let mut builder = Scene::builder("cradle")
        .gravity(DVec3::ZERO)
        .method(Method { impact: Some(law), ..Method::default() })
        .duration_s(1.25);
    for (number, &mass) in masses.iter().enumerate() {
        let comes = number < moving;
        let x = number as f64 - if comes { 1.0 } else { 0.0 };
        let ball = ball_on_x(&number.to_string(), 0.5, mass, x, if comes { 1.0 } else { 0.0 })?;
        builder = builder.body(ball.material(bouncy(restitution)?));
    }
    let run = Run::of(&builder.build()?, Effects::Planned)?;
    Ok(run.report.bodies.iter().map(|body| body.state.velocity.linear.x).collect())
}
