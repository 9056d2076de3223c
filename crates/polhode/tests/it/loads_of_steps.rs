//! Loads that time steps tell are what they applied: with the velocities of the same run, those of joints and contacts
//! obey Newton's law for every body over every step, where bodies land, slide, roll and stand, and for loops; after a
//! snapshot they are the same.

use crate::support::{brick, floor};
use polhode::scene::{Coordinate, Freedom, Joint, JointKind, Limits, Material, Method, Tier};
use polhode::spatial::{DVec3, MassProperties, UnitVector, Velocity};
use polhode::{Body, BodyId, Scene, Simulation};

const G: f64 = 9.81;
const STEP_S: f64 = 2e-3;

fn rough(body: Body) -> Body {
    body.material(Material::new("rough").with_friction(0.6).unwrap().with_restitution(0.3).unwrap())
}

/// A trunk on two legs with knees, one of which has a limit and the other damping, that falls onto a rough floor, and a
/// closed loop of a rod between the feet.
fn walker() -> Scene {
    let method = Method { tier: Some(Tier::Stepped), step_s: Some(STEP_S), ..Method::default() };
    let mut scene = Scene::builder("walker").method(method).duration_s(0.6);
    scene.add_body(rough(floor()));
    let slide = Velocity::new(DVec3::new(0.5, 0.1, 0.0), DVec3::ZERO);
    let mut part =
        |name: &str, size: DVec3, place: DVec3| scene.add_body(rough(brick(name, size, place)).velocity(slide));
    let trunk = part("trunk", DVec3::new(0.5, 0.2, 0.1), DVec3::Z * 0.5);
    let limb = DVec3::new(0.05, 0.05, 0.16);
    let legs = [-0.2, 0.2].map(|x| {
        let names = if x < 0.0 { ["left thigh", "left shank"] } else { ["right thigh", "right shank"] };
        [part(names[0], limb, DVec3::new(x, 0.0, 0.35)), part(names[1], limb, DVec3::new(x, 0.0, 0.17))]
    });
    let rod = part("rod", DVec3::new(0.3, 0.04, 0.04), DVec3::new(0.0, 0.2, 0.17));
    let soft = Freedom::default().with_spring(20.0, 0.2).unwrap().with_damping(0.2).unwrap();
    let limits = Limits::new(-0.1, 0.1).unwrap();
    for [thigh, shank] in legs {
        let x = if thigh == legs[0][0] { -0.2 } else { 0.2 };
        let hip = Joint::hinge(thigh, DVec3::new(x, 0.0, 0.44), UnitVector::Y).with(trunk);
        scene = scene.joint(hip.along(Coordinate::Angle, soft));
        let knee = Joint::hinge(shank, DVec3::new(x, 0.0, 0.26), UnitVector::Y).with(thigh);
        let stiff = knee.along(Coordinate::Angle, soft);
        scene = scene.joint(if x < 0.0 { knee.with_limits(Coordinate::Angle, limits) } else { stiff });
    }
    let ball = |body: BodyId, x: f64| Joint::new(JointKind::Ball, rod, DVec3::new(x, 0.2, 0.17)).with(body);
    scene.joint(ball(legs[0][1], -0.1)).joint(ball(legs[1][1], 0.1)).build().unwrap()
}

/// Largest defect of Newton's law of any body in a step, in parts of its weight.
fn defect(scene: &Scene, simulation: &Simulation, before: &[DVec3]) -> f64 {
    let mut worst: f64 = 0.0;
    for (index, body) in scene.bodies().iter().enumerate().filter(|(_, body)| body.mass_properties().is_some()) {
        let mass = body.mass_properties().map_or(0.0, MassProperties::mass);
        let id = BodyId::new(index);
        let after = simulation.body(id).velocity.linear;
        let mut left = (after - before[index]) * (mass / STEP_S) + DVec3::Z * (mass * G);
        for contact in simulation.contacts() {
            let force = contact.normal * contact.normal_force_n + contact.friction_n;
            left -= if contact.body_a == id { force } else { DVec3::ZERO };
            left += if contact.body_b == id { force } else { DVec3::ZERO };
        }
        for load in simulation.joint_loads() {
            let joint = &scene.joints()[load.joint.index()];
            left -= if joint.body() == id { load.force_n } else { DVec3::ZERO };
            left += if joint.other() == Some(id) { load.force_n } else { DVec3::ZERO };
        }
        worst = worst.max(left.length() / (mass * G));
    }
    worst
}

#[test]
fn loads_of_every_step_obey_newtons_law() {
    let scene = walker();
    let mut simulation = Simulation::new(&scene).unwrap();
    let bodies = scene.bodies().len();
    let (mut touched, mut worst) = (0, 0.0_f64);
    for _ in 0..300 {
        let before: Vec<DVec3> = (0..bodies).map(|body| simulation.body(BodyId::new(body)).velocity.linear).collect();
        simulation.step().unwrap();
        touched += usize::from(simulation.contacts().iter().any(|contact| contact.normal_force_n > 0.0));
        worst = worst.max(defect(&scene, &simulation, &before));
    }
    assert!(touched > 100, "the feet touch the floor in {touched} steps");
    assert!(worst < 1e-9, "{worst:e} of a weight");
}

#[test]
fn a_snapshot_keeps_the_loads() {
    let scene = walker();
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(0.4).unwrap();
    let (snapshot, loads) = (simulation.snapshot(), simulation.joint_loads());
    let mut other = Simulation::new(&scene).unwrap();
    other.restore(&snapshot).unwrap();
    assert_eq!(other.joint_loads(), loads);
    assert!(loads.iter().any(|load| load.force_n.length() > 1.0), "{loads:?}");
}
