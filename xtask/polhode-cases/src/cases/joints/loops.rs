//! JT-06 and JT-07: the four-bar linkage of N loops that stands upright, which passes the flat position at which it
//! could bifurcate, and Bricard's loop of six hinges, which holds more than it needs to.

use super::{WORK_OF_JOINTS, bodies_at, first_zero, hinge, rod, rows_of_energy, run, scene, whole_angle};
use crate::cases::motion::{angle_between, least_turn, zero};
use crate::cases::run::Run;
use crate::cases::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, BodySample, Scene, Simulation};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const G: f64 = crate::cases::bodies::GRAVITY;

/// Two loops: three uprights and two level bars of 1 m and 1 kg, the upper ends moving with 1 m/s.
pub(crate) fn four_bar(duration_s: f64) -> super::Result<Scene> {
    const LOOPS: usize = 2;
    let mut builder = scene("N-four-bar").duration_s(duration_s);
    let foot = |column: usize| DVec3::X * column as f64;
    let head = |column: usize| foot(column) + DVec3::Z;
    let mut uprights = Vec::new();
    for column in 0..=LOOPS {
        let velocity = Velocity::new(DVec3::X * 0.5, DVec3::Y);
        let body = rod(&format!("upright {column}"), 1.0, [foot(column), head(column)])?.velocity(velocity);
        let body = builder.add_body(body);
        builder = builder.joint(hinge(body, foot(column), UnitVector::Y));
        uprights.push(body);
    }
    for column in 0..LOOPS {
        let body = rod(&format!("bar {column}"), 1.0, [head(column), head(column + 1)])?;
        let body = builder.add_body(body.velocity(Velocity::new(DVec3::X, DVec3::ZERO)));
        for (upright, place) in [(uprights[column], head(column)), (uprights[column + 1], head(column + 1))] {
            builder = builder.joint(hinge(body, place, UnitVector::Y).with(upright));
        }
    }
    Ok(builder.build()?)
}

/// The angle of the first upright from upright, clockwise, within half a revolution, rad.
fn lean(bodies: &[BodySample]) -> f64 {
    let along = bodies[0].pose.rotation.rotate(DVec3::X);
    along.x.atan2(along.z)
}

/// The four-bar linkage against the pendulum that it is.
pub(crate) fn jt_06(context: &Context) -> CaseResult {
    let long = run(&four_bar(10.0)?)?;
    let level = first_zero(&long, |bodies| bodies[0].pose.rotation.rotate(DVec3::X).z)?;
    let rate = |t: f64| bodies_at(&long.scene, t).map(|bodies| bodies[0].velocity.angular.y);
    let mut rows = Vec::new();
    let (period, bottom) = period_and_bottom(&long)?;
    rows.push(context.reference.row("JT-06", "period of revolution", period)?);
    rows.push(context.reference.row("JT-06", "phi' at horizontal and at bottom", [rate(level)?, rate(bottom)?])?);
    for t in [1.0, 5.0, 10.0] {
        let part = run(&four_bar(t)?)?;
        let (angle, end) = (whole_angle(&part, lean), part.report.bodies[0].state);
        let head = end.pose.translation + end.pose.rotation.rotate(DVec3::X) * 0.5;
        let quantity = format!("t={t:.0}: phi (from upright), phi', B0x, B0y");
        rows.push(context.reference.row("JT-06", &quantity, [angle, end.velocity.angular.y, head.x, head.z])?);
    }
    rows.extend(rows_of_energy("JT-06", &long.report));
    Ok(rows)
}

/// The time of a revolution, and when the uprights first hang, s.
fn period_and_bottom(long: &Run) -> super::Result<(f64, f64)> {
    // The angle counted on from the samples says between which two each passage is.
    let mut angle = 0.0;
    let mut counted = Vec::new();
    for bodies in &long.record.samples {
        angle += least_turn(lean(bodies) - angle);
        counted.push(angle);
    }
    let when = |target: f64| -> super::Result<f64> {
        let place = counted.iter().position(|angle| *angle >= target).ok_or("no passage")?;
        let (before, after) = (long.record.times_s[place - 1], long.record.times_s[place]);
        zero([before, after], |t| Ok(least_turn(lean(&bodies_at(&long.scene, t)?) - target)))
    };
    let bottom = when(PI)?;
    Ok((when(PI + TAU)? - bottom, bottom))
}

/// Bricard's loop: five rods of 1 m, 1 kg and 0.1 m square along edges of a cube, with hinges across both of their
/// links; gravity along -y.
fn bricard(duration_s: f64) -> super::Result<Scene> {
    let corners = CORNERS.map(DVec3::from_array);
    let mut builder = scene("Bricard").gravity(DVec3::Y * -G).duration_s(duration_s);
    for link in 0..5 {
        let way = corners[link + 1] - corners[link];
        let (along, across) = (0.01 / 6.0, 1.01 / 12.0);
        let inertia = Inertia::from_diagonal(DVec3::new(along, across, across))?;
        let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, inertia);
        let pose = Pose::new(
            Rotation::from_rotation_vector(super::turn_from_x(way)),
            (corners[link] + corners[link + 1]) * 0.5,
        );
        builder.add_body(Body::movable(format!("rod {link}"), properties).pose(pose));
    }
    for corner in 0..6 {
        let before = corners[corner] - corners[(corner + 5) % 6];
        let after = corners[(corner + 1) % 6] - corners[corner];
        let axis = UnitVector::new(before.cross(after))?;
        // The rods before and after the corner; the sixth link is the world.
        let joint = match corner {
            0 => hinge(BodyId::new(0), corners[0], axis),
            5 => hinge(BodyId::new(4), corners[5], axis),
            _ => hinge(BodyId::new(corner), corners[corner], axis).with(BodyId::new(corner - 1)),
        };
        builder = builder.joint(joint);
    }
    Ok(builder.build()?)
}

const CORNERS: [[f64; 3]; 6] =
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, -1.0, 0.0], [1.0, -1.0, 1.0], [0.0, -1.0, 1.0], [0.0, 0.0, 1.0]];

/// The direction of a rod of the loop.
fn way(bodies: &[BodySample], link: usize) -> DVec3 {
    // A rod lies along the x axis of its body.
    bodies[link].pose.rotation.rotate(DVec3::X)
}

/// The interior angle at an even corner (P2), rad, and its rate.
fn interior(bodies: &[BodySample]) -> f64 {
    PI - angle_between(way(bodies, 1), way(bodies, 2))
}

fn interior_rate(bodies: &[BodySample]) -> f64 {
    let axis = way(bodies, 1).cross(way(bodies, 2)).normalize();
    -axis.dot(bodies[2].velocity.angular - bodies[1].velocity.angular)
}

/// Bricard's loop against the quadrature of its one equation.
pub(crate) fn jt_07(context: &Context) -> CaseResult {
    let scene = bricard(2.0)?;
    let whole = run(&scene)?;
    let found = Simulation::new(&scene)?.accelerations()?;
    // At rest the second derivative of the angle is the difference of angular accelerations about the axis of the
    // hinge.
    let start: Vec<BodySample> = whole.record.samples[0].clone();
    let axis = way(&start, 1).cross(way(&start, 2));
    let acceleration = -axis.dot(found[2].angular - found[1].angular);
    let mut rows = vec![context.reference.row("JT-07", "A'' at t=0 (=g/5.01)", acceleration)?];
    for degrees in [30.0_f64, 60.0, 85.0] {
        let target = FRAC_PI_2 + degrees.to_radians();
        let t = first_zero(&whole, |bodies| interior(bodies) - target)?;
        let bodies = bodies_at(&scene, t)?;
        let corner = bodies[2].pose.translation + way(&bodies, 2) * 0.5;
        let quantity = format!("A=90+{degrees:.0}deg: time, A', P3");
        let measured = [t, interior_rate(&bodies), corner.x, corner.y, corner.z];
        rows.push(context.reference.row("JT-07", &quantity, measured)?);
    }
    let long = run(&bricard(10.0)?)?;
    rows.extend(rows_of_energy("JT-07", &long.report));
    let energy = &long.report.energy;
    let change = (energy.final_j - energy.initial_j).abs() / long.report.ledger.scale_j;
    rows.push(Row::at_most("JT-07", "change of energy in 10 s over the largest", WORK_OF_JOINTS, change));
    Ok(rows)
}

/// A linkage of bars of 0.10, 0.30 and 0.25 m over a ground of 0.30 m, each with 1 kg for each metre, that swings
/// without damping.
pub(crate) fn linkage(_: &Context) -> CaseResult {
    const CASE: &str = "four-bar linkage";
    const BARS: [f64; 3] = [0.10, 0.30, 0.25];
    const GROUND: f64 = 0.30;
    let mut rows = Vec::new();
    for start in [1.2_f64, 2.4] {
        let crank = DVec3::new(start.cos(), 0.0, start.sin()) * BARS[0];
        let foot = DVec3::X * GROUND;
        let way = foot - crank;
        let along = (BARS[1] * BARS[1] - BARS[2] * BARS[2] + way.length_squared()) / (2.0 * way.length());
        let across = (BARS[1] * BARS[1] - along * along).sqrt();
        let unit = way.normalize();
        let pin = crank + unit * along + DVec3::new(-unit.z, 0.0, unit.x) * across;
        let mut builder = scene("four-bar linkage").duration_s(5.0);
        let bar = |name: &str, ends: [DVec3; 2]| rod(name, (ends[1] - ends[0]).length(), ends);
        let crank_bar = builder.add_body(bar("crank", [DVec3::ZERO, crank])?);
        let coupler = builder.add_body(bar("coupler", [crank, pin])?);
        let rocker = builder.add_body(bar("rocker", [pin, foot])?);
        for joint in [
            hinge(crank_bar, DVec3::ZERO, UnitVector::Y),
            hinge(coupler, crank, UnitVector::Y).with(crank_bar),
            hinge(rocker, pin, UnitVector::Y).with(coupler),
            hinge(rocker, foot, UnitVector::Y),
        ] {
            builder = builder.joint(joint);
        }
        let run = run(&builder.build()?)?;
        let certificate = &run.report.certificate;
        let named = |what: &str| format!("crank from {start} rad: {what}");
        let energy = &run.report.energy;
        let change = (energy.final_j - energy.initial_j).abs() / run.report.ledger.scale_j;
        rows.push(Row::at_most(
            CASE,
            &named("largest gap of a hinge, m"),
            WORK_OF_JOINTS,
            certificate.max_joint_error_m.unwrap_or(f64::NAN),
        ));
        rows.push(Row::at_most(
            CASE,
            &named("largest tilt of a hinge, rad"),
            WORK_OF_JOINTS,
            certificate.max_joint_error_rad.unwrap_or(f64::NAN),
        ));
        rows.push(Row::at_most(CASE, &named("change of energy in 5 s over the largest"), WORK_OF_JOINTS, change));
        rows.extend(rows_of_energy(CASE, &run.report));
    }
    Ok(rows)
}
