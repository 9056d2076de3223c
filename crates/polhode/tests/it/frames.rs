//! Frames that an observer is given while a run goes on: they account for every joule at their time.

use polhode::contact::Shape;
use polhode::mesh::solid_box;
use polhode::spatial::{DVec3, Mass, Pose, UnitVector, Velocity};
use polhode::{Body, BodySample, Energy, Frame, Observer, Scene, Simulation};

#[derive(Default)]
struct Frames(Vec<Frame>);

impl Observer for Frames {
    fn sample(&mut self, _t: f64, _bodies: &[BodySample]) {}

    fn wants_frames(&self) -> bool {
        true
    }

    fn frame(&mut self, frame: &Frame) {
        self.0.push(frame.clone());
    }
}

/// A brick that falls onto a floor, turning.
fn scene() -> Scene {
    let brick = Body::movable("brick", solid_box(DVec3::ONE, Mass::new(2.0).unwrap()).unwrap())
        .geometry(Shape::cuboid(DVec3::ONE).unwrap().into())
        .pose(Pose::from_translation(DVec3::Z * 1.5))
        .velocity(Velocity { linear: DVec3::ZERO, angular: DVec3::new(0.5, 1.0, 0.25) });
    let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into());
    Scene::builder("drop").body(floor).body(brick).build().unwrap()
}

#[test]
fn frames_hold_the_ledger_and_certificate_at_their_time() {
    let mut frames = Frames::default();
    let report = Simulation::new(&scene()).unwrap().run_observed(&mut frames).unwrap();
    let last = frames.0.last().unwrap();
    assert_eq!((last.ledger, last.certificate, last.steps), (report.ledger, report.certificate, report.steps));
    assert!(last.ledger.impact.value() > 1.0, "the floor takes energy");
    for pair in frames.0.windows(2) {
        assert!(pair[0].steps <= pair[1].steps);
        assert!(pair[0].ledger.impact.value() <= pair[1].ledger.impact.value());
    }
    for frame in &frames.0 {
        assert!(frame.ledger.closure_relative() < 1e-9, "t = {}: {}", frame.t_s, frame.ledger.closure_relative());
    }
}

/// Energies that come without frames are those of the frames.
#[test]
fn energies_come_with_the_samples() {
    #[derive(Default)]
    struct Energies(Vec<(f64, Energy)>);
    impl Observer for Energies {
        fn sample(&mut self, _t: f64, _bodies: &[BodySample]) {}

        fn wants_energies(&self) -> bool {
            true
        }

        fn energy(&mut self, t: f64, energy: &Energy) {
            self.0.push((t, *energy));
        }
    }
    let (mut energies, mut frames) = (Energies::default(), Frames::default());
    Simulation::new(&scene()).unwrap().run_observed(&mut energies).unwrap();
    Simulation::new(&scene()).unwrap().run_observed(&mut frames).unwrap();
    let of_frames: Vec<(f64, Energy)> = frames.0.iter().map(|frame| (frame.t_s, frame.energy)).collect();
    assert_eq!(energies.0, of_frames);
}

#[test]
fn frames_come_at_the_output_interval() {
    let mut frames = Frames::default();
    let scene = scene().with_output_interval(0.25).unwrap();
    Simulation::new(&scene).unwrap().run_observed(&mut frames).unwrap();
    let times: Vec<f64> = frames.0.iter().map(|frame| frame.t_s).collect();
    assert_eq!(times, [0.0, 0.25, 0.5, 0.75, 1.0]);
    for refused in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-300] {
        assert!(scene.clone().with_output_interval(refused).is_err(), "{refused}");
    }
}
