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
//! Method: rotations are rows `l w` of the block of their contact, with a length `l` of the pair: their reactions `M / l` are
//! forces, and their friction is the number `c / l` (`interaction/rotation_row.rs`). The solver finds slip, rolling and
//! spinning together ([`polhode_response::friction::FrictionBlock::Resisted`]). A rotation that turns already has one row, along
//! its direction.

use super::friction_blocks::RowSolution;
use crate::collision::contact_set::ContactId;
use crate::collision::turn::Turn;
use crate::world::World;
use crate::{Momentum, MomentumSum};
use polhode_dynamics::BodyState;
use polhode_response::friction::ContactStatus;
use polhode_spatial::DVec3;
use std::ops::Range;

/// A rotation that friction resists, among the rows of a problem.
#[derive(Debug, Clone)]
pub(crate) struct ResistedRotation {
    /// The normal row of its contact, which is the place of its block too.
    pub(crate) normal: usize,
    /// Which rotation it is.
    pub(crate) turn: Turn,
    /// Its own rows.
    pub(crate) rows: Range<usize>,
    /// The length of its friction over that of its rows (no unit).
    pub(crate) friction: f64,
    /// Whether the bodies turn already, along its one row.
    pub(crate) turns: bool,
}

impl ResistedRotation {
    /// The direction in its rows in which the bodies turn, or begin to turn; none while friction holds them. A moment opposes
    /// it; where nothing presses there is no moment, and the rotation follows its acceleration.
    pub(crate) fn direction(&self, solved: &RowSolution) -> Option<Vec<f64>> {
        if self.turns {
            return Some(vec![1.0; self.rows.len()]);
        }
        let part = solved.parts.get(self.normal).map(|[_, rolls, spins]| match self.turn {
            Turn::Rolling => *rolls,
            Turn::Spinning => *spins,
        });
        if part == Some(ContactStatus::Stick) {
            return None;
        }
        let unit = |parts: Vec<f64>| {
            let size = parts.iter().fold(0.0, |sum: f64, part| libm::hypot(sum, *part));
            (size > 0.0).then(|| parts.iter().map(|part| part / size).collect())
        };
        let own =
            |of: &[f64], sign: f64| self.rows.clone().filter_map(|row| of.get(row)).map(|part| sign * part).collect();
        unit(own(&solved.reactions, -1.0)).or_else(|| unit(own(&solved.velocities, 1.0)))
    }
}

/// Applies impulses of moments on A (N m s, world) to the momenta of the bodies of their contacts.
pub(crate) fn apply_moments(
    world: &World,
    states: &mut [BodyState],
    moments: impl Iterator<Item = (ContactId, DVec3)>,
) {
    for (id, moment) in moments {
        for (body, signed) in [(id.a, moment), (id.b, -moment)] {
            if world.bodies[body].rigid.is_some() {
                states[body].angular_momentum += signed;
            }
        }
    }
}

/// Momentum that moments on A (N m s, N m) give to the bodies that move: only contacts with immovable bodies
/// contribute.
pub(crate) fn moment_support(world: &World, moments: impl Iterator<Item = (ContactId, DVec3)>) -> Momentum {
    let mut sum = MomentumSum::default();
    for (id, moment) in moments {
        let sign = match (world.carries_momentum(id.a), world.carries_momentum(id.b)) {
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
    world: &World,
    states: &[BodyState],
    moments: impl Iterator<Item = (ContactId, DVec3)>,
) -> f64 {
    let rotation = |body: usize| {
        if world.trajectory(body).is_some() { world.velocity(body, &states[body]).angular } else { DVec3::ZERO }
    };
    moments.map(|(id, moment)| -moment.dot(rotation(id.a) - rotation(id.b))).sum()
}
