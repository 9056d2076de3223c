//! Tori about z: radius R of the ring (its middle line), radius r of the tube.
//!
//! | body | measure | along | across |
//! |---|---|---|---|
//! | solid | `2 pi^2 R r^2` | `m (R^2 + 3/4 r^2)` | `m (R^2 / 2 + 5/8 r^2)` |
//! | hollow | `4 pi^2 R r` | `m (R^2 + 3/2 r^2)` | `m (R^2 / 2 + 5/4 r^2)` |

use super::error::checked_radius;
use super::uniform::{Uniform, across_and_along};
use super::{PrimitiveError, Refinement};
use crate::triangle_mesh::TriangleMesh;
use crate::{Amount, SolidMesh};
use glam::DVec3;
use polhode_spatial::MassProperties;
use std::f64::consts::{PI, TAU};

/// A torus about the origin and z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Torus {
    major: f64,
    minor: f64,
}

impl Torus {
    /// With a ring of radius `major`, measured to the middle of a tube of radius `minor`, m.
    ///
    /// # Errors
    /// [`PrimitiveError::Radius`] when one is not positive and finite, [`PrimitiveError::Tube`] when the tube is not
    /// thinner than the ring, so that there is no hole.
    pub fn new(major: f64, minor: f64) -> Result<Self, PrimitiveError> {
        let (major, minor) = (checked_radius(major)?, checked_radius(minor)?);
        if minor < major { Ok(Self { major, minor }) } else { Err(PrimitiveError::Tube { major, minor }) }
    }

    /// Filled with matter, from its density (kg/m^3) or mass.
    ///
    /// # Errors
    /// [`PrimitiveError::MassProperties`] when mass or inertia over- or underflow.
    pub fn solid(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let (ring, tube) = (self.major * self.major, self.minor * self.minor);
        let moments = across_and_along(0.5 * ring + 0.625 * tube, ring + 0.75 * tube);
        Uniform::centered(2.0 * PI * PI * self.major * tube, moments).body(amount)
    }

    /// All its mass in its surface, from its density (kg/m^2) or mass.
    ///
    /// # Errors
    /// As [`Torus::solid`].
    pub fn hollow(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let (ring, tube) = (self.major * self.major, self.minor * self.minor);
        let moments = across_and_along(0.5 * ring + 1.25 * tube, ring + 1.5 * tube);
        Uniform::centered(4.0 * PI * PI * self.major * self.minor, moments).body(amount)
    }

    /// Its mesh: a circle's segments around the tube, twice as many around the ring.
    ///
    /// # Errors
    /// [`PrimitiveError::Mesh`] when the tube is so thin beside the ring that it is flat to rounding.
    pub fn mesh(&self, refinement: Refinement) -> Result<SolidMesh, PrimitiveError> {
        let around_tube = refinement.segments();
        let around_ring = 2 * around_tube;
        let angle = |i: u32, n: u32| TAU * f64::from(i) / f64::from(n);
        let tube: Vec<[f64; 2]> = (0..around_tube)
            .map(|j| {
                let (sin, cos) = libm::sincos(angle(j, around_tube));
                [self.major + self.minor * cos, self.minor * sin]
            })
            .collect();
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        for i in 0..around_ring {
            let (sin, cos) = libm::sincos(angle(i, around_ring));
            vertices.extend(tube.iter().map(|&[rho, z]| DVec3::new(rho * cos, rho * sin, z)));
            let at = |i: u32, j: u32| (i % around_ring) * around_tube + j % around_tube;
            for j in 0..around_tube {
                triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
                triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
        Ok(SolidMesh::new(TriangleMesh::new(vertices, triangles)?)?)
    }
}
