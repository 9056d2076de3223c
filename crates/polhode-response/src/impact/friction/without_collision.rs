//! Impacts without a collision, at one contact or several (Painleve).
//!
//! Over a time `h` the bodies press on each other with velocities `h b`, `b` the accelerations without contact forces,
//! and impulses with `u+ = u- + h b + G p` obey Coulomb's law. Where finite forces exist, `p` tends to zero with `h`;
//! where none does, it tends to the impulse of the jam. Two cone problems, with a small `h` and twice that, give the
//! limit by extrapolation: `p` is smooth in `h`, and what is left is of the order of its square. `h = 0` itself would
//! not do, as `p = 0` is then an answer too.
//!
//! Source: Stewart 2000, for the limit of steps of time; Genot and Brogliato 1999.

use super::law::RestitutionLaw;
use super::part::{Part, Struck};
use super::sequence::strike_alone;
use crate::dense::kernels::largest;
use crate::error::ResponseError;
use crate::impact::ImpactStatus;

/// The largest velocity `h b` of a contact over the largest velocity (no unit): small beside that of the jam, and large
/// beside the residual of the cone problem.
const PRESSED: f64 = 1e-7;

/// Strikes the contacts of a part that the accelerations of its rows press together, where no finite forces resist
/// them. One contact alone is struck by the law of `single`; by none where it stands for several.
pub(super) fn strike_without_collision(
    part: &mut Part,
    struck: &mut Struck,
    accelerations: &[f64],
    single: Option<RestitutionLaw>,
) -> Result<(), ResponseError> {
    let contacts = part.touching();
    let pressed: Vec<f64> =
        (0..part.contacts.len()).map(|block| accelerations[part.normal_row(block)].min(0.0)).collect();
    let most = contacts.iter().map(|&block| -pressed[block]).fold(0.0, f64::max);
    let speed = largest(&struck.velocities);
    if most <= 0.0 || speed <= 0.0 {
        return Ok(());
    }
    let mut touching = struck.velocities.clone();
    for &block in &contacts {
        touching[part.normal_row(block)] = touching[part.normal_row(block)].max(0.0);
    }
    if let ([block], Some(law)) = (&contacts[..], single) {
        let block = *block;
        let row = part.normal_row(block);
        // What rounding leaves of a touching contact's normal velocity is no approach.
        struck.velocities[row] = 0.0;
        part.restitution[block] = 0.0;
        strike_alone(part, struck, block, law)?;
        if struck.impulses.iter().any(|impulse| *impulse != 0.0) {
            part.status = part.status.max(ImpactStatus::Separated);
        }
        return Ok(());
    }
    let all: Vec<usize> = (0..part.contacts.len()).collect();
    let constant = |part: &Part, steps: f64| {
        let mut constant = touching.clone();
        for &block in &contacts {
            constant[part.normal_row(block)] += steps * PRESSED * speed * pressed[block] / most;
        }
        constant
    };
    let first = part.solve(&all, &constant(part, 1.0), None)?;
    let change = part.after(&vec![0.0; touching.len()], &first.impulses);
    // Finite forces have impulses of the size of what pressed the contacts together.
    if first.is_solved && largest(&change) <= 1e3 * PRESSED * speed {
        return Ok(());
    }
    let second = part.solve(&all, &constant(part, 2.0), Some(&first.impulses))?;
    if !(first.is_solved && second.is_solved) {
        part.not_solved();
        return Ok(());
    }
    let mut impulses: Vec<f64> = first.impulses.iter().zip(&second.impulses).map(|(p, q)| 2.0 * p - q).collect();
    for &block in &contacts {
        part.put_into_cone(block, &mut impulses);
    }
    let mut after = part.after(&touching, &impulses);
    for &block in &contacts {
        let row = part.normal_row(block);
        after[row] = if impulses[row] > 0.0 { 0.0 } else { after[row].max(0.0) };
    }
    part.hold_joints(&mut after);
    struck.add(part, &impulses, after);
    part.status = part.status.max(ImpactStatus::Separated);
    Ok(())
}
