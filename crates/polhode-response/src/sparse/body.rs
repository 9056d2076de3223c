//! What a body of a sparse problem is to the solver: how it resists being set in motion.

use crate::error::ResponseError;
use crate::problem::ContactProblem;
use crate::sparse::block6::{CholeskyBlock, Vector6, WIDTH};
use crate::tolerances::MATRIX_ROUNDING;

/// The numbers of a mass block, row-major.
pub(crate) type MassBlock = [f64; WIDTH * WIDTH];

/// The mass of a body; its velocity is `(v, w)` of the centre of mass, in axes of the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyMass(Inertness);

#[derive(Debug, Clone, Copy, PartialEq)]
enum Inertness {
    /// It moves as it is told.
    Fixed,
    /// `M`.
    Mass(MassBlock),
    /// `M^-1`.
    Inverse(MassBlock),
}

impl BodyMass {
    /// Moves as it is told, whatever pushes it: the ground, a body whose motion is prescribed.
    pub const FIXED: Self = Self(Inertness::Fixed);

    /// A rigid body of this mass (kg) and inertia about the centre of mass in axes of the world, row-major (kg m^2).
    pub fn rigid(mass: f64, inertia: &[f64; 9]) -> Self {
        let mut block = [0.0; WIDTH * WIDTH];
        for i in 0..3 {
            block[i * WIDTH + i] = mass;
            for j in 0..3 {
                block[(i + 3) * WIDTH + j + 3] = inertia[3 * i + j];
            }
        }
        Self::from_block(block)
    }

    /// Any symmetric positive definite block, row-major: one with added mass, or of a step that is implicit in forces.
    pub const fn from_block(block: [f64; 36]) -> Self {
        Self(Inertness::Mass(block))
    }

    /// The inverse of such a block. Nothing is inverted: rows are to the last digits what they are with the inverse
    /// given.
    pub const fn from_inverse_block(block: [f64; 36]) -> Self {
        Self(Inertness::Inverse(block))
    }

    /// The block, or its inverse, of a body that moves.
    pub const fn block(&self) -> Option<&[f64; 36]> {
        match &self.0 {
            Inertness::Fixed => None,
            Inertness::Mass(block) | Inertness::Inverse(block) => Some(block),
        }
    }

    /// Its factor; none of a body that moves as it is told.
    pub(crate) fn factor(&self) -> Option<Result<MassFactor, NotAMass>> {
        let of = |block: &MassBlock| factor_of_mass(block).ok_or(NotAMass);
        match &self.0 {
            Inertness::Fixed => None,
            Inertness::Mass(block) => Some(of(block).map(MassFactor::OfMass)),
            Inertness::Inverse(block) => Some(of(block).map(MassFactor::OfInverse)),
        }
    }
}

/// Whether every force moves each body, in as many coordinates as a body in space has.
pub(crate) fn are_movable(problem: &ContactProblem) -> bool {
    let is_mass = |mass: &BodyMass| mass.factor().is_none_or(|factor| factor.is_ok());
    masses_of(problem).is_ok_and(|masses| masses.iter().all(is_mass))
}

/// The masses of all bodies.
pub(crate) fn masses_of(problem: &ContactProblem) -> Result<Vec<BodyMass>, ResponseError> {
    let width = problem.width();
    if width > WIDTH {
        return Err(ResponseError::Width(width));
    }
    let of = |body: usize| {
        let mut block: MassBlock = [0.0; WIDTH * WIDTH];
        for k in 0..WIDTH {
            block[k * WIDTH + k] = 1.0;
        }
        for (line, own) in block.chunks_exact_mut(WIDTH).zip(problem.inverse_mass(body).chunks_exact(width)) {
            line[..width].copy_from_slice(own);
        }
        BodyMass::from_inverse_block(block)
    };
    Ok((0..problem.bodies()).map(of).collect())
}

/// A block is not symmetric and positive definite.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NotAMass;

/// What scales a mass away: velocities are `S^-1 v` and rows `J S` inside, with `S S^T = M^-1`.
#[derive(Debug, Clone, Copy)]
pub(crate) enum MassFactor {
    /// `L` of `M = L L^T`; `S = L^-T`.
    OfMass(CholeskyBlock<WIDTH>),
    /// `S` itself.
    OfInverse(CholeskyBlock<WIDTH>),
}

impl MassFactor {
    /// `S^-1 v` in place of `v`.
    pub(crate) fn scale_velocity(&self, v: &mut Vector6) {
        match self {
            Self::OfMass(factor) => factor.times_transposed(v),
            Self::OfInverse(factor) => factor.solve_lower(v),
        }
    }

    /// `S v` in place of `v`.
    pub(crate) fn unscale_velocity(&self, v: &mut Vector6) {
        match self {
            Self::OfMass(factor) => factor.solve_upper(v),
            Self::OfInverse(factor) => factor.times(v),
        }
    }

    /// `J S` in place of a row `J`.
    pub(crate) fn scale_row(&self, row: &mut Vector6) {
        match self {
            Self::OfMass(factor) => factor.solve_lower(row),
            Self::OfInverse(factor) => factor.times_transposed(row),
        }
    }
}

/// The factor of a mass block; none when it is not symmetric and positive definite.
fn factor_of_mass(block: &MassBlock) -> Option<CholeskyBlock<WIDTH>> {
    for i in 0..WIDTH {
        for j in 0..i {
            let (entry, mirror) = (block[i * WIDTH + j], block[j * WIDTH + i]);
            let size = (block[i * WIDTH + i] * block[j * WIDTH + j]).abs().sqrt();
            // Written so that NaN is refused.
            let is_symmetric = (entry - mirror).abs() <= MATRIX_ROUNDING * size;
            if !is_symmetric {
                return None;
            }
        }
    }
    CholeskyBlock::of(&std::array::from_fn(|i| std::array::from_fn(|j| block[i * WIDTH + j])))
}
