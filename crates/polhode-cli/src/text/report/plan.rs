//! The plan of a run: methods, then one line per effect.

use crate::text::table::{Table, number};
use polhode::Plan;
use polhode::scene::{OverlapLimit, Promise};
use polhode_scene::names;

/// Width of a plan, characters.
const WIDTH: usize = 100;

/// Methods, then effects.
pub(super) fn methods_and_effects(plan: &Plan) -> String {
    let mut methods = Table::default();
    methods.row(["tier", &format!("{} ({})", names::tier(plan.tier), plan.tier_reason)]);
    methods.row(["integrator", &format!("{} ({})", names::integrator(plan.integrator), plan.integrator_reason)]);
    methods.row(["impact", names::impact(plan.impact)]);
    methods.row(["contact", names::contact(plan.contact)]);
    methods.row(["response", plan.response.name()]);
    methods.row(["broad phase", plan.broad_phase.name()]);
    methods.row(["step", &format!("{} s", number(plan.step_s))]);
    methods.row(["tolerance", &number(plan.tolerance)]);
    methods.row(["promise", &promise(&plan.promise)]);
    let mut effects = Table::default();
    for effect in &plan.effects {
        let saves = if effect.saves.is_empty() { String::new() } else { format!("; {}", effect.saves) };
        let fact = format!("{}{saves}", effect.fact);
        effects.row([effect.effect.name(), names::decision(effect.decision), &fact]);
    }
    format!("plan\n{}\neffects\n{}", methods.print_within(WIDTH), effects.print_within(WIDTH))
}

/// The limits beyond which a run is degraded.
fn promise(promise: &Promise) -> String {
    let overlap = match promise.overlap {
        OverlapLimit::OfSize(part) => format!("{} of the smaller body", number(part)),
        OverlapLimit::OfStatedPenetration(times) => format!("{} times the stated penetration", number(times)),
        OverlapLimit::OfEnvelope(times) => format!("{} times the envelope", number(times)),
        _ => "not limited".to_owned(),
    };
    let others = [
        ("gaps of joints", promise.joint_gap),
        ("energy from projections and from the method", Some(promise.energy)),
        ("residuals", promise.residual),
        ("Coulomb's law", promise.friction),
        ("loads by Newton's law", promise.loads),
        ("estimated error", Some(promise.error)),
    ];
    let others = others.into_iter().filter_map(|(what, limit)| Some(format!(", {what} {}", number(limit?))));
    format!("overlaps at most {overlap}{}", others.collect::<String>())
}
