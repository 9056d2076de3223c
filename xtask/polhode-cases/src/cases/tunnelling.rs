//! Fast shots through thin plates and at each other: none is missed, none is late, and where the time is known in
//! closed form it is met.
//!
//! A shot is aimed so that the two centres meet at a known time: then the bodies overlap, whatever their shapes and
//! spins. That no impact is late is decided by a plain search over all axes at times before the one found.

use super::feature_numbers::JudgedBody;
use super::random_pairs::prism_points;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::spatial::{Motion, MotionBounds, Pose, Rotation, Velocity};
use polhode_contact::{ImpactSearch, Shape, find_impact};
use polhode_oracles::exact::pair::Pair;
use polhode_oracles::exact::polyhedron::Polyhedron;
use polhode_oracles::random::Random;

const CASE: &str = "tunnelling";
/// Shots of a full run.
const SHOTS: usize = 100_000;
/// Thickness of the plates, m.
const PLATE: f64 = 1e-3;
/// Largest speed, m/s, and angular speed, rad/s.
const SPEED: f64 = 1000.0;
const SPIN: f64 = 1e4;
/// Error of a time known in closed form, relative to the time of flight.
const TIME: f64 = 1e-12;
/// Times before an impact at which overlap is looked for.
const SAMPLES: u32 = 24;
/// An overlap smaller than this, m, before the impact is rounding of the poses: 1e4 rad/s turn a pose by one ulp of the
/// time of flight.
const ROUNDING: f64 = 1e-11;

/// A straight path and a steady spin.
#[derive(Debug, Clone, Copy)]
struct Screw {
    start: Pose,
    velocity: Velocity,
}

impl Motion for Screw {
    fn pose(&self, t: f64) -> Pose {
        let turn = Rotation::from_rotation_vector(self.velocity.angular * t);
        Pose::new(turn * self.start.rotation, self.start.translation + self.velocity.linear * t)
    }

    fn velocity(&self, _: f64) -> Velocity {
        self.velocity
    }

    fn bounds(&self, _: f64, _: f64) -> MotionBounds {
        let Velocity { linear, angular } = self.velocity;
        MotionBounds { speed: linear.length(), angular_speed: angular.length(), ..MotionBounds::default() }
    }
}

/// What the shots found.
#[derive(Debug, Default)]
struct Tally {
    shots: u64,
    missed: u64,
    late: u64,
    unanswered: u64,
    evaluations: u64,
    most: u32,
    known: u64,
    time: f64,
}

/// What is shot, or shot at.
#[derive(Debug, Clone)]
struct Body {
    shape: Shape,
    /// The same as the search knows it; a ball has none.
    polyhedron: Option<Polyhedron>,
}

impl From<JudgedBody> for Body {
    fn from(body: JudgedBody) -> Self {
        Self { shape: body.shape, polyhedron: Some(body.polyhedron) }
    }
}

/// A bullet of a few centimetres: ball, box, prism or tetrahedron.
fn bullet(random: &mut Random) -> Option<Body> {
    let body = match random.below(4) {
        0 => {
            let shape = Shape::sphere(random.between(0.005, 0.05)).ok()?;
            return Some(Body { shape, polyhedron: None });
        }
        1 => JudgedBody::cuboid(random.vector(0.005, 0.1)),
        2 => JudgedBody::hull(&prism_points(3 + random.below(10) as u32, 0.03, 0.05)),
        _ => {
            let corner = |x, y, z| DVec3::new(x, y, z) * 0.03;
            let corners =
                [corner(1.0, 1.0, 1.0), corner(1.0, -1.0, -1.0), corner(-1.0, 1.0, -1.0), corner(-1.0, -1.0, 1.0)];
            JudgedBody::hull(&corners)
        }
    };
    body.map(Body::from)
}

/// A motion whose centre is at `meeting` at the time `t`.
fn through(random: &mut Random, meeting: DVec3, t: f64, speed: f64, spin: f64) -> Screw {
    let velocity = Velocity::new(random.direction() * speed, random.direction() * spin);
    Screw { start: Pose::new(random.rotation(), meeting - velocity.linear * t), velocity }
}

/// Shots at plates that stand still, at plates that fly and turn, and at each other.
pub(super) fn shots(context: &Context) -> CaseResult {
    let (mut random, mut tally) = (Random(9), Tally::default());
    let plate = Body::from(JudgedBody::cuboid(DVec3::new(1.0, 1.0, PLATE)).ok_or("no plate")?);
    for number in 0..context.amount.of(SHOTS) {
        let Some(first) = bullet(&mut random) else { continue };
        if number % 4 == 0 {
            known(&mut tally, &mut random, &plate.shape)?;
            continue;
        }
        let t = random.between(0.01, 0.1);
        let meeting = random.vector(-0.3, 0.3);
        let speed = libm::exp10(random.between(1.0, 3.0)).min(SPEED);
        let spin = libm::exp10(random.between(0.0, 4.0)).min(SPIN);
        let bullet_motion = through(&mut random, meeting, t, speed, spin);
        let (target, other) = match number % 4 {
            1 => (plate.clone(), through(&mut random, meeting, t, 0.0, 0.0)),
            2 => (plate.clone(), through(&mut random, meeting, t, 10.0, 10.0)),
            _ => {
                let Some(second) = bullet(&mut random) else { continue };
                let (speed, spin) = (random.between(0.0, SPEED), random.between(0.0, SPIN));
                (second, through(&mut random, meeting, t, speed, spin))
            }
        };
        aimed(&mut tally, [&first, &target], [&bullet_motion, &other], t);
    }
    let named = |what: &str| format!("{what} (of {SHOTS} with --full)");
    Ok(vec![
        Row::exact(CASE, &named("shots missed"), 0_u64, tally.missed),
        Row::exact(CASE, &named("impacts found late"), 0_u64, tally.late),
        Row::exact(CASE, &named("shots without an answer"), 0_u64, tally.unanswered),
        Row::at_most(CASE, "error of a time of impact in closed form, relative to the flight", TIME, tally.time),
        Row::info(
            CASE,
            "shots, of them in closed form; separations evaluated on average and at most",
            [0.0; 4],
            [
                tally.shots as f64,
                tally.known as f64,
                tally.evaluations as f64 / tally.shots.max(1) as f64,
                f64::from(tally.most),
            ],
        ),
    ])
}

/// A shot whose centres meet at `t`; none when the bodies are not clear of each other at its start.
fn aimed(tally: &mut Tally, bodies: [&Body; 2], motions: [&Screw; 2], t: f64) {
    let settings = ImpactSearch::default();
    let shapes = bodies.map(|body| &body.shape);
    if polhode_contact::separation(shapes[0], &motions[0].start, shapes[1], &motions[1].start) <= PLATE {
        return;
    }
    tally.shots += 1;
    let report = match find_impact(shapes[0], motions[0], shapes[1], motions[1], 0.0, 2.0 * t, &settings) {
        Ok(report) => report,
        Err(error) => {
            tally.unanswered += 1;
            eprintln!("{CASE}: {error}");
            return;
        }
    };
    tally.evaluations += u64::from(report.evaluations);
    tally.most = tally.most.max(report.evaluations);
    let Some(found) = report.time.filter(|found| *found <= t) else {
        tally.missed += 1;
        eprintln!("{CASE}: missed: {report:?}, {motions:?}");
        return;
    };
    // Overlap is looked for in the last part of the flight, in which the bodies are near each other.
    let speed = (motions[0].velocity.linear - motions[1].velocity.linear).length().max(1.0);
    let near = (2.0 * (shapes[0].radius() + shapes[1].radius()) / speed).min(found);
    let overlaps = |s: f64| separation(bodies, motions, s).is_some_and(|separation| separation < -ROUNDING);
    if (1..=SAMPLES).any(|k| overlaps(found - near * f64::from(k) / f64::from(SAMPLES))) {
        tally.late += 1;
        eprintln!("{CASE}: late: {report:?}, {motions:?}");
    }
}

/// Separation by plain search, m. Nothing for a ball and a polyhedron, whose time is judged in closed form.
fn separation(bodies: [&Body; 2], motions: [&Screw; 2], t: f64) -> Option<f64> {
    let poses = motions.map(|motion| motion.pose(t));
    if let [Some(a), Some(b)] = bodies.map(|body| body.polyhedron.as_ref()) {
        let axes = Pair::new(a, &poses[0], b, &poses[1]).axes();
        return axes.iter().map(|axis| axis.separation).reduce(f64::max);
    }
    match bodies.map(|body| &body.shape) {
        [Shape::Sphere(s), Shape::Sphere(o)] => {
            Some((poses[0].translation - poses[1].translation).length() - s.radius() - o.radius())
        }
        _ => None,
    }
}

/// A shot at a plate, face on, whose time is distance over speed: a ball that spins, a box at any attitude that does
/// not, a box that spins about the normal, a point.
fn known(tally: &mut Tally, random: &mut Random, plate: &Shape) -> Result<(), Box<dyn std::error::Error>> {
    let turn = random.rotation();
    let normal = turn.rotate(DVec3::Z);
    let attitude = random.rotation();
    let height = |shape: &Shape, rotation: Rotation| match shape {
        Shape::Convex(p) => p.vertices().iter().map(|v| -normal.dot(rotation.rotate(*v))).fold(0.0, f64::max),
        Shape::Sphere(s) => s.radius(),
        _ => 0.0,
    };
    let spin = random.between(0.0, SPIN);
    let (shape, rotation, angular) = match random.below(4) {
        0 => (Shape::sphere(0.02)?, attitude, random.direction() * spin),
        1 => (Shape::cuboid(random.vector(0.01, 0.1))?, attitude, DVec3::ZERO),
        2 => (Shape::cuboid(random.vector(0.01, 0.1))?, turn, normal * spin),
        _ => (Shape::points(vec![DVec3::ZERO])?, attitude, random.direction() * spin),
    };
    let distance = random.between(1.0, 5.0);
    let linear = (random.direction() - 3.0 * normal) * random.between(1.0, 0.25 * SPEED);
    let drift = random.vector(-10.0, 10.0);
    let time = (distance - 0.5 * PLATE - height(&shape, rotation)) / -normal.dot(linear);
    // The place of impact is within the plate: the path is drawn back from there.
    let aim = turn.rotate(DVec3::new(random.between(-0.3, 0.3), random.between(-0.3, 0.3), 0.0));
    let sideways = aim - (linear - normal * normal.dot(linear)) * time;
    let start = Pose::new(rotation, normal * distance + sideways);
    let motion = Screw { start, velocity: Velocity::new(linear + drift, angular) };
    let target = Screw { start: Pose::new(turn, DVec3::ZERO), velocity: Velocity::new(drift, DVec3::ZERO) };
    tally.shots += 1;
    tally.known += 1;
    let report = find_impact(&shape, &motion, plate, &target, 0.0, 2.0 * time, &ImpactSearch::default())?;
    tally.evaluations += u64::from(report.evaluations);
    match report.time {
        Some(found) => tally.time = tally.time.max((found / time - 1.0).abs()),
        None => tally.missed += 1,
    }
    Ok(())
}
