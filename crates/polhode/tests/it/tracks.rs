//! Tracks: a point of a body follows a curve. Beads on circles and cycloids have the periods of pendulums, a car on a
//! hill leaves it where the force of a track that only pushes is zero (JT-10 of the reference catalogue, and the same
//! with other numbers), and lands where its parabola meets the track again. A track does no work, so that energy stays,
//! and no point leaves it.

use crate::checks::{assert_closes, complete_elliptic, root};
use crate::support::{accurate, ball, brick, run};
use polhode::scene::{
    Coordinate, Drive, Follows, Freedom, Joint, JointFriction, JointKind, Limits, Method, Motor, OneSide, SceneError,
    Tier, TrackEnds, TrackHold, TrackId, TrackSprings,
};
use polhode::spatial::curve::{Bend, Coil, Curve, Rolling, SplineEnds, Wave};
use polhode::spatial::{DQuat, DVec3, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, Effects, Event, EventKind, JointId, Recorder, Scene, SceneBuilder, Simulation, Snapshot};
use std::f64::consts::TAU;

const G: f64 = 9.81;

fn stepped(step_s: f64) -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(step_s), ..Method::default() }
}

const BOTH: TrackHold = TrackHold::Both(Follows::Point);

fn one_side(towards: DVec3) -> TrackHold {
    TrackHold::OneSide(OneSide { towards: UnitVector::new(towards).unwrap(), restitution: 0.0 })
}

/// A point car at a place with a velocity, on a curve.
fn car(curve: Curve, hold: TrackHold, place: DVec3, velocity: DVec3) -> SceneBuilder {
    on_track(curve, hold, TrackEnds::Free, place, velocity)
}

fn on_track(curve: Curve, hold: TrackHold, ends: TrackEnds, place: DVec3, velocity: DVec3) -> SceneBuilder {
    let mut scene = Scene::builder("car").method(accurate());
    let track = scene.add_track(curve);
    let kind = JointKind::Track { track, hold, ends };
    scene.body(bead(place, velocity)).joint(Joint::new(kind, BodyId::new(0), place))
}

fn bead(place: DVec3, velocity: DVec3) -> Body {
    ball("bead", 1.3, 0.05, place, velocity)
}

fn first(recorder: &Recorder, kind: EventKind) -> Option<&Event> {
    recorder.events.iter().find(|event| event.kind == kind)
}

/// The circle of this radius about the origin in the x-z plane, from its lowest point.
fn upright_circle(radius: f64) -> Curve {
    Curve::circle(DVec3::ZERO, -UnitVector::Y, -DVec3::Z * radius).unwrap()
}

/// A bead on an upright circle swings as a pendulum: the periods of JT-01, and its angle after a second.
#[test]
fn a_bead_on_a_circle_has_the_period_of_a_pendulum() {
    let periods = [(10.0_f64, 2.009892627298601), (90.0, 2.3678419475762373), (150.0, 3.5350981863815236)];
    for (degrees, period) in periods {
        let angle = degrees.to_radians();
        let place = DVec3::new(angle.sin(), 0.0, -angle.cos());
        let scene = car(upright_circle(1.0), BOTH, place, DVec3::ZERO).duration_s(10.0).build().unwrap();
        let mut simulation = Simulation::new(&scene).unwrap();
        for quarter in [1.0, 3.0] {
            simulation.advance_to(0.25 * quarter * period).unwrap();
            let at = simulation.body(BodyId::new(0));
            let late = at.pose.translation.x / at.velocity.linear.x;
            assert!(late.abs() < 1e-11 * period * quarter, "{degrees}: {late:e}");
        }
        let along = simulation.coordinate(JointId::new(0), Coordinate::Displacement).unwrap();
        assert!((along.value + angle).abs() < 1e-9, "{along:?}");
    }
    let scene = car(upright_circle(1.0), BOTH, DVec3::X, DVec3::ZERO).duration_s(2.0).build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(1.0).unwrap();
    let at = simulation.body(BodyId::new(0)).pose.translation;
    assert!((at.x.atan2(-at.z) + 1.405027311524799).abs() < 1e-10);
}

/// On a cycloid every swing lasts as long, `T = 4 pi sqrt(R/g)`, whatever its amplitude (Huygens).
#[test]
fn swings_on_a_cycloid_are_isochronous() {
    let radius = 0.6;
    let curve = Curve::cycloid(DVec3::ZERO, UnitVector::X, DVec3::Z, Rolling { radius, reach: 3.0 }).unwrap();
    let period = 2.0 * TAU * (radius / G).sqrt();
    for part in [0.05, 0.3, 0.49] {
        let start = curve.at(curve.length() * (0.5 + part));
        let scene = car(curve.clone(), BOTH, start.point, DVec3::ZERO).duration_s(4.0).build().unwrap();
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(0.75 * period).unwrap();
        let at = simulation.body(BodyId::new(0));
        assert!((at.pose.translation.x / at.velocity.linear.x).abs() < 1e-10 * period, "{part} {at:?}");
    }
}

/// A closed spline in space.
fn round_in_space() -> Curve {
    let points = [[0., 0., 2.], [1., 0.5, 1.2], [2., 1.5, 1.0], [1., 2.5, 1.5], [-0.5, 2., 1.0], [-1., 1., 0.8]];
    Curve::spline(&points.map(DVec3::from), SplineEnds::Closed).unwrap()
}

/// Down a slope, through a clothoid into an arc, and on by these parts.
fn bend_down_a_slope(then: &[Bend]) -> Curve {
    let down = UnitVector::new(DVec3::new(1.0, 0.0, -0.7)).unwrap();
    let bends = [
        Bend { length: 2.0, curvature: [0.0, 0.0] },
        Bend { length: 1.5, curvature: [0.0, 0.9] },
        Bend { length: 1.0, curvature: [0.9, 0.9] },
    ];
    Curve::path(DVec3::ZERO, down, DVec3::Z, &[&bends, then].concat()).unwrap()
}

/// On curves of all kinds, in the plane and in space, energy stays to 1e-12 of what moves, and the point on the track
/// to 1e-12 m.
#[test]
fn energy_stays_and_no_point_leaves_its_track() {
    let curves = [
        round_in_space(),
        bend_down_a_slope(&[Bend { length: 30.0, curvature: [0.0, 0.0] }]),
        Curve::wave(DVec3::ZERO, UnitVector::X, DVec3::Z, Wave { amplitude: 0.5, wavelength: 3.0, length: 90.0 })
            .unwrap(),
    ];
    for curve in curves {
        let start = curve.at(0.2);
        let scene = car(curve.clone(), BOTH, start.point, start.tangent * 2.0).duration_s(3.0);
        let (report, recorder) = run(&scene.build().unwrap(), Effects::Planned);
        for row in &recorder.samples {
            let place = row[0].pose.translation;
            let off = (place - curve.nearest(place).point).length();
            assert!(off < 1e-12, "{off:e}");
        }
        let first = &recorder.samples[0][0];
        let energy = |place: DVec3, velocity: DVec3| 0.5 * velocity.length_squared() + G * place.z;
        let scale = G * 2.0 + 2.0;
        for row in &recorder.samples {
            let change = energy(row[0].pose.translation, row[0].velocity.linear)
                - energy(first.pose.translation, first.velocity.linear);
            assert!(change.abs() < 1e-12 * scale, "{change:e}");
        }
        assert_closes(&report);
    }
}

/// Where a car pushed off on a one-sided track leaves it: that place, and its speed there.
fn leaves_at(curve: Curve, place: DVec3, velocity: DVec3, duration_s: f64) -> Option<(DVec3, f64)> {
    let scene = car(curve, one_side(DVec3::Z), place, velocity).duration_s(duration_s).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    assert_closes(&report);
    let event = first(&recorder, EventKind::Detach)?;
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(event.t_s).unwrap();
    Some((event.point, simulation.body(BodyId::new(0)).velocity.linear.length()))
}

/// JT-10: a car on a circular hill, pushed off the top, leaves it where `cos a = 2/3 + v0^2/(3 g R)`; above `sqrt(g R)`
/// at the top.
#[test]
fn a_car_leaves_a_round_hill_where_the_force_is_zero() {
    for (radius, speed) in [(10.0, 3.0), (10.0, 0.5), (4.0, 2.0), (0.7, 2.0), (10.0, 9.9)] {
        let hill = Curve::circle(DVec3::ZERO, UnitVector::Y, DVec3::Z * radius).unwrap();
        let (point, _) = leaves_at(hill, DVec3::Z * radius, DVec3::X * speed, 4.0).expect("it leaves the hill");
        let cosine: f64 = 2.0 / 3.0 + speed * speed / (3.0 * G * radius);
        let angle = point.x.atan2(point.z);
        assert!((angle / cosine.acos() - 1.0).abs() < 1e-10, "{radius} {speed}: {angle} for {}", cosine.acos());
    }
    let angle = (2.0_f64 / 3.0 + 9.0 / (3.0 * G * 10.0)).acos().to_degrees();
    assert!((angle / 45.79339792028449 - 1.0).abs() < 1e-14);
    let hill = Curve::circle(DVec3::ZERO, UnitVector::Y, DVec3::Z * 10.0).unwrap();
    let scene =
        car(hill, one_side(DVec3::Z), DVec3::Z * 10.0, DVec3::X * 9.904544411531508).duration_s(0.5).build().unwrap();
    let (_, recorder) = run(&scene, Effects::Planned);
    for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
        let expected = DVec3::new(9.904544411531508 * t, 0.0, 10.0 - 0.5 * G * t * t);
        assert!((row[0].pose.translation - expected).length() < 1e-12, "{t}");
    }
}

/// JT-10: on `z = -x^4/4` it leaves where `g s^3/2 + 3 v0^2 s = g`, `s = x^2`, with the speed of its fall.
#[test]
fn a_car_leaves_a_quartic_hill_where_the_force_is_zero() {
    for (speed, x, at) in [(1.0, 1.0483832953650774, 2.631619901545536), (2.0, 0.8280764603940333, 2.5112400105098147)]
    {
        let coefficients = [DVec3::ZERO, DVec3::X, DVec3::ZERO, DVec3::ZERO, DVec3::Z * -0.25];
        let hill = Curve::polynomial(&coefficients, [-1.0, 3.0]).unwrap();
        let (point, found) = leaves_at(hill, DVec3::ZERO, DVec3::X * speed, 2.0).expect("it leaves the hill");
        assert!((point.x / x - 1.0).abs() < 1e-10, "{} for {x}", point.x);
        assert!((found / at - 1.0).abs() < 1e-10, "{found} for {at}");
    }
}

/// JT-10: on the parabola `z = -x^2/(2 p)`, the path of a throw with `sqrt(g p)`, a car that is slower at the apex
/// never leaves, and one that is faster leaves there.
#[test]
fn a_car_leaves_a_parabola_at_its_apex_or_never() {
    for p in [1.0, 0.37] {
        let parabola = || {
            let coefficients = [DVec3::ZERO, DVec3::X, DVec3::Z * (-0.5 / p)];
            Curve::polynomial(&coefficients, [-1.0, 20.0]).unwrap()
        };
        let threshold = (G * p).sqrt();
        let slower = leaves_at(parabola(), DVec3::ZERO, DVec3::X * (threshold * (1.0 - 1e-6)), 2.0);
        assert!(slower.is_none(), "{slower:?}");
        let scene = car(parabola(), one_side(DVec3::Z), DVec3::ZERO, DVec3::X * (threshold * (1.0 + 1e-6)));
        let (_, recorder) = run(&scene.duration_s(0.5).build().unwrap(), Effects::Planned);
        for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
            let thrown = DVec3::new(threshold * (1.0 + 1e-6) * t, 0.0, -0.5 * G * t * t);
            assert!((row[0].pose.translation - thrown).length() < 1e-12, "{t}");
        }
    }
}

/// JT-10: on `z = cos x` with 3.1 m/s at a crest it never leaves, and presses as the centripetal force says; with more
/// than `sqrt(g)` it leaves at the crest.
#[test]
fn a_car_on_a_wave_presses_as_its_curvature_says() {
    let wave = || {
        Curve::wave(DVec3::ZERO, UnitVector::X, DVec3::Z, Wave { amplitude: 1.0, wavelength: TAU, length: 6.0 })
            .unwrap()
    };
    let forces = [(0.5, 1.1169893625595986), (1.0, 2.997201002906231), (1.5, 6.246475416147462)];
    let scene = on_track(wave(), one_side(DVec3::Z), TrackEnds::Straight, DVec3::Z, DVec3::X * 3.1);
    let scene = scene.duration_s(1.0).build().unwrap();
    let (_, recorder) = run(&scene, Effects::Planned);
    assert!(first(&recorder, EventKind::Detach).is_none());
    for (x, force) in forces {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..48 {
            let t = 0.5 * (low + high);
            let mut simulation = Simulation::new(&scene).unwrap();
            simulation.advance_to(t).unwrap();
            if simulation.body(BodyId::new(0)).pose.translation.x < x { low = t } else { high = t }
        }
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(high).unwrap();
        let found = simulation.joint_loads()[0].force_n.length() / 1.3;
        assert!((found / force - 1.0).abs() < 1e-9, "{found} for {force} at {x}");
    }
    let (point, _) = leaves_at(wave(), DVec3::Z, DVec3::X * 3.133, 0.2).expect("it leaves the crest");
    assert!(point.x < 1e-9, "{point}");
}

/// JT-10: a bead that starts at the bottom of a loop with `v^2 = 4 g R` leaves it at the angle with the cosine -2/3;
/// with `5 g R` it is just held at the top, and with a little less it is not: the height of fall `h = 5/2 R`. Other
/// radii and speeds: `cos a = (2 - v^2/(g R))/3`.
#[test]
fn a_bead_leaves_a_loop_where_the_force_is_zero() {
    for (radius, share) in [(1.0_f64, 4.0_f64), (2.5, 3.0), (0.4, 4.9)] {
        let speed = (share * G * radius).sqrt();
        let scene = car(upright_circle(radius), one_side(DVec3::Z), -DVec3::Z * radius, DVec3::X * speed);
        let (report, recorder) = run(&scene.duration_s(3.0).build().unwrap(), Effects::Planned);
        let event = first(&recorder, EventKind::Detach).expect("it leaves the loop");
        let angle = event.point.x.atan2(-event.point.z);
        let expected = ((2.0 - share) / 3.0).acos();
        assert!((angle / expected - 1.0).abs() < 1e-10, "{angle} for {expected}");
        // It lands on the loop again: where its parabola meets the circle.
        let (sin, cos) = expected.sin_cos();
        let v = DVec3::new(cos, 0.0, sin) * (-G * radius * cos).sqrt();
        let from = DVec3::new(sin, 0.0, -cos) * radius;
        let inside = |t: f64| radius - (from + v * t - DVec3::Z * (0.5 * G * t * t)).length();
        let flight = root(1e-3, 4.0 * radius, |t| inside(t) / t.powi(3));
        let impact = first(&recorder, EventKind::Impact).expect("it lands again");
        assert!((impact.t_s - event.t_s - flight).abs() < 1e-10, "{} for {flight}", impact.t_s - event.t_s);
        assert_closes(&report);
    }
    for (height, is_held) in [(2.5 + 1e-9, true), (2.5 - 1e-5, false)] {
        let speed = (2.0 * G * height).sqrt();
        let scene =
            car(upright_circle(1.0), one_side(DVec3::Z), -DVec3::Z, DVec3::X * speed).duration_s(1.2).build().unwrap();
        let (_, recorder) = run(&scene, Effects::Planned);
        assert_eq!(first(&recorder, EventKind::Detach).is_none(), is_held, "{height}");
    }
}

/// A car that leaves a wave at a crest lands where its parabola meets the wave again, and bounces as the restitution
/// says.
#[test]
fn a_car_lands_where_its_parabola_meets_the_track() {
    let (speed, restitution) = (4.0, 0.5);
    let wave =
        Curve::wave(DVec3::ZERO, UnitVector::X, DVec3::Z, Wave { amplitude: 1.0, wavelength: TAU, length: 20.0 })
            .unwrap();
    let x = root(0.1, 5.5, |x| 1.0 - 0.5 * G * (x / speed).powi(2) - x.cos());
    let hold = TrackHold::OneSide(OneSide { towards: UnitVector::Z, restitution });
    let scene = on_track(wave, hold, TrackEnds::Free, DVec3::Z, DVec3::X * speed).duration_s(1.3).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let impact = first(&recorder, EventKind::Impact).expect("it lands");
    assert!((impact.t_s - x / speed).abs() < 1e-10, "{impact:?}, {}", x / speed);
    let normal = DVec3::new(x.sin(), 0.0, 1.0).normalize();
    assert!((impact.normal - normal).length() < 1e-9);
    let approach = normal.dot(DVec3::new(speed, 0.0, -G * x / speed));
    let lost = -0.5 * 1.3 * (1.0 - restitution * restitution) * approach * approach;
    assert!((impact.energy_change_j / lost - 1.0).abs() < 1e-9, "{impact:?}");
    assert_closes(&report);
}

/// A body that runs off the end of an open track is free from then on; so it is in time steps, a step later. One that
/// meets a stop there bounces.
#[test]
fn a_body_runs_off_the_end_of_its_track() {
    let slope = Curve::line(DVec3::Z * 3.0, DVec3::new(4.0, 0.0, 0.0)).unwrap();
    let down = G * 0.6;
    let (end, speed) = ((2.0 * 5.0 / down).sqrt(), (2.0 * 5.0 * down).sqrt());
    let after = DVec3::new(4.0, 0.0, 0.0) + DVec3::new(0.8, 0.0, -0.6) * speed * (2.0 - end)
        - DVec3::Z * (0.5 * G * (2.0 - end).powi(2));
    for (method, exact) in [(accurate(), 1e-11), (stepped(1e-3), 0.05), (stepped(1e-4), 0.005)] {
        let at = on_track(slope.clone(), BOTH, TrackEnds::Free, DVec3::Z * 3.0, DVec3::ZERO);
        let (report, recorder) = run(&at.method(method).duration_s(2.0).build().unwrap(), Effects::Planned);
        let event = first(&recorder, EventKind::Detach).expect("it runs off");
        assert!((event.t_s - end).abs() < 0.1 * exact + 1e-11, "{event:?} for {end}");
        let found = report.bodies[0].state.pose.translation;
        assert!((found - after).length() < exact, "{found} for {after}");
        assert_closes(&report);
    }
    let at = on_track(slope, BOTH, TrackEnds::Stops(1.0), DVec3::Z * 3.0, DVec3::ZERO);
    let (report, recorder) = run(&at.duration_s(2.0 * end).build().unwrap(), Effects::Planned);
    let impact = first(&recorder, EventKind::Impact).expect("it meets the stop");
    assert!((impact.t_s - end).abs() < 1e-11);
    assert!((report.bodies[0].state.pose.translation - DVec3::Z * 3.0).length() < 1e-10);
}

/// A car that leaves the end of a one-sided track, in contact with it, flies on as a parabola.
#[test]
fn a_car_leaves_the_end_of_a_one_sided_track() {
    let quarter = Bend { length: 2.0, curvature: [0.5, 0.5] };
    let ramp = Curve::path(DVec3::ZERO, UnitVector::X, DVec3::Z, &[quarter]).unwrap();
    let scene = car(ramp.clone(), one_side(DVec3::Z), DVec3::ZERO, DVec3::X * 8.0).duration_s(1.0).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let event = first(&recorder, EventKind::Detach).expect("it leaves the end");
    let end = ramp.at(2.0);
    assert!((event.point - end.point).length() < 1e-11);
    let (speed, left) = ((64.0 - 2.0 * G * end.point.z).sqrt(), 1.0 - event.t_s);
    let expected = end.point + end.tangent * (speed * left) - DVec3::Z * (0.5 * G * left * left);
    assert!((report.bodies[0].state.pose.translation - expected).length() < 1e-10);
    assert_closes(&report);
}

/// What continues from a snapshot has the same bits, before and after a body has run off its track.
#[test]
fn a_snapshot_keeps_who_has_run_off() {
    let slope = Curve::line(DVec3::Z * 3.0, DVec3::new(4.0, 0.0, 0.0)).unwrap();
    let scene = on_track(slope, BOTH, TrackEnds::Free, DVec3::Z * 3.0, DVec3::ZERO).duration_s(3.0).build().unwrap();
    for method in [accurate(), stepped(1e-2)] {
        let scene = scene.clone().with_method(method);
        let mut whole = Simulation::new(&scene).unwrap();
        whole.advance_to(2.5).unwrap();
        for t in [0.5, 2.0] {
            let mut first = Simulation::new(&scene).unwrap();
            first.advance_to(t).unwrap();
            let snapshot = Snapshot::from_bytes(&first.snapshot().to_bytes()).unwrap();
            let mut second = Simulation::new(&scene).unwrap();
            second.restore(&snapshot).unwrap();
            second.advance_to(2.5).unwrap();
            assert_eq!(second.body(BodyId::new(0)), whole.body(BodyId::new(0)), "{t}");
            second.restore(&Simulation::new(&scene).unwrap().snapshot()).unwrap();
            second.advance_to(2.5).unwrap();
            assert_eq!(second.body(BodyId::new(0)), whole.body(BodyId::new(0)), "{t}, from the start");
        }
    }
}

fn rough(coefficient: f64) -> Freedom {
    Freedom::default().with_friction(JointFriction::default().with_bearing(coefficient, 1.0).unwrap())
}

/// A rough car on a curve.
fn rough_car(curve: Curve, hold: TrackHold, coefficient: f64, place: DVec3, velocity: DVec3) -> SceneBuilder {
    let mut scene = Scene::builder("rough car").method(accurate());
    let track = scene.add_track(curve);
    let joint = Joint::new(JointKind::Track { track, hold, ends: TrackEnds::Free }, BodyId::new(0), place);
    scene.body(bead(place, velocity)).joint(joint.along(Coordinate::Displacement, rough(coefficient)))
}

/// On a straight track friction is that of a box on a ramp: `a = g (sin - mu cos)` down, and up it stops after
/// `v^2/(2 g (sin + mu cos))` and stays where the angle is below that of friction.
#[test]
fn friction_on_a_straight_track_is_that_of_a_ramp() {
    let down = DVec3::new(0.8, 0.0, -0.6);
    for hold in [BOTH, one_side(DVec3::Z)] {
        let line = Curve::line(-down * 10.0, down * 30.0).unwrap();
        let scene = rough_car(line.clone(), hold, 0.2, DVec3::ZERO, down * 1.5).duration_s(1.5).build().unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
            let way = 1.5 * t + 0.5 * G * (0.6 - 0.2 * 0.8) * t * t;
            assert!((row[0].pose.translation - down * way).length() < 1e-11, "{t}");
        }
        let work = 1.3 * G * 0.8 * 0.2 * (1.5 * 1.5 + 0.5 * G * 0.44 * 2.25);
        assert!((report.ledger.friction.value() / work - 1.0).abs() < 1e-11);
        assert_closes(&report);
        let scene = rough_car(line, hold, 0.8, DVec3::ZERO, -down * 3.0).duration_s(1.5).build().unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let slowing = G * (0.6 + 0.8 * 0.8);
        let end = report.bodies[0].state;
        assert!((end.pose.translation + down * (9.0 / (2.0 * slowing))).length() < 1e-11, "{end:?}");
        assert!(end.velocity.linear.length() < 1e-12);
        let stops = recorder
            .events
            .iter()
            .find(|event| matches!(event.kind, EventKind::Stick | EventKind::Rest))
            .expect("it stops");
        assert!((stops.t_s - 3.0 / slowing).abs() < 1e-10, "{stops:?}");
    }
}

/// On an upright circle friction follows the load: `m a = -m g sin - mu abs(N) sign(v)`, `N = m g cos + m v^2/R`,
/// integrated here on its own.
#[test]
fn friction_on_a_circle_is_that_of_its_load() {
    let (radius, coefficient) = (1.3, 0.15);
    let start = 1.2_f64;
    let (mut angle, mut rate) = (start, 0.0_f64);
    let change = |angle: f64, rate: f64| {
        let load = (G * angle.cos() + radius * rate * rate).abs();
        (-G * angle.sin() + coefficient * load) / radius
    };
    let (duration, steps) = (0.9, 20_000);
    let h = duration / f64::from(steps);
    for _ in 0..steps {
        let k1 = (rate, change(angle, rate));
        let k2 = (rate + 0.5 * h * k1.1, change(angle + 0.5 * h * k1.0, rate + 0.5 * h * k1.1));
        let k3 = (rate + 0.5 * h * k2.1, change(angle + 0.5 * h * k2.0, rate + 0.5 * h * k2.1));
        let k4 = (rate + h * k3.1, change(angle + h * k3.0, rate + h * k3.1));
        angle += h / 6.0 * (k1.0 + 2.0 * (k2.0 + k3.0) + k4.0);
        rate += h / 6.0 * (k1.1 + 2.0 * (k2.1 + k3.1) + k4.1);
    }
    assert!(rate < 0.0, "it has not turned yet");
    let place = |angle: f64| DVec3::new(angle.sin(), 0.0, -angle.cos()) * radius;
    for hold in [BOTH, one_side(DVec3::new(-1.0, 0.0, 1.0))] {
        let scene = rough_car(upright_circle(radius), hold, coefficient, place(start), DVec3::ZERO);
        let (report, _) = run(&scene.duration_s(duration).build().unwrap(), Effects::Planned);
        let found = report.bodies[0].state.pose.translation;
        assert!((found - place(angle)).length() < 1e-9, "{found} for {}", place(angle));
        let energy = 1.3 * (G * radius * (angle.cos() - start.cos()) - 0.5 * (radius * rate).powi(2));
        assert!((report.ledger.friction.value() / energy - 1.0).abs() < 1e-9);
        assert_closes(&report);
    }
}

/// In time steps a bead on a circle is off by the square of the step.
#[test]
fn time_steps_on_a_track_are_of_second_order() {
    let place = DVec3::X;
    let end = |method: Method| {
        let scene = car(upright_circle(1.0), BOTH, place, DVec3::ZERO).method(method).duration_s(1.0).build().unwrap();
        run(&scene, Effects::Planned).0.bodies[0].state.pose.translation
    };
    let exact = end(accurate());
    let errors = [4e-3, 2e-3, 1e-3].map(|h| (end(stepped(h)) - exact).length());
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.1, "{errors:?}");
    }
}

/// The thesis's trouble: springs in the place of the track. A body across a straight track oscillates with `sqrt(k/m)`;
/// a stiffer spring costs more steps; and one that pulls never lets go where a track would, while one with a reach lets
/// go too late.
#[test]
fn springs_in_the_place_of_a_track_oscillate_and_do_not_let_go_in_time() {
    let springs = |stiffness: f64, reach: f64| TrackHold::Springs(TrackSprings { stiffness, damping: 0.0, reach });
    let line = Curve::line(-DVec3::X * 10.0, DVec3::X * 10.0).unwrap();
    let (stiffness, off) = (1.3 * 400.0, 0.01);
    let scene = car(line, springs(stiffness, f64::INFINITY), DVec3::Y * off, DVec3::X).gravity(DVec3::ZERO);
    let (report, recorder) = run(&scene.duration_s(1.0).build().unwrap(), Effects::Planned);
    for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
        let expected = DVec3::new(t, off * (20.0 * t).cos(), 0.0);
        assert!((row[0].pose.translation - expected).length() < 1e-11, "{t}");
    }
    assert_closes(&report);
    // On the hill of JT-10 a track lets go at 45.8 degrees.
    let mut steps = Vec::new();
    for stiffness in [1e4, 1e6] {
        let hill = Curve::circle(DVec3::ZERO, UnitVector::Y, DVec3::Z * 10.0).unwrap();
        let scene = car(hill.clone(), springs(stiffness, f64::INFINITY), DVec3::Z * 10.0, DVec3::X * 3.0);
        let (report, _) = run(&scene.duration_s(3.5).build().unwrap(), Effects::Planned);
        let place = report.bodies[0].state.pose.translation;
        assert!((place - hill.nearest(place).point).length() < 0.1, "glued: {place}");
        steps.push(report.steps);
        assert_closes(&report);
    }
    assert!(steps[1] > 4 * steps[0], "{steps:?}");
}

/// What contradicts itself is refused with its place and what is accepted.
#[test]
fn tracks_that_cannot_hold_are_refused() {
    let circle = || upright_circle(1.0);
    let error = |scene: SceneBuilder| scene.build().unwrap_err();
    let off = error(car(circle(), BOTH, DVec3::X * 1.002, DVec3::ZERO));
    let SceneError::OffTrack { number: 0, distance_mm, .. } = off else { panic!("{off}") };
    assert!((distance_mm - 2.0).abs() < 1e-9 && off.to_string().contains("mm"), "{off}");
    // The digits of a file are taken, and the point is moved onto the track.
    let near = car(circle(), BOTH, DVec3::X * (1.0 + 1e-9), DVec3::ZERO).build().unwrap();
    assert!((near.joints()[0].anchor() - DVec3::X).length() < 1e-15);
    let wrong = error(car(circle(), one_side(DVec3::Z), -DVec3::Z * 1.1, DVec3::ZERO));
    assert!(matches!(wrong, SceneError::OffTrack { how: "on the wrong side of its track", .. }), "{wrong}");
    let moving = error(car(circle(), BOTH, DVec3::X, DVec3::X));
    assert!(matches!(moving, SceneError::JointMoves { .. }), "{moving}");
    let helix = Curve::helix(DVec3::ZERO, UnitVector::Z, DVec3::X, Coil { advance: 0.3, turns: 2.0 }).unwrap();
    let skew = error(car(helix, one_side(DVec3::Z), DVec3::X, DVec3::ZERO));
    assert!(skew.to_string().contains("plane"), "{skew}");
    let none = Scene::builder("none").body(bead(DVec3::ZERO, DVec3::ZERO));
    let kind = JointKind::Track { track: TrackId::new(3), hold: BOTH, ends: TrackEnds::Free };
    let none = error(none.joint(Joint::new(kind, BodyId::new(0), DVec3::ZERO)));
    assert!(none.to_string().contains("does not have"), "{none}");
    let thesis = Method { tier: Some(Tier::Thesis), ..Method::default() };
    let thesis = error(car(circle(), BOTH, DVec3::X, DVec3::ZERO).method(thesis));
    assert!(matches!(thesis, SceneError::JointsInTier { .. }), "{thesis}");
}

fn turning(q: DQuat) -> Rotation {
    Rotation::from_wxyz([q.w, q.x, q.y, q.z]).unwrap()
}

/// A long car that follows the tangent, or the frame, of a clothoid bend, a closed spline in space and a helix: it
/// keeps its energy, and its axis the direction of the track. On a circle its moment of inertia adds to its mass,
/// `T = T_0 sqrt(1 + I/(m R^2))`.
#[test]
fn a_car_turns_with_its_track() {
    let helix = Coil { advance: 0.4, turns: 9.0 };
    let up = Some(UnitVector::Z);
    let cases = [
        (round_in_space(), Follows::Tangent),
        (round_in_space(), Follows::Frame { up }),
        (bend_down_a_slope(&[]), Follows::Frame { up: None }),
        (Curve::helix(DVec3::ZERO, UnitVector::Z, DVec3::X, helix).unwrap(), Follows::Frame { up }),
    ];
    for (curve, follows) in cases {
        let start = curve.at(0.3);
        let mut scene = Scene::builder("car").method(accurate()).duration_s(0.9);
        let track = scene.add_track(curve.clone());
        let kind = JointKind::Track { track, hold: TrackHold::Both(follows), ends: TrackEnds::Free };
        let attitude = turning(DQuat::from_rotation_arc(DVec3::X, start.tangent));
        let body = brick("car", DVec3::new(0.5, 0.2, 0.1), start.point);
        let body = body.pose(Pose { rotation: attitude, translation: start.point });
        let scene = scene.body(body).joint(Joint::new(kind, BodyId::new(0), start.point)).build().unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        for row in &recorder.samples {
            let at = curve.nearest(row[0].pose.translation);
            let ahead = row[0].pose.rotation.rotate(DVec3::X);
            assert!((ahead - at.tangent).length() < 1e-11, "{ahead} {}", at.tangent);
            assert!((row[0].pose.translation - at.point).length() < 1e-12);
        }
        assert!(report.ledger.numerical.value().abs() < 1e-11 * report.ledger.scale_j, "{:?}", report.ledger.numerical);
        assert!(report.bodies[0].state.velocity.linear.length() > 0.5);
        assert_closes(&report);
    }
    let (radius, small) = (1.0, 0.01_f64);
    let place = DVec3::new(small.sin(), 0.0, -small.cos()) * radius;
    let attitude = turning(DQuat::from_rotation_y(-small));
    let body = brick("car", DVec3::new(0.8, 0.2, 0.6), place).pose(Pose { rotation: attitude, translation: place });
    let mut scene = Scene::builder("car").method(accurate()).duration_s(3.0);
    let track = scene.add_track(upright_circle(radius));
    let kind = JointKind::Track { track, hold: TrackHold::Both(Follows::Tangent), ends: TrackEnds::Free };
    let scene = scene.body(body).joint(Joint::new(kind, BodyId::new(0), place)).build().unwrap();
    let inertia = (0.64 + 0.36) / 12.0;
    let period = 4.0 * ((1.0 + inertia) / G).sqrt() * complete_elliptic((0.5 * small).sin());
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(0.25 * period).unwrap();
    let at = simulation.body(BodyId::new(0));
    assert!((at.pose.translation.x / at.velocity.linear.x).abs() < 1e-10, "{at:?}");
}

/// A body that turns with its track takes no jump of its curvature, and needs a direction that is nowhere along it.
#[test]
fn a_car_does_not_turn_with_a_track_whose_curvature_jumps() {
    let bends = [Bend { length: 2.0, curvature: [0.0; 2] }, Bend { length: 1.0, curvature: [0.9; 2] }];
    let path = Curve::path(DVec3::ZERO, UnitVector::X, DVec3::Z, &bends).unwrap();
    let error = car(path, TrackHold::Both(Follows::Tangent), DVec3::X, DVec3::ZERO).build().unwrap_err();
    assert!(error.to_string().contains("clothoid"), "{error}");
    let upright = Follows::Frame { up: Some(UnitVector::Z) };
    let error = car(upright_circle(1.0), TrackHold::Both(upright), -DVec3::Z, DVec3::ZERO).build().unwrap_err();
    assert!(error.to_string().contains("up is along"), "{error}");
}

/// In time steps a car leaves the hill too, and flies on: its error falls with the step.
#[test]
fn time_steps_leave_a_hill_and_land() {
    let end = |method: Method, duration_s: f64| {
        let hill = Curve::circle(DVec3::ZERO, UnitVector::Y, DVec3::Z * 10.0).unwrap();
        let scene =
            car(hill, one_side(DVec3::Z), DVec3::Z * 10.0, DVec3::X * 3.0).method(method).duration_s(duration_s);
        let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
        assert_closes(&report);
        report.bodies[0].state.pose.translation
    };
    let exact = end(accurate(), 3.0);
    assert!(exact.length() > 10.5, "it has left the hill: {exact}");
    let errors = [4e-3, 2e-3, 1e-3].map(|h| (end(stepped(h), 3.0) - exact).length());
    assert!(errors[2] < 1e-4 && errors[2] < 0.6 * errors[1] && errors[1] < 0.6 * errors[0], "{errors:?}");
    let wave = |method: Method| {
        let wave = Wave { amplitude: 1.0, wavelength: TAU, length: 20.0 };
        let wave = Curve::wave(DVec3::ZERO, UnitVector::X, DVec3::Z, wave).unwrap();
        let scene =
            car(wave, one_side(DVec3::Z), DVec3::Z, DVec3::X * 4.0).method(method).duration_s(1.3).build().unwrap();
        run(&scene, Effects::Planned).0.bodies[0].state.pose.translation
    };
    let exact = wave(accurate());
    let errors = [4e-3, 2e-3, 1e-3].map(|h| (wave(stepped(h)) - exact).length());
    assert!(errors[2] < 1e-3, "{errors:?}");
}

/// A track fixed in a body moves with it: a bead on a ring that swings on a hinge keeps energy, and between two bodies
/// momentum stays.
#[test]
fn a_track_moves_with_the_body_that_it_is_fixed_in() {
    let (radius, place) = (0.5, DVec3::new(0.0, 0.5, 0.0));
    let mut scene = Scene::builder("ring and bead").method(accurate()).gravity(DVec3::ZERO).duration_s(2.0);
    let track = scene.add_track(Curve::circle(DVec3::ZERO, UnitVector::Z, DVec3::X * radius).unwrap());
    let spin = DVec3::new(0.7, -0.4, 1.1);
    let plate = brick("plate", DVec3::new(0.4, 0.6, 0.2), DVec3::ZERO).velocity(Velocity::new(DVec3::ZERO, spin));
    let velocity = spin.cross(place) + DVec3::X * 0.8;
    let kind = JointKind::Track { track, hold: BOTH, ends: TrackEnds::Free };
    let scene = scene.body(plate).body(ball("bead", 0.4, 0.02, place, velocity));
    let joint = Joint::new(kind, BodyId::new(1), place).with(BodyId::new(0));
    let scene = scene.joint(joint).no_contact([BodyId::new(0), BodyId::new(1)]).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    for row in &recorder.samples {
        let local = row[0].pose.inverse_transform_point(row[1].pose.translation);
        assert!(local.z.abs() < 1e-12 && (local.length() - radius).abs() < 1e-12, "{local}");
    }
    let start = &recorder.samples[0];
    let momentum = |row: &[polhode::BodySample]| row[0].velocity.linear * 1.0 + row[1].velocity.linear * 0.4;
    let end = recorder.samples.last().unwrap();
    assert!((momentum(end) - momentum(start)).length() < 1e-12);
    assert!(report.ledger.numerical.value().abs() < 1e-11 * report.ledger.scale_j);
    assert!((end[0].velocity.linear - start[0].velocity.linear).length() > 0.05, "the plate is moved");
    assert_closes(&report);
}

/// Motors and limits act along a track: a servo drives a car up a helix at its speed, and a limit stops it.
#[test]
fn a_motor_drives_a_car_along_its_track() {
    let helix = Curve::helix(DVec3::ZERO, UnitVector::Z, DVec3::X * 2.0, Coil { advance: 1.0, turns: 5.0 }).unwrap();
    let start = helix.at(1.0).point;
    let servo = Motor::new(Drive::Velocity { velocity: 2.0, gain: 1e3 }).unwrap();
    let freedom = Freedom::default().with_motor(servo).with_limits(Limits::new(-0.5, 3.0).unwrap());
    for (method, exact) in [(accurate(), 1e-9), (stepped(1e-3), 1e-6)] {
        let mut scene = Scene::builder("chain lift").method(method).duration_s(3.0);
        let track = scene.add_track(helix.clone());
        let kind = JointKind::Track { track, hold: BOTH, ends: TrackEnds::Free };
        let joint = Joint::new(kind, BodyId::new(0), start).along(Coordinate::Displacement, freedom);
        let scene = scene.body(bead(start, DVec3::ZERO)).joint(joint).build().unwrap();
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(1.0).unwrap();
        let slope = 1.0 / (TAU * 2.0).hypot(1.0);
        let along = simulation.coordinate(JointId::new(0), Coordinate::Displacement).unwrap();
        assert!((along.rate - (2.0 - 1.3 * G * slope / 1e3)).abs() < exact, "{along:?}");
        simulation.advance_to(3.0).unwrap();
        let along = simulation.coordinate(JointId::new(0), Coordinate::Displacement).unwrap();
        assert!((along.value - 3.0).abs() < 1e-9 && along.rate.abs() < 1e-9, "{along:?}");
    }
}
