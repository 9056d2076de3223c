//! Tier and knobs.

use super::fault::{Fault, positive};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::{
    BroadPhaseName, ContactName, CoordinatesName, CrowdingName, ErrorEstimationName, ImpactName, IntegratorName,
    MethodEntry, OrientationName, PromiseEntry, PropagationOrderName, PulseExponentName, ResponseName,
    RestitutionLawName, RotationRateName, TierName,
};
use polhode::scene::{
    ContactMethod, Coordinates, Crowding, ImpactLaw, Method, Orientation, PromiseChanges, PropagationOrder,
    PulseExponent, Response, RestitutionLaw, RotationRate,
};
use polhode::tier::{IntegratorChoice, TierFeature};
use polhode::{ErrorEstimation, SceneError};

/// The method that the file asks for, with these limits.
pub(super) fn build(entry: &MethodEntry, promise: &PromiseEntry) -> Result<Method, Fault> {
    let path = KeyPath::of(&["method"]);
    let step_s = entry.step.map(|step| positive(step, &path.key("step"))).transpose()?;
    let tolerance = entry.tolerance.map(|tolerance| positive(tolerance, &path.key("tolerance"))).transpose()?;
    let crowding_tolerance = entry.crowding_tolerance;
    let crowding_tolerance =
        crowding_tolerance.map(|tolerance| positive(tolerance, &path.key("crowding_tolerance"))).transpose()?;
    if entry.max_events_per_step == Some(0) {
        return Err((path.key("max_events_per_step"), Refusal::Number { value: 0.0, accepted: "at least 1" }));
    }
    let method = Method {
        tier: entry.tier.map(|TierName(tier)| tier),
        step_s,
        substeps: entry.substeps,
        integrator: entry.integrator.map(|IntegratorName(integrator)| integrator),
        orientation: entry.orientation.map(orientation),
        rotation_rate: entry.rotation_rate.map(rotation_rate),
        impact: entry.impact.map(impact),
        propagation_order: entry.propagation_order.map(propagation_order),
        pulse_exponent: entry.pulse_exponent.map(pulse_exponent),
        restitution_law: restitution_law(entry)?,
        contact: entry.contact.map(contact),
        response: entry.response.map(response),
        collision_envelope_m: entry.collision_envelope,
        broad_phase: entry.broad_phase.map(|BroadPhaseName(broad_phase)| broad_phase),
        tolerance,
        coordinates: entry.coordinates.map(coordinates),
        max_events_per_step: entry.max_events_per_step,
        crowding: entry.crowding.map(crowding),
        crowding_tolerance,
        error: entry.error.map(error_estimation),
        penalty: entry.penalty.as_ref().map(super::penalty::build),
        promise: limits(promise),
    };
    method.validate().map_err(|error| (path_of(&error, entry), error.into()))?;
    Ok(method)
}

/// The limits that the file sets.
const fn limits(entry: &PromiseEntry) -> PromiseChanges {
    let &PromiseEntry { overlap, joint_gap, energy, residual, friction, loads, error } = entry;
    PromiseChanges { overlap, joint_gap, energy, residual, friction, loads, error }
}

/// The key that an error of the method is about.
fn path_of(error: &SceneError, entry: &MethodEntry) -> KeyPath {
    let path = KeyPath::of(&["method"]);
    let named = Method {
        tier: entry.tier.map(|TierName(tier)| tier),
        response: entry.response.map(response),
        ..Method::default()
    };
    let tier = named.named_tier().unwrap_or_default().facts();
    match error {
        SceneError::Number { key, .. } => KeyPath::of(&key.split('.').collect::<Vec<_>>()),
        SceneError::PenaltyKnob { key, .. } => path.key("penalty").key(*key),
        _ if entry.penalty.is_some() && tier.own_response != Some(Response::Penalty) => path.key("penalty"),
        _ if entry.response.is_some() && entry.tier.is_some() && tier.own_response.is_some() => path.key("response"),
        // Knobs that do not go together: the one that is not the tier or the integrator.
        SceneError::NotYetAvailable { what, .. } if what.starts_with("propagation_order") => {
            path.key("propagation_order")
        }
        SceneError::NotYetAvailable { what, .. } if what.starts_with("pulse_exponent") => path.key("pulse_exponent"),
        _ if !matches!(entry.contact, None | Some(ContactName::ActiveSet)) && !tier.takes(TierFeature::LeastForce) => {
            path.key("contact")
        }
        SceneError::NotYetAvailable { what, .. } if what.starts_with("collision_envelope") => {
            path.key("collision_envelope")
        }
        SceneError::NotYetAvailable { what, .. } if what.starts_with("response") => path.key("response"),
        _ if !tier.takes(TierFeature::Responses)
            && !matches!(entry.response, None | Some(ResponseName::Constraint)) =>
        {
            path.key("response")
        }
        _ if entry.substeps.is_some() && !tier.takes(TierFeature::SequentialImpulses) => path.key("substeps"),
        _ if entry.contact.is_some()
            && matches!(entry.contact, Some(ContactName::SequentialImpulses | ContactName::Nncg))
                != tier.takes(TierFeature::SequentialImpulses) =>
        {
            path.key("contact")
        }
        _ if entry.integrator.is_some() && matches!(tier.integrator_choice, IntegratorChoice::Tier { .. }) => {
            path.key("integrator")
        }
        _ if entry.orientation.is_some() => path.key("orientation"),
        _ if entry.rotation_rate.is_some() => path.key("rotation_rate"),
        _ => path,
    }
}

const fn orientation(name: OrientationName) -> Orientation {
    match name {
        OrientationName::Quaternion => Orientation::Quaternion,
        OrientationName::QuaternionUnnormalized => Orientation::QuaternionUnnormalized,
        OrientationName::QuaternionThreeNumbers => Orientation::QuaternionThreeNumbers,
        OrientationName::Matrix => Orientation::Matrix,
        OrientationName::MatrixUnorthogonalized => Orientation::MatrixUnorthogonalized,
        OrientationName::EulerAngles => Orientation::EulerAngles,
    }
}

const fn rotation_rate(name: RotationRateName) -> RotationRate {
    match name {
        RotationRateName::AngularMomentum => RotationRate::AngularMomentum,
        RotationRateName::AngularVelocity => RotationRate::AngularVelocity,
    }
}

const fn impact(name: ImpactName) -> ImpactLaw {
    match name {
        ImpactName::Propagation => ImpactLaw::Propagation,
        ImpactName::Simultaneous => ImpactLaw::Simultaneous,
        ImpactName::Reflection => ImpactLaw::Reflection,
        ImpactName::Poisson => ImpactLaw::Poisson,
        ImpactName::Energetic => ImpactLaw::Energetic,
        ImpactName::Pulse => ImpactLaw::Pulse,
    }
}

const fn propagation_order(name: PropagationOrderName) -> PropagationOrder {
    match name {
        PropagationOrderName::Key => PropagationOrder::Key,
        PropagationOrderName::Depth => PropagationOrder::Depth,
        PropagationOrderName::Random(seed) => PropagationOrder::Random { seed },
    }
}

const fn pulse_exponent(name: PulseExponentName) -> PulseExponent {
    match name {
        PulseExponentName::Linear => PulseExponent::Linear,
        PulseExponentName::Hertz => PulseExponent::Hertz,
    }
}

/// The law of restitution, with the number that one of them takes.
fn restitution_law(entry: &MethodEntry) -> Result<Option<RestitutionLaw>, Fault> {
    let law = entry.restitution_law;
    if entry.tangential_restitution.is_some() && law != Some(RestitutionLawName::ChatterjeeRuina) {
        let found = law.map_or("no restitution_law", |_| "another restitution_law").to_owned();
        let accepted = "restitution_law = \"chatterjee-ruina\" beside tangential_restitution".to_owned();
        return Err((KeyPath::of(&["method", "tangential_restitution"]), Refusal::Type { found, accepted }));
    }
    Ok(law.map(|law| match law {
        RestitutionLawName::Stronge => RestitutionLaw::Stronge,
        RestitutionLawName::Poisson => RestitutionLaw::Poisson,
        RestitutionLawName::Newton => RestitutionLaw::Newton,
        RestitutionLawName::Whittaker => RestitutionLaw::Whittaker,
        RestitutionLawName::ChatterjeeRuina => {
            RestitutionLaw::ChatterjeeRuina { tangential_restitution: entry.tangential_restitution.unwrap_or(0.0) }
        }
    }))
}

const fn response(name: ResponseName) -> Response {
    match name {
        ResponseName::Constraint => Response::Constraint,
        ResponseName::Impulse => Response::Impulse,
        ResponseName::ImpulseProjection => Response::ImpulseProjection,
        ResponseName::ImpulseUnconditional => Response::ImpulseUnconditional,
        ResponseName::Penalty => Response::Penalty,
    }
}

const fn contact(name: ContactName) -> ContactMethod {
    match name {
        ContactName::LeastForce => ContactMethod::LeastForce,
        ContactName::ActiveSet => ContactMethod::ActiveSet,
        ContactName::Heuristic => ContactMethod::Heuristic,
        ContactName::Guesses => ContactMethod::Guesses,
        ContactName::SequentialImpulses => ContactMethod::SequentialImpulses,
        ContactName::Nncg => ContactMethod::ConjugateGradients,
    }
}

const fn coordinates(name: CoordinatesName) -> Coordinates {
    match name {
        CoordinatesName::Maximal => Coordinates::Maximal,
        CoordinatesName::Reduced => Coordinates::Reduced,
    }
}

const fn error_estimation(name: ErrorEstimationName) -> ErrorEstimation {
    match name {
        ErrorEstimationName::Off => ErrorEstimation::Off,
        ErrorEstimationName::Quick => ErrorEstimation::Quick,
        ErrorEstimationName::Full => ErrorEstimation::Full,
    }
}

const fn crowding(name: CrowdingName) -> Crowding {
    match name {
        CrowdingName::Step => Crowding::Step,
        CrowdingName::Error => Crowding::Error,
    }
}
