//! Tracks: a point of a body follows a curve. Beads on circles and cycloids have the periods of pendulums, a car on a hill leaves it where
//! the force of a track that only pushes is zero (JT-10 of the reference catalogue, and the same with other numbers), and lands where its
//! parabola meets the track again. A track does no work, so that energy stays, and no point leaves it.

use crate::checks::assert_closes;
use crate::support::{accurate, ball, run};
use polhode::scene::{Coordinate, Joint, JointKind, Method, OneSide, SceneError, Tier, TrackEnds, TrackHold, TrackId};
use polhode::spatial::curve::{Bend, Curve, Rolling, SplineEnds, Wave};
use polhode::spatial::{DVec3, UnitVector};
use polhode::{Body, BodyId, Effects, Event, EventKind, JointId, Recorder, Scene, SceneBuilder, Simulation};
use std::f64::consts::{PI, TAU};

const G: f64 = 9.81;

fn stepped(step_s: f64) -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(step_s), ..Method::default() }
}

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
        let scene = car(upright_circle(1.0), TrackHold::Both, place, DVec3::ZERO).duration_s(10.0).build().unwrap();
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
    let scene = car(upright_circle(1.0), TrackHold::Both, DVec3::X, DVec3::ZERO).duration_s(2.0).build().unwrap();
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
        let scene = car(curve.clone(), TrackHold::Both, start.point, DVec3::ZERO).duration_s(4.0).build().unwrap();
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(0.75 * period).unwrap();
        let at = simulation.body(BodyId::new(0));
        assert!((at.pose.translation.x / at.velocity.linear.x).abs() < 1e-10 * period, "{part} {at:?}");
    }
}

/// On curves of all kinds, in the plane and in space, energy stays to 1e-12 of what moves, and the point on the track to 1e-12 m.
#[test]
fn energy_stays_and_no_point_leaves_its_track() {
    let points = [[0., 0., 2.], [1., 0.5, 1.2], [2., 1.5, 1.0], [1., 2.5, 1.5], [-0.5, 2., 1.0], [-1., 1., 0.8]]
        .map(DVec3::from);
    let bends = [
        Bend { length: 2.0, curvature: [0.0, 0.0] },
        Bend { length: 1.5, curvature: [0.0, 0.9] },
        Bend { length: 1.0, curvature: [0.9, 0.9] },
        Bend { length: 30.0, curvature: [0.0, 0.0] },
    ];
    let down = UnitVector::new(DVec3::new(1.0, 0.0, -0.7)).unwrap();
    let curves = [
        Curve::spline(&points, SplineEnds::Closed).unwrap(),
        Curve::path(DVec3::ZERO, down, DVec3::Z, &bends).unwrap(),
        Curve::wave(DVec3::ZERO, UnitVector::X, DVec3::Z, Wave { amplitude: 0.5, wavelength: 3.0, length: 90.0 })
            .unwrap(),
    ];
    for curve in curves {
        let start = curve.at(0.2);
        let scene = car(curve.clone(), TrackHold::Both, start.point, start.tangent * 2.0).duration_s(3.0);
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
            assert!(change.abs() < 1e-11 * scale, "{change:e}");
        }
        assert_closes(&report);
    }
}

/// JT-10: a car on a circular hill, pushed off the top, leaves it where `cos a = 2/3 + v0^2/(3 g R)`.
#[test]
fn a_car_leaves_a_round_hill_where_the_force_is_zero() {
    for (radius, speed) in [(10.0, 3.0), (10.0, 0.5), (4.0, 2.0), (0.7, 2.0)] {
        for method in [accurate()] {
            let hill = Curve::circle(DVec3::ZERO, UnitVector::Y, DVec3::Z * radius).unwrap();
            let scene = car(hill, one_side(DVec3::Z), DVec3::Z * radius, DVec3::X * speed).method(method);
            let (report, recorder) = run(&scene.duration_s(4.0).build().unwrap(), Effects::Planned);
            let event = first(&recorder, EventKind::Detach).expect("it leaves the hill");
            let cosine = 2.0 / 3.0 + speed * speed / (3.0 * G * radius);
            let angle = event.point.x.atan2(event.point.z);
            assert!((angle / cosine.acos() - 1.0).abs() < 1e-10, "{radius} {speed}: {angle} for {}", cosine.acos());
            assert_closes(&report);
        }
    }
    let angle = (2.0_f64 / 3.0 + 9.0 / (3.0 * G * 10.0)).acos().to_degrees();
    assert!((angle / 45.79339792028449 - 1.0).abs() < 1e-14);
}
