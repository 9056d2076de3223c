//! The ledger: every joule and every newton-second of every scene that the project ships is accounted for.

use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use polhode::scene::RestitutionLaw;
use polhode::{BodyId, Effects, Scene};

/// What may be left unexplained, relative to the largest energy of the run.
const CLOSURE: f64 = 1e-12;
/// What a scene without losses may lose in a minute, relative to the same.
const LOSS: f64 = 1e-12;

/// Closure of the ledger in every shipped scene.
pub(super) fn shipped_scenes(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for name in context.shipped.names()? {
        match context.shipped.run(&name) {
            Ok(run) => {
                let ledger = &run.report.ledger;
                for (what, closure) in [
                    ("closure", ledger.closure_relative()),
                    ("closure of momentum", ledger.momentum.closure_relative()),
                ] {
                    rows.push(Row::at_most("ledger", &format!("{name}: {what}"), CLOSURE, closure));
                }
            }
            Err(error) => rows.push(Row::broken("ledger", &name, error.to_string())),
        }
    }
    Ok(rows)
}

/// Scenes in which every contact has restitution 1 lose nothing in a minute.
pub(super) fn elastic_scenes(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for name in context.shipped.names()? {
        let scene = context.shipped.load(&name)?;
        if !is_elastic(&scene) {
            continue;
        }
        let run = Run::of(&scene.with_duration(60.0)?, Effects::Planned)?;
        let lost = (run.report.energy.initial_j - run.report.energy.final_j) / run.report.ledger.scale_j;
        rows.push(Row::at_most("energy at e = 1", &format!("{name}: energy lost in 60 s"), LOSS, lost));
    }
    Ok(rows)
}

/// Whether there are contacts, each has restitution 1, and none has friction that takes the energy of a slip: friction
/// with tangential restitution 1 reverses the slip.
fn is_elastic(scene: &Scene) -> bool {
    let count = scene.bodies().len();
    let law = scene.method().restitution_law;
    let reverses_slips = law == Some(RestitutionLaw::ChatterjeeRuina { tangential_restitution: 1.0 });
    let pairs = (0..count).flat_map(|a| (a + 1..count).map(move |b| (BodyId::new(a), BodyId::new(b))));
    let mut pairs = pairs.filter(|&(a, b)| scene.can_collide(a, b));
    let mut any = false;
    let all = pairs.all(|(a, b)| {
        any = true;
        let material = scene.material_between(a, b);
        material.is_ok_and(|own| own.restitution() == 1.0 && (reverses_slips || own.friction() == 0.0))
    });
    any && all
}
