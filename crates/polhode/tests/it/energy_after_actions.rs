//! Energies are sums over what is there: after any order of adding, removing, stopping and moving bodies, in every
//! tier, the energy that a simulation reports is that of the bodies it has.

use crate::support::{ball, floor};
use polhode::scene::{Attachment, Force, Method, Tier};
use polhode::spatial::{DVec3, Pose, SplitMix64, Velocity};
use polhode::{BodyId, Scene, Simulation};

const G: f64 = 9.81;
const STIFFNESS: f64 = 40.0;
const ANCHOR: DVec3 = DVec3::new(0.0, 0.0, 3.0);

/// A body of the test, by its handle.
struct Known {
    id: BodyId,
    mass: f64,
    /// Whether a spring holds it.
    on_spring: bool,
}

/// Kinetic energy, gravity and springs of these balls, J.
fn energy(simulation: &Simulation, balls: &[Known]) -> f64 {
    let of = |known: &Known| {
        let body = simulation.body(known.id);
        let (v, w) = (body.velocity.linear.length_squared(), body.velocity.angular.length_squared());
        let stretch = if known.on_spring { (body.pose.translation - ANCHOR).length() } else { 0.0 };
        0.5 * known.mass * (v + 0.4 * 0.01 * w)
            + known.mass * G * body.pose.translation.z
            + 0.5 * STIFFNESS * stretch * stretch
    };
    balls.iter().map(of).sum()
}

/// Random actions on balls above a floor, of which some hang on springs.
#[test]
fn the_energy_is_that_of_the_bodies_that_are_there() {
    for (seed, tier) in (0..12).map(|seed| (seed, [Tier::Accurate, Tier::Stepped, Tier::Thesis][seed as usize % 3])) {
        let mut random = SplitMix64::new(seed);
        let method = Method { tier: Some(tier), step_s: Some(0.01), ..Method::default() };
        let mut scene = Scene::builder("actions").duration_s(10.0).method(method).body(floor());
        let mut masses = Vec::new();
        let between = |random: &mut SplitMix64, from: f64, to: f64| from + (to - from) * random.uniform();
        for number in 0..3 {
            let mass = between(&mut random, 0.5, 2.0);
            let at = DVec3::new(f64::from(number), 0.0, between(&mut random, 0.5, 2.0));
            scene = scene.body(ball(&format!("ball {number}"), mass, 0.1, at, DVec3::ZERO));
            masses.push(mass);
        }
        for body in [1, 2] {
            let b = Attachment::Body { body: BodyId::new(body), point: DVec3::ZERO };
            let a = Attachment::World(ANCHOR);
            scene = scene.force(Force::Spring { a, b, stiffness: STIFFNESS, rest_length: 0.0, damping: 0.0 });
        }
        let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
        let known = |(number, &mass): (usize, &f64)| {
            let id = simulation.body_id(&format!("ball {number}")).unwrap();
            Known { id, mass, on_spring: number < 2 }
        };
        let mut balls: Vec<Known> = masses.iter().enumerate().map(known).collect();
        for action in 0..20 {
            let t = simulation.time() + 0.013;
            simulation.advance_to(t).unwrap();
            let place = (random.uniform() * balls.len() as f64) as usize;
            let what = (4.0 * random.uniform()) as usize;
            let at =
                DVec3::new(10.0 + f64::from(action), between(&mut random, -1.0, 1.0), between(&mut random, 0.5, 4.0));
            match (what, balls.get(place).map(|known| known.id)) {
                (0, Some(id)) => {
                    simulation.remove_body(id).unwrap();
                    balls.remove(place);
                }
                (1, Some(id)) => simulation.set_velocity(id, Velocity::ZERO).unwrap(),
                (2, Some(id)) => simulation.set_pose(id, Pose::from_translation(at)).unwrap(),
                _ => {
                    let mass = between(&mut random, 0.5, 2.0);
                    let added = ball(&format!("new {action}"), mass, 0.1, at, DVec3::X);
                    balls.push(Known { id: simulation.add_body(added).unwrap(), mass, on_spring: false });
                }
            }
            let (found, exact) = (simulation.energy().final_j, energy(&simulation, &balls));
            assert!((found - exact).abs() < 1e-9, "{tier:?} {seed} {action}: {found} instead of {exact}");
        }
        let t = simulation.time() + 0.05;
        simulation.advance_to(t).unwrap();
        let frame = simulation.frame();
        assert!(frame.ledger.closure_relative() < 1e-10, "{tier:?} {seed}: {:e}", frame.ledger.closure_relative());
    }
}
