//! Joints to kinematic bodies: a crank drives a slider, and a pivot that moves drives a pendulum, as closed forms and
//! the equations in angles say. The work of the kinematic body is what the energy of the others changes by.

use crate::checks::assert_closes;
use crate::joints::{assert_held, down, inertia, integrate, rod};
use crate::support::{accurate, ball, brick, floor, run};
use polhode::dynamics::System;
use polhode::scene::{Interpolation, Joint, Method, MotionTable, PrescribedMotion, SceneError, Tier};
use polhode::spatial::{DVec3, Pose, UnitVector, Velocity};
use polhode::{Body, BodyId, Effects, RunReport, Scene, SceneBuilder, Simulation, Steering};
use std::f64::consts::TAU;

const G: f64 = 9.81;

/// A crank of 0.1 m that turns about the y axis drives a block along the x axis by a rod of 0.3 m.
const CRANK: f64 = 0.1;
const ROD: (f64, f64) = (0.5, 0.3);
const RATE: f64 = 20.0;

fn slider_crank(method: Method, duration_s: f64) -> SceneBuilder {
    let turning = Velocity::new(DVec3::ZERO, DVec3::Y * RATE);
    let crank = Body::kinematic("crank", PrescribedMotion::constant_velocity(turning).unwrap());
    let pin = DVec3::X * CRANK;
    let end = DVec3::X * (CRANK + ROD.1);
    let rate = -RATE * CRANK / ROD.1;
    let rod = rod("rod", ROD, (pin + end) * 0.5, std::f64::consts::FRAC_PI_2)
        .velocity(Velocity::new(DVec3::Z * (-0.5 * RATE * CRANK), DVec3::Y * rate));
    let block = brick("block", DVec3::splat(0.05), end);
    Scene::builder("slider-crank")
        .method(method)
        .duration_s(duration_s)
        .body(crank)
        .body(rod)
        .body(block)
        .joint(Joint::hinge(BodyId::new(1), pin, UnitVector::Y).with(BodyId::new(0)))
        .joint(Joint::hinge(BodyId::new(1), end, UnitVector::Y).with(BodyId::new(2)))
        .joint(Joint::new(polhode::scene::JointKind::Slider { axis: UnitVector::X }, BodyId::new(2), end))
}

/// Where the block is at a time, m.
fn block_at(t: f64) -> f64 {
    let (sin, cos) = (RATE * t).sin_cos();
    CRANK * cos + (ROD.1 * ROD.1 - CRANK * CRANK * sin * sin).sqrt()
}

/// The block follows its closed form through two turns and more; the work of the crank is the change of energy.
#[test]
fn a_crank_drives_a_slider() {
    // Nothing of it is free, so that time steps follow it to rounding too.
    for method in [accurate(), Method { tier: Some(Tier::Stepped), step_s: Some(2e-3), ..Method::default() }] {
        let is_accurate = method.tier == Some(Tier::Accurate);
        let (report, recorder) = run(&slider_crank(method, 0.73).build().unwrap(), Effects::Planned);
        for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
            let off = (row[2].pose.translation - DVec3::X * block_at(t)).length();
            assert!(off < 1e-11, "t = {t}: {off:e} m off");
        }
        assert!(report.ledger.external.value().abs() > 0.1, "{:?}", report.ledger);
        assert_closes(&report);
        if is_accurate {
            assert_held(&report);
        }
    }
}

/// A pendulum whose pivot moves up and down: the angle, its rate.
struct Shaken {
    acceleration: fn(f64) -> f64,
}

impl System for Shaken {
    type Error = std::convert::Infallible;

    fn dimension(&self) -> usize {
        2
    }

    fn derivative(&mut self, t: f64, state: &[f64], rates: &mut [f64]) -> Result<(), Self::Error> {
        let (mass, length) = ROD;
        let moment = inertia(ROD) + 0.25 * mass * length * length;
        let weight = mass * (G + (self.acceleration)(t));
        rates.copy_from_slice(&[state[1], -weight * 0.5 * length * state[0].sin() / moment]);
        Ok(())
    }
}

const AMPLITUDE: f64 = 0.02;
const FREQUENCY: f64 = 3.0;
const START: f64 = 0.9;

/// A rod at a kinematic pivot with this motion, whose velocity at the start is `speed` upwards.
fn shaken(motion: PrescribedMotion, speed: f64, joint: &Joint) -> SceneBuilder {
    let pendulum =
        rod("rod", ROD, down(START) * (0.5 * ROD.1), START).velocity(Velocity::new(DVec3::Z * speed, DVec3::ZERO));
    Scene::builder("shaken pendulum")
        .method(accurate())
        .duration_s(1.0)
        .body(Body::kinematic("pivot", motion))
        .body(pendulum)
        .joint(*joint)
}

/// The acceleration of a pivot that goes up and down.
fn sine(t: f64) -> f64 {
    let rate = TAU * FREQUENCY;
    -AMPLITUDE * rate * rate * (rate * t).sin()
}

#[track_caller]
fn assert_angle(report: &RunReport, pivot_z: f64, angle: f64) {
    let place = down(angle) * (0.5 * ROD.1) + DVec3::Z * pivot_z;
    let off = (report.bodies[1].state.pose.translation - place).length();
    assert!(off < 1e-9, "{off:e} m off");
    assert_held(report);
}

/// The kinematic body is the first of the joint or the second, a hinge or a ball joint.
#[test]
fn a_pivot_that_moves_drives_a_pendulum() {
    let mut state = vec![START, 0.0];
    let rate = TAU * FREQUENCY;
    integrate(&mut Shaken { acceleration: sine }, 1.0, &mut state);
    for joint in [
        Joint::hinge(BodyId::new(1), DVec3::ZERO, UnitVector::Y).with(BodyId::new(0)),
        Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Y).with(BodyId::new(1)),
        Joint::ball(BodyId::new(0), DVec3::ZERO).with(BodyId::new(1)),
    ] {
        let motion = PrescribedMotion::sine(DVec3::Z * AMPLITUDE, DVec3::ZERO, FREQUENCY, 0.0).unwrap();
        let (report, _) = run(&shaken(motion, AMPLITUDE * rate, &joint).build().unwrap(), Effects::Planned);
        assert_angle(&report, AMPLITUDE * (rate * 1.0).sin(), state[0]);
        assert!(report.ledger.external.value().abs() > 1e-3, "{:?}", report.ledger);
    }
}

/// The same by time steps: half the step, a quarter of the error.
#[test]
fn time_steps_of_a_driven_pendulum_are_of_second_order() {
    let mut state = vec![START, 0.0];
    integrate(&mut Shaken { acceleration: sine }, 1.0, &mut state);
    let place = down(state[0]) * (0.5 * ROD.1);
    let error = |step_s: f64| {
        let motion = PrescribedMotion::sine(DVec3::Z * AMPLITUDE, DVec3::ZERO, FREQUENCY, 0.0).unwrap();
        let joint = Joint::hinge(BodyId::new(1), DVec3::ZERO, UnitVector::Y).with(BodyId::new(0));
        let method = Method { tier: Some(Tier::Stepped), step_s: Some(step_s), ..Method::default() };
        let scene = shaken(motion, AMPLITUDE * TAU * FREQUENCY, &joint).method(method).build().unwrap();
        let (report, _) = run(&scene, Effects::Planned);
        assert_closes(&report);
        (report.bodies[1].state.pose.translation - place).length()
    };
    let errors = [2e-3, 1e-3, 5e-4].map(error);
    for pair in errors.windows(2) {
        assert!(pair[0] > 3.5 * pair[1], "{errors:?}");
    }
}

/// A pivot that stands, is lifted along a table, and stands again: steps end where its acceleration jumps.
#[test]
fn a_pivot_by_table_drives_a_pendulum() {
    let table = MotionTable {
        times_s: vec![0.0, 0.2, 0.5, 2.0],
        positions_m: Some([0.0, 0.0, 0.1, 0.1].map(|z| DVec3::Z * z).to_vec()),
        interpolation: Interpolation::Monotone,
        ..MotionTable::default()
    };
    let motion = PrescribedMotion::table(&table).unwrap();
    // Between samples at which it stands, the polynomial is z = 0.1 (10 s^3 - 15 s^4 + 6 s^5) with s = (t - 0.2)/0.3.
    let mut state = vec![START, 0.0];
    let still = |_: f64| 0.0;
    let lifted = |t: f64| {
        let s = t / 0.3;
        0.1 * s * (60.0 - 180.0 * s + 120.0 * s * s) / 0.09
    };
    for (acceleration, span) in [(still as fn(f64) -> f64, 0.2), (lifted, 0.3), (still, 0.5)] {
        integrate(&mut Shaken { acceleration }, span, &mut state);
    }
    let joint = Joint::hinge(BodyId::new(1), DVec3::ZERO, UnitVector::Y).with(BodyId::new(0));
    let (report, _) = run(&shaken(motion, 0.0, &joint).build().unwrap(), Effects::Planned);
    assert_angle(&report, 0.1, state[0]);
}

/// Balls fall on a rod that a crank drives: what the impacts take and the crank gives closes the ledgers.
#[test]
fn a_driven_linkage_that_is_struck_closes_its_ledgers() {
    for method in [accurate(), Method { tier: Some(Tier::Stepped), step_s: Some(1e-3), ..Method::default() }] {
        let scene = slider_crank(method, 0.5)
            .body(ball("ball", 0.1, 0.03, DVec3::new(0.25, 0.0, 0.2), DVec3::ZERO))
            .body(floor().pose(Pose::from_translation(DVec3::Z * -0.5)));
        let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
        assert_closes(&report);
        let off = (report.bodies[2].state.pose.translation - DVec3::X * block_at(0.5)).length();
        assert!(off < 1e-4, "{off:e}");
    }
}

/// Two kinematic bodies, or one and the world, hold nothing; one whose velocity jumps would need a force without a
/// bound.
#[test]
fn joints_that_drive_nothing_or_jump_are_refused() {
    let still = || PrescribedMotion::constant_velocity(Velocity::ZERO).unwrap();
    let pair = Scene::builder("pair").body(Body::kinematic("a", still())).body(Body::kinematic("b", still()));
    for joint in
        [Joint::ball(BodyId::new(0), DVec3::ZERO), Joint::ball(BodyId::new(0), DVec3::ZERO).with(BodyId::new(1))]
    {
        assert!(matches!(pair.clone().joint(joint).build(), Err(SceneError::Joint { number: 0, .. })));
    }
    let table = MotionTable {
        times_s: vec![0.0, 0.5, 1.0],
        positions_m: Some([0.0, 0.0, 0.1].map(|z| DVec3::Z * z).to_vec()),
        interpolation: Interpolation::Linear,
        ..MotionTable::default()
    };
    let joint = Joint::hinge(BodyId::new(1), DVec3::ZERO, UnitVector::Y).with(BodyId::new(0));
    let jumps = shaken(PrescribedMotion::table(&table).unwrap(), 0.0, &joint).build();
    assert!(matches!(jumps, Err(SceneError::MotionJumps { .. })), "{jumps:?}");
    // The pendulum must start with the velocity of its pivot.
    let motion = PrescribedMotion::sine(DVec3::Z * AMPLITUDE, DVec3::ZERO, FREQUENCY, 0.0).unwrap();
    assert!(matches!(shaken(motion, 0.0, &joint).build(), Err(SceneError::JointMoves { number: 0, .. })));
}

/// A crank at rest that a program sets turning takes its linkage along at once, as if it had turned from the start;
/// then it is turned back smoothly to where it began. What the program and the crank do closes the ledgers.
#[test]
fn a_program_steers_a_crank() {
    let still = PrescribedMotion::constant_velocity(Velocity::ZERO).unwrap();
    for tier in [Tier::Accurate, Tier::Stepped] {
        let method = Method { tier: Some(tier), step_s: Some(2e-3), ..Method::default() };
        let (pin, end) = (DVec3::X * CRANK, DVec3::X * (CRANK + ROD.1));
        let scene = Scene::builder("steered crank")
            .method(method)
            .duration_s(1.0)
            .body(Body::kinematic("crank", still.clone()))
            .body(rod("rod", ROD, (pin + end) * 0.5, std::f64::consts::FRAC_PI_2))
            .body(brick("block", DVec3::splat(0.05), end))
            .joint(Joint::hinge(BodyId::new(1), pin, UnitVector::Y).with(BodyId::new(0)))
            .joint(Joint::hinge(BodyId::new(1), end, UnitVector::Y).with(BodyId::new(2)))
            .joint(Joint::new(polhode::scene::JointKind::Slider { axis: UnitVector::X }, BodyId::new(2), end));
        let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
        let [crank, block] = ["crank", "block"].map(|name| simulation.body_id(name).unwrap());
        simulation.advance_to(0.1).unwrap();
        assert!((simulation.body(block).pose.translation - end).length() < 1e-12, "{tier:?}");
        let turning = Steering::Velocity(Velocity::new(DVec3::ZERO, DVec3::Y * RATE));
        simulation.set_motion(crank, turning).unwrap();
        simulation.advance_to(0.34).unwrap();
        let off = (simulation.body(block).pose.translation - DVec3::X * block_at(0.24)).length();
        assert!(off < 1e-11, "{tier:?}: {off:e} m off");
        simulation.set_motion(crank, Steering::Pose { pose: Pose::IDENTITY, within_s: 0.4 }).unwrap();
        let report = simulation.run().unwrap();
        assert!((simulation.body(block).pose.translation - end).length() < 1e-11, "{tier:?}");
        assert_closes(&report);
        // Only what time steps lose of the motion of the rod is left.
        let allowed = if tier == Tier::Accurate { 1e-10 } else { 1e-2 };
        assert!(
            report.ledger.numerical.value().abs() < allowed * report.ledger.scale_j,
            "{tier:?} {:?}",
            report.ledger
        );
    }
}
