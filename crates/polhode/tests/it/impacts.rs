//! Impacts.

use crate::support::{accurate, ball, elastic, floor, run};
use polhode::spatial::DVec3;
use polhode::{Effects, EventKind, Scene};

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
