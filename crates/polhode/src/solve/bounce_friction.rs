//! The end of bounces that are too small to resolve (`accurate/ending_bounces.rs`), with the friction that belongs to
//! it.
//!
//! Bounces that end at once at a speed `w` would have lasted for `T = 2 w / (a (1 - e))` and pressed by `m (a T - w)`
//! in that time. The contact that takes their place presses by `m a T`. The difference `m w` is the impulse `p = -m w`
//! (N s) along the normal that ends them, a pull. If the contact slides, friction takes `mu m w` too much from its slip
//! in that time. The end of the bounces gives it back: with an impulse `p` along the normal goes one of
//!
//! `-mu p t`
//!
//! with the direction `t` of the slip, as by Coulomb's law. End and held contact together then obey this law, and the
//! slip after the time `T` is that after the bounces. The energy is booked as friction, which takes it again within
//! `T`.
//!
//! The impulses along the normals make all normal velocities zero, those along the tangents included; both are found in
//! rounds. Without a contact that slides with friction one round is all.
//!
//! Source: the sums of the geometric sequence of bounces (thesis 3.3), and Coulomb's law.
//!
//! Limits: slips slower than the bounces get nothing, because rest may be nearer than the end of the bounces; nor do
//! rolling and spinning, whose moments of friction are smaller by their length than those of the slip. Where the rounds
//! do not converge, as where a slip presses its own contact, nothing is given back.

use crate::collision::{contact_kinematics, moving_surfaces};
use crate::identity::contact_id::ContactId;
use crate::model::states_of::{set_states, states_of};
use crate::model::{Model, prescribed};
use crate::rows::assembly::{TangentRow, apply_impulses};
use crate::rows::frictional_contact::FrictionalContact;
use crate::solve::projection::{Removal, RemovedVelocities, project_velocities};
use polhode_contact::ContactGeometry;
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;

/// Rounds have converged when the impulses along tangents change by less than this part of them (no unit, 1e-5 to
/// 1e-2): above the error with which the impulses of contacts that depend on each other are found. They are some 1e-5
/// m/s.
const SETTLED_IMPULSES: f64 = 1e-4;

/// Most rounds: a coupling of a half takes fourteen.
const MOST_ROUNDS: usize = 32;

/// What the end of some bounces took.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct EndedBounces {
    /// Work of prescribed motions by its impulses, J.
    pub(crate) work_j: f64,
    /// Energy lost to friction, J: negative, because it is given back.
    pub(crate) friction_j: f64,
}

/// A contact that slides with friction.
#[derive(Debug, Clone, Copy)]
struct Sliding {
    /// Its row along what friction opposes.
    row: TangentRow,
    coefficient: f64,
}

impl Sliding {
    /// A contact whose slip is faster than `slowest` (m/s); none for another one, or without friction.
    fn of(model: &Model, states: &[BodyState], id: ContactId, slowest: f64) -> Option<Self> {
        let geometry = contact_kinematics::kinematics(model, states, id)?.geometry;
        let own = FrictionalContact::of(model, states, (id, geometry), None)?;
        let slip = own.terms.slip_velocity;
        let direction = (slip.length() > slowest).then(|| slip.try_normalize())??;
        let sliding = own.sliding_along(direction).sliding?;
        Some(Self { row: own.row_along(sliding.row), coefficient: sliding.coefficient })
    }

    /// The impulse of friction on A along the row, N s, with those along the normals.
    fn impulse(&self, removed: &RemovedVelocities) -> f64 {
        let own = removed.impulses.iter().find(|(id, _)| *id == self.row.id);
        own.map_or(0.0, |(_, normal)| -self.coefficient * normal)
    }

    /// Its slip along the row, m/s.
    fn slip(&self, model: &Model, states: &[BodyState]) -> f64 {
        let terms = contact_kinematics::tangential_kinematics(model, states, self.row.id);
        terms.map_or(0.0, |terms| self.row.along.normal.dot(terms.slip_velocity))
    }
}

/// Sets the relative velocities along the normals of these contacts to zero, of which the fastest bounces at the speed
/// `fastest` (m/s), with the friction that belongs to it.
///
/// # Errors
/// When a state is not finite.
pub(crate) fn end_bounces(
    model: &Model,
    states: &mut [BodyState],
    bodies: &[usize],
    (contacts, fastest): (&[ContactId], f64),
) -> Result<EndedBounces, ResponseError> {
    let start = states_of(states, bodies);
    let sliding: Vec<Sliding> = contacts.iter().filter_map(|&id| Sliding::of(model, states, id, fastest)).collect();
    let before: Vec<f64> = sliding.iter().map(|one| one.slip(model, states)).collect();
    let mut rubbed = vec![0.0; sliding.len()];
    for _ in 0..MOST_ROUNDS {
        set_states(states, bodies, &start);
        apply_impulses(model, states, along_tangents(&sliding, &rubbed));
        let removed = project_velocities(model, states, bodies, (contacts, &[], &[]), Removal::Complete)?;
        let next: Vec<f64> = sliding.iter().map(|one| one.impulse(&removed)).collect();
        let largest = next.iter().fold(0.0, |most: f64, impulse| most.max(impulse.abs()));
        let change = next.iter().zip(&rubbed).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        if change <= SETTLED_IMPULSES * largest {
            let work_j = removed.work_j
                + prescribed::prescribed_work(model, states, along_tangents(&sliding, &rubbed))
                + moving_surfaces::surface_work(model, states, along_tangents(&sliding, &rubbed));
            let lost = |((one, before), impulse): ((&Sliding, &f64), &f64)| {
                -0.5 * impulse * (before + one.slip(model, states))
            };
            let friction_j = sliding.iter().zip(&before).zip(&rubbed).map(lost).sum();
            return Ok(EndedBounces { work_j, friction_j });
        }
        rubbed = next;
    }
    set_states(states, bodies, &start);
    let removed = project_velocities(model, states, bodies, (contacts, &[], &[]), Removal::Complete)?;
    Ok(EndedBounces { work_j: removed.work_j, friction_j: 0.0 })
}

/// Impulses along tangents, which stand in the place of normals.
fn along_tangents<'a>(
    sliding: &'a [Sliding],
    impulses: &'a [f64],
) -> impl Iterator<Item = (ContactId, &'a ContactGeometry, f64)> + Clone {
    sliding.iter().zip(impulses).map(|(one, &impulse)| (one.row.id, &one.row.along, impulse))
}
