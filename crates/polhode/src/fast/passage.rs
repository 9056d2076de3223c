//! Whether a body has come through the surface of another in a piece of a step, which no overlap at its end may show.
//!
//! Looked at are the middles of the convex parts of a body, which lie inside it: where one has crossed the surface of another body on its way
//! relative to it, or was behind it already, at least its own part has gone through. The way is taken as straight in the frame of the other body. A ring has no such
//! middle: what is threaded on it is not inside. Failure: what passes with an end alone is an overlap at the end of the step, or unseen.

use crate::world::World;
use polhode_contact::{Ray, Shape, aabb_of, closest_point, ray_cast};
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, Pose, UnitVector};

/// A middle that has moved by less than this part of its depth below its own surface has not come through another in this piece (no unit, 0.1 to 0.9).
const LEAST_WAY: f64 = 0.5;

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

    /// The least movement (m) by which one of them may have come through a surface; infinite without any.
    pub(super) fn least_way(&self) -> f64 {
        self.all.iter().map(|middle| LEAST_WAY * middle.depth).fold(f64::INFINITY, f64::min)
    }

    /// How deep (m) `body`, of which these are, has come behind the surface of `other` between two states; none where it has not.
    pub(super) fn passage(
        &self,
        world: &World,
        [before, after]: [&[BodyState]; 2],
        (body, other): (usize, usize),
    ) -> Option<f64> {
        let shape = world.bodies[other].shape.as_ref()?;
        let pose = &after[other].pose;
        let of = |middle: &Middle| {
            let start = before[other].pose.inverse_transform_point(before[body].pose.transform_point(middle.at));
            let (from, to) = (pose.transform_point(start), after[body].pose.transform_point(middle.at));
            let length = (to - from).length();
            if length <= LEAST_WAY * middle.depth {
                return None;
            }
            let ray = Ray::new(from, UnitVector::new(to - from).ok()?).ok()?;
            let hit = ray_cast(shape, pose, &ray, length)?;
            Some(length - hit.distance + middle.depth)
        };
        self.all.iter().filter_map(of).max_by(f64::total_cmp)
    }
}
