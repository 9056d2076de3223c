//! The springs of the tier penalty.

use crate::format::{PenaltyEntry, SpringDampingName, SpringFrictionName, SpringLawName};
use polhode::scene::{PenaltyMethod, SpringDamping, SpringFriction, SpringLaw};

/// What the file asks of springs; the numbers are checked with the rest of the method.
pub(super) fn build(entry: &PenaltyEntry) -> PenaltyMethod {
    let mut method = PenaltyMethod::default();
    method.law = entry.law.map(|law| match law {
        SpringLawName::Linear => SpringLaw::Linear,
        SpringLawName::Hertz => SpringLaw::Hertz,
    });
    method.damping = entry.damping.map(|damping| match damping {
        SpringDampingName::HuntCrossley => SpringDamping::HuntCrossley,
        SpringDampingName::Plain => SpringDamping::Plain,
    });
    method.friction = entry.friction.map(|friction| match friction {
        SpringFrictionName::Mindlin => SpringFriction::Mindlin,
        SpringFrictionName::Regularised => SpringFriction::Regularised,
    });
    method.penetration_m = entry.penetration_m;
    method.stiffness_n_m = entry.stiffness_n_m;
    method.slip_speed_m_s = entry.slip_speed_m_s;
    method
}
