//! Impacts.

use crate::support::{accurate, ball, elastic, floor, run};
use polhode::contact::Shape;
use polhode::scene::Method;
use polhode::spatial::{DVec3, Pose, UnitVector};
use polhode::{Body, Effects, EventKind, Recorder, Scene, Simulation, SimulationError};

/// IM-05: the accumulating bounce ends at its exact time, and its tenth impact comes when the series says.
#[test]
fn bouncing_ball_comes_to_rest_at_its_exact_time() {
    for (e, rest, tenth) in
        [(0.8, 4.063_712_768_871_578, 3.578_892_951_020_438), (0.5, 1.354_570_922_957_192_7, 1.352_807_158_734_592_2)]
    {
        let scene = Scene::builder("bounce")
            .method(accurate())
            .duration_s(5.0)
            .body(floor().material(elastic(e)))
            .body(ball("ball", 1.0, 0.1, DVec3::new(0.0, 0.0, 1.1), DVec3::ZERO).material(elastic(e)))
            .build()
            .unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let impacts: Vec<_> = recorder.events.iter().filter(|event| event.kind == EventKind::Impact).collect();
        assert!((impacts[9].t / tenth - 1.0).abs() < 1e-12, "{}", impacts[9].t);
        let rests: Vec<_> = recorder.events.iter().filter(|event| event.kind == EventKind::Rest).collect();
        assert_eq!(rests.len(), 1);
        assert!((rests[0].t / rest - 1.0).abs() < 1e-9, "{}", rests[0].t);
        assert!(report.bodies[1].1.velocity.is_zero());
        assert!(report.ledger.closure_relative() < 1e-12);
    }
}

/// A run whose time does not advance any more ends and says when and where. Here a ball rattles between two plates, and steps
/// as long as some hours make 0.2 s of it look like no time.
#[test]
fn a_run_that_makes_no_progress_says_where() {
    let down = UnitVector::new(-DVec3::Z).unwrap();
    let ceiling = Body::fixed("ceiling").geometry(Shape::half_space(down).into());
    let scene = Scene::builder("rattle")
        .method(Method { step_s: Some(1e4), ..accurate() })
        .duration_s(10.0)
        .body(floor().material(elastic(1.0)))
        .body(ceiling.pose(Pose::from_translation(DVec3::Z * 0.22)).material(elastic(1.0)))
        .body(ball("ball", 1.0, 0.1, DVec3::Z * 0.11, DVec3::Z * 100.0).material(elastic(1.0)))
        .build()
        .unwrap();
    let error = Simulation::new(&scene, Effects::Planned).unwrap().run(&mut Recorder::default()).unwrap_err();
    let SimulationError::NoProgress { t, steps, advanced_s, body_b, .. } = &error else { panic!("{error}") };
    assert_eq!((*steps, body_b.as_str()), (1024, "ball"));
    assert!(*advanced_s < 1.0 && (t - advanced_s).abs() < 1e-3, "{error}");
    assert!(error.to_string().contains("no progress"), "{error}");
}
