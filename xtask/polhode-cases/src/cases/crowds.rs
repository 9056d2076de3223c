//! Stretches of crowded events: the instants of samples change nothing, samples do not overlap, bodies far away change
//! nothing, and the estimated error of the stretches holds.
//!
//! Random scenes: cones, cylinders and boxes thrown on a rough floor and on each other, as they roll, slide and come to
//! rest. Most of them crowd. The error of a run is its distance at the end from a run with a tolerance of such
//! stretches that is [`FINER`] times smaller. The lowest points of bodies are computed here from their dimensions, by
//! no code of the program.

use super::bodies::GRAVITY;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::contact::Shape;
use polhode::mesh::{Cone, Cylinder, Primitive, solid_box};
use polhode::scene::{Material, Method};
use polhode::spatial::{Mass, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodySample, ErrorEstimation, Observer, Outcome, ReportedBody, RunReport, Scene, Simulation};
use polhode_oracles::random::Random;
use std::error::Error;

/// Random scenes with `--full`.
const SCENES: usize = 200;

/// Fewest random scenes in a plain run.
const FEWEST: usize = 4;

/// How many times smaller the tolerance of the finer run is.
const FINER: f64 = 1e4;

/// Share of the scenes in which the estimate must hold.
const HOLDS: f64 = 0.95;

/// The estimate is nowhere this many times too small.
const TOO_SMALL: f64 = 10.0;

/// Errors below this are those of the located events and of rounding, m.
const SMALLEST_ERROR_M: f64 = 1e-9;

/// Tolerance of the stretches of the runs that are judged: the default.
const TOLERANCE: f64 = 1e-6;

/// Largest penetration in a sample of a run that is not degraded, of the size of a body: the promised limit at the
/// default tolerance, with the rounding of the coordinates.
const DEEPEST: f64 = 1e-11;

/// Largest penetration beyond what the certificate says, of the size of a body: rounding of the lowest points.
const UNTOLD: f64 = 1e-14;

/// Output interval of the scenes whose samples are measured, s: no multiple of a step.
const SAMPLES_S: f64 = 0.0037;

/// Output intervals with which a scene is run, s.
const INTERVALS_S: [f64; 3] = [0.0013, 0.01, 0.37];

/// Duration of a random scene, s.
const DURATION_S: f64 = 1.2;

/// A smooth cylinder that falls on a floor.
#[derive(Debug, Clone, Copy)]
struct SmoothCylinder {
    radius_m: f64,
    height_m: f64,
    restitution: f64,
    place_m: DVec3,
    /// Rotation vector, rad.
    turn: DVec3,
    /// m/s
    velocity: DVec3,
}

/// Two whose bounces accumulate all along their rims, so that they crowd.
const SMOOTH_CYLINDERS: [SmoothCylinder; 2] = [
    SmoothCylinder {
        radius_m: 0.12,
        height_m: 0.137,
        restitution: 0.4,
        place_m: DVec3::new(0.0, 0.0, 0.3),
        turn: DVec3::new(0.41, -0.83, -0.51),
        velocity: DVec3::new(-0.55, 0.92, -0.75),
    },
    SmoothCylinder {
        radius_m: 0.0973933,
        height_m: 0.178965,
        restitution: 0.3,
        place_m: DVec3::new(0.0082788, 0.0409704, 0.4),
        turn: DVec3::new(-0.9034271527463753, 0.6425485839826166, -0.8117399161206349),
        velocity: DVec3::new(-0.5706036383286766, -0.8281055326216566, -0.16365569725848106),
    },
];

/// Duration of a smooth scene, s.
const SMOOTH_DURATION_S: f64 = 0.9;

/// How far beside the axis of its ring a ball falls, m.
const BALL_OFFSETS_M: [f64; 2] = [0.02, 0.05];

/// Dimensions of a body, about its own origin.
#[derive(Debug, Clone, Copy)]
enum Solid {
    /// Half edges, m.
    Cuboid(DVec3),
    /// Radius and height along z, m; the origin is in the middle.
    Cylinder(f64, f64),
    /// Radius of the base and height along z, m; the base is a quarter of the height below the origin.
    Cone(f64, f64),
}

impl Solid {
    fn random(random: &mut Random) -> Self {
        let (width, length) = (random.between(0.1, 0.25), random.between(0.2, 0.6));
        match random.below(4) {
            0 => Self::Cuboid(DVec3::new(width, length, width + 0.1) * 0.5),
            1 => Self::Cylinder(width, length),
            _ => Self::Cone(width, length),
        }
    }

    fn body(self, name: String, mass: Mass) -> Result<Body, Box<dyn Error>> {
        let (properties, shape) = match self {
            Self::Cuboid(half) => (solid_box(half * 2.0, mass)?, Shape::cuboid(half * 2.0)?),
            Self::Cylinder(radius, height) => {
                (Primitive::Cylinder(Cylinder::new(radius, height)?).solid(mass)?, Shape::cylinder(radius, height)?)
            }
            Self::Cone(radius, height) => {
                (Primitive::Cone(Cone::new(radius, height)?).solid(mass)?, Shape::cone(radius, height)?)
            }
        };
        Ok(Body::movable(name, properties).geometry(shape.into()))
    }

    /// Height of its lowest point above the floor at a pose, m.
    fn lowest(self, pose: &Pose) -> f64 {
        let down = pose.rotation.inverse().rotate(-DVec3::Z);
        let across = down.x.hypot(down.y);
        let reach = match self {
            Self::Cuboid(half) => half.dot(down.abs()),
            Self::Cylinder(radius, height) => radius * across + 0.5 * height * down.z.abs(),
            Self::Cone(radius, height) => (radius * across - 0.25 * height * down.z).max(0.75 * height * down.z),
        };
        pose.translation.z - reach
    }
}

/// A random scene with what is in it.
struct Thrown {
    scene: Scene,
    solids: Vec<Solid>,
}

impl Thrown {
    /// The scene of this number, with friction.
    fn new(number: u64) -> Result<Self, Box<dyn Error>> {
        let mut random = Random(number);
        let friction = random.between(0.1, 1.0);
        let material =
            Material::new("rubber").with_friction(friction)?.with_restitution(random.one_of(&[0.0, 0.0, 0.3, 0.6]))?;
        let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into()).material(material.clone());
        let mut scene = Scene::builder("thrown").gravity(-DVec3::Z * GRAVITY).duration_s(DURATION_S).body(floor);
        let mut solids = Vec::new();
        for body in 0..random.one_of(&[1, 1, 1, 2, 3]) {
            let solid = Solid::random(&mut random);
            let place = random.vector(-0.05, 0.05).with_z(0.5 + 0.75 * f64::from(body));
            let velocity = Velocity::new(random.vector(-1.0, 1.0), random.vector(-3.0, 3.0));
            let thrown = solid.body(format!("thrown {body}"), Mass::new(random.between(0.5, 2.0))?)?;
            scene = scene
                .body(thrown.pose(Pose::new(random.rotation(), place)).velocity(velocity).material(material.clone()));
            solids.push(solid);
        }
        Ok(Self { scene: scene.build()?, solids })
    }
}

/// The largest penetration of the floor in any sample, m, by the dimensions of the bodies alone.
struct Penetration<'a> {
    solids: &'a [Solid],
    deepest_m: f64,
}

impl Observer for Penetration<'_> {
    fn sample(&mut self, _t: f64, bodies: &[BodySample]) {
        for (solid, sample) in self.solids.iter().zip(&bodies[1..]) {
            self.deepest_m = self.deepest_m.max(-solid.lowest(&sample.pose));
        }
    }
}

/// What a run of a scene gives, whose error is not estimated.
fn run(scene: &Scene, observer: &mut dyn Observer) -> Result<RunReport, Box<dyn Error>> {
    Ok(Simulation::new(scene)?.estimating(ErrorEstimation::Off).run_observed(observer)?)
}

/// Every shipped scene that crowds, and some random ones, with several output intervals: the last states are the same.
pub(super) fn intervals(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    let mut scenes = Vec::new();
    for name in context.shipped.names()? {
        let run = context.shipped.run(&name)?;
        if !run.report.crowded.is_empty() {
            scenes.push((name, run.scene.clone()));
        }
    }
    for number in 0..FEWEST as u64 {
        scenes.push((format!("random scene {number}"), Thrown::new(number)?.scene));
    }
    for (name, scene) in scenes {
        let mut ends = Vec::new();
        for interval_s in INTERVALS_S {
            let scene = scene.clone().with_output_interval(interval_s)?;
            ends.push(format!("{:?}", run(&scene, &mut Sampled)?.bodies));
        }
        let others = ends.iter().filter(|&end| *end != ends[0]).count();
        rows.push(Row::exact(
            "crowds: output intervals",
            &format!("{name}: output intervals with which it ends with other bits"),
            0,
            others as u64,
        ));
    }
    Ok(rows)
}

/// Smooth scenes with and without a rough box that stands a kilometre away: the bits of the others are the same. The
/// cylinders crowd; a ball that falls into a ring moves in a plane.
pub(super) fn far_friction(_context: &Context) -> CaseResult {
    let (mut crowded, mut others) = (0_u64, 0_u64);
    for cylinder in SMOOTH_CYLINDERS {
        let alone = run(&cylinder.scene(Vec::new())?, &mut polhode::Unobserved)?;
        let beside = run(&cylinder.scene(far_pair()?)?, &mut polhode::Unobserved)?;
        crowded += u64::from(!alone.crowded.is_empty());
        others += u64::from(are_others(&alone, &beside));
    }
    let mut others_in_a_plane = 0_u64;
    for offset in BALL_OFFSETS_M {
        let alone = run(&ball_into_ring(offset, Vec::new())?, &mut polhode::Unobserved)?;
        let beside = run(&ball_into_ring(offset, far_pair()?)?, &mut polhode::Unobserved)?;
        others_in_a_plane += u64::from(are_others(&alone, &beside));
    }
    let case = "crowds: friction far away";
    Ok(vec![
        Row::exact(case, "cylinders that end with other bits beside a rough box a kilometre away", 0, others),
        Row::exact(case, "cylinders that crowd", SMOOTH_CYLINDERS.len() as u64, crowded),
        Row::exact(case, "motions in a plane that end with other bits beside it", 0, others_in_a_plane),
    ])
}

/// Whether the bodies of a run end with other bits than the same bodies of another one with more bodies.
fn are_others(alone: &RunReport, beside: &RunReport) -> bool {
    format!("{:?}", alone.bodies) != format!("{:?}", &beside.bodies[..alone.bodies.len()])
}

impl SmoothCylinder {
    /// It and its floor, with some more bodies.
    fn scene(self, far: Vec<Body>) -> Result<Scene, Box<dyn Error>> {
        let material = Material::new("ice").with_restitution(self.restitution)?;
        let pose = Pose::new(Rotation::from_rotation_vector(self.turn), self.place_m);
        let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into()).material(material.clone());
        let cylinder = Solid::Cylinder(self.radius_m, self.height_m).body("cylinder".to_owned(), Mass::new(1.0)?)?;
        let cylinder = cylinder.pose(pose).velocity(Velocity::new(self.velocity, DVec3::ZERO)).material(material);
        let scene = Scene::builder("cylinder").gravity(-DVec3::Z * GRAVITY).duration_s(SMOOTH_DURATION_S);
        let bodies = [floor, cylinder].into_iter().chain(far);
        Ok(bodies.fold(scene, polhode::SceneBuilder::body).build()?)
    }
}

/// A smooth ball that falls into a ring, beside its axis by `offset` (m), with some more bodies.
fn ball_into_ring(offset: f64, far: Vec<Body>) -> Result<Scene, Box<dyn Error>> {
    let material = Material::new("ice").with_restitution(0.5)?;
    let ring = Body::fixed("ring").geometry(Shape::torus(0.5, 0.1)?.into()).material(material.clone());
    let ball = Body::movable("ball", polhode::mesh::solid_sphere(0.5, Mass::new(1.0)?)?);
    let ball = ball.geometry(Shape::sphere(0.5)?.into()).pose(Pose::from_translation(DVec3::new(offset, 0.0, 1.0)));
    let scene = Scene::builder("ring").gravity(-DVec3::Z * GRAVITY).duration_s(SMOOTH_DURATION_S);
    let bodies = [ring, ball.material(material)].into_iter().chain(far);
    Ok(bodies.fold(scene, polhode::SceneBuilder::body).build()?)
}

/// A rough slab and a box on it, a kilometre away from the origin. They may touch nothing else.
fn far_pair() -> Result<Vec<Body>, Box<dyn Error>> {
    let rough = Material::new("sandpaper").with_friction(0.8)?;
    let at = |height: f64| Pose::from_translation(DVec3::new(1000.0, 0.0, height));
    let slab = Body::fixed("far slab").geometry(Shape::cuboid(DVec3::new(2.0, 2.0, 0.5))?.into()).pose(at(5.0));
    let brick = Body::movable("far brick", solid_box(DVec3::splat(0.5), Mass::new(1.0)?)?);
    let brick = brick.geometry(Shape::cuboid(DVec3::splat(0.5))?.into()).pose(at(5.5));
    Ok(vec![slab.material(rough.clone()), brick.material(rough)])
}

/// Takes samples and does nothing with them.
struct Sampled;

impl Observer for Sampled {
    fn sample(&mut self, _t: f64, _bodies: &[BodySample]) {}
}

/// Samples of random scenes: no body is below the floor by more than the certificate says.
pub(super) fn samples(context: &Context) -> CaseResult {
    let count = context.amount.of(SCENES).max(FEWEST);
    let (mut deepest, mut untold) = (0.0_f64, 0.0_f64);
    for number in 0..count as u64 {
        let Thrown { scene, solids } = Thrown::new(number)?;
        let scene = scene.with_output_interval(SAMPLES_S)?;
        let mut seen = Penetration { solids: &solids, deepest_m: 0.0 };
        let report = run(&scene, &mut seen)?;
        let size = solids.iter().map(|solid| -solid.lowest(&Pose::IDENTITY)).fold(f64::INFINITY, f64::min);
        if report.outcome != Outcome::Degraded {
            deepest = deepest.max(seen.deepest_m / size);
        }
        untold = untold.max((seen.deepest_m - report.certificate.max_penetration_m) / size);
    }
    let case = "crowds: samples";
    Ok(vec![
        Row::at_most(
            case,
            "penetration of the floor in a sample of a run that is not degraded, of a size",
            DEEPEST,
            deepest,
        ),
        Row::at_most(
            case,
            "penetration of the floor in a sample beyond that of the certificate, of a size",
            UNTOLD,
            untold,
        ),
    ])
}

/// The estimated error of random scenes with stretches, by whole runs beside them, against a finer run.
pub(super) fn estimates(context: &Context) -> CaseResult {
    let count = context.amount.of(SCENES).max(FEWEST);
    let (mut crowded, mut held, mut worst, mut unknown) = (0_u64, 0_u64, 0.0_f64, 0_u64);
    let mut number = 0;
    while crowded < count as u64 {
        let scene = Thrown::new(number)?.scene;
        number += 1;
        let report = Simulation::new(&scene)?.estimating(ErrorEstimation::Full).run()?;
        if report.crowded.is_empty() {
            continue;
        }
        crowded += 1;
        if report.error.bodies.is_empty() {
            unknown += 1;
            continue;
        }
        let ratio = ratio(&scene, &report)?;
        held += u64::from(ratio <= 1.0);
        worst = worst.max(ratio);
    }
    let case = "crowds: estimated error";
    let share = held as f64 / crowded as f64;
    Ok(vec![
        Row::exact(case, "scenes whose error is not known", 0, unknown),
        Row::at_most(case, "share of the scenes whose error exceeds the estimate", 1.0 - HOLDS, 1.0 - share),
        Row::at_most(case, "largest error, in estimates", TOO_SMALL, worst),
    ])
}

/// The error of a run, in estimates of it.
fn ratio(scene: &Scene, report: &RunReport) -> Result<f64, Box<dyn Error>> {
    let method = Method { crowding_tolerance: Some(TOLERANCE / FINER), ..scene.method().clone() };
    let finer = run(&scene.clone().with_method(method), &mut polhode::Unobserved)?;
    let error_m = |(own, finer): (&ReportedBody, &ReportedBody)| {
        (own.state.pose.translation - finer.state.pose.translation).length()
    };
    let error = report.bodies.iter().zip(&finer.bodies).map(error_m).fold(0.0, f64::max);
    let estimate = report.error.bodies.iter().map(|error| error.position_m).fold(SMALLEST_ERROR_M, f64::max);
    Ok(error / estimate)
}
