//! Joints that a program adds to a simulation and takes away: what was held flies as a free body, what is caught swings
//! from there, both ledgers close, and a snapshot goes on with the same bits on either side of the change.

use crate::checks::{assert_closes, particle};
use crate::joints::{Pendulum, down, inertia, integrate, rod};
use crate::support::{accurate, ball, brick, floor};
use polhode::mesh::solid_box;
use polhode::scene::{Coordinate, Drive, Joint, JointKind, Limits, Method, Motor, Tier};
use polhode::spatial::{DVec3, Mass, Pose, UnitVector, Velocity};
use polhode::{
    ActionError, Body, BodyId, JointId, Recorder, Scene, SceneBuilder, SceneError, Simulation, SimulationError,
};

const G: f64 = 9.81;

const ROD: (f64, f64) = (1.5, 0.8);

fn by(tier: Tier, step_s: f64) -> Method {
    Method { tier: Some(tier), step_s: Some(step_s), ..Method::default() }
}

/// The tiers that have joints, with the error of a position that their steps leave after half a second, m.
fn methods() -> [(Method, f64); 3] {
    [(accurate(), 1e-9), (by(Tier::Stepped, 1e-3), 1e-2), (by(Tier::Fast, 1e-3), 1e-2)]
}

/// A rod that hangs at the origin by a hinge along y, and is let go at an angle.
fn pendulum(method: Method, angle: f64) -> (SceneBuilder, BodyId, JointId) {
    let mut scene = Scene::builder("pendulum").method(method).gravity(DVec3::Z * -G).duration_s(1.0);
    let body = scene.add_body(rod("rod", ROD, down(angle) * (0.5 * ROD.1), angle));
    let hinge = scene.add_joint(Joint::hinge(body, DVec3::ZERO, UnitVector::Y));
    (scene, body, hinge)
}

/// A rod that lies level and falls from rest.
fn falling(method: Method) -> (SceneBuilder, BodyId) {
    let mut scene = Scene::builder("falling").method(method).gravity(DVec3::Z * -G).duration_s(1.0);
    let body = scene.add_body(rod("rod", ROD, DVec3::X * (0.5 * ROD.1), std::f64::consts::FRAC_PI_2));
    (scene, body)
}

fn action(error: SimulationError) -> ActionError {
    match error {
        SimulationError::Action(error) => error,
        other => panic!("{other}"),
    }
}

/// Free bodies fly in closed form: on the parabola of the velocity that the hinge left, with the rate of turning that
/// it had.
#[test]
fn a_pendulum_whose_hinge_is_removed_flies_as_a_free_body() {
    for (method, _) in methods() {
        let is_fast = method.tier == Some(Tier::Fast);
        let (scene, body, hinge) = pendulum(method, 1.2);
        let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
        simulation.advance_to(0.4).unwrap();
        let before = simulation.body(body);
        simulation.remove_joint(hinge).unwrap();
        assert!(simulation.joint_loads().is_empty() && simulation.coordinate(hinge, Coordinate::Angle).is_none());
        assert!((simulation.body(body).velocity.linear - before.velocity.linear).length() < 1e-14);
        simulation.advance_to(0.9).unwrap();
        let (after, t) = (simulation.body(body), 0.5);
        let wanted = before.pose.translation + before.velocity.linear * t - DVec3::Z * (0.5 * G * t * t);
        let within = if is_fast { 1e-3 } else { 1e-11 };
        assert!((after.pose.translation - wanted).length() < within, "{:?} {wanted:?}", after.pose.translation);
        assert!((after.velocity.angular - before.velocity.angular).length() < 1e-9, "{:?}", after.velocity);
        assert_closes(&simulation.run().unwrap());
    }
}

/// The hinge stops the end of the rod by an impulse, about which the angular momentum stays; from there it swings.
#[test]
fn a_body_that_a_new_hinge_catches_swings_like_a_pendulum() {
    let caught = 0.2;
    let (mass, length) = ROD;
    let whole = inertia(ROD) + 0.25 * mass * length * length;
    for (method, within) in methods() {
        let (scene, body) = falling(method);
        let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
        simulation.advance_to(caught).unwrap();
        let before = simulation.energy();
        let center = simulation.body(body).pose.translation;
        let end = center - DVec3::X * (0.5 * length);
        let hinge = simulation.add_joint(Joint::hinge(body, end, UnitVector::Y)).unwrap();
        let rate = mass * G * caught * (0.5 * length) / whole;
        let angular = simulation.body(body).velocity.angular;
        assert!((angular - DVec3::Y * rate).length() < 1e-3 * within.max(1e-9), "{angular:?} {rate}");
        let lost = before.kinetic_j - simulation.energy().kinetic_j;
        let wanted = 0.5 * mass * (G * caught) * (G * caught) - 0.5 * whole * rate * rate;
        assert!((lost - wanted).abs() < within.max(1e-9), "{lost} {wanted}");
        simulation.advance_to(caught + 0.5).unwrap();
        // Angles from -z towards x; the rod turns down.
        let mut state = vec![std::f64::consts::FRAC_PI_2, -rate];
        integrate(&mut Pendulum { rate: 0.5 * length * mass * G / whole }, 0.5, &mut state);
        let wanted = end + down(state[0]) * (0.5 * length);
        let found = simulation.body(body).pose.translation;
        assert!((found - wanted).length() < within, "{found:?} {wanted:?}");
        let angle = simulation.coordinate(hinge, Coordinate::Angle).unwrap().value;
        let turned = std::f64::consts::FRAC_PI_2 - state[0];
        assert!((angle.abs() - turned.abs()).abs() < within, "{angle} {turned}");
        assert_closes(&simulation.run().unwrap());
    }
}

/// A snapshot from before the removal brings the joint back, one from after it has none, and both go on with the same
/// bits.
#[test]
fn a_snapshot_goes_on_across_a_removal() {
    for (method, _) in methods() {
        let (scene, body, hinge) = pendulum(method, 1.2);
        let scene = scene.build().unwrap();
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(0.3).unwrap();
        let before = simulation.snapshot();
        simulation.remove_joint(hinge).unwrap();
        let after = simulation.snapshot();
        simulation.advance_to(0.8).unwrap();
        let flown = simulation.body(body);
        simulation.restore(&before).unwrap();
        assert!(simulation.coordinate(hinge, Coordinate::Angle).is_some());
        simulation.advance_to(0.8).unwrap();
        let swung = simulation.body(body);
        assert!((swung.pose.translation.length() - 0.5 * ROD.1).abs() < 1e-4);
        let mut other = Simulation::new(&scene).unwrap();
        other.restore(&after).unwrap();
        other.advance_to(0.8).unwrap();
        assert_eq!(other.body(body), flown);
        other.restore(&before).unwrap();
        other.advance_to(0.8).unwrap();
        assert_eq!(other.body(body), swung);
    }
}

/// The motor that a program has given a joint goes with it, and comes back with it.
#[test]
fn a_motor_comes_back_with_its_joint() {
    for (method, _) in [methods()[0].clone(), methods()[1].clone()] {
        let (scene, body, hinge) = pendulum(method, 1.2);
        let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
        let motor = Motor::new(Drive::Effort(2.0)).unwrap();
        simulation.set_motor(hinge, Coordinate::Angle, Some(motor)).unwrap();
        simulation.advance_to(0.2).unwrap();
        let before = simulation.snapshot();
        simulation.advance_to(0.5).unwrap();
        let driven = simulation.body(body);
        simulation.restore(&before).unwrap();
        simulation.remove_joint(hinge).unwrap();
        let after = simulation.snapshot();
        simulation.advance_to(0.5).unwrap();
        let flown = simulation.body(body);
        simulation.restore(&after).unwrap();
        simulation.advance_to(0.5).unwrap();
        assert_eq!(simulation.body(body), flown);
        simulation.restore(&before).unwrap();
        simulation.advance_to(0.5).unwrap();
        assert_eq!(simulation.body(body), driven);
    }
}

/// A snapshot with a joint that was added belongs to a simulation to which the same joint was added, between bodies at
/// the same places.
#[test]
fn a_snapshot_goes_on_with_a_joint_that_was_added() {
    for (method, _) in methods() {
        let (scene, body) = falling(method);
        let scene = scene.build().unwrap();
        let joint = |simulation: &Simulation| {
            let end = simulation.body(body).pose.translation - DVec3::X * (0.5 * ROD.1);
            Joint::hinge(body, end, UnitVector::Y)
        };
        let (mut one, mut other) = (Simulation::new(&scene).unwrap(), Simulation::new(&scene).unwrap());
        let free = one.snapshot();
        for simulation in [&mut one, &mut other] {
            simulation.advance_to(0.2).unwrap();
            simulation.add_joint(joint(simulation)).unwrap();
        }
        one.advance_to(0.3).unwrap();
        let saved = one.snapshot();
        one.advance_to(0.7).unwrap();
        other.restore(&saved).unwrap();
        other.advance_to(0.7).unwrap();
        assert_eq!(one.body(body), other.body(body));
        assert!(one.restore(&free).is_err());
        let mut elsewhere = Simulation::new(&scene).unwrap();
        let same_place = joint(&other);
        assert!(elsewhere.restore(&saved).is_err());
        elsewhere.add_joint(same_place).unwrap();
        assert!(elsewhere.restore(&saved).is_err());
    }
}

/// A hinge whose stop bears a load is removed: contacts at the joint go with it, and a snapshot of that moment can be
/// restored.
#[test]
fn stops_go_with_their_joint() {
    for (method, within) in methods() {
        let mut scene = Scene::builder("at its stop").method(method).gravity(DVec3::Z * -G).duration_s(1.0);
        let body = scene.add_body(rod("rod", ROD, down(0.8) * (0.5 * ROD.1), 0.8));
        let limits = Limits::new(-0.5, 0.5).unwrap();
        let hinge = Joint::hinge(body, DVec3::ZERO, UnitVector::Y).with_limits(Coordinate::Angle, limits);
        let hinge = scene.add_joint(hinge);
        let scene = scene.build().unwrap();
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(0.6).unwrap();
        let before = simulation.body(body);
        simulation.remove_joint(hinge).unwrap();
        let mut other = Simulation::new(&scene).unwrap();
        other.restore(&simulation.snapshot()).unwrap();
        for simulation in [&mut simulation, &mut other] {
            simulation.advance_to(0.8).unwrap();
        }
        assert_eq!(simulation.body(body), other.body(body));
        let wanted = before.pose.translation + before.velocity.linear * 0.2 - DVec3::Z * (0.5 * G * 0.2 * 0.2);
        let found = simulation.body(body).pose.translation;
        assert!((found - wanted).length() < within, "{found:?} {wanted:?}");
    }
}

/// Two balls rest on each other; a weld joins them, and later lets go: they do not collide with each other, and the
/// lower one still bears both while they are one.
#[test]
fn bodies_that_a_joint_joins_do_not_collide() {
    for (method, _) in methods() {
        let mut scene = Scene::builder("two balls").method(method).gravity(DVec3::Z * -G).duration_s(2.0).body(floor());
        let lower = scene.add_body(ball("lower", 1.0, 0.5, DVec3::Z * 0.5, DVec3::ZERO));
        let upper = scene.add_body(ball("upper", 1.0, 0.5, DVec3::Z * 1.5, DVec3::ZERO));
        let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
        simulation.advance_to(0.2).unwrap();
        assert_eq!(simulation.contacts().len(), 2);
        let weld = Joint::new(JointKind::Fixed, lower, DVec3::Z).with(upper);
        let weld = simulation.add_joint(weld).unwrap();
        simulation.advance_to(0.5).unwrap();
        let contacts = simulation.contacts();
        assert_eq!(contacts.len(), 1, "{contacts:?}");
        assert!((contacts[0].normal_force_n - 2.0 * G).abs() < 1e-2, "{contacts:?}");
        assert!((simulation.body(upper).pose.translation.z - 1.5).abs() < 1e-3);
        simulation.remove_joint(weld).unwrap();
        simulation.advance_to(0.6).unwrap();
        let fallen = 1.5 - simulation.body(upper).pose.translation.z;
        assert!((fallen - 0.5 * G * 0.01).abs() < 1e-2, "{fallen}");
    }
}

/// A joint that was added has motors, loads and a handle as those of the scene.
#[test]
fn a_joint_that_was_added_has_a_motor_and_a_load() {
    let mut scene = Scene::builder("motor").method(accurate()).gravity(DVec3::Z * -G).duration_s(5.0);
    let properties = solid_box(DVec3::new(0.8, 0.04, 2.0), Mass::new(20.0).unwrap()).unwrap();
    let door = scene.add_body(Body::movable("door", properties).pose(Pose::from_translation(DVec3::X * 0.4)));
    let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
    let hinge = simulation.add_joint(Joint::hinge(door, DVec3::ZERO, UnitVector::Z)).unwrap();
    let drive = Drive::Position { position: 1.0, stiffness: 200.0, damping: 80.0 };
    simulation.set_motor(hinge, Coordinate::Angle, Some(Motor::new(drive).unwrap())).unwrap();
    simulation.advance_to(5.0).unwrap();
    assert!((simulation.coordinate(hinge, Coordinate::Angle).unwrap().value - 1.0).abs() < 1e-3);
    assert!((simulation.joint_loads()[0].force_n.z - 20.0 * G).abs() < 1e-6);
    let saved = simulation.snapshot();
    simulation.restore(&saved).unwrap();
    assert_closes(&simulation.run().unwrap());
}

/// Two bodies in flight that a ball joint joins keep the momentum of both.
#[test]
fn a_joint_between_two_bodies_keeps_their_momentum() {
    for (method, _) in methods() {
        let mut scene = Scene::builder("caught in flight").method(method).gravity(DVec3::ZERO).duration_s(1.0);
        let one = scene.add_body(particle("one", 1.0, DVec3::ZERO, DVec3::new(1.0, 0.5, 0.0)));
        let other = scene.add_body(particle("other", 2.0, DVec3::X, DVec3::new(0.0, 0.0, -0.3)));
        let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
        simulation.advance_to(0.1).unwrap();
        let middle = 0.5 * (simulation.body(one).pose.translation + simulation.body(other).pose.translation);
        let before = simulation.momentum();
        simulation.add_joint(Joint::ball(one, middle).with(other)).unwrap();
        simulation.advance_to(0.9).unwrap();
        let after = simulation.momentum();
        assert!((after.linear - before.linear).length() < 1e-9, "{before:?} {after:?}");
        assert!((after.angular - before.angular).length() < 1e-3, "{before:?} {after:?}");
        assert_closes(&simulation.run().unwrap());
    }
}

/// What cannot be done is refused, and the simulation goes on as it was.
#[test]
fn joints_that_cannot_be_changed_are_refused() {
    let (scene, body, hinge) = pendulum(accurate(), 1.2);
    let scene = scene.build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(0.1).unwrap();
    let saved = simulation.snapshot();
    let wrong = simulation.remove_joint(JointId::new(7)).unwrap_err();
    assert_eq!(action(wrong), ActionError::UnknownJoint { index: 7, joints: 1 });
    let unknown = simulation.add_joint(Joint::ball(BodyId::new(4), DVec3::ZERO)).unwrap_err();
    assert_eq!(action(unknown), ActionError::UnknownBody { index: 4, bodies: 1 });
    let itself = simulation.add_joint(Joint::ball(body, DVec3::ZERO).with(body)).unwrap_err();
    assert!(matches!(itself, SimulationError::Scene(SceneError::Joint { number: 1, .. })), "{itself}");
    let not_finite = simulation.add_joint(Joint::ball(body, DVec3::splat(f64::NAN))).unwrap_err();
    assert!(matches!(not_finite, SimulationError::Scene(SceneError::Joint { .. })), "{not_finite}");
    assert_eq!(simulation.snapshot(), saved);
    simulation.remove_joint(hinge).unwrap();
    assert_eq!(action(simulation.remove_joint(hinge).unwrap_err()), ActionError::RemovedJoint(0));
    simulation.remove_body(body).unwrap();
    let removed = simulation.add_joint(Joint::ball(body, DVec3::ZERO)).unwrap_err();
    assert_eq!(action(removed), ActionError::RemovedBody("rod".to_owned()));
}

/// A rope that is longer than it may be names by how much, and a joint on a pivot what to do instead.
#[test]
fn joints_whose_anchors_are_apart_are_refused() {
    let (scene, body) = falling(accurate());
    let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
    let at = simulation.body(body).pose.translation;
    let rope = Joint::rope(body, at, at + DVec3::Z * 2.0, 1.5).unwrap();
    let apart = simulation.add_joint(rope).unwrap_err();
    assert!(apart.to_string().contains("2 m") && apart.to_string().contains("1.5"), "{apart}");
    let limits = Limits::new(0.1, 0.5).unwrap();
    let beyond = Joint::hinge(body, at, UnitVector::Y).with_limits(Coordinate::Angle, limits);
    let beyond = simulation.add_joint(beyond).unwrap_err();
    assert!(matches!(beyond, SimulationError::Scene(SceneError::JointBeyondLimits { .. })), "{beyond}");
    let on_pivot = brick("on pivot", DVec3::ONE, DVec3::ZERO).pivot(DVec3::Z * 0.5);
    let mut simulation = Simulation::new(&Scene::builder("pivot").body(on_pivot).build().unwrap()).unwrap();
    let refused = simulation.add_joint(Joint::ball(BodyId::new(0), DVec3::ZERO)).unwrap_err();
    assert_eq!(action(refused), ActionError::JointOnPivot("on pivot".to_owned()));
}

/// Tiers without joints, and joints with more than a tier has, are refused.
#[test]
fn joints_that_the_tier_does_not_have_are_refused() {
    let (scene, body) = falling(by(Tier::Thesis, 1e-3));
    let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
    let refused = simulation.add_joint(Joint::ball(body, DVec3::ZERO)).unwrap_err();
    assert!(matches!(refused, SimulationError::Scene(SceneError::JointsInTier { .. })), "{refused}");
    let (scene, body) = falling(by(Tier::Fast, 1e-3));
    let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
    let weak = Joint::ball(body, DVec3::ZERO).breaking_at(polhode::scene::Strength::default().force(5.0).unwrap());
    let refused = simulation.add_joint(weak).unwrap_err();
    assert!(matches!(refused, SimulationError::Scene(SceneError::NotYetAvailable { .. })), "{refused}");
    let (scene, body) = falling(Method { tier: Some(Tier::Penalty), ..Method::default() });
    let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
    let hinge = Joint::hinge(body, DVec3::ZERO, UnitVector::Y);
    let limits = Limits::new(-0.5, 0.5).unwrap();
    let refused = simulation.add_joint(hinge.with_limits(Coordinate::Angle, limits)).unwrap_err();
    assert!(matches!(refused, SimulationError::Scene(SceneError::NotYetAvailable { .. })), "{refused}");
    let hinge = simulation.add_joint(hinge).unwrap();
    simulation.advance_to(0.3).unwrap();
    assert!((simulation.body(body).pose.translation.length() - 0.5 * ROD.1).abs() < 1e-9);
    simulation.remove_joint(hinge).unwrap();
    assert_closes(&simulation.run().unwrap());
}

/// Steps of a length end there, at events, or where the tier's own steps do; what is reported on the way changes
/// nothing.
#[test]
fn steps_of_a_length_end_where_they_are_asked_to() {
    for (method, _) in methods() {
        let is_accurate = method.tier == Some(Tier::Accurate);
        let (scene, body, _) = pendulum(method, 1.2);
        let scene = scene.build().unwrap();
        let (mut one, mut other) = (Simulation::new(&scene).unwrap(), Simulation::new(&scene).unwrap());
        let own = one.step_within(1e-4, &mut Recorder::default()).unwrap();
        assert!((own.t_s - 1e-4).abs() < 1e-15, "{own:?}");
        let own = one.step_within(10.0, &mut Recorder::default()).unwrap();
        assert!(own.t_s <= 1.0, "{own:?}");
        one.advance_to(0.5).unwrap();
        other.advance_to(0.5).unwrap();
        if is_accurate {
            assert_eq!(one.body(body), other.body(body));
        }
        let told = one.report_so_far().unwrap();
        assert_eq!(told.simulated_s.to_bits(), 0.5_f64.to_bits());
        let saved = one.snapshot();
        let ends = one.run().unwrap();
        one.restore(&saved).unwrap();
        one.report_so_far().unwrap();
        assert_eq!(one.run().unwrap().bodies, ends.bodies);
        for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let refused = one.step_within(wrong, &mut Recorder::default()).unwrap_err();
            assert!(matches!(refused, SimulationError::TimeInThePast { .. }), "{refused}");
        }
    }
}

/// A body that turns is caught by a weld: it stops, and what it had is the program's.
#[test]
fn a_weld_stops_a_body_at_once() {
    let mut scene = Scene::builder("stopped").method(accurate()).gravity(DVec3::ZERO).duration_s(1.0);
    let velocity = Velocity::new(DVec3::new(1.0, 2.0, 0.0), DVec3::new(0.0, 3.0, 1.0));
    let body = scene.add_body(brick("brick", DVec3::ONE, DVec3::ZERO).velocity(velocity));
    let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
    simulation.advance_to(0.3).unwrap();
    let at = simulation.body(body).pose;
    let had = simulation.energy().kinetic_j;
    simulation.add_joint(Joint::new(JointKind::Fixed, body, at.translation)).unwrap();
    simulation.advance_to(1.0).unwrap();
    assert!((simulation.body(body).pose.translation - at.translation).length() < 1e-12);
    let report = simulation.run().unwrap();
    assert_closes(&report);
    assert!((report.ledger.external.value() + had).abs() < 1e-10 * had, "{:?}", report.ledger);
}
