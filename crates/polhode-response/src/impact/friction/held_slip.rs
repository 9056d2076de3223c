//! Friction of contacts without slip, where their normal forces are given (Tresca's law): which stick, and where the
//! others go.
//!
//! With normal forces `r_i` and the forces of all that slips already, find `q_i`, `|q_i| <= mu_i r_i`, with
//! `a = c + G_tt q` and either `a_i = 0` or `q_i = -mu_i r_i a_i/|a_i|`: the minimum of the convex `q.G_tt q/2 + c.q`
//! on discs, so that `a` exists and is unique, however many contacts hold the same body (`q` is not, then). Forces in N
//! or impulses in N s, `G` in 1/kg.
//!
//! Method: contact by contact ([`Coulomb::leaving_zero_slip`], exact for one), from the answer before, until nothing
//! changes.
//!
//! Source: Duvaut and Lions 1972 (friction with given normal forces).

use super::collision_matrix::CollisionMatrix;
use super::coulomb::{Coulomb, ZeroSlip};
use super::plane::{self, Tangent};
use super::spring_contact::SpringContact;
use crate::tolerances::LEAST_CHANGE;

/// Most sweeps over the contacts (100 to 10 000).
const HELD_SWEEPS: usize = 2_000;

/// The friction of contacts that have no slip, kept from one solve to the next.
#[derive(Debug)]
pub(super) struct HeldSlip {
    /// Tangential force over normal force of each contact.
    ratios: Vec<Tangent>,
    sticks: Vec<bool>,
}

impl HeldSlip {
    /// Of some contacts.
    pub(super) fn of(contacts: usize) -> Self {
        Self { ratios: vec![[0.0; 2]; contacts], sticks: vec![true; contacts] }
    }

    /// Whether a contact stuck when it was last solved for.
    pub(super) fn sticks(&self, contact: usize) -> bool {
        self.sticks[contact]
    }

    /// Finds the friction of the contacts that are `held`, for the forces in `growth` (of all rows), and puts it there.
    /// `matrix` is that of all rows, row-major.
    pub(super) fn solve(
        &mut self,
        contacts: &[SpringContact],
        held: impl Fn(usize) -> bool,
        matrix: &[f64],
        growth: &mut [f64],
    ) {
        let rows = growth.len();
        let chosen: Vec<usize> = (0..contacts.len()).filter(|&i| held(i) && growth[contacts[i].row] > 0.0).collect();
        let largest = chosen.iter().map(|&i| growth[contacts[i].row]).fold(0.0, f64::max);
        for &i in &chosen {
            let contact = &contacts[i];
            for k in 0..contact.tangents {
                growth[contact.row + 1 + k] = self.ratios[i][k] * growth[contact.row];
            }
        }
        let alone = chosen.len() == 1;
        for _ in 0..HELD_SWEEPS {
            let mut change: f64 = 0.0;
            for &i in &chosen {
                let contact = &contacts[i];
                let normal = growth[contact.row];
                let (ratio, sticks) = one(contact, matrix, growth, rows);
                for k in 0..contact.tangents {
                    let force = &mut growth[contact.row + 1 + k];
                    change = change.max((ratio[k] * normal - *force).abs());
                    *force = ratio[k] * normal;
                }
                self.ratios[i] = ratio;
                self.sticks[i] = sticks;
            }
            if alone || change <= LEAST_CHANGE * largest {
                break;
            }
        }
    }
}

/// What one contact does while the others keep their forces: its tangential force over its normal one, and whether it
/// sticks.
fn one(contact: &SpringContact, matrix: &[f64], growth: &[f64], rows: usize) -> (Tangent, bool) {
    let own = contact.row + 1..contact.row + 1 + contact.tangents;
    let normal = growth[contact.row];
    let pull = |row: usize| {
        let line = &matrix[row * rows..(row + 1) * rows];
        let others = line.iter().zip(growth).enumerate().filter(|(column, _)| !own.contains(column));
        others.map(|(_, (entry, force))| entry * force).sum::<f64>() / normal
    };
    let entry = |i: usize, j: usize| matrix[(own.start + i) * rows + own.start + j];
    let (coupling, tangential) = if contact.tangents == 1 {
        ([pull(own.start), 0.0], [entry(0, 0), 0.0, entry(0, 0)])
    } else {
        ([pull(own.start), pull(own.start + 1)], [entry(0, 0), entry(0, 1), entry(1, 1)])
    };
    let matrix = CollisionMatrix { normal: 1.0, coupling, tangential };
    match (Coulomb { matrix, friction: contact.friction }).leaving_zero_slip() {
        ZeroSlip::Sticks { ratio, .. } => (ratio, true),
        ZeroSlip::Slips(direction) => (plane::scaled(direction, -contact.friction), false),
    }
}
