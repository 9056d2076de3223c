//! Whether a tier has what a method asks for: impact law, contact forces, response, integrator.

use super::facts::{IntegratorChoice, TierFacts, TierFeature};
use crate::scene::{ContactMethod, ImpactLaw, Integrator, Method, Response, SceneError, Tier, positive};

impl Method {
    /// Checks the numbers, and that the settings are available together.
    ///
    /// # Errors
    /// When a number is out of range, or two settings are not yet available together.
    pub fn validate(&self) -> Result<(), SceneError> {
        self.check_numbers()?;
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
            positive("method.collision_envelope", depth)?;
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
}
