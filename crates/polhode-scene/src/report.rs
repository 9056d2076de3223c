//! Reports as JSON.

use crate::load::LoadedScene;
use crate::names;
use glam::DVec3;
use polhode::scene::{OverlapLimit, Promise};
use polhode::stability::{Beginning, MovingBody, PushMargin, Stability};
use polhode::{
    Acceleration, BodyId, BodySample, BrokenPromise, Momentum, MomentumLedger, Occurrence, PairAt, Plan,
    ReferenceReport, RunReport, Scene, SpringImpact, SpringReport,
};
use serde_json::{Value, json};

/// The report of a run; `wall_s` is the time it took, s.
pub fn report_json(report: &RunReport, wall_s: f64) -> Value {
    let (energy, ledger) = (&report.energy, &report.ledger);
    let mut value = json!({
        "scene": report.scene,
        "tier": names::tier(report.plan.tier),
        "outcome": names::outcome(report.outcome),
        "duration_s": report.duration_s,
        "simulated_s": report.simulated_s,
        "steps": report.steps,
        "wall_s": wall_s,
        "plan": plan_json(&report.plan),
        "energy": {
            "initial_j": energy.initial_j,
            "final_j": energy.final_j,
            "kinetic_j": energy.kinetic_j,
            "potential_j": energy.potential_j,
        },
        "ledger": {
            "numerical_j": ledger.numerical.value(),
            "projection_j": ledger.projection.value(),
            "impact_j": ledger.impact.value(),
            "friction_j": ledger.friction.value(),
            "rest_j": ledger.rest.value(),
            "damping_j": ledger.damping.value(),
            "external_j": ledger.external.value(),
            "closure_relative": ledger.closure_relative(),
            "momentum": momentum_json(&ledger.momentum),
        },
        "crowded": crowded_json(report),
        "events": report.events,
        "warnings": report.warnings,
        "tolerated": occurrences_json(&report.tolerated),
        "bodies": report.bodies.iter().map(|body| body_json(&body.name, &body.state)).collect::<Vec<_>>(),
    });
    value["error"] = error_json(report);
    value["choices"] = occurrences_json(&report.choices);
    if let (Value::Object(members), Value::Object(measured)) = (&mut value, certificate_json(report)) {
        members.extend(measured);
    }
    if let Some(springs) = &report.springs {
        value["springs"] = springs_json(report, springs);
    }
    value
}

/// The certificate of a run: the largest value of each measure, and where it was.
pub fn certificate_json(report: &RunReport) -> Value {
    let certificate = &report.certificate;
    json!({
        "max_projection_m": certificate.max_projection_m,
        "max_projection_of_limit": certificate.max_projection_of_limit,
        "max_projection_at": pair_json(report, certificate.max_projection_at),
        "max_projection_j": certificate.max_projection_j,
        "max_projection_relative": certificate.max_projection_relative,
        "max_projection_j_at": pair_json(report, certificate.max_projection_j_at),
        "max_ended_bounces_j": certificate.max_ended_bounces_j,
        "max_ended_bounces_at": pair_json(report, certificate.max_ended_bounces_at),
        "ended_bounces_j": certificate.ended_bounces_j,
        "max_penetration_m": certificate.max_penetration_m,
        "max_penetration_of_limit": certificate.max_penetration_of_limit,
        "max_penetration_at": pair_json(report, certificate.max_penetration_at),
        "max_sample_penetration_m": certificate.max_sample_penetration_m,
        "max_sample_penetration_of_limit": certificate.max_sample_penetration_of_limit,
        "max_sample_penetration_at": pair_json(report, certificate.max_sample_penetration_at),
        "max_friction_violation": certificate.max_friction_violation,
        "max_friction_violation_of_limit": certificate.max_friction_violation_of_limit,
        "max_friction_violation_at": pair_json(report, certificate.max_friction_violation_at),
        "max_residual": certificate.max_residual,
        "max_residual_of_limit": certificate.max_residual_of_limit,
        "max_acceleration_error_bound": certificate.max_acceleration_error_bound,
        "max_step_error": certificate.max_step_error,
        "estimated_error": report.error.relative(),
        "max_numerical_relative": certificate.max_numerical_relative,
        "factorisations": certificate.factorisations,
        "fallbacks": certificate.fallbacks,
        "max_load_defect": certificate.max_load_defect,
        "max_load_defect_of_limit": certificate.max_load_defect_of_limit,
        "max_joint_error_m": certificate.max_joint_error_m,
        "max_joint_error_rad": certificate.max_joint_error_rad,
        "max_joint_error_of_limit": certificate.max_joint_error_of_limit,
        "max_joint_error_at": pair_json(report, certificate.max_joint_error_at),
    })
}

/// The limits of the promise that a run has exceeded: when (s), which bodies, by how much, and what would help.
pub fn broken_json(report: &RunReport) -> Value {
    let name = |body: BodyId| report.bodies.get(body.index()).map(|body| body.name.as_str());
    let one = |broken: &BrokenPromise| {
        json!({
            "t_s": broken.t_s,
            "bodies": broken.bodies.map(|bodies| bodies.map(name)),
            "what": broken.what,
            "value": broken.value,
            "limit": broken.limit,
            "cure": broken.cure,
            "warning": broken.to_string(),
        })
    };
    report.broken.iter().map(one).collect()
}

/// What springs at contacts were asked for and reached: m, m/s, N, rad/s.
fn springs_json(report: &RunReport, springs: &SpringReport) -> Value {
    let name = |body: BodyId| report.bodies.get(body.index()).map(|body| body.name.as_str());
    let impact = |impact: &SpringImpact| {
        json!({
            "t_s": impact.begun_s,
            "duration_s": impact.duration_s,
            "body_a": name(impact.bodies[0]),
            "body_b": name(impact.bodies[1]),
            "approach_m_s": impact.approach_m_s,
            "separation_m_s": impact.separation_m_s,
            "penetration_m": impact.penetration_m,
            "force_n": impact.force_n,
            "restitution_asked": impact.restitution_asked,
            "alone": impact.is_alone,
        })
    };
    let out_of_reach = springs.out_of_reach.map(|[asked, reached]| json!({ "asked": asked, "reached": reached }));
    json!({
        "penetration_asked_m": springs.penetration_asked_m,
        "penetration_m": springs.penetration_m,
        "restitution_out_of_reach": out_of_reach,
        "impacts": springs.impacts,
        "worst_restitution": springs.worst_restitution.as_ref().map(impact),
        "first_impacts": springs.first_impacts.iter().map(impact).collect::<Vec<_>>(),
        "fastest_rad_s": springs.fastest_rad_s,
        "frequency_step": springs.frequency_step,
    })
}

/// The report of a run of a scene from a file, with what the file says of it.
pub fn scene_report_json(loaded: &LoadedScene, report: &RunReport, wall_s: f64) -> Value {
    let mut value = report_json(report, wall_s);
    value["title"] = json!(loaded.title());
    value["description"] = json!(loaded.description());
    value
}

/// The estimated error of a run: how it was estimated, the largest error, those at the end, the horizon.
fn error_json(report: &RunReport) -> Value {
    let error = &report.error;
    let name = |body: BodyId| report.bodies.get(body.index()).map(|body| body.name.as_str());
    let largest = error.largest.map(|largest| {
        json!({
            "relative": largest.relative,
            "position_m": largest.error.position_m,
            "rotation_rad": largest.error.rotation_rad,
            "body": name(largest.body),
            "t_s": largest.t_s,
        })
    });
    let reference = |reference: &ReferenceReport| {
        json!({
            "kind": reference.kind.name(),
            "method": reference.method,
            "covered_s": reference.covered_s,
            "work": reference.work,
            "largest_distance": reference.largest_distance,
            "ended": reference.ended,
        })
    };
    let at_end = report.bodies.iter().zip(&error.bodies);
    json!({
        "estimation": error.estimation.name(),
        "largest": largest,
        "horizon_s": error.horizon_s,
        "references": error.references.iter().map(reference).collect::<Vec<_>>(),
        "at_end": at_end.map(|(body, error)| json!({
            "name": body.name, "position_m": error.position_m, "rotation_rad": error.rotation_rad,
        })).collect::<Vec<_>>(),
    })
}

/// Two bodies at a time, s; null when there are none.
fn pair_json(report: &RunReport, at: Option<PairAt>) -> Value {
    let name = |body: BodyId| report.bodies.get(body.index()).map(|body| body.name.as_str());
    at.map_or(Value::Null, |at| json!({ "t_s": at.t_s, "body_a": name(at.body_a), "body_b": name(at.body_b) }))
}

/// The stretches of crowded events together; null without one.
fn crowded_json(report: &RunReport) -> Value {
    if report.crowded.is_empty() {
        return Value::Null;
    }
    json!({
        "stretches": report.crowded.len(),
        "length_s": report.crowded_s(),
        "max_residual": report.crowded_residual(),
    })
}

/// What was tolerated or chosen; times in s.
fn occurrences_json(occurrences: &[Occurrence]) -> Value {
    let one = |Occurrence { what, count, first_s, last_s, .. }: &Occurrence| {
        json!({
            "what": what, "count": count, "first_s": first_s, "last_s": last_s
        })
    };
    occurrences.iter().map(one).collect()
}

/// The ledger of momentum: N s, N m s.
fn momentum_json(ledger: &MomentumLedger) -> Value {
    let pair = |momentum: Momentum| json!({ "linear": triple(momentum.linear), "angular": triple(momentum.angular) });
    json!({
        "about": triple(ledger.about),
        "initial": pair(ledger.initial),
        "final": pair(ledger.current),
        "gravity": pair(ledger.gravity.value()),
        "support": pair(ledger.support.value()),
        "rest": pair(ledger.rest.value()),
        "projection": pair(ledger.projection.value()),
        "numerical": pair(ledger.numerical.value()),
        "closure_relative": ledger.closure_relative(),
    })
}

/// A plan.
pub fn plan_json(plan: &Plan) -> Value {
    let effects: Vec<_> = plan
        .effects
        .iter()
        .map(|decision| {
            json!({
                "effect": decision.effect.name(),
                "decision": names::decision(decision.decision),
                "fact": decision.fact,
                "saves": decision.saves,
            })
        })
        .collect();
    json!({
        "tier": names::tier(plan.tier),
        "tier_reason": plan.tier_reason,
        "integrator": names::integrator(plan.integrator),
        "integrator_reason": plan.integrator_reason,
        "impact": names::impact(plan.impact),
        "contact": names::contact(plan.contact),
        "response": plan.response.name(),
        "broad_phase": plan.broad_phase.name(),
        "step_s": plan.step_s,
        "tolerance": plan.tolerance,
        "promise": promise_json(&plan.promise),
        "max_events_per_step": plan.max_events_per_step,
        "effects": effects,
    })
}

/// What a run promises; null where nothing is.
fn promise_json(promise: &Promise) -> Value {
    let overlap = match promise.overlap {
        OverlapLimit::OfSize(part) => json!({ "of_size": part }),
        OverlapLimit::OfStatedPenetration(times) => json!({ "of_stated_penetration": times }),
        OverlapLimit::OfEnvelope(times) => json!({ "of_envelope": times }),
        _ => Value::Null,
    };
    json!({
        "overlap": overlap,
        "joint_gap": promise.joint_gap,
        "energy": promise.energy,
        "residual": promise.residual,
        "friction": promise.friction,
        "loads": promise.loads,
        "error": promise.error,
    })
}

/// A plan with the accelerations of all bodies at t = 0, in the order of the scene: linear of the centre of mass,
/// m/s^2, angular, rad/s^2, in the world.
pub fn plan_with_accelerations_json(scene: &Scene, plan: &Plan, accelerations: &[Acceleration]) -> Value {
    let mut value = plan_json(plan);
    let list: Vec<_> = scene
        .bodies()
        .iter()
        .zip(accelerations)
        .map(|(body, a)| json!({ "body": body.name(), "linear": triple(a.linear), "angular": triple(a.angular) }))
        .collect();
    value["scene"] = json!(scene.name());
    value["accelerations"] = json!(list);
    value
}

/// How far bodies at rest are from moving. `of_weight` is null where nothing holds them, and `"any"` where no push
/// moves them.
pub fn stability_json(scene: &Scene, stability: &Stability) -> Value {
    let begins = |moving: &[MovingBody]| {
        let one = |moving: &MovingBody| {
            let how = match moving.beginning {
                Beginning::Slides => "slides",
                Beginning::Tips => "tips",
                _ => "moves",
            };
            let name = scene.bodies().get(moving.body.index()).map(polhode::Body::name);
            json!({ "body": name, "how": how, "speed": moving.speed, "direction": moving.direction.map(triple) })
        };
        moving.iter().map(one).collect::<Vec<_>>()
    };
    let push = |push: &PushMargin| {
        let of_weight = push.of_weight.map(|part| if part.is_finite() { json!(part) } else { json!("any") });
        let tilt = push.tilt_rad().filter(|_| scene.forces().is_empty());
        json!({
            "direction": triple(push.direction),
            "of_weight": of_weight,
            "tilt_rad": tilt,
            "begins": begins(&push.begins),
        })
    };
    json!({
        "bodies": stability.bodies,
        "contacts": stability.contacts,
        "friction_needed": stability.friction.needed,
        "begins": begins(&stability.friction.begins),
        "pushes": stability.pushes.iter().map(push).collect::<Vec<_>>(),
    })
}

fn body_json(name: &str, sample: &BodySample) -> Value {
    json!({
        "name": name,
        "position": triple(sample.pose.translation),
        "orientation": sample.pose.rotation.to_wxyz(),
        "velocity": triple(sample.velocity.linear),
        "angular_velocity": triple(sample.velocity.angular),
    })
}

pub(crate) fn triple(v: DVec3) -> [f64; 3] {
    v.to_array()
}
