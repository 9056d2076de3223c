//! Projection: held contacts back onto zero separation and zero relative velocity, pivots back to their places.
//!
//! Positions: Newton on the separations in the metric of mass, `dq = M^-1 J^T l`, `G l = -separation`; velocities:
//! `dv = M^-1 J^T l`, `G l = -J v`. Both are the smallest changes that do it and neither is fed back into the motion
//! as a force; what they change in energy is booked in the ledger.

use crate::collision::contact_set::ContactId;
use crate::interaction::assembly::{Assembly, apply_impulses, apply_pivot_impulses};
use crate::interaction::constraint::ConstraintId;
use crate::pivots::PivotKinematics;
use crate::world::World;
use polhode_contact::ContactGeometry;
use polhode_dynamics::BodyState;
use polhode_response::{LeastNormHold, ResponseError};
use polhode_spatial::{DVec3, Rotation};
use std::collections::BTreeMap;

/// Newton steps on the separations. The correction is of the order of the integration error (1e-11) or of touch, so
/// that the second step is already at round-off.
const MAX_NEWTON_STEPS: usize = 3;

/// A separation beyond this fraction of the pair's size is not drift: the contact's place has jumped (a ring's nearest place
/// on an edge, say), and to put it together would throw the bodies. Drift is of the order of the tolerance.
const JUMPED_RELATIVE: f64 = 1e-5;

/// Contacts that are farther from zero separation than this fraction of the pair's size and rounding after the last Newton
/// step have not been put together: by what penetration is judged by at the default tolerance.
const UNCONVERGED_RELATIVE: f64 = 1e-12;

/// Separations below this fraction of the rounding that penetration is judged with are left alone.
const ROUNDING_FRACTION: f64 = 0.25;

/// What a projection has done.
#[derive(Debug, Clone, Default)]
pub(crate) struct Projection {
    /// Largest displacement of a body, m: of its origin, plus its rotation times its size, which bounds that of all points.
    pub(crate) moved_m: f64,
    /// The constraint that was farthest from what it was put to; none when nothing was to be done.
    pub(crate) farthest: Option<ConstraintId>,
    /// Contacts that were left alone because their place had jumped.
    pub(crate) jumped: Vec<ConstraintId>,
    /// Constraints that are farther off than rounding after the last Newton step.
    pub(crate) unconverged: Vec<ConstraintId>,
    /// Work of prescribed motions by the impulses that removed velocities, J.
    pub(crate) work_j: f64,
}

impl Projection {
    /// The bodies of the constraint that was farthest from what it was put to.
    pub(crate) fn pair(&self) -> Option<(usize, usize)> {
        self.farthest.as_ref().map(ConstraintId::bodies)
    }
}

/// Puts the held contacts of a group of bodies onto zero separation, then removes their relative velocities.
///
/// # Errors
/// When the state is not finite.
pub(crate) fn project(
    world: &World,
    states: &mut [BodyState],
    bodies: &[usize],
    held: &[ContactId],
) -> Result<Projection, ResponseError> {
    project_all(world, states, bodies, held, held)
}

/// Puts contacts onto zero separation, then removes the relative velocities of those that hold.
///
/// # Errors
/// When the state is not finite.
pub(crate) fn project_all(
    world: &World,
    states: &mut [BodyState],
    bodies: &[usize],
    touching: &[ContactId],
    held: &[ContactId],
) -> Result<Projection, ResponseError> {
    let mut done = project_positions(world, states, bodies, touching)?;
    let slowed = project_velocities(world, states, bodies, held)?;
    done.farthest = done.farthest.or(slowed.fastest);
    done.work_j = slowed.work_j;
    Ok(done)
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
) -> Result<Projection, ResponseError> {
    let mut done = Projection::default();
    let mut moved: BTreeMap<usize, (DVec3, DVec3)> = BTreeMap::new();
    let distance =
        |(id, geometry): &(ContactId, ContactGeometry)| (geometry.separation.abs(), ConstraintId::Contact(*id));
    for step in 0..=MAX_NEWTON_STEPS {
        let geometries = contacts.iter().filter_map(|&id| Some((id, world.kinematics(states, id)?.geometry)));
        let drifted = |(id, geometry): &(ContactId, ContactGeometry)| {
            geometry.separation.abs() <= JUMPED_RELATIVE * world.pair_size(id.a, id.b)
        };
        let (geometries, jumped): (Vec<_>, Vec<_>) = geometries.partition(drifted);
        done.jumped.extend(jumped.iter().map(|(id, _)| ConstraintId::Contact(*id)));
        let at_rounding = geometries
            .iter()
            .all(|(id, geometry)| geometry.separation.abs() <= ROUNDING_FRACTION * world.rounding(states, id.a, id.b));
        let is_in_place = |pivot: PivotKinematics| {
            pivot.gap.length() <= ROUNDING_FRACTION * world.rounding(states, pivot.body, pivot.body)
        };
        if at_rounding && world.pivots(states, bodies).all(is_in_place) {
            break;
        }
        if step == MAX_NEWTON_STEPS {
            let apart = |(id, geometry): &&(ContactId, ContactGeometry)| {
                geometry.separation.abs()
                    > UNCONVERGED_RELATIVE * world.pair_size(id.a, id.b) + world.rounding(states, id.a, id.b)
            };
            done.unconverged.extend(geometries.iter().filter(apart).map(|(id, _)| ConstraintId::Contact(*id)));
            let off = |pivot: &PivotKinematics| {
                let size = world.bodies[pivot.body].size;
                pivot.gap.length() > UNCONVERGED_RELATIVE * size + world.rounding(states, pivot.body, pivot.body)
            };
            done.unconverged.extend(world.pivots(states, bodies).filter(off).map(|pivot| pivot.id()));
            break;
        }
        if done.farthest.is_none() {
            let pivots = world.pivots(states, bodies).map(|pivot| (pivot.gap.length(), pivot.id()));
            done.farthest = farthest(geometries.iter().map(distance).chain(pivots));
        }
        let assembly = Assembly::new(world, states, bodies, geometries.iter().copied())?;
        let mut separations: Vec<f64> = geometries.iter().map(|(_, g)| g.separation).collect();
        separations.extend(assembly.pivots().iter().flat_map(|pivot| pivot.gap.to_array()));
        let multipliers = cancel(&assembly, &separations)?;
        for (body, linear, angular) in assembly.split(&assembly.problem.response(&multipliers)?) {
            let pose = &mut states[body].pose;
            pose.translation += linear;
            pose.rotation = Rotation::from_rotation_vector(angular) * pose.rotation;
            let sum = moved.entry(body).or_default();
            *sum = (sum.0 + linear, sum.1 + angular);
        }
    }
    done.jumped.dedup_by_key(|contact| contact.bodies());
    done.unconverged.dedup_by_key(|constraint| constraint.bodies());
    let displacement = |(&body, (linear, angular)): (&usize, &(DVec3, DVec3))| {
        linear.length() + angular.length() * world.bodies[body].size
    };
    done.moved_m = moved.iter().map(displacement).fold(0.0, f64::max);
    Ok(done)
}

/// The constraint of the largest of some distances or speeds.
fn farthest(distances: impl Iterator<Item = (f64, ConstraintId)>) -> Option<ConstraintId> {
    distances.max_by(|x, y| x.0.total_cmp(&y.0)).map(|(_, constraint)| constraint)
}

/// What the removal of relative velocities has done.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Slowed {
    /// The constraint that was fastest; none when none moved.
    pub(crate) fastest: Option<ConstraintId>,
    /// Work of prescribed motions by the impulses, J.
    pub(crate) work_j: f64,
}

/// Removes the relative velocities of contacts, and those of pivots.
///
/// # Errors
/// When the state is not finite.
pub(crate) fn project_velocities(
    world: &World,
    states: &mut [BodyState],
    bodies: &[usize],
    contacts: &[ContactId],
) -> Result<Slowed, ResponseError> {
    let contacts: Vec<_> = contacts.iter().filter_map(|&id| Some((id, world.kinematics(states, id)?))).collect();
    let stands = |pivot: PivotKinematics| pivot.velocity == DVec3::ZERO;
    if contacts.iter().all(|(_, k)| k.separation_rate == 0.0) && world.pivots(states, bodies).all(stands) {
        return Ok(Slowed::default());
    }
    let assembly = Assembly::new(world, states, bodies, contacts.iter().map(|(id, k)| (*id, k.geometry)))?;
    let mut rates: Vec<f64> = contacts.iter().map(|(_, k)| k.separation_rate).collect();
    rates.extend(assembly.pivots().iter().flat_map(|pivot| pivot.velocity.to_array()));
    let multipliers = cancel(&assembly, &rates)?;
    let impulses = contacts.iter().zip(&multipliers).map(|((id, k), &p)| (*id, &k.geometry, p));
    apply_impulses(world, states, impulses.clone());
    apply_pivot_impulses(world, states, assembly.pivot_forces(&multipliers));
    let work_j = world.prescribed_work(states, impulses);
    let speeds = contacts.iter().map(|(id, k)| (k.separation_rate.abs(), ConstraintId::Contact(*id)));
    let pivots = assembly.pivots().iter().map(|pivot| (pivot.velocity.length(), pivot.id()));
    Ok(Slowed { fastest: farthest(speeds.chain(pivots)), work_j })
}

/// Multipliers whose response cancels `values` on all rows.
fn cancel(assembly: &Assembly, values: &[f64]) -> Result<Vec<f64>, ResponseError> {
    let delassus = assembly.problem.delassus();
    LeastNormHold::factor(&delassus)?.solve(&delassus, values)
}
