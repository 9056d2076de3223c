//! How far what a step tells of its loads is from Newton's law.
//!
//! Newton's law over a step, for each body: `m (v_end - v_start) = m g h + K + sum p`, with the kick of fields `K` and
//! the impulses `p` as they are told: of contacts, of joints, of springs and motors at joints. The defect is told in
//! relation to the sum of the magnitudes of these terms, the weight among them. It sees what was applied and not told,
//! told and not applied, or told of another body. Of moments it says nothing.

use super::kick::Kick;
use crate::accounting::time_step_report::TimeStepReport;
use crate::identity::contact_id::Feature;
use crate::model::{Model, tolerances};
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// The largest defect of Newton's law among these bodies (no unit), where they had these states before a step of `h`
/// (s).
pub(super) fn newton_residual(
    model: &Model,
    (before, after): (&[BodyState], &[BodyState]),
    bodies: &[usize],
    (kick, h): (&Kick, f64),
    report: &TimeStepReport,
) -> f64 {
    // Left over, and the sum of the magnitudes of the terms.
    let mut sums: Vec<(DVec3, f64)> = Vec::with_capacity(bodies.len());
    for (place, (&body, start)) in bodies.iter().zip(before).enumerate() {
        let mass = model.bodies[body].rigid.as_ref().map_or(0.0, polhode_dynamics::RigidBody::mass);
        let (weight, kicked) =
            (model.free_acceleration(body) * h, kick.changes.get(place).map_or(DVec3::ZERO, |own| own.linear));
        let change = after[body].linear_velocity - start.linear_velocity;
        sums.push(((change - weight - kicked) * mass, (weight.length() + kicked.length()) * mass));
    }
    let mut give = |body: usize, impulse: DVec3| {
        if let Ok(place) = bodies.binary_search(&body) {
            sums[place].0 -= impulse;
            sums[place].1 += impulse.length();
        }
    };
    for given in report.impulses.iter().filter(|given| matches!(given.id.feature, Feature::Shapes(_))) {
        let on_a = given.geometry.normal * given.impulse + given.friction;
        given.id.members().for_each(|(body, sign)| give(body, on_a * sign));
    }
    for (&joint, view) in report.told.joints.iter().chain(&report.told.struck) {
        for (body, sign) in model.joints.ends_of_joint(joint) {
            give(body, view.force_n * sign);
        }
    }
    report.told.others.iter().for_each(|&(body, impulse)| give(body, impulse));
    let is_held = |body: usize| model.bodies[body].rigid.as_ref().is_none_or(polhode_dynamics::RigidBody::is_pivoted);
    let defect = |(&body, (left, all)): (&usize, &(DVec3, f64))| {
        let mass = model.bodies[body].rigid.as_ref().map_or(0.0, polhode_dynamics::RigidBody::mass);
        let rounding = mass * tolerances::velocity_rounding(model, after, &[body]);
        let defect = left.length() - rounding;
        if is_held(body) || defect <= 0.0 { 0.0 } else { defect / all }
    };
    bodies.iter().zip(&sums).map(defect).fold(0.0, f64::max)
}
