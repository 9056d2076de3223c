//! Islands on several threads: the whole state of a run, accounts and warm starts with it, has the same bits for any
//! number of threads, and for an executor that runs tasks in another order. Islands share a floor and a moving
//! platform.

use crate::stepped::stepped;
use crate::support::{ball, brick, floor};
use polhode::contact::Shape;
use polhode::scene::{Material, PrescribedMotion};
use polhode::spatial::{DVec3, Pose, Rotation, SplitMix64};
use polhode::{Body, Executor, Geometry, OneThread, Scene, Simulation, Task};
use std::num::NonZeroUsize;
use std::sync::Arc;

/// Seven heaps of tumbling boxes and balls, three of them on a platform that shakes.
fn heaps() -> Scene {
    let mut random = SplitMix64::new(7);
    let mut number = |from: f64, to: f64| from + (to - from) * random.uniform();
    let rough = Material::new("rough").with_friction(0.4).unwrap().with_restitution(0.3).unwrap();
    let motion = PrescribedMotion::sine(DVec3::new(0.02, 0.0, 0.02), DVec3::ZERO, 3.0, 0.0).unwrap();
    let platform = Body::kinematic("platform", motion)
        .geometry(Geometry::Shape(Shape::cuboid(DVec3::new(20.0, 2.0, 0.2)).unwrap()))
        .material(rough.clone())
        .pose(Pose::from_translation(DVec3::new(10.0, 5.0, 0.2)));
    let floor = floor().material(rough.clone());
    let mut builder = Scene::builder("heaps").method(stepped(5e-3)).duration_s(0.4).body(floor).body(platform);
    for heap in 0..7 {
        let base = DVec3::new(3.0 * f64::from(heap), if heap % 2 == 0 { 0.0 } else { 5.0 }, 0.6);
        for level in 0..3 {
            let place = base + DVec3::new(number(-0.1, 0.1), number(-0.1, 0.1), 0.35 * f64::from(level));
            let name = format!("{heap}-{level}");
            let tilt = Rotation::from_rotation_vector(DVec3::new(number(-0.5, 0.5), number(-0.5, 0.5), 0.0));
            let body = match level {
                1 => ball(&name, 1.0, 0.12, place, DVec3::ZERO),
                _ => brick(&name, DVec3::new(0.3, 0.25, 0.2), place).pose(Pose::new(tilt, place)),
            };
            builder = builder.body(body.material(rough.clone()));
        }
    }
    builder.build().unwrap()
}

fn run_all<'a>(tasks: impl Iterator<Item = Task<'a>>) {
    for task in tasks {
        task();
    }
}

/// So many threads, each of which takes every n-th task, n being their number.
#[derive(Debug)]
struct Threads(usize);

impl Executor for Threads {
    fn width(&self) -> NonZeroUsize {
        NonZeroUsize::new(self.0).unwrap()
    }

    fn run(&self, tasks: Vec<Task<'_>>) {
        let mut shares: Vec<Vec<Task<'_>>> = (0..self.0).map(|_| Vec::new()).collect();
        tasks.into_iter().enumerate().for_each(|(place, task)| shares[place % self.0].push(task));
        std::thread::scope(|scope| {
            for share in shares {
                scope.spawn(|| run_all(share.into_iter()));
            }
        });
    }
}

/// Runs tasks backwards.
#[derive(Debug)]
struct Backwards;

impl Executor for Backwards {
    fn width(&self) -> NonZeroUsize {
        NonZeroUsize::new(5).unwrap()
    }

    fn run(&self, tasks: Vec<Task<'_>>) {
        run_all(tasks.into_iter().rev());
    }
}

fn end_by(scene: &Scene, executor: Arc<dyn Executor>) -> (Vec<u8>, String) {
    let mut simulation = Simulation::new(scene).unwrap();
    simulation.set_executor(executor);
    let report = simulation.run().unwrap();
    (simulation.snapshot().to_bytes(), format!("{:?} {:?}", report.ledger, report.certificate))
}

/// Checks that the whole state of a scene's end, accounts with it, has the same bits with two, three and eight threads,
/// and backwards, as with one.
#[track_caller]
pub(crate) fn check_threads(scene: &Scene) {
    let one = end_by(scene, Arc::new(OneThread));
    for number in [2, 3, 8] {
        assert!(end_by(scene, Arc::new(Threads(number))) == one, "{number} threads");
    }
    assert!(end_by(scene, Arc::new(Backwards)) == one);
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    check_threads(&heaps());
}
