//! Whether a body has come through the surface of another in a piece of a step, which no overlap at its end may show.
//!
//! Looked at are the middles of the convex parts of a body, which lie inside it: where one has crossed the surface of
//! another body on its way relative to it, or was behind it already, at least its own part has gone through. The way is
//! taken as straight in the frame of the other body. A ring has no such middle: what is threaded on it is not inside. A
//! body that has come through overlaps by its whole size. Failure: what passes with an end alone is an overlap at the
//! end of the step, or unseen.

use crate::model::Model;
use polhode_contact::{Ray, Shape, aabb_of, closest_point, contains, ray_cast};
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, Pose, UnitVector};

/// A middle that has moved by less than this part of its depth below its own surface has not come through another in
/// this piece (no unit, 0.1 to 0.9).
pub(super) const LEAST_WAY: f64 = 0.5;

/// The middle of a convex part.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Middle {
    /// In the frame of the body, m.
    at: DVec3,
    /// How far it is below the surface of its part, m.
    depth: f64,
}

/// The middles of a body.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Middles {
    all: Vec<Middle>,
}

impl Middles {
    /// Those of a shape.
    pub(super) fn of(shape: Option<&Shape>) -> Self {
        let parts = match shape {
            None | Some(Shape::HalfSpace(_) | Shape::Points(_) | Shape::TriangleMesh(_)) => &[],
            Some(Shape::Compound(compound)) => compound.parts(),
            Some(shape) => std::slice::from_ref(shape),
        };
        let middle = |part: &Shape| {
            let bounds = aabb_of(part, &Pose::IDENTITY).ok()?;
            let at = (bounds.min() + bounds.max()) * 0.5;
            let depth = -closest_point(part, &Pose::IDENTITY, at).ok()?.distance;
            (depth > 0.0).then_some(Middle { at, depth })
        };
        Self { all: parts.iter().filter_map(middle).collect() }
    }

    /// The least depth (m) of one of them below the surface of its part; infinite without any.
    pub(super) fn least_depth(&self) -> f64 {
        self.all.iter().map(|middle| middle.depth).fold(f64::INFINITY, f64::min)
    }

    /// Whether one of them is behind the surface of `other`.
    pub(super) fn are_inside(&self, model: &Model, states: &[BodyState], (body, other): (usize, usize)) -> bool {
        let Some(shape) = &model.bodies[other].shape else { return false };
        let is_inside =
            |middle: &Middle| contains(shape, &states[other].pose, states[body].pose.transform_point(middle.at));
        self.all.iter().any(is_inside)
    }

    /// Whether `body`, of which these are, has come behind the surface of `other` between two states.
    pub(super) fn have_passed(
        &self,
        model: &Model,
        [before, after]: [&[BodyState]; 2],
        (body, other): (usize, usize),
    ) -> bool {
        let Some(shape) = &model.bodies[other].shape else { return false };
        let pose = &after[other].pose;
        let passes = |middle: &Middle| {
            let start = before[other].pose.inverse_transform_point(before[body].pose.transform_point(middle.at));
            let (from, to) = (pose.transform_point(start), after[body].pose.transform_point(middle.at));
            let length = (to - from).length();
            let ray = UnitVector::new(to - from).ok().and_then(|along| Ray::new(from, along).ok());
            length > LEAST_WAY * middle.depth && ray.is_some_and(|ray| ray_cast(shape, pose, &ray, length).is_some())
        };
        self.all.iter().any(passes)
    }
}
