//! How far heights above the faces of two bodies may have changed since they lay otherwise; the reasoning stands in
//! `coherence.rs`.

use crate::shape::polyhedron::ConvexPolyhedron;
use glam::DVec3;
use polhode_spatial::Pose;

/// How the bodies lay when something was kept.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Drift {
    /// Pose of B in A's frame.
    relative: Pose,
    /// Lengths that turn into changes of heights above the faces of A and of B, m.
    pub(crate) levers: [f64; 2],
}

impl Drift {
    /// From now on.
    pub(crate) fn since(a: &ConvexPolyhedron, b: &ConvexPolyhedron, x_ab: &Pose) -> Self {
        Self { relative: *x_ab, levers: [radius(&b.vertices), radius(&a.vertices) + x_ab.translation.length()] }
    }

    /// How much heights above planes of A and of B may have changed, m.
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
