//! JT-04, JT-05 and JT-09: chains of rods, hung, free in space, and between two supports.

use super::{WORK_OF_JOINTS, from_hanging, hinge, rod, rows_of_energy, run, scene, whole_angle};
use crate::cases::motion::zero;
use crate::cases::{Amount, CaseResult, Context};
use crate::row::Row;
use glam::{DMat4, DVec3};
use polhode::scene::Joint;
use polhode::spatial::{UnitVector, Velocity};
use polhode::{BodySample, Scene, Simulation};
use std::f64::consts::FRAC_PI_2;

const G: f64 = crate::cases::bodies::GRAVITY;

/// What chains in equilibrium may miss, relative to their weight, or move, m: what the reference values are held to.
const STILL: f64 = 1e-9;

/// Links of the chain of the thesis's Figure 5.
const LINKS: usize = 4;

/// Four rods of 1 m and 1 kg hung from the origin, at these angles from hanging, at rest.
pub(crate) fn hung(angles: [f64; LINKS], duration_s: f64) -> super::Result<Scene> {
    let mut scene = scene("hung chain").duration_s(duration_s);
    let mut end = DVec3::ZERO;
    let mut above = None;
    for (number, angle) in angles.into_iter().enumerate() {
        let start = end;
        end = start + DVec3::new(angle.sin(), 0.0, -angle.cos());
        let link = scene.add_body(rod(&format!("rod {number}"), 1.0, [start, end])?);
        let joint = hinge(link, start, UnitVector::Y);
        scene = scene.joint(above.map_or(joint, |above| joint.with(above)));
        above = Some(link);
    }
    Ok(scene.build()?)
}

/// Angular accelerations of the hung chain in the sense of its angles, rad/s^2.
fn accelerations(angles: [f64; LINKS]) -> super::Result<[f64; LINKS]> {
    let found = Simulation::new(&hung(angles, 1.0)?)?.accelerations()?;
    Ok(std::array::from_fn(|link| -found[link].angular.y))
}

/// How the accelerations change with the angles at the hanging chain, 1/s^2: central differences of three steps,
/// extrapolated.
fn stiffness() -> super::Result<DMat4> {
    const STEPS: [f64; 3] = [0.012, 0.006, 0.003];
    let mut columns = [[0.0; LINKS]; LINKS];
    for (link, column) in columns.iter_mut().enumerate() {
        let difference = |step: f64| -> super::Result<[f64; LINKS]> {
            let mut angles = [0.0; LINKS];
            angles[link] = step;
            let up = accelerations(angles)?;
            angles[link] = -step;
            let down = accelerations(angles)?;
            Ok(std::array::from_fn(|row| (up[row] - down[row]) / (2.0 * step)))
        };
        let [a, b, c] = STEPS.map(difference);
        let (a, b, c) = (a?, b?, c?);
        *column = std::array::from_fn(|row| {
            let (ab, bc) = ((4.0 * b[row] - a[row]) / 3.0, (4.0 * c[row] - b[row]) / 3.0);
            (16.0 * bc - ab) / 15.0
        });
    }
    Ok(DMat4::from_cols_array_2d(&columns))
}

/// The hung chain: its small oscillations, and its fall from level.
pub(crate) fn jt_04(context: &Context) -> CaseResult {
    let stiffness = stiffness()?;
    let at = |frequency: f64| (stiffness + DMat4::IDENTITY * (frequency * frequency)).determinant();
    // Between these the determinant changes its sign once.
    let brackets = [[1.0, 3.0], [3.0, 6.0], [6.0, 10.0], [10.0, 15.0]];
    let frequencies = brackets.map(|bracket| zero(bracket, |frequency| Ok(at(frequency))));
    let [a, b, c, d] = frequencies;
    let mut rows = vec![context.reference.row("JT-04", "angular frequencies (rad/s)", [a?, b?, c?, d?])?];
    let level = [FRAC_PI_2; LINKS];
    let quantity = "initial angular accelerations from horizontal";
    rows.push(context.reference.row("JT-04", quantity, accelerations(level)?)?);
    for (t, words) in [(0.5, "0.5"), (1.0, "1"), (2.0, "2")] {
        let run = run(&hung(level, t)?)?;
        let angle = |link: usize| whole_angle(&run, |bodies: &[BodySample]| from_hanging(&bodies[link]));
        let rate = |link: usize| -run.report.bodies[link].state.velocity.angular.y;
        let found: Vec<f64> = (0..LINKS).map(angle).chain((0..LINKS).map(rate)).collect();
        rows.push(context.reference.row("JT-04", &format!("t={words}: th1..4, w1..4"), found)?);
        rows.extend(rows_of_energy("JT-04", &run.report).into_iter().filter(|_| t == 2.0));
    }
    Ok(rows)
}

/// The same chain free in space, straight at the start, with rods that turn at different rates.
pub(crate) fn jt_05(context: &Context) -> CaseResult {
    const RATES: [f64; LINKS] = [1.0, -1.0, 2.0, 0.5];
    let mut builder = scene("free chain").gravity(DVec3::ZERO).duration_s(5.0);
    // Velocities of the middles of the rods along y, with the hinges together and the sum zero.
    let mut speeds = [0.0; LINKS];
    for link in 1..LINKS {
        speeds[link] = speeds[link - 1] + 0.5 * (RATES[link - 1] + RATES[link]);
    }
    let mean = speeds.iter().sum::<f64>() / LINKS as f64;
    let mut before = None;
    for link in 0..LINKS {
        let start = DVec3::X * (link as f64 - 2.0);
        let body = rod(&format!("rod {link}"), 1.0, [start, start + DVec3::X])?;
        let velocity = Velocity::new(DVec3::Y * (speeds[link] - mean), DVec3::Z * RATES[link]);
        let body = builder.add_body(body.velocity(velocity));
        if let Some(before) = before {
            builder = builder.joint(hinge(body, start, UnitVector::Z).with(before));
        }
        before = Some(body);
    }
    let run = run(&builder.build()?)?;
    let angle = |link: usize| {
        whole_angle(&run, |bodies: &[BodySample]| {
            let along = bodies[link].pose.rotation.rotate(DVec3::X);
            along.y.atan2(along.x)
        })
    };
    let rate = |link: usize| run.report.bodies[link].state.velocity.angular.z;
    let found: Vec<f64> = (0..LINKS).map(angle).chain((0..LINKS).map(rate)).collect();
    let mut rows = vec![context.reference.row("JT-05", "t=5: th1..4,w1..4", found)?];
    let energy = run.report.energy.kinetic_j;
    let momentum: f64 = run
        .report
        .bodies
        .iter()
        .map(|body| {
            let BodySample { pose, velocity, .. } = body.state;
            pose.translation.cross(velocity.linear).z + velocity.angular.z / 12.0
        })
        .sum();
    rows.push(context.reference.row("JT-05", "E, L about com", [energy, momentum])?);
    rows.extend(rows_of_energy("JT-05", &run.report));
    Ok(rows)
}

/// Twenty rods between two supports at one height, where the slopes are those of equilibrium: they stay, and bear what
/// statics says.
pub(crate) fn jt_09(context: &Context) -> CaseResult {
    const RODS: usize = 20;
    const ROD: (f64, f64) = (0.1, 0.1);
    const APART: f64 = 1.2;
    let (length, mass) = ROD;
    let slope = |pull: f64, rod: usize| (mass * G / pull) * (rod as f64 + 0.5 - 0.5 * RODS as f64);
    let span = |pull: f64| (0..RODS).map(|rod| length / slope(pull, rod).hypot(1.0)).sum::<f64>();
    let pull = zero([1.0, 10.0], |pull| Ok(span(pull) - APART))?;
    let mut builder = scene("catenary").duration_s(1.0);
    let (mut end, mut lowest) = (DVec3::ZERO, 0.0_f64);
    let mut before = None;
    for number in 0..RODS {
        let slope = slope(pull, number);
        let start = end;
        end = start + DVec3::new(1.0, 0.0, slope) * (length / slope.hypot(1.0));
        lowest = lowest.min(end.z);
        let body = builder.add_body(rod(&format!("rod {number}"), mass, [start, end])?);
        let joint = hinge(body, start, UnitVector::Y);
        builder = builder.joint(before.map_or(joint, |before| joint.with(before)));
        before = Some(body);
    }
    let last = before.ok_or("no rod")?;
    let built = builder.joint(Joint::ball(last, end)).build()?;
    let mut simulation = Simulation::new(&built)?;
    let load = simulation.joint_loads()[0].force_n;
    let largest = simulation.accelerations()?.iter().map(|own| own.linear.length() / G).fold(0.0, f64::max);
    simulation.advance_to(1.0)?;
    let bodies = simulation.bodies();
    let moved = bodies
        .iter()
        .zip(built.bodies())
        .map(|(now, then)| (now.pose.translation - then.initial_pose().translation).length());
    let row = |quantity: &str, value: f64| context.reference.row("JT-09", quantity, value);
    Ok(vec![
        row("horizontal tension H", load.x.abs())?,
        row("sag", -lowest)?,
        row("support tension", load.length())?,
        Row::at_most("JT-09", "largest acceleration at the start over g", STILL, largest),
        Row::at_most("JT-09", "largest displacement after 1 s, m", STILL, moved.fold(0.0, f64::max)),
    ])
}

/// A hanging chain of a hundred links whose last one carries a million times their mass: it bears what statics says,
/// and hangs still.
pub(crate) fn heavy_end(context: &Context) -> CaseResult {
    const CASE: &str = "chain with a heavy end";
    const LINKS: usize = 100;
    const LINK: (f64, f64) = (0.1, 0.01);
    const HEAVY: f64 = 1e6 * LINK.1;
    let (length, mass) = LINK;
    let at = |place: usize| DVec3::Z * -(place as f64 * length);
    let duration_s = 60.0;
    let mut builder = scene("chain with a heavy end").duration_s(duration_s).output_interval_s(1.0);
    let mut above = None;
    for link in 0..LINKS {
        let body = builder.add_body(rod(&format!("link {link}"), mass, [at(link), at(link + 1)])?);
        let joint = Joint::ball(body, at(link));
        builder = builder.joint(above.map_or(joint, |above| joint.with(above)));
        above = Some(body);
    }
    let properties = polhode::mesh::solid_sphere(0.5, polhode::spatial::Mass::new(HEAVY)?)?;
    let load = polhode::Body::movable("load", properties);
    let load = builder.add_body(load.pose(polhode::spatial::Pose::from_translation(at(LINKS) - DVec3::Z * 0.5)));
    let last = Joint::ball(load, at(LINKS));
    builder = builder.joint(above.map_or(last, |above| last.with(above)));
    let built = builder.build()?;
    let simulation = Simulation::new(&built)?;
    let loads = simulation.joint_loads();
    let error = loads.iter().enumerate().map(|(joint, load)| {
        let hangs = HEAVY + mass * (LINKS - joint) as f64;
        (load.force_n.length() / (hangs * G) - 1.0).abs()
    });
    let statics = error.fold(0.0, f64::max);
    let mut rows = vec![Row::at_most(CASE, "error of the forces of its joints, relative", STILL, statics)];
    // 303 rows at every stage of short steps: a second takes minutes.
    if context.amount == Amount::Full {
        let still = run(&built)?;
        rows.extend([
            Row::at_most(CASE, &format!("largest movement in {duration_s} s, m"), STILL, still.largest_movement_m()),
            Row::at_most(CASE, "closure of the ledger", WORK_OF_JOINTS, still.report.ledger.closure_relative()),
        ]);
    }
    Ok(rows)
}
