//! The tier `micro-collisions`: impulses alone hold bodies up, within the envelope; a body that slides stops where
//! Coulomb's law for the mean force says; the ledger closes, no collision gives energy, and a run continues from a
//! snapshot with the same bits.

use crate::support::{ball, elastic, floor, run};
use polhode::mesh::solid_box;
use polhode::scene::{Material, Method, Response, SceneBuilder, Tier};
use polhode::spatial::{DVec3, Mass, Pose, Velocity};
use polhode::{Body, Effects, Geometry, Scene, Simulation, Snapshot};

const GRAVITY: f64 = 9.81;
const ENVELOPE_M: f64 = 5e-4;

fn impulse() -> Method {
    Method { response: Some(Response::Impulse), collision_envelope_m: Some(ENVELOPE_M), ..Method::default() }
}

/// A box of 1 kg, 0.4 x 0.3 x 0.2 m, that lies on a floor of its material.
fn sliding_box(friction: f64, speed: f64) -> SceneBuilder {
    let material = Material::new("wood").with_friction(friction).unwrap();
    let size = DVec3::new(0.4, 0.3, 0.2);
    let body = Body::movable("box", solid_box(size, Mass::new(1.0).unwrap()).unwrap())
        .geometry(Geometry::from(polhode::contact::Shape::cuboid(size).unwrap()))
        .pose(Pose::from_translation(DVec3::Z * 0.1))
        .velocity(Velocity::new(DVec3::X * speed, DVec3::ZERO))
        .material(material.clone());
    Scene::builder("slide").method(impulse()).body(floor().material(material)).body(body)
}

/// `response = "impulse"` without a tier is this tier; with tier thesis it is the thesis's first try, and another is
/// refused.
#[test]
fn the_response_selects_the_tier() {
    let tier = |method: Method| {
        let scene = sliding_box(0.0, 0.0).method(method).duration_s(0.01).build()?;
        Ok::<_, polhode::SceneError>(Simulation::new(&scene).unwrap().plan().tier)
    };
    let with = |tier: Tier| Method { tier: Some(tier), response: Some(Response::Impulse), ..Method::default() };
    assert_eq!(tier(impulse()).unwrap(), Tier::MicroCollisions);
    assert_eq!(tier(with(Tier::MicroCollisions)).unwrap(), Tier::MicroCollisions);
    assert_eq!(tier(with(Tier::Thesis)).unwrap(), Tier::Thesis);
    for other in [Tier::Accurate, Tier::Stepped] {
        let refused = tier(with(other)).unwrap_err().to_string();
        assert!(refused.contains("impulse") && refused.contains("micro-collisions"), "{refused}");
    }
    let refused = tier(Method { collision_envelope_m: Some(1e-3), ..Method::default() }).unwrap_err().to_string();
    assert!(refused.contains("collision_envelope"), "{refused}");
    for bad in [0.0, -1.0, f64::NAN] {
        assert!(tier(Method { collision_envelope_m: Some(bad), ..impulse() }).is_err());
    }
}

/// A ball that lies on the floor neither sinks nor rises out of the envelope in ten seconds, ten thousand collisions;
/// the mean of its impulses carries its weight.
#[test]
fn a_ball_at_rest_stays_in_the_envelope() {
    for start_m in [0.0, 0.5 * ENVELOPE_M, 20.0 * ENVELOPE_M] {
        let scene = Scene::builder("ball")
            .method(impulse())
            .duration_s(10.0)
            .body(floor().material(elastic(0.3)))
            .body(ball("ball", 2.0, 0.1, DVec3::Z * (0.1 + start_m), DVec3::ZERO).material(elastic(0.3)))
            .build()
            .unwrap();
        let (report, record) = run(&scene, Effects::Planned);
        assert!(report.ledger.closure_relative() < 1e-12, "{}", report.ledger.closure_relative());
        assert!(report.ledger.momentum.closure_relative() < 1e-12);
        let gaps = record.samples.iter().map(|bodies| bodies[1].pose.translation.z - 0.1);
        for gap in gaps.skip(record.samples.len() / 2) {
            assert!((-2e-6..=ENVELOPE_M).contains(&gap), "{start_m}: {gap}");
        }
        // Twice the step at which the collisions repeat.
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(9.0).unwrap();
        let mut sum = 0.0;
        for _ in 0..1000 {
            simulation.step().unwrap();
            sum += simulation.contacts().iter().map(|contact| contact.normal_force_n).sum::<f64>();
        }
        assert!((sum / 1000.0 / (2.0 * GRAVITY) - 1.0).abs() < 0.01, "{start_m}: {sum}");
    }
}

/// A box that slides at 2 m/s stops after v^2/(2 mu g), to the part of it that a tenth of a second of uneven collisions
/// makes.
#[test]
fn a_box_stops_where_the_mean_of_friction_says() {
    let (friction, speed) = (0.4, 2.0);
    let scene = sliding_box(friction, speed).duration_s(1.0).build().unwrap();
    let (report, record) = run(&scene, Effects::Planned);
    let expected = speed * speed / (2.0 * friction * GRAVITY);
    let found = record.samples.last().unwrap()[1].pose.translation;
    assert!((found.x / expected - 1.0).abs() < 0.05, "{} {expected}", found.x);
    assert!((found.z - 0.1).abs() < 2.0 * ENVELOPE_M, "{found}");
    assert!(report.ledger.closure_relative() < 1e-12, "{}", report.ledger.closure_relative());
    assert!(report.ledger.impact.value() >= -1e-12 && report.ledger.friction.value() > 1.5);
}

/// Without friction nothing slows it.
#[test]
fn a_box_without_friction_slides_on() {
    let scene = sliding_box(0.0, 2.0).duration_s(1.0).build().unwrap();
    let (_, record) = run(&scene, Effects::Planned);
    assert!((record.samples.last().unwrap()[1].pose.translation.x - 2.0).abs() < 1e-9);
}

/// A run stopped at any time continues from its snapshot with the same bits.
#[test]
fn a_run_continues_with_the_same_bits() {
    let scene = sliding_box(0.4, 2.0).duration_s(0.3).build().unwrap();
    for stop in [0.0, 0.0505, 0.2] {
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(stop).unwrap();
        let saved = Snapshot::from_bytes(&simulation.snapshot().to_bytes()).unwrap();
        let mut other = Simulation::new(&scene).unwrap();
        other.restore(&saved).unwrap();
        for _ in 0..50 {
            simulation.step().unwrap();
            other.step().unwrap();
        }
        assert_eq!(simulation.snapshot().to_bytes(), other.snapshot().to_bytes());
    }
}

/// A box that sticks on a slope of 20 degrees does not creep: a micro-collision gives back the slip of the flight
/// before it, uphill (Mirtich 1996, section 3.5). By stopping the slip alone it would creep by g h sin(slope)/2, 1.7 mm
/// in this second.
#[test]
fn a_box_that_sticks_on_a_slope_does_not_creep() {
    let (sin, cos) = 20f64.to_radians().sin_cos();
    for law in [None, Some(polhode::scene::ImpactLaw::Simultaneous)] {
        let method = Method { impact: law, ..impulse() };
        let slope = DVec3::new(GRAVITY * sin, 0.0, -GRAVITY * cos);
        let scene = sliding_box(1.0, 0.0).method(method).gravity(slope).duration_s(1.0).build().unwrap();
        let (report, _) = run(&scene, Effects::Planned);
        let state = report.bodies[1].state;
        assert!(state.pose.translation.x.abs() < 1e-4, "{law:?}: {}", state.pose.translation.x);
        assert!((state.pose.translation.z - 0.1).abs() < ENVELOPE_M);
        assert!(report.ledger.closure_relative() < 1e-12);
    }
}
