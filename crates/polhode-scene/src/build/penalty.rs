//! The springs of the tier penalty.

use crate::format::{PenaltyEntry, SpringDampingName, SpringFrictionName, SpringLawName};
use polhode::scene::{PenaltyMethod, SpringDamping, SpringFriction, SpringLaw};

/// What the file asks of springs; the numbers are checked with the rest of the method.
pub(super) fn build(entry: &PenaltyEntry) -> PenaltyMethod {
    let law = |law| match law {
        SpringLawName::Linear => SpringLaw::Linear,
        SpringLawName::Hertz => SpringLaw::Hertz,
    };
    let damping = |damping| match damping {
        SpringDampingName::HuntCrossley => SpringDamping::HuntCrossley,
        SpringDampingName::Plain => SpringDamping::Plain,
    };
    let friction = |friction| match friction {
        SpringFrictionName::Mindlin => SpringFriction::Mindlin,
        SpringFrictionName::Regularised => SpringFriction::Regularised,
    };
    PenaltyMethod {
        law: entry.law.map(law),
        damping: entry.damping.map(damping),
        friction: entry.friction.map(friction),
        penetration_m: entry.penetration_m,
        stiffness_n_m: entry.stiffness_n_m,
        slip_speed_m_s: entry.slip_speed_m_s,
    }
}
