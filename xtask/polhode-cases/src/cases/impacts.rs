//! Single impacts: equation (14), the bouncing ball, mass ratios, boxes on a corner and on an edge.

use super::bodies::{GRAVITY, ball_on_x, bouncy, cuboid, half_space};
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::{DMat3, DVec3};
use polhode::mesh::solid_sphere;
use polhode::response::{ContactProblem, single_contact_impulse};
use polhode::spatial::{Mass, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Effects, EventKind, Geometry, Scene};
use std::error::Error;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_6};

/// Two bodies in space with tilted inertias: thesis equations (10) to (14).
pub(super) fn im_01(context: &Context) -> CaseResult {
    let n = DVec3::new(1.0, 2.0, 2.0) / 3.0;
    let mass = [2.0, 3.0];
    let inertia = [
        DMat3::from_cols_array(&[2.0, 0.25, 0.0, 0.25, 3.0, 0.5, 0.0, 0.5, 4.0]),
        DMat3::from_cols_array(&[5.0, 0.0, 1.0, 0.0, 4.0, 0.0, 1.0, 0.0, 6.0]),
    ];
    let arm = [DVec3::new(1.0, -0.5, -2.0), DVec3::new(0.5, 1.0, 1.5)];
    let before = [1.0, -2.0, -3.0, 0.5, 1.0, -1.0, 0.0, 1.0, 1.0, -1.0, 0.0, 2.0];
    let inverse_masses = (0..2).flat_map(|body| inverse_mass(mass[body], inertia[body])).collect();
    let mut problem = ContactProblem::new(6, inverse_masses)?;
    let row_a = jacobian(n, arm[0]);
    let row_b = jacobian(n, arm[1]).map(|x| -x);
    problem.push_row(&[(0, &row_a), (1, &row_b)])?;
    let speed = problem.row_velocities(&before)?[0];
    let kinetic = |v: &[f64]| (0..2).map(|body| kinetic_energy(mass[body], inertia[body], &v[6 * body..])).sum::<f64>();
    let mut rows = Vec::new();
    for (name, restitution) in [("e=1/2", 0.5), ("e=1", 1.0)] {
        let impulse = single_contact_impulse(problem.delassus().get(0, 0), speed, restitution)
            .ok_or("the contact has no mass")?;
        let change = problem.response(&[impulse])?;
        let after: Vec<f64> = before.iter().zip(&change).map(|(v, dv)| v + dv).collect();
        let lost = kinetic(&before) - kinetic(&after);
        rows.push(context.reference.row("IM-01", &format!("{name}: J"), impulse)?);
        rows.push(context.reference.row("IM-01", &format!("{name}: vA',wA',vB',wB'"), after)?);
        rows.push(context.reference.row("IM-01", &format!("{name}: kinetic energy lost"), lost)?);
    }
    Ok(rows)
}

/// Inverse mass of one body: 6 x 6, row-major.
fn inverse_mass(mass: f64, inertia: DMat3) -> Vec<f64> {
    let inverse = inertia.inverse();
    let mut block = vec![0.0; 36];
    for i in 0..3 {
        block[7 * i] = 1.0 / mass;
        for j in 0..3 {
            block[6 * (3 + i) + 3 + j] = inverse.col(j)[i];
        }
    }
    block
}

/// `(n, r x n)`.
fn jacobian(n: DVec3, arm: DVec3) -> [f64; 6] {
    let moment = arm.cross(n);
    [n.x, n.y, n.z, moment.x, moment.y, moment.z]
}

fn kinetic_energy(mass: f64, inertia: DMat3, v: &[f64]) -> f64 {
    let (linear, angular) = (DVec3::new(v[0], v[1], v[2]), DVec3::new(v[3], v[4], v[5]));
    0.5 * (mass * linear.length_squared() + angular.dot(inertia * angular))
}

/// A ball dropped from 1 m: bounces without end in finite time (Zeno).
pub(super) fn im_05(context: &Context) -> CaseResult {
    /// Radius of the ball, m.
    const RADIUS: f64 = 0.5;
    /// What may be left unexplained, relative to the largest energy of the run.
    const CLOSURE: f64 = 1e-12;
    let mut rows = Vec::new();
    for (restitution, duration) in [(0.8, 5.0), (0.5, 2.0), (0.99, 92.0)] {
        let properties = solid_sphere(RADIUS, Mass::new(1.0)?)?;
        let ball = Body::movable("ball", properties)
            .geometry(Geometry::from(polhode::contact::Shape::sphere(RADIUS)?))
            .pose(Pose::from_translation(DVec3::Z * (1.0 + RADIUS)))
            .material(bouncy(restitution)?);
        let scene = Scene::builder("bouncing ball")
            .body(half_space("floor", UnitVector::Z))
            .body(ball)
            .duration_s(duration)
            .build()?;
        let run = Run::of(&scene, Effects::Planned)?;
        let impacts = run.events(EventKind::Impact);
        let tenth = impacts.get(9).ok_or_else(|| format!("only {} impacts", impacts.len()))?;
        let rests = run.events(EventKind::Rest);
        let rest = rests.first().ok_or("the ball does not come to rest")?;
        // Of the impulse m (1 + e) u the part m e u is what throws the ball up again.
        let thrown_up = tenth.impulse * restitution / (1.0 + restitution);
        let apex = thrown_up * thrown_up / (2.0 * GRAVITY);
        let name = |quantity: &str| format!("e={restitution}: {quantity}");
        rows.push(context.reference.row("IM-05", &name("time of rest, s"), rest.t_s)?);
        rows.push(context.reference.row("IM-05", &name("time of 10th impact, s"), tenth.t_s)?);
        rows.push(context.reference.row("IM-05", &name("apex after 10th impact, m"), apex)?);
        let stays = rests.len() == 1 && run.last("ball")?.velocity.is_zero();
        rows.push(Row::exact("IM-05", &name("rests once, with no velocity left"), true, stays));
        rows.push(Row::at_most("IM-05", &name("closure of the ledger"), CLOSURE, run.report.ledger.closure_relative()));
    }
    Ok(rows)
}

/// A ball hits one a million times heavier, and the other way round.
pub(super) fn im_12(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for [m1, m2] in [[1.0, 1e6], [1e6, 1.0]] {
        let scene = Scene::builder("mass ratio")
            .gravity(DVec3::ZERO)
            .body(ball_on_x("first", 0.5, m1, -1.0, 1.0)?.material(bouncy(1.0)?))
            .body(ball_on_x("second", 0.5, m2, 1.0, 0.0)?)
            .duration_s(1.5)
            .build()?;
        let run = Run::of(&scene, Effects::Planned)?;
        let after = [run.last("first")?.velocity.linear.x, run.last("second")?.velocity.linear.x];
        rows.push(context.reference.row("IM-12", &format!("m1={m1}, m2={m2}: v1', v2'"), after)?);
    }
    Ok(rows)
}

/// A cube on its corner, the corner straight below the centre of mass: no spin.
pub(super) fn im_13(context: &Context) -> CaseResult {
    let diagonal = DVec3::ONE.normalize();
    let run = drop_cube(rotation_between(diagonal, DVec3::Z), 0.5)?;
    let cube = run.last("cube")?;
    let after = [cube.velocity.linear.z, cube.velocity.angular.length()];
    Ok(vec![context.reference.row("IM-13", "e=0.5: v', w'", after)?])
}

/// A cube tilted by 30 degrees lands on an edge: two contacts at once.
pub(super) fn im_14(context: &Context) -> CaseResult {
    let run = drop_cube(Rotation::from_rotation_vector(DVec3::Y * FRAC_PI_6), 0.5)?;
    let cube = run.last("cube")?;
    let impulse: f64 = run.events(EventKind::Impact).iter().map(|event| event.impulse).sum();
    let after = [impulse, cube.velocity.linear.z, cube.velocity.angular.length()];
    let mut rows = vec![context.reference.row("IM-14", "J total, v', |w'|", after)?];
    let sideways = cube.velocity.angular.x.abs().max(cube.velocity.angular.z.abs());
    rows.push(Row::at_most("IM-14", "spin about other axes than the edge's, rad/s", SPURIOUS_SPIN, sideways));
    Ok(rows)
}

/// Spin that rounding may leave, rad/s, beside about 1 rad/s that is right.
const SPURIOUS_SPIN: f64 = 1e-13;

/// A cube of 1 m and 1 kg that falls at 1 m/s, without gravity, on a floor; the run ends shortly after the impact.
fn drop_cube(orientation: Rotation, restitution: f64) -> Result<Run, Box<dyn Error>> {
    // The lowest corner of any orientation is within half the space diagonal.
    let height = 3.0 * FRAC_1_SQRT_2;
    let cube = cuboid("cube", DVec3::ONE, 1.0, DVec3::Z * height)?
        .pose(Pose::new(orientation, DVec3::Z * height))
        .velocity(Velocity::new(-DVec3::Z, DVec3::ZERO))
        .material(bouncy(restitution)?);
    let lowest = lowest_corner(orientation);
    let scene = Scene::builder("falling cube")
        .gravity(DVec3::ZERO)
        .body(half_space("floor", UnitVector::Z))
        .body(cube)
        .duration_s(height + lowest + 0.1)
        .build()?;
    Run::of(&scene, Effects::Planned)
}

/// Height of the lowest corner of the unit cube relative to its centre, m.
fn lowest_corner(orientation: Rotation) -> f64 {
    // The height of a corner is a sum of three half edges of either sign; the lowest takes every one downwards.
    let edges = [DVec3::X, DVec3::Y, DVec3::Z].map(|edge| orientation.rotate(edge).z.abs());
    -0.5 * edges.iter().sum::<f64>()
}

/// The shortest rotation that turns one unit vector into another one, not its opposite.
fn rotation_between(from: DVec3, to: DVec3) -> Rotation {
    Rotation::renormalized(glam::DQuat::from_rotation_arc(from, to))
}
