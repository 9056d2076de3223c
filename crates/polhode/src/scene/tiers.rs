//! The list of the tiers.
//!
//! What a tier is stands in its own folder ([`TierFacts`]); the list of their engines is in `run/engines.rs`.

use crate::accurate::facts::FACTS as ACCURATE;
use crate::fast::facts::FACTS as FAST;
use crate::micro_collisions::facts::FACTS as MICRO_COLLISIONS;
use crate::penalty::facts::FACTS as PENALTY;
use crate::scene::Response;
use crate::scene::tier_facts::{TierFacts, TierFeature};
use crate::stepped::facts::FACTS as STEPPED;
use crate::thesis::facts::FACTS as THESIS;

/// A set of methods with one promise.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Tier {
    /// The algorithm of the thesis's section 3.5, unchanged: RK4 at a fixed step, propagation of impulses, linear
    /// programme of least total force. It is kept for comparison and has no limit of penetration.
    Thesis,
    /// Impulses alone, after Mirtich: contacts at rest are many small collisions within an envelope.
    MicroCollisions,
    /// Real time: substeps of soft contacts by sequential impulses. Contacts overlap a little, and its error depends on
    /// the length of the step.
    Fast,
    /// Springs and dampers where bodies overlap: they interpenetrate by a stated depth, and nothing is solved for.
    Penalty,
    /// Fixed time steps at the level of velocities, with an exact complementarity problem at each. Every step has a
    /// solution; its error depends on the length of the step.
    Stepped,
    /// Free flight in closed form, constrained motion under error control, located events, exact contact forces.
    #[default]
    Accurate,
}

impl Tier {
    /// All tiers, the most accurate first.
    pub const ALL: [Self; 6] =
        [Self::Accurate, Self::Stepped, Self::Fast, Self::Penalty, Self::MicroCollisions, Self::Thesis];

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

    /// The name used in scenes and reports.
    pub const fn name(self) -> &'static str {
        self.facts().name
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

    /// The tier of this name; none if there is no such tier.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|tier| tier.name() == name)
    }
}

#[cfg(test)]
mod tests {
    //! The list is whole: each name leads back to its tier, and no two tiers share one.
    use super::*;

    #[test]
    fn names_lead_back() {
        for tier in Tier::ALL {
            assert_eq!(Tier::from_name(tier.name()), Some(tier));
        }
        assert_eq!(Tier::from_name("another"), None);
        assert_eq!(Tier::names_with(TierFeature::Joints), "`accurate` or `stepped` or `fast` or `penalty`");
    }
}
