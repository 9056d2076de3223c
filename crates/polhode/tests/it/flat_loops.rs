//! Closed loops of joints that pass their flat position, at which all bars lie in one line: rows of joints depend on
//! each other there, and nearly do beside it. A linkage of parallel cranks is a pendulum, and goes on as one.

use crate::support::{accurate, run};
use polhode::scene::{Coordinate, Freedom, Joint, JointFriction, Method, Tier};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, Effects, Outcome, Scene, SceneBuilder, Simulation};
use std::f64::consts::FRAC_PI_2;

/// Of the linkages: so long as their flat positions are passed once or twice.
const DURATION_S: f64 = 1.5;

/// Attitudes of a whole scene.
const ATTITUDES: [DVec3; 2] = [DVec3::ZERO, DVec3::new(0.7, -0.4, 1.1)];

/// Masses of a crank and of a coupler, kg; cranks are 1 m long.
const MASSES: [f64; 2] = [1.0, 1.5];

fn scene(method: Method, attitude: Rotation, duration_s: f64) -> SceneBuilder {
    let scene = Scene::builder("flat loops").method(method).duration_s(duration_s);
    scene.gravity(attitude.rotate(DVec3::Z * -9.81))
}

/// A thin bar along its x axis, at `lean` (rad) from upright, with its middle at a place.
fn bar(name: String, (mass, length): (f64, f64), lean: f64, place: DVec3, attitude: Rotation) -> Body {
    let across = mass * length * length / 12.0;
    let inertia = Inertia::from_diagonal(DVec3::new(0.1 * across, across, across)).unwrap();
    let properties = MassProperties::new(Mass::new(mass).unwrap(), DVec3::ZERO, inertia);
    let rotation = attitude * Rotation::from_rotation_vector(DVec3::Y * (lean - FRAC_PI_2));
    Body::movable(name, properties).pose(Pose::new(rotation, attitude.rotate(place)))
}

/// Cranks at these feet with one coupler, at `lean` (rad) from upright and turning with `rate` (rad/s): the cranks come
/// first.
fn linkage(feet: &[f64], [lean, rate]: [f64; 2], attitude: Rotation, duration_s: f64) -> Scene {
    let along = DVec3::new(lean.sin(), 0.0, lean.cos());
    let turning = DVec3::Y * rate;
    let axis = UnitVector::new(attitude.rotate(DVec3::Y)).unwrap();
    let moving =
        |arm: DVec3, angular: DVec3| Velocity::new(attitude.rotate(turning.cross(arm)), attitude.rotate(angular));
    let mut scene = scene(accurate(), attitude, duration_s);
    let mut joints = Vec::new();
    let coupler = BodyId::new(feet.len());
    for (number, &foot) in feet.iter().enumerate() {
        let foot = DVec3::X * foot;
        let crank = bar(format!("crank {number}"), (MASSES[0], 1.0), lean, foot + along * 0.5, attitude);
        let crank = scene.add_body(crank.velocity(moving(along * 0.5, turning)));
        joints.push(Joint::hinge(crank, attitude.rotate(foot), axis));
        joints.push(Joint::hinge(crank, attitude.rotate(foot + along), axis).with(coupler));
    }
    let width = feet[feet.len() - 1] - feet[0];
    let middle = DVec3::X * (0.5 * (feet[0] + feet[feet.len() - 1])) + along;
    let body = bar("coupler".to_owned(), (MASSES[1], width), FRAC_PI_2, middle, attitude);
    scene.add_body(body.velocity(moving(along, DVec3::ZERO)));
    joints.into_iter().fold(scene, SceneBuilder::joint).build().unwrap()
}

/// The pendulum that such a linkage is: a body with its moment about the foot and its weight's moment.
fn pendulum(cranks: usize, [lean, rate]: [f64; 2]) -> Scene {
    let (cranks, [crank, coupler]) = (cranks as f64, MASSES);
    let mass = cranks * crank + coupler;
    let arm = (cranks * crank * 0.5 + coupler) / mass;
    let moment = cranks * crank / 3.0 + coupler - mass * arm * arm;
    let inertia = Inertia::from_diagonal(DVec3::splat(moment)).unwrap();
    let properties = MassProperties::new(Mass::new(mass).unwrap(), DVec3::ZERO, inertia);
    let rotation = Rotation::from_rotation_vector(DVec3::Y * (lean - FRAC_PI_2));
    let place = rotation.rotate(DVec3::X * arm);
    let turning = DVec3::Y * rate;
    let body = Body::movable("pendulum", properties).pose(Pose::new(rotation, place));
    let mut scene = scene(accurate(), Rotation::IDENTITY, DURATION_S);
    let body = scene.add_body(body.velocity(Velocity::new(turning.cross(place), turning)));
    scene.joint(Joint::hinge(body, DVec3::ZERO, UnitVector::Y)).build().unwrap()
}

/// A linkage is where its pendulum is, and turns as it, to the rounding of poses over the distance of stages from the
/// flat position; and it keeps its energy.
#[track_caller]
fn assert_swings(feet: &[f64], start: [f64; 2], attitude: Rotation) {
    let (report, _) = run(&linkage(feet, start, attitude, DURATION_S), Effects::Planned);
    let lost = (report.energy.final_j - report.energy.initial_j).abs() / report.ledger.scale_j;
    assert!(lost < 1e-12, "{feet:?} {start:?}: lost {lost:e}");
    assert!(report.warnings.is_empty(), "{:?}", report.warnings);
    let exact = run(&pendulum(feet.len(), start), Effects::Planned).0.bodies[0].state;
    for crank in &report.bodies[..feet.len()] {
        let along = attitude.inverse_rotate(crank.state.pose.rotation.rotate(DVec3::X));
        let off = (along - exact.pose.rotation.rotate(DVec3::X)).length();
        let rate = (attitude.inverse_rotate(crank.state.velocity.angular) - exact.velocity.angular).length();
        assert!(off < 1e-10 && rate < 1e-9, "{feet:?} {start:?}: {off:e} rad, {rate:e} rad/s");
    }
}

#[test]
fn a_linkage_lost_energy_in_its_flat_position() {
    for attitude in ATTITUDES.map(Rotation::from_rotation_vector) {
        assert_swings(&[0.0, 1.0], [0.0, 1.0], attitude);
    }
}

#[test]
fn three_cranks_lost_energy_in_their_flat_position() {
    for attitude in ATTITUDES.map(Rotation::from_rotation_vector) {
        assert_swings(&[0.0, 0.6, 1.7], [0.3, 0.5], attitude);
    }
}

/// From the flat position itself, with a velocity, it goes on along the branch of that velocity.
#[test]
fn a_linkage_starts_from_its_flat_position() {
    assert_swings(&[0.0, 1.0], [FRAC_PI_2, 2.0], Rotation::IDENTITY);
}

/// A run may end where the linkage lies flat: its bars still turn alike.
#[test]
fn bars_turned_apart_where_a_run_ended_in_the_flat_position() {
    let mut long = Simulation::new(&linkage(&[0.0, 1.0], [0.0, 1.0], Rotation::IDENTITY, DURATION_S)).unwrap();
    let mut height = |t: f64| {
        long.advance_to(t).unwrap();
        let bar = long.body(BodyId::new(0));
        (bar.pose.rotation.rotate(DVec3::X).z, bar.velocity.angular.y)
    };
    let mut flat = 0.6;
    for _ in 0..20 {
        let (height, rate) = height(flat);
        // Newton's method from before, whose times ascend: the bar falls faster and faster.
        flat += (height / rate).max(0.0);
    }
    let ending = linkage(&[0.0, 1.0], [0.0, 1.0], Rotation::IDENTITY, flat);
    let (report, _) = run(&ending, Effects::Planned);
    let [first, second] = [0, 1].map(|bar| report.bodies[bar].state.velocity.angular.y);
    assert!((first - second).abs() < 1e-7, "{first} rad/s and {second} rad/s at {flat} s");
}

/// A coupler on three parallel cranks that rub in their bearings, upright at first.
fn rubbing(method: Method, attitude: Rotation) -> Scene {
    let axis = UnitVector::new(attitude.rotate(DVec3::Y)).unwrap();
    let rough = Freedom::default().with_friction(JointFriction::default().with_bearing(0.15, 0.08).unwrap());
    let mut scene = scene(method, attitude, 0.5);
    let (lean, length) = (0.1_f64.atan2(0.3), 0.1_f64.hypot(0.3));
    let along = DVec3::new(0.1, 0.0, 0.3);
    let coupler = scene.add_body(bar("coupler".to_owned(), (1.0, 0.5), FRAC_PI_2, along + DVec3::X * 0.25, attitude));
    for (number, foot) in [0.0, 0.5, 0.2].map(|x| DVec3::X * x).into_iter().enumerate() {
        let crank = scene.add_body(bar(format!("crank {number}"), (1.0, length), lean, foot + along * 0.5, attitude));
        let hinge = |place: DVec3| Joint::hinge(crank, attitude.rotate(place), axis);
        scene = scene.joint(hinge(foot).along(Coordinate::Angle, rough)).joint(hinge(foot + along).with(coupler));
    }
    scene.build().unwrap()
}

/// Loads of bearings grow beside the flat position, and the friction that they press with them: the search for loads
/// did not end there, and a run of half a second took minutes. What a run cannot know there it tells.
#[test]
fn cranks_that_rub_did_not_come_through_their_flat_position() {
    for attitude in ATTITUDES.map(Rotation::from_rotation_vector) {
        let stepped = Method { tier: Some(Tier::Stepped), step_s: Some(1e-3), ..Method::default() };
        for method in [accurate(), stepped] {
            let tier = method.tier;
            let report = Simulation::new(&rubbing(method, attitude)).unwrap().run().unwrap();
            let below = attitude.inverse_rotate(report.bodies[0].state.pose.translation).z;
            assert!(below < -0.1, "{tier:?}: {below} m, {:?}", report.warnings);
            let lost = report.energy.initial_j - report.energy.final_j;
            assert!(lost > 0.0, "{tier:?}: {lost} J");
            assert_eq!(report.outcome, Outcome::Degraded, "{tier:?}: {:?}", report.warnings);
        }
    }
}
