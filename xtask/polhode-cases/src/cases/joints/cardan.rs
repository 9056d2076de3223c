//! JT-11: a Cardan joint between two shafts that meet at 30 degrees, the first driven at a constant rate.
//!
//! With the input angle `a` from where the fork of the driven shaft's axis lies in the plane of both shafts, or across
//! it, the output is `tan b = tan a / cos beta` or `tan a cos beta`.

use super::{bodies_at, rows_of_energy, run, scene};
use crate::cases::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::mesh::Cylinder;
use polhode::scene::{Coordinate, CoordinateMotion, Joint, JointKind};
use polhode::spatial::{Mass, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Scene};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, PI};

/// Error of a prescribed angle after some revolutions, rad: the rounding of its function of time.
const DRIVEN_ANGLE: f64 = 1e-11;

/// How the fork of the driving shaft lies at the start.
#[derive(Clone, Copy)]
pub(crate) enum Fork {
    /// In the plane of both shafts.
    InPlane,
    /// Across it.
    Across,
}

/// The driving shaft along x, the other one in the plane of x and y; the first turns at 1 rad/s.
pub(crate) fn shafts(fork: Fork, duration_s: f64) -> super::Result<Scene> {
    let other = DVec3::new(FRAC_PI_6.cos(), FRAC_PI_6.sin(), 0.0);
    // The axis of the cross in each shaft: across that shaft, and at right angles to the other one.
    let (own, of_other, ratio) = match fork {
        Fork::InPlane => (DVec3::Y, DVec3::Z, 1.0 / FRAC_PI_6.cos()),
        Fork::Across => (DVec3::Z, DVec3::new(-FRAC_PI_6.sin(), FRAC_PI_6.cos(), 0.0), FRAC_PI_6.cos()),
    };
    let shaft = |name: &str, direction: DVec3, rate: f64| -> super::Result<Body> {
        let along_x = Rotation::from_rotation_vector(DVec3::Y * FRAC_PI_2);
        let rotation = Rotation::from_rotation_vector(super::turn_from_x(direction)) * along_x;
        let body = Body::movable(name, Cylinder::new(0.05, 0.5)?.solid(Mass::new(1.0)?)?);
        Ok(body.pose(Pose::new(rotation, direction * 0.3)).velocity(Velocity::new(DVec3::ZERO, direction * rate)))
    };
    let mut builder = scene("Cardan").duration_s(duration_s);
    let driving = builder.add_body(
        shaft("driving", DVec3::X, 1.0)?
            .pose(Pose::new(Rotation::from_rotation_vector(DVec3::Y * FRAC_PI_2), DVec3::X * -0.3)),
    );
    let driven = builder.add_body(shaft("driven", other, ratio)?);
    let bearing = builder.add_joint(Joint::hinge(driving, DVec3::X * -0.3, UnitVector::X));
    builder.add_joint(Joint::hinge(driven, other * 0.3, UnitVector::new(other)?));
    let axes = [UnitVector::new(own)?, UnitVector::new(of_other)?];
    let cross = Joint::new(JointKind::Universal { axes }, driving, DVec3::ZERO).with(driven);
    let motion = CoordinateMotion::rate(1.0)?;
    Ok(builder.joint(cross).coordinate_motion(bearing, Coordinate::Angle, motion).build()?)
}

/// The rate of the driven shaft at a time, rad/s.
fn rate_at(fork: Fork, t: f64) -> super::Result<f64> {
    Ok(bodies_at(&shafts(fork, 1.0)?, t)?[1].velocity.angular.length())
}

/// How far the driven shaft has turned when the driving one has turned by 40 degrees, degrees.
fn output_at_40(fork: Fork) -> super::Result<f64> {
    let scene = shafts(fork, 1.0)?;
    let end = bodies_at(&scene, 40.0_f64.to_radians())?[1];
    let start = scene.bodies()[1].initial_pose().rotation;
    Ok(start.angle_to(end.pose.rotation).to_degrees())
}

/// Ratios and angles of the shafts.
pub(crate) fn jt_11(context: &Context) -> CaseResult {
    // The ratio is extreme where the fork lies in the plane of the shafts, and a quarter of a revolution later.
    let ratios = [rate_at(Fork::InPlane, FRAC_PI_2)?, rate_at(Fork::InPlane, PI)?];
    let quantity = "output angle for input 40deg (deg), both phases";
    let mut rows = vec![
        context.reference.row("JT-11", "min,max ratio", ratios)?,
        context.reference.row("JT-11", quantity, [output_at_40(Fork::InPlane)?, output_at_40(Fork::Across)?])?,
    ];
    let long = run(&shafts(Fork::InPlane, 20.0)?)?;
    rows.extend(rows_of_energy("JT-11", &long.report));
    let turned = super::whole_angle(&long, |bodies| {
        let across = bodies[0].pose.rotation.rotate(DVec3::Y);
        across.z.atan2(across.y)
    });
    rows.push(Row::at_most(
        "JT-11",
        "error of the driving shaft's angle after 20 s, rad",
        DRIVEN_ANGLE,
        (turned - 20.0).abs(),
    ));
    Ok(rows)
}
