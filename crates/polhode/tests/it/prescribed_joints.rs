//! Prescribed motions of joint coordinates: the coordinate follows its function of time to rounding, whatever acts on
//! the bodies; the work of the drive is what the energy of the bodies changes by; the moment of the drive is Newton's;
//! and what contradicts itself is refused or told.

use crate::checks::assert_closes;
use crate::support::{accurate, run};
use polhode::mesh::solid_box;
use polhode::scene::{
    Coordinate, CoordinateMotion, Freedom, Gear, Interpolation, Joint, JointKind, Limits, Method, SceneError, Tier,
};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, UnitVector, Velocity};
use polhode::{Body, Effects, Scene, SceneBuilder, Simulation, SimulationError, Snapshot};
use std::f64::consts::TAU;

fn stepped() -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(1e-3), ..Method::default() }
}

/// A rod of 2 kg and 1 m hinged at the origin about y, which hangs along x at the start and turns at this rate.
fn arm(scene: &mut SceneBuilder, rate: f64) -> polhode::JointId {
    let properties = solid_box(DVec3::new(1.0, 0.05, 0.05), Mass::new(2.0).unwrap()).unwrap();
    let velocity = Velocity::new(DVec3::Y.cross(DVec3::X * 0.5) * rate, DVec3::Y * rate);
    let body = Body::movable("arm", properties).pose(Pose::from_translation(DVec3::X * 0.5)).velocity(velocity);
    let body = scene.add_body(body);
    scene.add_joint(Joint::hinge(body, DVec3::ZERO, UnitVector::Y))
}

/// Constant rate through many revolutions, sine, and tables: the angle is the function of time.
#[test]
fn an_angle_follows_its_function_of_time() {
    type Of = fn(f64) -> f64;
    let table =
        |interpolation| CoordinateMotion::table(vec![0.0, 0.4, 1.0, 1.5], &[0.0, 0.8, -0.5, 0.3], interpolation);
    let known: [(CoordinateMotion, f64, f64, Option<Of>); 4] = [
        (CoordinateMotion::rate(20.0).unwrap(), 20.0, 10.0, Some(|t| 20.0 * t)),
        (
            CoordinateMotion::sine(0.7, 1.3, 0.4).unwrap(),
            0.7 * TAU * 1.3 * 0.4_f64.cos(),
            3.0,
            Some(|t| 0.7 * ((TAU * 1.3 * t + 0.4).sin() - 0.4_f64.sin())),
        ),
        (table(Interpolation::Monotone).unwrap(), 0.0, 2.0, None),
        (table(Interpolation::Spline).unwrap(), 0.0, 2.0, None),
    ];
    for method in [accurate(), stepped()] {
        for (motion, rate, duration_s, expected) in &known {
            let mut scene =
                Scene::builder("arm").method(method.clone()).duration_s(*duration_s).output_interval_s(0.05);
            let hinge = arm(&mut scene, *rate);
            let scene = scene.coordinate_motion(hinge, Coordinate::Angle, motion.clone()).build().unwrap();
            let (report, recorder) = run(&scene, Effects::Planned);
            for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
                // Only the bodies of the scene are shown.
                assert_eq!(row.len(), 1);
                let Some(expected) = expected else { continue };
                let angle = expected(t);
                let along = row[0].pose.rotation.rotate(DVec3::X);
                let off = (along - DVec3::new(angle.cos(), 0.0, -angle.sin())).length();
                // Time steps keep the coordinate at their ends; samples between them are not asked for here.
                assert!(off < 2e-12, "{motion:?}, t = {t}: {off:e}");
            }
            if expected.is_none() {
                let along = report.bodies[0].state.pose.rotation.rotate(DVec3::X);
                let end = 0.3_f64;
                assert!((along - DVec3::new(end.cos(), 0.0, -end.sin())).length() < 1e-12, "{along}");
            }
            assert_closes(&report);
            assert!(report.ledger.external.value().abs() > 0.01, "{:?}", report.ledger);
        }
    }
}

/// At a sine the moment of the drive is that of inertia and weight: `I q'' + ...`, and its work is booked as external
/// work.
#[test]
fn the_moment_of_the_drive_is_newtons() {
    let (amplitude, frequency) = (0.5, 0.8);
    let rate = amplitude * TAU * frequency;
    let mut scene = Scene::builder("arm").method(accurate()).gravity(DVec3::Z * -9.81).duration_s(1.0);
    let hinge = arm(&mut scene, rate);
    let motion = CoordinateMotion::sine(amplitude, frequency, 0.0).unwrap();
    let scene = scene.coordinate_motion(hinge, Coordinate::Angle, motion).build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    let moment = 2.0 * (1.0 + 0.05 * 0.05) / 12.0 + 2.0 * 0.25;
    for t in [0.1, 0.33, 0.77] {
        simulation.advance_to(t).unwrap();
        let phase = TAU * frequency * t;
        let (angle, acceleration) = (amplitude * phase.sin(), -amplitude * (TAU * frequency).powi(2) * phase.sin());
        // A positive angle about y lowers the end of the arm.
        let needed = moment * acceleration - 2.0 * 9.81 * 0.5 * angle.cos();
        let load = simulation.joint_loads()[0];
        assert!((load.moment_n_m.y - needed).abs() < 1e-9, "t = {t}: {} and {needed}", load.moment_n_m.y);
    }
}

/// A slider that carries a pendulum: the pendulum is driven as by a kinematic body with the same motion.
#[test]
fn a_driven_slider_is_a_kinematic_body_to_what_hangs_at_it() {
    let (amplitude, frequency) = (0.1, 1.7);
    let bob = |scene: &mut SceneBuilder| {
        let inertia = Inertia::from_diagonal(DVec3::new(0.2, 0.3, 0.25)).unwrap();
        let properties = MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia);
        // The carriage moves at the start, and the bob with it.
        let velocity = Velocity::new(DVec3::X * (amplitude * TAU * frequency), DVec3::ZERO);
        scene
            .add_body(Body::movable("bob", properties).pose(Pose::from_translation(DVec3::Z * -0.6)).velocity(velocity))
    };
    let mut by_joint = Scene::builder("joint").method(accurate()).duration_s(3.0);
    let hanging = bob(&mut by_joint);
    let cart = solid_box(DVec3::splat(0.2), Mass::new(3.0).unwrap()).unwrap();
    let velocity = Velocity::new(DVec3::X * (amplitude * TAU * frequency), DVec3::ZERO);
    let cart = by_joint.add_body(Body::movable("cart", cart).velocity(velocity));
    by_joint.add_joint(Joint::ball(hanging, DVec3::ZERO).with(cart));
    let slider = by_joint.add_joint(Joint::new(JointKind::Slider { axis: UnitVector::X }, cart, DVec3::ZERO));
    let motion = CoordinateMotion::sine(amplitude, frequency, 0.0).unwrap();
    let by_joint = by_joint.coordinate_motion(slider, Coordinate::Displacement, motion).build().unwrap();

    let mut by_body = Scene::builder("body").method(accurate()).duration_s(3.0);
    let hanging = bob(&mut by_body);
    let motion = polhode::scene::PrescribedMotion::sine(DVec3::X * amplitude, DVec3::ZERO, frequency, 0.0).unwrap();
    let cart = by_body.add_body(Body::kinematic("cart", motion));
    by_body.add_joint(Joint::ball(hanging, DVec3::ZERO).with(cart));
    let by_body = by_body.build().unwrap();

    let [(first, _), (second, _)] = [by_joint, by_body].map(|scene| run(&scene, Effects::Planned));
    let [a, b] = [&first, &second].map(|report| report.bodies[0].state.pose.translation);
    assert!((a - b).length() < 1e-10, "{:e}", (a - b).length());
    assert_closes(&first);
}

/// A drive and a gear: the second wheel follows too. A run goes on from a snapshot with the same bits.
#[test]
fn a_prescribed_motion_drives_a_gear_and_goes_on_from_a_snapshot() {
    for method in [accurate(), stepped()] {
        let mut scene = Scene::builder("drive").method(method).duration_s(2.0);
        let first = arm(&mut scene, 4.0);
        let properties = solid_box(DVec3::new(0.3, 0.3, 0.1), Mass::new(0.5).unwrap()).unwrap();
        let wheel = Body::movable("wheel", properties).pose(Pose::from_translation(DVec3::Y * 3.0));
        let wheel = scene.add_body(wheel.velocity(Velocity::new(DVec3::ZERO, DVec3::Y * -8.0)));
        let second = scene.add_joint(Joint::hinge(wheel, DVec3::Y * 3.0, UnitVector::Y));
        let scene = scene.gear(Gear::new(first, second, -0.5).unwrap());
        let motion = CoordinateMotion::rate(4.0).unwrap();
        let scene = scene.coordinate_motion(first, Coordinate::Angle, motion).build().unwrap();
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(1.234_5).unwrap();
        let bytes = simulation.snapshot().to_bytes();
        let whole = simulation.run().unwrap();
        assert!((whole.bodies[1].state.velocity.angular.y + 8.0).abs() < 1e-12);
        let mut other = Simulation::new(&scene).unwrap();
        other.restore(&Snapshot::from_bytes(&bytes).unwrap()).unwrap();
        assert_eq!(other.run().unwrap().bodies, whole.bodies);
    }
}

/// What a joint cannot follow is refused, with what is needed.
#[test]
fn what_cannot_be_followed_is_refused() {
    let build = |rate: f64, coordinate, motion: CoordinateMotion| {
        let mut scene = Scene::builder("refused").duration_s(2.0);
        let hinge = arm(&mut scene, rate);
        scene.coordinate_motion(hinge, coordinate, motion)
    };
    let refused = |scene: SceneBuilder| scene.build().map(|_| ()).unwrap_err();
    let steady = || CoordinateMotion::rate(2.0).unwrap();
    let error = refused(build(1.0, Coordinate::Angle, steady()));
    assert!(matches!(
        error,
        SceneError::CoordinateRate { found, needed, .. } if (found - 1.0).abs() < 1e-12 && needed == 2.0
    ));
    assert!(
        refused(build(2.0, Coordinate::Displacement, steady())).to_string().contains("does not have that coordinate")
    );
    let twice = build(2.0, Coordinate::Angle, steady()).coordinate_motion(
        polhode::JointId::new(0),
        Coordinate::Angle,
        steady(),
    );
    assert!(refused(twice).to_string().contains("two of them"));
    let jumps = CoordinateMotion::table(vec![0.0, 1.0, 1.5], &[0.0, 1.0, 0.0], Interpolation::Linear).unwrap();
    assert!(refused(build(1.0, Coordinate::Angle, jumps)).to_string().contains("jumps"));
    assert!(CoordinateMotion::rate(f64::NAN).is_err() && CoordinateMotion::sine(1.0, 0.0, 0.0).is_err());
    let mut limited = Scene::builder("limits");
    let body = solid_box(DVec3::ONE, Mass::new(1.0).unwrap()).unwrap();
    let body = limited.add_body(Body::movable("body", body));
    let range = Freedom::default().with_limits(Limits::new(-1.0, 1.0).unwrap());
    let hinge = limited.add_joint(Joint::hinge(body, DVec3::ZERO, UnitVector::Z).along(Coordinate::Angle, range));
    let still = CoordinateMotion::rate(0.0).unwrap();
    assert!(refused(limited.coordinate_motion(hinge, Coordinate::Angle, still)).to_string().contains("limits"));
}

/// Two motions that contradict each other through a gear: the run says so where it would begin.
#[test]
fn motions_that_contradict_each_other_are_refused() {
    for method in [accurate(), stepped()] {
        let mut scene = Scene::builder("contradiction").method(method).duration_s(1.0);
        let first = arm(&mut scene, 0.0);
        let properties = solid_box(DVec3::new(0.3, 0.3, 0.1), Mass::new(0.5).unwrap()).unwrap();
        let wheel = scene.add_body(Body::movable("wheel", properties).pose(Pose::from_translation(DVec3::Y * 3.0)));
        let second = scene.add_joint(Joint::hinge(wheel, DVec3::Y * 3.0, UnitVector::Y));
        let table = |end: f64| CoordinateMotion::table(vec![0.0, 1.0], &[0.0, end], Interpolation::Spline).unwrap();
        // The second one moves as the gear says in one scene, and otherwise in the other.
        let scene = scene.gear(Gear::new(first, second, -0.5).unwrap());
        let driven = |end: f64| {
            let scene = scene.clone().coordinate_motion(first, Coordinate::Angle, table(1.0));
            scene.coordinate_motion(second, Coordinate::Angle, table(end)).build().unwrap()
        };
        let (report, _) = run(&driven(-2.0), Effects::Planned);
        assert_closes(&report);
        let error = Simulation::new(&driven(1.0)).and_then(|mut simulation| simulation.run().map(|_| ())).unwrap_err();
        assert!(matches!(error, SimulationError::JointsContradict { t_s, .. } if t_s < 0.05), "{error}");
    }
}
