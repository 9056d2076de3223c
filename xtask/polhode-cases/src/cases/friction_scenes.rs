//! Scenes of friction that people try, as they ship: each against what is known of it in closed form.
//!
//! | scene | what is known |
//! |---|---|
//! | ladders on a smooth wall | friction that statics asks for: `x/z`, centre of mass x from the foot, top at z |
//! | billiards | a ball with speed v and spin w ends up rolling with `(5 v + 2 R w)/7` |
//! | | a head-on impact of two balls |
//! | ball on a turntable | goes round a circle at 2/7 of the table's rate (Earnshaw 1844) |
//! | conveyor | a body set down slides for `v/(mu g)` and `v^2/(2 mu g)` |
//! | books | slide `v^2/(2 mu g)` |
//! | dominoes | fall one after the other |
//! | Kapla tower | stands |

use super::bodies::{GRAVITY, cuboid};
use super::rough_plane::{Plane, rough, threshold};
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::{Body, BodyId, BodySample, EventKind, Scene, Simulation};
use polhode_scene::{Override, load_with};
use std::error::Error;

const CASE: &str = "scenes of friction";

/// Tolerance of thresholds of friction, velocities and places, relative.
const RELATIVE: f64 = 1e-9;

/// Tolerance of places, m.
const PLACE_M: f64 = 1e-9;

/// A body that moves by less has stood still, m: rounding of its coordinates.
const STOOD_M: f64 = 1e-12;

/// A body whose points accelerate by less is in equilibrium, m/s^2; rounding errors are some 1e-13.
const EQUILIBRIUM: f64 = 1e-9;

/// All rows.
pub(super) fn rows(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for part in [ladders, billiards, masse, turntable, conveyor, books, dominoes, tower] {
        rows.extend(part(context)?);
    }
    Ok(rows)
}

/// The body of this name with its number.
fn body_of<'a>(scene: &'a Scene, name: &str) -> Result<(usize, &'a Body), Box<dyn Error>> {
    let found = scene.bodies().iter().enumerate().find(|(_, body)| body.name() == name);
    Ok(found.ok_or_else(|| format!("{}: no body {name}", scene.name()))?)
}

/// The friction that a ladder needs, by statics and by the search for the least that holds it; and what it does.
fn ladders(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for (scene, ladders) in [("ladder", ["steep", "flat"]), ("ladder-climber", ["climber low", "climber high"])] {
        let path = context.shipped.path(scene);
        let with_friction = |friction: f64| -> Result<Scene, Box<dyn Error>> {
            let rule = Override::new("verify", "materials.wood.friction", format!("{friction:?}"));
            Ok(load_with(&path, &[rule]).map_err(|error| error.to_string())?.scene)
        };
        for name in ladders {
            let needed = threshold(MOST_FRICTION, LEAST_FRICTION, |friction| {
                let scene = with_friction(friction)?;
                let (index, _) = body_of(&scene, name)?;
                let accelerations = Simulation::new(&scene)?.accelerations()?;
                let a = accelerations.get(index).ok_or("no acceleration")?;
                Ok(a.linear.length() <= EQUILIBRIUM && a.angular.length() <= EQUILIBRIUM)
            })?;
            let expected = friction_by_statics(&with_friction(MOST_FRICTION)?, name)?;
            let quantity = format!("{scene}, {name}: least friction that holds");
            rows.push(Row::compared(CASE, &quantity, expected, needed, Tolerance::Relative(RELATIVE)));
        }
        let run = context.shipped.run(scene)?;
        let moved = ladders.map(|name| movement(&run, name).map(|moved| moved > STOOD_M));
        let moved = moved.into_iter().collect::<Result<Vec<bool>, _>>()?;
        rows.push(Row::exact(CASE, &format!("{scene}: which slides"), vec![false, true], moved));
    }
    Ok(rows)
}

/// Friction at which the ladders stand, and at which they do not.
const MOST_FRICTION: f64 = 0.6;
const LEAST_FRICTION: f64 = 0.1;

/// How far the origin of a body has moved, m.
fn movement(run: &Run, name: &str) -> Result<f64, Box<dyn Error>> {
    let start = body_of(&run.scene, name)?.1.initial_pose().translation;
    Ok((run.last(name)?.pose.translation - start).length())
}

/// Moments about the foot: the wall's force, which is the friction at the foot, times the height of the top is the
/// weight times the distance of the centre of mass.
fn friction_by_statics(scene: &Scene, name: &str) -> Result<f64, Box<dyn Error>> {
    let body = body_of(scene, name)?.1;
    let properties = body.mass_properties().ok_or("no mass")?;
    let center = body.initial_pose().transform_point(properties.center_of_mass());
    let simulation = Simulation::new(scene)?;
    let id = simulation.body_id(name).ok_or("no such body")?;
    let contacts = simulation.contacts();
    let points = contacts.iter().filter(|contact| contact.body_a == id || contact.body_b == id);
    let mut points: Vec<DVec3> = points.map(|contact| contact.point_m).collect();
    points.sort_by(|a, b| a.z.total_cmp(&b.z));
    let (foot, top) = (points.first().ok_or("no contact")?, points.last().ok_or("no contact")?);
    Ok((center.x - foot.x) / (top.z - foot.z))
}

/// A ball of a billiard table: its speed and spin along its way, and its radius.
#[derive(Debug, Clone, Copy)]
struct Rolling {
    /// Velocity, m/s.
    v: f64,
    /// Angular velocity, positive when it rolls forwards, rad/s.
    w: f64,
}

/// Radius of the balls, m; friction of the cloth; restitution of two balls; and the way of the cue ball, m.
const BALL_M: f64 = 0.028_575;
const CLOTH: f64 = 0.2;
const BALLS_RESTITUTION: f64 = 0.95;
const DISTANCE_M: f64 = 0.3 - 2.0 * BALL_M;

impl Rolling {
    /// After it has gone `distance` (m), sliding all the way or rolling all the way.
    fn after(self, distance: f64) -> Self {
        let slip = self.v - BALL_M * self.w;
        if slip.abs() < f64::EPSILON * self.v.abs() {
            return self;
        }
        let deceleration = CLOTH * GRAVITY * slip.signum();
        let v = (self.v * self.v - 2.0 * deceleration * distance).sqrt();
        let t = (self.v - v) / deceleration;
        Self { v, w: self.w + 2.5 * deceleration * t / BALL_M }
    }

    /// The speed at which it rolls in the end, m/s.
    fn rolls(self) -> f64 {
        (5.0 * self.v + 2.0 * BALL_M * self.w) / 7.0
    }
}

/// Draw and follow: where the cue ball and the ball that it hits end up rolling.
fn billiards(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for (scene, spin) in [("billiard-draw", -120.0), ("billiard-follow", 2.0 / BALL_M)] {
        let hits = Rolling { v: 2.0, w: spin }.after(DISTANCE_M);
        let cue = Rolling { v: 0.5 * (1.0 - BALLS_RESTITUTION) * hits.v, w: hits.w };
        let object = Rolling { v: 0.5 * (1.0 + BALLS_RESTITUTION) * hits.v, w: 0.0 };
        let run = context.shipped.run(scene)?;
        let found = [run.last("cue ball")?.velocity.linear.x, run.last("object ball")?.velocity.linear.x];
        rows.push(Row::compared(
            CASE,
            &format!("{scene}: velocities in the end, cue ball and object ball, m/s"),
            [cue.rolls(), object.rolls()],
            found,
            Tolerance::Relative(RELATIVE),
        ));
    }
    Ok(rows)
}

/// The masse shot: the cue ball is on its parabola (Coriolis 1835) until it meets the object ball, and nothing else.
fn masse(context: &Context) -> CaseResult {
    let run = context.shipped.run("billiard-masse")?;
    let (cue, body) = body_of(&run.scene, "cue ball")?;
    let (object, _) = body_of(&run.scene, "object ball")?;
    let start = body.initial_velocity();
    let slip = start.at(DVec3::Z * -BALL_M);
    let deceleration = slip / slip.length() * (CLOTH * GRAVITY);
    let impacts = run.events(EventKind::Impact);
    let of_balls: Vec<_> = impacts.iter().filter(|event| event.normal.z.abs() < LEVEL).collect();
    let first = of_balls.first().ok_or("the balls do not meet")?;
    let is_of = |a: usize, b: usize| {
        let (a, b) = (BodyId::new(a), BodyId::new(b));
        of_balls.iter().all(|event| [(a, Some(b)), (b, Some(a))].contains(&(event.body_a, event.body_b)))
    };
    let mut worst = 0.0f64;
    for (t, sample) in run.record.times_s.iter().zip(&run.record.samples).filter(|(t, _)| **t <= first.t_s) {
        let expected = body.initial_pose().translation + start.linear * *t - deceleration * (0.5 * t * t);
        worst = worst.max((sample.get(cue).ok_or("no sample")?.pose.translation - expected).length());
    }
    Ok(vec![
        Row::exact(CASE, "billiard-masse: the cue ball meets the object ball alone", true, is_of(cue, object)),
        Row::at_most(CASE, "billiard-masse: distance from its parabola before, m", PLACE_M, worst),
    ])
}

/// The normal of an impact between balls has a vertical part smaller than this: they differ in height by rounding.
const LEVEL: f64 = 1e-6;

/// The ball on the turntable: on its circle at every sample.
fn turntable(context: &Context) -> CaseResult {
    let run = context.shipped.run("turntable-ball")?;
    let (ball, _) = body_of(&run.scene, "ball")?;
    let (center, radius, rate) = (DVec3::new(0.75, 0.0, 0.1), 0.25, 2.0 / 7.0 * 7.0);
    let mut worst = 0.0f64;
    for (t, sample) in run.record.times_s.iter().zip(&run.record.samples) {
        let (sine, cosine) = (rate * t).sin_cos();
        let expected = center + DVec3::new(cosine, sine, 0.0) * radius;
        worst = worst.max((sample.get(ball).ok_or("no sample")?.pose.translation - expected).length());
    }
    Ok(vec![Row::at_most(CASE, "turntable-ball: distance from its circle at 2/7 of the rate, m", PLACE_M, worst)])
}

/// The conveyor: where the parcel is, and that the bottle lies.
fn conveyor(context: &Context) -> CaseResult {
    let run = context.shipped.run("conveyor")?;
    let (speed, friction) = (1.0, 0.5);
    let slid = speed * speed / (2.0 * friction * GRAVITY);
    let expected = 1.2 - (speed * run.report.duration_s - slid);
    let parcel = run.last("parcel")?;
    let bottle = run.last("bottle")?.pose.rotation.rotate(DVec3::Z);
    Ok(vec![
        Row::compared(
            CASE,
            "conveyor: place and velocity of the parcel",
            [expected, -speed],
            [parcel.pose.translation.x, parcel.velocity.linear.x],
            Tolerance::Relative(RELATIVE),
        ),
        Row::at_most(CASE, "conveyor: slope of the axis of the bottle, which lies", LEVEL, bottle.z.abs()),
    ])
}

/// Books: where the slow one stops, and which fall.
fn books(context: &Context) -> CaseResult {
    let run = context.shipped.run("book-off-desk")?;
    let (speed, friction) = (1.2, 0.3);
    let expected = -0.3 + speed * speed / (2.0 * friction * GRAVITY);
    let falls = |sample: BodySample| sample.pose.translation.z < -0.5;
    let fallen = vec![falls(run.last("slow book")?), falls(run.last("book")?), falls(run.last("fast book")?)];
    Ok(vec![
        Row::compared(
            CASE,
            "book-off-desk: where the slow book stops, m",
            expected,
            run.last("slow book")?.pose.translation.x,
            Tolerance::Relative(RELATIVE),
        ),
        Row::exact(CASE, "book-off-desk: which fall", vec![false, true, true], fallen),
    ])
}

/// Dominoes: each is first hit by the one before it, one after the other.
fn dominoes(context: &Context) -> CaseResult {
    let run = context.shipped.run("dominoes")?;
    let (first, _) = body_of(&run.scene, "domino 1")?;
    let mut pairs: Vec<(usize, usize)> = Vec::new();
    for event in run.events(EventKind::Impact) {
        let pair = event.body_b.map(|b| (event.body_a.min(b).index(), event.body_a.max(b).index()));
        let Some(pair) = pair.filter(|(a, b)| (*a >= first) && (*b > first)) else { continue };
        if !pairs.contains(&pair) {
            pairs.push(pair);
        }
    }
    let words = |pairs: &[(usize, usize)]| {
        let words: Vec<String> =
            pairs.iter().map(|(a, b)| format!("{} hits {}", a - first + 1, b - first + 1)).collect();
        words.join(", ")
    };
    let in_order: Vec<(usize, usize)> = (0..pairs.len()).map(|k| (first + k, first + k + 1)).collect();
    Ok(vec![Row::exact(CASE, "dominoes: order of the first impacts", words(&in_order), words(&pairs))])
}

/// The Kapla tower: nothing moves, in the shipped part of it and in SimBenchmark's whole one for its 600 s.
fn tower(context: &Context) -> CaseResult {
    let run = context.shipped.run("kapla-tower")?;
    let shipped = format!("kapla-tower: movement in {} s, m", run.report.simulated_s);
    let scene = whole_tower()?;
    let blocks = scene.bodies().iter().filter(|body| body.mass_properties().is_some()).count();
    let whole = format!("SimBenchmark's tower of {blocks} blocks: movement in {TOWER_S} s, m");
    let report = Simulation::new(&scene)?.run()?;
    let moved = scene.bodies().iter().zip(&report.bodies);
    let moved = moved.map(|(body, end)| (end.state.pose.translation - body.initial_pose().translation).length());
    Ok(vec![
        Row::at_most(CASE, &shipped, STOOD_M, run.largest_movement_m()),
        Row::at_most(CASE, &whole, STOOD_M, moved.fold(0.0, f64::max)),
    ])
}

/// How long SimBenchmark's tower is to stand, s.
const TOWER_S: f64 = 600.0;

/// Friction of its blocks and of the ground.
const TOWER_FRICTION: f64 = 0.8;

/// SimBenchmark's tower: six storeys of eight bases across and nine blocks along on them.
fn whole_tower() -> Result<Scene, Box<dyn Error>> {
    let (base, along) = (DVec3::new(0.05, 0.25, 0.1), DVec3::new(0.2, 0.05, 0.1));
    let rows = [(0.1, -0.1, 4), (0.3, 0.1, 3), (0.1, 0.1, 1), (1.3, 0.1, 1)];
    let mut blocks = Vec::new();
    for storey in 0..6_u32 {
        let height = 0.05 + 0.2 * f64::from(storey);
        blocks.extend((0..8_u32).map(|k| (base, DVec3::new(0.2 * f64::from(k), 0.0, height))));
        for (x, y, count) in rows {
            let place = |k: u32| DVec3::new(x + 0.4 * f64::from(k), y, height + 0.1);
            blocks.extend((0..count).map(|k| (along, place(k))));
        }
    }
    let wood = rough(TOWER_FRICTION)?;
    let ground = Plane::LEVEL.ground(TOWER_FRICTION)?;
    let mut scene = Scene::builder("SimBenchmark's tower").duration_s(TOWER_S).body(ground);
    for (number, (size, center)) in blocks.into_iter().enumerate() {
        scene = scene.body(cuboid(&format!("block {number}"), size, 10.0, center)?.material(wood.clone()));
    }
    Ok(scene.build()?)
}
