//! Forces along the coordinates of joints: springs, dampers and motors, as force fields over the movable bodies.
//!
//! | what | effort along the coordinate `q` | account |
//! |---|---|---|
//! | spring | `-k (q - q0)`, `V = k (q - q0)^2/2` | potential |
//! | damper | `-c q'` | damping |
//! | motor | what its drive asks for, within its bound ([`crate::scene::Motor`]) | external |
//!
//! The effort is a moment about the axis of an angle (N m), a force along the line of a displacement or a distance (N),
//! on the first body; on the second one it is the opposite. How it responds to motions is told in terms of the point
//! and direction of the coordinate (`coordinate.rs`), which is exact as long as the joint holds. Source: Featherstone
//! 2008, chapter 9 (forces at joints).

use super::coordinate::{CoordinateAt, Measured};
use super::joint::ModelJoint;
use super::joint_coordinate::JointCoordinate;
use crate::scene::{Drive, Motor};
use polhode_dynamics::field::{Account, Dependence, Field, ForceResponse, ResponseEnd, Wrench};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::{DMat3, Pose, Velocity};

/// What exerts an effort, in the unit of the coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Source {
    Spring { stiffness: f64, rest: f64 },
    Damper { damping: f64 },
    Motor(Motor),
}

/// How an effort changes with its coordinate and its rate.
pub(crate) struct Gains {
    /// N m/rad or N/m.
    pub(crate) stiffness: f64,
    /// N m s/rad or N s/m.
    pub(crate) damping: f64,
}

impl Source {
    fn effort(&self, value: f64, rate: f64) -> f64 {
        match self {
            Self::Spring { stiffness, rest } => stiffness * (rest - value),
            Self::Damper { damping } => -damping * rate,
            Self::Motor(motor) => motor.effort(value, rate),
        }
    }

    pub(crate) fn gains(&self, value: f64, rate: f64) -> Gains {
        match *self {
            Self::Spring { stiffness, .. } => Gains { stiffness, damping: 0.0 },
            Self::Damper { damping } => Gains { stiffness: 0.0, damping },
            // At its bound the effort does not change.
            Self::Motor(motor) if motor.effort(value, rate).abs() >= motor.most() => {
                Gains { stiffness: 0.0, damping: 0.0 }
            }
            Self::Motor(motor) => match motor.drive() {
                Drive::Effort(_) => Gains { stiffness: 0.0, damping: 0.0 },
                Drive::Velocity { gain, .. } => Gains { stiffness: 0.0, damping: gain },
                Drive::Position { stiffness, damping, .. } => Gains { stiffness, damping },
            },
        }
    }
}

/// A spring, a damper or a motor at a coordinate of a joint.
#[derive(Debug, Clone)]
pub(crate) struct JointForce {
    pub(crate) joint: ModelJoint,
    /// Place of the coordinate among those of the joint.
    pub(crate) place: usize,
    measured: Measured,
    /// As in [`JointCoordinate`].
    pub(crate) unit: f64,
    near: f64,
    pub(crate) source: Source,
    /// The movable bodies at its ends: number, and place among the movable ones.
    pub(crate) ends: [Option<(usize, usize)>; 2],
}

impl JointForce {
    /// Those of a joint, where `slot` is the place of a body among the movable ones.
    pub(crate) fn of(joint: &ModelJoint, slot: impl Fn(usize) -> Option<usize>) -> impl Iterator<Item = Self> {
        let ends = joint.ends().map(|body| body.and_then(|body| Some((body, slot(body)?))));
        joint.coordinates().iter().enumerate().flat_map(move |(place, coordinate)| {
            let JointCoordinate { measured, unit, near, freedom, .. } = coordinate.clone();
            let spring = Source::Spring { stiffness: freedom.stiffness(), rest: freedom.rest() };
            let spring = (freedom.stiffness() > 0.0).then_some(spring);
            let damper = (freedom.damping() > 0.0).then_some(Source::Damper { damping: freedom.damping() });
            let motor = freedom.motor().map(Source::Motor);
            let sources = [spring, damper, motor].into_iter().flatten();
            sources.map(move |source| {
                let measured = measured.clone();
                Self { joint: joint.clone(), place, measured, unit, near, source, ends }
            })
        })
    }

    /// The coordinate where bodies have these poses of their moving frames, and velocities.
    pub(crate) fn coordinate_at(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> Option<CoordinateAt> {
        self.joint.coordinate_at((&self.measured, self.near * self.unit), motion)
    }

    /// Its effort times the rate of its coordinate, W.
    pub(crate) fn power(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> f64 {
        self.coordinate_at(motion).map_or(0.0, |at| {
            let rate = at.own_rate() / self.unit;
            self.source.effort(at.value / self.unit, rate) * rate
        })
    }

    /// Its effort, in the unit of its coordinate; zero where that has no direction.
    pub(crate) fn effort(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> f64 {
        let effort = |at: CoordinateAt| self.source.effort(at.value / self.unit, at.own_rate() / self.unit);
        self.coordinate_at(motion).map_or(0.0, effort)
    }

    fn at(&self, bodies: &[RigidBody], states: &[BodyState]) -> Option<CoordinateAt> {
        let motion = |body: usize| -> (Pose, Velocity) {
            let slot = self.ends.iter().flatten().find(|(own, _)| *own == body).map(|(_, slot)| *slot);
            slot.and_then(|slot| Some((bodies.get(slot)?, states.get(slot)?)))
                .map_or((Pose::IDENTITY, Velocity::ZERO), |(own, state)| (state.pose, own.velocity(state)))
        };
        self.coordinate_at(motion)
    }
}

impl Field for JointForce {
    fn dependence(&self) -> Dependence {
        match self.source {
            Source::Spring { .. } => Dependence::Poses,
            Source::Motor(motor) if matches!(motor.drive(), Drive::Effort(_)) => Dependence::Poses,
            Source::Damper { .. } | Source::Motor(_) => Dependence::Velocities,
        }
    }

    fn account(&self) -> Account {
        match self.source {
            Source::Spring { .. } => Account::Potential,
            Source::Damper { .. } => Account::Damping,
            Source::Motor(_) => Account::External,
        }
    }

    fn acts_on(&self, body: usize) -> bool {
        self.ends.iter().flatten().any(|(_, slot)| *slot == body)
    }

    fn bodies(&self) -> Option<Vec<usize>> {
        Some(self.ends.iter().flatten().map(|(_, slot)| *slot).collect())
    }

    fn add_wrenches(&self, _t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        let Some(at) = self.at(bodies, states) else { return };
        let along = self.source.effort(at.value / self.unit, at.own_rate() / self.unit) / self.unit;
        for (end, sign) in self.ends.iter().zip([1.0, -1.0]) {
            let Some((_, slot)) = end else { continue };
            let (Some(state), Some(wrench)) = (states.get(*slot), wrenches.get_mut(*slot)) else { continue };
            let along = along * sign;
            if let Some(moment) = at.moment {
                wrench.torque += moment.axis * along;
            } else {
                let force = at.direction * along;
                wrench.force += force;
                wrench.torque += (at.point - state.pose.translation).cross(force);
            }
        }
    }

    fn responses(&self, bodies: &[RigidBody], states: &[BodyState]) -> Option<Vec<ForceResponse>> {
        let Some(at) = self.at(bodies, states) else { return Some(Vec::new()) };
        let end = |end: Option<(usize, usize)>| -> Option<ResponseEnd> {
            let (_, body) = end?;
            Some(ResponseEnd { body, arm: at.point - states.get(body)?.pose.translation })
        };
        let Gains { stiffness, damping } = self.source.gains(at.value / self.unit, at.own_rate() / self.unit);
        let direction = at.direction;
        let along = DMat3::from_cols(direction * direction.x, direction * direction.y, direction * direction.z);
        let per_unit = along * (self.unit * self.unit).recip();
        let none = ForceResponse::none(self.ends.map(end));
        Some(vec![ForceResponse { stiffness: per_unit * stiffness, damping: per_unit * damping, ..none }])
    }

    fn potential_energy(&self, bodies: &[RigidBody], states: &[BodyState]) -> f64 {
        let Source::Spring { stiffness, rest } = self.source else { return 0.0 };
        self.at(bodies, states).map_or(0.0, |at| {
            let stretch = at.value / self.unit - rest;
            0.5 * stiffness * stretch * stretch
        })
    }
}
