//! Convex solids: meshes that are known to be convex, and the test of a point against their half-spaces.
//!
//! A convex solid is the intersection of the half-spaces behind its triangles, so a point that lies in each of them
//! lies in the solid (thesis 3.2). The test is exact for the triangles as they are in memory. A mesh may be convex only
//! to [`DIGITS_OF_A_FILE`](polhode_spatial::rounding::DIGITS_OF_A_FILE); then points within its dents count as outside,
//! which [`PointLocator`](crate::PointLocator) does not do. Cost: one determinant a triangle.

use crate::point_location::PointLocation;
use crate::predicates::{side_of_plane, unit_scale};
use crate::{Convexity, SolidMesh, TriangleMesh, VolumeIntegrals, convexity};
use glam::DVec3;
use thiserror::Error;

/// A solid whose vertices stand in front of a face's plane.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error("the solid is not convex: a vertex stands {} m in front of the plane of a face, for a size of {} \
    m", .0.excess, .0.size)]
pub struct NotConvexError(
    /// How far it is from convex, and where.
    pub Convexity,
);

/// A solid mesh that is convex.
#[derive(Debug, Clone, PartialEq)]
pub struct ConvexSolid {
    solid: SolidMesh,
    scale: f64,
}

impl ConvexSolid {
    /// Takes a solid that is convex to [`DIGITS_OF_A_FILE`](polhode_spatial::rounding::DIGITS_OF_A_FILE).
    ///
    /// # Errors
    /// [`NotConvexError`] says how far it is from that.
    pub fn new(solid: SolidMesh) -> Result<Self, NotConvexError> {
        let measured = convexity(&solid);
        if measured.is_convex() { Ok(Self::known_convex(solid)) } else { Err(NotConvexError(measured)) }
    }

    /// Of a mesh that is convex by the way it was made.
    pub(crate) fn known_convex(solid: SolidMesh) -> Self {
        let scale = unit_scale(solid.mesh().bounds().largest_coordinate());
        Self { solid, scale }
    }

    /// The solid.
    pub const fn solid(&self) -> &SolidMesh {
        &self.solid
    }

    /// Its mesh.
    pub const fn mesh(&self) -> &TriangleMesh {
        self.solid.mesh()
    }

    /// Volume, centroid and second moment.
    pub const fn volume_integrals(&self) -> &VolumeIntegrals {
        self.solid.volume_integrals()
    }

    /// Gives the solid back.
    pub fn into_solid(self) -> SolidMesh {
        self.solid
    }

    /// Where `point` (m) lies: outside as soon as it is in front of one triangle; on the surface when it is in front of
    /// none and in the plane of one. A point that is not finite is outside.
    pub fn locate(&self, point: DVec3) -> PointLocation {
        if !point.is_finite() {
            return PointLocation::Outside;
        }
        let point = point * self.scale;
        let mut location = PointLocation::Inside;
        for corners in self.mesh().corner_positions() {
            let plane = corners.map(|corner| corner * self.scale);
            let side = side_of_plane(plane, point);
            if side > 0.0 {
                return PointLocation::Outside;
            }
            // A degenerate triangle has no plane: every point is on it.
            if side == 0.0 && !crate::predicates::are_collinear(plane[0], plane[1], plane[2]) {
                location = PointLocation::OnSurface;
            }
        }
        location
    }
}
