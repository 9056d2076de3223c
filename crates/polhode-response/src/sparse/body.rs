//! What a body of a sparse problem is to the solver: how it resists being set in motion.

use crate::sparse::block6::{Block6, CholeskyBlock, WIDTH, ZERO};

/// Largest relative asymmetry of a mass block that counts as rounding (no unit).
const MASS_ROUNDING: f64 = 1e-12;

/// The mass of a body; its velocity is `(v, w)` of the centre of mass, in axes of the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyMass {
    /// None for a body that moves as it is told.
    block: Option<Block6>,
}

impl BodyMass {
    /// Moves as it is told, whatever pushes it: the ground, a body whose motion is prescribed.
    pub const FIXED: Self = Self { block: None };

    /// A rigid body of this mass (kg) and inertia about the centre of mass in axes of the world, row-major (kg m^2).
    pub fn rigid(mass: f64, inertia: &[f64; 9]) -> Self {
        let mut block = ZERO;
        for i in 0..3 {
            block[i * WIDTH + i] = mass;
            for j in 0..3 {
                block[(i + 3) * WIDTH + j + 3] = inertia[3 * i + j];
            }
        }
        Self { block: Some(block) }
    }

    /// Any symmetric positive definite block, row-major: one with added mass, or of a step that is implicit in forces.
    pub const fn from_block(block: [f64; 36]) -> Self {
        Self { block: Some(block) }
    }

    /// The block of a body that moves.
    pub const fn block(&self) -> Option<&[f64; 36]> {
        self.block.as_ref()
    }
}

/// The factor of a mass block; none when it is not symmetric and positive definite.
pub(crate) fn factor_of_mass(block: &Block6) -> Option<CholeskyBlock> {
    for i in 0..WIDTH {
        for j in 0..i {
            let (entry, mirror) = (block[i * WIDTH + j], block[j * WIDTH + i]);
            let size = (block[i * WIDTH + i] * block[j * WIDTH + j]).abs().sqrt();
            // Written so that NaN is refused.
            let is_symmetric = (entry - mirror).abs() <= MASS_ROUNDING * size;
            if !is_symmetric {
                return None;
            }
        }
    }
    CholeskyBlock::of(block)
}
