//! A simulation that a program advances: the division into steps changes no bit. The actions of the program on bodies
//! have the effects of mechanics, and the ledgers book them.

use crate::support::{Sides, accurate, ball, brick, diamond, elastic, floor};
use polhode::spatial::{DVec3, Pose, Velocity};
use polhode::{ActionError, BodyId, Effects, Recorder, Scene, SceneBuilder, Simulation, SimulationError};

/// A pile that falls: bricks and balls that meet each other and the floor.
fn pile() -> SceneBuilder {
    let size = DVec3::new(0.4, 0.3, 0.2);
    Scene::builder("pile")
        .duration_s(0.8)
        .output_interval_s(0.037)
        .method(accurate())
        .body(floor().material(elastic(0.3)))
        .body(brick("low", size, DVec3::new(0.0, 0.0, 0.15)).material(elastic(0.3)))
        .body(brick("high", size, DVec3::new(0.13, 0.05, 0.45)).material(elastic(0.3)))
        .body(ball("ball", 0.5, 0.1, DVec3::new(-0.1, 0.02, 0.9), DVec3::ZERO).material(elastic(0.3)))
}

/// All numbers of a record, as bits.
fn bits(record: &Recorder) -> Vec<u64> {
    let mut out = Vec::new();
    for (t, row) in record.times_s.iter().zip(&record.samples) {
        out.push(t.to_bits());
        for body in row {
            let [w, x, y, z] = body.pose.rotation.to_wxyz();
            out.extend([w, x, y, z].map(f64::to_bits));
            for v in [body.pose.translation, body.velocity.linear, body.velocity.angular] {
                out.extend(v.to_array().map(f64::to_bits));
            }
        }
    }
    for event in &record.events {
        out.extend([event.t_s, event.impulse, event.energy_change_j].map(f64::to_bits));
    }
    out
}

fn closes(simulation: &mut Simulation) {
    let report = simulation.run().unwrap();
    assert!(report.ledger.closure_relative() < 1e-12, "{:?}", report.ledger);
    assert!(report.ledger.momentum.closure_relative() < 1e-12, "{:?}", report.ledger.momentum);
}

/// Steps one by one, a run as a whole, and a run that a program stops at many times have the same samples and events,
/// bit for bit: a stop within a step does not shorten the step.
#[test]
fn the_motion_is_the_same_wherever_it_is_stopped() {
    for scene in [pile().build().unwrap(), diamond(2, Sides::Touch).duration_s(0.3).build().unwrap()] {
        let mut whole = Recorder::default();
        Simulation::new(&scene).unwrap().run_observed(&mut whole).unwrap();
        let mut stepped = Recorder::default();
        let mut simulation = Simulation::new(&scene).unwrap();
        while simulation.time() < scene.duration_s() {
            let outcome = simulation.step_observed(&mut stepped).unwrap();
            assert_eq!(outcome.t_s, simulation.time());
        }
        simulation.run_observed(&mut stepped).unwrap();
        assert_eq!(bits(&whole), bits(&stepped));
        let mut cut = Recorder::default();
        let mut simulation = Simulation::new(&scene).unwrap();
        for k in 1..=97 {
            let t = scene.duration_s() * (f64::from(k) / 97.0);
            simulation.advance_to_observed(t, &mut cut).unwrap();
            assert_eq!(simulation.time(), t);
        }
        assert_eq!(bits(&whole), bits(&cut));
    }
}

/// A time in the past, or one that is not a number, is refused, and nothing has changed.
#[test]
fn times_in_the_past_are_refused() {
    let scene = pile().build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(0.2).unwrap();
    for t in [0.1, f64::NAN, f64::INFINITY, -1.0] {
        let refused = simulation.advance_to(t);
        assert!(matches!(refused, Err(SimulationError::TimeInThePast { .. })), "{t}");
        assert_eq!(simulation.time(), 0.2);
    }
}

/// A body that neither touches the others nor acts on them changes no bit of their motion, at any place in the list of
/// bodies and whatever happens to it.
#[test]
fn an_unrelated_body_changes_no_bit() {
    let mut alone = Recorder::default();
    Simulation::new(&pile().build().unwrap()).unwrap().run_observed(&mut alone).unwrap();
    let far = DVec3::new(30.0, 0.0, 0.2);
    let other = ball("other", 1.0, 0.1, far, DVec3::new(3.0, 0.0, -2.0)).material(elastic(0.9));
    let mut together = Recorder::default();
    let scene = pile().body(other).build().unwrap();
    Simulation::new(&scene).unwrap().run_observed(&mut together).unwrap();
    assert!(together.events.iter().any(|event| event.body_b == Some(BodyId::new(4)) || event.body_a == BodyId::new(4)));
    together.samples.iter_mut().for_each(|row| row.truncate(4));
    together.events.retain(|event| event.body_a != BodyId::new(4) && event.body_b != Some(BodyId::new(4)));
    assert_eq!(bits(&alone), bits(&together));
}

/// Two piles side by side move as each would alone, whichever comes first: islands have no order.
#[test]
fn the_order_of_islands_changes_no_bit() {
    let size = DVec3::new(0.4, 0.3, 0.2);
    let bodies = |shift: f64, number: usize| {
        let at = DVec3::X * shift;
        [
            brick(&format!("low{number}"), size, at + DVec3::new(0.0, 0.0, 0.15)).material(elastic(0.3)),
            brick(&format!("high{number}"), size, at + DVec3::new(0.13, 0.05, 0.45)).material(elastic(0.3)),
        ]
    };
    let run = |order: [usize; 2]| {
        let mut builder =
            Scene::builder("piles").duration_s(0.6).method(accurate()).body(floor().material(elastic(0.3)));
        for pile in order {
            for body in bodies(8.0 * pile as f64, pile) {
                builder = builder.body(body);
            }
        }
        let report = Simulation::new(&builder.build().unwrap()).unwrap().run().unwrap();
        let mut found: Vec<_> =
            report.bodies.iter().map(|body| (body.name.clone(), format!("{:?}", body.state))).collect();
        found.sort();
        found
    };
    assert_eq!(run([0, 1]), run([1, 0]));
}

/// A thrust equal to the weight of a ball holds it where it is and does no work; without it the ball falls.
#[test]
fn a_force_that_is_set_holds_until_it_is_set_again() {
    let scene = Scene::builder("hover").duration_s(2.0).body(ball("ball", 2.0, 0.1, DVec3::Z, DVec3::ZERO));
    let scene = scene.method(accurate()).body(floor()).build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    let ball = simulation.body_id("ball").unwrap();
    simulation.set_force(ball, DVec3::Z * 2.0 * 9.81, DVec3::ZERO).unwrap();
    simulation.advance_to(1.0).unwrap();
    assert!((simulation.body(ball).pose.translation - DVec3::Z).length() < 1e-12);
    simulation.set_force(ball, DVec3::ZERO, DVec3::ZERO).unwrap();
    simulation.advance_to(1.25).unwrap();
    let fallen = 1.0 - simulation.body(ball).pose.translation.z;
    assert!((fallen - 0.5 * 9.81 * 0.0625).abs() < 1e-12, "{fallen}");
    closes(&mut simulation);
}

/// A force on a resting box wakes it; the box slides with the acceleration F/m.
#[test]
fn a_force_wakes_what_rests() {
    let scene = Scene::builder("push").duration_s(1.0).method(accurate()).body(floor());
    let scene = scene.body(brick("box", DVec3::splat(0.2), DVec3::Z * 0.1)).build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    let id = simulation.body_id("box").unwrap();
    simulation.advance_to(0.5).unwrap();
    assert_eq!(simulation.body(id).velocity, Velocity::ZERO);
    simulation.set_force(id, DVec3::X * 3.0, DVec3::ZERO).unwrap();
    simulation.advance_to(0.9).unwrap();
    let velocity = simulation.body(id).velocity.linear;
    assert!((velocity - DVec3::X * 3.0 * 0.4).length() < 1e-11, "{velocity}");
    let found: f64 = simulation.contacts().iter().map(|contact| contact.normal_force_n).sum();
    assert!((found - 9.81).abs() < 1e-9, "{found}");
    closes(&mut simulation);
}

/// An impulse changes the momenta as mechanics says, and the ledger books its work `J.(v- + v+)/2`.
#[test]
fn an_impulse_is_given_at_its_point() {
    let scene = Scene::builder("kick").gravity(DVec3::ZERO).duration_s(1.0).method(accurate());
    let scene = scene.body(ball("ball", 2.0, 0.5, DVec3::ZERO, DVec3::X)).build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    let ball = simulation.body_id("ball").unwrap();
    simulation.advance_to(0.25).unwrap();
    let before = (simulation.body(ball), simulation.momentum(), simulation.energy());
    let (impulse, arm) = (DVec3::new(0.3, -1.0, 0.2), DVec3::new(0.1, 0.2, 0.4));
    simulation.apply_impulse(ball, impulse, before.0.pose.translation + arm).unwrap();
    let after = (simulation.body(ball), simulation.momentum(), simulation.energy());
    assert!((after.0.velocity.linear - before.0.velocity.linear - impulse / 2.0).length() < 1e-15);
    let turned = arm.cross(impulse) / (0.4 * 2.0 * 0.25);
    assert!((after.0.velocity.angular - turned).length() < 1e-14);
    assert!((after.1.linear - before.1.linear - impulse).length() < 1e-14);
    let speed = |sample: &polhode::BodySample| sample.velocity.linear + sample.velocity.angular.cross(arm);
    let work = 0.5 * impulse.dot(speed(&before.0) + speed(&after.0));
    assert!((after.2.kinetic_j - before.2.kinetic_j - work).abs() < 1e-14);
    let report = simulation.run().unwrap();
    assert!((report.ledger.external.value() - work).abs() < 1e-14);
    assert!((report.ledger.momentum.program.value().linear - impulse).length() < 1e-14);
    assert!(report.ledger.closure_relative() < 1e-12);
}

/// A body whose pose is set moves on from there with its velocity. A pose at which it would overlap another body is
/// refused.
#[test]
fn a_pose_is_set_where_there_is_room() {
    let scene = Scene::builder("put").duration_s(1.0).method(accurate()).body(floor());
    let scene = scene.body(brick("low", DVec3::splat(0.2), DVec3::Z * 0.1));
    let scene = scene.body(ball("ball", 1.0, 0.1, DVec3::Z * 2.0, DVec3::ZERO)).build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    let ball = simulation.body_id("ball").unwrap();
    simulation.advance_to(0.1).unwrap();
    let before = simulation.body(ball);
    let refused = simulation.set_pose(ball, Pose::from_translation(DVec3::Z * 0.25));
    assert!(matches!(refused, Err(SimulationError::Action(ActionError::Overlap { .. }))), "{refused:?}");
    assert_eq!(simulation.body(ball), before);
    simulation.set_pose(ball, Pose::from_translation(DVec3::Z * 0.4)).unwrap();
    assert_eq!(simulation.body(ball).velocity, before.velocity);
    // The body that is placed in touch with the brick strikes it at once: without restitution both rest.
    simulation.set_pose(ball, Pose::from_translation(DVec3::Z * 0.3)).unwrap();
    assert_eq!(simulation.body(ball).velocity, Velocity::ZERO);
    simulation.advance_to(0.6).unwrap();
    assert_eq!(simulation.body(ball).velocity, Velocity::ZERO);
    assert!((simulation.body(ball).pose.translation.z - 0.3).abs() < 1e-12);
    closes(&mut simulation);
}

/// A brick added on a stack rests there, and the brick above a removed one falls. Handles remain those of their bodies.
#[test]
fn bodies_come_and_go() {
    let size = DVec3::splat(0.2);
    let scene = Scene::builder("stack").duration_s(1.0).method(accurate()).body(floor());
    let scene = scene.body(brick("first", size, DVec3::Z * 0.1)).build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(0.1).unwrap();
    let second = simulation.add_body(brick("second", size, DVec3::Z * 0.3)).unwrap();
    assert_eq!(simulation.body_id("second"), Some(second));
    let refused = simulation.add_body(brick("third", size, DVec3::Z * 0.35));
    assert!(matches!(refused, Err(SimulationError::Action(ActionError::Overlap { .. }))), "{refused:?}");
    assert!(simulation.add_body(brick("second", size, DVec3::Z * 5.0)).is_err());
    simulation.advance_to(0.4).unwrap();
    assert_eq!(simulation.body(second).velocity, Velocity::ZERO);
    let first = simulation.body_id("first").unwrap();
    simulation.remove_body(first).unwrap();
    assert!(matches!(simulation.remove_body(first), Err(SimulationError::Action(ActionError::RemovedBody(_)))));
    assert!(simulation.set_force(first, DVec3::X, DVec3::ZERO).is_err());
    assert_eq!(simulation.body_id("first"), None);
    simulation.advance_to(0.5).unwrap();
    let fallen = 0.3 - simulation.body(second).pose.translation.z;
    assert!((fallen - 0.5 * 9.81 * 0.01).abs() < 1e-12, "{fallen}");
    closes(&mut simulation);
}

/// Numbers that are not finite and handles of other simulations are refused.
#[test]
fn bad_actions_are_refused_and_change_nothing() {
    let scene = pile().build().unwrap();
    let mut recorder = Recorder::default();
    Simulation::new(&scene).unwrap().run_observed(&mut recorder).unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    let (low, base) = (simulation.body_id("low").unwrap(), simulation.body_id("floor").unwrap());
    let mut again = Recorder::default();
    simulation.advance_to_observed(0.3, &mut again).unwrap();
    let nan = DVec3::new(0.0, f64::NAN, 0.0);
    assert!(simulation.set_force(low, nan, DVec3::ZERO).is_err());
    assert!(simulation.set_force(base, DVec3::X, DVec3::ZERO).is_err());
    assert!(simulation.apply_impulse(low, DVec3::X, nan).is_err());
    assert!(simulation.set_velocity(low, Velocity::new(nan, DVec3::ZERO)).is_err());
    assert!(simulation.set_pose(low, Pose::from_translation(nan)).is_err());
    assert!(simulation.set_pose(base, Pose::IDENTITY).is_err());
    simulation.run_observed(&mut again).unwrap();
    assert_eq!(bits(&recorder), bits(&again));
}

/// A push out of the plane of a planar motion ends the planar reduction: the plan says so, and the motion is that in
/// space.
#[test]
fn an_action_that_leaves_the_plane_ends_planar_motion() {
    let scene = Scene::builder("plane").duration_s(0.5).method(accurate()).body(floor().material(elastic(0.5)));
    let scene = scene.body(brick("box", DVec3::splat(0.2), DVec3::Z * 0.3).material(elastic(0.5))).build().unwrap();
    let run = |effects| {
        let mut simulation = Simulation::with_effects(&scene, effects).unwrap();
        let id = simulation.body_id("box").unwrap();
        simulation.advance_to(0.1).unwrap();
        let place = simulation.body(id).pose.translation;
        simulation.apply_impulse(id, DVec3::new(0.01, 0.02, 0.0), place + DVec3::new(0.03, 0.02, 0.01)).unwrap();
        let report = simulation.run().unwrap();
        (simulation.body(id), report)
    };
    let (planned, report) = run(Effects::Planned);
    let (space, _) = run(Effects::All);
    assert!((planned.pose.translation - space.pose.translation).length() < 1e-11);
    assert_eq!(report.plan_changes.len(), 1);
    assert!(report.plan_changes[0].changes.iter().any(|change| change.contains("planar motion off")), "{report:?}");
}
