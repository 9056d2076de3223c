//! The micro-collision of contacts that stick: it reverses the slip too (Mirtich).
//!
//! What rests on a slope slips freely between two collisions. Collisions that only stopped the slip would let it creep,
//! by `g h sin(slope)/2` (m/s) for one every `h` (s). Mirtich gives a micro-collision the impulse that reverses the
//! whole velocity of the contact, `p = -2 K^-1 u`, where that is in the cone of friction, and the impulse of an
//! ordinary collision where not. The body then goes uphill as long as downhill.
//!
//! Here, for any number of contacts: with `p_0` the impulses that stop all contacts that carry (the cone problem
//! without restitution) and stick them, `p = (1 + e) p_0` and `u+ = u_0 + e (u_0 - u-)`. `e` is the largest restitution
//! of those contacts; where it is 1, as of bodies that touch in micro-collisions, this is Mirtich's rule, and no corner
//! sinks below touch. `p` is in all cones with `p_0`; the energy changes by `1 - e^2`
//! times what a stop takes.
//!
//! It does not apply where a contact slips, carries with a velocity left, or would be left approaching.
//!
//! Source: Mirtich 1996, section 3.5 (p. 88).

use super::multiple::MultipleFrictionalImpact;
use super::multiple_outcome::MultipleImpact;
use crate::error::ResponseError;
use crate::impact::ImpactStatus;

/// The impact that reverses the velocities of all contacts that carry, of blocks of which the first `contacts` are
/// contacts; none where one of them does not stick.
///
/// # Errors
/// Those of [`MultipleFrictionalImpact::resolve`].
pub(crate) fn reversal(
    impact: &MultipleFrictionalImpact<'_>,
    contacts: usize,
) -> Result<Option<MultipleImpact>, ResponseError> {
    let blocks = impact.contacts;
    let none = vec![0.0; impact.restitution.len()];
    let stop = MultipleFrictionalImpact { restitution: &none, ..*impact }.resolve()?;
    if stop.status != ImpactStatus::Separated {
        return Ok(None);
    }
    let carries = |block: &usize| stop.impulses[blocks.range(*block).start] > 0.0;
    let sticks = |block: usize| stop.velocities_after[blocks.range(block)].iter().all(|u| *u == 0.0);
    if !(0..contacts).filter(carries).all(sticks) {
        return Ok(None);
    }
    let e = (0..contacts).filter(carries).map(|block| impact.restitution[block]).fold(0.0, f64::max);
    let before = blocks.constant();
    let velocities_after: Vec<f64> =
        stop.velocities_after.iter().zip(before).map(|(stopped, before)| stopped + e * (stopped - before)).collect();
    let normal = |block: usize| velocities_after[blocks.range(block).start];
    if (0..contacts).any(|block| normal(block) < 0.0) {
        return Ok(None);
    }
    let share = 1.0 - e * e;
    let scaled = |numbers: &[f64], by: f64| numbers.iter().map(|number| by * number).collect();
    let mut reversed = stop.clone();
    reversed.impulses = scaled(&stop.impulses, 1.0 + e);
    reversed.normal_work = scaled(&stop.normal_work, share);
    reversed.friction_work = scaled(&stop.friction_work, share);
    reversed.energy_change = share * stop.energy_change;
    reversed.velocities_after = velocities_after;
    Ok(Some(reversed))
}
