//! The coordinate of a joint along one of its freedoms: its value, its rate, and the row of forces along it.
//!
//! | coordinate | value | row, on A; the opposite on B |
//! |---|---|---|
//! | angle about an axis `n` (unit, fixed in B) | `l atan2(n.(e_B x e_A), e_B.e_A)` | `n x e_A` at `p_A + l e_A` |
//! | displacement along an axis `d` (unit vector, fixed in B) | `d.(p_A - p_B)` | `d` at `p_A` |
//! | arc length along a track, height above one | `track.rs` | `track.rs` |
//! | distance of two points | `abs(p_A - p_B)` | `(p_A - p_B)/abs(p_A - p_B)` at `p_A` |
//!
//! `p` are the anchors (m), `e` unit vectors at right angles to the axis, one at the start, and `l` a length of the
//! joint (m) that gives angles the unit of displacements. A force at a lever stands for the moment about a hinge: the
//! hinge holds its anchor and adds the opposite force there, so that both together are the moment.
//!
//! Of each value there are the rate `u = row.(v_A - v_B)` and what its second derivative contains beside the
//! accelerations of the bodies, its bias: centripetal terms `c = w x (w x r)`, `row.(c_A - c_B)`, and those by which
//! the row turns, `2 (w_B x row).u`, of an angle `l (w_B x n).(w_A - w_B)` too, of a distance
//! `u_across^2 / abs(p_A - p_B)`. Source: Featherstone 2008, chapters 3 and 8.
//!
//! Assumptions: what the joint keeps holds. An angle is known up to whole revolutions. Two points at one place have no
//! direction: there is no row then.

pub(crate) use super::coordinate_at::CoordinateAt;
use super::coordinate_at::{AsMoment, AtLever};
use super::end::EndKinematics;
use super::line;
use super::row::RowKind;
use super::track::Guide;
use polhode_spatial::{DVec3, Rotation};
use std::f64::consts::PI;
use std::sync::Arc;

/// A coordinate of a joint.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Measured {
    /// Unit vectors: the axis in the axes of B, and those at right angles to it in the axes of A and B.
    Angle {
        axis: DVec3,
        of_a: DVec3,
        of_b: DVec3,
    },
    /// The axis in the axes of B, a unit vector.
    Displacement {
        axis: DVec3,
    },
    Distance,
    /// Arc length along a track.
    Along(Arc<Guide>),
    /// Height above the side to which a track pushes.
    Height(Arc<Guide>),
}

impl Measured {
    /// The angle about an axis of the world (unit vector), zero at the start, between bodies with these attitudes.
    pub(crate) fn angle(axis: DVec3, (a, b): (Rotation, Rotation)) -> Self {
        let across = axis.any_orthonormal_vector();
        Self::Angle { axis: b.inverse_rotate(axis), of_a: a.inverse_rotate(across), of_b: b.inverse_rotate(across) }
    }

    /// The displacement along an axis of the world (unit vector), zero at the start, fixed in a body with this
    /// attitude.
    pub(crate) fn displacement(axis: DVec3, b: Rotation) -> Self {
        Self::Displacement { axis: b.inverse_rotate(axis) }
    }

    /// Its axis in the axes of B, a unit vector.
    pub(crate) fn axis(&self) -> Option<DVec3> {
        match *self {
            Self::Angle { axis, .. } | Self::Displacement { axis } => Some(axis),
            Self::Distance | Self::Along(_) | Self::Height(_) => None,
        }
    }

    /// The coordinate of these ends. `length` is that of the joint, m; an angle is given within half a revolution of
    /// `near` (its arc, m).
    pub(crate) fn at(&self, a: &EndKinematics, b: &EndKinematics, length: f64, near: f64) -> Option<CoordinateAt> {
        match *self {
            Self::Angle { axis, of_a, of_b } => Some(angle((axis, of_a, of_b), a, b, length, near)),
            Self::Displacement { axis } => {
                let way = a.point - b.point;
                let row = line::row(axis, way, a, &b.at_point(a.point));
                let RowKind::Along(direction) = row.kind else { return None };
                Some(CoordinateAt::displacement(&row, a.point, direction))
            }
            Self::Distance => distance(a, b),
            Self::Along(ref guide) => Some(guide.along(a, b, near)),
            Self::Height(ref guide) => guide.height(a, b),
        }
    }
}

fn angle(
    (axis, of_a, of_b): (DVec3, DVec3, DVec3),
    a: &EndKinematics,
    b: &EndKinematics,
    length: f64,
    near: f64,
) -> CoordinateAt {
    let (axis, at_b) = (b.rotation.rotate(axis), b.rotation.rotate(of_b));
    let at_a = a.rotation.rotate(of_a);
    let angle = libm::atan2(axis.dot(at_b.cross(at_a)), at_b.dot(at_a));
    let whole = libm::round((near / length - angle) / (2.0 * PI));
    let turns = a.angular - b.angular;
    let turning = length * b.angular.cross(axis).dot(turns);
    let at_lever = |lever: DVec3| {
        let direction = axis.cross(lever);
        // What the joint keeps at the anchor determines the acceleration there along the direction of the force.
        let kept = line::bias(direction, a, &b.at_point(a.point));
        let point = a.point + lever * length;
        let slip = a.at_point(point).velocity - b.at_point(point).velocity;
        AtLever { point, direction, rate: direction.dot(slip), bias: kept + turning }
    };
    let AtLever { point, direction, rate, bias } = at_lever(at_a);
    CoordinateAt {
        value: length * (angle + 2.0 * PI * whole),
        rate,
        bias,
        point,
        direction,
        moment: Some(AsMoment { axis: axis * length, rate: length * axis.dot(turns), bias: turning }),
        at_second: Some(at_lever(at_b)),
    }
}

/// The distance of two ends; none at one place, where it has no direction.
pub(crate) fn distance(a: &EndKinematics, b: &EndKinematics) -> Option<CoordinateAt> {
    let way = a.point - b.point;
    let value = way.length();
    let direction = way.try_normalize()?;
    let slip = a.velocity - b.velocity;
    let rate = direction.dot(slip);
    let across = (slip - direction * rate).length_squared();
    let bias = direction.dot(a.acceleration - b.acceleration) + across / value;
    Some(CoordinateAt { value, rate, bias, point: a.point, direction, moment: None, at_second: None })
}
