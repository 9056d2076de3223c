//! What is judged, and what is found: the states and the ledger of a run, the scene with its weights, broken laws.

use super::mass::Weight;
use crate::random_scene::model::{Body, Model};
use glam::{DQuat, DVec3};

/// A body at one time.
#[derive(Debug, Clone, Copy)]
pub struct State {
    /// Of the body's own origin, m.
    pub position: DVec3,
    /// From the body to the world.
    pub orientation: DQuat,
    /// Of the centre of mass, m/s; of a kinematic body of its origin.
    pub velocity: DVec3,
    /// rad/s
    pub angular_velocity: DVec3,
}

/// What a run has written.
#[derive(Debug, Clone, Default)]
pub struct Track {
    /// Times of the samples, s.
    pub times: Vec<f64>,
    /// States of all bodies at these times.
    pub states: Vec<Vec<State>>,
    /// The terms of the ledger.
    pub account: Account,
}

/// The ledger of a run, J.
#[derive(Debug, Clone, Copy, Default)]
pub struct Account {
    /// Lost by impacts.
    pub impact: f64,
    /// Lost by friction.
    pub friction: f64,
    /// Lost by coming to rest.
    pub rest: f64,
    /// Lost by damping.
    pub damping: f64,
    /// Work from outside.
    pub external: f64,
    /// Taken by projections.
    pub projection: f64,
    /// Lost by the method.
    pub numerical: f64,
    /// Energy at the start.
    pub initial: f64,
    /// Energy at the end.
    pub end: f64,
    /// Whether time steps have passed a stretch of crowded events.
    pub is_crowded: bool,
    /// When the run first told that its laws allow several motions, of which it took one.
    pub first_choice_s: Option<f64>,
}

/// A law that a run has broken.
#[derive(Debug, Clone)]
pub struct Finding {
    /// Which law.
    pub law: &'static str,
    /// Where and by how much.
    pub what: String,
    /// How many times the limit.
    pub of_limit: f64,
}

/// The findings, the worst of each law.
#[derive(Debug, Default)]
pub struct Findings(pub(super) Vec<Finding>);

impl Findings {
    /// Holds a magnitude against its limit.
    pub(super) fn hold(&mut self, law: &'static str, amount: f64, limit: f64, what: impl FnOnce() -> String) {
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
pub(super) struct Judged<'a> {
    pub(super) model: &'a Model,
    pub(super) weights: Vec<Weight>,
}

impl Judged<'_> {
    pub(super) fn body(&self, number: usize) -> &Body {
        &self.model.bodies[number]
    }

    /// The centre of mass of a body, m.
    pub(super) fn center(&self, number: usize, state: &State) -> DVec3 {
        state.position + state.orientation * self.weights[number].center
    }

    /// Its angular momentum about the centre of mass, N m s.
    pub(super) fn spin(&self, number: usize, state: &State) -> DVec3 {
        let own = state.orientation.inverse() * state.angular_velocity;
        state.orientation * (self.weights[number].inertia * own)
    }
}
