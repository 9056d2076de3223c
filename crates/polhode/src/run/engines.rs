//! The engines of the tiers: begun from a scene, and restored from a snapshot.

use crate::accurate::Engine;
use crate::error::SimulationError;
use crate::fast::FastEngine;
use crate::micro_collisions::MicroCollisionEngine;
use crate::penalty::PenaltyEngine;
use crate::scene::tiers::Tier as TierName;
use crate::snapshot::{SnapshotError, content};
use crate::stepped::SteppedEngine;
use crate::thesis::ThesisEngine;
use crate::tier::Tier;
use crate::tier::core::Core;
use polhode_dynamics::BodyState;

/// The engine of the tier of the settings, which begins at these states.
///
/// # Errors
/// When contacts or forces of the first instant cannot be found.
pub(crate) fn begun(core: &mut Core, states: Vec<BodyState>) -> Result<Box<dyn Tier>, SimulationError> {
    Ok(match core.settings.tier {
        TierName::Accurate => Box::new(Engine::new(core, states)?),
        TierName::Stepped => Box::new(SteppedEngine::new(core, states)?),
        TierName::Fast => Box::new(FastEngine::new(core, states)),
        TierName::Thesis => Box::new(ThesisEngine::new(core, states)?),
        TierName::MicroCollisions => Box::new(MicroCollisionEngine::new(core, states)),
        TierName::Penalty => Box::new(PenaltyEngine::new(core, states)),
    })
}

/// The engine that continues from a snapshot.
///
/// # Errors
/// When the snapshot is of another tier or contradicts itself.
pub(crate) fn restored(core: &mut Core, saved: &content::Tier) -> Result<Box<dyn Tier>, SimulationError> {
    if !core.t.is_finite() {
        return Err(SnapshotError::Invalid("its time is not finite").into());
    }
    match (core.settings.tier, saved) {
        (TierName::Accurate, content::Tier::Accurate(saved)) => Ok(Box::new(Engine::restored(core, saved)?)),
        (TierName::Stepped, content::Tier::Stepped(saved)) => Ok(Box::new(SteppedEngine::restored(core, saved)?)),
        (TierName::Fast, content::Tier::Fast(saved)) => Ok(Box::new(FastEngine::restored(core, saved)?)),
        (TierName::Thesis, content::Tier::Thesis(saved)) => Ok(Box::new(ThesisEngine::restored(core, saved)?)),
        (TierName::MicroCollisions, content::Tier::MicroCollisions(saved)) => {
            Ok(Box::new(MicroCollisionEngine::restored(core, saved)?))
        }
        (TierName::Penalty, content::Tier::Penalty(saved)) => Ok(Box::new(PenaltyEngine::restored(core, saved)?)),
        _ => Err(SnapshotError::Invalid("its tier is not that of its scene").into()),
    }
}
