//! The plane of a planar motion, and the coordinates of velocities in it: two of the velocity in the plane, one of the
//! angular velocity about its normal. `planar.rs` finds out whether a motion is planar.

use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// The plane of a planar motion: `normal . x = offset`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PlaneOfMotion {
    normal: DVec3,
    /// Distance from the world's origin along the normal, m.
    offset: f64,
    /// Two orthonormal directions that span the plane.
    axes: [DVec3; 2],
}

impl PlaneOfMotion {
    pub(crate) fn new(normal: DVec3, offset: f64) -> Self {
        let first = normal.any_orthonormal_vector();
        Self { normal, offset, axes: [first, normal.cross(first)] }
    }

    /// The unit normal.
    pub(crate) fn normal(&self) -> DVec3 {
        self.normal
    }

    /// Coordinates of a velocity with an angular velocity, or of a force with a moment: two in the plane, one about its
    /// normal.
    pub(crate) fn coordinates(&self, linear: DVec3, angular: DVec3) -> [f64; 3] {
        [self.axes[0].dot(linear), self.axes[1].dot(linear), self.normal.dot(angular)]
    }

    /// Linear and angular velocity with these coordinates.
    pub(crate) fn velocity(&self, coordinates: [f64; 3]) -> (DVec3, DVec3) {
        let [x, y, turn] = coordinates;
        (self.axes[0] * x + self.axes[1] * y, self.normal * turn)
    }

    /// Tangents of a contact with this unit normal, which lies in the plane: one in the plane, and the normal of the
    /// plane.
    pub(crate) fn tangents(&self, contact_normal: DVec3) -> [DVec3; 2] {
        let along = self.normal.cross(self.project_vector(contact_normal));
        [along.try_normalize().unwrap_or(self.axes[0]), self.normal]
    }

    /// Height of a point above the plane, m.
    pub(crate) fn height(&self, point: DVec3) -> f64 {
        self.normal.dot(point) - self.offset
    }

    /// Orthogonal projection of a point onto the plane.
    pub(crate) fn project_point(&self, point: DVec3) -> DVec3 {
        point - self.normal * self.height(point)
    }

    /// Component of a vector parallel to the plane.
    pub(crate) fn project_vector(&self, vector: DVec3) -> DVec3 {
        vector - self.normal * self.normal.dot(vector)
    }

    /// Projects a state onto the motion in the plane: it removes what rounding has put outside it.
    pub(crate) fn project_state(&self, state: &mut BodyState) {
        state.pose.translation = self.project_point(state.pose.translation);
        state.linear_velocity = self.project_vector(state.linear_velocity);
        state.angular_momentum = self.normal * self.normal.dot(state.angular_momentum);
    }
}
