//! Whether a structure stands: a run of ten seconds, ended early where its end is certain.
//!
//! A structure falls if its bodies accelerate from rest: nothing can hold them later that does not hold them at the
//! start. Its fall is run until it shows where the case asks for that.

use crate::cases::run::movement_m;
use polhode::{Acceleration, BodySample, ErrorEstimation, Scene, Simulation};

/// How long a structure has to stand, s.
const DURATION_S: f64 = 10.0;

/// A structure falls once a body is displaced farther than this, m: far above rounding (1e-15), and what the least fall
/// of an unbalanced structure exceeds within a second.
const DISPLACED_M: f64 = 1e-6;

/// Bodies that accelerate by more than this from rest fall, m/s^2 or rad/s^2: above the rounding of equilibrium
/// (1e-12), below what a shortfall at the margin of the programme gives (1e-5).
const ACCELERATES: f64 = 1e-9;

/// How far a fall is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Until {
    /// Until bodies accelerate.
    Acceleration,
    /// Until a body is displaced.
    Displacement,
}

/// A run of more steps is given up. A structure that stands is at rest after the first step, and one that falls has
/// moved after some tens of steps, unless its events crowd.
const MOST_STEPS: usize = 200;

/// What became of a structure.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Fate {
    /// All bodies are at rest, in certified equilibrium.
    Rests,
    /// It moved by less than the limit.
    Stands,
    /// It moved, by this time, s.
    Falls(f64),
    /// The run was given up at this time, s: its bodies move, and none has moved by the limit.
    Open(f64),
    /// The run ended with an error.
    Fails(String),
}

impl Fate {
    /// Whether it stood.
    pub(super) fn stands(&self) -> bool {
        matches!(self, Self::Rests | Self::Stands)
    }
}

/// Runs a structure.
pub(super) fn fate(scene: &Scene, until: Until) -> Fate {
    run(scene, until).unwrap_or_else(|error| Fate::Fails(error.to_string()))
}

fn run(scene: &Scene, until: Until) -> Result<Fate, polhode::SimulationError> {
    let mut simulation = Simulation::new(scene)?.estimating(ErrorEstimation::Off);
    if until == Until::Acceleration {
        let accelerations = simulation.accelerations()?;
        let accelerates = |a: &Acceleration| a.linear.length().max(a.angular.length()) > ACCELERATES;
        if accelerations.iter().any(accelerates) {
            return Ok(Fate::Falls(0.0));
        }
    }
    let start = simulation.bodies();
    for _ in 0..MOST_STEPS {
        let t_s = simulation.step()?.t_s;
        let now = simulation.bodies();
        if movement_m(scene, &start, &now) > DISPLACED_M {
            return Ok(Fate::Falls(t_s));
        }
        let is_still = |body: &BodySample| body.velocity.linear.length() + body.velocity.angular.length() == 0.0;
        // Exactly zero only where the bodies have been put to rest.
        if now.iter().all(is_still) {
            return Ok(Fate::Rests);
        }
        if t_s >= DURATION_S {
            return Ok(Fate::Stands);
        }
    }
    Ok(Fate::Open(simulation.time()))
}
