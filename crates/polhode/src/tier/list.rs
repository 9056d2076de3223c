//! The list of what the tiers are.
//!
//! What a tier is stands in its own folder ([`TierFacts`]). A scene names a tier ([`Tier`]) and knows none of this.

use super::facts::{TierFacts, TierFeature};
use crate::accurate::facts::FACTS as ACCURATE;
use crate::fast::facts::FACTS as FAST;
use crate::micro_collisions::facts::FACTS as MICRO_COLLISIONS;
use crate::penalty::facts::FACTS as PENALTY;
use crate::scene::{Method, Response, Tier};
use crate::stepped::facts::FACTS as STEPPED;
use crate::thesis::facts::FACTS as THESIS;

impl Tier {
    /// What the tier is.
    pub const fn facts(self) -> &'static TierFacts {
        match self {
            Self::Thesis => &THESIS,
            Self::MicroCollisions => &MICRO_COLLISIONS,
            Self::Penalty => &PENALTY,
            Self::Stepped => &STEPPED,
            Self::Fast => &FAST,
            Self::Accurate => &ACCURATE,
        }
    }

    /// The names of the tiers that take this, for a message: `accurate` or `stepped` or `fast`.
    pub(crate) fn names_with(feature: TierFeature) -> String {
        let takes = |tier: &Self| tier.facts().takes(feature);
        let names = Self::ALL.into_iter().filter(takes).map(|tier| format!("`{}`", tier.name()));
        names.collect::<Vec<_>>().join(" or ")
    }

    /// The tier that alone has this response, and that a scene which names the response means; none where several have
    /// it.
    pub(crate) fn of_response(response: Response) -> Option<Self> {
        Self::ALL.into_iter().find(|tier| tier.facts().own_response == Some(response))
    }
}

impl Method {
    /// The tier that the scene names, or that its response names; none where the plan chooses.
    pub fn named_tier(&self) -> Option<Tier> {
        self.tier.or_else(|| self.response.and_then(Tier::of_response))
    }
}

#[cfg(test)]
mod tests {
    //! The list is whole: the facts of each tier have its name, and a message names those that take a feature.
    use super::*;

    #[test]
    fn facts_are_those_of_their_tier() {
        for tier in Tier::ALL {
            assert_eq!(tier.facts().name, tier.name());
        }
        assert_eq!(Tier::names_with(TierFeature::Joints), "`accurate` or `stepped` or `fast` or `penalty`");
    }
}
