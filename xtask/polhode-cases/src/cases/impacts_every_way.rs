//! The impacts of the catalogue (IM-01 to IM-06, IM-11 to IM-14) by every impact law and every tier.
//!
//! One contact alone has one answer, equation (14) of the thesis, whatever the way. Where several contacts are struck
//! at once a law decides: what is mirror symmetric has the symmetric answer by every law but propagation, and a chain
//! of balls the table of its law. One table gives the case, the scene, the ways and their claims.

use super::bodies::{GRAVITY, ball_on_x, bouncy, cuboid, half_space};
use super::run::Run;
use super::ways::{Claims, LAWS, STEP_S, TIERS, Way, compared};
use super::{CaseResult, Context};
use crate::reference::Reference;
use crate::row::Row;
use glam::{DMat3, DVec3};
use polhode::contact::{Shape, Sphere};
use polhode::scene::{ImpactLaw, SceneBuilder, Tier};
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, EventKind, Scene};
use std::error::Error;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_6};

const CASE: &str = "impacts by every way";

/// Velocities after impacts at constant velocities, at 1 m/s. Fixed steps strike bodies that a step has turned or
/// moved.
const AFTER: Claims = Claims { exact: 1e-12, pulse: 1e-10, micro: 1e-12, springs: 1e-5, fast: 1e-3, thesis: 1e-3 };
/// Those of bodies that turn meanwhile: a step earlier or later the arms are others.
const TURNING: Claims = Claims { exact: 1e-12, pulse: 1e-10, micro: 1e-3, springs: 1e-5, fast: 1e-3, thesis: 1e-3 };

/// The energy may rise by this part: rounding of a few sums.
const RISE: f64 = 1e-14;

type Found = Result<Vec<f64>, Box<dyn Error>>;

/// All rows.
pub(super) fn rows(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let mut rows = Vec::new();
    two_bodies(reference, &mut rows)?;
    sticks(reference, &mut rows)?;
    cradles(reference, &mut rows)?;
    between(&mut rows)?;
    mass_ratios(reference, &mut rows)?;
    cubes(reference, &mut rows)?;
    bounces(&mut rows);
    pi_machine(&mut rows)?;
    Ok(rows)
}

/// Whether a way strikes several contacts together and to the end of its law: propagation, and the thesis by it,
/// strikes one after the other; the sweeps of the tier fast end before they have the answer of any law.
fn strikes_at_once(way: Way) -> bool {
    !matches!(way, Way::Law(ImpactLaw::Propagation, _) | Way::Of(Tier::Thesis | Tier::Fast))
}

/// Whether a way tells each impact by itself: the tier fast does not.
fn tells_impacts(way: Way) -> bool {
    way != Way::Of(Tier::Fast)
}

fn every() -> impl Iterator<Item = Way> {
    LAWS.into_iter().chain(TIERS)
}

/// IM-01: two bodies in space with tilted inertias; balls beside their centres of mass meet at the arms of the case.
fn two_bodies(reference: &Reference, rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    /// Radius of the balls, m.
    const RADIUS: f64 = 0.1;
    let n = DVec3::new(1.0, 2.0, 2.0) / 3.0;
    let inertia = [
        DMat3::from_cols_array(&[2.0, 0.25, 0.0, 0.25, 3.0, 0.5, 0.0, 0.5, 4.0]),
        DMat3::from_cols_array(&[5.0, 0.0, 1.0, 0.0, 4.0, 0.0, 1.0, 0.0, 6.0]),
    ];
    let arm = [DVec3::new(1.0, -0.5, -2.0), DVec3::new(0.5, 1.0, 1.5)];
    let before = [
        Velocity::new(DVec3::new(1.0, -2.0, -3.0), DVec3::new(0.5, 1.0, -1.0)),
        Velocity::new(DVec3::new(0.0, 1.0, 1.0), DVec3::new(-1.0, 0.0, 2.0)),
    ];
    for (name, restitution) in [("e=1/2", 0.5), ("e=1", 1.0)] {
        let after = reference.numbers("IM-01", &format!("{name}: vA',wA',vB',wB'"))?;
        for way in every() {
            let body = |name: &str, which: usize, side: f64, place: DVec3| -> Result<Body, Box<dyn Error>> {
                let mass = Mass::new([2.0, 3.0][which])?;
                let properties = MassProperties::new(mass, DVec3::ZERO, Inertia::new(inertia[which])?);
                let ball = Shape::Sphere(Sphere::new(arm[which] + n * (side * RADIUS), RADIUS)?);
                let body = Body::movable(name, properties).geometry(ball.into()).velocity(before[which]);
                Ok(body.pose(Pose::from_translation(place)).material(bouncy(restitution)?))
            };
            let scene = Scene::builder("two bodies")
                .gravity(DVec3::ZERO)
                .duration_s(20.0 * STEP_S)
                .body(body("a", 0, 1.0, DVec3::ZERO)?)
                .body(body("b", 1, -1.0, arm[0] - arm[1])?);
            let found = way.run(scene).map(|run| {
                let states = run.report.bodies.iter().map(|body| body.state);
                // Free motion after the impact keeps the angular momentum: w right after it follows.
                let numbers = states.zip(&inertia).flat_map(|(state, inertia)| {
                    let own = state.pose.rotation.inverse_rotate(state.velocity.angular);
                    let angular = inertia.inverse() * state.pose.rotation.rotate(*inertia * own);
                    state.velocity.linear.to_array().into_iter().chain(angular.to_array())
                });
                numbers.collect()
            });
            rows.push(compared(CASE, &format!("IM-01, e={restitution}"), (way, &TURNING), found, &after));
        }
    }
    Ok(())
}

/// IM-02 and IM-03: a flat stick is symmetric: it leaves as it came by every law but propagation, whose numbers have
/// cases of their own, in its own tier (thesis) too.
fn sticks(reference: &Reference, rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    let inertias = [
        ("1/50", 0.02),
        ("1/20", 0.05),
        ("1/10", 0.1),
        ("1/5", 0.2),
        ("1/3", 1.0 / 3.0),
        ("1/2", 0.5),
        ("3/4", 0.75),
        ("1", 1.0),
    ];
    for (name, inertia) in inertias {
        for way in every().filter(|way| strikes_at_once(*way)) {
            let found = stick(way, inertia, 1.0);
            rows.push(compared(CASE, &format!("IM-02, I={name}: v', w'"), (way, &AFTER), found, &[1.0, 0.0]));
        }
    }
    for (name, inertia) in [("1/50", 0.02), ("1/10", 0.1), ("1/2", 0.5), ("1", 1.0)] {
        let way = Way::Of(Tier::Thesis);
        let found = stick(way, inertia, 1.0).map(|found| vec![found[0], found[1].abs()]);
        let expected = reference.numbers("IM-02", &format!("I={name}: v', |w'|"))?;
        rows.push(compared(CASE, &format!("IM-02, I={inertia}: v', |w'| in turn"), (way, &AFTER), found, &expected));
    }
    for (name, inertia, restitution) in [("1/3", 1.0 / 3.0, 0.5), ("1/3", 1.0 / 3.0, 0.08), ("1/10", 0.1, 0.5)] {
        for way in every().filter(|way| strikes_at_once(*way)) {
            let quantity = format!("IM-03, I={name}, e={restitution}: v', w'");
            rows.push(compared(CASE, &quantity, (way, &AFTER), stick(way, inertia, restitution), &[restitution, 0.0]));
        }
    }
    Ok(())
}

fn stick(way: Way, inertia: f64, restitution: f64) -> Found {
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, Inertia::from_diagonal(DVec3::splat(inertia))?);
    let body = Body::movable("stick", properties)
        .geometry(Shape::points(vec![-DVec3::X, DVec3::X])?.into())
        .pose(Pose::from_translation(DVec3::Z * 0.05))
        .velocity(Velocity::new(-DVec3::Z, DVec3::ZERO))
        .material(bouncy(restitution)?);
    let scene = Scene::builder("stick").gravity(DVec3::ZERO).duration_s(0.06);
    let run = way.run(scene.body(half_space("floor", UnitVector::Z)).body(body))?;
    let end = run.last("stick")?.velocity;
    Ok(vec![end.linear.z, end.angular.y])
}

/// IM-04: Newton's cradle by the tiers; the laws have theirs in the case "impact laws". Reflection is the law of
/// stepped and of micro-collisions, propagation that of the thesis. Springs disperse: they keep momentum and energy.
fn cradles(reference: &Reference, rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    for (count, moving) in [(3_usize, 1_u32), (4, 1), (5, 2)] {
        // As many balls leave as come.
        let expected: Vec<f64> =
            (0..count).map(|ball| if ball + moving as usize >= count { 1.0 } else { 0.0 }).collect();
        for way in TIERS {
            let quantity = format!("IM-04, {count} balls, {moving} moving");
            let found = cradle(way, &vec![1.0; count], moving, 1.0);
            match way {
                Way::Of(Tier::Penalty) => {
                    let sums = found.map(|v| vec![v.iter().sum(), v.iter().map(|v| v * v).sum()]);
                    let quantity = format!("{quantity}: momentum, twice the energy");
                    rows.push(compared(CASE, &quantity, (way, &AFTER), sums, &[f64::from(moving); 2]));
                }
                Way::Of(Tier::Fast) => {
                    let rise = found?.iter().map(|v| v * v).sum::<f64>() - f64::from(moving);
                    rows.push(Row::at_most(
                        CASE,
                        &format!("{quantity}: tier fast: rise of energy"),
                        RISE,
                        rise.max(0.0),
                    ));
                }
                _ => rows.push(compared(CASE, &quantity, (way, &AFTER), found, &expected)),
            }
        }
    }
    let way = Way::Of(Tier::Thesis);
    let found = cradle(way, &[1.0; 3], 1, 0.5);
    let expected = reference.numbers("IM-04", "3 balls, 1 moving, e=1/2: propagation")?;
    rows.push(compared(CASE, "IM-04, 3 balls, e=0.5", (way, &AFTER), found, &expected));
    Ok(())
}

fn cradle(way: Way, masses: &[f64], moving: u32, restitution: f64) -> Found {
    let mut scene = Scene::builder("cradle").gravity(DVec3::ZERO).duration_s(0.06);
    for (number, &mass) in masses.iter().enumerate() {
        let speed = if number < moving as usize { 1.0 } else { 0.0 };
        let ball = ball_on_x(&number.to_string(), 0.5, mass, number as f64 - 0.05 * speed, speed)?;
        scene = scene.body(ball.material(bouncy(restitution)?));
    }
    Ok(speeds(&way.run(scene)?))
}

fn speeds(run: &Run) -> Vec<f64> {
    run.report.bodies.iter().map(|body| body.state.velocity.linear.x).collect()
}

/// IM-11: a ball between two that touch it, at 30 degrees.
fn between(rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    let c = 0.75_f64.sqrt();
    for way in every().filter(|way| strikes_at_once(*way)) {
        let ball = |name: &str, place: DVec3, speed: f64| -> Result<Body, Box<dyn Error>> {
            let ball = ball_on_x(name, 1.0, 1.0, 0.0, speed)?;
            Ok(ball.pose(Pose::from_translation(place)).material(bouncy(1.0)?))
        };
        let scene = Scene::builder("between")
            .gravity(DVec3::ZERO)
            .duration_s(0.06)
            .body(ball("striker", DVec3::X * -0.05, 1.0)?)
            .body(ball("left", DVec3::new(2.0 * c, 1.0, 0.0), 0.0)?)
            .body(ball("right", DVec3::new(2.0 * c, -1.0, 0.0), 0.0)?);
        let found = way.run(scene).map(|run| {
            let plane = run.report.bodies.iter().map(|body| body.state.velocity.linear);
            plane.flat_map(|v| [v.x, v.y]).collect()
        });
        let after = [-0.2, 0.0, 0.6, 0.4 * c, 0.6, -0.4 * c];
        rows.push(compared(CASE, "IM-11: velocities", (way, &TURNING), found, &after));
    }
    Ok(())
}

/// IM-12: a ball hits one a million times heavier, and the other way round.
fn mass_ratios(reference: &Reference, rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    for masses in [[1.0, 1e6], [1e6, 1.0]] {
        let after = reference.numbers("IM-12", &format!("m1={}, m2={}: v1', v2'", masses[0], masses[1]))?;
        for way in every() {
            let found = cradle(way, &masses, 1, 1.0);
            rows.push(compared(CASE, &format!("IM-12, masses {masses:?}"), (way, &AFTER), found, &after));
        }
    }
    Ok(())
}

/// IM-13 and IM-14: cubes on a corner and on an edge, e = 1/2. In turn (propagation, thesis) the edge has another
/// answer.
fn cubes(reference: &Reference, rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    let on_corner = Rotation::renormalized(glam::DQuat::from_rotation_arc(DVec3::ONE.normalize(), DVec3::Z));
    let on_edge = Rotation::from_rotation_vector(DVec3::Y * FRAC_PI_6);
    let on_corner_after = reference.numbers("IM-13", "e=0.5: v', w'")?;
    let on_edge_after = reference.numbers("IM-14", "J total, v', |w'|")?;
    for way in every() {
        let found = cube(way, on_corner).map(|found| vec![found[0], DVec3::from_slice(&found[1..]).length()]);
        rows.push(compared(CASE, "IM-13: v', w'", (way, &AFTER), found, &on_corner_after));
        if strikes_at_once(way) {
            let after = [on_edge_after[1], 0.0, on_edge_after[2], 0.0];
            let found = cube(way, on_edge).map(|found| vec![found[0], found[1], found[2].abs(), found[3]]);
            rows.push(compared(CASE, "IM-14: v', w'", (way, &AFTER), found, &after));
        }
    }
    Ok(())
}

/// Velocity upwards and spin of a cube of 1 m and 1 kg that has fallen at 1 m/s.
fn cube(way: Way, orientation: Rotation) -> Found {
    /// Gap below the lowest corner, m.
    const GAP_M: f64 = 0.05;
    let edges = [DVec3::X, DVec3::Y, DVec3::Z].map(|edge| orientation.rotate(edge).z.abs());
    let height = 0.5 * edges.iter().sum::<f64>() + GAP_M;
    debug_assert!(height < 3.0 * FRAC_1_SQRT_2);
    let body = cuboid("cube", DVec3::ONE, 1.0, DVec3::ZERO)?
        .pose(Pose::new(orientation, DVec3::Z * height))
        .velocity(Velocity::new(-DVec3::Z, DVec3::ZERO))
        .material(bouncy(0.5)?);
    let scene = Scene::builder("cube").gravity(DVec3::ZERO).duration_s(1.2 * GAP_M);
    let run = way.run(scene.body(half_space("floor", UnitVector::Z)).body(body))?;
    let end = run.last("cube")?.velocity;
    Ok([end.linear.z].into_iter().chain(end.angular.to_array()).collect())
}

/// IM-05: times of the bounces of a ball, relative; each bounce of a fixed step is late by up to one, and springs last.
const BOUNCE_TIMES: Claims =
    Claims { exact: 1e-12, pulse: 1e-12, micro: 1e-3, springs: 1e-4, fast: 1e-3, thesis: 1e-3 };

fn bounces(rows: &mut Vec<Row>) {
    for restitution in [0.8, 0.5] {
        let fall = (2.0 / GRAVITY).sqrt();
        // The n-th bounce is at t_1 (1 + 2 (e + ... + e^(n-1))).
        let sum: f64 = (1..5).map(|n| restitution_power(restitution, n)).sum();
        let fifth = fall * (1.0 + 2.0 * sum);
        for way in every().filter(|way| tells_impacts(*way)) {
            let found = bounce(way, restitution, 1.05 * fifth);
            let quantity = format!("IM-05, e={restitution}: time of the 5th impact");
            rows.push(compared(CASE, &quantity, (way, &BOUNCE_TIMES), found, &[fifth]));
        }
    }
}

fn restitution_power(restitution: f64, power: i32) -> f64 {
    restitution.powi(power)
}

/// Time of the fifth impact of a ball that falls from 1 m, s.
fn bounce(way: Way, restitution: f64, duration_s: f64) -> Found {
    let ball = ball_on_x("ball", 0.5, 1.0, 0.0, 0.0)?.pose(Pose::from_translation(DVec3::Z * 1.5));
    let scene = Scene::builder("bounce").duration_s(duration_s).body(half_space("floor", UnitVector::Z));
    let run = way.run(scene.body(ball.material(bouncy(restitution)?)))?;
    let kind = if way == Way::Of(Tier::Penalty) { EventKind::ContactBegin } else { EventKind::Impact };
    let impacts = run.events(kind);
    let fifth = impacts.get(4).ok_or_else(|| format!("{} impacts", impacts.len()))?;
    Ok(vec![fifth.t_s])
}

/// IM-06: Galperin's pi machine: no collision may be missed or merged. Fixed steps count while a step is short beside
/// the time between two collisions.
fn pi_machine(rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    for (ratio, count) in [(1.0, 3), (100.0, 31)] {
        for way in every().filter(|way| tells_impacts(*way)) {
            let machine = |scene: SceneBuilder| -> Result<SceneBuilder, Box<dyn Error>> {
                Ok(scene
                    .body(half_space("wall", UnitVector::X).material(bouncy(1.0)?))
                    .body(ball_on_x("light", 0.05, 1.0, 0.2, 0.0)?.material(bouncy(1.0)?))
                    .body(ball_on_x("heavy", 0.05, ratio, 0.4, -1.0)?.material(bouncy(1.0)?)))
            };
            let scene = machine(Scene::builder("pi machine").gravity(DVec3::ZERO).duration_s(2.0))?;
            let kind = if way == Way::Of(Tier::Penalty) { EventKind::ContactEnd } else { EventKind::Impact };
            let quantity = format!("IM-06, mass {ratio}: collisions: {}", way.name());
            let run = way.run(scene);
            rows.push(match run {
                Ok(run) => Row::exact(CASE, &quantity, count as u64, run.events(kind).len() as u64),
                Err(error) => Row::broken(CASE, &quantity, error.to_string()),
            });
        }
    }
    Ok(())
}
