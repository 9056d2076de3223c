//! The plane of a planar motion, the coordinates of velocities in it (two of the velocity in the plane, one of the
//! angular velocity about its normal), and the bodies that move in it. `planar.rs` finds out which these are.
//!
//! What holds for bodies in the plane holds as long as they meet no others ([`PlanarBodies::meet`]): a body whose
//! motion is not its own mirror image pushes those that it touches out of the plane, and these push others. A tier asks
//! before it looks for contacts.

use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;
use serde::{Deserialize, Serialize};

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

/// How a body stands to the plane of motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Membership {
    /// It moves in the plane.
    InPlane,
    /// Forces do not move it, and it is its own mirror image.
    OwnImage,
    /// Its motion or shape is not its own mirror image.
    Outside,
}

/// The plane and its bodies as plain data: normal, offset (m), and how each body stands to it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct PlanarParts {
    normal: [f64; 3],
    offset: f64,
    members: Vec<Membership>,
}

/// The bodies that move in the plane of a planar motion.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct PlanarBodies {
    plane: Option<PlaneOfMotion>,
    /// Of each body; a body that was added later is outside.
    members: Vec<Membership>,
}

impl PlanarBodies {
    /// Those of a plane.
    pub(crate) fn new(plane: PlaneOfMotion, members: Vec<Membership>) -> Self {
        Self { plane: Some(plane), members }
    }

    /// The plane, if any body moves in it.
    pub(crate) fn plane(&self) -> Option<PlaneOfMotion> {
        self.plane
    }

    /// How a body stands to the plane.
    pub(crate) fn membership(&self, body: usize) -> Membership {
        self.members.get(body).copied().unwrap_or(Membership::Outside)
    }

    /// Whether a body moves in the plane.
    pub(crate) fn contains(&self, body: usize) -> bool {
        self.plane.is_some() && self.membership(body) == Membership::InPlane
    }

    /// The bodies that move in the plane, ascending.
    pub(crate) fn bodies(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.members.len()).filter(|&body| self.contains(body))
    }

    /// The plane of a contact of two bodies: of those of which one moves in it and neither is outside.
    pub(crate) fn of_pair(&self, a: usize, b: usize) -> Option<PlaneOfMotion> {
        let plane = self.plane?;
        let members = [a, b].map(|body| self.membership(body));
        (members.contains(&Membership::InPlane) && !members.contains(&Membership::Outside)).then_some(plane)
    }

    /// The plane in which all of these movable bodies move.
    pub(crate) fn of_group(&self, bodies: &[usize]) -> Option<PlaneOfMotion> {
        self.plane.filter(|_| bodies.iter().all(|&body| self.contains(body)))
    }

    /// Whether one of two bodies moves in the plane and the other is outside: where they touch the motion of the former
    /// leaves the plane.
    pub(crate) fn part(&self, (a, b): (usize, usize)) -> bool {
        let members = [a, b].map(|body| self.membership(body));
        self.plane.is_some() && members.contains(&Membership::InPlane) && members.contains(&Membership::Outside)
    }

    /// Bodies in the plane meet others at these pairs: they are outside from now on, and so are those in the plane that
    /// they meet in turn. Returns them.
    pub(crate) fn meet(&mut self, pairs: &[(usize, usize)]) -> Vec<usize> {
        let mut met = Vec::new();
        while let Some(&(a, b)) = pairs.iter().find(|&&pair| self.part(pair)) {
            let inside = if self.contains(a) { a } else { b };
            self.release(&[inside]);
            met.push(inside);
        }
        met
    }

    /// These bodies are outside from now on.
    pub(crate) fn release(&mut self, bodies: &[usize]) {
        for &body in bodies {
            if let Some(membership) = self.members.get_mut(body) {
                *membership = Membership::Outside;
            }
        }
        if !self.members.contains(&Membership::InPlane) {
            self.plane = None;
        }
    }

    /// As plain data; none without a plane.
    pub(crate) fn parts(&self) -> Option<PlanarParts> {
        let PlaneOfMotion { normal, offset, .. } = self.plane?;
        Some(PlanarParts { normal: normal.to_array(), offset, members: self.members.clone() })
    }

    /// From such data.
    pub(crate) fn of_parts(parts: Option<&PlanarParts>) -> Self {
        let plane = |own: &PlanarParts| PlaneOfMotion::new(DVec3::from_array(own.normal), own.offset);
        parts.map_or_else(Self::default, |own| Self::new(plane(own), own.members.clone()))
    }

    /// The same of which only these bodies move in the plane still.
    pub(crate) fn restored(&self, in_plane: &[usize]) -> Self {
        let gone: Vec<usize> = self.bodies().filter(|body| !in_plane.contains(body)).collect();
        let mut restored = self.clone();
        restored.release(&gone);
        restored
    }

    /// Those that are among `others` too, in the same plane.
    pub(crate) fn among(&self, others: &Self) -> Self {
        if self.plane != others.plane {
            return Self::default();
        }
        let gone: Vec<usize> =
            (0..self.members.len()).filter(|&body| others.membership(body) == Membership::Outside).collect();
        let mut both = self.clone();
        both.release(&gone);
        both
    }
}
