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
//! | `piece` | shapes as unions of thickened convex cores and rings |
//! | `distance` | distance of a point from a core |
//! | `separation` | separation of two cores |
//! | `pairs` | separations of all bodies at every sample |
//! | `mass` | centre of mass and inertia |
//! | `energy` | energy and ledger |
//! | `motion` | flight, momentum, Coulomb's law, prescribed motions |

mod distance;
mod energy;
mod mass;
mod motion;
mod pairs;
mod piece;
mod separation;

use crate::random_scene::model::{Body, Model};
use glam::{DQuat, DVec3};
use mass::Weight;

pub(crate) use pairs::are_apart;

/// A body at one time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct State {
    /// Of the body's own origin, m.
    pub(crate) position: DVec3,
    pub(crate) orientation: DQuat,
    /// Of the centre of mass, m/s; of a kinematic body of its origin.
    pub(crate) velocity: DVec3,
    /// rad/s
    pub(crate) angular_velocity: DVec3,
}

/// What a run has written.
#[derive(Debug, Clone, Default)]
pub(crate) struct Track {
    /// Times of the samples, s.
    pub(crate) times: Vec<f64>,
    /// States of all bodies at these times.
    pub(crate) states: Vec<Vec<State>>,
    /// The terms of the ledger.
    pub(crate) account: Account,
}

/// The ledger of a run, J.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Account {
    pub(crate) impact: f64,
    pub(crate) friction: f64,
    pub(crate) rest: f64,
    pub(crate) damping: f64,
    pub(crate) external: f64,
    pub(crate) projection: f64,
    pub(crate) numerical: f64,
    /// Energy at the start and at the end.
    pub(crate) initial: f64,
    pub(crate) end: f64,
    /// Whether time steps have passed a stretch of crowded events.
    pub(crate) is_crowded: bool,
}

/// A law that a run has broken.
#[derive(Debug, Clone)]
pub(crate) struct Finding {
    /// Which law.
    pub(crate) law: &'static str,
    /// Where and by how much.
    pub(crate) what: String,
    /// How many times the limit.
    pub(crate) of_limit: f64,
}

/// The findings, the worst of each law.
#[derive(Debug, Default)]
pub(crate) struct Findings(Vec<Finding>);

impl Findings {
    /// Holds a magnitude against its limit.
    fn hold(&mut self, law: &'static str, amount: f64, limit: f64, what: impl FnOnce() -> String) {
        if amount <= limit {
            return;
        }
        let of_limit = amount / limit;
        let found = self.0.iter_mut().find(|finding| finding.law == law);
        match found {
            Some(finding) if finding.of_limit >= of_limit => {}
            Some(finding) => *finding = Finding { law, what: what(), of_limit },
            None => self.0.push(Finding { law, what: what(), of_limit }),
        }
    }
}

/// The scene with what is computed once.
struct Judged<'a> {
    model: &'a Model,
    weights: Vec<Weight>,
}

impl Judged<'_> {
    fn body(&self, number: usize) -> &Body {
        &self.model.bodies[number]
    }

    /// The centre of mass of a body, m.
    fn center(&self, number: usize, state: &State) -> DVec3 {
        state.position + state.orientation * self.weights[number].center
    }

    /// Its angular momentum about the centre of mass, N m s.
    fn spin(&self, number: usize, state: &State) -> DVec3 {
        let own = state.orientation.inverse() * state.angular_velocity;
        state.orientation * (self.weights[number].inertia * own)
    }
}

/// All laws that a run has broken.
pub(crate) fn judge(model: &Model, track: &Track) -> Vec<Finding> {
    let mut findings = Findings::default();
    let weights = model
        .bodies
        .iter()
        .map(|body| {
            let weight = Weight::of(&body.form);
            if let crate::random_scene::model::Role::Free(mass) = body.role { weight.of_mass(mass) } else { weight }
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
