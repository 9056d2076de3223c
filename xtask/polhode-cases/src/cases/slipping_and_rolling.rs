//! FC-07, FC-08, FC-10, FC-11, FC-19 and SimBenchmark's rolling: round bodies that slip, come to roll, and roll.
//!
//! A slip of constant direction has a constant rate, so a ball that slips on level ground moves on a parabola:
//! `v(t) = v0 - mu g t s`, `s` the direction of its slip, until `t = 2 |u|/(7 mu g)`; then it rolls.

use super::bodies::{GRAVITY, cuboid, half_space};
use super::motion::zero;
use super::rough_plane::{Plane, end_of, first_acceleration, first_event, rough, sphere, sphere_of_inertia, threshold};
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::contact::Shape;
use polhode::mesh::solid_sphere;
use polhode::scene::{Force, Frame, PairRule, PrescribedMotion, Signal};
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, BodySample, Effects, Scene, Simulation};
use polhode_oracles::random::Random;
use std::error::Error;
use std::f64::consts::FRAC_PI_2;

/// A body rolls when it slips more slowly than this, m/s.
const ROLLS_M_S: f64 = 1e-9;

/// Tolerance of speeds, times and places, as in the catalogue of cases, relative.
const ROLLING: f64 = 1e-10;

/// Tolerance of places on the turntable, m.
const PLACE_M: f64 = 1e-9;

/// Limit of the mean squared error of velocities, (m/s)^2; docs/REFERENCES.md, SimBenchmark.
const MEAN_SQUARE: f64 = 1e-20;

/// Time between two samples of the benchmark, s.
const SAMPLE_S: f64 = 1e-3;

/// Slip of a ball of this radius on level ground, m/s.
fn slip(sample: &BodySample, radius: f64) -> DVec3 {
    sample.velocity.at(DVec3::Z * -radius)
}

/// A solid ball on level ground.
pub(super) fn ball(
    radius: f64,
    linear: DVec3,
    angular: DVec3,
    friction: f64,
    duration_s: f64,
) -> Result<Scene, Box<dyn Error>> {
    let body = Plane::LEVEL.round(sphere(radius)?, radius, Velocity::new(linear, angular));
    Ok(Plane::LEVEL.with(body, friction)?.duration_s(duration_s).build()?)
}

/// When a ball comes to roll, s, and its state then.
fn begins_to_roll(scene: &Scene, radius: f64) -> Result<(f64, BodySample), Box<dyn Error>> {
    first_event(scene, |sample| slip(sample, radius).length() < ROLLS_M_S)
}

/// A ball that slides without spin comes to roll with 5/7 of its speed.
pub(super) fn fc_07(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let speed = 7.0;
    let scene = |duration_s: f64| ball(1.0, DVec3::X * speed, DVec3::ZERO, 0.2, duration_s);
    let (t, state) = begins_to_roll(&scene(2.0)?, 1.0)?;
    let run = Run::of(&scene(t + 100.0)?, Effects::Planned)?;
    let last = run.last("ball")?;
    let height = GRAVITY;
    let fraction = (run.report.energy.final_j - height) / (run.report.energy.initial_j - height);
    Ok(vec![
        reference.row("FC-07", "v_roll, t_roll, x_roll", [state.velocity.linear.x, t, state.pose.translation.x])?,
        reference.row("FC-07", "kinetic energy fraction left", fraction)?,
        reference.row("FC-07", "velocity 100 s later (no rolling resistance)", last.velocity.linear.x)?,
    ])
}

/// Billiard shots: the slip keeps its direction, the ball moves on a parabola, then straight on.
pub(super) fn fc_08(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let radius = 0.0286;
    let scene = ball(radius, DVec3::X * 2.0, DVec3::new(30.0, -60.0, 50.0), 0.2, 1.0)?;
    let start =
        BodySample { velocity: Velocity::new(DVec3::X * 2.0, DVec3::new(30.0, -60.0, 50.0)), ..end_of(&scene)? };
    let (t, state) = begins_to_roll(&scene, radius)?;
    let end = end_of(&scene)?.velocity.linear;
    // How fast the slip shrinks tells what it was.
    let speed = 3.5 * 0.2 * GRAVITY * t;
    let place = state.pose.translation;
    let draw = ball(radius, DVec3::X, DVec3::Y * -200.0, 0.2, 2.0)?;
    let mut rows = vec![
        reference.row("FC-08", "slip speed, time to rolling", [slip(&start, radius).length(), t])?,
        Row::compared(
            "FC-08",
            "slip speed from its rate and the time",
            slip(&start, radius).length(),
            speed,
            Tolerance::Relative(ROLLING),
        ),
        reference.row("FC-08", "rolling velocity", [end.x, end.y])?,
        reference.row("FC-08", "position when rolling starts", [place.x, place.y])?,
        reference.row(
            "FC-08",
            "draw shot v=1, backspin wy=-200: rolling velocity (negative = comes back)",
            end_of(&draw)?.velocity.linear.x,
        )?,
    ];
    rows.extend(random_shots(context)?);
    Ok(rows)
}

/// A shot, and what its ball does.
pub(crate) struct Shot {
    /// The ball is its first body.
    pub(crate) scene: Scene,
    radius: f64,
    /// Velocities at the start and while it rolls, m/s.
    linear: DVec3,
    rolling: DVec3,
    /// When it begins to roll, s.
    rolls_s: f64,
    /// Slip at the start, m/s.
    slip: DVec3,
}

impl Shot {
    /// A shot of any speed and spin, of a ball of any size and moment of inertia.
    pub(crate) fn random(random: &mut Random) -> Result<Self, Box<dyn Error>> {
        let (radius, friction) = (random.between(0.01, 1.0), random.between(0.05, 1.0));
        let k = random.between(0.1, 0.66);
        let mut vector = || DVec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        let linear = vector() * DVec3::new(5.0, 5.0, 0.0);
        let angular = vector() * (5.0 / radius);
        let slip = linear + angular.cross(DVec3::Z * -radius);
        // The slip falls by mu g (1 + m r^2/I) each second.
        let rolls_s = slip.length() / (friction * GRAVITY * (1.0 + 1.0 / k));
        let rolling = linear - slip / (1.0 + 1.0 / k);
        let body = sphere_of_inertia(radius, k * radius * radius)?;
        let body = Plane::LEVEL.round(body, radius, Velocity::new(linear, angular));
        let scene = Plane::LEVEL.with(body, friction)?.duration_s(2.0 * rolls_s).build()?;
        Ok(Self { scene, radius, linear, rolling, rolls_s, slip })
    }

    /// Where the ball is at a time (s), m.
    pub(crate) fn place(&self, t: f64) -> DVec3 {
        let slipping = t.min(self.rolls_s);
        let now = self.linear + (self.rolling - self.linear) * (slipping / self.rolls_s);
        (self.linear + now) * (0.5 * slipping) + self.rolling * (t - slipping) + DVec3::Z * self.radius
    }
}

/// Shots of any speed and spin, of balls of any size and moment of inertia.
fn random_shots(context: &Context) -> CaseResult {
    /// Shots at full count.
    const SHOTS: usize = 1000;
    let mut random = Random(8);
    let mut worst = 0.0f64;
    let count = context.amount.of(SHOTS);
    for _ in 0..count {
        let shot = Shot::random(&mut random)?;
        let t = shot.rolls_s;
        let end = end_of(&shot.scene)?;
        let size = (shot.linear.length() + shot.slip.length()) * t;
        worst = worst.max((end.pose.translation - shot.place(2.0 * t)).length() / size);
        worst = worst.max((end.velocity.linear - shot.rolling).length() * t / size);
    }
    Ok(vec![Row::at_most(
        "FC-08",
        &format!("{count} shots: error of place and velocity after rolling, relative"),
        ROLLING,
        worst,
    )])
}

/// A ball that rolls on a turntable moves on a circle; solid and hollow.
pub(super) fn fc_10(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let solid = turntable_ball(0.4, 1.0)?;
    let hollow = turntable_ball(2.0 / 3.0, 1.0)?;
    let rates = [orbit_rate(&solid)?, orbit_rate(&hollow)?];
    // Three places of the circle tell its centre.
    let places = [0.3, 1.2, 2.1].map(|t| place_at(0.4, t));
    let [a, b, c] = places;
    let (center, radius) = circle_through(a?, b?, c?);
    let end = place_at(0.4, 10.0)?;
    Ok(vec![
        reference.row("FC-10", "orbit rate solid, hollow", rates)?,
        Row::compared(
            "FC-10",
            "orbit radius and centre, m",
            [0.25, 0.75, 0.0],
            [radius, center.x, center.y],
            Tolerance::Absolute(PLACE_M),
        ),
        reference.row("FC-10", "position after t=10 s", [end.x, end.y])?,
    ])
}

/// A ball of 1 kg whose moment is `k m r^2`, rolling on a turntable.
pub(crate) fn turntable_ball(k: f64, duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let (radius, rate) = (0.1, 7.0);
    let (place, linear) = (DVec3::X, DVec3::Y * 0.5);
    let motion = PrescribedMotion::constant_velocity(Velocity::new(DVec3::ZERO, DVec3::Z * rate))?;
    let table = Body::kinematic("turntable", motion).geometry(Shape::half_space(UnitVector::Z).into());
    let over_table = linear - (DVec3::Z * rate).cross(place);
    let body = sphere_of_inertia(radius, k * radius * radius)?
        .pose(Pose::from_translation(place + DVec3::Z * radius))
        .velocity(Velocity::new(linear, DVec3::Z.cross(over_table) / radius));
    let scene = Scene::builder("ball on a turntable").body(body.material(rough(1.0)?));
    Ok(scene.body(table.material(rough(1.0)?)).duration_s(duration_s).build()?)
}

fn place_at(k: f64, t: f64) -> Result<DVec3, Box<dyn Error>> {
    Ok(end_of(&turntable_ball(k, t)?)?.pose.translation)
}

/// Angle by which the velocity turns in a scene of one second or less than a turn, per second.
fn orbit_rate(scene: &Scene) -> Result<f64, Box<dyn Error>> {
    let velocity = end_of(scene)?.velocity.linear;
    let turned = (-velocity.x).atan2(velocity.y);
    Ok(turned.rem_euclid(std::f64::consts::TAU) / scene.duration_s())
}

/// Centre and radius of the circle through three points of a level plane.
fn circle_through(a: DVec3, b: DVec3, c: DVec3) -> (DVec3, f64) {
    let (u, v) = (b - a, c - a);
    let twice = 2.0 * (u.x * v.y - u.y * v.x);
    let x = (v.y * u.length_squared() - u.y * v.length_squared()) / twice;
    let y = (u.x * v.length_squared() - v.x * u.length_squared()) / twice;
    let offset = DVec3::new(x, y, 0.0);
    (a + offset, offset.length())
}

/// A slip that grows by less than this is rounding, m/s^2.
const SLIP_ACCELERATION: f64 = 1e-10;

/// What rolls down a slope.
#[derive(Debug, Clone, Copy)]
enum Round {
    Cylinder,
    Ball,
    Hoop,
}

impl Round {
    /// A body of 1 kg and this radius, its axis level.
    fn body(self, radius: f64) -> Result<Body, Box<dyn Error>> {
        match self {
            Self::Ball => sphere(radius),
            Self::Cylinder => cylinder("cylinder", radius, radius, 0.5),
            Self::Hoop => cylinder("hoop", radius, 0.4 * radius, 1.0),
        }
    }

    /// Sets it on a slope, at rest.
    fn on(self, plane: Plane, radius: f64, friction: f64, duration_s: f64) -> Result<Scene, Box<dyn Error>> {
        // The axis of a cylinder is its z; it lies along the level direction of the slope.
        let pose = Pose::new(Rotation::from_rotation_vector(DVec3::X * FRAC_PI_2), DVec3::Z * radius);
        let body = plane.place(self.body(radius)?, pose, Velocity::new(DVec3::ZERO, DVec3::ZERO));
        Ok(plane.with(body, friction)?.duration_s(duration_s).build()?)
    }
}

/// A cylinder of 1 kg whose moment about its axis is `k m r^2`.
fn cylinder(name: &str, radius: f64, height: f64, k: f64) -> Result<Body, Box<dyn Error>> {
    let across = 0.5 * k * radius * radius + height * height / 12.0;
    let moments = Inertia::from_diagonal(DVec3::new(across, across, k * radius * radius))?;
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, moments);
    Ok(Body::movable(name, properties).geometry(Shape::cylinder(radius, height)?.into()))
}

/// Round bodies roll down a slope, or slip where friction does not suffice.
pub(super) fn fc_11(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let plane = Plane::inclined(30.0f64.to_radians());
    let shapes = [Round::Cylinder, Round::Ball, Round::Hoop];
    let radius = 0.3;
    let mut accelerations = Vec::new();
    let mut thresholds = Vec::new();
    for shape in shapes {
        let end = end_of(&shape.on(plane, radius, 0.8, 1.0)?)?;
        accelerations.push(2.0 * plane.local(end.pose.translation).x);
        thresholds.push(threshold(0.6, 0.05, |friction| {
            let acceleration = first_acceleration(&shape.on(plane, radius, friction, 1.0)?)?;
            let rolls = plane.local(acceleration.linear).x - radius * plane.local(acceleration.angular).y;
            Ok(rolls.abs() < SLIP_ACCELERATION)
        })?);
    }
    let slipping = end_of(&Round::Ball.on(plane, radius, 0.1, 1.0)?)?;
    let measured = [plane.local(slipping.velocity.linear).x, radius * plane.local(slipping.velocity.angular).y];
    Ok(vec![
        reference.row("FC-11", "accelerations cyl, sphere, hoop", accelerations)?,
        reference.row("FC-11", "threshold mu", thresholds)?,
        reference.row("FC-11", "sphere with mu=0.1: a, R*alpha", measured)?,
    ])
}

/// A spool pulled by its string: force and its moment about the axis.
pub(super) fn fc_19(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let critical = zero([0.5, 1.4], |angle| Ok(first_acceleration(&spool(angle)?)?.linear.x))?;
    let run = end_of(&spool(0.0)?)?;
    Ok(vec![
        reference.row("FC-19", "critical angle (deg)", critical.to_degrees())?,
        reference.row(
            "FC-19",
            "I=mR^2/2, m=1, F=1 horizontal from below: a = F(1-r/R)/(m+I/R^2)",
            2.0 * run.pose.translation.x,
        )?,
    ])
}

/// A spool of radius 1 m and inner radius 0.5 m whose string pulls from below at this angle above the level, rad.
fn spool(angle: f64) -> Result<Scene, Box<dyn Error>> {
    let body = cylinder("spool", 1.0, 0.5, 0.5)?;
    let pose = Pose::new(Rotation::from_rotation_vector(DVec3::X * FRAC_PI_2), DVec3::Z);
    let body = Plane::LEVEL.place(body, pose, Velocity::new(DVec3::ZERO, DVec3::ZERO));
    // A pull at the bottom of the inner cylinder to the right turns the spool against rolling to the right.
    let force = Force::Applied {
        body: BodyId::new(0),
        force: DVec3::new(angle.cos(), 0.0, angle.sin()),
        torque: DVec3::Y * -0.5,
        frame: Frame::World,
        point: None,
        signal: Signal::ONE,
    };
    Ok(Plane::LEVEL.with(body, 0.8)?.force(force).duration_s(1.0).build()?)
}

/// SimBenchmark's rolling: 25 balls on a box that is pulled over the ground (published figures 1.1).
pub(super) fn simbenchmark_rolling(_: &Context) -> CaseResult {
    let case = "SimBenchmark rolling";
    let mut rows = Vec::new();
    for (name, direction) in [("y", DVec3::Y), ("xy", DVec3::new(0.5, 0.75f64.sqrt(), 0.0))] {
        rows.push(Row::at_most(
            case,
            &format!("force along {name}: mean squared velocity error in 4 s, m^2/s^2"),
            MEAN_SQUARE,
            rolling_error(direction)?,
        ));
    }
    Ok(rows)
}

/// Mean over steps of 1 ms of the squared velocity errors of the first ball and of the box.
fn rolling_error(direction: DVec3) -> Result<f64, Box<dyn Error>> {
    let (box_mass, ball_mass, count, pull) = (10.0, 1.0, 25.0, 150.0);
    let ground_force = 0.4 * (box_mass + count * ball_mass) * GRAVITY;
    let ball_force = (pull - ground_force) / box_mass / (3.5 / ball_mass + count / box_mass);
    let box_rate = (pull - ground_force - count * ball_force) / box_mass;
    let ball_rate = ball_force / ball_mass;
    let scene = rolling_scene(direction * pull)?;
    let mut simulation = Simulation::new(&scene)?;
    let mut sum = 0.0;
    let steps = 4000;
    for step in 1..=steps {
        let t = f64::from(step) * SAMPLE_S;
        simulation.advance_to(t)?;
        let bodies = simulation.bodies();
        let [carrier, ball, ..] = bodies.as_slice() else { return Err("no bodies".into()) };
        sum += (ball.velocity.linear - direction * (ball_rate * t)).length_squared();
        sum += (carrier.velocity.linear - direction * (box_rate * t)).length_squared();
    }
    Ok(sum / f64::from(steps))
}

/// The box with its balls on the ground, pulled by this force (N). All touch exactly.
fn rolling_scene(pull: DVec3) -> Result<Scene, Box<dyn Error>> {
    let material = |name: &str| polhode::scene::Material::new(name);
    let size = DVec3::new(20.0, 20.0, 1.0);
    let mut builder = Scene::builder("SimBenchmark rolling")
        .body(cuboid("box", size, 10.0, DVec3::Z * 0.5)?.material(material("box")))
        .duration_s(4.0);
    for i in 0..5 {
        for j in 0..5 {
            let center = DVec3::new(f64::from(2 * i - 4), f64::from(2 * j - 4), 1.5);
            let ball = Body::movable(format!("ball {i} {j}"), solid_sphere(0.5, Mass::new(1.0)?)?)
                .geometry(Shape::sphere(0.5)?.into())
                .pose(Pose::from_translation(center))
                .material(material("ball"));
            builder = builder.body(ball);
        }
    }
    let pair = |a: &str, b: &str, friction: f64| PairRule::new([a.to_owned(), b.to_owned()]).with_friction(friction);
    let force = Force::Applied {
        body: BodyId::new(0),
        force: pull,
        torque: DVec3::ZERO,
        frame: Frame::World,
        point: None,
        signal: Signal::ONE,
    };
    Ok(builder
        .body(half_space("ground", UnitVector::Z).material(material("ground")))
        .pair_rule(pair("ground", "box", 0.4)?)
        .pair_rule(pair("box", "ball", 0.8)?)
        .pair_rule(pair("ground", "ball", 0.5)?)
        .force(force)
        .build()?)
}
