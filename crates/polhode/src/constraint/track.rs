//! A point of a body on a track: a curve fixed in the other body or in the world.
//!
//! In the axes of the curve, let `q` be the point of A, `u` its velocity relative to B, `c(s)` its foot on the curve
//! with the tangent `t` and `k = dt/ds`, and `d = q - c`. From `t.d = 0` follows `s' = t.u / (1 - k.d)`. There are
//!
//! | row | gap or value | rate | bias: what its second derivative contains beside accelerations |
//! |---|---|---|---|
//! | across, `n`, at right angles to `t` | `n.d` | `n.u` | `c_n - s' (n.k) (t.u)` |
//! | along, `t` | `s` | `t.u` | `c_t + s' k.u` |
//!
//! where `c_n` are the centripetal and Coriolis terms of `line.rs`. On the track, `d = 0`, the first is that of the
//! centripetal force `m v^2 k`. A track that holds from both sides has two rows across; one that holds from one side
//! has that of its plane as a row, and the other as a stop (`stop.rs`): it closes, strikes, presses and opens as
//! contacts do, so that a body leaves where its force is zero.
//!
//! Sources: thesis, section on penalty methods (the roller coaster); do Carmo 1976, chapter 1; Featherstone 2008,
//! chapter 8. Assumption: the point stays within the radius of curvature while it is held; away from the track, in
//! flight, the values across are distances from the nearest place, and the rows along it act on nothing. No memory: the
//! foot depends on the pose alone (`polhode_spatial::curve`).

use super::coordinate_at::CoordinateAt;
use super::end::EndKinematics;
use super::line;
use super::row::{BilateralRow, RowKind};
use polhode_spatial::curve::{Curve, CurvePlane, CurvePoint};
use polhode_spatial::{DVec3, Rotation};
use std::sync::Arc;

/// Least value of `1 - k.d` (no unit): nearer to a centre of curvature the foot runs along the curve faster than any
/// step follows. Only points in flight come there.
const LEAST_STRETCH: f64 = 1e-3;

/// A reference direction at an angle to the tangent whose sine is below this is replaced (no unit, 0.01 to 0.5).
const LEAST_ANGLE: f64 = 0.1;

/// How far beyond an end of a track a body has left it, as a part of its length: rounding of a body that starts at the
/// end (no unit, 1e-15 to 1e-11).
const BEYOND_END: f64 = 1e-13;

/// How many rows a track has that holds from both sides.
pub(crate) const ROWS: usize = 2;

/// A track as the end of a joint sees it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Guide {
    curve: Arc<Curve>,
    /// The place of the curve's frame at which B holds the joint, m.
    origin: DVec3,
    /// Attitude of B at the start, when the frame of the curve is that of the world.
    attitude: Rotation,
    /// The normal of its plane; of a curve in no plane a reference direction. Unit vector, in the frame of the curve.
    normal: DVec3,
    /// 1 where the side to which a track with one side pushes is `normal x t`, otherwise -1.
    side: f64,
    /// Arc length of the foot at the start, m.
    start: f64,
}

/// A point near a track, in the frame of the curve.
#[derive(Debug, Clone, Copy)]
struct Near {
    foot: CurvePoint,
    /// `d`, m.
    way: DVec3,
    /// `u`, m/s.
    slip: DVec3,
    /// `s'`, m/s.
    rate: f64,
}

impl Guide {
    /// The track of a joint that holds its second body, which has this attitude, at a point of the world (m). Of one
    /// with one side, `towards` points to it (unit vector, world).
    pub(crate) fn new(curve: &Arc<Curve>, origin: DVec3, attitude: Rotation, towards: Option<DVec3>) -> Self {
        let foot = curve.nearest(origin);
        let reference = match (curve.plane(), towards) {
            (CurvePlane::Plane(normal), _) => normal.get(),
            (CurvePlane::Straight, Some(towards)) => {
                foot.tangent.cross(towards).normalize_or(foot.tangent.any_orthonormal_vector())
            }
            (CurvePlane::Straight | CurvePlane::None, _) => foot.tangent.any_orthonormal_vector(),
        };
        let pushes = towards.map_or(1.0, |towards| reference.cross(foot.tangent).dot(towards));
        let side = if pushes < 0.0 { -1.0 } else { 1.0 };
        Self { curve: Arc::clone(curve), origin, attitude, normal: reference, side, start: foot.arc }
    }

    /// The normal of the plane of the track at the start, unit vector, world.
    pub(crate) fn plane_normal(&self) -> DVec3 {
        self.normal
    }

    /// The arc lengths of the ends of an open track from the foot at the start, m.
    pub(crate) fn ends(&self) -> Option<[f64; 2]> {
        (!self.curve.is_closed()).then(|| [-self.start, self.curve.length() - self.start])
    }

    /// Whether a point is beyond an end of an open track.
    pub(crate) fn is_beyond(&self, a: &EndKinematics, b: &EndKinematics) -> bool {
        let length = self.curve.length();
        let arc = self.curve.nearest(self.origin + self.to_curve(b, a.point - b.point)).arc;
        !self.curve.is_closed() && (arc < -BEYOND_END * length || arc > (1.0 + BEYOND_END) * length)
    }

    fn to_curve(&self, b: &EndKinematics, vector: DVec3) -> DVec3 {
        self.attitude.rotate(b.rotation.inverse_rotate(vector))
    }

    fn to_world(&self, b: &EndKinematics, vector: DVec3) -> DVec3 {
        b.rotation.rotate(self.attitude.inverse_rotate(vector))
    }

    fn near(&self, a: &EndKinematics, b: &EndKinematics) -> Near {
        let point = self.origin + self.to_curve(b, a.point - b.point);
        let foot = self.curve.nearest(point);
        let slip = self.to_curve(b, a.velocity - b.at_point(a.point).velocity);
        let way = point - foot.point;
        let stretch = (1.0 - foot.curvature.dot(way)).max(LEAST_STRETCH);
        Near { foot, way, slip, rate: foot.tangent.dot(slip) / stretch }
    }

    /// The place of the point on the curve, and the row along it.
    pub(crate) fn place(&self, a: &EndKinematics, b: &EndKinematics) -> (CurvePoint, CoordinateAt) {
        let near = self.near(a, b);
        (near.foot, self.along_at(&near, a, b, 0.0))
    }

    /// The rotation from the frame of the curve to the world.
    pub(crate) fn rotation(&self, b: &EndKinematics) -> Rotation {
        b.rotation * self.attitude.inverse()
    }

    /// The place at the start.
    pub(crate) fn start(&self) -> CurvePoint {
        self.curve.nearest(self.origin)
    }

    /// The rows across the track.
    pub(crate) fn rows(&self, a: &EndKinematics, b: &EndKinematics) -> [BilateralRow; ROWS] {
        let near = self.near(a, b);
        self.across(&near).map(|direction| self.row(&near, direction, a, b))
    }

    /// Two unit vectors at right angles to the tangent and to each other, the first one in the plane of the curve.
    fn across(&self, near: &Near) -> [DVec3; ROWS] {
        let tangent = near.foot.tangent;
        let first = self.normal.cross(tangent);
        let length = first.length();
        let first = if length > LEAST_ANGLE { first / length } else { tangent.any_orthonormal_vector() };
        [first, tangent.cross(first)]
    }

    /// The row across the track along a unit vector of the frame of the curve.
    fn row(&self, near: &Near, direction: DVec3, a: &EndKinematics, b: &EndKinematics) -> BilateralRow {
        let along = near.foot.tangent.dot(near.slip);
        let turning = near.rate * along * direction.dot(near.foot.curvature);
        let world = self.to_world(b, direction);
        BilateralRow {
            kind: RowKind::Along(world),
            gap: direction.dot(near.way),
            rate: direction.dot(near.slip),
            bias: line::bias(world, a, &b.at_point(a.point)) - turning,
        }
    }

    /// The height above the side to which the track pushes.
    pub(crate) fn height(&self, a: &EndKinematics, b: &EndKinematics) -> Option<CoordinateAt> {
        let near = self.near(a, b);
        let direction = self.normal.cross(near.foot.tangent) * self.side;
        let row = self.row(&near, direction, a, b);
        let RowKind::Along(direction) = row.kind else { return None };
        Some(CoordinateAt::displacement(&row, a.point, direction))
    }

    /// The arc length from the foot at the start, within half a round of `near_value` on a closed track, m.
    pub(crate) fn along(&self, a: &EndKinematics, b: &EndKinematics, near_value: f64) -> CoordinateAt {
        self.along_at(&self.near(a, b), a, b, near_value)
    }

    fn along_at(&self, near: &Near, a: &EndKinematics, b: &EndKinematics, near_value: f64) -> CoordinateAt {
        let mut value = near.foot.arc - self.start;
        if self.curve.is_closed() {
            let round = self.curve.length();
            value += round * libm::round((near_value - value) / round);
        }
        let tangent = near.foot.tangent;
        let direction = self.to_world(b, tangent);
        let bias = line::bias(direction, a, &b.at_point(a.point)) + near.rate * near.foot.curvature.dot(near.slip);
        let row = BilateralRow { kind: RowKind::Along(direction), gap: value, rate: tangent.dot(near.slip), bias };
        CoordinateAt::displacement(&row, a.point, direction)
    }

    /// The way from the foot and the velocity across the track, world (m, m/s), with the tangent.
    pub(crate) fn deviation(&self, a: &EndKinematics, b: &EndKinematics) -> Deviation {
        let near = self.near(a, b);
        let tangent = near.foot.tangent;
        let across = near.slip - tangent * tangent.dot(near.slip);
        Deviation {
            way: self.to_world(b, near.way),
            velocity: self.to_world(b, across),
            tangent: self.to_world(b, tangent),
        }
    }
}

/// How a point is off a track, world.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Deviation {
    /// From the foot to the point, m.
    pub(crate) way: DVec3,
    /// Across the track, m/s.
    pub(crate) velocity: DVec3,
    /// Unit vector.
    pub(crate) tangent: DVec3,
}
