//! The models of contact that the thesis tries first (section 3.3) have the faults that it describes, in its own
//! figures, and the ledger shows what they do to the energy.

use crate::support::{ball, elastic, floor, run_even_degraded};
use polhode::scene::{Method, Response, Tier};
use polhode::spatial::DVec3;
use polhode::{Effects, Recorder, RunReport, Scene};

const GRAVITY: f64 = 9.81;
const RADIUS: f64 = 0.5;

/// A ball of 1 kg above a floor, by one of the models.
fn ball_above(height_m: f64, restitution: f64, step_s: f64, response: Response) -> (RunReport, Recorder) {
    let method =
        Method { tier: Some(Tier::Thesis), step_s: Some(step_s), response: Some(response), ..Method::default() };
    let place = DVec3::Z * (RADIUS + height_m);
    let scene = Scene::builder("ball")
        .method(method)
        .duration_s(3.0)
        .output_interval_s(step_s)
        .body(floor().material(elastic(restitution)))
        .body(ball("ball", 1.0, RADIUS, place, DVec3::ZERO).material(elastic(restitution)))
        .build()
        .unwrap();
    // They sink, or are given energy: what the models are kept to show, and what degrades their runs.
    let (report, record) = run_even_degraded(&scene, Effects::Planned);
    assert!(report.ledger.closure_relative() < 1e-12, "{}", report.ledger.closure_relative());
    assert!(report.ledger.momentum.closure_relative() < 1e-12);
    (report, record)
}

/// Heights of the lowest point of the ball, m.
fn heights(record: &Recorder) -> Vec<f64> {
    record.samples.iter().map(|bodies| bodies[1].pose.translation.z - RADIUS).collect()
}

/// By impulses alone a ball at rest falls by g h^2/2 in every step, for each impulse takes only the velocity.
#[test]
fn ball_at_rest_sinks_by_impulses_alone() {
    let step_s = 0.01;
    let (report, record) = ball_above(0.0, 0.0, step_s, Response::Impulse);
    for (steps, height) in heights(&record).into_iter().enumerate() {
        let expected = -0.5 * GRAVITY * step_s * step_s * steps as f64;
        assert!((height - expected).abs() < 1e-12, "after {steps} steps: {height} m instead of {expected} m");
    }
    assert!((report.certificate.max_penetration_m - 0.14715).abs() < 1e-9);
}

/// With forces at resting contacts the same ball stays where it is.
#[test]
fn ball_at_rest_stays_by_constraint() {
    let (_, record) = ball_above(0.0, 0.0, 0.01, Response::Constraint);
    assert!(heights(&record).into_iter().all(|height| height.abs() < 1e-12));
}

/// Moved back after every step, the ball stays within g h^2/2 of its place, and every lift gives it the energy of that
/// height.
#[test]
fn ball_at_rest_is_given_energy_by_lifting() {
    let step_s = 0.01;
    let fall_m = 0.5 * GRAVITY * step_s * step_s;
    let (report, record) = ball_above(0.0, 0.0, step_s, Response::ImpulseProjection);
    assert!(heights(&record).into_iter().all(|height| height.abs() < 1.001 * fall_m));
    let given = -report.ledger.projection.value();
    assert!((given - 300.0 * GRAVITY * fall_m).abs() < 1e-9, "{given} J");
}

/// A ball that a step of 0.03 s lets into the floor by 13 cm is caught there when impulses act on it while it leaves,
/// and bounces off when they do not.
#[test]
fn bouncing_ball_is_caught_by_impulses_that_pull() {
    let top_after = |record: &Recorder| {
        let heights = heights(record);
        let landed = heights.iter().position(|&height| height < 0.0).unwrap();
        heights[landed..].iter().fold(f64::NEG_INFINITY, |top: f64, &height| top.max(height))
    };
    let (report, caught) = ball_above(1.0, 0.8, 0.03, Response::ImpulseUnconditional);
    assert!(top_after(&caught) < 0.0, "{}", top_after(&caught));
    assert!(report.ledger.impact.value() > 0.0);
    let (_, free) = ball_above(1.0, 0.8, 0.03, Response::Impulse);
    assert!(top_after(&free) > 0.5, "{}", top_after(&free));
}
