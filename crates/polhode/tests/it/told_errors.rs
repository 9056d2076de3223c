//! Every sample of a run has an estimated error: told once, in the order of the samples, never far below the true one,
//! and of no effect on the motion.

use crate::support::{accurate, ball, elastic, floor};
use polhode::scene::{Method, Tier};
use polhode::spatial::DVec3;
use polhode::{BodyError, BodySample, ErrorEstimation, Flow, Observer, Recorder, Scene, Simulation, Unobserved};

/// Distances that are rounding, m: a body of 0.1 m within 10 m of the origin for a second.
const ROUNDING: f64 = 1e-13;

const VELOCITY: DVec3 = DVec3::new(3.0, 1.0, 4.0);

/// A ball that is thrown and meets nothing, by this method.
fn projectile(method: Method) -> Scene {
    let scene = Scene::builder("projectile").method(method).duration_s(1.0).output_interval_s(0.01);
    scene.body(ball("ball", 1.0, 0.05, DVec3::Z, VELOCITY)).build().unwrap()
}

/// A ball that bounces on a floor, by this tier.
fn bouncing(tier: Tier) -> Scene {
    let method = Method { tier: Some(tier), ..Method::default() };
    let scene = Scene::builder("bouncing").method(method).duration_s(1.0).output_interval_s(0.01);
    let ball = ball("ball", 1.0, 0.1, DVec3::Z, DVec3::X).material(elastic(0.5));
    scene.body(floor().material(elastic(0.5))).body(ball).build().unwrap()
}

/// What an observer is told, in order.
#[derive(Default)]
struct Told {
    samples: Vec<f64>,
    errors: Vec<(f64, Option<Vec<BodyError>>)>,
    stop_s: f64,
}

impl Observer for Told {
    fn sample(&mut self, t_s: f64, _bodies: &[BodySample]) {
        self.samples.push(t_s);
    }

    fn wants_errors(&self) -> bool {
        true
    }

    fn errors(&mut self, t_s: f64, errors: Option<&[BodyError]>) {
        self.errors.push((t_s, errors.map(<[_]>::to_vec)));
    }

    fn progress(&mut self, t_s: f64) -> Flow {
        if t_s >= self.stop_s { Flow::Stop } else { Flow::Continue }
    }
}

impl Told {
    /// Nothing so far, by one who does not stop the run.
    fn to_the_end() -> Self {
        Self { stop_s: f64::INFINITY, ..Self::default() }
    }

    /// That the errors of all samples have been told.
    fn expect_all(&self) {
        assert!(self.samples.len() > 50, "{} samples", self.samples.len());
        assert!(self.samples.iter().eq(self.errors.iter().map(|(t_s, _)| t_s)));
    }
}

/// The error of a projectile is at least a tenth of its distance from the parabola, at every sample.
#[test]
fn errors_of_a_projectile_are_not_below_a_tenth_of_the_true_ones() {
    let euler = Method { tier: Some(Tier::Stepped), ..Method::default() };
    for method in [accurate(), euler] {
        let mut kept = Recorder::default();
        Simulation::new(&projectile(method)).unwrap().run_observed(&mut kept).unwrap();
        assert_eq!(kept.errors.len(), kept.samples.len());
        for ((t, bodies), errors) in kept.times_s.iter().zip(&kept.samples).zip(&kept.errors) {
            let exact = DVec3::Z + VELOCITY * *t - DVec3::Z * (0.5 * 9.81 * t * t);
            let apart = (bodies[0].pose.translation - exact).length();
            let error = errors[0].position_m;
            assert!(error.is_finite() && error >= 0.1 * apart && error < ROUNDING, "t = {t}: {error:e}, {apart:e}");
        }
    }
}

/// In every tier each sample of a run with impacts has an error, told once and in order.
#[test]
fn every_sample_of_every_tier_has_an_error() {
    for tier in [Tier::Accurate, Tier::Stepped, Tier::Fast] {
        for estimation in [ErrorEstimation::Quick, ErrorEstimation::Full] {
            let mut told = Told::to_the_end();
            let mut simulation = Simulation::new(&bouncing(tier)).unwrap().estimating(estimation);
            let report = simulation.run_observed(&mut told).unwrap();
            told.expect_all();
            let errors = told.errors.iter().map(|(_, errors)| errors.as_ref().unwrap());
            assert!(errors.flatten().all(|error| error.position_m.is_finite() && error.rotation_rad.is_finite()));
            assert_eq!(told.errors.last().unwrap().1.as_ref(), Some(&report.error.bodies));
        }
    }
}

/// Where nothing is estimated, every sample is told to have no known error.
#[test]
fn errors_that_are_not_estimated_are_told_to_be_unknown() {
    let mut told = Told::to_the_end();
    let mut simulation = Simulation::new(&bouncing(Tier::Stepped)).unwrap().estimating(ErrorEstimation::Off);
    simulation.run_observed(&mut told).unwrap();
    told.expect_all();
    assert!(told.errors.iter().all(|(_, errors)| errors.is_none()));
}

/// A run that is stopped and goes on owes no sample its error at the end; and the motion has the same bits as without
/// anybody who asks for errors.
#[test]
fn stopping_owes_no_errors_and_asking_changes_no_motion() {
    let scene = bouncing(Tier::Stepped);
    let mut stopped = Simulation::new(&scene).unwrap();
    let mut told = Told { stop_s: 0.305, ..Told::default() };
    stopped.run_observed(&mut told).unwrap();
    assert!(told.errors.len() <= told.samples.len() && !stopped.has_ended());
    told.stop_s = f64::INFINITY;
    stopped.run_observed(&mut told).unwrap();
    told.expect_all();
    let mut unasked = Simulation::new(&scene).unwrap();
    unasked.run_observed(&mut Unobserved).unwrap();
    assert_eq!(stopped.bodies(), unasked.bodies());
}

/// A run that is restored begins at its own samples: those before it are not told again.
#[test]
fn restored_run_tells_the_errors_of_its_own_samples() {
    let scene = bouncing(Tier::Stepped);
    let mut first = Simulation::new(&scene).unwrap();
    first.run_observed(&mut Told { stop_s: 0.305, ..Told::default() }).unwrap();
    let mut second = Simulation::new(&scene).unwrap();
    second.restore(&first.snapshot()).unwrap();
    let mut told = Told::to_the_end();
    second.run_observed(&mut told).unwrap();
    told.expect_all();
    assert!(told.samples[0] > 0.3);
}
