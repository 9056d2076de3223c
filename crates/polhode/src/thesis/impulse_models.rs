//! The models that the thesis tries before it has contact forces (section 3.3): impulses alone.
//!
//! | [`Response`](crate::scene::Response) | what it does | what goes wrong |
//! |---|---|---|
//! | `impulse` | impulses where bodies approach | a body at rest falls by `g h^2/2` a step: it sinks (Videos 05, 06) |
//! | `impulse-projection` | then moves bodies apart | each lift adds `m g d`: they vibrate for ever (Videos 07, 08) |
//! | `impulse-unconditional` | impulses wherever bodies overlap | apart they pull: bodies stay caught (Video 04) |
//!
//! The impulse at a contact is that of equation (14), `j = -(1 + e) u/G`, u the rate of separation (m/s), G the inverse
//! mass seen by the contact (1/kg). Its change of energy is `-(1 - e^2) u^2/(2 G)` for either sign of u, so that
//! pulling takes energy as pushing does. Bodies are moved along the normal of the deepest contact of each pair, each by
//! its share of the inverse masses; the ledger has the energy of that as taken by projection, with a negative sign.

use crate::collision::touch::Touch;
use crate::constraint::ConstraintId;
use crate::model::Model;
use crate::rows::assembly::{Assembly, apply_impulses};
use crate::rows::groups::Group;
use crate::solve::projection::Projection;
use crate::tier::core::Core;
use polhode_dynamics::{BodyState, RigidBody};
use polhode_response::ResponseError;
use polhode_response::impact::{Application, ImpactOutcome};

/// Gives every contact of a group one impulse, in order, whether its bodies approach or separate. The status of what is
/// returned stays the default: nothing is known of the contacts afterwards.
///
/// # Errors
/// When a number is not finite.
pub(super) fn strike_unconditionally(
    model: &Model,
    states: &mut [BodyState],
    group: &Group,
    touches: &[Touch],
) -> Result<ImpactOutcome, ResponseError> {
    let members: Vec<Touch> = group.contacts.iter().map(|&i| touches[i]).collect();
    let rows = members.iter().map(|touch| (touch.id, touch.kinematics.geometry));
    let assembly = Assembly::new(model, states, &group.bodies, rows)?;
    let delassus = assembly.problem.delassus();
    let mut rates: Vec<f64> = members.iter().map(|touch| touch.kinematics.separation_rate).collect();
    let mut outcome = ImpactOutcome { impulses: vec![0.0; members.len()], ..ImpactOutcome::default() };
    for (row, touch) in members.iter().enumerate() {
        let (before, inverse_mass) = (rates[row], delassus.get(row, row));
        if before == 0.0 || inverse_mass <= 0.0 {
            continue;
        }
        let restitution = model.scene.pair_material(touch.id.a, touch.id.b).restitution();
        let impulse = -(1.0 + restitution) * before / inverse_mass;
        for (other, rate) in rates.iter_mut().enumerate() {
            *rate += delassus.get(other, row) * impulse;
        }
        rates[row] = -restitution * before;
        let energy_change = 0.5 * impulse * (before + rates[row]);
        outcome.impulses[row] = impulse;
        outcome.energy_change += energy_change;
        outcome.applications.push(Application { row, impulse, energy_change });
    }
    let impulses = members.iter().zip(&outcome.impulses);
    apply_impulses(model, states, impulses.map(|(touch, &p)| (touch.id, &touch.kinematics.geometry, p)));
    outcome.velocities_after = rates;
    Ok(outcome)
}

/// Moves the bodies of every pair that overlaps apart, by the depth of its deepest contact, pair after pair, and books
/// what that does to the energy. A body with a pivot stays where it is.
pub(super) fn move_apart(core: &mut Core, states: &mut [BodyState], touches: &[Touch]) {
    let movable = core.model.movable.clone();
    for pair in touches.chunk_by(|x, y| (x.id.a, x.id.b) == (y.id.a, y.id.b)) {
        let depth = |touch: &Touch| -touch.kinematics.geometry.separation;
        let Some(deepest) = pair.iter().max_by(|x, y| depth(x).total_cmp(&depth(y))) else { continue };
        let shares = [deepest.id.a, deepest.id.b].map(|body| share(&core.model, body));
        let total = shares[0] + shares[1];
        if depth(deepest) <= 0.0 || total <= 0.0 {
            continue;
        }
        let before = core.accounts.books.balance(&core.model, states, &movable);
        let way = deepest.kinematics.geometry.normal * (depth(deepest) / total);
        states[deepest.id.a].pose.translation += way * shares[0];
        states[deepest.id.b].pose.translation -= way * shares[1];
        let after = core.accounts.books.balance(&core.model, states, &movable);
        let moved_m = depth(deepest) * shares[0].max(shares[1]) / total;
        let farthest = Some(ConstraintId::Contact(deepest.id));
        let done = Projection { moved_m, farthest, ..Projection::default() };
        core.book_projection(core.t, states, &done, (before, after));
    }
}

/// Inverse mass by which a body gives way, 1/kg: zero for what is immovable or held at a point.
fn share(model: &Model, body: usize) -> f64 {
    let is_held = model.scene.bodies()[body].pivot_point().is_some();
    let inverse_mass = model.bodies[body].rigid.as_ref().map_or(0.0, RigidBody::inverse_mass);
    if is_held { 0.0 } else { inverse_mass }
}
