//! Islands with joints come to rest in the tier `fast` where forces of their contacts, joints and limits hold them, and
//! not where none do: a pendulum of an amplitude that a step can hardly tell from rest swings on. At rest all
//! velocities are zero, joints bear what hangs at them, and what reaches one body wakes its whole island.

use crate::fast_joints::{fast, pendulum, run};
use crate::friction::rough;
use crate::snapshots::check_restored_runs;
use crate::support::{ball, brick, floor};
use polhode::scene::{Coordinate, Joint, JointKind, Limits};
use polhode::spatial::{DVec3, MassProperties, UnitVector, Velocity};
use polhode::{BodyId, Effects, MotionKind, Scene, SceneBuilder, Simulation};

const G: f64 = 9.81;

/// How many bodies rest. Those that rest have no velocity.
fn resting(simulation: &Simulation, bodies: usize) -> usize {
    let frame = simulation.frame();
    let rests = |&body: &usize| frame.motions[body] == MotionKind::Rest;
    let still = |&body: &usize| simulation.body(BodyId::new(body)).velocity == Velocity::default();
    let number = (0..bodies).filter(rests).count();
    assert_eq!((0..bodies).filter(rests).filter(still).count(), number);
    number
}

/// Ten links that hang in line below the origin.
fn hanging() -> SceneBuilder {
    let mut scene = Scene::builder("hanging chain").method(fast(1.0 / 60.0)).duration_s(8.0).output_interval_s(2.0);
    for link in 0..10 {
        let top = DVec3::Z * (-0.4 * link as f64);
        scene = scene.body(brick(&format!("{link}"), DVec3::new(0.05, 0.05, 0.3), top - DVec3::Z * 0.2));
        let joint = Joint::ball(BodyId::new(link), top);
        scene = scene.joint(if link == 0 { joint } else { joint.with(BodyId::new(link - 1)) });
    }
    scene
}

/// A chain that hangs comes to rest, and its joints bear the links below them. A stone that hits one link wakes all.
#[test]
fn a_hanging_chain_rests_until_it_is_hit() {
    let scene = hanging().body(ball("stone", 0.1, 0.05, DVec3::new(20.0, 0.0, -3.8), DVec3::X * -4.0));
    let scene = scene.build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(1.0).unwrap();
    assert_eq!(resting(&simulation, 10), 10);
    let mass = scene.bodies()[0].mass_properties().map_or(0.0, MassProperties::mass);
    for (number, load) in simulation.joint_loads().iter().enumerate() {
        let below = (10 - number) as f64 * mass * G;
        assert!((load.force_n - DVec3::Z * below).length() < 1e-3 * below, "{number}: {load:?}");
    }
    // The stone flies on a parabola, and misses.
    simulation.advance_to(4.0).unwrap();
    assert_eq!(resting(&simulation, 10), 10);
    let hit = hanging().body(ball("stone", 0.1, 0.05, DVec3::new(4.2, 0.0, 3.4), DVec3::X * -4.0));
    let mut simulation = Simulation::new(&hit.build().unwrap()).unwrap();
    simulation.advance_to(0.9).unwrap();
    assert_eq!(resting(&simulation, 10), 10);
    simulation.advance_to(1.3).unwrap();
    assert_eq!(resting(&simulation, 10), 0);
}

/// A pendulum of an amplitude of 3e-4 rad is slower than a step can tell from rest all the time; it swings on.
#[test]
fn a_pendulum_at_its_turning_point_does_not_rest() {
    for angle in [3e-4, 1.0] {
        let scene = pendulum(|body| Joint::hinge(body, DVec3::ZERO, UnitVector::Y), angle).method(fast(1.0 / 60.0));
        let mut simulation = Simulation::new(&scene.duration_s(10.0).build().unwrap()).unwrap();
        let mut most: f64 = 0.0;
        for step in 1..=600 {
            simulation.advance_to(f64::from(step) / 60.0).unwrap();
            assert_eq!(resting(&simulation, 1), 0, "{angle}");
            if step > 500 {
                most = most.max(simulation.body(BodyId::new(0)).pose.translation.x.abs());
            }
        }
        assert!(most > 0.8 * 0.5 * angle.sin(), "{angle}: {most}");
    }
}

/// A table of five boxes in fixed joints that stands on the floor with three boxes on it.
fn table() -> SceneBuilder {
    let stone = |name: &str, size: DVec3, at: DVec3| brick(name, size, at).material(rough(0.5));
    let mut scene = Scene::builder("table").method(fast(1.0 / 60.0)).duration_s(6.0).output_interval_s(2.0);
    scene = scene.body(floor().material(rough(0.5)));
    scene = scene.body(stone("top", DVec3::new(1.0, 0.6, 0.05), DVec3::Z * 0.75));
    for (number, (x, y)) in [(-0.45, -0.25), (-0.45, 0.25), (0.45, -0.25), (0.45, 0.25)].into_iter().enumerate() {
        scene = scene.body(stone(&format!("leg {number}"), DVec3::new(0.05, 0.05, 0.7), DVec3::new(x, y, 0.37)));
        let joint = Joint::new(JointKind::Fixed, BodyId::new(2 + number), DVec3::new(x, y, 0.72));
        scene = scene.joint(joint.with(BodyId::new(1)));
    }
    for (number, x) in [-0.3, 0.0, 0.3].into_iter().enumerate() {
        scene = scene.body(stone(&format!("box {number}"), DVec3::splat(0.2), DVec3::new(x, 0.0, 0.89)));
    }
    scene
}

#[test]
fn a_table_of_fixed_joints_rests_and_its_legs_bear_it() {
    let scene = table().build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(6.0).unwrap();
    assert_eq!(resting(&simulation, scene.bodies().len()), 8);
    let mass = |body: usize| scene.bodies()[body].mass_properties().map_or(0.0, MassProperties::mass);
    let above: f64 = [1, 6, 7, 8].into_iter().map(mass).sum::<f64>() * G;
    let borne: DVec3 = simulation.joint_loads().iter().map(|load| load.force_n).sum();
    assert!((borne + DVec3::Z * above).length() < 1e-2 * above, "{borne} {above}");
    check_restored_runs(&scene, Effects::Planned);
}

/// A rod at a hinge lies on the limit of its angle, which pushes.
#[test]
fn a_rod_on_its_limit_rests() {
    let limits = Limits::new(-0.5, 0.5).unwrap();
    let hinge = |body: BodyId| Joint::hinge(body, DVec3::ZERO, UnitVector::Y).with_limits(Coordinate::Angle, limits);
    let scene = pendulum(hinge, 1.2).method(fast(1.0 / 60.0)).duration_s(5.0);
    let mut simulation = Simulation::new(&scene.clone().build().unwrap()).unwrap();
    simulation.advance_to(5.0).unwrap();
    assert_eq!(resting(&simulation, 1), 1);
    assert!(run(scene).energy.kinetic_j == 0.0);
}
