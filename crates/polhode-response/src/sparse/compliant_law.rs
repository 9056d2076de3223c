//! The law of a contact or joint that yields: its reaction as a function of its velocity.
//!
//! With a compliance `c` and reactions `r_0` to which it returns, a block asks for its law of `r` and
//! `u + c (r - r_0)`. With `z = r_0 - u / c` the answer is explicit: `r = z` where it holds, `r_n = max(z_n, 0)` along
//! a normal, and the point of the disc `|r_i| <= mu_i r_n` that is nearest to `z_i` for a part that resists. This is
//! Coulomb's law with its slip, not the projection onto the cone. Source: Alart and Curnier 1991 (the augmented
//! Lagrangian). Symbols: `r` (N s), `u` (m/s), `c` (1/kg), `K = -dr/du` (kg). Assumption: rows of one part have one
//! compliance of their own; where they do not, the direction of a slip is that of `z`. Failure: none, any `c` above 0
//! gives numbers.

use crate::friction::coulomb_cone::BlockRows;
use crate::law::{Law, MOST_ROWS};
use crate::sparse::system::RowMatrix;

/// A block that yields: its reaction, and how that follows its velocity.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Yielded {
    pub(crate) reactions: BlockRows,
    /// `-dr/du`.
    pub(crate) stiffness: RowMatrix,
}

/// A block's compliance and the reactions to which it returns.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spring {
    /// `c` (1/kg).
    pub(crate) compliance: f64,
    /// The compliance of the rows themselves (1/kg).
    pub(crate) own: BlockRows,
    /// `r_0`.
    pub(crate) reactions: BlockRows,
}

impl Spring {
    /// What a block does at these velocities, without those that its own compliance adds.
    pub(crate) fn yielded(&self, law: Law, u: &BlockRows) -> Yielded {
        let c: BlockRows = self.own.map(|own| own + self.compliance);
        let z: BlockRows = std::array::from_fn(|k| (self.compliance * self.reactions[k] - u[k]) / c[k]);
        let mut yielded = Yielded { reactions: [0.0; MOST_ROWS], stiffness: [[0.0; MOST_ROWS]; MOST_ROWS] };
        let Yielded { reactions: r, stiffness } = &mut yielded;
        if let Law::Hold { rows } = law {
            for k in 0..rows {
                (r[k], stiffness[k][k]) = (z[k], 1.0 / c[k]);
            }
            return yielded;
        }
        // Written so that NaN is open.
        let presses = z[0] > 0.0;
        if !presses {
            return yielded;
        }
        (r[0], stiffness[0][0]) = (z[0], 1.0 / c[0]);
        for (rows, resists) in law.parts() {
            let radius = resists.friction * z[0];
            let length = rows.clone().map(|row| z[row] * z[row]).sum::<f64>().sqrt();
            for row in rows.clone() {
                if resists.slides {
                    (r[row], stiffness[row][0]) = (-radius, -resists.friction / c[0]);
                } else if length <= radius {
                    (r[row], stiffness[row][row]) = (z[row], 1.0 / c[row]);
                } else {
                    let along = z[row] / length;
                    (r[row], stiffness[row][0]) = (radius * along, resists.friction * along / c[0]);
                    for other in rows.clone() {
                        let unit = f64::from(u8::from(row == other));
                        stiffness[row][other] = radius / length * (unit - along * z[other] / length) / c[other];
                    }
                }
            }
        }
        yielded
    }
}
