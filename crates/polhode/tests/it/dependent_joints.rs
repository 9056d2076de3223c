//! Joints that depend on each other: more of them than a mechanism needs. Their loads are not unique; those of least
//! norm are taken, told, and turn with the scene. Where bearings rub, so does the motion.

use crate::support::{accurate, run};
use polhode::scene::{Coordinate, Freedom, Joint, JointFriction, Method, Tier};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, UnitVector};
use polhode::{Body, BodyId, Effects, Scene, SceneBuilder, Simulation};

const DURATION_S: f64 = 0.2;

/// Attitudes of a whole scene.
const ATTITUDES: [DVec3; 4] =
    [DVec3::new(0.0, 0.0, 1.0), DVec3::new(0.7, -0.4, 1.1), DVec3::new(-1.9, 0.8, 0.3), DVec3::new(2.1, 1.3, -0.6)];

fn stepped(step_s: f64) -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(step_s), ..Method::default() }
}

fn scene(method: Method, attitude: Rotation) -> SceneBuilder {
    let scene = Scene::builder("dependent joints").method(method).duration_s(DURATION_S);
    scene.gravity(attitude.rotate(DVec3::new(0.3, 0.1, -9.81)))
}

/// A body of 1 kg with these principal moments, without turn in its scene.
fn bar(name: String, (place, attitude): (DVec3, Rotation)) -> Body {
    let inertia = Inertia::from_diagonal(DVec3::new(0.01, 0.02, 0.025)).unwrap();
    let properties = MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia);
    Body::movable(name, properties).pose(Pose::new(attitude, attitude.rotate(place)))
}

fn rough() -> Freedom {
    Freedom::default().with_friction(JointFriction::default().with_bearing(0.15, 0.08).unwrap())
}

/// A coupler on three parallel cranks, all of which rub in their bearings; they stay away from their flat position.
fn cranks(method: Method, attitude: Rotation) -> Scene {
    let at = |x: f64, z: f64| DVec3::new(x, 0.0, z);
    let axis = UnitVector::new(attitude.rotate(DVec3::Y)).unwrap();
    let mut scene = scene(method, attitude);
    let coupler = scene.add_body(bar("coupler".to_owned(), (at(0.35, 0.3), attitude)));
    for (k, x) in [0.0, 0.5, 0.2].into_iter().enumerate() {
        let crank = scene.add_body(bar(format!("crank {k}"), (at(x + 0.05, 0.15), attitude)));
        let hinge = |body: BodyId, place: DVec3| Joint::hinge(body, attitude.rotate(place), axis);
        scene = scene
            .joint(hinge(crank, at(x, 0.0)).along(Coordinate::Angle, rough()))
            .joint(hinge(crank, at(x + 0.1, 0.3)).with(coupler));
    }
    scene.build().unwrap()
}

/// A door on three hinges, at unequal heights of an axis that leans.
fn door(method: Method, attitude: Rotation) -> Scene {
    let up = DVec3::new(0.2, 0.1, 1.0).normalize();
    let mut scene = scene(method, attitude);
    let door = scene.add_body(bar("door".to_owned(), (DVec3::new(0.4, 0.1, 0.9), attitude)));
    for height in [0.2, 1.1, 1.8] {
        let hinge = Joint::hinge(door, attitude.rotate(up * height), UnitVector::new(attitude.rotate(up)).unwrap());
        scene = scene.joint(hinge.along(Coordinate::Angle, rough()));
    }
    scene.build().unwrap()
}

/// Where bodies are, and what joints bear, seen from the attitude of the whole scene.
fn seen(scene: &Scene, attitude: Rotation) -> (Vec<DVec3>, Vec<DVec3>) {
    let mut simulation = Simulation::new(scene).unwrap();
    simulation.advance_to(DURATION_S).unwrap();
    let places = (0..scene.bodies().len()).map(|body| simulation.body(BodyId::new(body)).pose.translation);
    let places = places.map(|place| attitude.inverse_rotate(place)).collect();
    let loads = simulation.joint_loads();
    let loads = loads.iter().flat_map(|load| [load.force_n, load.moment_n_m]);
    (places, loads.map(|load| attitude.inverse_rotate(load)).collect())
}

fn farthest(found: &[DVec3], expected: &[DVec3]) -> f64 {
    assert_eq!(found.len(), expected.len());
    found.iter().zip(expected).map(|(a, b)| (*a - *b).length()).fold(0.0, f64::max)
}

/// How far bodies (m) and loads of joints (N, N m) of a scene in other attitudes are from those in none, the farthest.
fn differences(method: &Method, built: impl Fn(Method, Rotation) -> Scene) -> [f64; 2] {
    let (places, loads) = seen(&built(method.clone(), Rotation::IDENTITY), Rotation::IDENTITY);
    ATTITUDES.map(Rotation::from_rotation_vector).into_iter().fold([0.0; 2], |[moved, borne], attitude| {
        let (turned, turned_loads) = seen(&built(method.clone(), attitude), attitude);
        [moved.max(farthest(&turned, &places)), borne.max(farthest(&turned_loads, &loads))]
    })
}

/// Exactly the motion turns with the scene. In time steps friction acts at levers of the poses that bodies have, and
/// joints at those at which their loops are closed: that is seen, and goes with the second power of the step.
#[track_caller]
fn assert_turns_with_the_scene(built: impl Fn(Method, Rotation) -> Scene) {
    let [moved, borne] = differences(&accurate(), &built);
    assert!(moved < 1e-9 && borne < 1e-9 * 9.81, "{moved:e} m, loads of {borne:e} N");
    let [coarse, fine] = [4e-3, 2e-3].map(|step_s| differences(&stepped(step_s), &built)[0]);
    assert!(coarse < 1e-6 && (3.5..4.5).contains(&(coarse / fine)), "in steps {coarse:e} m and {fine:e} m");
}

#[test]
fn bearings_of_three_cranks_rubbed_by_loads_that_followed_the_axes_of_the_world() {
    assert_turns_with_the_scene(cranks);
}

#[test]
fn a_door_on_three_hinges_was_rubbed_by_loads_that_followed_the_axes_of_the_world() {
    assert_turns_with_the_scene(door);
}

#[test]
fn loads_of_bearings_that_are_not_unique_are_told() {
    for attitude in ATTITUDES.map(Rotation::from_rotation_vector) {
        for built in [cranks(accurate(), attitude), door(accurate(), attitude)] {
            let (report, _) = run(&built, Effects::Planned);
            let told = report.warnings.iter().any(|warning| warning.contains("loads of bearings"));
            assert!(told, "{:?}", report.warnings);
        }
    }
}
