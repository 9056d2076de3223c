//! Limits of joints are stops: bodies strike them with their restitution, rest against them and leave them as closed
//! forms say, and ropes hold what hangs on them only while they are taut. Stops conserve what contacts conserve.

use crate::checks::assert_closes;
use crate::joints::{assert_held, down, inertia, integrate, rod};
use crate::support::{accurate, ball, brick, run};
use polhode::dynamics::System;
use polhode::scene::{Coordinate, Joint, JointKind, Limits, LimitsError, Method, SceneError, Tier};
use polhode::spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};
use polhode::{
    ActionError, Body, BodyId, Effects, EventKind, Scene, SceneBuilder, Simulation, SimulationError, Snapshot,
};

const G: f64 = 9.81;

fn stepped(step_s: f64) -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(step_s), ..Method::default() }
}

fn limits(lower: f64, upper: f64, restitution: f64) -> Limits {
    Limits::new(lower, upper).unwrap().with_restitution(restitution).unwrap()
}

fn scene(name: &str, method: Method) -> SceneBuilder {
    Scene::builder(name).method(method).gravity(DVec3::ZERO)
}

/// A slider of the only body with the world.
fn slider(axis: UnitVector, range: Limits) -> Joint {
    Joint::new(JointKind::Slider { axis }, BodyId::new(0), DVec3::ZERO).with_limits(Coordinate::Displacement, range)
}

/// Between two elastic stops a slider goes to and fro for ever, without a loss, whichever way its axis points.
#[test]
fn a_slider_goes_to_and_fro_between_elastic_stops() {
    let (speed, near, far, duration) = (3.0, -0.2, 0.5, 2.0);
    for (method, exact) in [(accurate(), 1e-12), (stepped(1e-2), 1e-9)] {
        for along in [DVec3::X, DVec3::new(-0.3, 0.8, 0.2)] {
            let axis = UnitVector::new(along).unwrap();
            let velocity = Velocity::new(axis.get() * speed, DVec3::ZERO);
            let body = brick("bead", DVec3::new(0.1, 0.05, 0.02), DVec3::ZERO).velocity(velocity);
            let joint = slider(axis, limits(near, far, 1.0));
            let built = scene("bead", method.clone()).duration_s(duration).body(body).joint(joint).build().unwrap();
            let (report, recorder) = run(&built, Effects::Planned);
            let range = far - near;
            for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
                let phase = (speed * t - near) % (2.0 * range);
                let place = near + if phase < range { phase } else { 2.0 * range - phase };
                let off = (row[0].pose.translation - axis.get() * place).length();
                assert!(off < exact, "t = {t}: {off:e} m off");
            }
            assert!(recorder.events.iter().filter(|event| event.kind == EventKind::Impact).count() >= 8);
            assert_closes(&report);
        }
    }
}

/// A body on a vertical slider bounces on its lower stop as a ball does on a floor,
/// `t_n = t_1 + 2 v/g (e + e^2 + ...)`, and comes to rest on it.
#[test]
fn a_slider_bounces_on_its_stop_and_comes_to_rest() {
    let (height, e) = (0.4, 0.5);
    let body = brick("bead", DVec3::splat(0.05), DVec3::ZERO);
    for upwards in [false, true] {
        let (axis, range) = if upwards { (UnitVector::Z, (-height, 1.0)) } else { (-UnitVector::Z, (-1.0, height)) };
        let joint = slider(axis, limits(range.0, range.1, e));
        let built = scene("bead", accurate()).gravity(DVec3::Z * -G).duration_s(2.0).body(body.clone()).joint(joint);
        let (report, recorder) = run(&built.build().unwrap(), Effects::Planned);
        let impacts: Vec<f64> =
            recorder.events.iter().filter(|event| event.kind == EventKind::Impact).map(|event| event.t_s).collect();
        let fall = (2.0 * height / G).sqrt();
        for (number, &t) in impacts.iter().take(12).enumerate() {
            let bounces: f64 = (1..=number).map(|k| e.powi(k as i32)).sum();
            assert!((t - fall * (1.0 + 2.0 * bounces)).abs() < 1e-10, "impact {number} at {t}");
        }
        assert!(impacts.len() > 12);
        let rest = recorder.events.iter().find(|event| event.kind == EventKind::Rest).expect("it comes to rest");
        assert!((rest.t_s - 3.0 * fall).abs() < 1e-8, "{rest:?}");
        assert!((report.bodies[0].state.pose.translation - DVec3::Z * -height).length() < 1e-12);
        assert_closes(&report);
    }
}

/// A level rod on a hinge falls onto a stop: it arrives with the energy of its fall, loses `1 - e^2` of it, and the
/// stop holds it in the end by the moment of its weight.
#[test]
fn a_pendulum_strikes_its_stop_with_the_energy_of_its_fall() {
    let (own, stop, e) = ((1.3, 0.6), 0.7, 0.4);
    for (axis, range) in [(UnitVector::Y, (-1.0, stop)), (-UnitVector::Y, (-stop, 1.0))] {
        let body = rod("rod", own, DVec3::X * (0.5 * own.1), std::f64::consts::FRAC_PI_2);
        let joint =
            Joint::hinge(BodyId::new(0), DVec3::ZERO, axis).with_limits(Coordinate::Angle, limits(range.0, range.1, e));
        let built = scene("pendulum", accurate()).gravity(DVec3::Z * -G).duration_s(2.5).body(body).joint(joint);
        let (report, recorder) = run(&built.build().unwrap(), Effects::Planned);
        let fallen = own.0 * G * 0.5 * own.1 * stop.sin();
        let first = recorder.events.iter().find(|event| event.kind == EventKind::Impact).expect("it strikes");
        let lost = -(1.0 - e * e) * fallen;
        assert!((first.energy_change_j / lost - 1.0).abs() < 1e-11, "{first:?}, {lost}");
        let last = &report.bodies[0].state;
        let rests_at = DVec3::new(stop.cos(), 0.0, -stop.sin()) * (0.5 * own.1);
        assert!((last.pose.translation - rests_at).length() < 1e-11, "{last:?}");
        assert_eq!(last.velocity.linear, DVec3::ZERO);
        assert!((report.ledger.impact.value() + report.ledger.rest.value() - fallen).abs() < 1e-10 * fallen);
        assert_closes(&report);
    }
}

/// Two bodies on a hinge in free space strike their elastic stops again and again: momentum, angular momentum and
/// energy stay, and the angle keeps within its range. Which of the two is named first does not matter.
#[test]
fn stops_between_two_bodies_conserve_momentum_and_energy() {
    let at = |first: usize, second: usize| {
        let center = [DVec3::new(-0.2, 0.0, 0.0), DVec3::new(0.3, 0.0, 0.0)];
        let spin = [DVec3::Z * 4.0, DVec3::Z * -3.0];
        let bodies = [0, 1].map(|k| {
            let size = DVec3::new(2.0 * center[k].x.abs(), 0.1, 0.07);
            let velocity = Velocity::new(spin[k].cross(center[k]) + DVec3::new(0.1, -0.2, 0.3), spin[k]);
            brick(["left", "right"][k], size, center[k]).velocity(velocity)
        });
        let axis = if first == 0 { UnitVector::Z } else { -UnitVector::Z };
        // The angle of the first about the axis relative to the second is the same either way.
        let range = (-0.3, 0.4);
        let joint = Joint::hinge(BodyId::new(first), DVec3::ZERO, axis)
            .with(BodyId::new(second))
            .with_limits(Coordinate::Angle, limits(range.0, range.1, 1.0));
        let [left, right] = bodies;
        let built = scene("scissors", accurate()).duration_s(3.0).body(left).body(right).joint(joint).build().unwrap();
        run(&built, Effects::Planned)
    };
    let (report, recorder) = at(0, 1);
    let (_, other) = at(1, 0);
    let mut extremes = (0.0_f64, 0.0_f64);
    for (row, same) in recorder.samples.iter().zip(&other.samples) {
        let [a, b] = [0, 1].map(|k| row[k].pose.rotation);
        let angle = (b.inverse() * a).to_rotation_vector().z;
        extremes = (extremes.0.min(angle), extremes.1.max(angle));
        assert!((row[0].pose.translation - same[0].pose.translation).length() < 1e-10);
    }
    assert!(extremes.0 > -0.3 - 1e-11 && extremes.0 < -0.2, "{extremes:?}");
    assert!(extremes.1 < 0.4 + 1e-11 && extremes.1 > 0.3, "{extremes:?}");
    assert!(recorder.events.iter().filter(|event| event.kind == EventKind::Impact).count() > 10);
    assert_held(&report);
    assert!(
        ((report.energy.kinetic_j + report.energy.potential_j) / report.energy.initial_j - 1.0).abs() < 1e-11,
        "{:?}",
        report.energy
    );
}

/// The equation of a pendulum of a point: its angle from down, its rate.
struct PointPendulum {
    length: f64,
}

impl System for PointPendulum {
    type Error = std::convert::Infallible;

    fn dimension(&self) -> usize {
        2
    }

    fn derivative(&mut self, _t: f64, state: &[f64], rates: &mut [f64]) -> Result<(), Self::Error> {
        rates.copy_from_slice(&[state[1], -G / self.length * state[0].sin()]);
        Ok(())
    }
}

/// A ball on a rope falls freely until the rope is taut, loses its velocity along the rope, and then swings on it as on
/// a rod of that length.
#[test]
fn a_rope_holds_only_while_it_is_taut() {
    let (offset, length, duration) = (0.5, 0.8, 1.3);
    let body = ball("ball", 0.7, 0.05, DVec3::X * offset, DVec3::ZERO);
    let joint = Joint::rope(BodyId::new(0), DVec3::X * offset, DVec3::ZERO, length).unwrap();
    let built = scene("rope", accurate()).gravity(DVec3::Z * -G).duration_s(duration).body(body).joint(joint);
    let (report, recorder) = run(&built.build().unwrap(), Effects::Planned);
    let drop = (length * length - offset * offset).sqrt();
    let taut = (2.0 * drop / G).sqrt();
    let first = recorder.events.iter().find(|event| event.kind == EventKind::Impact).expect("it becomes taut");
    assert!((first.t_s - taut).abs() < 1e-12, "{first:?}");
    let along = G * taut * drop / length;
    assert!((first.energy_change_j + 0.35 * along * along).abs() < 1e-11, "{first:?}");
    let mut swing = vec![(offset / drop).atan(), -G * taut * offset / length / length];
    integrate(&mut PointPendulum { length }, duration - taut, &mut swing);
    let off = (report.bodies[0].state.pose.translation - down(swing[0]) * length).length();
    assert!(off < 1e-10, "{off:e} m off");
    assert_closes(&report);
}

/// Two balls in free space on a slack elastic rope: when it becomes taut they exchange momentum, and energy and angular
/// momentum stay.
#[test]
fn an_elastic_rope_between_two_bodies_conserves() {
    let bodies = [
        ball("first", 1.0, 0.1, DVec3::ZERO, DVec3::new(-0.5, 0.2, 0.0)),
        ball("second", 3.0, 0.1, DVec3::X * 0.5, DVec3::new(0.4, 0.0, 0.3)),
    ];
    let range = limits(0.0, 0.8, 1.0);
    let joint = Joint::new(JointKind::Rope { to: DVec3::X * 0.4 }, BodyId::new(0), DVec3::X * 0.1)
        .with(BodyId::new(1))
        .with_limits(Coordinate::Distance, range);
    let [first, second] = bodies;
    let built = scene("rope", accurate()).duration_s(3.0).body(first).body(second).joint(joint).build().unwrap();
    let (report, recorder) = run(&built, Effects::Planned);
    let longest = recorder.samples.iter().map(|row| {
        let end = |k: usize, arm: DVec3| row[k].pose.transform_point(arm);
        (end(0, DVec3::X * 0.1) - end(1, DVec3::X * -0.1)).length()
    });
    let longest = longest.fold(0.0, f64::max);
    assert!(longest < 0.8 + 1e-10 && longest > 0.7, "{longest}");
    assert!(recorder.events.iter().any(|event| event.kind == EventKind::Impact));
    assert!(
        ((report.energy.kinetic_j + report.energy.potential_j) / report.energy.initial_j - 1.0).abs() < 1e-12,
        "{:?}",
        report.energy
    );
    assert_closes(&report);
}

/// A ball on a rod without mass is a pendulum; so it is in tier `stepped`, to the second order of its step.
#[test]
fn a_rod_without_mass_makes_a_pendulum() {
    let (length, start, duration) = (0.9, 1.1, 2.0);
    let mut swing = vec![start, 0.0];
    integrate(&mut PointPendulum { length }, duration, &mut swing);
    for (method, allowed) in [(accurate(), 1e-10), (stepped(1e-3), 1e-5)] {
        let place = down(start) * length;
        let body = ball("bob", 2.0, 0.05, place, DVec3::ZERO);
        let joint = Joint::new(JointKind::Rod { to: DVec3::ZERO }, BodyId::new(0), place);
        let built = scene("rod", method).gravity(DVec3::Z * -G).duration_s(duration).body(body).joint(joint);
        let (report, _) = run(&built.build().unwrap(), Effects::Planned);
        let off = (report.bodies[0].state.pose.translation - down(swing[0]) * length).length();
        assert!(off < allowed, "{off:e} m off");
    }
}

/// A kinematic arm swings a rod that lies against its stop: while the arm speeds up the stop pushes the rod along.
#[test]
fn a_stop_on_a_kinematic_body_drives() {
    use polhode::scene::PrescribedMotion;
    let turning = Velocity::new(DVec3::ZERO, DVec3::Z * 2.0);
    let arm = Body::kinematic("arm", PrescribedMotion::constant_velocity(turning).unwrap());
    let own = (1.0, 0.4);
    let body = Body::movable("rod", *rod("rod", own, DVec3::ZERO, 0.0).mass_properties().unwrap())
        .pose(Pose::new(Rotation::from_rotation_vector(DVec3::Y * std::f64::consts::FRAC_PI_2), DVec3::X * 0.2));
    let joint = Joint::hinge(BodyId::new(1), DVec3::ZERO, UnitVector::Z)
        .with(BodyId::new(0))
        .with_limits(Coordinate::Angle, limits(-0.25, 0.5, 0.0));
    let built = scene("arm", accurate()).duration_s(1.0).body(arm).body(body).joint(joint).build().unwrap();
    let (report, recorder) = run(&built, Effects::Planned);
    // The arm turns for 0.25 rad until the stop meets the rod, which then turns with it at 2 rad/s.
    let first = recorder.events.iter().find(|event| event.kind == EventKind::Impact).expect("it meets the stop");
    assert!((first.t_s - 0.125).abs() < 1e-12, "{first:?}");
    let angle: f64 = 2.0 * (1.0 - 0.125);
    let place = DVec3::new(angle.cos(), angle.sin(), 0.0) * 0.2;
    assert!((report.bodies[1].state.pose.translation - place).length() < 1e-11);
    let moment = inertia(own) + own.0 * 0.04;
    assert!((report.ledger.external.value().abs() - moment * 4.0).abs() < 1e-10, "{:?}", report.ledger);
    assert_closes(&report);
}

/// A simulation that is restored from a snapshot while a rod rests against its stop goes on with the same bits.
#[test]
fn a_snapshot_keeps_stops() {
    for method in [accurate(), stepped(1e-2)] {
        let body = rod("rod", (1.0, 0.5), DVec3::X * 0.25, std::f64::consts::FRAC_PI_2);
        let joint = Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Y)
            .with_limits(Coordinate::Angle, limits(-0.2, 0.4, 0.3));
        let built = scene("rod", method.clone())
            .gravity(DVec3::Z * -G)
            .duration_s(1.0)
            .body(body)
            .joint(joint)
            .build()
            .unwrap();
        for t in [0.31, 0.42, 0.77] {
            let mut whole = Simulation::new(&built).unwrap();
            whole.advance_to(t).unwrap();
            let snapshot = Snapshot::from_bytes(&whole.snapshot().to_bytes()).unwrap();
            let mut restored = Simulation::new(&built).unwrap();
            restored.restore(&snapshot).unwrap();
            assert_eq!(restored.snapshot().to_bytes(), snapshot.to_bytes());
            for simulation in [&mut whole, &mut restored] {
                simulation.advance_to(0.9).unwrap();
            }
            assert_eq!(restored.snapshot().to_bytes(), whole.snapshot().to_bytes());
        }
    }
}

/// What limits cannot be is refused with a reason.
#[test]
fn limits_that_no_joint_can_have_are_refused() {
    assert_eq!(Limits::new(1.0, 1.0), Err(LimitsError::Order { lower: 1.0, upper: 1.0 }));
    assert!(Limits::new(f64::NAN, 1.0).is_err() && Limits::new(0.0, f64::NAN).is_err());
    assert_eq!(Limits::new(0.0, 1.0).unwrap().with_restitution(1.5), Err(LimitsError::Restitution(1.5)));
    let refused = |joint: Joint| {
        let body = brick("body", DVec3::splat(0.1), DVec3::ZERO);
        scene("refused", accurate()).body(body).joint(joint).build().expect_err("it is refused")
    };
    let hinge =
        |range: Limits| Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Z).with_limits(Coordinate::Angle, range);
    assert!(matches!(
        refused(hinge(limits(0.1, 0.5, 0.0))),
        SceneError::JointBeyondLimits { number: 0, lower: 0.1, .. }
    ));
    assert!(matches!(refused(hinge(limits(-4.0, 4.0, 0.0))), SceneError::Joint { number: 0, .. }));
    assert!(matches!(refused(hinge(limits(f64::NEG_INFINITY, 4.0, 0.0))), SceneError::Joint { number: 0, .. }));
    let ball = Joint::ball(BodyId::new(0), DVec3::ZERO).with_limits(Coordinate::Angle, limits(-1.0, 1.0, 0.0));
    assert!(matches!(refused(ball), SceneError::Joint { number: 0, .. }));
    let rope = Joint::rope(BodyId::new(0), DVec3::ZERO, DVec3::X, 0.5).unwrap();
    assert!(matches!(refused(rope), SceneError::JointBeyondLimits { start: 1.0, upper: 0.5, .. }));
    assert!(matches!(
        refused(Joint::new(JointKind::Rope { to: DVec3::X }, BodyId::new(0), DVec3::ZERO)),
        SceneError::Joint { .. }
    ));
    assert!(matches!(
        refused(Joint::new(JointKind::Rod { to: DVec3::ZERO }, BodyId::new(0), DVec3::ZERO)),
        SceneError::Joint { .. }
    ));
}

/// A program may put a jointed body anywhere within its limits, and nowhere beyond.
#[test]
fn a_pose_beyond_a_limit_is_refused() {
    let body = brick("bead", DVec3::splat(0.1), DVec3::ZERO);
    let built =
        scene("bead", accurate()).body(body).joint(slider(UnitVector::X, limits(-0.2, 0.5, 0.0))).build().unwrap();
    let mut simulation = Simulation::new(&built).unwrap();
    let mut put = |x: f64| simulation.set_pose(BodyId::new(0), Pose::from_translation(DVec3::X * x));
    assert!(put(0.4).is_ok() && put(-0.2).is_ok());
    assert!(matches!(put(0.6), Err(SimulationError::Action(ActionError::BeyondLimits(_)))));
}

/// A flap that swings between elastic limits of its hinge keeps its energy in time steps, though the hinge bends its
/// way: what a step is wrong by in the time of an impact takes nothing.
#[test]
fn a_flap_swings_between_elastic_limits_without_a_loss() {
    for (rate, step_s) in [(2.0, 1e-2), (10.0, 1e-3)] {
        let body = brick("flap", DVec3::new(0.8, 0.1, 0.1), DVec3::X * 0.4);
        let body = body.velocity(Velocity::new(DVec3::Y * (0.4 * rate), DVec3::Z * rate));
        let hinge = Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Z);
        let hinge = hinge.with_limits(Coordinate::Angle, limits(-0.1, 3.0, 1.0));
        let built = scene("flap", stepped(step_s)).duration_s(31.0 / rate).body(body).joint(hinge).build().unwrap();
        let (report, recorder) = run(&built, Effects::Planned);
        let lost = 1.0 - report.energy.final_j / report.energy.initial_j;
        // What is left is of the projection of the hinge, which the same flap without limits loses, too.
        assert!(lost.abs() < 1e-5, "{lost:e} of the energy");
        assert!(report.ledger.impact.value().abs() < 1e-9 * report.energy.initial_j, "{:?}", report.ledger);
        let impacts = recorder.events.iter().filter(|event| event.kind == EventKind::Impact).count();
        assert!((9..=11).contains(&impacts), "{impacts} impacts");
        assert_closes(&report);
    }
}
