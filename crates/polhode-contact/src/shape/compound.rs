//! Compounds: bodies of several parts that are fixed to each other.

use super::Shape;
use super::error::ShapeError;
use polhode_spatial::Pose;

/// Parts that are fixed to each other and may touch or overlap. Their vertices, edges and faces are numbered part after
/// part, so that a feature of the compound names its part too.
#[derive(Debug, Clone, PartialEq)]
pub struct Compound {
    pub(crate) parts: Vec<Shape>,
}

impl Compound {
    /// From parts, each in the body's frame; a compound among them gives its own parts.
    ///
    /// # Errors
    /// When there is no part, or one is a half-space or a triangle mesh, which stand alone.
    pub fn new(parts: Vec<Shape>) -> Result<Self, ShapeError> {
        let mut flat = Vec::with_capacity(parts.len());
        for part in parts {
            match part {
                Shape::Compound(inner) => flat.extend(inner.parts),
                Shape::HalfSpace(_) => return Err(ShapeError::NotAPart { what: "a half-space" }),
                Shape::TriangleMesh(_) => return Err(ShapeError::NotAPart { what: "a triangle mesh" }),
                part => flat.push(part),
            }
        }
        if flat.is_empty() {
            return Err(ShapeError::NoPart { what: "parts" });
        }
        Ok(Self { parts: flat })
    }

    /// The parts, in the body's frame.
    pub fn parts(&self) -> &[Shape] {
        &self.parts
    }

    pub(super) fn placed(&self, pose: &Pose) -> Result<Self, ShapeError> {
        let parts = self.parts.iter().map(|part| part.placed(pose)).collect::<Result<_, _>>()?;
        Ok(Self { parts })
    }

    /// An upper bound of the size, m: the diameter of a ball about the frame's origin, or of the parts' own when less.
    pub(super) fn size(&self) -> f64 {
        let reach = self.parts.iter().map(Shape::radius).fold(0.0, f64::max);
        if let [only] = self.parts.as_slice() { only.size() } else { 2.0 * reach }
    }
}
