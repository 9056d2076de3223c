//! A step of ten thousand free bodies, polhode beside rapier3d-f64 in one run, one after the other in turns:
//! `cargo bench --manifest-path peers/Cargo.toml --bench step`.
//!
//! Both step by 1/60 s for one second, from the same start and under gravity; every body is asymmetric and tumbles.
//! Printed are the least and the median time of a step over [`ROUNDS`] turns, and the ratios to rapier with one
//! substep.
//!
//! | name | what one step is |
//! |---|---|
//! | `rapier3d-f64, one substep` | a step of its pipeline; nothing sleeps, gyroscopic forces on |
//! | `... and all poses` | the same, then every pose is read |
//! | `advance_to` | [`Simulation::advance_to`] the end of the step, nobody watches |
//! | `advance_to, body of each` | the same, then [`Simulation::body`] of every body |
//! | `advance_to, bodies` | the same, then [`Simulation::bodies`] |
//! | `run, a sample a step` | a whole run with a sample at every step, ledger, report and all |
//!
//! `points` have no shape and so nothing to collide with; `balls` stand far enough apart never to meet, so that the
//! broad phase of both works for nothing.

use polhode::contact::Shape;
use polhode::scene::{DEFAULT_GRAVITY, Method};
use polhode::spatial::{DVec3, Pose, Velocity};
use polhode::{Body, BodyId, BodySample, Geometry, Observer, Scene, Simulation};
use rapier3d::prelude::{ColliderBuilder, PhysicsWorld, RigidBodyBuilder};
use std::hint::black_box;
use std::time::Instant;

#[path = "support/tumbling_bodies.rs"]
mod tumbling_bodies;

use tumbling_bodies::{TumblingBody, tumbling_bodies};

/// Steps of one run.
const STEPS: u32 = 60;
/// Step, s.
const STEP_S: f64 = 1.0 / 60.0;
/// Turns.
const ROUNDS: usize = 15;
/// Radius of the balls, m, their distances along each axis at the start, m, and how many stand in a row.
const RADIUS: f64 = 0.5;
const DISTANCE: f64 = 4.0;
const ROW: usize = 22;
/// Part of the speed of points that balls have: they then stay apart for a second.
const SLOWER: f64 = 0.25;

/// What bodies are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Points,
    Balls,
}

/// The bodies where they start.
fn bodies(kind: Kind) -> Vec<TumblingBody> {
    let place = |k: usize| DVec3::new((k % ROW) as f64, (k / ROW % ROW) as f64, (k / ROW / ROW) as f64) * DISTANCE;
    let placed = |(k, body): (usize, TumblingBody)| TumblingBody {
        pose: Pose::new(body.pose.rotation, place(k)),
        velocity: Velocity::new(body.velocity.linear * SLOWER, body.velocity.angular),
        ..body
    };
    match kind {
        Kind::Points => tumbling_bodies(),
        Kind::Balls => tumbling_bodies().into_iter().enumerate().map(placed).collect(),
    }
}

/// Time of a step of rapier with one substep, s; then each pose is read.
fn rapier(bodies: &[TumblingBody], kind: Kind) -> [f64; 2] {
    let mut world = PhysicsWorld { gravity: DEFAULT_GRAVITY, ..PhysicsWorld::default() };
    world.integration_parameters.dt = STEP_S;
    world.integration_parameters.num_solver_iterations = 1;
    let mut handles = Vec::with_capacity(bodies.len());
    for body in bodies {
        let properties = rapier3d::prelude::MassProperties::new(DVec3::ZERO, body.mass, body.moments);
        let builder = RigidBodyBuilder::dynamic()
            .additional_mass_properties(properties)
            .pose(rapier3d::math::Pose::from_parts(body.pose.translation, body.pose.rotation.quaternion()))
            .linvel(body.velocity.linear)
            .angvel(body.velocity.angular)
            .gyroscopic_forces_enabled(true)
            .can_sleep(false);
        handles.push(match kind {
            Kind::Points => world.bodies.insert(builder),
            Kind::Balls => world.insert(builder, ColliderBuilder::ball(RADIUS).density(0.0)).0,
        });
    }
    let (mut stepping, mut reading) = (0.0, 0.0);
    for _ in 0..STEPS {
        let begin = Instant::now();
        world.step();
        let stepped = Instant::now();
        for &handle in &handles {
            black_box(world.bodies[handle].position());
        }
        stepping += (stepped - begin).as_secs_f64();
        reading += stepped.elapsed().as_secs_f64();
    }
    [stepping, stepping + reading].map(|time| time / f64::from(STEPS))
}

/// The scene of all bodies.
fn scene(bodies: &[TumblingBody], kind: Kind) -> Option<Scene> {
    let method = Method { step_s: Some(STEP_S), ..Method::default() };
    let mut builder = Scene::builder("free bodies").method(method).duration_s(1.0).output_interval_s(STEP_S);
    for (k, body) in bodies.iter().enumerate() {
        let own = Body::movable(k.to_string(), body.properties).pose(body.pose).velocity(body.velocity);
        builder = builder.body(match kind {
            Kind::Points => own,
            Kind::Balls => own.geometry(Geometry::Shape(Shape::sphere(RADIUS).ok()?)),
        });
    }
    builder.build().ok()
}

/// What is read after a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Reading {
    Nothing,
    Each,
    All,
}

/// Time of a step by `advance_to`, s.
fn advance(scene: &Scene, reading: Reading) -> Option<f64> {
    let mut simulation = Simulation::new(scene).ok()?;
    let ids: Vec<BodyId> = scene.bodies().iter().filter_map(|body| simulation.body_id(body.name())).collect();
    let mut time = 0.0;
    for step in 1..=STEPS {
        let begin = Instant::now();
        simulation.advance_to(f64::from(step) * STEP_S).ok()?;
        match reading {
            Reading::Nothing => {}
            Reading::Each => ids.iter().for_each(|&id| {
                black_box(simulation.body(id));
            }),
            Reading::All => {
                black_box(simulation.bodies());
            }
        }
        time += begin.elapsed().as_secs_f64();
    }
    Some(time / f64::from(STEPS))
}

/// Looks at nothing, but asks for samples.
struct Looker;

impl Observer for Looker {
    fn sample(&mut self, _t: f64, bodies: &[BodySample]) {
        black_box(bodies);
    }
}

/// Time of a step of a run with samples, s.
fn run(scene: &Scene) -> Option<f64> {
    let mut simulation = Simulation::new(scene).ok()?;
    let begin = Instant::now();
    black_box(simulation.run_observed(&mut Looker).ok()?);
    Some(begin.elapsed().as_secs_f64() / f64::from(STEPS))
}

/// The times of one turn, in the order of [`NAMES`].
fn turn(bodies: &[TumblingBody], kind: Kind, scene: &Scene) -> Option<[f64; NAMES.len()]> {
    let [stepping, with_poses] = rapier(bodies, kind);
    let [nothing, each, all] = [Reading::Nothing, Reading::Each, Reading::All].map(|reading| advance(scene, reading));
    Some([stepping, with_poses, nothing?, each?, all?, run(scene)?])
}

const NAMES: [&str; 6] = [
    "rapier3d-f64, one substep",
    "... and all poses",
    "advance_to",
    "advance_to, body of each",
    "advance_to, bodies",
    "run, a sample a step",
];

fn main() {
    for kind in [Kind::Points, Kind::Balls] {
        let bodies = bodies(kind);
        let Some(scene) = scene(&bodies, kind) else { return };
        let turns: Vec<_> = (0..ROUNDS).filter_map(|_| turn(&bodies, kind, &scene)).collect();
        println!("{} {kind:?}, a step of 1/60 s, {} turns: least, median (ms); ratios", bodies.len(), turns.len());
        let column = |k: usize| {
            let mut times: Vec<f64> = turns.iter().map(|turn| turn[k] * 1e3).collect();
            times.sort_by(f64::total_cmp);
            [0, times.len() / 2].map(|place| times.get(place).copied().unwrap_or(f64::NAN))
        };
        let peer = column(0);
        for (k, name) in NAMES.iter().enumerate() {
            let [least, median] = column(k);
            println!("{name:>28}: {least:8.3} {median:8.3}   {:6.2} {:6.2}", least / peer[0], median / peer[1]);
        }
    }
}
