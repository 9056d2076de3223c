//! Words for the members of the engine's enums, as the scene format writes them.

use polhode::Decision;
use polhode::scene::{ContactMethod, ImpactLaw, Integrator, Tier};

/// The word for a tier.
pub const fn tier(tier: Tier) -> &'static str {
    match tier {
        Tier::Thesis => "thesis",
        Tier::Accurate => "accurate",
    }
}

/// The word for an integrator.
pub const fn integrator(integrator: Integrator) -> &'static str {
    match integrator {
        Integrator::Rk4 => "rk4",
        Integrator::Exact => "exact",
    }
}

/// The word for an impact law.
pub const fn impact(law: ImpactLaw) -> &'static str {
    match law {
        ImpactLaw::Propagation => "propagation",
        ImpactLaw::Simultaneous => "simultaneous",
        ImpactLaw::Reflection => "reflection",
    }
}

/// The word for a method of contact forces.
pub const fn contact(method: ContactMethod) -> &'static str {
    match method {
        ContactMethod::LeastForce => "least-force",
        ContactMethod::ActiveSet => "active-set",
    }
}

/// `on` or `off`.
pub const fn decision(decision: Decision) -> &'static str {
    match decision {
        Decision::On => "on",
        Decision::Off => "off",
    }
}
