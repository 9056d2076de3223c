//! The method: a tier, and settings that override its choices.
//!
//! A setting that is given is used as it is; for one that is absent the tier or the plan chooses. The enumerations here
//! have only members that are implemented, so that a scene cannot ask for others.

use super::SceneError;
use super::laws::{
    BroadPhaseMethod, ContactMethod, Coordinates, ImpactLaw, Integrator, Orientation, PropagationOrder, PulseExponent,
    Response, RotationRate,
};
use super::penalty::PenaltyMethod;
use super::promise::PromiseChanges;
use crate::scene::tier_facts::{IntegratorChoice, TierFacts, TierFeature};
use crate::scene::tiers::Tier;
use polhode_response::RestitutionLaw;

/// Most substeps of a step: beyond, a shorter step costs no more.
const MOST_SUBSTEPS: u32 = 1000;

/// What a run does at crowded events: events of an island that follow each other so closely that time hardly advances.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Crowding {
    /// It advances the island by time steps at the level of velocities until the events are fewer.
    #[default]
    Step,
    /// The run ends with an error.
    Error,
}

impl Crowding {
    /// Whether a run advances by time steps at crowded events.
    pub(crate) fn steps(self) -> bool {
        self == Self::Step
    }
}

/// What a scene asks for; `None` leaves the choice to the plan.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Method {
    /// The tier.
    pub tier: Option<Tier>,
    /// Step, s: the fixed step of `thesis` and `stepped`, the upper bound of a step of `accurate`.
    pub step_s: Option<f64>,
    /// Substeps of a step, of the tier that has them; at least 1.
    pub substeps: Option<u32>,
    /// Integrator of bodies without active contacts. Constrained motion of the tier `accurate` is integrated by DOP853,
    /// or by RK4 when that is given here.
    pub integrator: Option<Integrator>,
    /// Coordinates of orientation, for `rk4`.
    pub orientation: Option<Orientation>,
    /// Variable of rotation, for `rk4`.
    pub rotation_rate: Option<RotationRate>,
    /// Impact law.
    pub impact: Option<ImpactLaw>,
    /// Which contact [`ImpactLaw::Propagation`] strikes first; by key when absent.
    pub propagation_order: Option<PropagationOrder>,
    /// Exponent of the springs of [`ImpactLaw::Pulse`]; Hertz's when absent.
    pub pulse_exponent: Option<PulseExponent>,
    /// Law of restitution of impacts with friction.
    pub restitution_law: Option<RestitutionLaw>,
    /// Contact forces.
    pub contact: Option<ContactMethod>,
    /// How bodies that touch act on each other.
    pub response: Option<Response>,
    /// Depth of the envelope of micro-collisions, m; a thousandth of the smallest body that moves when absent.
    pub collision_envelope_m: Option<f64>,
    /// Broad phase: how pairs that may touch are found. It affects the computing time only; results are the same bits.
    pub broad_phase: Option<BroadPhaseMethod>,
    /// Error allowed under error control, relative to size and speed of each body: of each step of constrained motion,
    /// and of free motion by an integrator that controls its error. No promised limit is below it.
    pub tolerance: Option<f64>,
    /// In which coordinates bodies that joints hold are integrated.
    pub coordinates: Option<Coordinates>,
    /// Largest number of events within one step.
    pub max_events_per_step: Option<u64>,
    /// What happens at crowded events.
    pub crowding: Option<Crowding>,
    /// Error allowed within a stretch of crowded events per [`Method::step_s`], relative to the size of each body.
    pub crowding_tolerance: Option<f64>,
    /// The springs of the tier `penalty`.
    pub penalty: Option<PenaltyMethod>,
    /// Limits in place of those that the tier promises.
    pub promise: PromiseChanges,
}

impl Method {
    /// The tier that the scene names, or that its response names; none where the plan chooses.
    pub fn named_tier(&self) -> Option<Tier> {
        self.tier.or_else(|| self.response.and_then(Tier::of_response))
    }

    /// The first setting given that only the default tier has; none where no such setting is given.
    pub(crate) fn first_of_default_tier(&self) -> Option<&'static str> {
        let given = [
            (self.tolerance.is_some(), "method.tolerance"),
            (self.integrator.is_some(), "method.integrator"),
            (self.orientation.is_some(), "method.orientation"),
            (self.rotation_rate.is_some(), "method.rotation_rate"),
            (self.coordinates == Some(Coordinates::Reduced), "method.coordinates"),
            (self.contact.is_some(), "method.contact"),
            (self.substeps.is_some(), "method.substeps"),
            (self.response.is_some(), "method.response"),
            (self.crowding.is_some(), "method.crowding"),
            (self.crowding_tolerance.is_some(), "method.crowding_tolerance"),
        ];
        given.into_iter().find(|(is_given, _)| *is_given).map(|(_, key)| key)
    }

    /// Checks knobs of impact laws.
    fn check_impact(&self, tier: &TierFacts) -> Result<(), SceneError> {
        let of_law = [
            (self.propagation_order.is_some(), "propagation_order", ImpactLaw::Propagation),
            (self.pulse_exponent.is_some(), "pulse_exponent", ImpactLaw::Pulse),
        ];
        for (is_given, key, law) in of_law {
            if is_given && self.impact.unwrap_or(tier.impact) != law {
                let other = self.impact.unwrap_or(tier.impact).name();
                let what = format!("{key} with impact = \"{other}\"");
                let instead = format!("impact = \"{}\" beside it, or no {key}", law.name());
                return Err(SceneError::NotYetAvailable { what, instead });
            }
        }
        Ok(())
    }

    /// Checks that the tier has the method of contact forces, and its knobs.
    fn check_contact(&self, tier: &TierFacts) -> Result<(), SceneError> {
        let refuse = |what: String, instead: String| Err(SceneError::NotYetAvailable { what, instead });
        let is_taken = |contact: ContactMethod| match contact {
            ContactMethod::SequentialImpulses | ContactMethod::ConjugateGradients => {
                tier.takes(TierFeature::SequentialImpulses)
            }
            ContactMethod::ActiveSet => !tier.takes(TierFeature::SequentialImpulses),
            _ => tier.takes(TierFeature::LeastForce),
        };
        if let Some(contact) = self.contact.filter(|&contact| !is_taken(contact)) {
            let what = format!("contact = \"{}\" with tier = \"{}\"", contact.name(), tier.name);
            let instead = match contact {
                ContactMethod::SequentialImpulses | ContactMethod::ConjugateGradients => {
                    format!("contact = \"active-set\", or tier {}", Tier::names_with(TierFeature::SequentialImpulses))
                }
                ContactMethod::ActiveSet => format!("contact = \"{}\"", tier.contact.name()),
                _ => format!(
                    "contact = \"{}\", or tier {}",
                    tier.contact.name(),
                    Tier::names_with(TierFeature::LeastForce)
                ),
            };
            return refuse(what, instead);
        }
        if self.substeps.is_some() && !tier.takes(TierFeature::SequentialImpulses) {
            let instead = format!("tier {}", Tier::names_with(TierFeature::SequentialImpulses));
            return refuse(format!("substeps with tier = \"{}\"", tier.name), instead);
        }
        Ok(())
    }

    /// Checks that the tier has the response, and knobs only of its own response.
    fn check_response(&self, tier: &TierFacts) -> Result<(), SceneError> {
        let refuse = |what: String, instead: String| Err(SceneError::NotYetAvailable { what, instead });
        let given = self.response.unwrap_or(tier.own_response.unwrap_or_default());
        let own = Tier::of_response(given);
        let is_taken = match (tier.own_response, own) {
            (Some(expected), _) => given == expected,
            (None, _) => {
                given == Response::Constraint || (given.is_by_impulses() && tier.takes(TierFeature::Responses))
            }
        };
        if !is_taken {
            let what = format!("response = \"{}\" with tier = \"{}\"", given.name(), tier.name);
            let instead = match (tier.own_response, own) {
                (Some(expected), _) => format!("response = \"{}\", or another tier", expected.name()),
                (None, Some(own)) => format!("tier = \"{}\", or no tier", own.name()),
                _ => format!("response = \"constraint\", or tier {}", Tier::names_with(TierFeature::Responses)),
            };
            return refuse(what, instead);
        }
        if let Some(depth) = self.collision_envelope_m {
            super::error::positive("method.collision_envelope", depth)?;
            if tier.own_response != Some(Response::Impulse) {
                let what = format!("collision_envelope with tier = \"{}\"", tier.name);
                let instead = "tier = \"micro-collisions\" beside it, or no collision_envelope".to_owned();
                return refuse(what, instead);
            }
        }
        let Some(penalty) = &self.penalty else { return Ok(()) };
        if given != Response::Penalty {
            let what = format!("method.penalty with response = \"{}\"", given.name());
            return refuse(what, "response = \"penalty\"".to_owned());
        }
        penalty.validate()
    }

    /// Checks the numbers, and that the settings are available together.
    ///
    /// # Errors
    /// When a number is out of range, or two settings are not yet available together.
    pub fn validate(&self) -> Result<(), SceneError> {
        if let Some(step) = self.step_s {
            super::error::positive("method.step", step)?;
        }
        if let Some(substeps) = self.substeps.filter(|substeps| !(1..=MOST_SUBSTEPS).contains(substeps)) {
            let accepted = "a whole number from 1 to 1000";
            return Err(SceneError::Number { key: "method.substeps", value: f64::from(substeps), accepted });
        }
        self.promise.validate()?;
        if let Some(tolerance) = self.crowding_tolerance {
            super::error::positive("method.crowding_tolerance", tolerance)?;
        }
        if let Some(tolerance) = self.tolerance {
            super::error::positive("method.tolerance", tolerance)?;
            if tolerance > 0.1 {
                return Err(SceneError::Number {
                    key: "method.tolerance",
                    value: tolerance,
                    accepted: "a number in (0, 0.1]",
                });
            }
        }
        if let Some(RestitutionLaw::ChatterjeeRuina { tangential_restitution: value }) = self.restitution_law
            && !(-1.0..=1.0).contains(&value)
        {
            let (key, accepted) = ("method.tangential_restitution", "a number in [-1, 1]");
            return Err(SceneError::Number { key, value, accepted });
        }
        let refuse = |what: &str, instead: &str| {
            Err(SceneError::NotYetAvailable { what: what.to_owned(), instead: instead.to_owned() })
        };
        let tier = self.named_tier().unwrap_or_default().facts();
        self.check_impact(tier)?;
        self.check_contact(tier)?;
        self.check_response(tier)?;
        if let (IntegratorChoice::Tier { instead, .. }, Some(integrator)) = (tier.integrator_choice, self.integrator) {
            return refuse(&format!("integrator = \"{}\" with tier = \"{}\"", integrator.name(), tier.name), instead);
        }
        let representation = self.orientation.is_some() || self.rotation_rate.is_some();
        let rk4 = self.integrator.unwrap_or(tier.integrator) == Integrator::Rk4;
        if representation && !rk4 {
            return refuse("orientation or rotation_rate without integrator = \"rk4\"", "integrator = \"rk4\"");
        }
        Ok(())
    }
}
