//! What sequential impulses are given of a face on which two bodies touch, and what they give back.

use polhode_spatial::DVec3;

/// Most points of one manifold: others of the same face add nothing that a rigid body could feel.
pub const MOST_POINTS: usize = 4;

/// One point of a manifold at the start of a step.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ManifoldPoint {
    /// From the centre of mass of A to the point, m, world.
    pub arm: DVec3,
    /// Signed distance along the normal, m.
    pub separation: f64,
    /// Impulse that the first substep starts from: along the normal and the two tangents, N s.
    pub impulse: [f64; 3],
}

/// Up to four points at which two bodies touch or may touch in this step, with one normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpulseManifold {
    /// Numbers of A and B, of which an impulse moves at least one.
    pub bodies: [u32; 2],
    /// Unit normal from B to A, world.
    pub normal: DVec3,
    /// A unit tangent, world; the other one is `normal x tangent`.
    pub tangent: DVec3,
    /// From the centre of mass of B to that of A, m, world.
    pub between: DVec3,
    /// Coefficient of friction (no unit).
    pub friction: f64,
    /// Coefficient of restitution (no unit).
    pub restitution: f64,
    /// The points.
    pub points: [ManifoldPoint; MOST_POINTS],
    /// How many of them there are.
    pub count: usize,
}

/// What became of a point.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PointImpulse {
    /// Impulse of the last substep along normal and tangents, N s: the next step starts from it.
    pub last: [f64; 3],
    /// Impulse of the whole step, N s.
    pub total: [f64; 3],
    /// Rate of separation at the start of the step, m/s.
    pub rate: f64,
    /// Separation after the last movement, m.
    pub separation: f64,
}
