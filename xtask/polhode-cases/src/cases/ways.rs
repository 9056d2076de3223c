//! Every way in which bodies act on each other where they touch, and how exactly each claims to do it.
//!
//! A case gives its scene a way and compares what it finds with one reference; what a way answers by its own law
//! (several contacts struck at once) is the case's, how exactly it answers is the way's.

use super::run::Run;
use crate::row::Row;
use polhode::response::impact::PulseExponent;
use polhode::scene::{ContactMethod, ImpactLaw, Method, PenaltyMethod, SceneBuilder, Tier};
use polhode::{Effects, Scene};
use std::error::Error;

/// Step of the ways of fixed steps, s.
pub(super) const STEP_S: f64 = 1e-4;
/// Penetration that springs are to keep, m, beside bodies of some 1 m.
pub(super) const DEPTH_M: f64 = 1e-6;
/// The same of bodies that rest, m.
pub(super) const REST_DEPTH_M: f64 = 1e-3;
/// Tolerance of the steps on springs.
const SPRING_TOLERANCE: f64 = 1e-9;

/// A way of contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Way {
    /// The tier accurate with an impact law.
    Law(ImpactLaw, PulseExponent),
    /// A tier with what it does when nothing else is named.
    Of(Tier),
    /// The tier thesis with a method of contact forces.
    Forces(ContactMethod),
}

/// Impact laws.
pub(super) const LAWS: [Way; 7] = [
    Way::Law(ImpactLaw::Propagation, PulseExponent::Hertz),
    Way::Law(ImpactLaw::Simultaneous, PulseExponent::Hertz),
    Way::Law(ImpactLaw::Reflection, PulseExponent::Hertz),
    Way::Law(ImpactLaw::Poisson, PulseExponent::Hertz),
    Way::Law(ImpactLaw::Energetic, PulseExponent::Hertz),
    Way::Law(ImpactLaw::Pulse, PulseExponent::Linear),
    Way::Law(ImpactLaw::Pulse, PulseExponent::Hertz),
];

/// Tiers.
pub(super) const TIERS: [Way; 5] = [
    Way::Of(Tier::Stepped),
    Way::Of(Tier::MicroCollisions),
    Way::Of(Tier::Penalty),
    Way::Of(Tier::Fast),
    Way::Of(Tier::Thesis),
];

/// Methods of contact forces at rest.
pub(super) const FORCES: [Way; 3] = [
    Way::Forces(ContactMethod::LeastForce),
    Way::Forces(ContactMethod::Heuristic),
    Way::Forces(ContactMethod::Guesses),
];

impl Way {
    /// In words.
    pub(super) fn name(self) -> String {
        match self {
            Self::Law(ImpactLaw::Pulse, PulseExponent::Linear) => "pulse, linear".to_owned(),
            Self::Law(law, _) => law.name().to_owned(),
            Self::Of(tier) => format!("tier {}", tier.name()),
            Self::Forces(contact) => contact.name().to_owned(),
        }
    }

    /// The method of a scene.
    pub(super) fn method(self) -> Method {
        let plain = Method::default();
        match self {
            Self::Law(ImpactLaw::Pulse, exponent) => {
                Method { impact: Some(ImpactLaw::Pulse), pulse_exponent: Some(exponent), ..plain }
            }
            Self::Law(law, _) => Method { impact: Some(law), ..plain },
            Self::Of(Tier::Penalty) => Method {
                tier: Some(Tier::Penalty),
                tolerance: Some(SPRING_TOLERANCE),
                penalty: Some(PenaltyMethod { penetration_m: Some(DEPTH_M), ..PenaltyMethod::default() }),
                ..plain
            },
            Self::Of(tier) => Method { tier: Some(tier), step_s: Some(STEP_S), ..plain },
            Self::Forces(contact) => {
                Method { tier: Some(Tier::Thesis), contact: Some(contact), step_s: Some(STEP_S), ..plain }
            }
        }
    }

    /// A scene of bodies at rest by this way: springs give way by [`REST_DEPTH_M`].
    pub(super) fn at_rest(self, scene: Scene) -> Scene {
        let mut method = self.method();
        if let Some(penalty) = &mut method.penalty {
            penalty.penetration_m = Some(REST_DEPTH_M);
        }
        scene.with_method(method)
    }

    /// The scene by this way.
    ///
    /// # Errors
    /// When it is refused.
    pub(super) fn scene(self, builder: SceneBuilder) -> Result<Scene, Box<dyn Error>> {
        Ok(builder.method(self.method()).build()?)
    }

    /// Runs a scene by this way.
    ///
    /// # Errors
    /// When it is refused or does not run.
    pub(super) fn run(self, builder: SceneBuilder) -> Result<Run, Box<dyn Error>> {
        Run::of(&self.scene(builder)?, Effects::Planned)
    }
}

/// How exactly the ways claim to do something.
#[derive(Debug, Clone, Copy)]
pub(super) struct Claims {
    /// Of ways that find impacts in time and solve their law.
    pub(super) exact: f64,
    /// Of springs of the pulse, integrated to estimated errors of 1e-12, where several contacts are struck.
    pub(super) pulse: f64,
    /// Of micro-collisions, in time to a step.
    pub(super) micro: f64,
    /// Of springs that give way by [`DEPTH_M`].
    pub(super) springs: f64,
    /// Of impulses that are found by sweeps, in time to a step.
    pub(super) fast: f64,
    /// Of the thesis's step.
    pub(super) thesis: f64,
}

impl Claims {
    /// That of a way.
    pub(super) fn of(&self, way: Way) -> f64 {
        match way {
            Way::Law(ImpactLaw::Pulse, _) => self.pulse,
            Way::Law(..) | Way::Of(Tier::Accurate | Tier::Stepped) => self.exact,
            Way::Of(Tier::MicroCollisions) => self.micro,
            Way::Of(Tier::Penalty) => self.springs,
            Way::Of(Tier::Fast) => self.fast,
            Way::Of(_) | Way::Forces(_) => self.thesis,
        }
    }
}

/// Numbers found by a way against those that it should find: the largest difference, of 1 or the largest number.
pub(super) fn compared(
    case: &str,
    quantity: &str,
    (way, claims): (Way, &Claims),
    found: Result<Vec<f64>, Box<dyn Error>>,
    expected: &[f64],
) -> Row {
    let quantity = format!("{quantity}: {}: largest error", way.name());
    match found {
        Err(error) => Row::broken(case, &quantity, error.to_string()),
        Ok(found) => {
            let size = expected.iter().fold(1.0, |most: f64, value| most.max(value.abs()));
            let pairs = found.iter().zip(expected);
            let error = pairs.map(|(found, expected)| (found - expected).abs() / size).fold(0.0, larger);
            let error = if found.len() == expected.len() { error } else { f64::INFINITY };
            let row = Row::at_most(case, &quantity, claims.of(way), error);
            Row { note: Some(format!("{found:.12?}")), ..row }
        }
    }
}

/// The larger of two numbers; NaN when one is.
pub(super) fn larger(x: f64, y: f64) -> f64 {
    if x.is_nan() || y.is_nan() { f64::NAN } else { x.max(y) }
}
