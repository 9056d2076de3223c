//! Springs, dampers and motors at the coordinates of joints: oscillations, decays and servos as closed forms say;
//! between two bodies they are internal, so that momentum stays; what they do on the bodies is booked where it belongs.

use crate::checks::assert_closes;
use crate::joints::{inertia, rod};
use crate::support::{accurate, brick, run};
use polhode::scene::{Coordinate, Drive, Freedom, Joint, JointKind, Limits, Method, Motor, SceneError, Tier};
use polhode::spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, Effects, JointId, Scene, SceneBuilder, Simulation, Snapshot};

const G: f64 = 9.81;

fn stepped(step_s: f64) -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(step_s), ..Method::default() }
}

fn scene(method: Method) -> SceneBuilder {
    Scene::builder("joint forces").method(method).gravity(DVec3::ZERO)
}

/// A rod on a hinge at the origin along y, level along x; its mass and length, and its moment about the hinge.
const ROD: (f64, f64) = (1.4, 0.8);

fn level_rod() -> Body {
    rod("rod", ROD, DVec3::X * (0.5 * ROD.1), std::f64::consts::FRAC_PI_2)
}

fn moment() -> f64 {
    inertia(ROD) + 0.25 * ROD.0 * ROD.1 * ROD.1
}

fn hinge(freedom: Freedom) -> Joint {
    Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Y).along(Coordinate::Angle, freedom)
}

/// The centre of the rod where its angle about y is this.
fn at_angle(angle: f64) -> DVec3 {
    DVec3::new(angle.cos(), 0.0, -angle.sin()) * (0.5 * ROD.1)
}

/// A torsion spring swings a rod about the angle at which it is at rest, beyond a revolution too; in time steps to
/// their order.
#[test]
fn a_torsion_spring_swings_a_rod_harmonically() {
    let (stiffness, rest) = (7.0, 0.6);
    let frequency = (stiffness / moment()).sqrt();
    for (method, allowed) in [(accurate(), 1e-10), (stepped(1e-3), 2e-5)] {
        let is_accurate = method.tier == Some(Tier::Accurate);
        let spring = Freedom::default().with_spring(stiffness, rest).unwrap();
        let built = scene(method).duration_s(1.5).body(level_rod()).joint(hinge(spring)).build().unwrap();
        let (report, recorder) = run(&built, Effects::Planned);
        for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
            let off = (row[0].pose.translation - at_angle(rest * (1.0 - (frequency * t).cos()))).length();
            assert!(off < allowed, "t = {t}: {off:e} m off");
        }
        assert!((report.energy.initial_j - 0.5 * stiffness * rest * rest).abs() < 1e-13, "{:?}", report.energy);
        if is_accurate {
            assert!((report.energy.final_j / report.energy.initial_j - 1.0).abs() < 1e-11, "{:?}", report.energy);
        }
        assert_closes(&report);
    }
}

/// A damper slows a rod exponentially, and takes the energy that the rod loses; in time steps to their order.
#[test]
fn a_damper_slows_a_rod_exponentially() {
    let (damping, rate, duration) = (0.9, 5.0, 1.2);
    for (method, allowed) in [(accurate(), 1e-11), (stepped(1e-2), 1e-3)] {
        let damper = Freedom::default().with_damping(damping).unwrap();
        let turning = Velocity::new(DVec3::Y.cross(DVec3::X * (0.5 * ROD.1)) * rate, DVec3::Y * rate);
        let body = level_rod().velocity(turning);
        let built = scene(method).duration_s(duration).body(body).joint(hinge(damper)).build().unwrap();
        let (report, recorder) = run(&built, Effects::Planned);
        for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
            let expected = rate * (-damping * t / moment()).exp();
            let off = (row[0].velocity.angular.y / expected - 1.0).abs();
            assert!(off < allowed, "t = {t}: {off:e}");
        }
        let lost = report.energy.initial_j - report.energy.final_j;
        assert!((report.ledger.damping.value() / lost - 1.0).abs() < 10.0 * allowed, "{:?}", report.ledger);
        assert_closes(&report);
    }
}

/// A spring and a damper on a slider: a damped oscillation.
#[test]
fn a_slider_on_a_spring_with_a_damper_oscillates_with_decay() {
    let (stiffness, damping, rest) = (50.0, 1.5, 0.1);
    let axis = UnitVector::new(DVec3::new(0.5, -0.2, 0.7)).unwrap();
    let own = Freedom::default().with_spring(stiffness, rest).unwrap().with_damping(damping).unwrap();
    let joint = Joint::new(JointKind::Slider { axis }, BodyId::new(0), DVec3::X).along(Coordinate::Displacement, own);
    let body = brick("bead", DVec3::splat(0.1), DVec3::ZERO);
    let built = scene(accurate()).duration_s(2.0).body(body).joint(joint).build().unwrap();
    let (report, recorder) = run(&built, Effects::Planned);
    let (decay, frequency) = (0.5 * damping, (stiffness - 0.25 * damping * damping).sqrt());
    for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
        let (sin, cos) = (frequency * t).sin_cos();
        let place = rest * (1.0 - (-decay * t).exp() * (cos + decay / frequency * sin));
        let off = (row[0].pose.translation - axis.get() * place).length();
        assert!(off < 1e-10, "t = {t}: {off:e} m off");
    }
    assert_closes(&report);
}

/// A servo of velocity with a bounded torque speeds a rod up evenly while it is at its bound, and exponentially from
/// then on; its work is external, and equals the energy of the rod.
#[test]
fn a_servo_of_velocity_reaches_its_target_within_its_torque() {
    let (target, gain, most, duration) = (3.0, 2.0, 1.5, 2.0);
    let motor = Motor::new(Drive::Velocity { velocity: target, gain }).unwrap().at_most(most).unwrap();
    let built = scene(accurate()).duration_s(duration).body(level_rod());
    let built = built.joint(hinge(Freedom::default().with_motor(motor))).build().unwrap();
    let (report, recorder) = run(&built, Effects::Planned);
    let below_bound = target - most / gain;
    let until = below_bound * moment() / most;
    for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
        let left = (target - below_bound) * (-(t - until) * gain / moment()).exp();
        let expected = if t < until { most / moment() * t } else { target - left };
        let off = (row[0].velocity.angular.y - expected).abs();
        assert!(off < 1e-8, "t = {t}: {off:e} rad/s off");
    }
    let last = report.energy.kinetic_j;
    assert!((report.ledger.external.value() - last).abs() < 1e-10 * last, "{:?}", report.ledger);
    assert_closes(&report);
}

/// In time steps whether a motor is at its bound does not depend on how the scene is turned: a servo of rate lifts a
/// rod under gravity and leaves its bound. (It was decided by the rate of a lever across the axis, which the fall of
/// the anchor in half of a step was part of, and the lever points anywhere: copies left the bound steps apart.)
#[test]
fn a_turned_servo_leaves_its_bound_in_the_same_step() {
    let (mass, length) = ROD;
    let motor = Motor::new(Drive::Velocity { velocity: -1.0, gain: 12.0 }).unwrap().at_most(7.0).unwrap();
    let end = |turned: Rotation| {
        let body = level_rod();
        let pose = Pose::new(turned, DVec3::ZERO) * *body.initial_pose();
        let axis = UnitVector::new(turned.rotate(DVec3::Y)).unwrap();
        let servo = Freedom::default().with_motor(motor);
        let joint = Joint::hinge(BodyId::new(0), DVec3::ZERO, axis).along(Coordinate::Angle, servo);
        let built = scene(stepped(0.002)).gravity(turned.rotate(DVec3::Z * -G)).duration_s(0.4).body(body.pose(pose));
        let (report, _) = run(&built.joint(joint).build().unwrap(), Effects::Planned);
        turned.inverse_rotate(report.bodies[0].state.pose.translation)
    };
    let upright = end(Rotation::IDENTITY);
    assert!(upright.z > 0.05 * length, "it lifts {mass} kg: {upright}");
    for vector in [DVec3::X, DVec3::new(0.4, -0.9, 1.3), DVec3::new(-2.0, 0.5, 0.1)] {
        let off = (end(Rotation::from_rotation_vector(vector)) - upright).length();
        assert!(off < 1e-12, "turned by {vector}: {off:e} m");
    }
}

/// A servo of position holds a rod against its weight where its torque equals the moment of the weight, in both tiers;
/// the rod that it holds does not move.
#[test]
fn a_servo_of_position_holds_a_rod_against_its_weight() {
    let (stiffness, damping) = (60.0, 12.0);
    for method in [accurate(), stepped(1e-2)] {
        let motor = Motor::new(Drive::Position { position: 0.0, stiffness, damping }).unwrap();
        let built = scene(method).gravity(DVec3::Z * -G).duration_s(8.0).body(level_rod());
        let built = built.joint(hinge(Freedom::default().with_motor(motor))).build().unwrap();
        let (report, _) = run(&built, Effects::Planned);
        let place = report.bodies[0].state.pose.translation;
        let angle = (-place.z).atan2(place.x);
        let weight = ROD.0 * G * 0.5 * ROD.1 * angle.cos();
        assert!((stiffness * angle - weight).abs() < 1e-6 * weight, "{angle}");
        assert!(report.bodies[0].state.velocity.angular.length() < 1e-6);
    }
}

/// A motor between two bodies in free space turns them against each other: momentum and angular momentum stay zero, and
/// the work of the motor is their energy.
#[test]
fn a_motor_between_two_bodies_is_internal() {
    let bodies =
        [brick("rotor", DVec3::new(0.3, 0.2, 0.1), DVec3::ZERO), brick("stator", DVec3::splat(0.4), DVec3::Z * 0.3)];
    let motor = Motor::new(Drive::Effort(0.02)).unwrap();
    let joint = Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Z)
        .with(BodyId::new(1))
        .along(Coordinate::Angle, Freedom::default().with_motor(motor));
    let [rotor, stator] = bodies;
    let inertias = [&rotor, &stator].map(|body| body.mass_properties().unwrap().inertia().matrix().z_axis.z);
    let duration = 1.5;
    let built = scene(accurate()).duration_s(duration).body(rotor).body(stator).joint(joint).build().unwrap();
    let (report, _) = run(&built, Effects::Planned);
    for (body, sign) in [(0, 1.0), (1, -1.0)] {
        let expected = sign * 0.02 * duration / inertias[body];
        let off = report.bodies[body].state.velocity.angular - DVec3::Z * expected;
        assert!(off.length() < 1e-11, "{off}");
        assert!(report.bodies[body].state.velocity.linear.length() < 1e-12);
    }
    assert!((report.ledger.external.value() - report.energy.kinetic_j).abs() < 1e-12, "{:?}", report.ledger);
    assert_closes(&report);
}

/// A spring that is far too stiff for its step stays where it is at rest in tier `stepped`.
#[test]
fn a_spring_that_is_stiff_for_its_step_is_stable() {
    let own = Freedom::default().with_spring(1e7, 0.0).unwrap().with_damping(1e2).unwrap();
    let built = scene(stepped(1e-2)).gravity(DVec3::Z * -G).duration_s(2.0).body(level_rod()).joint(hinge(own));
    let (report, recorder) = run(&built.build().unwrap(), Effects::Planned);
    let sag = recorder.samples.iter().map(|row| row[0].pose.translation.z.abs()).fold(0.0, f64::max);
    assert!(sag < 1e-5, "{sag:e} m");
    // The potential of so stiff a spring is known to the rounding of the pose times its force.
    assert!(report.ledger.closure_relative() < 1e-9, "{:?}", report.ledger);
}

/// A motor drives a rod against its stop, which bears the torque: the rod rests there.
#[test]
fn a_motor_presses_a_rod_against_its_stop() {
    let motor = Motor::new(Drive::Effort(2.0)).unwrap();
    let own = Freedom::default().with_limits(Limits::new(-0.1, 0.8).unwrap()).with_motor(motor);
    let built = scene(accurate()).duration_s(2.0).body(level_rod()).joint(hinge(own)).build().unwrap();
    let (report, _) = run(&built, Effects::Planned);
    assert!((report.bodies[0].state.pose.translation - at_angle(0.8)).length() < 1e-12);
    assert_eq!(report.bodies[0].state.velocity.angular, DVec3::ZERO);
    assert!((report.ledger.external.value() - 1.6).abs() < 1e-9, "{:?}", report.ledger);
    assert_closes(&report);
}

/// What cannot be is refused with a reason.
#[test]
fn forces_that_no_joint_can_have_are_refused() {
    assert!(Motor::new(Drive::Effort(f64::NAN)).is_err());
    assert!(Motor::new(Drive::Velocity { velocity: 1.0, gain: -1.0 }).is_err());
    assert!(Motor::new(Drive::Position { position: f64::INFINITY, stiffness: 1.0, damping: 0.0 }).is_err());
    assert!(Motor::new(Drive::Effort(1.0)).unwrap().at_most(f64::NAN).is_err());
    assert!(
        Freedom::default().with_spring(-1.0, 0.0).is_err() && Freedom::default().with_damping(f64::INFINITY).is_err()
    );
    let ball = Joint::ball(BodyId::new(0), DVec3::ZERO)
        .along(Coordinate::Angle, Freedom::default().with_damping(1.0).unwrap());
    let refused = scene(accurate()).body(brick("body", DVec3::splat(0.1), DVec3::ZERO)).joint(ball).build();
    assert!(matches!(refused, Err(SceneError::Joint { number: 0, .. })));
}

/// A program reads a coordinate and changes its motor while the simulation runs: the rod follows, a snapshot keeps the
/// motor, and taking the motor away leaves the rod to itself.
#[test]
fn a_program_drives_a_joint() {
    for (method, allowed) in [(accurate(), 1e-9), (stepped(1e-2), 1e-3)] {
        let mut builder = scene(method).duration_s(20.0);
        builder.add_body(level_rod());
        let pin = builder.add_joint(Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Y));
        let built = builder.build().unwrap();
        let mut simulation = Simulation::new(&built).unwrap();
        let servo = |position| {
            Some(
                Motor::new(Drive::Position { position, stiffness: 30.0, damping: 10.0 }).unwrap().at_most(8.0).unwrap(),
            )
        };
        let angle = |simulation: &Simulation| simulation.coordinate(pin, Coordinate::Angle).unwrap();
        for (t, target) in [(6.0, 0.7), (12.0, -0.4)] {
            simulation.set_motor(pin, Coordinate::Angle, servo(target)).unwrap();
            simulation.advance_to(t).unwrap();
            assert!((angle(&simulation).value - target).abs() < 1e-5, "{:?}", angle(&simulation));
        }
        simulation.set_motor(pin, Coordinate::Angle, servo(1.0)).unwrap();
        simulation.advance_to(12.5).unwrap();
        let mut other = Simulation::new(&built).unwrap();
        other.restore(&Snapshot::from_bytes(&simulation.snapshot().to_bytes()).unwrap()).unwrap();
        for simulation in [&mut simulation, &mut other] {
            simulation.advance_to(13.0).unwrap();
            simulation.set_motor(pin, Coordinate::Angle, None).unwrap();
        }
        assert_eq!(simulation.snapshot().to_bytes(), other.snapshot().to_bytes());
        let free = angle(&simulation);
        assert!(free.rate.abs() > 1e-3, "{free:?}");
        simulation.advance_to(14.0).unwrap();
        let after = angle(&simulation);
        let off = (after.value - free.value - free.rate).abs().max((after.rate - free.rate).abs());
        assert!(off < allowed, "{off:e}");
        assert_eq!(simulation.coordinate(pin, Coordinate::Distance), None);
        assert!(simulation.set_motor(pin, Coordinate::Displacement, None).is_err());
        assert!(simulation.set_motor(JointId::new(7), Coordinate::Angle, None).is_err());
    }
}

/// A motor on a light hub that a weld holds gives its bound, whichever way the hub would turn under it alone: the wheel
/// begins as its moment says.
#[test]
fn a_bounded_servo_on_a_light_hub_turns_its_wheel() {
    let servo = Motor::new(Drive::Velocity { velocity: 50.0, gain: 40.0 }).unwrap().at_most(150.0).unwrap();
    for method in [accurate(), stepped(2e-3)] {
        let mut built = scene(method).duration_s(0.1);
        let hub = built.add_body(brick("hub", DVec3::splat(0.03), DVec3::ZERO));
        let wheel = built.add_body(brick("wheel", DVec3::new(2.0, 0.1, 2.0), DVec3::Y * 0.2));
        built = built.joint(Joint::new(JointKind::Fixed, hub, DVec3::ZERO));
        let driven = Freedom::default().with_motor(servo);
        let shaft = Joint::hinge(wheel, DVec3::Y * 0.2, UnitVector::Y).with(hub).along(Coordinate::Angle, driven);
        let (report, _) = run(&built.joint(shaft).build().unwrap(), Effects::Planned);
        let expected = 150.0 / (8.0 / 12.0) * 0.1;
        let rate = report.bodies[1].state.velocity.angular.y;
        assert!((rate - expected).abs() < 1e-9, "{rate} and {expected}");
        assert_closes(&report);
    }
}

/// A torsion spring goes on being wound beyond half a turn, whichever way, and so does the angle that samples tell; a
/// snapshot on the way keeps the count.
#[test]
fn a_torsion_spring_is_wound_beyond_half_a_turn() {
    let (stiffness, most, duration_s) = (7.0, 5.0, 1.6);
    let frequency = (stiffness / moment()).sqrt();
    let joint = JointId::new(0);
    for sign in [1.0, -1.0] {
        let rate = sign * most * frequency;
        for (method, allowed) in [(accurate(), 1e-9), (stepped(5e-4), 2e-3)] {
            let spring = Freedom::default().with_spring(stiffness, 0.0).unwrap();
            let turning = Velocity::new(DVec3::Y.cross(DVec3::X * (0.5 * ROD.1)) * rate, DVec3::Y * rate);
            let built = scene(method).duration_s(duration_s).body(level_rod().velocity(turning)).joint(hinge(spring));
            let built = built.build().unwrap();
            let mut simulation = Simulation::new(&built).unwrap();
            let mut between: Option<(i32, Snapshot)> = None;
            for tenth in 1..=16 {
                let t = 0.1 * f64::from(tenth);
                simulation.advance_to(t).unwrap();
                let angle = simulation.coordinate(joint, Coordinate::Angle).unwrap().value;
                let expected = sign * most * (frequency * t).sin();
                assert!((angle - expected).abs() < allowed, "t = {t}: {angle} rad instead of {expected}");
                if between.is_none() && angle.abs() > 4.0 {
                    between = Some((tenth, simulation.snapshot()));
                }
            }
            let end = simulation.body(BodyId::new(0));
            let (tenth, snapshot) = between.expect("it turns by more than 4 rad");
            simulation.restore(&snapshot).unwrap();
            (tenth + 1..=16).for_each(|tenth| simulation.advance_to(0.1 * f64::from(tenth)).unwrap());
            assert_eq!(simulation.body(BodyId::new(0)), end);
        }
    }
}

/// A damped servo to more than half a turn arrives there.
#[test]
fn a_servo_arrives_beyond_half_a_turn() {
    for (method, target) in [(accurate(), 4.0), (stepped(2e-3), 4.0), (stepped(2e-3), -9.0)] {
        let drive = Drive::Position { position: target, stiffness: 20.0, damping: 6.0 };
        let servo = Freedom::default().with_motor(Motor::new(drive).unwrap());
        let built = scene(method).duration_s(12.0).body(level_rod()).joint(hinge(servo)).build().unwrap();
        let mut simulation = Simulation::new(&built).unwrap();
        simulation.advance_to(12.0).unwrap();
        let angle = simulation.coordinate(JointId::new(0), Coordinate::Angle).unwrap();
        assert!((angle.value - target).abs() < 1e-7 && angle.rate.abs() < 1e-7, "{angle:?} instead of {target}");
    }
}

/// A servo of position without damping, at its bound most of the time: arcs of constant acceleration and of a harmonic
/// motion, where the effort has corners. After twenty and a half swings the body passes the target as these say.
#[test]
fn a_servo_leaves_its_bound_where_its_effort_has_a_corner() {
    let (mass, target, stiffness, most) = (1.0, 0.436, 1710.0, 345.0);
    let motor =
        Motor::new(Drive::Position { position: target, stiffness, damping: 0.0 }).unwrap().at_most(most).unwrap();
    let (reach, frequency) = (most / stiffness, f64::sqrt(stiffness / mass));
    let speed = (2.0 * most / mass * (target - reach)).sqrt();
    let amplitude = reach.hypot(speed / frequency);
    let swing = 2.0 * speed * mass / most + 2.0 * (reach / amplitude).asin() / frequency;
    let along = Freedom::default().with_motor(motor);
    let slider = Joint::new(JointKind::Slider { axis: UnitVector::X }, BodyId::new(0), DVec3::ZERO)
        .along(Coordinate::Displacement, along);
    let body = brick("b", DVec3::splat(0.1), DVec3::ZERO);
    let built = scene(accurate()).duration_s(20.5 * swing).body(body).joint(slider).build().unwrap();
    let (report, _) = run(&built, Effects::Planned);
    let state = report.bodies[0].state;
    let off = state.pose.translation.x - target;
    assert!(off.abs() < 2e-10, "{off:e} m off");
    assert!((state.velocity.linear.x - amplitude * frequency).abs() < 1e-9, "{:?}", state.velocity);
}

/// A rod on a hinge strikes a body on a slider with a spring. Until then each moved on its own: what the spring has
/// done by then is its potential energy, and no projection of the rod takes it.
#[test]
fn a_blow_on_a_body_with_a_spring_leaves_the_ledger_closed() {
    let spring = Freedom::default().with_spring(2000.0, -0.02).unwrap();
    let rod = brick("rod", DVec3::new(0.4, 0.05, 0.05), DVec3::X * 0.2);
    let falling = Velocity::new(DVec3::Z * 0.6, DVec3::Y * -3.0);
    let plate = brick("plate", DVec3::new(0.1, 0.1, 0.02), DVec3::new(0.38, 0.0, 0.05));
    let guide = Joint::new(JointKind::Slider { axis: UnitVector::Z }, BodyId::new(1), DVec3::new(0.38, 0.0, 0.05));
    let built = scene(accurate())
        .duration_s(0.2)
        .body(rod.velocity(falling))
        .body(plate)
        .joint(hinge(Freedom::default()))
        .joint(guide.along(Coordinate::Displacement, spring))
        .build()
        .unwrap();
    let (report, recorder) = run(&built, Effects::Planned);
    assert!(recorder.events.iter().any(|event| event.kind == polhode::EventKind::Impact));
    assert!(report.ledger.projection.value().abs() < 1e-10 * report.energy.initial_j, "{:?}", report.ledger);
    assert_closes(&report);
}
