//! Every query of a simulation, in every tier, on one scene whose answers are known: a box rests on a floor, a ball
//! flies and a ball hangs on a spring. What a tier does not compute is absent and not zero.

use crate::support::{ball, brick, floor};
use polhode::contact::Ray;
use polhode::scene::{Attachment, Force, Method, Tier};
use polhode::spatial::{DVec3, UnitVector};
use polhode::{BodyId, MotionKind, Scene, Simulation};

const G: f64 = 9.81;

fn simulation(tier: Tier) -> Simulation {
    let spring = Force::Spring {
        a: Attachment::World(DVec3::new(5.0, 0.0, 4.0)),
        b: Attachment::Body { body: BodyId::new(3), point: DVec3::ZERO },
        stiffness: 20.0 * G,
        rest_length: 0.9,
        damping: 0.0,
    };
    let scene = Scene::builder("queries").duration_s(1.0).body(floor());
    let scene = scene.method(Method { tier: Some(tier), step_s: Some(1e-3), ..Method::default() });
    let scene = scene.body(brick("box", DVec3::new(0.4, 0.3, 0.2), DVec3::Z * 0.1));
    let scene = scene.body(ball("flying", 2.0, 0.1, DVec3::new(2.0, 0.0, 3.0), DVec3::Y));
    // At rest: the spring is longer by m g/k.
    let scene = scene.body(ball("hanging", 2.0, 0.1, DVec3::new(5.0, 0.0, 3.0), DVec3::ZERO)).force(spring);
    Simulation::new(&scene.build().unwrap()).unwrap()
}

#[test]
fn every_query_answers_in_every_tier() {
    for tier in [Tier::Accurate, Tier::Stepped, Tier::Thesis, Tier::Fast] {
        // Soft contacts sag by the square of a step times gravity, and a fixed number of sweeps leaves a part of the
        // forces.
        let is_soft = tier == Tier::Fast;
        let (place, force) = if is_soft { (1e-5, 1e-2) } else { (1e-11, 1e-9) };
        let mut simulation = simulation(tier);
        let t = 0.3;
        simulation.advance_to(t).unwrap();
        let [box_, flying, hanging] = ["box", "flying", "hanging"].map(|name| simulation.body_id(name).unwrap());
        let position = |id: BodyId| simulation.body(id).pose.translation;
        let flown = DVec3::new(2.0, t, 3.0 - 0.5 * G * t * t);
        assert!((position(flying) - flown).length() < 1e-11, "{tier:?}");
        assert!((position(box_) - DVec3::Z * 0.1).length() < place, "{tier:?}");
        // The balance of a spring is held to g h^2.
        assert!((position(hanging) - DVec3::new(5.0, 0.0, 3.0)).length() < 1e-5, "{tier:?}");
        let listed = simulation.bodies();
        assert!([box_, flying, hanging].iter().all(|&id| listed[id.index()] == simulation.body(id)), "{tier:?}");

        let contacts = simulation.contacts();
        let sum: f64 = contacts.iter().map(|contact| contact.normal_force_n * contact.normal.z.abs()).sum();
        assert!(contacts.len() == 4 && (sum - G).abs() < force, "{tier:?} {sum}");
        assert!(simulation.pivots().is_empty(), "{tier:?}");
        let islands = simulation.islands();
        assert!(islands.iter().flat_map(|island| &island.bodies).any(|&id| id == box_), "{tier:?} {islands:?}");

        // The stretch of the spring is m g/k = 0.1 m.
        let kinetic = 0.5 * 2.0 * (1.0 + (G * t) * (G * t));
        let potential = G * (0.1 + 2.0 * flown.z + 2.0 * 3.0) + 0.5 * 20.0 * G * 0.01;
        let energy = simulation.energy();
        assert!((energy.kinetic_j - kinetic).abs() < 1e-4, "{tier:?} {energy:?} {kinetic}");
        assert!((energy.potential_j - potential).abs() < 1e-4, "{tier:?} {energy:?} {potential}");
        let momentum = simulation.momentum().linear;
        assert!((momentum - 2.0 * DVec3::new(0.0, 1.0, -G * t)).length() < 1e-3, "{tier:?} {momentum}");

        let frame = simulation.frame();
        assert_eq!((frame.t_s, frame.energy, frame.bodies), (t, energy, listed), "{tier:?}");
        assert_eq!(frame.motions[0], MotionKind::Given, "{tier:?}");
        assert_eq!(frame.contacts, contacts, "{tier:?}");
        let queries = simulation.queries().unwrap();
        let down = Ray::new(DVec3::Z * 9.0, UnitVector::new(-DVec3::Z).unwrap()).unwrap();
        let (first, hit) = queries.first_hit(&down, 100.0).unwrap();
        assert!(first == box_ && (hit.distance - 8.8).abs() < place.max(1e-9), "{tier:?}");

        let accelerations = simulation.accelerations().unwrap();
        let expected = [(box_, DVec3::ZERO), (flying, -DVec3::Z * G), (hanging, DVec3::ZERO)];
        for (id, exact) in expected {
            assert!((accelerations[id.index()].linear - exact).length() < 1e-3, "{tier:?} {accelerations:?}");
        }

        let report = simulation.run().unwrap();
        let certificate = report.certificate;
        assert!(report.error.largest.is_some(), "{tier:?} {:?}", report.error);
        let is_fixed = tier != Tier::Accurate;
        if is_soft {
            // It estimates no error of a step.
            assert_eq!(certificate.max_step_error, None);
            assert!(certificate.max_residual.is_finite() && certificate.max_acceleration_error_bound.is_none());
            continue;
        }
        assert_eq!(certificate.max_step_error.is_some(), !is_fixed, "{tier:?}");
        assert_eq!(certificate.max_acceleration_error_bound.is_some(), tier != Tier::Stepped, "{tier:?}");
    }
}
