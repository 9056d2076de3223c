//! Bodies with a prescribed motion in runs: what they do to others, against closed forms.

use crate::checks::{assert_closes, heavy_brick, max_position_error, root};
use crate::support::{accurate, ball, brick, elastic, floor, run};
use polhode::contact::Shape;
use polhode::scene::{Interpolation, Method, MotionTable, PrescribedMotion, SampledOrientations, Tier};
use polhode::spatial::{DVec3, Motion, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Effects, EventKind, Geometry, Recorder, Scene, SceneBuilder, Simulation, SimulationError};
use std::f64::consts::{FRAC_PI_2, TAU};

const G: f64 = 9.81;
const RADIUS: f64 = 0.2;

/// A slab 4 x 4 x 0.2 m. Its initial pose, unless the motion gives one, puts the top at z = 0.
fn slab(motion: PrescribedMotion) -> Body {
    let shape = Geometry::Shape(Shape::cuboid(DVec3::new(4.0, 4.0, 0.2)).unwrap());
    let body = Body::kinematic("slab", motion).geometry(shape);
    let place = body.initial_pose().translation;
    if place == DVec3::ZERO { body.pose(Pose::from_translation(DVec3::Z * -0.1)) } else { body }
}

/// A slab that goes up and down.
fn shaken(amplitude: f64, frequency: f64, phase: f64) -> Body {
    slab(PrescribedMotion::sine(DVec3::Z * amplitude, DVec3::ZERO, frequency, phase).unwrap())
}

/// A slab that passes through these heights of its top.
fn lifted(times: &[f64], heights: &[f64]) -> Body {
    let positions = heights.iter().map(|&height| DVec3::Z * (height - 0.1)).collect();
    let (times_s, positions_m) = (times.to_vec(), Some(positions));
    let table = MotionTable { times_s, positions_m, interpolation: Interpolation::Spline, ..MotionTable::default() };
    slab(PrescribedMotion::table(&table).unwrap())
}

fn steady(linear: DVec3, angular: DVec3) -> PrescribedMotion {
    PrescribedMotion::constant_velocity(Velocity::new(linear, angular)).unwrap()
}

fn scene(name: &str, duration_s: f64) -> SceneBuilder {
    Scene::builder(name).method(accurate()).duration_s(duration_s)
}

fn times_of(recorder: &Recorder, kind: EventKind) -> Vec<f64> {
    recorder.events.iter().filter(|event| event.kind == kind).map(|event| event.t_s).collect()
}

/// The largest distance of a body in run `one` from where it is in run `other` displaced by `drift` (m/s) times the
/// time.
fn apart(one: &Recorder, other: &Recorder, body: usize, drift: DVec3) -> f64 {
    let place = |recorder: &Recorder, k: usize| recorder.samples[k][body].pose.translation;
    let rows = one.times_s.iter().enumerate();
    rows.map(|(k, &t)| (place(one, k) - place(other, k) - drift * t).length()).fold(0.0, f64::max)
}

/// A ball in a lift whose acceleration stays above -g stays in contact, whatever its material; the force is
/// `m (g + a)`, the work of the lift is the change of the ball's energy, and its impulse that of the ball's momentum
/// and weight.
#[test]
fn ball_in_a_lift_bears_its_weight_and_its_acceleration() {
    let (amplitude, rate, phase, mass) = (0.1, TAU, 0.3, 1.7);
    let top = |t: f64| amplitude * (rate * t + phase).sin();
    let up = amplitude * rate * phase.cos();
    let ball = ball("ball", mass, RADIUS, DVec3::Z * (RADIUS + top(0.0)), DVec3::Z * up).material(elastic(0.7));
    let scene = scene("lift", 2.3).body(shaken(amplitude, 1.0, phase)).body(ball).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let worst = max_position_error(&recorder, 1, |t| DVec3::Z * (RADIUS + top(t)));
    assert!(worst < 1e-12 && recorder.events.is_empty(), "{worst:e} {:?}", recorder.events);
    assert_closes(&report);
    let (work, gained) = (report.ledger.external.value(), report.energy.final_j - report.energy.initial_j);
    assert!((work - gained).abs() < 1e-11 * report.ledger.scale_j && work.abs() > 0.1, "{work} {gained}");
    assert!(report.ledger.numerical.value().abs() < 1e-11 * report.ledger.scale_j, "{:?}", report.ledger);

    let mut simulation = Simulation::new(&scene).unwrap();
    for t in [0.0, 0.37, 0.8, 1.955] {
        simulation.advance_to(t).unwrap();
        let acceleration = -amplitude * rate * rate * (rate * t + phase).sin();
        let contacts = simulation.contacts();
        let force = contacts[0].normal_force_n / (mass * (G + acceleration));
        assert!(contacts.len() == 1 && (force - 1.0).abs() < 1e-12, "{t} {force}");
        for own in simulation.accelerations().unwrap() {
            assert!((own.linear.z - acceleration).abs() < 1e-12, "{t} {own:?}");
        }
    }
}

/// A shaker whose downward acceleration exceeds g throws a ball off when `a = -g`. The ball flies and meets the shaker
/// again at the root of a closed form. The impact is that with a wall of the same speed.
#[test]
fn shaker_throws_a_ball_off_when_it_accelerates_down_by_more_than_gravity() {
    let (amplitude, frequency, mass, e) = (0.05, 4.0, 0.6, 0.4);
    let rate = TAU * frequency;
    let top = |t: f64| amplitude * (rate * t - FRAC_PI_2).sin();
    let speed = |t: f64| amplitude * rate * (rate * t - FRAC_PI_2).cos();
    let ball = ball("ball", mass, RADIUS, DVec3::Z * (RADIUS - amplitude), DVec3::ZERO).material(elastic(e));
    let shaker = shaken(amplitude, frequency, -FRAC_PI_2).material(elastic(e));
    let off = ((G / (amplitude * rate * rate)).asin() + FRAC_PI_2) / rate;
    let flying = |t: f64| top(off) + speed(off) * (t - off) - 0.5 * G * (t - off).powi(2);
    let touch_s = root(off + 0.02, off + 0.5, |t| flying(t) - top(t));
    let scene = scene("shaker", touch_s + 0.02).body(shaker).body(ball).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);

    let detached = times_of(&recorder, EventKind::Detach);
    assert!(detached.len() == 1 && (detached[0] - off).abs() < 1e-9, "{detached:?} {off}");
    let worst = max_position_error(&recorder, 1, |t| {
        DVec3::Z * (RADIUS + if t < off { top(t) } else { flying(t.min(touch_s)) })
    });
    assert!(worst < 1e-10 || recorder.times_s.last().unwrap() > &touch_s, "{worst:e}");
    let impacts: Vec<_> = recorder.events.iter().filter(|event| event.kind == EventKind::Impact).collect();
    let approach = speed(touch_s) - (speed(off) - G * (touch_s - off));
    assert!(impacts.len() == 1 && (impacts[0].t_s - touch_s).abs() < 1e-9, "{impacts:?} {touch_s}");
    assert!((impacts[0].impulse / (mass * (1.0 + e) * approach) - 1.0).abs() < 1e-8, "{impacts:?}");
    let lost = 0.5 * mass * (1.0 - e * e) * approach * approach;
    assert!((report.ledger.impact.value() / lost - 1.0).abs() < 1e-8);
    assert_closes(&report);
    assert!(report.ledger.numerical.value().abs() < 1e-10 * report.ledger.scale_j);
}

/// A wall of velocity V gives a ball of velocity v the velocity `V + e (V - v)` and the impulse `p = m (1+e)(V - v)`.
/// The wall does the work `p V`, and the impact dissipates `m (1 - e^2)(V - v)^2/2`. A kinematic half-space does the
/// same as a box.
#[test]
fn moving_wall_strikes_a_ball() {
    let (mass, e, wall_speed, speed) = (1.3, 0.6, 2.0, -0.5);
    let shapes =
        [(Shape::cuboid(DVec3::ONE).unwrap(), DVec3::X * -0.5), (Shape::half_space(UnitVector::X), DVec3::ZERO)];
    for (shape, place) in shapes {
        let wall = Body::kinematic("wall", steady(DVec3::X * wall_speed, DVec3::ZERO))
            .geometry(Geometry::Shape(shape))
            .pose(Pose::from_translation(place))
            .material(elastic(e));
        let ball = ball("ball", mass, RADIUS, DVec3::X * (1.0 + RADIUS), DVec3::X * speed).material(elastic(e));
        let scene = scene("wall", 1.0).gravity(DVec3::ZERO).body(wall).body(ball).build().unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let meets = 1.0 / (wall_speed - speed);
        let after = wall_speed + e * (wall_speed - speed);
        let x = |t: f64| 1.0 + RADIUS + speed * t.min(meets) + after * (t - meets).max(0.0);
        let worst = max_position_error(&recorder, 1, |t| DVec3::X * x(t));
        assert!(worst < 1e-12, "{worst:e}");
        let (impulse, ledger) = (mass * (1.0 + e) * (wall_speed - speed), report.ledger);
        assert!((ledger.momentum.support.value().linear.x / impulse - 1.0).abs() < 1e-12);
        assert!((ledger.external.value() / (impulse * wall_speed) - 1.0).abs() < 1e-12);
        let lost = 0.5 * mass * (1.0 - e * e) * (wall_speed - speed) * (wall_speed - speed);
        assert!((ledger.impact.value() / lost - 1.0).abs() < 1e-12);
        assert_closes(&report);
    }
}

/// Without friction a surface that moves along itself moves no body: a box on a sliding table and a disc on a turntable
/// stay where they are, and no work is done.
#[test]
fn surfaces_that_move_along_themselves_move_nothing() {
    let sliding = PrescribedMotion::sine(DVec3::new(0.3, 0.2, 0.0), DVec3::ZERO, 1.2, 0.4).unwrap();
    let disc = Shape::cylinder(0.5, 0.2).unwrap();
    let turntable = Body::kinematic("turntable", steady(DVec3::ZERO, DVec3::Z * 3.5))
        .geometry(Geometry::Shape(Shape::cylinder(2.0, 0.2).unwrap()))
        .pose(Pose::from_translation(DVec3::Z * -0.1));
    let box_on = heavy_brick("body", 1.5, DVec3::new(0.5, 0.4, 0.2), DVec3::new(0.3, -0.2, 0.1));
    let disc_on =
        heavy_brick("body", 1.5, DVec3::new(0.5, 0.5, 0.2), DVec3::new(0.3, -0.2, 0.1)).geometry(Geometry::Shape(disc));
    for (table, body) in [(slab(sliding), box_on.clone()), (turntable.clone(), box_on), (turntable, disc_on)] {
        let scene = scene("along", 1.5).body(table).body(body).build().unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let (first, last) = (recorder.samples[0][1], recorder.samples.last().unwrap()[1]);
        assert!((first.pose.translation - last.pose.translation).length() < 1e-12, "{first:?} {last:?}");
        assert!(first.pose.rotation.angle_to(last.pose.rotation) < 1e-12 && last.velocity.linear.length() < 1e-12);
        assert!(report.ledger.external.value().abs() < 1e-12 * report.ledger.scale_j.max(1.0));
        assert_closes(&report);
    }
}

/// A ball follows a lift through the samples of a table, at which the third derivative of the motion jumps, and rests
/// when the lift has stopped.
#[test]
fn ball_follows_a_lift_with_corners() {
    let lift = lifted(&[0.2, 0.6, 1.2, 1.7], &[0.0, 0.05, 0.02, 0.1]);
    let trajectory = lift.trajectory().unwrap();
    let deepest = (0..200).map(|k| trajectory.acceleration(0.01 * f64::from(k)).linear.z).fold(0.0, f64::min);
    assert!((-9.0..-0.5).contains(&deepest), "{deepest}");
    let ball = ball("ball", 1.7, RADIUS, DVec3::Z * RADIUS, DVec3::ZERO);
    let scene = scene("corners", 2.5).body(lift).body(ball).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let worst = max_position_error(&recorder, 1, |t| trajectory.pose(t).translation + DVec3::Z * (0.1 + RADIUS));
    assert!(worst < 1e-12, "{worst:e}");
    let rests = times_of(&recorder, EventKind::Rest);
    assert!(rests.len() == 1 && (rests[0] - 1.7).abs() < 1e-12, "{rests:?}");
    assert!((report.ledger.external.value() / (1.7 * G * 0.1) - 1.0).abs() < 1e-10);
    assert_closes(&report);
}

/// A stack on a platform rests until the platform begins to move, wakes then, follows it, and rests again when it
/// stops.
#[test]
fn stack_follows_a_platform_that_starts_late() {
    let platform = lifted(&[1.0, 1.5], &[0.0, 0.1]);
    let trajectory = platform.trajectory().unwrap();
    let size = DVec3::new(0.5, 0.4, 0.2);
    let mut builder = scene("stack", 2.0).body(platform);
    for k in 0..3 {
        builder = builder.body(brick(&format!("brick {k}"), size, DVec3::Z * (0.1 + 0.2 * f64::from(k))));
    }
    let scene = builder.build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    for k in 0..3 {
        let above = DVec3::Z * (0.2 + 0.2 * f64::from(k));
        let worst = max_position_error(&recorder, 1 + k as usize, |t| trajectory.pose(t).translation + above);
        assert!(worst < 1e-11, "{k} {worst:e}");
    }
    let mut simulation = Simulation::new(&scene).unwrap();
    for (t, islands) in [(0.5, 1), (1.2, 1), (1.8, 1)] {
        simulation.advance_to(t).unwrap();
        assert_eq!(simulation.islands().len(), islands, "{t}");
    }
    for (kind, t) in [(EventKind::Wake, 1.0), (EventKind::Rest, 1.5)] {
        assert_eq!(times_of(&recorder, kind), [t; 3], "{kind:?}");
    }
    assert!((report.ledger.external.value() / (3.0 * G * 0.1) - 1.0).abs() < 1e-9);
    assert!(report.certificate.max_penetration_m < 1e-12);
    assert_closes(&report);
    assert_eq!(run(&scene, Effects::All).0.bodies, report.bodies);
}

/// Bodies that bounce and slide on a floor of constant velocity move as on a fixed floor, seen from a frame of that
/// velocity. The losses are the same, and the work of the floor is the rest of the change of energy.
#[test]
fn motion_does_not_depend_on_the_velocity_of_the_observer() {
    let runs = [DVec3::ZERO, DVec3::new(0.4, -0.3, 0.7)].map(|drift| {
        let support = slab(steady(drift, DVec3::ZERO)).material(elastic(0.5));
        let fixed = Body::fixed("slab").geometry(support.shape().unwrap().clone()).pose(*support.initial_pose());
        let support = if drift == DVec3::ZERO { fixed.material(elastic(0.5)) } else { support };
        let ball = ball("ball", 1.2, RADIUS, DVec3::new(-1.0, 0.0, 0.5), drift + DVec3::X * 0.1);
        let box_on = brick("box", DVec3::new(0.5, 0.4, 0.2), DVec3::new(0.5, 0.0, 0.1))
            .velocity(Velocity::new(drift + DVec3::Y * 0.2, DVec3::ZERO));
        let ball = ball.material(elastic(0.5));
        run(&scene("frame", 2.0).body(support).body(ball).body(box_on).build().unwrap(), Effects::Planned)
    });
    let drift = DVec3::new(0.4, -0.3, 0.7);
    let [(still, on_fixed), (moving, on_moving)] = &runs;
    for body in [1, 2] {
        let worst = apart(on_moving, on_fixed, body, drift);
        assert!(worst < 1e-10, "{body} {worst:e}");
    }
    let (a, b) = (&still.ledger, &moving.ledger);
    assert!((a.impact.value() / b.impact.value() - 1.0).abs() < 1e-9, "{a:?} {b:?}");
    assert!(a.rest.value() > 0.0 && (a.rest.value() / b.rest.value() - 1.0).abs() < 1e-6, "{a:?} {b:?}");
    let gained = moving.energy.final_j - moving.energy.initial_j;
    assert!((b.external.value() - b.impact.value() - b.rest.value() - gained).abs() < 1e-10 * b.scale_j);
    assert_closes(still);
    assert_closes(moving);
}

/// A half-space that tilts to and fro moves a ball on it as a wide slab does.
#[test]
fn tilting_half_space_is_a_wide_slab() {
    let motion = PrescribedMotion::sine(DVec3::Z * 0.02, DVec3::Y * 0.1, 0.7, 0.0).unwrap();
    let slab = Shape::cuboid(DVec3::new(40.0, 4.0, 0.2)).unwrap().translated(DVec3::Z * -0.1).unwrap();
    let runs = [slab, Shape::half_space(UnitVector::Z)].map(|shape| {
        let support = Body::kinematic("support", motion.clone()).geometry(Geometry::Shape(shape));
        let velocity = motion.from_pose(&Pose::IDENTITY).velocity(0.0);
        let start = DVec3::Z * RADIUS;
        let ball = ball("ball", 1.2, RADIUS, start, velocity.linear + velocity.angular.cross(start));
        run(&scene("tilt", 2.0).body(support).body(ball).build().unwrap(), Effects::Planned)
    });
    let [(on_slab, by_slab), (on_plane, by_plane)] = &runs;
    let worst = apart(by_plane, by_slab, 1, DVec3::ZERO);
    let moved = by_slab.samples.iter().map(|row| row[1].pose.translation.x.abs()).fold(0.0, f64::max);
    assert!(worst < 1e-10 && moved > 0.1, "{worst:e} {moved}");
    assert_closes(on_slab);
    assert_closes(on_plane);
    assert!(on_plane.ledger.numerical.value().abs() < 1e-10 * on_plane.ledger.scale_j);
}

/// A plough comes from far away, after its swept bounding box has been renewed thousands of times. It meets a
/// box at rest when it should and pushes it along without a bounce; a box beside its path stays at rest.
#[test]
fn plough_from_far_away() {
    let (speed, far) = (7.0, 350.0);
    let plough = Body::kinematic("plough", steady(DVec3::X * speed, DVec3::ZERO))
        .geometry(Geometry::Shape(Shape::cuboid(DVec3::new(1.0, 6.0, 1.0)).unwrap()))
        .pose(Pose::from_translation(DVec3::new(-far - 0.5, 0.0, 0.6)));
    let pushed = heavy_brick("box", 2.0, DVec3::new(0.5, 0.4, 1.2), DVec3::new(0.25, 2.0, 0.6));
    let bystander = heavy_brick("bystander", 2.0, DVec3::new(0.5, 0.4, 0.2), DVec3::new(0.25, 9.0, 0.1));
    let scene = scene("plough", 51.0).body(floor()).body(plough).body(pushed).body(bystander).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let meets = far / speed;
    let worst = max_position_error(&recorder, 2, |t| DVec3::new(0.25 + speed * (t - meets).max(0.0), 2.0, 0.6));
    assert!(worst < 1e-9, "{worst:e} {:?}", recorder.events);
    let impacts = times_of(&recorder, EventKind::Impact);
    assert!(!impacts.is_empty() && impacts.iter().all(|t| (t - meets).abs() < 1e-9), "{impacts:?}");
    assert_eq!(recorder.samples[0][3], recorder.samples.last().unwrap()[3]);
    // Half of the work m V^2 is lost in the impact.
    assert!((report.ledger.external.value() / (2.0 * speed * speed) - 1.0).abs() < 1e-9);
    assert!((report.ledger.impact.value() / (speed * speed) - 1.0).abs() < 1e-9);
    assert_closes(&report);
}

/// The motion is the same wherever a program stops the run to look at it, and with all effects on.
#[test]
fn stops_and_effects_do_not_change_the_motion() {
    let shaker = shaken(0.05, 3.0, -FRAC_PI_2).material(elastic(0.3));
    let ball = ball("ball", 0.6, RADIUS, DVec3::Z * (RADIUS - 0.05), DVec3::ZERO).material(elastic(0.3));
    let scene = scene("cut", 1.0).body(shaker).body(ball).build().unwrap();
    let whole = run(&scene, Effects::Planned);
    let mut simulation = Simulation::new(&scene).unwrap();
    for t in [0.013, 0.2, 0.2055, 0.61] {
        simulation.advance_to(t).unwrap();
        let place = simulation.body(simulation.body_id("slab").unwrap()).pose.translation.z;
        assert!((place + 0.1 - 0.05 * (TAU * 3.0 * t - FRAC_PI_2).sin()).abs() < 1e-15);
        assert!(simulation.contacts().iter().all(|contact| contact.separation_m.abs() < 1e-11));
    }
    let report = simulation.run().unwrap();
    let difference = report.bodies[1].state.pose.translation.z - whole.0.bodies[1].state.pose.translation.z;
    assert!(difference.abs() < 1e-9, "{difference:e}");
    let all = run(&scene, Effects::All).0;
    assert!((all.bodies[1].state.pose.translation.z - whole.0.bodies[1].state.pose.translation.z).abs() < 1e-9);
    assert_closes(&report);
}

/// When a program removes a platform, the ball on it falls from then on; a platform that it adds catches the ball.
#[test]
fn platforms_come_and_go() {
    let platform = || slab(steady(DVec3::Z * 0.3, DVec3::ZERO));
    let ball = ball("ball", 1.0, RADIUS, DVec3::Z * RADIUS, DVec3::Z * 0.3);
    let scene = scene("program", 3.0).body(platform()).body(ball).build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    let (slab, ball) = (simulation.body_id("slab").unwrap(), simulation.body_id("ball").unwrap());
    simulation.advance_to(0.5).unwrap();
    simulation.remove_body(slab).unwrap();
    simulation.advance_to(0.9).unwrap();
    let fallen = 0.15 + 0.3 * 0.4 - 0.5 * G * 0.16 + RADIUS;
    assert!((simulation.body(ball).pose.translation.z - fallen).abs() < 1e-12);
    // An added body moves as a function of the time of the run: its top is at z = -3 + 0.3 t.
    let lower = platform().pose(Pose::from_translation(DVec3::Z * -3.1));
    simulation.add_body(lower).unwrap();
    simulation.advance_to(2.5).unwrap();
    let z = simulation.body(ball).pose.translation.z;
    assert!((z - (-3.0 + 0.3 * 2.5 + RADIUS)).abs() < 1e-11, "{z}");
    assert_closes(&simulation.run().unwrap());
}

/// Tier `thesis` follows a lift with an error that falls with the step, and the work of the lift closes the ledgers.
#[test]
fn thesis_follows_a_lift() {
    let top = |t: f64| 0.1 * (TAU * t).sin();
    let errors = [2e-3, 1e-3].map(|step| {
        let method = Method { tier: Some(Tier::Thesis), step_s: Some(step), ..Method::default() };
        let ball = ball("ball", 1.0, RADIUS, DVec3::Z * RADIUS, DVec3::Z * (0.1 * TAU));
        let scene = scene("thesis", 1.0).method(method).body(shaken(0.1, 1.0, 0.0)).body(ball).build().unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        assert_closes(&report);
        max_position_error(&recorder, 1, |t| DVec3::Z * (RADIUS + top(t)))
    });
    assert!(errors[1] < 0.7 * errors[0] && errors[1] < 1e-2, "{errors:?}");
}

/// A shaker whose downward acceleration exceeds g for only two milliseconds throws a ball off when `a = -g`, also with
/// steps of ten milliseconds at both ends of which the ball is pressed on.
#[test]
fn a_loss_of_contact_within_a_step_is_not_missed() {
    let (amplitude, frequency) = (0.01, 5.0);
    let rate = TAU * frequency;
    // Gravity that the shaker exceeds by one part in two thousand.
    let g = amplitude * rate * rate / 1.0005;
    let method = Method { tolerance: Some(1e-3), step_s: Some(0.01), ..accurate() };
    for k in 0..10 {
        let phase = -1.0 + 0.04 * f64::from(k);
        let off = ((1.0 / 1.0005f64).asin() - phase) / rate;
        let (top, speed) = (amplitude * phase.sin(), amplitude * rate * phase.cos());
        let ball = ball("ball", 0.6, RADIUS, DVec3::Z * (RADIUS + top), DVec3::Z * speed);
        let scene = scene("short", 0.15).method(method.clone()).gravity(DVec3::Z * -g);
        let scene = scene.body(shaken(amplitude, frequency, phase)).body(ball).build().unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let detached = times_of(&recorder, EventKind::Detach);
        assert!(detached.len() == 1 && (detached[0] - off).abs() < 1e-6, "{k} {detached:?} {off}");
        assert_closes(&report);
    }
}

/// A ball that bounces on a shaker follows the recurrence of its impacts: each flight ends at the next root of a closed
/// form, where the velocity becomes `v' = V + e (V - v)`.
#[test]
fn ball_bounces_on_a_shaker_by_the_recurrence() {
    let (amplitude, frequency, phase, e) = (0.03, 3.0, 0.7, 0.8);
    let rate = TAU * frequency;
    let top = |t: f64| amplitude * (rate * t + phase).sin();
    let speed = |t: f64| amplitude * rate * (rate * t + phase).cos();
    let start = 0.5;
    let ball = ball("ball", 0.6, RADIUS, DVec3::Z * (RADIUS + start), DVec3::ZERO).material(elastic(e));
    let scene = scene("map", 7.0).body(shaken(amplitude, frequency, phase).material(elastic(e))).body(ball);
    let (report, recorder) = run(&scene.build().unwrap(), Effects::Planned);
    let impacts: Vec<_> = recorder.events.iter().filter(|event| event.kind == EventKind::Impact).collect();
    let (mut t0, mut z, mut v) = (0.0, start, 0.0);
    for impact in impacts.iter().take(8) {
        let gap = |dt: f64| z + v * dt - 0.5 * G * dt * dt - top(t0 + dt);
        let first = (1..10_000).map(|k| 1e-3 * f64::from(k)).find(|&dt| gap(dt) < 0.0).unwrap();
        let dt = root(first - 1e-3, first, gap);
        let (before, under) = (v - G * dt, speed(t0 + dt));
        let impulse = 0.6 * (1.0 + e) * (under - before);
        (t0, z, v) = (t0 + dt, top(t0 + dt), under + e * (under - before));
        assert!((impact.t_s - t0).abs() < 1e-8 && (impact.impulse / impulse - 1.0).abs() < 1e-7, "{impact:?} {t0}");
    }
    assert!(impacts.len() >= 8, "{}", impacts.len());
    assert_closes(&report);
    assert!(report.certificate.max_penetration_m < 1e-12, "{:?}", report.certificate);
}

/// A press descends on a ball on the floor, and no contact force can keep both from penetrating it. The run ends when
/// they meet, with an error that names press and ball; it neither hangs nor lets the press pass through.
#[test]
fn press_on_a_body_without_a_way_out() {
    let press = Body::kinematic("press", steady(DVec3::Z * -0.5, DVec3::ZERO))
        .geometry(Geometry::Shape(Shape::cuboid(DVec3::ONE).unwrap()))
        .pose(Pose::from_translation(DVec3::Z * 1.2));
    let ball = ball("ball", 1.0, RADIUS, DVec3::Z * RADIUS, DVec3::ZERO);
    let scene = scene("press", 1.5).body(floor()).body(press).body(ball).build().unwrap();
    let refused = Simulation::new(&scene).unwrap().run().unwrap_err();
    let SimulationError::NoWayOut { t_s: t, body_a, body_b, overlap_m } = &refused else { panic!("{refused}") };
    assert_eq!((body_a.as_str(), body_b.as_str()), ("press", "ball"));
    let met = (0.7 - 2.0 * RADIUS) / 0.5;
    assert!((t - met).abs() < 1e-2 && *overlap_m < 1e-2 * RADIUS, "{refused}");
}

/// A pusher that stands by a box on the floor wakes it when it begins to move, drives it, and lets it go when it slows
/// down.
#[test]
fn pusher_that_touches_from_the_start() {
    let table = MotionTable {
        times_s: vec![0.5, 1.0, 1.5],
        positions_m: Some(vec![DVec3::new(-0.5, 0.0, 0.5), DVec3::new(-0.4, 0.0, 0.5), DVec3::new(-0.3, 0.0, 0.5)]),
        interpolation: Interpolation::Spline,
        ..MotionTable::default()
    };
    let pusher = Body::kinematic("pusher", PrescribedMotion::table(&table).unwrap())
        .geometry(Geometry::Shape(Shape::cuboid(DVec3::new(1.0, 1.0, 0.6)).unwrap()));
    let trajectory = pusher.trajectory().unwrap();
    let fastest = root(0.5001, 0.95, |t| trajectory.acceleration(t).linear.x);
    let pushed = heavy_brick("box", 2.0, DVec3::new(0.4, 0.4, 1.0), DVec3::new(0.2, 0.0, 0.5));
    let scene = scene("pusher", 1.5).body(floor()).body(pusher).body(pushed).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let at = |t: f64| (trajectory.pose(t).translation.x + 0.7, trajectory.velocity(t).linear.x);
    let x = |t: f64| at(t.min(fastest)).0 + at(fastest).1 * (t - fastest).max(0.0);
    let worst = max_position_error(&recorder, 2, |t| DVec3::new(x(t), 0.0, 0.5));
    assert!(worst < 1e-9, "{worst:e} {:?}", recorder.events);
    assert_eq!(times_of(&recorder, EventKind::Wake), [0.5]);
    let gained = at(fastest).1 * at(fastest).1;
    assert!((report.ledger.external.value() / gained - 1.0).abs() < 1e-9);
    assert_closes(&report);
}

/// Balls in a closed box that is shaken and rocked stay in it and never penetrate its walls. The run gives no warning,
/// and the ledgers close.
#[test]
fn balls_in_a_shaken_box() {
    let wall = |size: DVec3, place: DVec3| Shape::cuboid(size).unwrap().translated(place).unwrap();
    let (wide, tall) = (DVec3::new(1.4, 1.4, 0.2), DVec3::new(0.2, 1.0, 1.0));
    let mut walls = vec![wall(wide, DVec3::Z * -0.6), wall(wide, DVec3::Z * 0.6)];
    for side in [-0.6, 0.6] {
        walls.push(wall(tall, DVec3::X * side));
        walls.push(wall(DVec3::new(1.0, 0.2, 1.0), DVec3::Y * side));
    }
    let shaking = PrescribedMotion::sine(DVec3::new(0.05, 0.03, 0.08), DVec3::new(0.15, 0.1, 0.05), 2.0, 0.0).unwrap();
    let walls = Body::kinematic("walls", shaking).geometry(Geometry::Shape(Shape::compound(walls).unwrap()));
    let trajectory = walls.trajectory().unwrap();
    let mut builder = scene("box", 1.5).body(walls.material(elastic(0.7)));
    for k in 0..6 {
        let place = DVec3::new(0.25 * f64::from(k % 3) - 0.25, 0.3 * f64::from(k / 3) - 0.2, 0.03 * f64::from(k) - 0.2);
        builder = builder.body(ball(&format!("ball {k}"), 0.3, 0.1, place, DVec3::ZERO).material(elastic(0.7)));
    }
    let (report, recorder) = run(&builder.build().unwrap(), Effects::Planned);
    for (&t, row) in recorder.times_s.iter().zip(&recorder.samples) {
        for own in &row[1..] {
            let seen = trajectory.pose(t).inverse_transform_point(own.pose.translation).abs().max_element();
            assert!(seen < 0.4 + 1e-9, "{t} {seen}");
        }
    }
    assert!(report.events > 30 && report.certificate.max_penetration_m < 1e-12, "{:?}", report.certificate);
    assert_closes(&report);
    assert!(report.ledger.numerical.value().abs() < 1e-9 * report.ledger.scale_j, "{:?}", report.ledger);
    assert!(report.warnings.is_empty(), "{:?}", report.warnings);
}

/// One of many slabs that spin, rock, drift and follow tables.
fn random_slab(seed: u32, random: impl Fn(u32) -> f64) -> Body {
    let vector = |k: u32| DVec3::new(random(k), random(k + 1), random(k + 2));
    let motion = match seed % 4 {
        0 => steady(DVec3::ZERO, DVec3::Y * (1.0 + 3.0 * random(1))),
        1 => PrescribedMotion::sine(vector(1) * 0.1, vector(4) * 0.5, 0.5 + 2.0 * random(7), random(8)).unwrap(),
        2 => steady(vector(1) - DVec3::new(0.5, 0.5, 0.0), vector(4) * 2.0),
        _ => PrescribedMotion::table(&MotionTable {
            times_s: vec![0.1, 0.4, 0.9, 1.4],
            positions_m: Some(vec![DVec3::ZERO, vector(1) * 0.2, vector(4) * 0.3, DVec3::ZERO]),
            orientations: Some(SampledOrientations::RotationVectors(vec![
                DVec3::ZERO,
                DVec3::Y * random(7),
                DVec3::X * random(8),
                DVec3::ZERO,
            ])),
            interpolation: Interpolation::Spline,
        })
        .unwrap(),
    };
    let shape = Shape::cuboid(DVec3::new(2.0, 2.0, 0.2)).unwrap();
    Body::kinematic("slab", motion).geometry(Geometry::Shape(shape))
}

/// Bodies fall on slabs that move in many ways: the ledgers close, energy is lost only in impacts, and no body
/// penetrates another.
#[test]
fn bodies_fall_on_moving_slabs() {
    for seed in 0..16 {
        let random = |k: u32| f64::from((seed * 7919 + k * 104_729 + 13) % 1000) / 1000.0;
        let support = floor().pose(Pose::from_translation(DVec3::Z * -1.5));
        let mut builder = scene("slabs", 2.0).body(random_slab(seed, random)).body(support);
        for k in 0..3 {
            let place = DVec3::new(0.7 * (f64::from(k) - 1.0), random(k + 10) - 0.5, 1.2 + 0.3 * f64::from(k));
            let turned = Rotation::from_rotation_vector(DVec3::new(random(k + 20), random(k + 30), 0.3));
            let body = match k {
                1 => ball("ball", 0.6, RADIUS, place, DVec3::ZERO),
                _ => brick(&format!("brick {k}"), DVec3::new(0.4, 0.3, 0.2), place).pose(Pose::new(turned, place)),
            };
            builder = builder.body(body.material(elastic(0.4 * random(6))));
        }
        let (report, _) = run(&builder.build().unwrap(), Effects::Planned);
        assert_closes(&report);
        let (ledger, scale) = (&report.ledger, report.ledger.scale_j);
        assert!(ledger.external.value() > 0.1 && ledger.impact.value() > 0.1, "{seed} {ledger:?}");
        assert!((0.0..1e-7 * scale).contains(&ledger.rest.value()), "{seed} {ledger:?}");
        let lost = ledger.numerical.value().abs() + ledger.projection.value().abs();
        assert!(lost < 1e-9 * scale, "{seed} {ledger:?}");
        assert!(report.certificate.max_penetration_m < 1e-12, "{seed} {:?}", report.certificate);
    }
}
