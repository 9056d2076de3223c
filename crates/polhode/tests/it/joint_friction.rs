//! Dry friction of joints: what moves comes to rest where the closed form says, sticks there, and starts again at the
//! effort of breakaway; what friction takes is the loss of the bodies, and between two bodies it is internal.

use crate::checks::{assert_closes, heavy_brick};
use crate::joints::{inertia, rod};
use crate::support::{accurate, ball, brick, run};
use polhode::scene::{
    Coordinate, Force, Frame, Freedom, Joint, JointFriction, JointKind, Limits, Method, Signal, Tier,
};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, Effects, Event, EventKind, Recorder, Scene, SceneBuilder, Simulation, Snapshot};

const G: f64 = 9.81;

/// Mass and length of a rod.
const ROD: (f64, f64) = (1.4, 0.8);

fn stepped(step_s: f64) -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(step_s), ..Method::default() }
}

fn scene(method: Method) -> SceneBuilder {
    Scene::builder("joint friction").method(method).gravity(DVec3::ZERO)
}

fn rough(effort: f64) -> Freedom {
    Freedom::default().with_friction(JointFriction::new(effort).unwrap())
}

fn hinge(freedom: Freedom) -> Joint {
    Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Y).along(Coordinate::Angle, freedom)
}

/// The moment of the rod about its end.
fn moment() -> f64 {
    inertia(ROD) + 0.25 * ROD.0 * ROD.1 * ROD.1
}

fn first(recorder: &Recorder, kind: EventKind) -> Option<&Event> {
    recorder.events.iter().find(|event| event.kind == kind)
}

/// A rod that spins on a hinge slows evenly, and stops after the angle at which friction has taken its energy; in time
/// steps within their error.
#[test]
fn a_spinning_rod_stops_after_the_angle_of_its_energy() {
    let (torque, rate) = (0.7, 3.0);
    for (method, allowed) in [(accurate(), 1e-11), (stepped(1e-3), 2e-5)] {
        let turning = Velocity::new(DVec3::Y.cross(DVec3::X * (0.5 * ROD.1)) * rate, DVec3::Y * rate);
        let body = rod("rod", ROD, DVec3::X * (0.5 * ROD.1), std::f64::consts::FRAC_PI_2).velocity(turning);
        let built = scene(method).duration_s(2.5).body(body).joint(hinge(rough(torque))).build().unwrap();
        let (report, recorder) = run(&built, Effects::Planned);
        let (end, whole) = (rate * moment() / torque, 0.5 * rate * rate * moment() / torque);
        for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
            let angle = if t < end { rate * t - 0.5 * torque / moment() * t * t } else { whole };
            let expected = DVec3::new(angle.cos(), 0.0, -angle.sin()) * (0.5 * ROD.1);
            let off = (row[0].pose.translation - expected).length();
            assert!(off < allowed, "t = {t}: {off:e} m off");
        }
        let energy = 0.5 * rate * rate * moment();
        assert!((report.ledger.friction.value() / energy - 1.0).abs() < allowed, "{:?}", report.ledger.friction);
        assert!(report.bodies[0].state.velocity.angular.length() < 1e-12);
        assert_closes(&report);
    }
}

/// A pendulum swings once and sticks where its weight, at the turning point, is less than friction bears. The turning
/// point solves `m g d (cos b - cos a) = T (a + b)`.
#[test]
fn a_pendulum_sticks_at_the_turning_point_that_friction_holds() {
    let (torque, start) = (2.2, 1.3);
    let weight = ROD.0 * G * 0.5 * ROD.1;
    let work = |end: f64| weight * (f64::cos(end) - f64::cos(start)) - torque * (start + end);
    let (mut below, mut above) = (-start, start);
    for _ in 0..200 {
        let middle = 0.5 * (below + above);
        if work(middle) > 0.0 { below = middle } else { above = middle }
    }
    assert!((weight * below.sin()).abs() < torque, "friction is to hold it at {below}");
    for (method, allowed) in [(accurate(), 1e-10), (stepped(1e-3), 2e-6)] {
        let built = scene(method).gravity(DVec3::Z * -G).duration_s(3.0);
        let place = DVec3::new(start.sin(), 0.0, -start.cos()) * (0.5 * ROD.1);
        let built = built.body(rod("rod", ROD, place, -start)).joint(hinge(rough(torque))).build().unwrap();
        let (report, _) = run(&built, Effects::Planned);
        let at = report.bodies[0].state.pose.translation;
        let angle = (-at.x).atan2(-at.z);
        assert!((angle - below).abs() < allowed, "{angle} for {below}");
        assert!(report.bodies[0].state.velocity.angular.length() < 1e-12);
        assert_closes(&report);
    }
}

/// What a joint does is told: a rough hinge that holds a pendulum off its lowest place bears its weight, and the moment
/// of it; a stop does the same; while it swings the force is that of Newton's law for its centre.
#[test]
fn joint_loads_are_those_of_statics_and_of_the_swing() {
    let (weight, angle) = (ROD.0 * G, 0.9_f64);
    let place = DVec3::new(angle.sin(), 0.0, -angle.cos()) * (0.5 * ROD.1);
    let held = weight * 0.5 * ROD.1 * angle.sin();
    let stop = Freedom::default().with_limits(Limits::new(-0.1, 0.0).unwrap());
    for freedom in [rough(1.5 * held), stop] {
        let built = scene(accurate()).gravity(DVec3::Z * -G).body(rod("rod", ROD, place, -angle)).joint(hinge(freedom));
        let mut simulation = Simulation::new(&built.build().unwrap()).unwrap();
        for t in [0.0, 0.2] {
            simulation.advance_to(t).unwrap();
            let load = simulation.joint_loads()[0];
            assert!((load.force_n - DVec3::Z * weight).length() < 1e-11, "{load:?}");
            assert!((load.moment_n_m - DVec3::Y * -held).length() < 1e-11, "{load:?}");
        }
    }
    let level = rod("rod", ROD, DVec3::X * (0.5 * ROD.1), std::f64::consts::FRAC_PI_2);
    let built = scene(accurate()).gravity(DVec3::Z * -G).body(level).joint(hinge(Freedom::default()));
    let mut simulation = Simulation::new(&built.build().unwrap()).unwrap();
    simulation.advance_to(0.35).unwrap();
    let acceleration = simulation.accelerations().unwrap()[0].linear;
    let load = simulation.joint_loads()[0];
    assert!((load.force_n - (acceleration + DVec3::Z * G) * ROD.0).length() < 1e-11 * weight, "{load:?}");
    let along = simulation.body(BodyId::new(0)).pose.translation.normalize();
    let gained = 2.0 * G * -simulation.body(BodyId::new(0)).pose.translation.z * ROD.0 / moment();
    let pull = ROD.0 * gained * 0.5 * ROD.1 - weight * along.z;
    assert!((load.force_n.dot(-along) - pull).abs() < 1e-9 * weight, "{load:?} for {pull}");
}

/// A torque that grows moves a rod when it exceeds the effort of breakaway, not before; from then on friction is that
/// of motion.
#[test]
fn a_growing_torque_starts_a_rod_at_breakaway() {
    let (effort, breakaway, growth) = (0.5, 0.8, 0.4);
    let friction = JointFriction::new(effort).unwrap().with_breakaway(breakaway).unwrap();
    let torque = Force::Applied {
        body: BodyId::new(0),
        force: DVec3::ZERO,
        torque: DVec3::Y * growth,
        frame: Frame::World,
        point: None,
        signal: Signal::polynomial(vec![0.0, 1.0]).unwrap(),
    };
    let body = rod("rod", ROD, DVec3::X * (0.5 * ROD.1), std::f64::consts::FRAC_PI_2);
    let built = scene(accurate()).duration_s(3.0).body(body).force(torque);
    let built = built.joint(hinge(Freedom::default().with_friction(friction))).build().unwrap();
    let (report, recorder) = run(&built, Effects::Planned);
    let start = breakaway / growth;
    let slide = first(&recorder, EventKind::Slide).expect("it starts");
    assert!((slide.t_s - start).abs() < 1e-9, "{} for {start}", slide.t_s);
    for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
        let s = (t - start).max(0.0);
        let rate = ((breakaway - effort) * s + 0.5 * growth * s * s) / moment();
        assert!((row[0].velocity.angular.y - rate).abs() < 1e-9, "t = {t}: {} for {rate}", row[0].velocity.angular.y);
    }
    assert_closes(&report);
}

/// Two bodies in free space that turn on a rough hinge against each other come to turn together; momentum stays, and
/// friction has taken the energy of their relative motion.
#[test]
fn friction_between_two_bodies_is_internal() {
    for (method, allowed) in [(accurate(), 1e-11), (stepped(1e-3), 1e-6)] {
        let is_accurate = method.tier == Some(Tier::Accurate);
        let rotor = brick("rotor", DVec3::new(0.3, 0.2, 0.1), DVec3::ZERO);
        let stator = brick("stator", DVec3::splat(0.4), DVec3::Z * 0.3);
        let moments = [&rotor, &stator].map(|body| body.mass_properties().unwrap().inertia().matrix().z_axis.z);
        let rate = 4.0;
        let rotor = rotor.velocity(Velocity::new(DVec3::ZERO, DVec3::Z * rate));
        let joint = Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Z)
            .with(BodyId::new(1))
            .along(Coordinate::Angle, rough(0.01));
        let built = scene(method).duration_s(4.0).body(rotor).body(stator).joint(joint).build().unwrap();
        let (report, recorder) = run(&built, Effects::Planned);
        let together = rate * moments[0] / (moments[0] + moments[1]);
        for body in &report.bodies {
            assert!(
                (body.state.velocity.angular - DVec3::Z * together).length() < allowed,
                "{:?}",
                body.state.velocity
            );
        }
        assert!(!is_accurate || first(&recorder, EventKind::Stick).is_some());
        let taken = 0.5 * rate * rate * moments[0] - 0.5 * together * rate * moments[0];
        assert!(
            (report.ledger.friction.value() / taken - 1.0).abs() < allowed.max(1e-10),
            "{:?}",
            report.ledger.friction
        );
        assert_closes(&report);
    }
}

/// A bead on a slider: pushed by less than its friction it stays to the last bit, by more it slides at the difference.
#[test]
fn a_bead_slides_only_under_more_than_its_friction() {
    let axis = UnitVector::new(DVec3::new(0.5, -0.2, 0.7)).unwrap();
    for method in [accurate(), stepped(1e-2)] {
        for push in [1.9, 2.6] {
            let joint = Joint::new(JointKind::Slider { axis }, BodyId::new(0), DVec3::X)
                .along(Coordinate::Displacement, rough(2.0));
            let (force, torque) = (axis.get() * push, DVec3::ZERO);
            let (frame, signal) = (Frame::World, Signal::ONE);
            let force = Force::Applied { body: BodyId::new(0), force, torque, frame, point: None, signal };
            let body = brick("bead", DVec3::splat(0.1), DVec3::ZERO);
            let mass = body.mass_properties().unwrap().mass();
            let built = scene(method.clone()).duration_s(1.0).body(body).joint(joint).force(force).build().unwrap();
            let (report, _) = run(&built, Effects::Planned);
            let way = axis.get() * (0.5 * (push - 2.0_f64).max(0.0) / mass);
            let off = (report.bodies[0].state.pose.translation - way).length();
            assert!(off <= 1e-12 * way.length(), "{push}: {off:e} m off");
            assert_closes(&report);
        }
    }
}

/// A rod that spins on a bearing of radius `r` with the coefficient `mu` is slowed by the force that turns its centre:
/// with `k = mu r` and `R = m d sqrt(w^4 + w'^2)` that is `w' = -c w^2`, `c = k m d/sqrt(I^2 - (k m d)^2)`.
#[test]
fn a_bearing_slows_a_rod_by_the_load_of_its_spin() {
    let (coefficient, radius, rate) = (0.3, 0.05, 6.0);
    let (lever, moment) = (0.5 * ROD.1, moment());
    let held = coefficient * radius * ROD.0 * lever;
    let decay = held / (moment * moment - held * held).sqrt();
    for (method, allowed) in [(accurate(), 1e-11), (stepped(1e-3), 5e-5)] {
        let turning = Velocity::new(DVec3::Y.cross(DVec3::X * lever) * rate, DVec3::Y * rate);
        let body = rod("rod", ROD, DVec3::X * lever, std::f64::consts::FRAC_PI_2).velocity(turning);
        let bearing = JointFriction::default().with_bearing(coefficient, radius).unwrap();
        let joint = hinge(Freedom::default().with_friction(bearing));
        let built = scene(method).duration_s(2.0).body(body).joint(joint).build().unwrap();
        let (report, recorder) = run(&built, Effects::Planned);
        for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
            let expected = rate / (1.0 + decay * rate * t);
            let off = (row[0].velocity.angular.y / expected - 1.0).abs();
            assert!(off < allowed, "t = {t}: {} for {expected}", row[0].velocity.angular.y);
        }
        assert_closes(&report);
    }
}

/// A bead on a level wire with friction slides as a box on a floor, and stays under a push that its weight holds.
#[test]
fn a_bead_on_a_level_wire_slides_like_a_box_on_a_floor() {
    let (coefficient, speed) = (0.2, 1.5);
    let axis = UnitVector::new(DVec3::new(0.6, 0.8, 0.0)).unwrap();
    let wire = JointFriction::default().with_bearing(coefficient, 1.0).unwrap();
    for method in [accurate(), stepped(1e-2)] {
        let joint = Joint::new(JointKind::Slider { axis }, BodyId::new(0), DVec3::ZERO)
            .along(Coordinate::Displacement, Freedom::default().with_friction(wire));
        let body =
            brick("bead", DVec3::splat(0.1), DVec3::ZERO).velocity(Velocity::new(axis.get() * speed, DVec3::ZERO));
        let built = scene(method.clone()).gravity(DVec3::Z * -G).duration_s(1.5).body(body).joint(joint);
        let (report, _) = run(&built.build().unwrap(), Effects::Planned);
        let way = axis.get() * (0.5 * speed * speed / (coefficient * G));
        let off = (report.bodies[0].state.pose.translation - way).length();
        let allowed = if method.tier == Some(Tier::Accurate) { 1e-12 } else { 1e-3 };
        assert!(off < allowed, "{off:e} m off");
        assert!(report.bodies[0].state.velocity.linear.length() < 1e-12);
        assert_closes(&report);
    }
}

/// A run that goes on from a snapshot, while a rod slips and while it sticks, has the bits of the run that went on.
#[test]
fn a_snapshot_keeps_joints_that_slip_or_stick() {
    for method in [accurate(), stepped(1e-2)] {
        let turning = Velocity::new(DVec3::Y.cross(DVec3::X * (0.5 * ROD.1)) * 2.0, DVec3::Y * 2.0);
        let body = rod("rod", ROD, DVec3::X * (0.5 * ROD.1), std::f64::consts::FRAC_PI_2).velocity(turning);
        let built = scene(method).duration_s(2.0).body(body).joint(hinge(rough(0.7))).build().unwrap();
        for t in [0.3, 1.4] {
            let mut whole = Simulation::new(&built).unwrap();
            whole.advance_to(t).unwrap();
            let snapshot = Snapshot::from_bytes(&whole.snapshot().to_bytes()).unwrap();
            let mut restored = Simulation::new(&built).unwrap();
            restored.restore(&snapshot).unwrap();
            for simulation in [&mut whole, &mut restored] {
                simulation.advance_to(2.0).unwrap();
            }
            assert_eq!(restored.snapshot().to_bytes(), whole.snapshot().to_bytes());
        }
    }
}

/// A bearing that locks itself is left to time steps. A snapshot among them was refused, because the contact of a joint
/// with the world is between a body and itself; then the error of such a stretch was not known.
#[test]
fn a_snapshot_among_time_steps_keeps_a_joint_with_the_world() {
    let turning = Velocity::new(DVec3::Y.cross(DVec3::X * (0.5 * ROD.1)) * 6.0, DVec3::Y * 6.0);
    let body = heavy_brick("rod", 1.4, DVec3::new(0.8, 0.02, 0.02), DVec3::X * 0.4).velocity(turning);
    let locking = JointFriction::default().with_bearing(1.0, 0.7).unwrap();
    let joint = hinge(Freedom::default().with_friction(locking));
    let built = scene(accurate()).duration_s(0.2).body(body).joint(joint).build().unwrap();
    let mut whole = Simulation::new(&built).unwrap();
    let mut restored = Simulation::new(&built).unwrap();
    whole.advance_to(0.013).unwrap();
    restored.restore(&Snapshot::from_bytes(&whole.snapshot().to_bytes()).unwrap()).unwrap();
    for simulation in [&mut whole, &mut restored] {
        simulation.advance_to(0.2).unwrap();
    }
    assert_eq!(restored.snapshot().to_bytes(), whole.snapshot().to_bytes());
}

/// A heavy body on a light rough rotor: what holds a joint of unlike masses is not lost in their ratio.
#[test]
fn a_heavy_pendulum_on_a_rough_hinge_sticks_whatever_the_ratio_of_masses() {
    for ratio in [1.0, 1e3, 1e6] {
        let carrier = brick("carrier", DVec3::splat(0.1), DVec3::ZERO);
        let load = heavy_brick("load", ratio, DVec3::splat(0.2), DVec3::X * 0.5);
        let weight = ratio * G * 0.5;
        let fixed = Joint::new(JointKind::Fixed, BodyId::new(1), DVec3::X * 0.25).with(BodyId::new(0));
        let built = scene(accurate()).gravity(DVec3::Z * -G).duration_s(0.5).body(carrier).body(load);
        let built = built.joint(hinge(rough(1.01 * weight))).joint(fixed).build().unwrap();
        let (report, recorder) = run(&built, Effects::Planned);
        assert_eq!(recorder.samples[0], *recorder.samples.last().unwrap(), "ratio {ratio}");
        assert_closes(&report);
    }
}

/// What friction of a joint cannot be is refused with a reason.
#[test]
fn friction_that_no_joint_can_have_is_refused() {
    for effort in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(JointFriction::new(effort).is_err(), "{effort}");
    }
    for breakaway in [0.9, f64::NAN, f64::INFINITY] {
        assert!(JointFriction::new(1.0).unwrap().with_breakaway(breakaway).is_err(), "{breakaway}");
    }
    // Friction without an effort and without a bearing is no friction.
    let body = heavy_brick("rod", 1.0, DVec3::new(0.8, 0.1, 0.1), DVec3::X * 0.4);
    let none = Freedom::default().with_friction(JointFriction::default());
    let error = scene(accurate()).body(body).joint(hinge(none)).build().unwrap_err();
    assert!(error.to_string().contains("neither an effort nor a bearing"), "{error}");
}

/// Friction is a finite force: an impact lasts for no time, so that a rough hinge takes the same impulse as a smooth
/// one, to the rounding of the solution, however large its friction is.
#[test]
fn impacts_take_no_friction_of_joints() {
    let struck = |freedom: Freedom| {
        let rod = brick("rod", DVec3::new(0.8, 0.1, 0.1), DVec3::X * 0.4);
        let ball = ball("ball", 0.3, 0.05, DVec3::new(0.7, 0.0, 0.3), DVec3::Z * -2.0);
        let built = scene(accurate()).duration_s(0.2).body(rod).body(ball).joint(hinge(freedom)).build().unwrap();
        let (_, recorder) = run(&built, Effects::Planned);
        let impact = *first(&recorder, EventKind::Impact).unwrap();
        (impact.t_s, impact.impulse, impact.energy_change_j)
    };
    let smooth = struck(Freedom::default());
    for effort in [1e-3, 1.0, 1e3] {
        let (t, impulse, change) = struck(rough(effort));
        let differs = (impulse - smooth.1).abs().max((change - smooth.2).abs());
        assert!((t - smooth.0).abs() < 1e-12 && differs < 1e-12, "{effort} N m: {differs:e}");
    }
}

/// A cab that comes to a stop within a step, at any part of it, stays where breakaway holds its weight, though friction
/// in motion would not: `v^2/(2 (g + F/m))` above where it was.
#[test]
fn a_cab_that_stops_within_a_step_stays() {
    let (effort, breakaway, step_s) = (2.5, 12.5, 1e-2);
    let friction = JointFriction::new(effort).unwrap().with_breakaway(breakaway).unwrap();
    let slowing = G + effort;
    for part in 0..10 {
        let speed = slowing * step_s * (20.05 + 0.1 * f64::from(part));
        let cab = brick("cab", DVec3::splat(0.2), DVec3::ZERO).velocity(Velocity::new(DVec3::Z * speed, DVec3::ZERO));
        let freedom = Freedom::default().with_friction(friction);
        let slider = Joint::new(JointKind::Slider { axis: UnitVector::Z }, BodyId::new(0), DVec3::ZERO);
        let built = scene(stepped(step_s)).gravity(DVec3::Z * -G).duration_s(0.5).body(cab);
        let built = built.joint(slider.along(Coordinate::Displacement, freedom)).build().unwrap();
        let (report, _) = run(&built, Effects::Planned);
        let off = report.bodies[0].state.pose.translation.z - 0.5 * speed * speed / slowing;
        assert!(off.abs() < 1e-9, "it stops at {part} tenths of a step: {off:e} m off");
        assert_closes(&report);
    }
}

/// A parallelogram of so many parallel cranks, of which the first one rubs in its bearing, turned about the vertical by
/// this angle.
fn cranks(count: usize, turn: f64) -> Scene {
    let attitude = Rotation::from_rotation_vector(DVec3::Z * turn);
    let at = |x: f64, z: f64| attitude.rotate(DVec3::new(x, 0.0, z));
    let axis = UnitVector::new(attitude.rotate(DVec3::Y)).unwrap();
    let inertia = Inertia::from_diagonal(DVec3::splat(0.01)).unwrap();
    let bar = |name: String, place: DVec3| {
        let properties = MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia);
        Body::movable(name, properties).pose(Pose::from_translation(place))
    };
    let mut scene = Scene::builder("cranks").method(accurate()).duration_s(0.01);
    let coupler = scene.add_body(bar("coupler".to_owned(), at(0.55, 0.1)));
    let bearing = JointFriction::default().with_bearing(0.15, 0.08).unwrap();
    for (k, x) in [0.0, 0.5, 0.25].into_iter().enumerate().take(count) {
        let crank = scene.add_body(bar(format!("crank {k}"), at(x + 0.15, 0.05)));
        let hinge = Joint::hinge(crank, at(x, 0.0), axis);
        let rough = Freedom::default().with_friction(bearing);
        let hinge = if k == 0 { hinge.along(Coordinate::Angle, rough) } else { hinge };
        scene = scene.joint(hinge).joint(Joint::hinge(crank, at(x + 0.3, 0.1), axis).with(coupler));
    }
    scene.build().unwrap()
}

/// With a third crank the load of the first one's bearing is one of many, and so is the motion, without a word: turned
/// about the vertical the scene moved differently. With two cranks there is one load, and nothing to say.
#[test]
fn friction_of_a_bearing_whose_load_is_not_unique_turns_with_the_world_unsaid() {
    for turn in [0.0, 1.0, 2.0] {
        for (count, is_open) in [(2, false), (3, true)] {
            let (report, _) = run(&cranks(count, turn), Effects::Planned);
            let told = report.warnings.iter().any(|warning| warning.contains("loads of bearings"));
            assert_eq!(told, is_open, "{count} cranks, turned by {turn}: {:?}", report.warnings);
        }
    }
}
