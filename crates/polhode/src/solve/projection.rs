//! Projection: held contacts back onto zero separation and zero relative velocity, bilateral constraints onto zero
//! gaps.
//!
//! Positions: Newton on the separations in the metric of mass, `dq = M^-1 J^T l`, `G l = -separation`; velocities:
//! `dv = M^-1 J^T l`, `G l = -J v`. Both are the smallest changes that satisfy the constraints. Neither acts on the
//! motion as a force. The ledger books their change of energy.

use crate::collision::turn::Turn;
use crate::collision::{contact_kinematics, moving_surfaces, slip_directions};
use crate::constraint::ConstraintId;
use crate::identity::contact_id::ContactId;
use crate::joints::bilateral::{self, Bilateral, Reaction, apply_reactions};
use crate::joints::held;
use crate::model::states_of::{set_states, states_of};
use crate::model::{Model, prescribed, tolerances};
use crate::rows::assembly::{Assembly, TangentRow, apply_impulses, largest_change};
use crate::rows::rotation_row::RotationRow;
use crate::solve::overlap::Overlaps;
use crate::solve::rotational_friction::{apply_moments, moment_work};
use polhode_contact::{ContactGeometry, ContactKinematics};
use polhode_dynamics::BodyState;
use polhode_response::solve::removal::{Limits, Removed, remove};
use polhode_response::{Memory, ResponseError};
use polhode_spatial::{DVec3, Rotation};
use std::collections::BTreeMap;

/// Newton steps on the separations. The correction is of the order of the integration error (1e-11) or of the touch
/// distance, so that the second step already reaches rounding error.
const MAX_NEWTON_STEPS: usize = 3;

/// The same of bilateral constraints alone, which time steps leave open by up to a thousandth of a size. The steps
/// converge quadratically; where bodies move by as much as their size in a step, there may be no closed pose.
const MAX_CLOSING_STEPS: usize = 8;

/// A separation beyond this fraction of the pair's size is not drift: the contact point has jumped (for example, a
/// ring's nearest point on an edge), and its projection would displace the bodies far. Drift is of the order of the
/// tolerance.
const JUMPED_RELATIVE: f64 = 1e-5;

/// A relative velocity beyond this fraction of the speeds of the bodies and of what gravity gives over their size, and
/// beyond the tolerance of the method, is not drift either: the contact point has jumped to a point at which the bodies
/// approach or separate. Only an impact may stop them there.
const JUMPED_SPEED: f64 = 1e-7;

/// Contacts farther from zero separation than this fraction of the pair's size plus rounding after the last Newton step
/// have not converged. It is what a step aims at (`Settings::penetration_aim`) at the default tolerance.
const UNCONVERGED_RELATIVE: f64 = 1e-12;

/// Separations below this fraction of the rounding allowance of penetration are not projected.
const ROUNDING_FRACTION: f64 = 0.25;

/// Contacts of a pile may be so nearly linearly dependent that an exact projection moves bodies by thousands of times
/// their separations. If it moves them by more than this many times the largest separation (dimensionless, 2 to 100),
/// the projection is partial (regularised).
const PARTIAL_AMPLIFICATION: f64 = 5.0;

/// The same as a fraction of the smallest size, or of the smallest speed of a pair: five steps' error at the
/// default tolerance.
const PARTIAL_RELATIVE: f64 = 5e-11;

/// Separations below this fraction of the pair's size are negligible: removing them is not worth a large displacement.
const NEGLIGIBLE_RELATIVE: f64 = 1e-13;

/// Result of a projection.
#[derive(Debug, Clone, Default)]
pub(crate) struct Projection {
    /// Largest displacement of a body, m: of its origin, plus its rotation times its size, which bounds that of all
    /// points.
    pub(crate) moved_m: f64,
    /// The constraint with the largest violation before the projection; none when there was none.
    pub(crate) farthest: Option<ConstraintId>,
    /// Whether the projection was partial, because contacts are nearly linearly dependent.
    pub(crate) is_partial: bool,
    /// Whether separations exceeded what a step aims at: the projection may have made other contacts
    /// penetrate.
    pub(crate) exceeds_tolerance: bool,
    /// Contacts that were not projected because their point had jumped.
    pub(crate) jumped: Vec<ConstraintId>,
    /// Constraints whose violation exceeds rounding after the last Newton step.
    pub(crate) unconverged: Vec<ConstraintId>,
    /// Work of prescribed motions by the impulses that removed velocities, J.
    pub(crate) work_j: f64,
}

impl Projection {
    /// The bodies of the constraint with the largest violation.
    pub(crate) fn pair(&self) -> Option<(usize, usize)> {
        self.farthest.as_ref().map(ConstraintId::bodies)
    }
}

/// Contacts of a group that are projected.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Projected<'a> {
    /// Those whose separation is made zero.
    pub(crate) touching: &'a [ContactId],
    /// Those whose relative velocity along the normal is made zero.
    pub(crate) held: &'a [ContactId],
    /// Those of them whose slip is made zero.
    pub(crate) sticking: &'a [ContactId],
    /// Rotations that are made zero.
    pub(crate) turns: &'a [(ContactId, Turn)],
}

/// Projects touching contacts of a group of bodies onto zero separation, then removes the relative velocities of the
/// held ones and the slips of those that stick. All are remainders of a step within `tolerance` or of the touch
/// distance. Contacts whose point has jumped are not projected. Remaining penetration is removed with all contacts of
/// the group's pairs.
///
/// # Errors
/// When the state is not finite.
pub(crate) fn project(
    model: &Model,
    states: &mut [BodyState],
    bodies: &[usize],
    Projected { touching, held, sticking, turns }: Projected<'_>,
    (tolerance, memory): (f64, &mut Memory),
) -> Result<Projection, ResponseError> {
    let start = states_of(states, bodies);
    let mut done = project_positions(model, states, bodies, touching)?;
    if done.exceeds_tolerance || done.is_partial || !(done.jumped.is_empty() && done.unconverged.is_empty()) {
        let is_contact = |constraint: &ConstraintId| constraint.contact().is_some();
        let contradict = done.jumped.is_empty() && done.unconverged.iter().any(is_contact);
        if contradict {
            // Contacts that cannot all have zero separation: the body stands on two levels. Only penetration is
            // removed.
            set_states(states, bodies, &start);
            done.moved_m = 0.0;
        }
        let mut pairs: Vec<_> = touching.iter().map(|id| (id.a, id.b)).collect();
        pairs.sort_unstable();
        pairs.dedup();
        done.moved_m += remove_overlap(model, states, bodies, &pairs, memory)?.moved_m;
        if contradict {
            // A gap may remain then, a penetration may not.
            done.unconverged.retain(|constraint| constraint.contact().is_none_or(|id| penetrates(model, states, id)));
        }
    }
    let (jumped, drifting): (Vec<_>, Vec<_>) = held.iter().copied().partition(|&id| {
        let kinematics = contact_kinematics::kinematics(model, states, id);
        kinematics.is_some_and(|kinematics| rate_exceeds_drift(model, states, id, &kinematics, tolerance))
    });
    done.jumped.extend(jumped.into_iter().map(ConstraintId::Contact));
    done.jumped.dedup_by_key(|contact| contact.bodies());
    let removed = project_velocities(model, states, bodies, (&drifting, sticking, turns), Removal::OfDrift)?;
    done.farthest = done.farthest.or(removed.fastest);
    done.work_j = removed.work_j;
    Ok(done)
}

/// Whether a contact penetrates by more than a projection may leave.
fn penetrates(model: &Model, states: &[BodyState], id: ContactId) -> bool {
    let left = UNCONVERGED_RELATIVE * tolerances::pair_size(model, id.a, id.b)
        + tolerances::rounding(model, states, id.a, id.b);
    contact_kinematics::kinematics(model, states, id).is_some_and(|kinematics| kinematics.geometry.separation < -left)
}

/// Whether a held contact approaches or separates faster than the drift of a step within `tolerance`: its point has
/// jumped.
pub(crate) fn rate_exceeds_drift(
    model: &Model,
    states: &[BodyState],
    id: ContactId,
    kinematics: &ContactKinematics,
    tolerance: f64,
) -> bool {
    let limit = JUMPED_SPEED.max(tolerance) * speed_of_pair(model, states, id);
    kinematics.separation_rate.abs() > limit
}

/// Removes the penetration of some pairs, without projecting their contacts onto zero separation.
///
/// # Errors
/// When the state is not finite.
pub(crate) fn remove_overlap(
    model: &Model,
    states: &mut [BodyState],
    bodies: &[usize],
    pairs: &[(usize, usize)],
    memory: &mut Memory,
) -> Result<Projection, ResponseError> {
    let overlaps = Overlaps::find(model, states, pairs);
    let farthest = overlaps.deepest.map(ConstraintId::Contact);
    let removed = overlaps.remove(model, states, (bodies, pairs), memory)?;
    Ok(Projection { moved_m: removed.moved_m, farthest, ..Projection::default() })
}

/// Sum of the speeds of a contact's bodies and of a fall over their size, m/s.
fn speed_of_pair(model: &Model, states: &[BodyState], id: ContactId) -> f64 {
    let fall = (model.gravity().length() * tolerances::pair_size(model, id.a, id.b)).sqrt();
    let speed = |body: usize| {
        let velocity = model.velocity(body, &states[body]);
        velocity.linear.length() + velocity.angular.length() * model.bodies[body].size
    };
    fall + speed(id.a) + speed(id.b)
}

/// Projects contacts onto zero separation.
///
/// # Errors
/// When the state is not finite.
pub(crate) fn project_positions(
    model: &Model,
    states: &mut [BodyState],
    bodies: &[usize],
    contacts: &[ContactId],
) -> Result<Projection, ResponseError> {
    let mut done = Projection::default();
    let mut moved: BTreeMap<usize, (DVec3, DVec3)> = BTreeMap::new();
    let mut allowance = None;
    let distance =
        |(id, geometry): &(ContactId, ContactGeometry)| (geometry.separation.abs(), ConstraintId::Contact(*id));
    let most = if contacts.is_empty() { MAX_CLOSING_STEPS } else { MAX_NEWTON_STEPS };
    for step in 0..=most {
        let geometries =
            contacts.iter().filter_map(|&id| Some((id, contact_kinematics::kinematics(model, states, id)?.geometry)));
        let drifted = |(id, geometry): &(ContactId, ContactGeometry)| {
            geometry.separation.abs() <= JUMPED_RELATIVE * tolerances::pair_size(model, id.a, id.b)
        };
        let (geometries, jumped): (Vec<_>, Vec<_>) = geometries.partition(drifted);
        done.jumped.extend(jumped.iter().map(|(id, _)| ConstraintId::Contact(*id)));
        let at_rounding = geometries.iter().all(|(id, geometry)| {
            geometry.separation.abs() <= ROUNDING_FRACTION * tolerances::rounding(model, states, id.a, id.b)
        });
        let bilaterals: Vec<Bilateral> = held::bilaterals(model, states, bodies).collect();
        let is_in_place = |bilateral: &Bilateral| {
            let (a, b) = bilateral.id.bodies();
            bilateral.gap() <= ROUNDING_FRACTION * tolerances::rounding(model, states, a, b)
        };
        // After a partial projection separations within the touch distance remain, and repetition would not reduce
        // them.
        if done.is_partial || (at_rounding && bilaterals.iter().all(is_in_place)) {
            break;
        }
        if step == most {
            let is_unconverged = |(id, geometry): &&(ContactId, ContactGeometry)| {
                geometry.separation.abs()
                    > UNCONVERGED_RELATIVE * tolerances::pair_size(model, id.a, id.b)
                        + tolerances::rounding(model, states, id.a, id.b)
            };
            done.unconverged.extend(geometries.iter().filter(is_unconverged).map(|(id, _)| ConstraintId::Contact(*id)));
            done.unconverged.extend(unconverged_bilaterals(model, states, bodies));
            break;
        }
        if done.farthest.is_none() {
            let gaps = bilaterals.iter().map(|bilateral| (bilateral.gap(), bilateral.id));
            done.farthest = farthest(geometries.iter().map(distance).chain(gaps));
        }
        done.exceeds_tolerance |= geometries.iter().any(|(id, geometry)| {
            geometry.separation.abs() > UNCONVERGED_RELATIVE * tolerances::pair_size(model, id.a, id.b)
        });
        let opened = opened(model, &bilaterals);
        let assembly = Assembly::with_bilaterals(model, (states, bodies), geometries.iter().copied(), bilaterals)?;
        let separations = assembly.gaps(geometries.iter().map(|(_, g)| g.separation));
        let size =
            geometries.iter().map(|(id, _)| tolerances::pair_size(model, id.a, id.b)).fold(f64::INFINITY, f64::min);
        // All Newton steps share one allowance; otherwise nearly dependent rows could use all of it in every step.
        let allowance = *allowance.get_or_insert_with(|| allowed_change(&separations, size));
        let displacement =
            largest_change(model, moved.iter().map(|(&body, &(linear, angular))| (body, linear, angular)));
        let allowed = (allowance - displacement).max(0.0);
        let limits = Limits { allowed, negligible: NEGLIGIBLE_RELATIVE * size, opened };
        let Removed { reactions: multipliers, is_partial, .. } = cancel(model, &assembly, &separations, limits)?;
        done.is_partial |= is_partial;
        move_by(states, &mut moved, assembly.split(&assembly.problem.response(&multipliers)?));
    }
    done.jumped.dedup_by_key(|contact| contact.bodies());
    done.unconverged.dedup_by_key(|constraint| constraint.bodies());
    done.moved_m = largest_change(model, moved.into_iter().map(|(body, (linear, angular))| (body, linear, angular)));
    Ok(done)
}

/// Moves bodies by a displacement and a rotation vector each, and adds these to what they have been moved by.
fn move_by(
    states: &mut [BodyState],
    moved: &mut BTreeMap<usize, (DVec3, DVec3)>,
    displacements: impl Iterator<Item = (usize, DVec3, DVec3)>,
) {
    for (body, linear, angular) in displacements {
        let pose = &mut states[body].pose;
        pose.translation += linear;
        pose.rotation = Rotation::from_rotation_vector(angular) * pose.rotation;
        let sum = moved.entry(body).or_default();
        *sum = (sum.0 + linear, sum.1 + angular);
    }
}

/// The largest gap of these constraints in relation to the size of their bodies (no unit).
fn opened(model: &Model, bilaterals: &[Bilateral]) -> f64 {
    let of = |bilateral: &Bilateral| {
        let (a, b) = bilateral.id.bodies();
        let size = tolerances::pair_size(model, a, b);
        if size > 0.0 { bilateral.gap() / size } else { 0.0 }
    };
    bilaterals.iter().map(of).fold(0.0, f64::max)
}

/// The bilateral constraints whose gap exceeds rounding after the last Newton step.
fn unconverged_bilaterals<'a>(
    model: &'a Model,
    states: &'a [BodyState],
    bodies: &'a [usize],
) -> impl Iterator<Item = ConstraintId> + 'a {
    let is_unconverged = |bilateral: &Bilateral| {
        let (a, b) = bilateral.id.bodies();
        bilateral.gap()
            > UNCONVERGED_RELATIVE * tolerances::pair_size(model, a, b) + tolerances::rounding(model, states, a, b)
    };
    held::bilaterals(model, states, bodies).filter(is_unconverged).map(|bilateral| bilateral.id)
}

/// The constraint of the largest of some distances or speeds.
fn farthest(distances: impl Iterator<Item = (f64, ConstraintId)>) -> Option<ConstraintId> {
    distances.max_by(|x, y| x.0.total_cmp(&y.0)).map(|(_, constraint)| constraint)
}

/// Result of the projection of velocities.
#[derive(Debug, Default)]
pub(crate) struct RemovedVelocities {
    /// The constraint with the largest relative velocity; none when all were zero.
    pub(crate) fastest: Option<ConstraintId>,
    /// The impulses of the contacts along their normals, on A, N s; empty when all velocities were zero.
    pub(crate) impulses: Vec<(ContactId, f64)>,
    /// Work of prescribed motions by the impulses, J.
    pub(crate) work_j: f64,
    /// The rows and their multipliers, N s; none when all velocities were zero.
    held: Option<(Assembly, Vec<f64>)>,
}

impl RemovedVelocities {
    /// The impulses of bilateral constraints, N s.
    pub(crate) fn reactions(&self) -> impl Iterator<Item = (&Bilateral, Reaction)> + Clone {
        self.held.iter().flat_map(|(assembly, multipliers)| assembly.reactions(multipliers))
    }
}

/// How relative velocities are removed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Removal {
    /// Completely: velocities of the actual motion, at the end of bounces.
    Complete,
    /// Partially if contacts are nearly dependent: errors of rounding and of a step.
    OfDrift,
}

/// Removes the relative velocities of contacts, the slips of those that stick, and the velocities of pivots.
///
/// # Errors
/// When the state is not finite.
pub(crate) fn project_velocities(
    model: &Model,
    states: &mut [BodyState],
    bodies: &[usize],
    (contacts, sticking, turns): (&[ContactId], &[ContactId], &[(ContactId, Turn)]),
    removal: Removal,
) -> Result<RemovedVelocities, ResponseError> {
    let contacts: Vec<_> =
        contacts.iter().filter_map(|&id| Some((id, contact_kinematics::kinematics(model, states, id)?))).collect();
    let slips: Vec<(TangentRow, f64)> = sticking.iter().flat_map(|&id| slip_rows(model, states, id)).collect();
    let turns: Vec<(RotationRow, f64)> = turns.iter().flat_map(|&turn| turn_rows(model, states, turn)).collect();
    let bilaterals: Vec<Bilateral> = held::bilaterals(model, states, bodies).collect();
    if contacts.iter().all(|(_, k)| k.separation_rate == 0.0)
        && slips.iter().all(|&(_, slip)| slip == 0.0)
        && turns.iter().all(|&(_, rate)| rate == 0.0)
        && bilaterals.iter().all(Bilateral::stands)
    {
        return Ok(RemovedVelocities::default());
    }
    let geometries = contacts.iter().map(|(id, k)| (*id, k.geometry));
    let mut assembly = Assembly::with_bilaterals(model, (states, bodies), geometries, bilaterals)?;
    assembly.push_tangents(states, slips.iter().map(|&(row, _)| row))?;
    assembly.push_rotations(turns.iter().map(|&(row, _)| row))?;
    let mut rates = assembly.rates(contacts.iter().map(|(_, k)| k.separation_rate));
    rates.extend(slips.iter().map(|&(_, slip)| slip));
    rates.extend(turns.iter().map(|&(_, rate)| rate));
    let speed = contacts.iter().map(|&(id, _)| speed_of_pair(model, states, id)).fold(f64::INFINITY, f64::min);
    let allowed = match removal {
        Removal::Complete => f64::INFINITY,
        Removal::OfDrift => allowed_change(&rates, speed),
    };
    let limits = Limits { allowed, negligible: 0.0, opened: 0.0 };
    let multipliers = cancel(model, &assembly, &rates, limits)?.reactions;
    let along_tangents = slips.iter().zip(multipliers.iter().skip(assembly.first_tangent()));
    let along_tangents = along_tangents.map(|((row, _), &p)| (row.id, &row.along, p));
    let impulses = contacts.iter().zip(&multipliers).map(|((id, k), &p)| (*id, &k.geometry, p)).chain(along_tangents);
    apply_impulses(model, states, impulses.clone());
    apply_reactions(model, states, assembly.reactions(&multipliers));
    let moments: Vec<_> = assembly.of_rotations(&multipliers).map(|(row, p)| (row.id, row.axis * p)).collect();
    apply_moments(model, states, moments.iter().copied());
    let along_tangents = slips.iter().zip(multipliers.iter().skip(assembly.first_tangent()));
    let along_tangents = along_tangents.map(|((row, _), &p)| (row.id, &row.along, p));
    let work_j = prescribed::prescribed_work(model, states, impulses)
        + moving_surfaces::surface_work(model, states, along_tangents)
        + bilateral::driven_work(model, states, assembly.reactions(&multipliers))
        + moment_work(model, states, moments.into_iter());
    let speeds = contacts.iter().map(|(id, k)| (k.separation_rate.abs(), ConstraintId::Contact(*id)));
    let bilaterals = assembly.bilaterals().iter().map(|bilateral| (bilateral.speed(), bilateral.id));
    let fastest = farthest(speeds.chain(bilaterals));
    let impulses = contacts.iter().zip(&multipliers).map(|((id, _), &p)| (*id, p)).collect();
    Ok(RemovedVelocities { fastest, impulses, work_j, held: Some((assembly, multipliers)) })
}

/// Rows along the tangents of a contact, each with the slip along it, m/s.
fn slip_rows(model: &Model, states: &[BodyState], id: ContactId) -> Vec<(TangentRow, f64)> {
    let both = contact_kinematics::kinematics(model, states, id)
        .zip(contact_kinematics::tangential_kinematics(model, states, id));
    let rows = both.map(|(kinematics, terms)| {
        let row = |&tangent: &DVec3| {
            let row = TangentRow::new(id, &kinematics.geometry, &terms, tangent);
            (row, tangent.dot(terms.slip_velocity))
        };
        slip_directions::slip_directions(model, (id.a, id.b)).tangents(&terms.basis).iter().map(row).collect::<Vec<_>>()
    });
    rows.into_iter().flatten().collect()
}

/// Rows of a rotation, each with its rate, m/s.
fn turn_rows(model: &Model, states: &[BodyState], (id, turn): (ContactId, Turn)) -> Vec<(RotationRow, f64)> {
    let both = contact_kinematics::kinematics(model, states, id)
        .zip(contact_kinematics::tangential_kinematics(model, states, id));
    let rows = both.map(|(kinematics, terms)| {
        turn.axes(kinematics.geometry.normal, (&terms.basis, slip_directions::slip_directions(model, (id.a, id.b))))
    });
    let row = |axis| {
        let row = RotationRow::about(model, id, axis);
        (row, row.rate(model, states))
    };
    rows.into_iter().flatten().map(row).collect()
}

/// Reactions whose response cancels `values` on all rows, or a part of them.
fn cancel(model: &Model, assembly: &Assembly, values: &[f64], limits: Limits) -> Result<Removed, ResponseError> {
    let change_of = |response: &[f64]| largest_change(model, assembly.split(response));
    remove((&assembly.problem, assembly.joint_rows()), values, limits, change_of)
}

/// The allowed change to cancel `values`: of the order of the largest value, or negligible against `scale`.
fn allowed_change(values: &[f64], scale: f64) -> f64 {
    (PARTIAL_RELATIVE * scale).max(PARTIAL_AMPLIFICATION * largest(values))
}

/// The largest magnitude of some values.
fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}
