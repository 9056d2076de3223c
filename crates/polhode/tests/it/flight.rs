//! Free flight: the flight record is exact, and evaluating it more often does not change it.

use crate::support::{accurate, run};
use polhode::scene::Method;
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Velocity};
use polhode::{Body, Effects, Scene, SceneBuilder};

/// Case FR-02: the Dzhanibekov body, which flips about its middle axis.
fn dzhanibekov() -> SceneBuilder {
    let inertia = Inertia::from_diagonal(DVec3::new(1.0, 2.0, 3.0)).unwrap();
    let properties = MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia);
    let spin = Velocity::new(DVec3::ZERO, DVec3::new(0.01, 2.0, 0.01));
    Scene::builder("dzhanibekov")
        .gravity(DVec3::ZERO)
        .duration_s(100.0)
        .body(Body::movable("nut", properties).velocity(spin))
}

/// The orientation at 100 s is right to ten digits, and one step of 100 s gives the same bits as 6000 samples.
#[test]
fn dzhanibekov_orientation_does_not_depend_on_how_it_is_asked_for() {
    let reference = [0.006157426554914883, -0.5041426374441205, 6.170773042980609e-05, 0.863598450323565];
    let one_step =
        dzhanibekov().method(Method { step_s: Some(100.0), ..accurate() }).output_interval_s(100.0).build().unwrap();
    let sampled = dzhanibekov().method(accurate()).output_interval_s(100.0 / 6000.0).build().unwrap();
    let (report, recorder) = run(&one_step, Effects::Planned);
    assert_eq!(recorder.times_s, [0.0, 100.0]);
    let (many, samples) = run(&sampled, Effects::Planned);
    assert_eq!(samples.times_s.len(), 6001);
    assert_eq!(report.bodies, many.bodies);
    let q = report.bodies[0].state.pose.rotation.to_wxyz();
    let sign = (q[0] * reference[0] + q[1] * reference[1] + q[3] * reference[3]).signum();
    for (found, expected) in q.iter().zip(reference) {
        assert!((found * sign - expected).abs() < 1e-10, "{q:?}");
    }
    assert!((many.energy.final_j / many.energy.initial_j - 1.0).abs() < 1e-13);
    assert!(many.ledger.closure_relative() < 1e-12);
}
