//! JT-01 to JT-03: pendulums of particles and rods.

use super::{
    bodies_at, first_zero, from_hanging, hinge, massless_rod, particle, rod, rows_of_energy, run, scene, whole_angle,
    zeros,
};
use crate::cases::{CaseResult, Context};
use glam::DVec3;
use polhode::spatial::UnitVector;
use polhode::{BodyId, BodySample, Scene, Simulation};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

const G: f64 = crate::cases::bodies::GRAVITY;

/// Where a pendulum of 1 m is at an angle from hanging.
pub(crate) fn at(angle: f64) -> DVec3 {
    DVec3::new(angle.sin(), 0.0, -angle.cos())
}

pub(crate) fn of_particle(angle: f64) -> super::Result<Scene> {
    let mut scene = scene("pendulum of a particle").duration_s(2.5);
    let bob = scene.add_body(particle("bob", at(angle), DVec3::ZERO)?);
    Ok(scene.joint(massless_rod(bob, at(angle), DVec3::ZERO)).build()?)
}

pub(crate) fn of_rod(angle: f64, duration_s: f64) -> super::Result<Scene> {
    let mut scene = scene("pendulum of a rod").duration_s(duration_s);
    let rod = scene.add_body(rod("rod", 1.0, [DVec3::ZERO, at(angle)])?);
    Ok(scene.joint(hinge(rod, DVec3::ZERO, UnitVector::Y)).build()?)
}

/// The period: four times the time from rest to the lowest point.
fn period(scene: &Scene, angle: impl Fn(&[BodySample]) -> f64) -> super::Result<f64> {
    Ok(4.0 * first_zero(&run(scene)?, angle)?)
}

/// Periods at large amplitudes, and a rod that is let go level.
pub(crate) fn jt_01(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for degrees in [10.0_f64, 90.0, 150.0, 179.0] {
        let angle = degrees.to_radians();
        let of_particle = period(&of_particle(angle)?, |bodies| bodies[0].pose.translation.x)?;
        let of_rod = period(&of_rod(angle, 2.5)?, |bodies| from_hanging(&bodies[0]))?;
        let quantity = format!("{degrees:.0}deg: T point mass, T rod");
        rows.push(context.reference.row("JT-01", &quantity, [of_particle, of_rod])?);
    }
    let place = bodies_at(&of_particle(FRAC_PI_2)?, 1.0)?[0].pose.translation;
    let angle = place.x.atan2(-place.z);
    rows.push(context.reference.row("JT-01", "theta(t=1) for point mass released at 90deg", angle)?);
    let scene = of_rod(FRAC_PI_2, 1.0)?;
    let bottom = first_zero(&run(&scene)?, |bodies| from_hanging(&bodies[0]))?;
    let mut simulation = Simulation::new(&scene)?;
    let begins = simulation.joint_loads()[0].force_n.length() / G;
    let tip = simulation.accelerations()?[0].angular.length() / G;
    simulation.advance_to(bottom)?;
    let load = simulation.joint_loads()[0].force_n.length() / G;
    let rate = simulation.body(BodyId::new(0)).velocity.angular.length();
    let quantity = "rod released from horizontal: hinge force at bottom / mg, w at bottom, initial hinge force/mg, tip \
        acceleration/g";
    rows.push(context.reference.row("JT-01", quantity, [load, rate, begins, tip])?);
    rows.extend(rows_of_energy("JT-01", &run(&scene.with_duration(10.0)?)?.report));
    Ok(rows)
}

/// A spherical pendulum: the conical motion, and one between two heights.
pub(crate) fn jt_02(context: &Context) -> CaseResult {
    let start = at(FRAC_PI_3);
    let moving = |speed: f64, duration_s: f64| -> super::Result<Scene> {
        let mut scene = scene("spherical pendulum").duration_s(duration_s);
        let bob = scene.add_body(particle("bob", start, DVec3::Y * speed)?);
        Ok(scene.joint(massless_rod(bob, start, DVec3::ZERO)).build()?)
    };
    let azimuth = |bodies: &[BodySample]| bodies[0].pose.translation.y.atan2(bodies[0].pose.translation.x);
    let polar = |bodies: &[BodySample]| {
        let place = bodies[0].pose.translation;
        place.x.hypot(place.y).atan2(-place.z)
    };
    let sine = FRAC_PI_3.sin();
    let conical = run(&moving((G * sine * FRAC_PI_3.tan()).sqrt(), 10.0)?)?;
    let rate = whole_angle(&conical, azimuth) / 10.0;
    let mut rows = vec![context.reference.row("JT-02", "conical rate at 60deg", rate)?];
    let scene = moving(1.0, 4.0)?;
    let whole = run(&scene)?;
    // The height turns where the vertical velocity is zero: at the lowest point, and where the bob is as high as at the
    // start.
    let turns = zeros(&whole, 2, |bodies| bodies[0].velocity.linear.z)?;
    let [lowest, highest] =
        [turns[0], turns[1]].map(|t| bodies_at(&scene, t).map(|bodies| polar(&bodies).to_degrees()));
    rows.push(context.reference.row("JT-02", "polar angle range (deg from down)", [lowest?, highest?])?);
    let period = whole_angle(&run(&scene.clone().with_duration(turns[1])?)?, azimuth);
    rows.push(context.reference.row("JT-02", "vertical period, azimuth per period (rad)", [turns[1], period])?);
    rows.extend(rows_of_energy("JT-02", &whole.report));
    Ok(rows)
}

/// A double pendulum of two particles, let go at these angles from hanging.
pub(crate) fn double(angles: [f64; 2], duration_s: f64) -> super::Result<Scene> {
    let places = [at(angles[0]), at(angles[0]) + at(angles[1])];
    let mut scene = scene("double pendulum of particles").duration_s(duration_s);
    let upper = scene.add_body(particle("upper", places[0], DVec3::ZERO)?);
    let lower = scene.add_body(particle("lower", places[1], DVec3::ZERO)?);
    let scene = scene.joint(massless_rod(upper, places[0], DVec3::ZERO));
    Ok(scene.joint(massless_rod(lower, places[1], places[0]).with(upper)).build()?)
}

/// Double pendulums of two particles, whose motion is chaotic.
pub(crate) fn jt_03(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for (first, second) in [(90.0_f64, 90.0_f64), (120.0, -10.0)] {
        let angles = [first, second].map(f64::to_radians);
        for t in [1.0, 5.0, 10.0] {
            let scene = double(angles, t)?;
            let run = run(&scene)?;
            let ways = |bodies: &[BodySample]| {
                let [upper, lower] = [0, 1].map(|body: usize| bodies[body].pose.translation);
                [upper, lower - upper]
            };
            let angle = |arm: usize| whole_angle(&run, |bodies| ways(bodies)[arm].x.atan2(-ways(bodies)[arm].z));
            let end: Vec<BodySample> = run.report.bodies.iter().map(|body| body.state).collect();
            let rate = |arm: usize| {
                let (way, speeds) =
                    (ways(&end)[arm], [end[0].velocity.linear, end[1].velocity.linear - end[0].velocity.linear]);
                // The direction in which the angle grows is that of the arm turned by a quarter from -z to x.
                speeds[arm].dot(DVec3::new(-way.z, 0.0, way.x)) / way.length_squared()
            };
            let quantity = format!("({first:.0},{second:.0}) t={t:.0}: th1, th2, w1, w2");
            rows.push(context.reference.row("JT-03", &quantity, [angle(0), angle(1), rate(0), rate(1)])?);
            rows.extend(rows_of_energy("JT-03", &run.report).into_iter().filter(|_| t == 10.0));
        }
    }
    Ok(rows)
}
