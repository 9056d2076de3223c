//! The line between two points, one of them on a body: what springs and dampers act along.

use super::error::finite_vector;
use super::{FieldError, ForceResponse, ResponseEnd, Wrench};
use crate::{BodyState, RigidBody};
use glam::DVec3;

/// One end of a spring or damper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Anchor {
    /// A point of the world, m.
    World(DVec3),
    /// A point of a body.
    Body {
        /// Index of the body.
        body: usize,
        /// `p_CQ`, m, body axes, from the origin of the moving frame: centre of mass or pivot.
        point: DVec3,
    },
}

impl Anchor {
    fn body(&self) -> Option<usize> {
        match self {
            Self::World(_) => None,
            Self::Body { body, .. } => Some(*body),
        }
    }

    /// Position and velocity of the point; nothing when there is no such body.
    fn motion(&self, bodies: &[RigidBody], states: &[BodyState]) -> Option<(DVec3, DVec3)> {
        match self {
            Self::World(position) => Some((*position, DVec3::ZERO)),
            Self::Body { body, point } => {
                let (body, state) = (bodies.get(*body)?, states.get(*body)?);
                let lever = state.pose.rotation.rotate(*point);
                Some((state.pose.translation + lever, body.velocity(state).at(lever)))
            }
        }
    }

    /// The point as the end of a force; none in the world.
    fn end(&self, states: &[BodyState]) -> Option<ResponseEnd> {
        let Self::Body { body, point } = self else { return None };
        let arm = states.get(*body)?.pose.rotation.rotate(*point);
        Some(ResponseEnd { body: *body, arm })
    }

    /// Adds a force at the point.
    fn push(&self, force: DVec3, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        let Self::Body { body: index, point } = self else { return };
        let (Some(body), Some(state)) = (bodies.get(*index), states.get(*index)) else { return };
        if let Some(wrench) = wrenches.get_mut(*index) {
            wrench.force += force;
            wrench.torque += state.pose.rotation.rotate(*point - body.arm()).cross(force);
        }
    }
}

/// Two anchors that are not held by one thing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Link {
    a: Anchor,
    b: Anchor,
}

impl Link {
    pub(super) fn new(a: Anchor, b: Anchor) -> Result<Self, FieldError> {
        if a.body() == b.body() {
            return Err(FieldError::SameEnds);
        }
        for end in [&a, &b] {
            let (Anchor::World(point) | Anchor::Body { point, .. }) = end;
            finite_vector("an anchor", *point)?;
        }
        Ok(Self { a, b })
    }

    pub(super) fn acts_on(&self, body: usize) -> bool {
        [self.a, self.b].iter().any(|end| end.body() == Some(body))
    }

    pub(super) fn bodies(&self) -> Vec<usize> {
        [self.a, self.b].iter().filter_map(Anchor::body).collect()
    }

    /// From a to b: the vector (m) and its rate (m/s).
    pub(super) fn extent(&self, bodies: &[RigidBody], states: &[BodyState]) -> Option<(DVec3, DVec3)> {
        let (a, b) = (self.a.motion(bodies, states)?, self.b.motion(bodies, states)?);
        Some((b.0 - a.0, b.1 - a.1))
    }

    /// A force at both ends that does not respond yet.
    pub(super) fn response(&self, states: &[BodyState]) -> ForceResponse {
        ForceResponse::none([self.a.end(states), self.b.end(states)])
    }

    /// Adds `force` at a and its opposite at b.
    pub(super) fn pull(&self, force: DVec3, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        self.a.push(force, bodies, states, wrenches);
        self.b.push(-force, bodies, states, wrenches);
    }
}
