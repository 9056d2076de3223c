//! Projection: held contacts back onto zero separation and zero relative velocity.
//!
//! Positions: Newton on the separations in the metric of mass, `dq = M^-1 J^T l`, `G l = -separation`; velocities:
//! `dv = M^-1 J^T l`, `G l = -J v`. Both are the smallest changes that do it and neither is fed back into the motion
//! as a force; what they change in energy is booked in the ledger.

use crate::collision::contact_set::ContactId;
use crate::interaction::assembly::{Assembly, apply_impulses};
use crate::world::World;
use polhode_dynamics::BodyState;
use polhode_response::{LeastNormHold, ResponseError};
use polhode_spatial::Rotation;

/// Newton steps on the separations. The correction is of the order of the integration error (1e-11) or of touch, so
/// that the second step is already at round-off.
const MAX_NEWTON_STEPS: usize = 3;

/// A separation beyond this fraction of the pair's size is not drift: the contact's place has jumped (a ring's nearest place
/// on an edge, say), and to put it together would throw the bodies. Drift is of the order of the tolerance.
const JUMPED_RELATIVE: f64 = 1e-5;

/// Separations below this fraction of the rounding that penetration is judged with are left alone.
const ROUNDING_FRACTION: f64 = 0.25;

/// Puts the held contacts of a group of bodies onto zero separation, then removes their relative velocities; the work of
/// prescribed motions in that, J.
///
/// # Errors
/// When the state is not finite.
pub(crate) fn project(
    world: &World,
    states: &mut [BodyState],
    bodies: &[usize],
    held: &[ContactId],
) -> Result<f64, ResponseError> {
    project_positions(world, states, bodies, held)?;
    project_velocities(world, states, bodies, held)
}

/// Puts contacts onto zero separation.
///
/// # Errors
/// When the state is not finite.
pub(crate) fn project_positions(
    world: &World,
    states: &mut [BodyState],
    bodies: &[usize],
    contacts: &[ContactId],
) -> Result<(), ResponseError> {
    for _ in 0..MAX_NEWTON_STEPS {
        let geometries: Vec<_> = contacts
            .iter()
            .filter_map(|&id| Some((id, world.kinematics(states, id)?.geometry)))
            .filter(|(id, geometry)| geometry.separation.abs() <= JUMPED_RELATIVE * world.pair_size(id.a, id.b))
            .collect();
        let at_rounding = geometries
            .iter()
            .all(|(id, geometry)| geometry.separation.abs() <= ROUNDING_FRACTION * world.rounding(states, id.a, id.b));
        if at_rounding {
            break;
        }
        let assembly = Assembly::new(world, states, bodies, geometries.iter().copied())?;
        let separations: Vec<f64> = geometries.iter().map(|(_, g)| g.separation).collect();
        let multipliers = cancel(&assembly, &separations)?;
        for (body, linear, angular) in assembly.split(&assembly.problem.response(&multipliers)?) {
            let pose = &mut states[body].pose;
            pose.translation += linear;
            pose.rotation = Rotation::from_rotation_vector(angular) * pose.rotation;
        }
    }
    Ok(())
}

/// Removes the relative velocities of contacts; the work of prescribed motions by the impulses that do it, J.
///
/// # Errors
/// When the state is not finite.
pub(crate) fn project_velocities(
    world: &World,
    states: &mut [BodyState],
    bodies: &[usize],
    contacts: &[ContactId],
) -> Result<f64, ResponseError> {
    let contacts: Vec<_> = contacts.iter().filter_map(|&id| Some((id, world.kinematics(states, id)?))).collect();
    if contacts.iter().all(|(_, k)| k.separation_rate == 0.0) {
        return Ok(0.0);
    }
    let assembly = Assembly::new(world, states, bodies, contacts.iter().map(|(id, k)| (*id, k.geometry)))?;
    let impulses = cancel(&assembly, &contacts.iter().map(|(_, k)| k.separation_rate).collect::<Vec<_>>())?;
    let impulses = contacts.iter().zip(&impulses).map(|((id, k), &p)| (*id, &k.geometry, p));
    apply_impulses(world, states, impulses.clone());
    Ok(world.prescribed_work(states, impulses))
}

/// Multipliers whose response cancels `values` on all rows.
fn cancel(assembly: &Assembly, values: &[f64]) -> Result<Vec<f64>, ResponseError> {
    let delassus = assembly.problem.delassus();
    LeastNormHold::factor(&delassus)?.solve(&delassus, values)
}
