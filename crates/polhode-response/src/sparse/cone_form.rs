//! The rows of a contact as those of a second-order cone.
//!
//! With weights `w = (1, mu, mu)` the reactions are `r = w x`, and with `y = w u + (|(w u)_t|, 0, 0)` Coulomb's law
//! reads `L contains x _|_ y in L`: the slip enters `y`. Parts that slide already follow from the normal reaction, `r
//! = w x + d x_0`. Contacts that resist rotations have all their rows in one cone here, which is the inner ellipsoid
//! of theirs. Source: Acary, Armand, Nguyen and Shpakovych 2023. Symbols: `theta` direction of the slip, `E = 1 + e_0
//! theta^T` its derivative, `T = w + d e_0^T`.

use crate::dense::small::solve_small;
use crate::friction::coulomb_cone::{BlockRows, filled_up};
use crate::law::{Law, MOST_ROWS};
use crate::sparse::jordan::{UNIT, tail, tail_product};
use crate::sparse::problem::{BodyProblem, RowBlock};
use crate::sparse::system::RowMatrix;
use crate::tolerances::DEPENDENT_COMPLIANCE;

/// A block that is no hold.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ConeForm {
    /// `w`.
    weights: BlockRows,
    /// `d`.
    driven: BlockRows,
    /// The diagonal of `C`.
    compliance: BlockRows,
}

/// `y` at some rates, and what it was made of.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slipping {
    pub(crate) y: BlockRows,
    /// `theta`.
    pub(crate) theta: BlockRows,
}

impl Slipping {
    /// `E z`.
    pub(crate) fn turned(&self, z: &BlockRows) -> BlockRows {
        let mut turned = *z;
        turned[0] += tail_product(&self.theta, z);
        turned
    }
}

impl ConeForm {
    /// Of a block; none when it is held.
    pub(crate) fn of(problem: &BodyProblem, block: &RowBlock) -> Option<Self> {
        if matches!(block.law, Law::Hold { .. }) {
            return None;
        }
        let (mut weights, mut driven) = (UNIT, [0.0; MOST_ROWS]);
        for (rows, resists) in block.law.parts() {
            for row in rows {
                let target = if resists.slides { &mut driven[row] } else { &mut weights[row] };
                *target = if resists.slides { -resists.friction } else { resists.friction };
            }
        }
        Some(Self { weights, driven, compliance: filled_up(&problem.compliance[block.rows.clone()]) })
    }

    /// Whether its cone is only the inner ellipsoid of that of the law.
    pub(crate) fn is_inner(law: Law) -> bool {
        law.parts().iter().filter(|(rows, part)| !rows.is_empty() && !part.slides).count() > 1
    }

    /// `r` of `x`.
    pub(crate) fn reactions(&self, x: &BlockRows) -> BlockRows {
        std::array::from_fn(|k| self.weights[k] * x[k] + self.driven[k] * x[0])
    }

    /// `x` of `r`, as far as `r` follows from it.
    pub(crate) fn point(&self, r: &BlockRows) -> BlockRows {
        std::array::from_fn(|k| if self.weights[k] > 0.0 { r[k] / self.weights[k] } else { 0.0 })
    }

    /// `w u`.
    pub(crate) fn weighted(&self, u: &BlockRows) -> BlockRows {
        std::array::from_fn(|k| self.weights[k] * u[k])
    }

    /// `C r`.
    pub(crate) fn yielding(&self, r: &BlockRows) -> BlockRows {
        std::array::from_fn(|k| self.compliance[k] * r[k])
    }

    /// `y` of `u`.
    pub(crate) fn slipping(&self, u: &BlockRows) -> Slipping {
        let mut y = self.weighted(u);
        let slip = tail(&y);
        let mut theta: BlockRows = if slip > 0.0 { y.map(|y| y / slip) } else { [0.0; MOST_ROWS] };
        theta[0] = 0.0;
        y[0] += slip;
        Slipping { y, theta }
    }

    /// `T B E w`: what rates take from the reactions when they take `B E w` from `x`.
    pub(crate) fn stiffness(&self, inverse: &RowMatrix, slipping: &Slipping) -> RowMatrix {
        let theta = &slipping.theta;
        // Only the first column of B is seen through the slip.
        let scaled: RowMatrix = std::array::from_fn(|i| {
            std::array::from_fn(|j| (inverse[i][j] + inverse[i][0] * theta[j]) * self.weights[j])
        });
        std::array::from_fn(|i| std::array::from_fn(|j| self.weights[i] * scaled[i][j] + self.driven[i] * scaled[0][j]))
    }

    /// `(1 + B E w C T)^-1`, by which compliance lessens all changes of `x`; none for a rigid contact.
    pub(crate) fn lessening(&self, inverse: &RowMatrix, slipping: &Slipping) -> Option<RowMatrix> {
        if self.compliance.iter().all(|value| *value == 0.0) {
            return None;
        }
        let unit = |k: usize| -> BlockRows { std::array::from_fn(|i| f64::from(u8::from(i == k))) };
        let column = |k: usize| {
            let given = slipping.turned(&self.weighted(&self.yielding(&self.reactions(&unit(k)))));
            times(inverse, &given)
        };
        let columns: RowMatrix = std::array::from_fn(column);
        let matrix: RowMatrix = std::array::from_fn(|i| std::array::from_fn(|j| unit(i)[j] + columns[j][i]));
        let mut lessening = [[0.0; MOST_ROWS]; MOST_ROWS];
        for j in 0..MOST_ROWS {
            let mut right = unit(j);
            let mut copy = matrix;
            solve_small(copy.as_flattened_mut(), &mut right, DEPENDENT_COMPLIANCE);
            for (line, value) in lessening.iter_mut().zip(right) {
                line[j] = value;
            }
        }
        Some(lessening)
    }
}

/// `A z`.
pub(crate) fn times(matrix: &RowMatrix, z: &BlockRows) -> BlockRows {
    std::array::from_fn(|i| matrix[i].iter().zip(z).map(|(a, z)| a * z).sum())
}

/// `A B`.
pub(crate) fn product_of(a: &RowMatrix, b: &RowMatrix) -> RowMatrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..MOST_ROWS).map(|k| a[i][k] * b[k][j]).sum()))
}
