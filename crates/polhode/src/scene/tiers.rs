//! The tiers by their names.
//!
//! What a tier is stands in its own folder, and `tier/list.rs` lists these facts; the list of their engines is in
//! `run/engines.rs`.

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

    /// The name used in scenes and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Thesis => "thesis",
            Self::MicroCollisions => "micro-collisions",
            Self::Penalty => "penalty",
            Self::Stepped => "stepped",
            Self::Fast => "fast",
            Self::Accurate => "accurate",
        }
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
    }
}
