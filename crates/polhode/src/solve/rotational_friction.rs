//! Friction of rolling and of spinning: moments at a contact.
//!
//! A contact with the normal force `f_n` resists the angular velocity `w` of A relative to B. With `w_n` its part
//! along the normal and `w_t` the rest,
//!
//! `M_roll = -c_r f_n w_t / |w_t|`, and `|M_roll| <= c_r f_n` where `w_t = 0`;
//! `M_spin = -c_s f_n w_n / |w_n|`, and `|M_spin| <= c_s f_n` where `w_n = 0`.
//!
//! The lengths `c_r`, `c_s` (m) are the friction of rolling and of spinning. Source: docs/REFERENCES.md, Johnson 1985;
//! Leine and Glocker 2003. Assumptions: the contact is a point, moments of friction do not depend on the speed, and
//! the impulse of a moment at an impact is bounded by the same length times the normal impulse.
//!
//! Method: rotations are rows `l w` of the block of their contact, with a length `l` of the pair: their reactions
//! `M / l` are forces, and their friction is the number `c / l` (`rows/rotation_row.rs`, `rows/resisted_rotation.rs`).
//! The solver finds slip, rolling and spinning together ([`polhode_response::friction::Law::Resist`]). A rotation that
//! turns already has one row, along its direction.

use crate::identity::contact_id::ContactId;
use crate::model::{Model, prescribed};
use crate::report::momentum_ledger::{Momentum, MomentumSum};
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// Applies impulses of moments on A (N m s, world) to the momenta of the bodies of their contacts.
pub(crate) fn apply_moments(
    model: &Model,
    states: &mut [BodyState],
    moments: impl Iterator<Item = (ContactId, DVec3)>,
) {
    for (id, moment) in moments {
        for (body, signed) in [(id.a, moment), (id.b, -moment)] {
            if model.bodies[body].rigid.is_some() {
                states[body].angular_momentum += signed;
            }
        }
    }
}

/// Momentum that moments on A (N m s, N m) give to the bodies that move: only contacts with immovable bodies
/// contribute.
pub(crate) fn moment_support(model: &Model, moments: impl Iterator<Item = (ContactId, DVec3)>) -> Momentum {
    let mut sum = MomentumSum::default();
    for (id, moment) in moments {
        let sign = match (model.carries_momentum(id.a), model.carries_momentum(id.b)) {
            (true, false) => 1.0,
            (false, true) => -1.0,
            _ => continue,
        };
        sum.add(Momentum { linear: DVec3::ZERO, angular: moment * sign });
    }
    sum.value()
}

/// Work (J; power, W) of kinematic bodies by moments on A (N m s; N m).
pub(crate) fn moment_work(
    model: &Model,
    states: &[BodyState],
    moments: impl Iterator<Item = (ContactId, DVec3)>,
) -> f64 {
    let rotation = |body: usize| {
        if prescribed::trajectory(model, body).is_some() {
            model.velocity(body, &states[body]).angular
        } else {
            DVec3::ZERO
        }
    };
    moments.map(|(id, moment)| -moment.dot(rotation(id.a) - rotation(id.b))).sum()
}
