//! A face along which two convex bodies pass each other.
//!
//! Two convex bodies that touch move on without an impact as long as one direction remains along which they do not
//! overlap. At the border of a face several directions separate bodies that touch: the normal of the face, that of the
//! face beyond the border, and those between. The bodies collide only if they approach along all of them. A body that
//! slides on a plane and reaches the edge of a second body whose top is flush with the plane approaches along the
//! normal of the side of that body, but not along that of its top: it passes over the edge.
//!
//! For a face of body X with the outward unit normal `n` through `x`, and the other body Y, the separation along the
//! face's normal and its rate are
//!
//! `chi = min_y n.(y - x)`, `chi' = min n.(v_Y - v_X + (w_Y - w_X) x r_y)` over the points `y` of the first minimum,
//!
//! with velocities at these points, and the normal fixed to X. The face is **open** when `chi >= -d`, with the touch
//! distance `d` of the pair, and `chi' >= -NOT_APPROACHING v`, with the sum `v` of the speeds of both bodies there.
//! Nothing but the two bodies and their motion decides.
//!
//! For the surface of several bodies this means: a step up to the touch distance is passed, a higher one trips, and a
//! gap does not matter to a body that has not sunk into it.
//!
//! Limits: a half-space has no border and a mesh no inside, so that neither has an open face.

use crate::shape::circle::Circle;
use crate::shape::round::{circles, hull_points};
use crate::{Shape, Side};
use glam::DVec3;
use polhode_spatial::{Pose, Velocity};

/// Bodies whose separation shrinks by less than this part of their speeds do not approach (no unit, 1e-12 to 1e-7):
/// above the error of velocities within a step. A separation that goes on to shrink is found as an impact later.
const NOT_APPROACHING: f64 = 1e-9;

/// A shape with its pose and velocity.
#[derive(Debug, Clone, Copy)]
pub struct Moving<'a> {
    /// The shape.
    pub shape: &'a Shape,
    /// Its pose.
    pub pose: &'a Pose,
    /// Its velocity; the linear one is that of the origin of the pose.
    pub velocity: &'a Velocity,
}

impl Moving<'_> {
    /// Velocity of the material point at a place of the world.
    fn at(&self, place: DVec3) -> DVec3 {
        self.velocity.linear + self.velocity.angular.cross(place - self.pose.translation)
    }
}

/// A face along which two bodies neither overlap nor approach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct OpenFace {
    /// The body that it belongs to.
    pub(crate) of: Side,
    /// Its number among the faces or discs of that body.
    pub(crate) face: u32,
    /// Its outward unit normal in the frame of its body.
    pub(crate) normal: DVec3,
    /// Its offset in that frame, m.
    pub(crate) offset: f64,
    /// How far the other body is above it, m; negative below it.
    pub(crate) separation: f64,
}

impl OpenFace {
    /// The pose of the body that it belongs to.
    pub(crate) const fn of_pose<'a>(&self, a: Moving<'a>, b: Moving<'a>) -> &'a Pose {
        match self.of {
            Side::A => a.pose,
            Side::B => b.pose,
        }
    }
}

/// The open faces of two shapes without parts, A's before B's, with the touch distance of their bodies (m); none when
/// they approach along all faces.
pub(crate) fn open_faces(a: Moving<'_>, b: Moving<'_>, touch: f64) -> Vec<OpenFace> {
    let mut open = Vec::new();
    if [a, b].iter().any(|body| is_without_open_face(body.shape)) {
        return open;
    }
    for (of, own, other) in [(Side::A, a, b), (Side::B, b, a)] {
        let seen_from_own = own.pose.relative(other.pose);
        let (points, ball) = hull_points(other.shape);
        let some_point = points.first().map(|&point| seen_from_own.transform_point(point));
        each_face(own.shape, |face, normal, offset| {
            // Most faces of a body are on the far side of it, where any point of the other one shows that.
            if some_point.is_some_and(|point| normal.dot(point) - ball - offset < -touch) {
                return;
            }
            let found = OpenFace { of, face, normal, offset, separation: 0.0 };
            let separation = above(&found, own, other, &seen_from_own, touch);
            open.extend(separation.map(|separation| OpenFace { separation, ..found }));
        });
    }
    open
}

const fn is_without_open_face(shape: &Shape) -> bool {
    matches!(shape, Shape::HalfSpace(_) | Shape::TriangleMesh(_) | Shape::Compound(_) | Shape::Points(_))
}

/// Calls `visit` with number, outward unit normal and offset (m) of each face and disc of a shape, in its frame.
fn each_face(shape: &Shape, mut visit: impl FnMut(u32, DVec3, f64)) {
    match shape {
        Shape::Convex(polyhedron) => {
            for (number, face) in (0..).zip(&polyhedron.faces) {
                visit(number, face.normal, face.offset);
            }
        }
        Shape::Cylinder(_) | Shape::Cone(_) => {
            for (number, rim) in (0..).zip(circles(shape).iter()) {
                visit(number, rim.axis, rim.axis.dot(rim.center));
            }
        }
        _ => {}
    }
}

/// How far a body is above a face of another one (m), if it does not approach it and is below it by at most `touch`.
/// `seen_from_own` is the pose of the body in the frame of the face's one.
fn above(face: &OpenFace, own: Moving<'_>, other: Moving<'_>, seen_from_own: &Pose, touch: f64) -> Option<f64> {
    let local = seen_from_own.rotation.inverse_rotate(face.normal);
    let origin = face.normal.dot(seen_from_own.translation) - face.offset;
    let (points, ball) = hull_points(other.shape);
    let rims = circles(other.shape);
    let of_points = points.iter().map(|p| local.dot(*p)).fold(f64::INFINITY, f64::min);
    let lowest = rims.iter().map(|rim| -rim.support(-local)).fold(of_points, f64::min);
    let separation = lowest - ball + origin;
    if separation.is_nan() || separation < -touch {
        return None;
    }
    let normal = own.pose.rotation.rotate(face.normal);
    let stays = |place: DVec3, falls: f64| {
        let (v, w) = (other.at(place), own.at(place));
        normal.dot(v - w) - falls >= -NOT_APPROACHING * (v.length() + w.length())
    };
    let low = lowest + touch;
    let turning = normal.cross(other.velocity.angular - own.velocity.angular).length();
    let points_stay = points
        .iter()
        .filter(|p| local.dot(**p) <= low)
        .all(|p| stays(other.pose.transform_point(*p) - normal * ball, 0.0));
    let rim_stays = |rim: &Circle| {
        if -rim.support(-local) > low {
            return true;
        }
        // All points of a rim that is parallel to the face are equally low.
        let is_flat = rim.radius * rim.axis.cross(local).length() <= touch;
        let (place, falls) = if is_flat { (rim.center, rim.radius * turning) } else { (rim.farthest(-local), 0.0) };
        stays(other.pose.transform_point(place) - normal * ball, falls)
    };
    (points_stay && rims.iter().all(rim_stays)).then_some(separation)
}
