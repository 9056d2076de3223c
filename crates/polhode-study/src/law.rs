//! The law by which a method lets bodies meet: its model of contact, apart from how exactly it computes that.
//!
//! A method is judged by the limit of its own law. How far that limit is from the limit of the scene's law is no error
//! of the method, and is told beside.

use crate::candidate::change;
use polhode::Plan;
use polhode::scene::{ImpactLaw, Response};
use polhode_scene::{Override, names};

/// What decides how bodies meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Law {
    impact: ImpactLaw,
    response: Response,
}

impl Law {
    /// From the plan that a run followed.
    pub const fn of(plan: &Plan) -> Self {
        Self { impact: plan.impact, response: plan.response }
    }

    /// Its name: the impact law, or what takes the place of impacts.
    pub const fn name(self) -> &'static str {
        match self.response {
            Response::Constraint => names::impact(self.impact),
            response => response.name(),
        }
    }

    /// What makes the most accurate tier compute its limit; none where only the methods of this law can.
    pub fn model(self) -> Option<Override> {
        (self.response == Response::Constraint).then(|| change("method.impact", names::impact(self.impact)))
    }
}

/// A law that is not the scene's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OtherLaw {
    /// Which.
    pub law: Law,
    /// How far its limit is from that of the scene's law, as an error is measured.
    pub difference: f64,
}
