//! The tier `fast` obeys the laws of physics to the order of its steps: flight is exact, slides stop where they should,
//! stacks stand, nothing is lifted by sliding or passes through a plate, momentum is kept, the ledger closes, and its
//! motion has the same bits for any number of threads and when it goes on from a snapshot.

use crate::checks::assert_closes;
use crate::snapshots::check_restored_runs;
use crate::support::{ball, brick, elastic, floor, run_even_degraded};
use crate::threads::check_threads;
use polhode::contact::Shape;
use polhode::scene::{ContactMethod, Material, Method, Tier};
use polhode::spatial::{DVec3, Pose, Rotation, Velocity};
use polhode::{Body, Effects, EventKind, Geometry, RunReport, Scene, SceneBuilder, Simulation};

const G: f64 = 9.81;

fn fast(step_s: f64) -> Method {
    Method { tier: Some(Tier::Fast), step_s: Some(step_s), ..Method::default() }
}

fn rough(friction: f64) -> Material {
    Material::new("rough").with_friction(friction).unwrap()
}

fn run(scene: SceneBuilder) -> RunReport {
    let report = run_even_degraded(&scene.build().unwrap(), Effects::Planned).0;
    assert_closes(&report);
    report
}

fn position(report: &RunReport, body: usize) -> DVec3 {
    report.bodies[body].state.pose.translation
}

/// A body that touches nothing flies along its parabola at every step, with no error but rounding.
#[test]
fn flight_is_exact() {
    let body = || ball("stone", 2.0, 0.1, DVec3::Z, DVec3::new(3.0, 0.0, 4.0));
    for step in [1.0 / 60.0, 0.01] {
        let report = run(Scene::builder("flight").method(fast(step)).duration_s(1.0).body(body()));
        let exact = DVec3::new(3.0, 0.0, 1.0 + 4.0 - 0.5 * G);
        assert!((position(&report, 0) - exact).length() < 1e-12, "{step}");
        assert!(report.ledger.numerical.value().abs() < 1e-11, "{:?}", report.ledger);
    }
}

/// A box that slides at 3 m/s on friction 0.5 stops after `v^2 / (2 mu g)`; the error falls with the step. While it
/// slides it is not lifted: the convex model of friction would lift it at `mu v`.
#[test]
fn a_slide_stops_and_does_not_float() {
    let exact = 9.0 / (2.0 * 0.5 * G);
    let mut errors = Vec::new();
    for step in [1.0 / 60.0, 1.0 / 240.0] {
        let slider = brick("slider", DVec3::new(0.4, 0.4, 0.1), DVec3::Z * 0.05).material(rough(0.5));
        let slider = slider.velocity(Velocity::new(DVec3::X * 3.0, DVec3::ZERO));
        let scene = Scene::builder("slide").method(fast(step)).body(floor().material(rough(0.5))).body(slider);
        let half_way = position(&run(scene.clone().duration_s(0.3)), 1);
        assert!((half_way.z - 0.05).abs() < 1e-3, "{half_way}");
        let report = run(scene.duration_s(1.0));
        errors.push((position(&report, 1).x - exact).abs());
        assert!(report.bodies[1].state.velocity.linear.length() < 1e-6, "{:?}", report.bodies[1]);
        // All of its energy went into friction, but for the sag of the soft contact.
        assert!((report.ledger.friction.value() - 4.5).abs() < 0.05, "{:?}", report.ledger);
    }
    assert!(errors[0] < 0.03 && errors[1] < 0.5 * errors[0] + 1e-4, "{errors:?}");
}

/// A ball that falls from a metre with restitution 0.5 rises to a quarter of it, to the speed that gravity gives in a
/// step or two.
#[test]
fn a_bounce_reaches_its_height() {
    let ball = ball("ball", 1.0, 0.1, DVec3::Z * 1.1, DVec3::ZERO).material(elastic(0.5));
    let scene = Scene::builder("bounce").method(fast(1.0 / 240.0)).body(floor().material(elastic(0.5))).body(ball);
    let fall = (2.0 / G).sqrt();
    let rise = 0.5 * (2.0 * G).sqrt() / G;
    let report = run(scene.clone().duration_s(fall + rise));
    assert!((position(&report, 1).z - 0.35).abs() < 0.02, "{}", position(&report, 1));
    let settled = run(scene.duration_s(6.0));
    assert!((position(&settled, 1).z - 0.1).abs() < 1e-3, "{}", position(&settled, 1));
}

/// A stack of ten boxes stands for ten seconds.
#[test]
fn a_stack_stands() {
    let mut scene =
        Scene::builder("stack").method(fast(1.0 / 60.0)).duration_s(10.0).body(floor().material(rough(0.5)));
    for k in 0..10 {
        scene = scene.body(brick(&format!("b{k}"), DVec3::ONE, DVec3::Z * (f64::from(k) + 0.5)).material(rough(0.5)));
    }
    let report = run(scene);
    for k in 0..10 {
        let place = position(&report, k + 1);
        assert!((place - DVec3::Z * (k as f64 + 0.5)).length() < 0.03, "{k}: {place}");
    }
}

/// A ball at 300 m/s does not pass through a plate of a centimetre, though it moves by five metres in a step.
#[test]
fn a_shot_does_not_pass_a_thin_plate() {
    let plate = Body::fixed("plate").geometry(Geometry::Shape(Shape::cuboid(DVec3::new(2.0, 2.0, 0.01)).unwrap()));
    let shot = ball("shot", 0.1, 0.02, DVec3::Z * 7.3, DVec3::Z * -300.0);
    let scene = Scene::builder("shot").method(fast(1.0 / 60.0)).duration_s(0.1).body(plate).body(shot);
    let report = run(scene);
    assert!(position(&report, 1).z > 0.0, "{}", position(&report, 1));
}

/// Two bodies that hit each other away from everything keep their momentum, and their angular momentum to the order of
/// the step.
#[test]
fn momentum_is_kept() {
    let one = brick("one", DVec3::new(0.3, 0.2, 0.1), DVec3::ZERO).velocity(Velocity::new(DVec3::X * 2.0, DVec3::Y));
    let other = brick("other", DVec3::ONE * 0.3, DVec3::new(0.6, 0.05, 0.02));
    let scene = Scene::builder("hit").method(fast(1e-3)).duration_s(0.6).gravity(DVec3::ZERO);
    let report = run(scene.body(one.material(rough(0.3))).body(other.material(rough(0.3))));
    let momentum = &report.ledger.momentum;
    assert!((momentum.current.linear - DVec3::X * 2.0).length() < 1e-13, "{momentum:?}");
    assert!((momentum.current.angular - momentum.initial.angular).length() < 1e-3, "{momentum:?}");
    assert!(report.ledger.impact.value() > 0.1, "{:?}", report.ledger);
}

/// A heap of boxes and balls on a floor, five groups of it.
fn heaps() -> SceneBuilder {
    let material = || Material::new("m").with_friction(0.4).unwrap().with_restitution(0.3).unwrap();
    let mut scene = Scene::builder("heaps").method(fast(1.0 / 60.0)).duration_s(1.0).output_interval_s(0.25);
    scene = scene.body(floor().material(material()));
    for k in 0..60 {
        let (group, level) = (k / 12, k % 12);
        let place = DVec3::new(
            3.0 * f64::from(group) + 0.05 * f64::from(level % 3),
            0.04 * f64::from(level % 4),
            0.3 + 0.45 * f64::from(level),
        );
        let name = format!("body {k}");
        let body = if k % 3 == 0 {
            ball(&name, 1.0, 0.15, place, DVec3::ZERO)
        } else {
            let turn = Rotation::from_rotation_vector(DVec3::new(0.1, 0.2, 0.3) * f64::from(level));
            brick(&name, DVec3::new(0.3, 0.25, 0.2), place).pose(Pose::new(turn, place))
        };
        scene = scene.body(body.material(material()));
    }
    scene
}

/// The whole state, accounts with it, has the same bits with any number of threads.
#[test]
fn threads_change_no_bit() {
    let scene = heaps().build().unwrap();
    check_threads(&scene);
}

/// Bodies apart do not change each other: each group of the heaps moves as if it were alone.
#[test]
fn bodies_apart_do_not_matter() {
    let all = heaps().build().unwrap();
    let (whole, _) = run_even_degraded(&all, Effects::Planned);
    let mut alone = Scene::builder("alone").method(fast(1.0 / 60.0)).duration_s(1.0).output_interval_s(0.25);
    let material = || Material::new("m").with_friction(0.4).unwrap().with_restitution(0.3).unwrap();
    alone = alone.body(floor().material(material()));
    for body in &all.bodies()[1..=12] {
        alone = alone.body(body.clone());
    }
    let (part, _) = run_even_degraded(&alone.build().unwrap(), Effects::Planned);
    for k in 1..=12 {
        assert_eq!(part.bodies[k].state, whole.bodies[k].state, "{k}");
    }
}

/// The ledger of a heap with friction and restitution closes, and no energy is made.
#[test]
fn the_ledger_of_a_heap_closes() {
    let report = run(heaps());
    let ledger = &report.ledger;
    assert!(ledger.friction.value() > 0.0 && ledger.impact.value() > 0.0, "{ledger:?}");
    assert!(report.certificate.max_residual > 0.0 && report.certificate.max_residual.is_finite());
    assert!(report.certificate.max_penetration_m < 0.05, "{:?}", report.certificate);
}

/// A run that goes on from a snapshot has the same bits.
#[test]
fn a_restored_run_has_the_same_bits() {
    check_restored_runs(&heaps().duration_s(0.5).build().unwrap(), Effects::Planned);
}

/// What the tier does not take is refused with the tiers that do.
#[test]
fn what_is_not_taken_is_refused() {
    let sticky = Material::new("sticky").with_friction(0.3).unwrap().with_static_friction(0.5).unwrap();
    let scene = Scene::builder("sticky").method(fast(0.01)).body(floor().material(sticky.clone()));
    let error = scene.body(brick("b", DVec3::ONE, DVec3::Z * 0.5).material(sticky)).build().unwrap_err();
    assert!(error.to_string().contains("static friction"), "{error}");
}

/// A stack comes to rest: forces that hold it are found, and from then on its velocities are zero, exactly, until a
/// ball falls on it.
#[test]
fn what_rests_is_exactly_still_until_it_is_hit() {
    let mut scene = Scene::builder("rest").method(fast(1.0 / 60.0)).duration_s(20.0).body(floor().material(rough(0.5)));
    for k in 0..3 {
        scene = scene.body(brick(&format!("b{k}"), DVec3::ONE, DVec3::Z * (f64::from(k) + 0.5)).material(rough(0.5)));
    }
    // It falls for three seconds.
    let scene = scene.body(ball("ball", 0.5, 0.1, DVec3::Z * 48.0, DVec3::ZERO));
    let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
    simulation.advance_to(2.9).unwrap();
    let before = simulation.bodies();
    assert!(before[1..4].iter().all(|body| body.velocity == Velocity::ZERO), "{before:?}");
    simulation.advance_to(3.2).unwrap();
    assert!(simulation.bodies()[1..4].iter().any(|body| body.velocity != Velocity::ZERO));
}

/// A pyramid of cubes of 1 m that are 5 cm apart beside each other, on a rough floor.
fn pyramid(rows: u32) -> SceneBuilder {
    let mut scene =
        Scene::builder("pyramid").method(fast(1.0 / 60.0)).duration_s(6.0).body(floor().material(rough(0.5)));
    for row in 0..rows {
        for place in 0..rows - row {
            let x = 1.05 * (f64::from(place) + 0.5 * f64::from(row));
            let center = DVec3::new(x, 0.0, f64::from(row) + 0.5);
            scene = scene.body(brick(&format!("b{row}-{place}"), DVec3::ONE, center).material(rough(0.5)));
        }
    }
    scene
}

/// A pyramid of twenty rows comes to rest: after six seconds no body moves, exactly. (With sweeps that all went the
/// same way, and contacts that forget less of their impulses, the stack swung on what it carried over from step to
/// step, for ever.)
#[test]
fn a_pyramid_of_twenty_rows_comes_to_rest() {
    let report = run(pyramid(20));
    assert!(report.bodies.iter().all(|body| body.state.velocity.is_zero()), "{:?}", report.energy);
}

/// A pyramid of forty rows sinks until its contacts bear it, and hardly farther: its top is never lower than three
/// hundredths below where it comes to. (It was, by seven hundredths, when all sweeps went the same way and contacts
/// forgot more of their impulses.)
#[test]
fn a_tall_pyramid_sinks_hardly_farther_than_it_sags() {
    const ROWS: u32 = 40;
    let mut simulation = Simulation::new(&pyramid(ROWS).build().unwrap()).unwrap();
    let top = simulation.bodies().len() - 1;
    let mut sinks = Vec::new();
    for look in 1..=36 {
        simulation.advance_to(0.05 * f64::from(look)).unwrap();
        sinks.push(f64::from(ROWS) - 0.5 - simulation.bodies()[top].pose.translation.z);
    }
    let (largest, last) = (sinks.iter().copied().fold(0.0, f64::max), sinks[35]);
    assert!(largest < 1.03 * last, "{sinks:?}");
}

/// A sample a moment after the end of a step, by the rounding of its time, shows the velocities of that step. (Overlaps
/// were pushed apart by as much as in a whole step, in no time: a body that slid at 10 m/s was shown at 1e11 m/s.)
#[test]
fn a_sample_just_after_a_step_shows_the_velocities_of_the_step() {
    let slider = brick("slider", DVec3::ONE, DVec3::Z * 0.5).velocity(Velocity::new(DVec3::X * 10.0, DVec3::ZERO));
    let scene = Scene::builder("slide").method(fast(1.0 / 60.0)).duration_s(0.5).body(floor()).body(slider);
    let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
    for step in 1..=30 {
        let end = f64::from(step) / 60.0;
        for moment in [0.0, 1e-16, 1e-13, 1e-9] {
            simulation.advance_to(end + moment).unwrap();
            let velocity = simulation.bodies()[1].velocity;
            assert!((velocity.linear - DVec3::X * 10.0).length() < 0.1, "{step}: {velocity:?}");
            assert!(velocity.angular.length() < 0.1, "{step}: {velocity:?}");
        }
    }
}

/// A thin slab that slides fast lies on its four lower corners. (In a step it moves farther than it is thick, so that
/// the search found its upper corners too; two of them took the places of lower ones, and it sank by a third of its
/// thickness.)
#[test]
fn a_thin_slab_that_slides_fast_does_not_sink() {
    let slab = brick("slab", DVec3::new(1.0, 0.5, 0.1), DVec3::Z * 0.05).material(rough(0.1));
    let slab = slab.velocity(Velocity::new(DVec3::X * 10.0, DVec3::ZERO));
    let scene = Scene::builder("slide").method(fast(1.0 / 60.0)).duration_s(0.5);
    let report = run(scene.body(floor().material(rough(0.1))).body(slab));
    assert!((position(&report, 1).z - 0.05).abs() < 2e-4, "{}", position(&report, 1));
}

/// With conjugate gradients between sweeps (`contact = "nncg"`) a tall stack is nearer to the law, step by step, and
/// sags less.
#[test]
fn conjugate_gradients_leave_a_smaller_residual_of_a_tall_stack() {
    let of = |contact: Option<ContactMethod>| {
        let method = Method { contact, ..fast(1.0 / 60.0) };
        let mut scene = Scene::builder("stack").method(method).duration_s(1.0).body(floor().material(rough(0.5)));
        for k in 0..20 {
            let center = DVec3::Z * (f64::from(k) + 0.5);
            scene = scene.body(brick(&format!("b{k}"), DVec3::ONE, center).material(rough(0.5)));
        }
        let report = run(scene);
        (report.certificate.max_residual, 19.5 - position(&report, 20).z)
    };
    let (plain, conjugate) = (of(None), of(Some(ContactMethod::ConjugateGradients)));
    assert!(conjugate.0 < 0.7 * plain.0 && conjugate.1 < plain.1, "{conjugate:?} {plain:?}");
}

/// A ball that bounces is told as impacts: each at the end of the step in which it came, with the impulse and the loss
/// of `(1 - e^2) m v^2 / 2`.
#[test]
fn impacts_are_events() {
    let (speed, restitution) = (3.0, 0.5);
    let ball = ball("ball", 2.0, 0.1, DVec3::Z * 0.4, DVec3::Z * -speed).material(elastic(restitution));
    let scene = Scene::builder("hit").method(fast(1e-3)).duration_s(0.15).gravity(DVec3::ZERO);
    let scene = scene.body(floor().material(elastic(restitution))).body(ball).build().unwrap();
    let (_, recorder) = run_even_degraded(&scene, Effects::Planned);
    let impacts: Vec<_> = recorder.events.iter().filter(|event| event.kind == EventKind::Impact).collect();
    let [impact] = impacts[..] else { panic!("{impacts:?}") };
    assert!((impact.t_s - 0.1).abs() < 2e-3, "{impact:?}");
    assert!((impact.impulse - 2.0 * speed * (1.0 + restitution)).abs() < 1e-9, "{impact:?}");
    let loss = 0.5 * 2.0 * speed * speed * (1.0 - restitution * restitution);
    assert!((impact.energy_change_j + loss).abs() < 1e-9, "{impact:?}");
    assert!((impact.normal.z.abs() - 1.0).abs() < 1e-12 && impact.body_b.is_some(), "{impact:?}");
}
