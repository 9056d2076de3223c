//! Quaternions: `q' = q (0, w)/2`, w in body axes (thesis 3.3: `q' = (0, w) q/2`, w in world axes).
//!
//! The method moves q off the unit sphere by its truncation error, `|q|` falling by about `(h |w|)^6/9216` a step for a
//! steady spin; normalising keeps the order and costs a root. Without it the attitude still follows the direction of q,
//! but vectors are turned by the thesis's matrix of a quaternion that is no longer of length one, which is no rotation:
//! a steady spin begins to wobble, and errors depend on the axes that the motion is written in.

use super::super::body_axes::{quaternion_rate, to_body, to_world};
use super::super::one_step::Span;
use super::{Frame, Representation};
use crate::integrator::IntegrationError;
use glam::{DQuat, DVec3};
use polhode_spatial::Rotation;

/// Turns vectors as the direction of the quaternion does, whatever its length.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DirectionFrame {
    q: DQuat,
    /// `1/|q|^2`.
    scale: f64,
}

impl DirectionFrame {
    #[inline]
    fn new(q: DQuat) -> Self {
        Self { q, scale: 1.0 / q.length_squared() }
    }
}

impl Frame for DirectionFrame {
    #[inline]
    fn to_body(self, vector: DVec3) -> DVec3 {
        to_body(self.q, vector) * self.scale
    }

    #[inline]
    fn to_world(self, vector: DVec3) -> DVec3 {
        to_world(self.q, vector) * self.scale
    }
}

/// Normalised after each step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Quaternion;

impl Representation for Quaternion {
    type Coordinates = DQuat;
    type Frame = DirectionFrame;

    fn of(rotation: Rotation) -> DQuat {
        rotation.quaternion()
    }

    #[inline]
    fn rotation(q: &DQuat) -> Rotation {
        Rotation::renormalized(*q)
    }

    #[inline]
    fn frame(q: &DQuat) -> DirectionFrame {
        DirectionFrame::new(*q)
    }

    #[inline]
    fn rate(q: &DQuat, w: DVec3, _span: Span) -> Result<DQuat, IntegrationError> {
        Ok(quaternion_rate(*q, w))
    }

    #[inline]
    fn settled(q: DQuat) -> DQuat {
        Rotation::renormalized(q).quaternion()
    }

    #[inline]
    fn is_finite(q: &DQuat) -> bool {
        q.is_finite()
    }
}

/// Never normalised.
#[derive(Debug, Clone, Copy)]
pub(crate) struct QuaternionUnnormalized;

/// The thesis's matrix of a quaternion of any length: a rotation only for length one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct UnnormalizedFrame(DQuat);

impl Frame for UnnormalizedFrame {
    fn to_body(self, vector: DVec3) -> DVec3 {
        Self(self.0.conjugate()).to_world(vector)
    }

    fn to_world(self, vector: DVec3) -> DVec3 {
        // The matrix of the thesis has 1 - 2 (y^2 + z^2) on its diagonal; as products it is Rodrigues' formula.
        let u = DVec3::new(self.0.x, self.0.y, self.0.z);
        let t = u.cross(vector) * 2.0;
        vector + t * self.0.w + u.cross(t)
    }
}

impl Representation for QuaternionUnnormalized {
    type Coordinates = DQuat;
    type Frame = UnnormalizedFrame;

    fn of(rotation: Rotation) -> DQuat {
        rotation.quaternion()
    }

    #[inline]
    fn rotation(q: &DQuat) -> Rotation {
        Rotation::renormalized(*q)
    }

    #[inline]
    fn frame(q: &DQuat) -> UnnormalizedFrame {
        UnnormalizedFrame(*q)
    }

    #[inline]
    fn rate(q: &DQuat, w: DVec3, _span: Span) -> Result<DQuat, IntegrationError> {
        Ok(quaternion_rate(*q, w))
    }

    #[inline]
    fn is_finite(q: &DQuat) -> bool {
        q.is_finite()
    }
}

/// Cut to x, y, z after each step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct QuaternionThreeNumbers;

/// What three numbers keep of a quaternion: that of its two signs with `w >= 0`, and w as their length gives it. An
/// error of 1 ulp in them is one of `1/w` ulp in w (erratum E10).
fn from_three_numbers(q: DQuat) -> DQuat {
    let q = Rotation::renormalized(q).quaternion();
    let q = if q.w < 0.0 { -q } else { q };
    let w = (1.0 - (q.x * q.x + q.y * q.y + q.z * q.z)).max(0.0).sqrt();
    DQuat::from_xyzw(q.x, q.y, q.z, w)
}

impl Representation for QuaternionThreeNumbers {
    /// All four within a step, so that a step through w = 0 is as good as any other; what is carried from step to step
    /// are three.
    type Coordinates = DQuat;
    type Frame = DirectionFrame;

    fn of(rotation: Rotation) -> DQuat {
        from_three_numbers(rotation.quaternion())
    }

    #[inline]
    fn rotation(q: &DQuat) -> Rotation {
        Rotation::renormalized(*q)
    }

    #[inline]
    fn frame(q: &DQuat) -> DirectionFrame {
        DirectionFrame::new(*q)
    }

    #[inline]
    fn rate(q: &DQuat, w: DVec3, _span: Span) -> Result<DQuat, IntegrationError> {
        Ok(quaternion_rate(*q, w))
    }

    #[inline]
    fn settled(q: DQuat) -> DQuat {
        from_three_numbers(q)
    }

    #[inline]
    fn is_finite(q: &DQuat) -> bool {
        q.is_finite()
    }
}
