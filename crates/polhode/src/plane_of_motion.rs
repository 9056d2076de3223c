//! The plane in which the bodies of a scene move, and the coordinates of that motion: two of a velocity in the plane,
//! one of the angular velocity about its normal. When a scene moves in one is found in `planar.rs`.

use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// The plane in which a scene moves: `normal . x = offset`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PlaneOfMotion {
    normal: DVec3,
    /// m.
    offset: f64,
    /// Two directions that span the plane.
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

    /// Coordinates of a velocity or force with a moment: two in the plane, one about its normal.
    pub(crate) fn coordinates(&self, linear: DVec3, angular: DVec3) -> [f64; 3] {
        [self.axes[0].dot(linear), self.axes[1].dot(linear), self.normal.dot(angular)]
    }

    /// Linear and angular part of a velocity of the plane.
    pub(crate) fn velocity(&self, coordinates: [f64; 3]) -> (DVec3, DVec3) {
        let [x, y, turn] = coordinates;
        (self.axes[0] * x + self.axes[1] * y, self.normal * turn)
    }

    /// Height of a point above the plane, m.
    pub(crate) fn height(&self, point: DVec3) -> f64 {
        self.normal.dot(point) - self.offset
    }

    /// The point of the plane below a point.
    pub(crate) fn project_point(&self, point: DVec3) -> DVec3 {
        point - self.normal * self.height(point)
    }

    /// The part of a vector in the plane.
    pub(crate) fn project_vector(&self, vector: DVec3) -> DVec3 {
        vector - self.normal * self.normal.dot(vector)
    }

    /// Takes from a state what rounding has left outside the motion in the plane.
    pub(crate) fn project_state(&self, state: &mut BodyState) {
        state.pose.translation = self.project_point(state.pose.translation);
        state.linear_velocity = self.project_vector(state.linear_velocity);
        state.angular_momentum = self.normal * self.normal.dot(state.angular_momentum);
    }
}
