//! Ten thousand free bodies: polhode beside rapier3d-f64, in one run.
//! `cargo bench --manifest-path peers/Cargo.toml --bench free_bodies`.
//!
//! | name | what one step of 1/60 s is |
//! |---|---|
//! | `rapier3d-f64` | a step of its pipeline: no colliders, no sleep, gyroscopic forces, 4 substeps (its default) |
//! | `rapier3d-f64, one substep` | the same with one substep: faster, and less accurate |
//! | `simulation` | a step of a whole [`Simulation`], ledger and all, that ends in a sample of all bodies |
//! | `flight records` | all states from the records of their flights |
//! | `exact drift, chained` | attitudes by the exact rotation from step to step, centres of mass by its formula |
//!
//! Times are per step. Before them errors after one second are printed: angle of the attitude and place of the centre
//! of mass, largest over all bodies, against the exact flight; that itself against DOP853 at a step of 1/240 s.

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use polhode::dynamics::exact_rotation::drift;
use polhode::dynamics::{BodyState, Dop853, Flight, FreeMotion};
use polhode::scene::{DEFAULT_GRAVITY, Method};
use polhode::spatial::{DVec3, Pose};
use polhode::{Body, BodySample, Observer, Scene, Simulation};
use rapier3d::prelude::{PhysicsWorld, RigidBodyBuilder, RigidBodyHandle};
use std::hint::black_box;
use std::time::{Duration, Instant};

#[path = "support/tumbling_bodies.rs"]
mod tumbling_bodies;

use tumbling_bodies::{TumblingBody, tumbling_bodies};

/// Steps of one run.
const STEPS: u32 = 60;
/// Simulated time of one run, s.
const DURATION_S: f64 = 1.0;
/// Step, s.
const STEP_S: f64 = DURATION_S / STEPS as f64;
/// Steps of DOP853 over one run: at most 0.025 rad each, where its error is below round-off.
const REFERENCE_STEPS: u32 = 240;
/// One body of so many is integrated so.
const REFERENCE_STRIDE: usize = 10;

/// Poses after one run, and the time that its steps took.
type Run = (Vec<Pose>, Duration);

/// Substeps of rapier's step: its default, and the fewest.
const SUBSTEPS: [usize; 2] = [4, 1];

/// Rapier from the start for one second, in steps of so many substeps.
fn rapier(bodies: &[TumblingBody], substeps: usize) -> Run {
    let mut world = PhysicsWorld { gravity: DEFAULT_GRAVITY, ..PhysicsWorld::default() };
    world.integration_parameters.dt = STEP_S;
    world.integration_parameters.num_solver_iterations = substeps;
    let handles: Vec<RigidBodyHandle> = bodies
        .iter()
        .map(|body| {
            let properties = rapier3d::prelude::MassProperties::new(DVec3::ZERO, body.mass, body.moments);
            let pose = rapier3d::math::Pose::from_parts(body.pose.translation, body.pose.rotation.quaternion());
            let builder = RigidBodyBuilder::dynamic()
                .additional_mass_properties(properties)
                .pose(pose)
                .linvel(body.velocity.linear)
                .angvel(body.velocity.angular)
                .gyroscopic_forces_enabled(true)
                .can_sleep(false);
            world.bodies.insert(builder)
        })
        .collect();
    let begin = Instant::now();
    for _ in 0..STEPS {
        world.step();
    }
    let elapsed = begin.elapsed();
    let poses = handles.iter().map(|&handle| {
        let pose = world.bodies[handle].position();
        Pose::new(polhode::spatial::Rotation::renormalized(pose.rotation), pose.translation)
    });
    (poses.collect(), elapsed)
}

/// Keeps the newest sample.
#[derive(Default)]
struct Newest {
    bodies: Vec<BodySample>,
}

impl Observer for Newest {
    fn sample(&mut self, _t: f64, bodies: &[BodySample]) {
        self.bodies.clear();
        self.bodies.extend_from_slice(bodies);
    }
}

/// The scene of all bodies.
fn scene(bodies: &[TumblingBody]) -> Option<Scene> {
    let method = Method { step_s: Some(STEP_S), ..Method::default() };
    let builder = Scene::builder("free bodies").method(method).duration_s(DURATION_S).output_interval_s(STEP_S);
    let builder = bodies.iter().enumerate().fold(builder, |builder, (k, body)| {
        builder.body(Body::movable(k.to_string(), body.properties).pose(body.pose).velocity(body.velocity))
    });
    builder.build().ok()
}

/// The facade from the start for one second, its report at the end included.
fn simulation(scene: &Scene) -> Run {
    let mut newest = Newest::default();
    let Ok(mut simulation) = Simulation::new(scene) else { return Run::default() };
    let begin = Instant::now();
    let report = black_box(simulation.run_observed(&mut newest));
    let elapsed = begin.elapsed();
    drop(report);
    (newest.bodies.iter().map(|body| body.pose).collect(), elapsed)
}

/// One second from records of flights.
fn flight_records(flights: &[Flight]) -> Run {
    let mut states = vec![BodyState::default(); flights.len()];
    let begin = Instant::now();
    for step in 1..=STEPS {
        let t = f64::from(step) * STEP_S;
        for (state, flight) in states.iter_mut().zip(flights) {
            *state = flight.state(t);
        }
        black_box(&mut states);
    }
    (states.iter().map(|state| state.pose).collect(), begin.elapsed())
}

/// One second by the exact rotation from step to step.
fn chained_drift(bodies: &[TumblingBody]) -> Run {
    // The moments are along the axes of the body, so that its attitude is that of the principal axes.
    let mut states: Vec<(DVec3, BodyState)> = bodies.iter().map(|body| (body.moments, body.state())).collect();
    let begin = Instant::now();
    for _ in 0..STEPS {
        for (moments, state) in &mut states {
            state.pose.rotation = drift(*moments, state.pose.rotation, state.angular_momentum, STEP_S);
            state.pose.translation += (state.linear_velocity + DEFAULT_GRAVITY * (0.5 * STEP_S)) * STEP_S;
            state.linear_velocity += DEFAULT_GRAVITY * STEP_S;
        }
        black_box(&mut states);
    }
    (states.iter().map(|(_, state)| state.pose).collect(), begin.elapsed())
}

/// Poses after one second by numerical integration, of every so-many-th body.
fn integrated(bodies: &[TumblingBody]) -> Vec<Pose> {
    let h = DURATION_S / f64::from(REFERENCE_STEPS);
    let end_of = |body: &TumblingBody| {
        let rigid = [body.rigid_body()];
        let mut motion = FreeMotion::new(&rigid, DEFAULT_GRAVITY, &[]);
        let mut state = body.state().to_array();
        let mut method = Dop853::new(state.len());
        for step in 0..REFERENCE_STEPS {
            method.attempt(&mut motion, f64::from(step) * h, &state, h, &[1.0; 13]).ok()?;
            state.copy_from_slice(method.end_state());
        }
        Some(BodyState::from_array(&state).pose)
    };
    bodies.iter().step_by(REFERENCE_STRIDE).filter_map(end_of).collect()
}

/// Prints the largest errors of poses against others.
fn print_errors(name: &str, poses: &[Pose], exact: &[Pose]) {
    let (mut angle, mut distance) = (0.0f64, 0.0f64);
    for (pose, exact) in poses.iter().zip(exact) {
        angle = angle.max(pose.rotation.angle_to(exact.rotation));
        distance = distance.max((pose.translation - exact.translation).length());
    }
    println!("{name:>32}: attitude {angle:.1e} rad, centre of mass {distance:.1e} m ({} bodies)", poses.len());
}

/// Reports the time of one step of what takes [`STEPS`] of them.
fn bench_steps(group: &mut BenchmarkGroup<'_, WallTime>, name: &str, mut run: impl FnMut() -> Run) {
    group.bench_function(name, |bencher| {
        bencher.iter_custom(|steps| {
            let runs = steps.div_ceil(u64::from(STEPS));
            let elapsed: Duration = (0..runs).map(|_| run().1).sum();
            elapsed.mul_f64(steps as f64 / (runs * u64::from(STEPS)) as f64)
        });
    });
}

fn free_bodies(criterion: &mut Criterion) {
    let bodies = tumbling_bodies();
    let Some(scene) = scene(&bodies) else { return };
    let flights: Vec<Flight> =
        bodies.iter().map(|body| Flight::new(&body.rigid_body(), 0.0, &body.state(), DEFAULT_GRAVITY)).collect();

    let exact = flight_records(&flights).0;
    println!("Errors after {DURATION_S} s:");
    print_errors("rapier3d-f64", &rapier(&bodies, SUBSTEPS[0]).0, &exact);
    print_errors("rapier3d-f64, one substep", &rapier(&bodies, SUBSTEPS[1]).0, &exact);
    print_errors("simulation", &simulation(&scene).0, &exact);
    print_errors("exact drift, chained", &chained_drift(&bodies).0, &exact);
    let every: Vec<Pose> = exact.iter().copied().step_by(REFERENCE_STRIDE).collect();
    print_errors("flight records (against DOP853)", &every, &integrated(&bodies));

    let mut group = criterion.benchmark_group(format!("a step of {} free bodies", bodies.len()));
    bench_steps(&mut group, "rapier3d-f64", || rapier(&bodies, SUBSTEPS[0]));
    bench_steps(&mut group, "rapier3d-f64, one substep", || rapier(&bodies, SUBSTEPS[1]));
    bench_steps(&mut group, "simulation", || simulation(&scene));
    bench_steps(&mut group, "flight records", || flight_records(&flights));
    bench_steps(&mut group, "exact drift, chained", || chained_drift(&bodies));
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10);
    targets = free_bodies
}
criterion_main!(benches);
