//! Gears: wheels in mesh, rack and pinion, a rope over a pulley and a planetary gear move as Newton's law with the
//! ratio says; their forces do no work together; the angles keep their ratio to rounding through many revolutions,
//! whatever the ratio; a run goes on from a snapshot with the same bits; and what cannot be a gear is refused.

use crate::checks::assert_closes;
use crate::support::{accurate, run};
use polhode::mesh::solid_box;
use polhode::scene::{
    Coordinate, Drive, Force, Frame, Freedom, Gear, GearError, Joint, JointKind, Limits, Method, Motor, SceneError,
    Signal, Tier,
};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, UnitVector, Velocity};
use polhode::{Body, Effects, JointId, RunReport, Scene, SceneBuilder, Simulation, Snapshot};
use std::f64::consts::TAU;

const G: f64 = 9.81;

fn stepped() -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(2e-3), ..Method::default() }
}

/// A wheel of 1 kg with this moment about z, which spins about it.
fn wheel(name: &str, moment: f64, place: DVec3, rate: f64) -> Body {
    let inertia = Inertia::from_diagonal(DVec3::new(0.6 * moment, 0.6 * moment, moment)).unwrap();
    let properties = MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia);
    let velocity = Velocity::new(DVec3::ZERO, DVec3::Z * rate);
    Body::movable(name, properties).pose(Pose::from_translation(place)).velocity(velocity)
}

fn block(name: &str, mass: f64, place: DVec3) -> Body {
    let properties = solid_box(DVec3::splat(0.1), Mass::new(mass).unwrap()).unwrap();
    Body::movable(name, properties).pose(Pose::from_translation(place))
}

/// The gear neither gives nor takes energy; of what an integrator and projections leave, little.
#[track_caller]
fn assert_no_work(report: &RunReport) {
    assert_closes(report);
    let ledger = &report.ledger;
    let left = ledger.numerical.value().abs() + ledger.projection.value().abs();
    assert!(left < 1e-12 * ledger.scale_j, "{ledger:?}");
}

/// Two wheels on the world, the first one with a motor, and the gear between them.
fn train(method: Method, ratio: f64, effort: f64, rate: f64) -> SceneBuilder {
    let mut scene = Scene::builder("train").method(method).gravity(DVec3::ZERO);
    let first = scene.add_body(wheel("first", 0.2, DVec3::ZERO, ratio * rate));
    let second = scene.add_body(wheel("second", 0.5, DVec3::X, rate));
    let motor = Motor::new(Drive::Effort(effort)).unwrap();
    let motor = Freedom::default().with_motor(motor);
    let first = scene.add_joint(Joint::hinge(first, DVec3::ZERO, UnitVector::Z).along(Coordinate::Angle, motor));
    let second = scene.add_joint(Joint::hinge(second, DVec3::X, UnitVector::Z));
    scene.gear(Gear::new(first, second, ratio).unwrap())
}

/// A torque on the first wheel accelerates both: `a_1 = T / (I_1 + I_2/r^2)`.
#[test]
fn a_train_of_wheels_has_the_inertia_of_both() {
    for method in [accurate(), stepped()] {
        for ratio in [-2.5, 0.3] {
            let (report, recorder) =
                run(&train(method.clone(), ratio, 0.7, 0.0).duration_s(1.0).build().unwrap(), Effects::Planned);
            let acceleration = 0.7 / (0.2 + 0.5 / (ratio * ratio));
            for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
                let off = (row[0].velocity.angular.z - acceleration * t).abs();
                let apart = (row[0].velocity.angular.z - ratio * row[1].velocity.angular.z).abs();
                assert!(off < 1e-11 && apart < 1e-12, "ratio {ratio}, t = {t}: {off:e} {apart:e}");
            }
            assert_no_work(&report);
        }
    }
}

/// Hundreds of revolutions: the angles keep their ratio.
#[test]
fn angles_keep_their_ratio_through_many_revolutions() {
    // The first ratio is not a fraction of small numbers: which revolution a wheel is in matters.
    for (ratio, revolutions, method) in [(0.123_456_789_012_345, 200.0, accurate()), (-7.0 / 3.0, 50.0, stepped())] {
        let rate = 60.0;
        let duration_s = revolutions * TAU / rate;
        let scene = train(method, ratio, 0.0, rate).duration_s(duration_s).output_interval_s(0.02).build().unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let mut turned = [0.0_f64; 2];
        let mut worst = 0.0_f64;
        for row in &recorder.samples {
            for (turned, body) in turned.iter_mut().zip(row) {
                let along = body.pose.rotation.rotate(DVec3::X);
                let within = along.y.atan2(along.x);
                *turned = within + TAU * ((*turned - within) / TAU).round();
            }
            worst = worst.max((turned[0] - ratio * turned[1]).abs());
        }
        assert!((turned[1] / TAU - revolutions).abs() < 1e-6, "{}", turned[1] / TAU);
        // What is left is the rounding of the unwound angles here: some units of 6283 rad.
        assert!(worst < 4e-12, "ratio {ratio}: {worst:e} rad apart");
        assert_closes(&report);
    }
}

/// Rack and pinion: a torque on the pinion of radius `r` moves the rack, `a = (T/r) / (m + I/r^2)`; and a rack that
/// falls turns it.
#[test]
fn a_pinion_moves_a_rack() {
    let radius = 0.1;
    for method in [accurate(), stepped()] {
        let mut scene = Scene::builder("rack").method(method).gravity(DVec3::new(0.0, -G, 0.0)).duration_s(2.0);
        let pinion = scene.add_body(wheel("pinion", 0.004, DVec3::ZERO, 0.0));
        let rack = scene.add_body(block("rack", 2.0, DVec3::new(radius, 0.0, 0.0)));
        let motor = Freedom::default().with_motor(Motor::new(Drive::Effort(0.5)).unwrap());
        let hinge = scene.add_joint(Joint::hinge(pinion, DVec3::ZERO, UnitVector::Z).along(Coordinate::Angle, motor));
        let slider = JointKind::Slider { axis: UnitVector::Y };
        let slider = scene.add_joint(Joint::new(slider, rack, DVec3::new(radius, 0.0, 0.0)));
        let scene = scene.gear(Gear::new(slider, hinge, radius).unwrap()).no_contact([pinion, rack]);
        let (report, recorder) = run(&scene.build().unwrap(), Effects::Planned);
        let acceleration = (0.5 / radius - 2.0 * G) / (2.0 + 0.004 / (radius * radius));
        for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
            let off = (row[1].pose.translation.y - 0.5 * acceleration * t * t).abs();
            assert!(off < 1e-11, "t = {t}: {off:e} m off");
        }
        // The pinion turned by more than ten revolutions.
        assert!(recorder.samples.last().unwrap()[1].pose.translation.y < -10.0 * TAU * radius);
        assert_no_work(&report);
    }
}

/// Atwood's machine: one rope over a pulley without mass is two ropes whose lengths have a constant sum.
#[test]
fn a_rope_over_a_pulley_is_a_gear_of_ratio_minus_one() {
    let (light, heavy) = (1.0, 1.5);
    for method in [accurate(), stepped()] {
        let mut scene = Scene::builder("Atwood").method(method).gravity(DVec3::Z * -G).duration_s(0.6);
        let hang = |scene: &mut SceneBuilder, name: &str, mass: f64, x: f64| -> JointId {
            let top = DVec3::X * x;
            let place = top - DVec3::Z * 1.2;
            let body = scene.add_body(block(name, mass, place));
            let long = Limits::new(f64::NEG_INFINITY, 10.0).unwrap();
            scene
                .add_joint(Joint::new(JointKind::Rope { to: top }, body, place).with_limits(Coordinate::Distance, long))
        };
        let [left, right] = [hang(&mut scene, "left", light, -0.2), hang(&mut scene, "right", heavy, 0.2)];
        let scene = scene
            .gear(Gear::new(left, right, -1.0).unwrap())
            .no_contact([polhode::BodyId::new(0), polhode::BodyId::new(1)]);
        let (report, recorder) = run(&scene.build().unwrap(), Effects::Planned);
        let acceleration = G * (heavy - light) / (heavy + light);
        for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
            let off = (row[1].pose.translation.z + 1.2 + 0.5 * acceleration * t * t).abs();
            assert!(off < 1e-11, "t = {t}: {off:e} m off");
        }
        assert_no_work(&report);
    }
}

/// A planetary gear in free space: sun and planet are hinged to a carrier that nothing holds, so that a body is at both
/// joints. The angular momentum stays, and so does the energy.
#[test]
fn a_gear_on_a_free_carrier_keeps_the_angular_momentum() {
    let ratio = -1.7;
    let mut scene = Scene::builder("planetary").method(accurate()).gravity(DVec3::ZERO).duration_s(5.0);
    let carrier = scene.add_body(wheel("carrier", 0.9, DVec3::ZERO, 0.4));
    let sun = scene.add_body(wheel("sun", 0.1, DVec3::ZERO, 0.4 + ratio * 3.0));
    let offset = DVec3::new(0.5, 0.0, 0.0);
    let planet = wheel("planet", 0.05, offset, 0.4 + 3.0);
    let planet = scene.add_body(planet.velocity(Velocity::new(DVec3::Y * (0.4 * 0.5), DVec3::Z * 3.4)));
    let of_sun = scene.add_joint(Joint::hinge(sun, DVec3::ZERO, UnitVector::Z).with(carrier));
    let of_planet = scene.add_joint(Joint::hinge(planet, offset, UnitVector::Z).with(carrier));
    let scene = scene.gear(Gear::new(of_sun, of_planet, ratio).unwrap()).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    for row in &recorder.samples {
        let [carrier, sun, planet] = [0, 1, 2].map(|body: usize| row[body].velocity.angular.z);
        let apart = ((sun - carrier) - ratio * (planet - carrier)).abs();
        assert!(apart < 1e-12, "{apart:e}");
    }
    assert_no_work(&report);
    let _ = (carrier, sun, planet);
}

/// Three wheels on a line where the ends are on different carriers: four bodies in one row.
#[test]
fn a_gear_couples_four_bodies() {
    let ratio = 0.6;
    let mut scene = Scene::builder("four").method(accurate()).gravity(DVec3::ZERO).duration_s(3.0);
    let at = |scene: &mut SceneBuilder, name: &str, moment: f64, x: f64, rate: f64| {
        scene.add_body(wheel(name, moment, DVec3::X * x, rate))
    };
    let a = at(&mut scene, "a", 0.3, 0.0, 1.0 + ratio * 2.0);
    let b = at(&mut scene, "b", 0.2, 0.0, 1.0);
    let c = at(&mut scene, "c", 0.4, 3.0, -0.5 + 2.0);
    let d = at(&mut scene, "d", 0.1, 3.0, -0.5);
    let first = scene.add_joint(Joint::hinge(a, DVec3::ZERO, UnitVector::Z).with(b));
    let second = scene.add_joint(Joint::hinge(c, DVec3::X * 3.0, UnitVector::Z).with(d));
    // A moment on `a` that the gear passes on.
    let (torque, frame, signal) = (DVec3::Z * 0.2, Frame::World, Signal::ONE);
    let force = Force::Applied { body: a, force: DVec3::ZERO, torque, frame, point: None, signal };
    let scene = scene.gear(Gear::new(first, second, ratio).unwrap()).force(force).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    for row in &recorder.samples {
        let w = [0, 1, 2, 3].map(|body: usize| row[body].velocity.angular.z);
        assert!(((w[0] - w[1]) - ratio * (w[2] - w[3])).abs() < 1e-12, "{w:?}");
        // Each pair keeps the sum of its momenta but for what the torque gives to the first one.
        assert!((0.4 * w[2] + 0.1 * w[3] - (0.4 * 1.5 - 0.1 * 0.5)).abs() < 1e-12, "{w:?}");
    }
    assert_no_work(&report);
}

/// A run that is stopped after some hundred revolutions goes on with the same bits.
#[test]
fn revolutions_are_part_of_a_snapshot() {
    for method in [accurate(), stepped()] {
        let scene = train(method, 0.377, 0.1, 50.0).duration_s(30.0).output_interval_s(1.0).build().unwrap();
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(20.123).unwrap();
        let bytes = simulation.snapshot().to_bytes();
        let whole = simulation.run().unwrap();
        let mut other = Simulation::new(&scene).unwrap();
        other.restore(&Snapshot::from_bytes(&bytes).unwrap()).unwrap();
        assert_eq!(other.run().unwrap().bodies, whole.bodies);
    }
}

/// What cannot be a gear is refused, with what is needed.
#[test]
fn what_is_no_gear_is_refused() {
    let [first, second] = [JointId::new(0), JointId::new(1)];
    assert_eq!(Gear::new(first, second, 0.0), Err(GearError::Ratio(0.0)));
    assert!(matches!(Gear::new(first, second, f64::NAN), Err(GearError::Ratio(ratio)) if ratio.is_nan()));
    assert!(Gear::new(first, second, f64::INFINITY).is_err());
    let build = |gear: Gear, rate: f64| {
        let mut scene = Scene::builder("refused");
        let a = scene.add_body(wheel("a", 0.2, DVec3::ZERO, rate));
        let b = scene.add_body(wheel("b", 0.2, DVec3::X, 1.0));
        scene.add_joint(Joint::hinge(a, DVec3::ZERO, UnitVector::Z));
        scene.add_joint(Joint::hinge(b, DVec3::X, UnitVector::Z));
        scene.gear(gear).build().map(|_| ())
    };
    let gear = |first, second| Gear::new(first, second, 2.0).unwrap();
    assert!(build(gear(first, second), 2.0).is_ok());
    let refused = |result: Result<(), SceneError>| result.unwrap_err().to_string();
    assert!(refused(build(gear(first, JointId::new(7)), 2.0)).contains("does not exist"));
    assert!(refused(build(gear(first, first), 2.0)).contains("itself"));
    let of_distance = gear(first, second).between(Coordinate::Angle, Coordinate::Displacement);
    assert!(refused(build(of_distance, 2.0)).contains("does not have such a coordinate"));
    assert!(matches!(
        build(gear(first, second), 1.0),
        Err(SceneError::GearRate { found, needed, .. }) if found == 1.0 && needed == 2.0
    ));
}
