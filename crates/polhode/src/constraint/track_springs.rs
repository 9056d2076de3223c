//! Springs and dampers that hold a point to a track in the place of a constraint: the penalty method.
//!
//! With the way `d` from the foot of the point on the curve (m) and its velocity `u` across the curve (m/s), on A
//!
//! `f = -k d - c u`, `V = k d^2/2`, and nothing where `abs(d)` is above the reach
//!
//! and the opposite on the other body. Source: thesis, section on penalty methods. What it says of them shows here: a
//! body oscillates across the track with `omega = sqrt(k/m)`, a stiff spring asks for short steps, a soft one lets the
//! body off the track, and when a spring is to let go is a choice that no law makes.

use super::end::EndKinematics;
use super::joint::ModelJoint;
use super::track::Deviation;
use crate::scene::TrackHold;
use polhode_dynamics::field::{Account, Dependence, Field, ForceResponse, ResponseEnd, Wrench};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::{DMat3, DVec3, Pose, Velocity};

/// Which of the two a field is: their energies have accounts of their own.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Part {
    /// N/m.
    Spring(f64),
    /// N s/m.
    Damper(f64),
}

/// The springs or the dampers of a track.
#[derive(Debug, Clone)]
pub(crate) struct TrackSpring {
    joint: ModelJoint,
    part: Part,
    /// m.
    reach: f64,
    /// The movable bodies at its ends: number, and place among the movable ones.
    ends: [Option<(usize, usize)>; 2],
}

/// What it does in given states.
struct At {
    /// Where, world, m.
    point: DVec3,
    off: Deviation,
}

impl TrackSpring {
    /// Those of a joint, where `slot` is the place of a body among the movable ones.
    pub(crate) fn of(joint: &ModelJoint, slot: impl Fn(usize) -> Option<usize>) -> impl Iterator<Item = Self> {
        let springs = match joint.hold() {
            Some(TrackHold::Springs(springs)) => Some(springs),
            _ => None,
        };
        let ends = joint.ends().map(|body| body.and_then(|body| Some((body, slot(body)?))));
        springs.into_iter().flat_map(move |own| {
            let damper = (own.damping > 0.0).then_some(Part::Damper(own.damping));
            let parts = std::iter::once(Part::Spring(own.stiffness)).chain(damper);
            parts.map(move |part| Self { joint: joint.clone(), part, reach: own.reach, ends })
        })
    }

    /// None beyond the reach, and beyond an end at which the track lets go.
    fn at(&self, bodies: &[RigidBody], states: &[BodyState]) -> Option<At> {
        let motion = |body: usize| -> (Pose, Velocity) {
            let slot = self.ends.iter().flatten().find(|(own, _)| *own == body).map(|(_, slot)| *slot);
            slot.and_then(|slot| Some((bodies.get(slot)?, states.get(slot)?)))
                .map_or((Pose::IDENTITY, Velocity::ZERO), |(own, state)| (state.pose, own.velocity(state)))
        };
        let [a, b]: [EndKinematics; 2] = self.joint.ends_at(motion);
        let guide = self.joint.guide()?;
        if self.joint.lets_go_at_ends() && guide.is_beyond(&a, &b) {
            return None;
        }
        let off = guide.deviation(&a, &b);
        (off.way.length() <= self.reach).then_some(At { point: a.point, off })
    }
}

impl Field for TrackSpring {
    fn dependence(&self) -> Dependence {
        match self.part {
            Part::Spring(_) => Dependence::Poses,
            Part::Damper(_) => Dependence::Velocities,
        }
    }

    fn account(&self) -> Account {
        match self.part {
            Part::Spring(_) => Account::Potential,
            Part::Damper(_) => Account::Damping,
        }
    }

    fn acts_on(&self, body: usize) -> bool {
        self.ends.iter().flatten().any(|(_, slot)| *slot == body)
    }

    fn bodies(&self) -> Option<Vec<usize>> {
        Some(self.ends.iter().flatten().map(|(_, slot)| *slot).collect())
    }

    fn add_wrenches(&self, _t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        let Some(At { point, off }) = self.at(bodies, states) else { return };
        let force = match self.part {
            Part::Spring(stiffness) => off.way * -stiffness,
            Part::Damper(damping) => off.velocity * -damping,
        };
        for (end, sign) in self.ends.iter().zip([1.0, -1.0]) {
            let Some((_, slot)) = end else { continue };
            let (Some(state), Some(wrench)) = (states.get(*slot), wrenches.get_mut(*slot)) else { continue };
            let force = force * sign;
            wrench.force += force;
            wrench.torque += (point - state.pose.translation).cross(force);
        }
    }

    fn responses(&self, bodies: &[RigidBody], states: &[BodyState]) -> Option<Vec<ForceResponse>> {
        let Some(At { point, off }) = self.at(bodies, states) else { return Some(Vec::new()) };
        let end = |end: Option<(usize, usize)>| -> Option<ResponseEnd> {
            let (_, body) = end?;
            Some(ResponseEnd { body, arm: point - states.get(body)?.pose.translation })
        };
        let t = off.tangent;
        let across = DMat3::IDENTITY - DMat3::from_cols(t * t.x, t * t.y, t * t.z);
        let none = ForceResponse::none(self.ends.map(end));
        Some(vec![match self.part {
            Part::Spring(stiffness) => ForceResponse { stiffness: across * stiffness, ..none },
            Part::Damper(damping) => ForceResponse { damping: across * damping, ..none },
        }])
    }

    fn potential_energy(&self, bodies: &[RigidBody], states: &[BodyState]) -> f64 {
        let Part::Spring(stiffness) = self.part else { return 0.0 };
        // Beyond its reach a spring keeps what it held there: letting go is no work.
        let most = 0.5 * stiffness * self.reach * self.reach;
        self.at(bodies, states).map_or(most, |at| 0.5 * stiffness * at.off.way.length_squared())
    }
}
