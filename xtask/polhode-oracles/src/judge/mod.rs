//! Judges whole runs of random scenes from the scene, the sampled states and the terms of the ledger alone.
//!
//! Everything is computed anew by code that shares nothing with the program judged: masses, separations, energies,
//! momenta. What is held against the run:
//!
//! | law | holds |
//! |---|---|
//! | states | all numbers finite, quaternions of length 1, samples where they are asked for |
//! | still bodies | fixed bodies stay, kinematic ones follow their motion |
//! | penetration | no two bodies are in each other |
//! | energy | T + V of the states is that of the report, falls where nothing drives, and is what the ledger leaves |
//! | ledger | losses to friction, impacts, rest and damping are not negative; the integrator takes next to nothing |
//! | momentum | of bodies among themselves stays |
//! | flight | bodies that can touch nothing fly along a parabola, with their angular momentum |
//! | Coulomb | the impulse that a plane gives a body presses, and its tangential part is within the cone |
//!
//! | module | holds |
//! |---|---|
//! | `judged` | the run and the scene that are judged, and the findings |
//! | `piece` | shapes as unions of thickened convex cores and rings |
//! | `distance` | distance of a point from a core |
//! | `separation` | separation of two cores |
//! | `pairs` | separations of all bodies at every sample |
//! | `mass` | centre of mass and inertia |
//! | `energy` | energy and ledger |
//! | `motion` | flight, momentum, Coulomb's law, prescribed motions |
//! | `tiers` | whether runs of several tiers, steps and copies of a scene are one motion |

mod distance;
mod energy;
mod judged;
mod mass;
mod motion;
mod pairs;
mod piece;
mod separation;
pub mod tiers;

use crate::random_scene::model::{Form, Model, Role};
use judged::Judged;
use mass::Weight;

pub use judged::{Account, Finding, Findings, State, Track};
pub use pairs::are_apart;

/// Volume of a shape, m^3; that of a compound is the sum of its parts.
pub fn volume(form: &Form) -> f64 {
    Weight::of(form).mass
}

/// All laws that a run has broken.
pub fn judge(model: &Model, track: &Track) -> Vec<Finding> {
    let mut findings = Findings::default();
    let weights = model
        .bodies
        .iter()
        .map(|body| {
            let weight = Weight::of(&body.form);
            if let Role::Free(mass) = body.role { weight.of_mass(mass) } else { weight }
        })
        .collect();
    let judged = Judged { model, weights };
    if !motion::states(&judged, track, &mut findings) {
        return findings.0;
    }
    let near = pairs::penetration(&judged, track, &mut findings);
    motion::still_bodies(&judged, track, &mut findings);
    motion::momentum(&judged, track, &mut findings);
    motion::intervals(&judged, track, &near, &mut findings);
    energy::hold(&judged, track, &mut findings);
    findings.0
}

#[cfg(test)]
mod tests {
    //! A fall in closed form breaks no law, and each way to be wrong breaks the law that is named after it.
    use super::*;
    use crate::random_scene::generate;
    use crate::random_scene::model::{Body, Material};
    use glam::{DQuat, DVec3};

    const GRAVITY: DVec3 = DVec3::new(0.0, 0.0, -9.81);
    const HEIGHT: f64 = 2.0;

    /// A box of 1 kg above a plane, or beside one.
    fn model(normal: DVec3, position: DVec3) -> Model {
        let mut model = generate::scene(0);
        let rough = Material { friction: 0.5, static_friction: 0.5, rolling: 0.0, spinning: 0.0, restitution: 0.0 };
        let body = |name: &str, form: Form, role: Role, position: DVec3| Body {
            name: name.to_owned(),
            form,
            role,
            position,
            orientation: DQuat::IDENTITY,
            velocity: DVec3::ZERO,
            angular_velocity: DVec3::ZERO,
            material: 0,
            pivot: None,
        };
        model.gravity = GRAVITY;
        model.duration = 0.5;
        model.materials = vec![rough];
        model.forces = Vec::new();
        model.restitution_law = None;
        model.bodies = vec![
            body("plane", Form::HalfSpace(normal), Role::Fixed, DVec3::ZERO),
            body("box", Form::Cuboid(DVec3::ONE), Role::Free(1.0), position),
        ];
        model
    }

    /// A track of both bodies; the box is where and as fast as it is told.
    fn track(motion: impl Fn(f64) -> (DVec3, DVec3)) -> Track {
        let times: Vec<f64> = (0..=50).map(|k| f64::from(k) * 0.01).collect();
        let state = |position: DVec3, velocity: DVec3| State {
            position,
            orientation: DQuat::IDENTITY,
            velocity,
            angular_velocity: DVec3::ZERO,
        };
        let states = times.iter().map(|&t| {
            let (position, velocity) = motion(t);
            vec![state(DVec3::ZERO, DVec3::ZERO), state(position, velocity)]
        });
        let states: Vec<Vec<State>> = states.collect();
        let energy = |state: &State| 0.5 * state.velocity.length_squared() - GRAVITY.dot(state.position);
        let (initial, end) = (energy(&states[0][1]), energy(&states[50][1]));
        let account = Account { initial, end, friction: initial - end, ..Account::default() };
        Track { times, states, account }
    }

    fn laws(findings: &[Finding]) -> Vec<&'static str> {
        findings.iter().map(|finding| finding.law).collect()
    }

    fn fall(from: DVec3) -> impl Fn(f64) -> (DVec3, DVec3) {
        move |t| (from + 0.5 * t * t * GRAVITY, GRAVITY * t)
    }

    #[test]
    fn a_fall_is_right() {
        let model = model(DVec3::Z, DVec3::Z * HEIGHT);
        let findings = judge(&model, &track(fall(DVec3::Z * HEIGHT)));
        assert!(findings.is_empty(), "{findings:?}");
    }

    #[test]
    fn a_fall_that_gains_is_not() {
        let model = model(DVec3::Z, DVec3::Z * HEIGHT);
        let wrong = |t: f64| (DVec3::Z * HEIGHT + 0.5 * t * t * GRAVITY, GRAVITY * t * 1.001);
        assert!(laws(&judge(&model, &track(wrong))).contains(&"flight"));
    }

    #[test]
    fn a_body_in_a_plane_is_found() {
        let at = DVec3::Z * 0.5;
        let model = model(DVec3::Z, at);
        let sunk = |t: f64| (at - DVec3::Z * if t > 0.2 { 1e-9 } else { 0.0 }, DVec3::ZERO);
        assert!(laws(&judge(&model, &track(sunk))).contains(&"penetration"));
        let still = judge(&model, &track(|_| (at, DVec3::ZERO)));
        assert!(still.is_empty(), "{still:?}");
    }

    #[test]
    fn a_body_beside_a_wall_falls_and_does_not_hang() {
        let at = DVec3::X * 0.5;
        let model = model(DVec3::X, at);
        let falls = judge(&model, &track(fall(at)));
        assert!(falls.is_empty(), "{falls:?}");
        assert!(laws(&judge(&model, &track(|_| (at, DVec3::ZERO)))).contains(&"Coulomb"));
    }

    #[test]
    fn energy_that_comes_from_nowhere_and_a_ledger_that_is_left_open_are_found() {
        let at = DVec3::Z * 0.5;
        let model = model(DVec3::Z, at);
        let moved = track(|t| (at + DVec3::X * t * t, DVec3::X * 2.0 * t));
        let found = laws(&judge(&model, &moved));
        assert!(found.contains(&"energy rises") && found.contains(&"loss below zero"), "{found:?}");
        let mut open = track(|_| (at, DVec3::ZERO));
        open.account.impact = 1e-3;
        assert!(laws(&judge(&model, &open)).contains(&"ledger"));
    }
}
