//! Scenes of the validation cases whose motion is known in closed form, and those in which nothing moves.

use super::known::{Known, Place};
use super::setting::ALL_TIERS;
use crate::cases::bodies::{ball_on_x, bouncy, rotor};
use crate::cases::exact_drift::Hard;
use crate::cases::random_throws::Throw;
use crate::cases::slipping_and_rolling::{Shot, turntable_ball};
use crate::cases::slopes::OnSlope;
use crate::cases::{frictional_statics, seams, stacks, stacks_on_slopes, structures};
use glam::DVec3;
use polhode::Scene;
use polhode::scene::Tier;
use polhode::spatial::{Pose, Rotation};
use polhode_oracles::random::Random;
use std::error::Error;
use std::path::Path;

/// Tiers of scenes with friction and one contact.
const ROUGH: [Tier; 4] = [Tier::Accurate, Tier::Stepped, Tier::Fast, Tier::MicroCollisions];
/// Tiers of scenes in which nothing moves.
const STANDING: [Tier; 3] = [Tier::Accurate, Tier::Stepped, Tier::Fast];
/// Tiers whose law of impacts passes a blow through a row of balls.
const ROWS: [Tier; 3] = [Tier::Accurate, Tier::Stepped, Tier::Thesis];
/// Random throws, boxes on slopes, shots.
const THROWS: u64 = 40;
const SLOPES: usize = 24;
const SHOTS: usize = 24;
/// Random structures that are asked whether they stand.
const STRUCTURES: usize = 24;
/// Impacts of two balls.
const IMPACTS: usize = 10;
/// Every so many of the hard rotations is taken, if it does not take longer than this, s.
const HARD_OF: usize = 4;
const LONGEST_S: f64 = 20.0;
/// Seeds of the parameters.
const SEEDS: [u64; 3] = [521, 1521, 2521];

type Found = Result<Vec<Known>, Box<dyn Error>>;

/// Bodies thrown at walls: known is where they end.
pub(super) fn throws(draw: u64) -> Found {
    let throw = |seed: u64| {
        let Throw { name, scene, place, .. } = Throw::random(seed)?;
        let end = scene.duration_s();
        let known = move |t: f64| if t == end { vec![Place::at(0, place)] } else { Vec::new() };
        Ok(Known::motion(format!("throws/{seed} {name}"), scene, &ALL_TIERS, known))
    };
    (THROWS * draw..THROWS * (draw + 1)).map(throw).collect()
}

/// Boxes on slopes, which slide or stay.
pub(super) fn slopes(draw: u64) -> Found {
    let mut random = Random(SEEDS[0] + draw);
    let slope = |number: usize| {
        let slope = OnSlope::random(&mut random)?;
        let start = *slope.scene.bodies()[0].initial_pose();
        let scene = slope.scene.clone();
        let known = move |t: f64| vec![Place::pose(0, Pose::new(start.rotation, start.translation + slope.moved(t)))];
        Ok(Known::motion(format!("slopes/{number}"), scene, &ROUGH, known))
    };
    (0..SLOPES).map(slope).collect()
}

/// Balls that slip and come to roll, and two that roll on a turntable.
pub(super) fn shots(draw: u64) -> Found {
    let mut random = Random(SEEDS[1] + draw);
    let mut all = Vec::new();
    for number in 0..SHOTS {
        let shot = Shot::random(&mut random)?;
        let scene = shot.scene.clone();
        all.push(Known::motion(format!("shots/{number}"), scene, &ROUGH, move |t| vec![Place::at(0, shot.place(t))]));
    }
    for (name, k) in [("solid", 0.4), ("hollow", 2.0 / 3.0)] {
        // It goes round at k/(1 + k) of the turntable's 7 rad/s, at 0.5 m/s.
        let rate = 7.0 * k / (1.0 + k);
        let radius = 0.5 / rate;
        let known = move |t: f64| {
            let around = DVec3::new(libm::cos(rate * t), libm::sin(rate * t), 0.0) * radius;
            vec![Place::at(0, DVec3::new(1.0 - radius, 0.0, 0.1) + around)]
        };
        all.push(Known::motion(format!("shots/{name} ball on a turntable"), turntable_ball(k, 1.0)?, &ROUGH, known));
    }
    Ok(all)
}

/// Free rotations computed to 40 digits: known is their attitude at the end.
pub(super) fn rotations(root: &Path) -> Found {
    let path = root.join("fixtures/reference/free_rotation/hard_cases.csv");
    let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut all = Vec::new();
    for (number, line) in text.lines().filter(|line| !line.starts_with('#')).enumerate() {
        let hard = Hard::parse(line)?;
        let end = hard.time.abs();
        if !number.is_multiple_of(HARD_OF) || end > LONGEST_S || hard.kind == "Unphysical" {
            continue;
        }
        // The motion before the start is that of the opposite spin after it.
        let spin = hard.momentum / hard.moments * hard.time.signum();
        let scene = Scene::builder("free rotation").gravity(DVec3::ZERO).duration_s(end);
        let scene = scene.body(rotor("rotor", hard.moments, spin)?).build()?;
        let pose = Pose::new(hard.attitude, DVec3::ZERO);
        let known = move |t: f64| if t == end { vec![Place::pose(0, pose)] } else { Vec::new() };
        all.push(Known::motion(format!("rotations/{number} {}", hard.kind), scene, &ALL_TIERS, known));
    }
    Ok(all)
}

/// Balls that meet head on, of any masses, and rows of balls.
pub(super) fn impacts(draw: u64) -> Found {
    let mut random = Random(SEEDS[2] + draw);
    let mut all = Vec::new();
    for number in 0..IMPACTS {
        let (ratio, e, speed) = (random.between(-3.0, 3.0), random.between(0.0, 1.0), random.between(1.0, 4.0));
        let second = libm::exp10(ratio);
        let [left, right] = [[1.0, -1.0, speed], [second, 1.0, 0.0]];
        let scene = Scene::builder("two balls")
            .gravity(DVec3::ZERO)
            .body(ball_on_x("first", 0.5, left[0], left[1], left[2])?.material(bouncy(e)?))
            .body(ball_on_x("second", 0.5, right[0], right[1], right[2])?)
            .duration_s(2.0 / speed)
            .build()?;
        let after = [(1.0 - e * second) / (1.0 + second), (1.0 + e) / (1.0 + second)].map(|part| part * speed);
        let known = move |t: f64| {
            let (before_s, after_s) = (t.min(1.0 / speed), (t - 1.0 / speed).max(0.0));
            let at = |body: usize, x: f64| Place::pose(body, Pose::from_translation(DVec3::X * x));
            vec![at(0, -1.0 + speed * before_s + after[0] * after_s), at(1, 1.0 + after[1] * after_s)]
        };
        all.push(Known::motion(format!("impacts/two balls {number}"), scene, &ALL_TIERS, known));
    }
    for [count, moving] in [[3usize, 1usize], [4, 1], [5, 1], [5, 2], [4, 3], [8, 3]] {
        all.push(Known::motion(format!("impacts/{moving} of {count} balls"), row(count, moving)?, &ROWS, move |t| {
            let (before_s, after_s) = (t.min(1.0), (t - 1.0).max(0.0));
            let x = |ball: usize| {
                let comes = if ball < moving { before_s - 1.0 } else { 0.0 };
                ball as f64 + comes + if ball + moving >= count { after_s } else { 0.0 }
            };
            (0..count).map(|ball| Place::pose(ball, Pose::from_translation(DVec3::X * x(ball)))).collect()
        }));
    }
    Ok(all)
}

/// Equal balls in a row that touch; the first come at 1 m/s from 1 m away.
fn row(count: usize, moving: usize) -> Result<Scene, Box<dyn Error>> {
    let mut builder = Scene::builder("row of balls").gravity(DVec3::ZERO).duration_s(1.5);
    for number in 0..count {
        let comes = if number < moving { 1.0 } else { 0.0 };
        let ball = ball_on_x(&number.to_string(), 0.5, 1.0, number as f64 - comes, comes)?;
        builder = builder.body(ball.material(bouncy(1.0)?));
    }
    Ok(builder.build()?)
}

/// Bodies that slide over the seams of tiles: they keep their velocity.
pub(super) fn over_seams() -> Found {
    let known = |(name, scene): (&str, Scene)| {
        let slider = scene.bodies().len() - 1;
        let body = &scene.bodies()[slider];
        let (start, velocity) = (*body.initial_pose(), body.initial_velocity().linear);
        let known = move |t: f64| {
            let rotation: Rotation = start.rotation;
            vec![Place::pose(slider, Pose::new(rotation, start.translation + velocity * t))]
        };
        Known::motion(format!("seams/{name}"), scene, &ALL_TIERS, known)
    };
    Ok(seams::crossings()?.into_iter().map(known).collect())
}

/// Structures in which nothing moves.
pub(super) fn standing(draw: u64) -> Found {
    let mut all = Vec::new();
    for bricks in [1, 2, 3, 5, 10] {
        // A hundredth of a brick behind the place where it would fall.
        all.push((format!("overhang of {bricks} bricks"), stacks::overhang(bricks, -0.01)?));
    }
    all.extend(stacks_on_slopes::standing()?);
    all.extend(frictional_statics::standing()?);
    all.extend(structures::standing(STRUCTURES * draw as usize..STRUCTURES * (draw as usize + 1))?);
    let still = |(name, scene): (String, Scene)| {
        Ok(Known::still(format!("still/{name}"), scene.with_duration(1.0)?, &STANDING))
    };
    all.into_iter().map(still).collect()
}
