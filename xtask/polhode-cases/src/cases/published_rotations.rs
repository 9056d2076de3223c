//! Free rotations and a top that other programs have published figures of.

use super::bodies::rotor;
use super::free_rotation::orientation_row;
use super::motion::{angle_between, angular_momentum, body_rate};
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::scene::Method;
use polhode::spatial::{Inertia, Mass, MassProperties, Velocity};
use polhode::{Body, Effects, Scene};
use std::error::Error;

/// What may change relative to itself although it is conserved.
const CONSERVATION: f64 = 1e-12;

fn spun(moments: DVec3, spin: DVec3, duration_s: f64, interval_s: f64) -> Result<Run, Box<dyn Error>> {
    let scene = Scene::builder("free rotation")
        .gravity(DVec3::ZERO)
        .body(rotor("rotor", moments, spin)?)
        .duration_s(duration_s)
        .output_interval_s(interval_s)
        .method(Method { step_s: Some(interval_s), ..Method::default() })
        .build()?;
    Run::of(&scene, Effects::Planned)
}

/// NASA's check case 2, a tumbling brick. Only ratios of moments matter: those of slug ft^2 stand for kg m^2.
pub(super) fn tumbling_brick(context: &Context) -> CaseResult {
    /// Principal moments, slug ft^2.
    const MOMENTS: DVec3 = DVec3::new(1.894220e-3, 6.211019e-3, 7.194665e-3);
    let spin = DVec3::new(10.0, 20.0, 30.0).map(f64::to_radians);
    let last = spun(MOMENTS, spin, 30.0, 30.0)?.last("rotor")?;
    let rates = body_rate(&last).to_array().map(f64::to_degrees);
    Ok(vec![
        context.reference.row("NESC-2", "p, q, r after 30 s, deg/s", rates)?,
        context.reference.row("NESC-2", "published p, q, r after 30 s, deg/s", rates)?,
    ])
}

/// The box of the OSRF benchmark: sliding through space with a steady spin, and thrown with a tumbling one.
pub(super) fn osrf_boxes(context: &Context) -> CaseResult {
    const CASE: &str = "OSRF-boxes";
    /// Principal moments of a box of 0.1 x 0.4 x 0.9 m and 10 kg, kg m^2.
    const MOMENTS: DVec3 = DVec3::new(9.7 / 12.0, 8.2 / 12.0, 1.7 / 12.0);
    /// The same as the benchmark has them, to six digits: its starting energies are theirs.
    const ROUNDED: DVec3 = DVec3::new(0.808_333, 0.683_333, 0.141_667);
    let scenes = [
        ("simple", DVec3::ZERO, DVec3::new(-0.9, 0.4, 0.1), DVec3::X * 0.5),
        ("complex", DVec3::Z * -9.8, DVec3::new(-2.0, 2.0, 8.0), DVec3::new(0.1, 5.0, 0.1)),
    ];
    let mut rows = Vec::new();
    for (name, gravity, velocity, spin) in scenes {
        let properties = MassProperties::new(Mass::new(10.0)?, DVec3::ZERO, Inertia::from_diagonal(MOMENTS)?);
        let body = Body::movable("box", properties).velocity(Velocity::new(velocity, spin));
        let scene = Scene::builder(name).gravity(gravity).body(body).duration_s(10.0).build()?;
        let run = Run::of(&scene, Effects::Planned)?;
        let (energy, start) = (run.report.energy.initial_j, MOMENTS * spin);
        let mut off = [0.0f64; 4];
        for (&t, sample) in run.record.times_s.iter().zip(run.record.samples.iter().filter_map(|all| all.first())) {
            let path = velocity * t + gravity * (0.5 * t * t);
            let momentum = angular_momentum(MOMENTS, sample);
            let kinetic = 5.0 * sample.velocity.linear.length_squared() + 0.5 * momentum.dot(sample.velocity.angular);
            let now = kinetic - 10.0 * gravity.dot(sample.pose.translation);
            let place = (sample.pose.translation - path).length() / path.length().max(1.0);
            let speed = (sample.velocity.linear - (velocity + gravity * t)).length() / velocity.length();
            let errors = [place, speed, (momentum - start).length() / start.length(), (now / energy - 1.0).abs()];
            off = [0, 1, 2, 3].map(|k| if errors[k] <= off[k] { off[k] } else { errors[k] });
        }
        let published = energy - 0.5 * (MOMENTS - ROUNDED).dot(spin * spin);
        rows.push(context.reference.row(CASE, &format!("{name}: energy at the start, J"), published)?);
        let what = ["position", "velocity", "H (best published: 6.3e-4)", "E (best published: 6.2e-4)"];
        for (what, off) in what.iter().zip(off) {
            rows.push(Row::at_most(CASE, &format!("{name}: relative error of {what}"), CONSERVATION, off));
        }
        if name == "complex" {
            let last = run.last("box")?;
            rows.push(context.reference.row(CASE, "complex: |H| at the start, kg m^2/s", start.length())?);
            rows.push(orientation_row(context, CASE, "complex: q at t = 10 s", &last)?);
            let rate = body_rate(&last).to_array();
            rows.push(context.reference.row(CASE, "complex: w in body axes at t = 10 s, rad/s", rate)?);
        }
    }
    Ok(rows)
}

/// Orekit's figure: the direction of the angular momentum over 80 s, whichever axis has which moment.
pub(super) fn orekit(context: &Context) -> CaseResult {
    let (moments, spin) = (DVec3::new(0.375, 0.5, 0.625), DVec3::new(0.05, 0.0, 0.04));
    let orders: [fn(DVec3) -> DVec3; 6] = [
        |v| v,
        |v| DVec3::new(v.y, v.z, v.x),
        |v| DVec3::new(v.z, v.x, v.y),
        |v| DVec3::new(v.y, v.x, v.z),
        |v| DVec3::new(v.x, v.z, v.y),
        |v| DVec3::new(v.z, v.y, v.x),
    ];
    let mut most = 0.0f64;
    for order in orders {
        // The motion before t = 0 is that of the opposite spin after it.
        for spin in [order(spin), -order(spin)] {
            let moments = order(moments);
            let run = spun(moments, spin, 40.0, 0.01)?;
            for sample in run.record.samples.iter().filter_map(|bodies| bodies.first()) {
                most = most.max(angle_between(angular_momentum(moments, sample), moments * spin));
            }
        }
    }
    Ok(vec![context.reference.row("Orekit", "direction of the angular momentum, rad", most)?])
}

/// Basilisk's hub.
pub(super) fn basilisk(context: &Context) -> CaseResult {
    let last = spun(DVec3::new(500.0, 200.0, 300.0), DVec3::new(0.5, -0.4, 0.7), 10.0, 10.0)?.last("rotor")?;
    let rate = body_rate(&last).to_array();
    Ok(vec![context.reference.row("Basilisk", "w in body axes at t = 10 s, rad/s", rate)?])
}

/// The heavy top that integrators on Lie groups are compared on.
pub(super) fn bruels_top(context: &Context) -> CaseResult {
    let inertia = Inertia::from_diagonal(DVec3::new(0.234_375, 0.468_75, 0.234_375))?;
    let body = Body::movable("top", MassProperties::new(Mass::new(15.0)?, DVec3::Y, inertia))
        .pivot(DVec3::ZERO)
        .velocity(Velocity::new(DVec3::ZERO, DVec3::new(0.0, 150.0, -4.61538)));
    let scene = Scene::builder("heavy top").body(body).duration_s(2.0).build()?;
    let last = Run::of(&scene, Effects::Planned)?.last("top")?;
    let center = last.pose.transform_point(DVec3::Y).to_array();
    Ok(vec![context.reference.row("Bruels-top", "centre of mass at t = 2 s, m", center)?])
}
