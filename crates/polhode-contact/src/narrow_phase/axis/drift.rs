//! Bounds of how much the separations along the face normals of two bodies have changed since an earlier relative pose.
//! The formula is in `coherence.rs`.

use crate::shape::polyhedron::ConvexPolyhedron;
use glam::DVec3;
use polhode_spatial::Pose;

/// The relative pose at which data were stored.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Drift {
    /// Pose of B in A's frame.
    relative: Pose,
    /// Lever arms: a rotation by an angle changes heights above the faces of A and of B by at most the angle times
    /// these, m.
    pub(crate) levers: [f64; 2],
}

impl Drift {
    /// Starts at this relative pose.
    pub(crate) fn since(a: &ConvexPolyhedron, b: &ConvexPolyhedron, x_ab: &Pose) -> Self {
        Self { relative: *x_ab, levers: [radius(&b.vertices), radius(&a.vertices) + x_ab.translation.length()] }
    }

    /// Bounds of the change of heights above planes of A and of B, m.
    #[inline]
    pub(crate) fn changes(&self, x_ab: &Pose) -> [f64; 2] {
        let shift = (x_ab.translation - self.relative.translation).length();
        let (before, now) = (self.relative.rotation.quaternion(), x_ab.rotation.quaternion());
        // A quaternion and its negative are the same rotation.
        let nearest = (now - before).length_squared().min((now + before).length_squared());
        let turn = 2.0 * nearest.sqrt();
        self.levers.map(|lever| shift + lever * turn)
    }
}

/// Largest distance of some points from the origin, m.
fn radius(points: &[DVec3]) -> f64 {
    points.iter().map(|p| p.length_squared()).fold(0.0, f64::max).sqrt()
}
