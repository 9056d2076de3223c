//! Axis-aligned bounding boxes of shapes at rest and in motion.

use super::aabb::{Aabb, AabbError, ROUNDING_ULPS};
use crate::Shape;
use crate::shape::extent::turned;
use crate::shape::round;
use glam::{DMat3, DVec3};
use polhode_spatial::{Motion, Pose, Rotation};
use std::cell::OnceCell;

/// A box that contains the shape at a pose. A half-space is unbounded.
///
/// # Errors
/// When the pose is not finite.
pub fn aabb_of(shape: &Shape, pose: &Pose) -> Result<Aabb, AabbError> {
    if let Shape::HalfSpace(_) = shape {
        return if pose.is_finite() {
            Ok(Aabb::UNBOUNDED)
        } else {
            Aabb::new(pose.translation * f64::NAN, pose.translation)
        };
    }
    let (low, high) = extents(shape, &axes_seen(pose.rotation));
    let place = pose.translation;
    let rounding = ROUNDING_ULPS * f64::EPSILON * (low.abs().max(high.abs()).max_element() + place.abs());
    Aabb::new(place + low - rounding, place + high + rounding)
}

/// A box that contains the shape at every time of `[t0, t1]` (s).
///
/// Let a, v and w be the bounds of acceleration, speed and angular speed over the duration T. The centre of mass stays
/// within `v T` of its start, and within `a T^2/8` of the straight line between its first and its last position. Seen
/// from the centre of mass, a point at the distance r from it stays within `r min(w T/2, 2)` of its place at the middle
/// of the interval. A half-space is unbounded.
///
/// # Errors
/// When the interval is not finite or reversed, or the motion is not finite.
pub fn swept_aabb(shape: &Shape, motion: &dyn Motion, t0: f64, t1: f64) -> Result<Aabb, AabbError> {
    Sweep::new(motion, t0, t1)?.of(shape)
}

/// Bounds of a motion over an interval, computed once for all parts of a body.
pub(crate) struct Sweep<'a> {
    motion: &'a dyn Motion,
    /// Bounds of the centre of mass, m.
    low: DVec3,
    high: DVec3,
    /// `min(w T/2, 2)`, half of the largest angle of rotation (rad); at 2 a point may be anywhere on its sphere.
    turn: f64,
    /// Middle of the interval, s.
    middle: f64,
    /// Rotation at the middle, computed when first needed: the box of a ball does not need it.
    rotation: OnceCell<(Rotation, DMat3)>,
}

impl<'a> Sweep<'a> {
    /// # Errors
    /// When the interval is not finite or reversed.
    pub(crate) fn new(motion: &'a dyn Motion, t0: f64, t1: f64) -> Result<Self, AabbError> {
        if !(t0.is_finite() && t1.is_finite() && t0 <= t1) {
            return Err(AabbError::Interval { t0, t1 });
        }
        let duration = t1 - t0;
        let bounds = motion.bounds(t0, t1);
        let (start, end) = (motion.position(t0), motion.position(t1));
        let sag = DVec3::splat(bounds.acceleration * duration * duration / 8.0);
        let path = DVec3::splat(bounds.speed * duration);
        let (low, high) = (start.min(end) - sag, start.max(end) + sag);
        let (low, high) = (low.max(start - path), high.min(start + path));
        let turn = (0.5 * bounds.angular_speed * duration).min(2.0);
        Ok(Self { motion, low, high, turn, middle: t0 + 0.5 * duration, rotation: OnceCell::new() })
    }

    /// The rotation at the middle of the interval, and the world's axes in the body's frame.
    fn rotation(&self) -> &(Rotation, DMat3) {
        self.rotation.get_or_init(|| {
            let rotation = self.motion.pose(self.middle).rotation;
            (rotation, axes_seen(rotation))
        })
    }

    /// A box that contains a shape throughout.
    ///
    /// # Errors
    /// When the motion is not finite.
    pub(crate) fn of(&self, shape: &Shape) -> Result<Aabb, AabbError> {
        if let Shape::HalfSpace(_) = shape {
            return Ok(Aabb::UNBOUNDED);
        }
        if let Shape::Compound(compound) = shape {
            let mut boxes = compound.parts().iter().map(|part| self.of(part));
            let Some(first) = boxes.next() else { return Ok(Aabb::UNBOUNDED) };
            return boxes.try_fold(first?, |whole, part| Ok(whole.merged(&part?)));
        }
        let (low, high) = (self.low, self.high);
        let (spread_low, spread_high) = self.turning_extent(shape);
        let largest = low.abs().max(high.abs()) + spread_high.abs().max(spread_low.abs());
        let rounding = ROUNDING_ULPS * f64::EPSILON * largest;
        Aabb::new(low + spread_low - rounding, high + spread_high + rounding)
    }

    /// A box that contains a box fixed in the body throughout; for the boxes of a tree of parts.
    pub(crate) fn of_box(&self, fixed: Aabb) -> Aabb {
        let stray = fixed.min.abs().max(fixed.max.abs()).length() * self.turn;
        let (rotation, _) = self.rotation();
        let around = turned(fixed, &Pose { rotation: *rotation, translation: DVec3::ZERO }).widened(stray);
        let largest = self.low.abs().max(self.high.abs()) + around.min.abs().max(around.max.abs());
        let rounding = ROUNDING_ULPS * f64::EPSILON * largest;
        Aabb { min: self.low + around.min - rounding, max: self.high + around.max + rounding }
    }

    /// Bounds of the shape's points relative to the centre of mass, along the world's axes.
    fn turning_extent(&self, shape: &Shape) -> (DVec3, DVec3) {
        // A ball about the centre of mass does not change under rotation.
        if let Shape::Sphere(sphere) = shape
            && sphere.center == DVec3::ZERO
        {
            return (DVec3::splat(-sphere.radius), DVec3::splat(sphere.radius));
        }
        let radius = shape.radius();
        let ball = DVec3::splat(radius);
        let stray = DVec3::splat(radius * self.turn);
        let (rotation, axes) = self.rotation();
        if let Shape::TriangleMesh(mesh) = shape {
            // The corners of the mesh's bounding box bound its many vertices.
            let around = turned(mesh.bounds(), &Pose { rotation: *rotation, translation: DVec3::ZERO });
            return (around.min - stray, around.max + stray);
        }
        let (low, high) = extents(shape, axes);
        ((low - stray).max(-ball), (high + stray).min(ball))
    }
}

/// The world's axes in the frame of a body at this rotation.
fn axes_seen(rotation: Rotation) -> DMat3 {
    let [x, y, z] = DVec3::AXES.map(|axis| rotation.inverse_rotate(axis));
    DMat3::from_cols(x, y, z)
}

/// Least and largest `d . x` over the points of a bounded shape for three unit vectors d of its frame, the columns of
/// `axes`, m. One pass over the vertices serves all three.
fn extents(shape: &Shape, axes: &DMat3) -> (DVec3, DVec3) {
    match shape {
        Shape::TriangleMesh(mesh) => spread(mesh.used_vertices(), axes),
        Shape::Compound(compound) => {
            let parts = compound.parts.iter().map(|part| extents(part, axes));
            parts.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), part| (low.min(part.0), high.max(part.1)))
        }
        Shape::Cylinder(_) | Shape::Cone(_) | Shape::Torus(_) => {
            let directions = axes.to_cols_array_2d().map(DVec3::from);
            let supports = |sign: f64| DVec3::from_array(directions.map(|d| round::support(shape, sign * d)));
            (-supports(-1.0), supports(1.0))
        }
        _ => {
            let (centers, radius) = shape.centers();
            let (low, high) = spread(centers.iter().copied(), axes);
            (low - radius, high + radius)
        }
    }
}

/// The same for points.
fn spread(points: impl Iterator<Item = DVec3>, axes: &DMat3) -> (DVec3, DVec3) {
    let across = axes.transpose();
    let heights = Aabb::of_points(points.map(|point| across * point));
    (heights.min, heights.max)
}
