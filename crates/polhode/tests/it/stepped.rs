//! The tier `stepped`: fixed time steps at the level of velocities.

use crate::checks::assert_closes;
use crate::support::{ball, brick, elastic, floor};
use polhode::scene::{Method, Tier};
use polhode::spatial::DVec3;
use polhode::{Effects, Recorder, RunReport, Scene, SceneBuilder, Simulation};

const G: f64 = 9.81;

fn stepped(step_s: f64) -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(step_s), ..Method::default() }
}

fn run(scene: SceneBuilder, step_s: f64) -> (RunReport, Recorder) {
    let scene = scene.method(stepped(step_s)).build().unwrap();
    let mut recorder = Recorder::default();
    let report = Simulation::new(&scene, Effects::Planned).unwrap().run(&mut recorder).unwrap();
    assert_closes(&report);
    (report, recorder)
}

/// A box and a ball that lie on a floor stay where they are, to the last bit, for 10 s.
#[test]
fn box_and_ball_rest_exactly() {
    let scene = Scene::builder("rest")
        .duration_s(10.0)
        .output_interval_s(1.0)
        .body(floor())
        .body(brick("box", DVec3::new(0.5, 0.4, 0.2), DVec3::Z * 0.1))
        .body(ball("ball", 1.3, 0.25, DVec3::new(1.0, 0.0, 0.25), DVec3::ZERO));
    for step in [0.01, 1e-3] {
        let (report, recorder) = run(scene.clone(), step);
        for sample in &recorder.samples {
            assert_eq!(sample, &recorder.samples[0]);
        }
        assert!(report.certificate.max_penetration_m <= 1e-15, "{:?}", report.certificate);
    }
}

/// A ball that falls from rest, with restitution 1/2: its energy never rises, and its apexes converge.
#[test]
fn bouncing_ball_loses_energy_only_and_its_apexes_converge() {
    let scene = Scene::builder("bounce")
        .duration_s(1.5)
        .output_interval_s(0.01)
        .body(floor().material(elastic(0.5)))
        .body(ball("ball", 2.0, 0.1, DVec3::Z * 1.1, DVec3::ZERO).material(elastic(0.5)));
    for step in [0.004, 0.001] {
        let (report, recorder) = run(scene.clone(), step);
        println!("{:?} {:?}", report.certificate, report.energy);
        let mut last = f64::INFINITY;
        let mut apex: f64 = 0.0;
        for (t, sample) in recorder.times.iter().zip(&recorder.samples) {
            let body = sample[1];
            let energy = G * body.pose.translation.z + 0.5 * body.velocity.linear.length_squared();
            assert!(energy <= last * (1.0 + 1e-14), "{t} {energy} {last}");
            last = energy;
            if *t > 0.5 { apex = apex.max(body.pose.translation.z - 0.1) }
        }
        println!("{apex} {}", apex - 0.25);
    }
}
