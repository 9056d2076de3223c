//! Piles with friction in time steps, solved in the velocities of bodies.
//!
//! From some fifty contacts in a group on, a time step forms no matrix of all its contacts, and starts from the forces
//! of the step before. Shown is that this is the same mechanics: what stands, stands; what slides as one, slides as
//! mechanics says; momentum is accounted for; neither the order of bodies nor an interruption changes the motion.

use crate::checks::assert_closes;
use crate::snapshots::check_restored_runs;
use crate::stepped::stepped;
use crate::support::{brick, floor};
use polhode::scene::Material;
use polhode::spatial::{DVec3, Velocity};
use polhode::{Body, Effects, Recorder, RunReport, Scene, SceneBuilder, Simulation};

const G: f64 = 9.81;
const STEP_S: f64 = 1.0 / 60.0;
const FRICTION: f64 = 0.5;
/// Friction of a smoother floor, and of cubes on it, `sqrt(0.5 * 0.08)`: a pyramid slides there as one. On a floor as
/// rough as the cubes all its contacts would be at the limit of sticking, where a residual of 1e-6 leaves slips of its
/// root.
const SMOOTHER: f64 = 0.08;
const SLIDING_FRICTION: f64 = 0.2;
/// Edge of a cube, m, and the distance of those beside each other.
const EDGE: f64 = 0.4;
const APART: f64 = 0.44;

/// What steps may leave of a way of some decimetres, m.
const LEFT_M: f64 = 1e-8;

/// Cubes of 1 kg, `rows` of them on the floor, one fewer in each row above.
fn pyramid(rows: usize) -> Vec<Body> {
    let mut cubes = Vec::new();
    for row in 0..rows {
        for column in 0..rows - row {
            let x = (column as f64 + 0.5 * row as f64) * APART;
            let place = DVec3::new(x, 0.0, EDGE * (row as f64 + 0.5));
            cubes.push(brick(&format!("cube {}", cubes.len()), DVec3::splat(EDGE), place));
        }
    }
    cubes
}

/// On a floor, everything with the same friction.
fn on_a_floor(cubes: Vec<Body>, duration_s: f64) -> SceneBuilder {
    on_a_floor_of(FRICTION, cubes, duration_s)
}

/// On a floor of this friction, with which that of the cubes is combined to the geometric mean.
fn on_a_floor_of(friction: f64, cubes: Vec<Body>, duration_s: f64) -> SceneBuilder {
    let rough = Material::new("rough").with_friction(FRICTION).unwrap();
    let scene = Scene::builder("pile").duration_s(duration_s).output_interval_s(STEP_S);
    let scene = scene.body(floor().material(Material::new("floor").with_friction(friction).unwrap()));
    cubes.into_iter().fold(scene, |scene, cube| scene.body(cube.material(rough.clone())))
}

/// A pyramid one of whose cubes is thrown out of it.
fn hit(rows: usize) -> Vec<Body> {
    let mut cubes = pyramid(rows);
    let thrown = cubes[rows].clone().velocity(Velocity::new(DVec3::new(0.3, 1.0, 0.0), DVec3::ZERO));
    cubes[rows] = thrown;
    cubes
}

/// A run in which contacts of many are solved for.
fn run(scene: &SceneBuilder) -> (RunReport, Recorder) {
    let (report, recorder) = run_any(scene);
    assert!(report.certificate.factorisations > 0, "no group is large: {:?}", report.certificate);
    (report, recorder)
}

fn run_any(scene: &SceneBuilder) -> (RunReport, Recorder) {
    let scene = scene.clone().method(stepped(STEP_S)).build().unwrap();
    let mut recorder = Recorder::default();
    let report = Simulation::new(&scene).unwrap().run_observed(&mut recorder).unwrap();
    assert_closes(&report);
    (report, recorder)
}

/// 21 cubes stand for a second of 60 steps, to the last bit: forces that hold them are found at the start, so that no
/// step solves for any.
#[test]
fn a_pyramid_stands_exactly() {
    let (report, recorder) = run_any(&on_a_floor(pyramid(6), 1.0));
    assert!(recorder.samples.iter().all(|sample| *sample == recorder.samples[0]));
    assert!(report.certificate.max_residual < 1e-9, "{:?}", report.certificate);
    assert_eq!(report.certificate.fallbacks, 0);
}

/// A pyramid that slides as one is braked with `mu g`: in closed form `x = v t - mu g t^2/2`, for every cube.
#[test]
fn a_pyramid_slides_as_one() {
    let speed = 2.0;
    let along = Velocity::new(DVec3::X * speed, DVec3::ZERO);
    let cubes = pyramid(4).into_iter().map(|cube| cube.velocity(along)).collect();
    let (_, recorder) = run(&on_a_floor_of(SMOOTHER, cubes, 0.3));
    for (&t, sample) in recorder.times_s.iter().zip(&recorder.samples) {
        let way = speed * t - 0.5 * SLIDING_FRICTION * G * t * t;
        for (now, start) in sample.iter().zip(&recorder.samples[0]).skip(1) {
            let moved = now.pose.translation - start.pose.translation;
            assert!((moved - DVec3::X * way).length() < LEFT_M, "t = {t}: {moved} instead of {way}");
        }
    }
}

/// A cube is thrown out of a pyramid: energy is never gained, momentum and energy are accounted for (every run here
/// checks that), and what contacts leave of Coulomb's law is below the promise.
#[test]
fn a_pyramid_that_is_hit_gains_no_energy() {
    let (report, _) = run(&on_a_floor(hit(5), 0.4));
    assert!(report.energy.final_j < report.energy.initial_j);
    assert!(report.ledger.numerical.value().abs() < 1e-12 * report.energy.initial_j);
    assert!(report.certificate.max_residual < 1e-6, "{:?}", report.certificate);
    assert!(report.certificate.max_friction_violation_of_limit < 1.0, "{:?}", report.certificate);
}

/// The same bodies in another order move the same, as far as the residual of a step lets them. The pyramid slides as
/// one: where bodies are wedged friction may hold them in several ways, and the order decides which of them is found.
#[test]
fn the_order_of_bodies_changes_no_motion() {
    let along = Velocity::new(DVec3::new(1.0, 0.5, 0.0), DVec3::ZERO);
    let sliding = || pyramid(5).into_iter().map(|cube| cube.velocity(along)).collect::<Vec<Body>>();
    let places = |cubes: Vec<Body>| {
        let (report, _) = run(&on_a_floor_of(SMOOTHER, cubes, 0.1));
        let mut places: Vec<_> =
            report.bodies.iter().map(|body| (body.name.clone(), body.state.pose.translation)).collect();
        places.sort_by(|a, b| a.0.cmp(&b.0));
        places
    };
    let home = places(sliding());
    let reversed = places(sliding().into_iter().rev().collect());
    for (a, b) in home.iter().zip(&reversed) {
        assert!(a.0 == b.0 && (a.1 - b.1).length() < LEFT_M, "{a:?} {b:?}");
    }
}

/// A run that goes on from a snapshot has the bits of one that was never stopped: the forces that a step starts from
/// are part of it.
#[test]
fn restored_piles_go_on_with_the_same_bits() {
    let scene = on_a_floor(hit(5), 0.15).method(stepped(STEP_S)).build().unwrap();
    check_restored_runs(&scene, Effects::Planned);
}
