//! The rows of a time step's problems: in its middle and at its start (`sustained.rs`, `closing.rs` have their
//! equations).

use super::consistent_rows::{make_consistent, remove_contradictions};
use super::contacts::{NearContact, kinematics_at_point};
use super::middle::Problem;
use super::row::Row;
use super::shared_work::Kicked;
use super::sustained_friction::TangentialRow;
use crate::joints::joint_friction::{self, Pressed};
use crate::model::{Loads, Model, tolerances};
use crate::rows::assembly::Assembly;
use polhode_contact::ContactKinematics;
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;
use polhode_response::solve::way;

/// Error of a separation as a fraction of the rounding of two poses (eight units in the last place): the remainder of
/// the projection. In a short step it corresponds to a considerable velocity.
const SEPARATION_ROUNDING: f64 = 0.25;

/// The contacts in the middle of the step; those whose features no longer define a contact are left out.
pub(super) fn rows(
    model: &Model,
    kicked: Kicked<'_>,
    (near, slips): (&[NearContact], &[f64]),
    (problem, t, h): (Problem, f64, f64),
) -> Result<Vec<Row>, ResponseError> {
    let Kicked { states, bodies, .. } = kicked;
    let here: Vec<(usize, ContactKinematics)> = near
        .iter()
        .enumerate()
        .filter(|(_, near)| !near.is_awaited)
        .filter(|(_, near)| problem == Problem::Sustained || joint_friction::pressed(model, states, near.id).is_none())
        .filter_map(|(contact, near)| Some((contact, kinematics_at_point(model, states, near.id)?)))
        .filter(|(contact, kinematics)| near[*contact].is_same(kinematics))
        .collect();
    if here.is_empty() {
        return Ok(Vec::new());
    }
    let geometries = here.iter().map(|&(contact, kinematics)| (near[contact].id, kinematics.geometry));
    // Accelerations without the forces of joints: their rows are not asked for.
    let mut assembly = Assembly::with_bilaterals(model, (states, bodies), geometries, Vec::new())?;
    let of = |(contact, kinematics): &(usize, ContactKinematics)| {
        TangentialRow::of(model, states, near[*contact].id, (kinematics, kicked))
    };
    let friction: Vec<_> = here.iter().map(of).collect();
    assembly.push_tangents(states, friction.iter().flatten().flat_map(TangentialRow::along))?;
    let free = assembly.free_accelerations(model, states, &Loads::default());
    let contacts = here.iter().map(|(contact, kinematics)| (near[*contact].id, kinematics));
    let accelerations = assembly.acceleration_constants(model, t, states, &free, contacts)?;
    let mut slip_rates = accelerations[assembly.first_tangent()..].iter().copied();
    let mut with_rates = |row: TangentialRow, contact: usize, acceleration: f64| {
        let mut rates = [0.0; 2];
        rates.iter_mut().take(row.tangents()).zip(slip_rates.by_ref()).for_each(|(rate, found)| *rate = found);
        if problem == Problem::Closing {
            return Some(row);
        }
        Some(row.with_rates((slips[contact], rates), h, 0.5 * h * acceleration))
    };
    let friction = friction.into_iter().zip(&here).zip(&accelerations);
    let friction: Vec<_> =
        friction.map(|((row, (contact, _)), &acceleration)| with_rates(row?, *contact, acceleration)).collect();
    let row = |(((contact, kinematics), acceleration), friction): (((usize, ContactKinematics), f64), _)| {
        let of = (contact, kinematics, friction);
        match problem {
            Problem::Closing => row_at_start(model, states, near, of, h),
            Problem::Sustained => row_in_middle(model, kicked, near, of, (0.5 * h * acceleration, h)),
        }
    };
    let mut rows: Vec<Row> = here.into_iter().zip(accelerations).zip(friction).map(row).collect();
    let pair = |row: &Row| (near[row.contact].id.a, near[row.contact].id.b);
    let is_of_many = way::are_many(rows.len());
    for of_pair in rows.chunk_by_mut(|x, y| pair(x) == pair(y)) {
        if is_of_many {
            make_consistent(of_pair);
        } else {
            remove_contradictions(of_pair);
        }
    }
    Ok(rows)
}

/// The row of a contact in the problem in the middle of a step of `h` (s), with `h/2 a` (m/s).
fn row_in_middle(
    model: &Model,
    kicked: Kicked<'_>,
    near: &[NearContact],
    (contact, kinematics, friction): (usize, ContactKinematics, Option<TangentialRow>),
    (half_fall, h): (f64, f64),
) -> Row {
    let id = near[contact].id;
    let rounding = 2.0 * SEPARATION_ROUNDING * tolerances::rounding(model, kicked.states, id.a, id.b) / h;
    let gap_bound = 2.0 * kinematics.geometry.separation / h + 0.5 * half_fall;
    // A gap within rounding counts as zero.
    let gap_bound = if gap_bound <= half_fall + rounding { half_fall } else { gap_bound };
    let geometry = &kinematics.geometry;
    let rate_before = kinematics.separation_rate - geometry.normal.dot(kicked.change_at(id, geometry.point));
    // What presses a joint with friction gives the impulse of its force.
    let bound = match joint_friction::pressed(model, kicked.states, id) {
        Some(Pressed { force, compliance, .. }) => -compliance * force * h,
        None => gap_bound.max(rate_before),
    };
    let problem = Problem::Sustained;
    Row { contact, problem, kinematics, rate_before, bound, least_bound: rate_before, half_fall, rounding, friction }
}

/// The row of a contact in the problem at the start of a step of `h` (s): it may approach as fast as closes its gap.
/// All such bounds are at least zero, so that the impulses `p` with `p.(u+ + r) = 0` give no energy:
/// `p.(u- + u+)/2 = -r.p - p.G p/2`.
fn row_at_start(
    model: &Model,
    states: &[BodyState],
    near: &[NearContact],
    (contact, kinematics, friction): (usize, ContactKinematics, Option<TangentialRow>),
    h: f64,
) -> Row {
    let id = near[contact].id;
    let rounding = SEPARATION_ROUNDING * tolerances::rounding(model, states, id.a, id.b) / h;
    let bound = ((kinematics.geometry.separation - near[contact].kept_off) / h).max(0.0);
    let bound = if bound <= rounding { 0.0 } else { bound };
    let rate_before = kinematics.separation_rate;
    Row {
        contact,
        problem: Problem::Closing,
        kinematics,
        rate_before,
        bound,
        least_bound: 0.0,
        half_fall: 0.0,
        rounding,
        friction,
    }
}
