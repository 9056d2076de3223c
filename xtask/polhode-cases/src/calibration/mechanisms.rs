//! Mechanisms whose motion is known: pendulums, chains, a loop, a Cardan joint, steady tops.

use super::known::{Known, Place};
use super::oracles::{Angles, chain, double_pendulum, pendulum};
use crate::cases::heavy_tops::{self, AXIAL, WEIGHT};
use crate::cases::joints::cardan::{Fork, shafts};
use crate::cases::joints::chains::hung;
use crate::cases::joints::loops::four_bar;
use crate::cases::joints::pendulums::{double, of_particle, of_rod};
use glam::DVec3;
use polhode::scene::Tier;
use polhode::spatial::{Pose, Rotation};
use polhode_oracles::random::Random;
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};

/// Tiers that take joints.
const JOINTED: [Tier; 3] = [Tier::Accurate, Tier::Stepped, Tier::Fast];
/// Time that mechanisms are followed, s.
const FOLLOWED_S: f64 = 1.0;
/// Steady tops.
const TOPS: usize = 8;
/// Seed of their parameters.
const SEED: u64 = 52;

/// A pendulum's arm of 1 m at an angle from hanging.
fn arm(angle: f64) -> DVec3 {
    DVec3::new(libm::sin(angle), 0.0, -libm::cos(angle))
}

/// A turn about y, rad.
fn about_y(angle: f64) -> Rotation {
    Rotation::from_rotation_vector(DVec3::Y * angle)
}

/// The pose of a rod of 1 m that hangs at an angle from a point.
fn hanging(from: DVec3, angle: f64) -> Pose {
    Pose::new(about_y(FRAC_PI_2 - angle), from + arm(angle) * 0.5)
}

/// Pendulums of particles and rods, and double pendulums.
pub(super) fn pendulums() -> Result<Vec<Known>, Box<dyn Error>> {
    let mut all = Vec::new();
    for degrees in [10.0f64, 60.0, 90.0, 150.0] {
        let angle = degrees.to_radians();
        let start = Angles::at_rest(&[angle]);
        let scene = of_particle(angle)?.with_duration(FOLLOWED_S)?;
        all.push(Known::motion(format!("joints/particle at {degrees} degrees"), scene, &JOINTED, move |t| {
            let angle = start.after(t, &pendulum(1.0))[0];
            vec![Place::pose(0, Pose::from_translation(arm(angle)))]
        }));
        let start = Angles::at_rest(&[angle]);
        let scene = of_rod(angle, FOLLOWED_S)?;
        all.push(Known::motion(format!("joints/rod at {degrees} degrees"), scene, &JOINTED, move |t| {
            vec![Place::pose(0, hanging(DVec3::ZERO, start.after(t, &pendulum(2.0 / 3.0))[0]))]
        }));
    }
    for degrees in [[90.0f64, 90.0], [120.0, -10.0], [30.0, 60.0]] {
        let angles = degrees.map(f64::to_radians);
        let start = Angles::at_rest(&angles);
        let scene = double(angles, FOLLOWED_S)?;
        all.push(Known::motion(format!("joints/double pendulum at {degrees:?}"), scene, &JOINTED, move |t| {
            let angles = start.after(t, &double_pendulum);
            let upper = arm(angles[0]);
            let poses = [upper, upper + arm(angles[1])].map(Pose::from_translation);
            vec![Place::pose(0, poses[0]), Place::pose(1, poses[1])]
        }));
    }
    Ok(all)
}

/// Chains of four rods, hanging still or let go, a loop that is a pendulum, and a Cardan joint.
pub(super) fn chains() -> Result<Vec<Known>, Box<dyn Error>> {
    let mut all = vec![Known::still("joints/chain that hangs".to_owned(), hung([0.0; 4], FOLLOWED_S)?, &JOINTED)];
    for (name, angles) in [("level chain", [FRAC_PI_2; 4]), ("bent chain", [0.3, 0.6, 0.2, -0.4])] {
        let start = Angles::at_rest(&angles);
        let scene = hung(angles, FOLLOWED_S)?;
        all.push(Known::motion(format!("joints/{name}"), scene, &JOINTED, move |t| {
            let mut end = DVec3::ZERO;
            let mut places = Vec::new();
            for (body, angle) in start.after(t, &chain).into_iter().enumerate() {
                places.push(Place::pose(body, hanging(end, angle)));
                end += arm(angle);
            }
            places
        }));
    }
    // It is a pendulum that stands upright.
    let start = Angles::one(0.0, 1.0);
    all.push(Known::motion("joints/four-bar".to_owned(), four_bar(FOLLOWED_S)?, &JOINTED, move |t| {
        let angle = start.after(t, &pendulum(-6.0 / 7.0))[0];
        let upright = DVec3::new(libm::sin(angle), 0.0, libm::cos(angle));
        let foot = |column: usize| DVec3::X * column as f64;
        let mut places: Vec<Place> = (0..3)
            .map(|column| Place::pose(column, Pose::new(about_y(angle - FRAC_PI_2), foot(column) + upright * 0.5)))
            .collect();
        let bar = |column: usize| Pose::from_translation(foot(column) + DVec3::X * 0.5 + upright);
        places.extend((0..2).map(|column| Place::pose(3 + column, bar(column))));
        places
    }));
    for (name, fork, ratio) in
        [("in plane", Fork::InPlane, 1.0 / FRAC_PI_6.cos()), ("across", Fork::Across, FRAC_PI_6.cos())]
    {
        let scene = shafts(fork, FOLLOWED_S)?;
        let starts = [0, 1].map(|body: usize| *scene.bodies()[body].initial_pose());
        let axes = [DVec3::X, DVec3::new(FRAC_PI_6.cos(), FRAC_PI_6.sin(), 0.0)];
        all.push(Known::motion(format!("joints/Cardan, fork {name}"), scene, &JOINTED, move |t| {
            let turns = [t, libm::atan(ratio * libm::tan(t))];
            let pose = |body: usize| {
                let turn = Rotation::from_rotation_vector(axes[body] * turns[body]);
                Pose::new(turn * starts[body].rotation, starts[body].translation)
            };
            vec![Place::pose(0, pose(0)), Place::pose(1, pose(1))]
        }));
    }
    Ok(all)
}

/// Tops that precess without nodding.
pub(super) fn tops(draw: u64) -> Result<Vec<Known>, Box<dyn Error>> {
    let mut random = Random(SEED + draw);
    let mut all = Vec::new();
    for number in 0..TOPS {
        let (lean, spin) = (random.between(0.3, 1.4), random.between(15.0, 40.0));
        // A rate^2 cos(theta) - C spin rate + m g l = 0, with A = 1 kg m^2: the slow root.
        let (a, b) = (libm::cos(lean), AXIAL * spin);
        let rate = 2.0 * WEIGHT / (b + (b * b - 4.0 * a * WEIGHT).sqrt());
        let own = spin - rate * a;
        let scene = heavy_tops::precessing(lean, spin, rate)?.duration_s(FOLLOWED_S).build()?;
        let start = heavy_tops::lean(lean);
        let tiers = [Tier::Accurate, Tier::Stepped];
        all.push(Known::motion(format!("tops/steady {number}"), scene, &tiers, move |t| {
            let turn = |angle: f64| Rotation::from_rotation_vector(DVec3::Z * angle);
            vec![Place::pose(0, Pose::new(turn(rate * t) * start * turn(own * t), DVec3::ZERO))]
        }));
    }
    Ok(all)
}
