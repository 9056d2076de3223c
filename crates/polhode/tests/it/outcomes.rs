//! How runs end: a run that has not kept what its method promises says so, with bodies and time.

use crate::support::{accurate, ball, brick, elastic, floor, run, run_even_degraded};
use polhode::contact::Shape;
use polhode::observer::Flow;
use polhode::scene::{Method, Tier};
use polhode::spatial::DVec3;
use polhode::{Body, BodySample, Effects, Observer, Outcome, Scene, SceneBuilder, Simulation};

/// A ball that falls on a ring, off its axis, run at this tolerance.
fn ball_on_ring(tolerance: f64) -> SceneBuilder {
    Scene::builder("ball on a ring")
        .method(Method { tolerance: Some(tolerance), ..accurate() })
        .duration_s(3.0)
        .body(Body::fixed("ring").geometry(Shape::torus(0.5, 0.1).unwrap().into()).material(elastic(0.2)))
        .body(ball("ball", 1.0, 0.5, DVec3::new(0.05, 0.0, 1.0), DVec3::ZERO).material(elastic(0.2)))
}

/// At a tolerance of 0.01, projections change the energy of a ball that settles in a ring by more than this fraction.
/// The run is degraded, the first warning names the bodies and the time, and fallbacks are counted.
#[test]
fn ball_in_a_ring_whose_projections_take_too_much_degrades_its_run() {
    let (report, _) = run_even_degraded(&ball_on_ring(1e-2).build().unwrap(), Effects::Planned);
    let certificate = report.certificate;
    assert_eq!((report.outcome, report.simulated_s), (Outcome::Degraded, 3.0));
    assert!(report.ledger.projection.value().abs() > 0.1, "{certificate:?}");
    assert!(certificate.max_penetration_of_limit <= 1.0, "{certificate:?}");
    let at = certificate.max_projection_j_at.unwrap();
    assert_eq!((at.body_a.index(), at.body_b.index()), (0, 1));
    assert!(at.t_s > 0.0 && at.t_s <= 3.0);
    for part in ["t = ", "degraded", "ring and ball", "promised", "projections took"] {
        assert!(report.warnings[0].contains(part), "{part}: {}", report.warnings[0]);
    }
    let counted: u64 = report.tolerated.iter().map(|tolerated| tolerated.count).sum();
    assert!(counted > 0 && counted == certificate.fallbacks, "{:?}", report.tolerated);
    assert!(report.tolerated.iter().all(|tolerated| tolerated.what.contains("ring and ball")));
}

/// Stops a run at a time.
struct StopAt(f64);

impl Observer for StopAt {
    fn sample(&mut self, _t: f64, _bodies: &[BodySample]) {}

    fn progress(&mut self, t: f64) -> Flow {
        if t >= self.0 { Flow::Stop } else { Flow::Continue }
    }
}

/// A run that the observer stops has the outcome `Stopped`; if it has exceeded a promised limit before, it is degraded.
#[test]
fn stopped_run_is_degraded_by_what_it_has_done() {
    let end = |tolerance: f64, stop_s: f64| {
        let scene = ball_on_ring(tolerance).build().unwrap();
        let report = Simulation::new(&scene).unwrap().run_observed(&mut StopAt(stop_s)).unwrap();
        assert!(report.simulated_s < 3.0);
        report.outcome
    };
    assert_eq!(end(1e-2, 0.1), Outcome::Stopped);
    assert_eq!(end(1e-2, 1.5), Outcome::Degraded);
}

/// The tier `thesis` promises no limit of penetration: a run in which a ball penetrates by the distance it falls in one
/// step is completed, and its certificate holds the depth.
#[test]
fn thesis_promises_no_limit_of_penetration() {
    let scene = Scene::builder("thesis")
        .method(Method { tier: Some(Tier::Thesis), step_s: Some(0.01), ..Method::default() })
        .duration_s(1.0)
        .body(floor())
        .body(ball("ball", 1.0, 0.1, DVec3::Z, DVec3::ZERO))
        .build()
        .unwrap();
    let (report, _) = run(&scene, Effects::Planned);
    let certificate = report.certificate;
    assert_eq!(report.outcome, Outcome::Completed);
    assert!(certificate.max_penetration_m > 1e-3 && certificate.max_penetration_of_limit == 0.0, "{certificate:?}");
}

/// Bodies that overlap at the start by less than the tolerance of a touch are moved apart. The certificate holds the
/// displacement, and the run is not degraded.
#[test]
fn overlap_within_touch_at_the_start_is_not_degraded() {
    let overlap_m = 0.9e-9;
    let scene = Scene::builder("overlap")
        .body(floor())
        .body(brick("box", DVec3::ONE, DVec3::Z * (0.5 - overlap_m)))
        .build()
        .unwrap();
    let (report, _) = run(&scene, Effects::Planned);
    let certificate = report.certificate;
    assert_eq!((report.outcome, certificate.max_projection_of_limit), (Outcome::Completed, 0.0));
    assert!((certificate.max_projection_m - overlap_m).abs() < 1e-15, "{certificate:?}");
    assert!((certificate.max_projection_j - 9.81 * overlap_m).abs() < 1e-14, "{certificate:?}");
    assert!(report.warnings[0].contains("moved apart"));
}

/// A box that falls on its edge and comes to rest uses less than half of the promised limits, at every tolerance from
/// the tightest to the loosest and at every scale of length.
#[test]
fn falling_box_keeps_its_promise() {
    for tolerance in [1e-12, 1e-11, 1e-9, 1e-6, 1e-3] {
        for size in [1e-3, 1.0, 1e3] {
            let box_on_edge = brick("box", DVec3::new(1.0, 0.5, 0.25) * size, DVec3::new(0.3, 0.0, 0.4) * size);
            let ledge = Body::fixed("ledge").geometry(Shape::cuboid(DVec3::new(0.5, 2.0, 0.1) * size).unwrap().into());
            let scene = Scene::builder("edge")
                .method(Method { tolerance: Some(tolerance), ..accurate() })
                .gravity(DVec3::NEG_Z * 9.81 * size)
                .body(ledge)
                .body(box_on_edge)
                .build()
                .unwrap();
            let certificate = run(&scene, Effects::Planned).0.certificate;
            assert!(certificate.max_penetration_of_limit < 0.5, "{tolerance} {size} {certificate:?}");
            assert!(certificate.max_projection_of_limit < 0.5, "{tolerance} {size} {certificate:?}");
        }
    }
}
