//! Mass properties of primitives in closed form, about their own centre, which is the origin of their frame.
//!
//! | body, edges a b c or radius r | moment about x (box) or any axis (sphere) |
//! |---|---|
//! | solid box | `m (b^2 + c^2) / 12` |
//! | hollow box | `m ((b^2 + c^2) bc + (c^2 + 3 b^2) ca + (b^2 + 3 c^2) ab) / (12 (ab + bc + ca))` |
//! | solid sphere | `2/5 m r^2` |
//! | hollow sphere | `2/3 m r^2` |
//!
//! A hollow box is its six faces of uniform mass per area: two across x at no distance along y and z, two across y at
//! b/2, two across z at c/2. Sources: docs/REFERENCES.md, Goldstein 5.3; checked by the mesh integrals.

use crate::triangle_mesh::{MeshError, TriangleMesh};
use crate::{Amount, SolidMesh};
use glam::DVec3;
use polhode_spatial::{Inertia, MassProperties, MassPropertiesError};
use std::f64::consts::PI;
use thiserror::Error;

/// Why a primitive has no mass properties.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum PrimitiveError {
    /// An edge is not positive and finite.
    #[error("the edges of a box must be positive and finite, found ({}, {}, {}) m", .0.x, .0.y, .0.z)]
    Size(DVec3),
    /// The radius is not positive and finite.
    #[error("a radius must be positive and finite, found {0} m")]
    Radius(f64),
    /// Mass or inertia over- or underflow.
    #[error(transparent)]
    MassProperties(#[from] MassPropertiesError),
    /// The primitive is so thin that its mesh is flat to rounding.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// A solid box with full edges `size` (m), from its density (kg/m^3) or mass.
///
/// # Errors
/// [`PrimitiveError`] when `size` is not positive and finite, or mass or inertia over- or underflow.
pub fn solid_box(size: DVec3, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
    let size = checked_size(size)?;
    let s2 = size * size;
    let moments_per_mass = DVec3::new(s2.y + s2.z, s2.z + s2.x, s2.x + s2.y) / 12.0;
    centered(amount.into(), size.x * size.y * size.z, moments_per_mass)
}

/// A hollow box with full edges `size` (m), all its mass in its faces, from its density (kg/m^2) or mass.
///
/// # Errors
/// As [`solid_box`].
pub fn hollow_box(size: DVec3, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
    let size = checked_size(size)?;
    let s2 = size * size;
    // Area of one face across each axis.
    let faces = DVec3::new(size.y * size.z, size.z * size.x, size.x * size.y);
    let half_area = faces.x + faces.y + faces.z;
    let moment = |i: usize| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let across_i = (s2[j] + s2[k]) * faces[i];
        let across_j = (s2[k] + 3.0 * s2[j]) * faces[j];
        let across_k = (s2[j] + 3.0 * s2[k]) * faces[k];
        (across_i + across_j + across_k) / (12.0 * half_area)
    };
    centered(amount.into(), 2.0 * half_area, DVec3::new(moment(0), moment(1), moment(2)))
}

/// A solid sphere of radius `radius` (m), from its density (kg/m^3) or mass.
///
/// # Errors
/// [`PrimitiveError`] when `radius` is not positive and finite, or mass or inertia over- or underflow.
pub fn solid_sphere(radius: f64, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
    let r2 = checked_radius(radius)? * radius;
    centered(amount.into(), 4.0 / 3.0 * PI * r2 * radius, DVec3::splat(0.4 * r2))
}

/// A hollow sphere of radius `radius` (m), all its mass in its surface, from its density (kg/m^2) or mass.
///
/// # Errors
/// As [`solid_sphere`].
pub fn hollow_sphere(radius: f64, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
    let r2 = checked_radius(radius)? * radius;
    centered(amount.into(), 4.0 * PI * r2, DVec3::splat(2.0 / 3.0 * r2))
}

/// The mesh of a box with full edges `size` (m) about the origin: 8 vertices, 12 triangles.
///
/// # Errors
/// [`PrimitiveError::Size`] when an edge is not positive and finite, [`PrimitiveError::Mesh`] when it is so thin beside
/// the others that the box is flat to rounding.
pub fn box_mesh(size: DVec3) -> Result<SolidMesh, PrimitiveError> {
    let size = checked_size(size)?;
    // Vertex i lies on the positive side of axis k when bit k of i is set.
    let side = |i: u32, axis: u32| if i >> axis & 1 == 1 { 0.5 } else { -0.5 };
    let vertices = (0..8).map(|i| size * DVec3::new(side(i, 0), side(i, 1), side(i, 2))).collect();
    let faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Ok(SolidMesh::new(TriangleMesh::new(vertices, triangles)?)?)
}

/// The box's edges, when there is such a box.
fn checked_size(size: DVec3) -> Result<DVec3, PrimitiveError> {
    if size.cmpgt(DVec3::ZERO).all() && size.is_finite() { Ok(size) } else { Err(PrimitiveError::Size(size)) }
}

/// The sphere's radius, when there is such a sphere.
fn checked_radius(radius: f64) -> Result<f64, PrimitiveError> {
    if radius > 0.0 && radius.is_finite() { Ok(radius) } else { Err(PrimitiveError::Radius(radius)) }
}

/// A body about its own centre, from its volume or area and its principal moments per mass (m^2).
fn centered(amount: Amount, measure: f64, moments_per_mass: DVec3) -> Result<MassProperties, PrimitiveError> {
    let mass = amount.mass(measure)?;
    let inertia = Inertia::from_diagonal(mass.get() * moments_per_mass).map_err(MassPropertiesError::from)?;
    Ok(MassProperties::new(mass, DVec3::ZERO, inertia))
}
