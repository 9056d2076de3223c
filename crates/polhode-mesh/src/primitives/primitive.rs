//! Any of the primitives, as one type.

use super::{Capsule, Cone, Cuboid, Cylinder, Ellipsoid, HalfBall, PrimitiveError, Refinement, Sphere, Torus};
use crate::{Amount, SolidMesh};
use polhode_spatial::MassProperties;

/// Any of the primitives.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Primitive {
    /// A box.
    Box(Cuboid),
    /// A sphere.
    Sphere(Sphere),
    /// An ellipsoid.
    Ellipsoid(Ellipsoid),
    /// A cylinder.
    Cylinder(Cylinder),
    /// A cone.
    Cone(Cone),
    /// A capsule.
    Capsule(Capsule),
    /// A torus.
    Torus(Torus),
    /// Half a ball.
    HalfBall(HalfBall),
}

/// The same call for every kind.
macro_rules! each {
    ($primitive:expr, $body:ident => $call:expr) => {
        match $primitive {
            Primitive::Box($body) => $call,
            Primitive::Sphere($body) => $call,
            Primitive::Ellipsoid($body) => $call,
            Primitive::Cylinder($body) => $call,
            Primitive::Cone($body) => $call,
            Primitive::Capsule($body) => $call,
            Primitive::Torus($body) => $call,
            Primitive::HalfBall($body) => $call,
        }
    };
}

impl Primitive {
    /// The word for its kind, as scene files write it.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Box(_) => "box",
            Self::Sphere(_) => "sphere",
            Self::Ellipsoid(_) => "ellipsoid",
            Self::Cylinder(_) => "cylinder",
            Self::Cone(_) => "cone",
            Self::Capsule(_) => "capsule",
            Self::Torus(_) => "torus",
            Self::HalfBall(_) => "half-ball",
        }
    }

    /// Filled with matter, from its density (kg/m^3) or mass.
    ///
    /// # Errors
    /// [`PrimitiveError::MassProperties`] when mass or inertia over- or underflow.
    pub fn solid(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        each!(self, body => body.solid(amount))
    }

    /// All its mass in its surface, from its density (kg/m^2) or mass.
    ///
    /// # Errors
    /// As [`Primitive::solid`].
    pub fn hollow(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        each!(self, body => body.hollow(amount))
    }

    /// A mesh with its vertices on the surface. That of a box is the box, whatever the refinement.
    ///
    /// # Errors
    /// [`PrimitiveError::Mesh`] when the body is so thin that its mesh is flat to rounding.
    pub fn mesh(&self, refinement: Refinement) -> Result<SolidMesh, PrimitiveError> {
        each!(self, body => body.mesh(refinement))
    }
}
