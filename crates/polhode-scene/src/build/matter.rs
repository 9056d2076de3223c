//! What the mass of a body is spread over.

use crate::error::Refusal;
use polhode::mesh::{Amount, Primitive, PrimitiveError, SolidMesh, hollow_mass_properties, solid_mass_properties};
use polhode::spatial::{Density, MassProperties, Pose};

/// What the mass of a body is spread over.
pub(super) enum Matter {
    /// A primitive in its own frame.
    Primitive(Primitive),
    /// The solid that a mesh bounds.
    Mesh(SolidMesh),
    /// Parts, each in its place in the body.
    Parts(Vec<(Self, Pose)>),
    /// Nothing that has a volume.
    WithoutVolume,
    /// A half-space, which no mass can fill.
    HalfSpace,
}

/// How a body is filled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Filling {
    /// Evenly.
    Solid,
    /// Evenly over its surface.
    Hollow,
}

impl Matter {
    /// Whether there is something to fill.
    pub(super) fn has_volume(&self) -> bool {
        match self {
            Self::Primitive(_) | Self::Mesh(_) => true,
            Self::Parts(parts) => parts.iter().any(|(part, _)| part.has_volume()),
            Self::WithoutVolume | Self::HalfSpace => false,
        }
    }

    /// Mass properties in the body's frame; nothing when there is nothing to fill.
    ///
    /// # Errors
    /// When mass or inertia over- or underflow, or a mesh encloses no volume.
    pub(super) fn filled(&self, filling: Filling, amount: Amount) -> Result<Option<MassProperties>, Refusal> {
        match (self, filling) {
            (Self::Primitive(primitive), Filling::Solid) => primitive.solid(amount).map(Some).map_err(of_primitive),
            (Self::Primitive(primitive), Filling::Hollow) => primitive.hollow(amount).map(Some).map_err(of_primitive),
            (Self::Mesh(mesh), Filling::Solid) => solid_mass_properties(mesh, amount).map(Some).map_err(Refusal::Mesh),
            (Self::Mesh(mesh), Filling::Hollow) => {
                hollow_mass_properties(mesh.mesh(), amount).map(Some).map_err(Refusal::Mesh)
            }
            (Self::Parts(parts), _) => filled_parts(parts, filling, amount),
            (Self::WithoutVolume | Self::HalfSpace, _) => Ok(None),
        }
    }
}

/// All parts have one density: that of the given mass, when it is the mass that is given.
fn filled_parts(parts: &[(Matter, Pose)], filling: Filling, amount: Amount) -> Result<Option<MassProperties>, Refusal> {
    let density = match amount {
        Amount::Density(density) => density,
        Amount::Mass(mass) => {
            let unit = sum(parts, filling, Density::new(1.0)?)?;
            let Some(unit) = unit else { return Ok(None) };
            Density::new(mass.get() / unit.mass())?
        }
    };
    sum(parts, filling, density)
}

fn sum(parts: &[(Matter, Pose)], filling: Filling, density: Density) -> Result<Option<MassProperties>, Refusal> {
    let mut sum: Option<MassProperties> = None;
    for (part, pose) in parts {
        let Some(filled) = part.filled(filling, density.into())? else { continue };
        let placed = filled.in_frame(pose);
        sum = Some(match sum {
            Some(sum) => sum.combined(&placed)?,
            None => placed,
        });
    }
    Ok(sum)
}

fn of_primitive(error: PrimitiveError) -> Refusal {
    match error {
        PrimitiveError::MassProperties(error) => error.into(),
        error => error.into(),
    }
}
