//! Words for the members of the engine's enums, as the scene format writes them.

use polhode::scene::{ContactMethod, ImpactLaw, Integrator, Orientation, RotationRate, Tier};
use polhode::{Decision, Outcome};

/// The word for a tier.
pub const fn tier(tier: Tier) -> &'static str {
    tier.name()
}

/// The word for an integrator.
pub const fn integrator(integrator: Integrator) -> &'static str {
    integrator.name()
}

/// The word for coordinates of orientation.
pub const fn orientation(orientation: Orientation) -> &'static str {
    match orientation {
        Orientation::Quaternion => "quaternion",
        Orientation::QuaternionUnnormalized => "quaternion-unnormalized",
        Orientation::QuaternionThreeNumbers => "quaternion-three-numbers",
        Orientation::Matrix => "matrix",
        Orientation::MatrixUnorthogonalized => "matrix-unorthogonalized",
        Orientation::EulerAngles => "euler-angles",
    }
}

/// The word for a variable of rotation.
pub const fn rotation_rate(variable: RotationRate) -> &'static str {
    match variable {
        RotationRate::AngularMomentum => "angular-momentum",
        RotationRate::AngularVelocity => "angular-velocity",
    }
}

/// The word for an impact law.
pub const fn impact(law: ImpactLaw) -> &'static str {
    law.name()
}

/// The word for a method of contact forces.
pub const fn contact(method: ContactMethod) -> &'static str {
    method.name()
}

/// `on` or `off`.
pub const fn decision(decision: Decision) -> &'static str {
    match decision {
        Decision::On => "on",
        Decision::Off => "off",
    }
}

/// How a run ended.
pub const fn outcome(outcome: Outcome) -> &'static str {
    outcome.name()
}
