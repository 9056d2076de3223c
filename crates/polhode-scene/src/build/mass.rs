//! Mass properties from mass or density, shape and inertia.
//!
//! A solid (or, with `hollow`, its surface) is filled evenly; `inertia`, about the centre of mass in the body's own
//! axes, replaces the inertia of the shape. Points and bodies without a shape have no volume to fill: they need mass
//! and inertia, and their centre of mass is their origin. `center_of_mass` puts the centre of mass elsewhere, as in a
//! loaded die: such a body is not filled evenly, so that its inertia must be given too.

use super::fault::{Fault, vector};
use super::matter::{Filling, Matter};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::{BodyEntry, Exactly, InertiaEntry};
use glam::{DMat3, DVec3};
use polhode::mesh::Amount;
use polhode::spatial::{Density, Inertia, Mass, MassProperties};

/// Mass properties of the body given at `path`.
pub(super) fn build(entry: &BodyEntry, matter: Option<&Matter>, path: &KeyPath) -> Result<MassProperties, Fault> {
    let Some(center) = &entry.center_of_mass else { return about_own_center(entry, matter, path) };
    let key = path.key("center_of_mass");
    let center = vector(center, &key)?;
    if entry.inertia.is_none() {
        return Err((key, Refusal::Needs { what: "a body with `center_of_mass`", needed: "`inertia`" }));
    }
    let found = about_own_center(entry, matter, path)?;
    let mass = Mass::new(found.mass()).map_err(|error| (path.clone(), error.into()))?;
    Ok(MassProperties::new(mass, center, *found.inertia()))
}

/// Mass properties with the centre of mass that the shape has.
fn about_own_center(entry: &BodyEntry, matter: Option<&Matter>, path: &KeyPath) -> Result<MassProperties, Fault> {
    let amount = amount(entry, path)?;
    let inertia = entry.inertia.as_ref().map(|inertia| self::inertia(inertia, &path.key("inertia"))).transpose()?;
    let Some(matter) = matter.filter(|matter| matter.has_volume()) else {
        return of_given_inertia(entry, amount, inertia, matter.is_some(), path);
    };
    let filling = if entry.hollow { Filling::Hollow } else { Filling::Solid };
    let needs = Refusal::Needs { what: WITHOUT_VOLUME, needed: MASS_AND_INERTIA };
    let filled = matter.filled(filling, amount).and_then(|filled| filled.ok_or(needs));
    let filled = filled.map_err(|refusal| (path.key("shape"), refusal))?;
    let Some(inertia) = inertia else { return Ok(filled) };
    let mass = Mass::new(filled.mass()).map_err(|error| (path.clone(), error.into()))?;
    Ok(MassProperties::new(mass, filled.center_of_mass(), inertia))
}

const WITHOUT_SHAPE: &str = "a body without a shape";
const WITHOUT_VOLUME: &str = "a body whose shape has no volume";
const MASS_AND_INERTIA: &str = "`mass` and `inertia`";

/// A body whose shape tells nothing about its mass.
fn of_given_inertia(
    entry: &BodyEntry,
    amount: Amount,
    inertia: Option<Inertia>,
    has_shape: bool,
    path: &KeyPath,
) -> Result<MassProperties, Fault> {
    let what = if has_shape { WITHOUT_VOLUME } else { WITHOUT_SHAPE };
    if entry.hollow {
        return Err((path.key("hollow"), Refusal::Meaningless { key: "hollow", what }));
    }
    match (amount, inertia) {
        (Amount::Density(_), _) => Err((path.key("density"), Refusal::Meaningless { key: "density", what })),
        (Amount::Mass(_), None) => Err((path.clone(), Refusal::Needs { what, needed: MASS_AND_INERTIA })),
        (Amount::Mass(mass), Some(inertia)) => Ok(MassProperties::new(mass, DVec3::ZERO, inertia)),
    }
}

/// Mass or density, exactly one of them.
fn amount(entry: &BodyEntry, path: &KeyPath) -> Result<Amount, Fault> {
    match (entry.mass, entry.density) {
        (Some(_), Some(_)) => Err((path.key("density"), Refusal::Excludes { key: "density", other: "mass" })),
        (None, None) => {
            Err((path.clone(), Refusal::Needs { what: "a body that moves", needed: "`mass` or `density`" }))
        }
        (Some(mass), None) => match Mass::new(mass) {
            Ok(mass) => Ok(mass.into()),
            Err(error) => Err((path.key("mass"), error.into())),
        },
        (None, Some(density)) => match Density::new(density) {
            Ok(density) => Ok(density.into()),
            Err(error) => Err((path.key("density"), error.into())),
        },
    }
}

fn inertia(entry: &InertiaEntry, path: &KeyPath) -> Result<Inertia, Fault> {
    let inertia = match entry {
        InertiaEntry::Diagonal(Exactly(moments)) => Inertia::from_diagonal(DVec3::from_array(*moments)),
        // Rows become columns; the constructor checks that it makes no difference.
        InertiaEntry::Matrix(Exactly([x, y, z])) => Inertia::new(DMat3::from_cols_array_2d(&[x.0, y.0, z.0])),
    };
    inertia.map_err(|error| (path.clone(), error.into()))
}
