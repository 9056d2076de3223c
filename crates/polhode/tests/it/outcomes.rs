//! How runs end: a run that has not kept what its method promises says so, with bodies and time.

use crate::support::{accurate, ball, brick, elastic, floor, run, run_even_degraded};
use polhode::Flow;
use polhode::contact::Shape;
use polhode::scene::{Joint, Method, OverlapLimit, PromiseChanges, Tier};
use polhode::spatial::{DVec3, Mass, UnitVector};
use polhode::{Body, BodyId, BodySample, Effects, Observer, Outcome, RunReport, Scene, SceneBuilder, Simulation};

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
    for part in ["t = ", "degraded", "ring and ball", "promised", "projections gave"] {
        assert!(report.warnings[0].contains(part), "{part}: {}", report.warnings[0]);
    }
    let counted: u64 = report.tolerated.iter().map(|tolerated| tolerated.count).sum();
    assert!(counted > 0 && counted == certificate.fallbacks, "{:?}", report.tolerated);
    assert!(report.tolerated.iter().all(|tolerated| tolerated.what.contains("ring and ball")));
}

/// What a degraded run says in words it also says in numbers: bodies, time, value, limit, and what would help.
#[test]
fn a_broken_promise_is_told_in_numbers_too() {
    let (report, _) = run_even_degraded(&ball_on_ring(1e-2).build().unwrap(), Effects::Planned);
    let broken = &report.broken[0];
    assert_eq!(broken.to_string(), report.warnings[0]);
    assert_eq!(broken.bodies, Some([BodyId::new(0), BodyId::new(1)]));
    assert!(broken.t_s.is_some_and(|t| t > 0.0 && t <= 3.0));
    assert!(broken.value.unwrap() > broken.limit.unwrap());
    let (kept, _) = run_even_degraded(&ball_on_ring(1e-11).build().unwrap(), Effects::Planned);
    assert!(kept.broken.is_empty(), "{:?}", kept.broken);
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
    let mut simulation = Simulation::new(&ball_on_ring(1e-11).build().unwrap()).unwrap();
    simulation.advance_to_observed(2.0, &mut StopAt(0.1)).unwrap();
    assert!(simulation.time() >= 0.1 && simulation.time() < 2.0, "an observer stops an advance too");
    simulation.advance_to(2.0).unwrap();
    assert_eq!(simulation.time(), 2.0);
    assert_eq!(end(1e-2, 0.1), Outcome::Stopped);
    assert_eq!(end(1e-2, 1.5), Outcome::Degraded);
}

/// A ball of the tier `thesis` penetrates the floor by the distance it falls in one step.
fn ball_of_the_thesis(step_s: f64, promise: PromiseChanges) -> RunReport {
    let scene = Scene::builder("thesis")
        .method(Method { tier: Some(Tier::Thesis), step_s: Some(step_s), promise, ..Method::default() })
        .duration_s(1.0)
        .body(floor())
        .body(ball("ball", 1.0, 0.1, DVec3::Z, DVec3::ZERO))
        .build()
        .unwrap();
    run_even_degraded(&scene, Effects::Planned).0
}

/// The step that a warning proposes, s.
fn proposed_step(report: &RunReport) -> f64 {
    report.warnings[0].split("a step of ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap()
}

/// Tiers of fixed steps have limits too: beyond a hundredth of the ball its run is degraded, and the warning names the
/// bodies, the limit and a step that may do. How deep the ball is when its step ends is chance: the second proposal at
/// the latest does.
#[test]
fn a_tier_of_fixed_steps_degrades_a_run_whose_bodies_overlap() {
    let report = ball_of_the_thesis(0.01, PromiseChanges::default());
    assert_eq!(report.outcome, Outcome::Degraded);
    assert!(report.certificate.max_penetration_of_limit > 1.0, "{:?}", report.certificate);
    let warning = &report.warnings[0];
    for part in ["floor and ball overlapped by", "the promised limit is", "a shorter method.step would help"] {
        assert!(warning.contains(part), "{part}: {warning}");
    }
    let again = |report: &RunReport| ball_of_the_thesis(proposed_step(report), PromiseChanges::default());
    let mut report = again(&report);
    if report.outcome == Outcome::Degraded {
        report = again(&report);
    }
    assert_eq!(report.outcome, Outcome::Completed, "{:?}", report.warnings);
}

/// A scene sets the limits that its run is held to, wider or narrower ones; the plan tells them, and a limit that is
/// not positive is refused.
#[test]
fn a_scene_sets_its_own_promise() {
    let overlap = |limit: f64| PromiseChanges { overlap: Some(limit), ..PromiseChanges::default() };
    let wide = ball_of_the_thesis(0.01, PromiseChanges { error: Some(10.0), ..overlap(0.5) });
    assert_eq!((wide.outcome, wide.plan.promise.overlap), (Outcome::Completed, OverlapLimit::OfSize(0.5)));
    // The error of the ball is what such an overlap leaves.
    assert_eq!(ball_of_the_thesis(0.01, overlap(0.5)).outcome, Outcome::Degraded);
    assert_eq!(ball_of_the_thesis(0.001, overlap(1e-4)).outcome, Outcome::Degraded);
    for limit in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(overlap(limit).validate().unwrap_err().to_string().contains("promise.overlap"), "{limit}");
    }
}

/// A joint that is open by more than is promised degrades the run; the warning names its bodies.
#[test]
fn a_joint_that_opens_degrades_its_run() {
    let bar =
        Body::movable("bar", polhode::mesh::solid_box(DVec3::new(0.5, 0.1, 0.1), Mass::new(1.0).unwrap()).unwrap());
    let ends = |gap: Option<f64>| {
        let promise = PromiseChanges { joint_gap: gap, ..PromiseChanges::default() };
        let scene = Scene::builder("pendulum")
            .method(Method { tier: Some(Tier::Fast), promise, ..Method::default() })
            .joint(Joint::hinge(BodyId::new(0), DVec3::X * 0.25, UnitVector::Y))
            .body(bar.clone())
            .build()
            .unwrap();
        run_even_degraded(&scene, Effects::Planned).0
    };
    assert_eq!(ends(None).outcome, Outcome::Completed);
    let report = ends(Some(1e-12));
    assert_eq!(report.outcome, Outcome::Degraded);
    assert!(report.warnings[0].contains("a joint of bar was open by"), "{:?}", report.warnings);
    assert!(report.certificate.max_joint_error_of_limit > 1.0 && report.certificate.max_joint_error_at.is_some());
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
