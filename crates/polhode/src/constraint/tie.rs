//! A tie: a row that holds a coordinate of a joint to another coordinate (a gear) or to a function of time (a
//! prescribed motion).
//!
//! | tie | keeps | acts along |
//! |---|---|---|
//! | gear | `q_1 - r q_2 = 0` | the first coordinate with `f`, the second one with `-r f` |
//! | prescribed motion | `q - s(t) = 0` | the coordinate |
//!
//! `q` are coordinates measured from the start (rad of an angle, m otherwise; `coordinate.rs`), `r` the ratio. The row
//! is multiplied by the length of the first joint where its coordinate is an angle, so that it has the unit m. Along an
//! angle acts a moment about the axis, along a displacement or a distance a force. The function of time is the
//! displacement along x of a *carriage*, a kinematic body without a shape which nobody sees (`carriages.rs`): so its
//! rates, its acceleration, its work, the times at which it is not smooth and whether it stands still are those of
//! kinematic bodies.
//!
//! An angle is known up to whole revolutions, `q = a + 2 pi k`. That of the first coordinate has the `k` next to
//! `r q_2` or `s`. That of the second one of a gear of two angles is next to what it was at the end of the last step,
//! which is part of the state of a run. Where both have turned `k_1` and `k_2` times the row keeps
//! `a_1 - r a_2 + 2 pi (k_1 - r k_2)`, the bracket in twice the working precision, so that it is as exact after a
//! thousand revolutions as at the start.
//!
//! Assumptions: what the joints keep holds; the second angle turns by less than half a revolution in a step. Source:
//! Featherstone 2008, chapter 3 (constraints between joint coordinates).

use super::coordinate::CoordinateAt;
use super::joint::ModelJoint;
use super::row::{Action, BilateralRow, Member, Part, RowKind, RowsAt};
use crate::scene::Coordinate;
use polhode_spatial::{DVec3, DoubleDouble, Pose, Velocity};
use std::f64::consts::TAU;

/// A coordinate of a joint that a tie takes hold of.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tied {
    pub(crate) joint: ModelJoint,
    /// Its place among the coordinates of the joint.
    pub(crate) place: usize,
    /// Its value at the start, rad or m.
    pub(crate) start: f64,
}

/// What the first coordinate is held to.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum HeldTo {
    /// The ratio times another coordinate.
    Coordinate {
        second: Box<Tied>,
        ratio: f64,
        /// The value of the second one at the end of the last step, with all its revolutions, if it is an angle: rad.
        last: f64,
    },
    /// The displacement along x of a carriage, a kinematic body, less that at the start.
    Carriage { body: usize, start: f64 },
}

/// A tie of the model.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tie {
    /// Its number: gears in the order of the scene, then prescribed motions.
    pub(crate) number: usize,
    pub(crate) first: Tied,
    pub(crate) to: HeldTo,
}

/// A coordinate in given states.
struct TiedAt {
    /// From the start, rad or m; of an angle within half a revolution of zero.
    value: f64,
    is_angle: bool,
    /// The length that gives an angle the unit m, 1 otherwise.
    unit: f64,
    /// In m/s and m/s^2.
    rate: f64,
    bias: f64,
    action: Action,
    members: Vec<Member>,
    drivers: Vec<Member>,
}

impl Tied {
    fn is_angle(&self) -> bool {
        self.joint.coordinates().get(self.place).is_some_and(|own| own.coordinate == Coordinate::Angle)
    }

    /// Its value, of an angle within half a revolution of zero; none where it has no direction.
    pub(crate) fn value(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> Option<f64> {
        let own = self.joint.coordinates().get(self.place)?;
        Some(self.joint.coordinate_at((&own.measured, 0.0), motion)?.value / own.unit)
    }

    fn at(&self, part: Part, motion: impl Fn(usize) -> (Pose, Velocity)) -> Option<TiedAt> {
        let own = self.joint.coordinates().get(self.place)?;
        let (at, [a, b]) = self.joint.coordinate_with_ends((&own.measured, 0.0), motion)?;
        let CoordinateAt { value, rate, bias, point, direction, moment, .. } = at;
        let (rate, bias, action) = match moment {
            Some(moment) => (moment.rate, moment.bias, Action::Moment(moment.axis)),
            None => (rate, bias, Action::Force { direction, point }),
        };
        let [a, b] = [a, b].map(|end| end.at_point(point));
        let of = |member: Option<Member>| member.map(|member| Member { part, ..member });
        Some(TiedAt {
            value: value / own.unit - self.start,
            is_angle: self.is_angle(),
            unit: own.unit,
            rate,
            bias,
            action,
            members: of(a.member(1.0)).into_iter().chain(of(b.member(-1.0))).collect(),
            drivers: of(a.driver(1.0)).into_iter().chain(of(b.driver(-1.0))).collect(),
        })
    }
}

impl Tie {
    /// The joints whose coordinates it takes hold of.
    pub(crate) fn joints(&self) -> impl Iterator<Item = &ModelJoint> {
        self.coordinates().map(|tied| &tied.joint)
    }

    /// The coordinates that it takes hold of.
    pub(crate) fn coordinates(&self) -> impl Iterator<Item = &Tied> {
        let second = match &self.to {
            HeldTo::Coordinate { second, .. } => Some(&**second),
            HeldTo::Carriage { .. } => None,
        };
        std::iter::once(&self.first).chain(second)
    }

    /// Its number: gears in the order of the scene, then prescribed motions.
    pub(crate) fn number(&self) -> usize {
        self.number
    }

    /// The movable bodies that it connects, ascending.
    pub(crate) fn bodies(&self) -> Vec<usize> {
        let mut bodies: Vec<usize> = self.joints().flat_map(ModelJoint::bodies).collect();
        bodies.sort_unstable();
        bodies.dedup();
        bodies
    }

    /// Its carriage, of a prescribed motion.
    pub(crate) fn carriage(&self) -> Option<usize> {
        match self.to {
            HeldTo::Carriage { body, .. } => Some(body),
            HeldTo::Coordinate { .. } => None,
        }
    }

    /// The angle whose revolutions it counts, at the end of the last step, rad; none of a tie that counts none.
    pub(crate) fn counted(&self) -> Option<f64> {
        match &self.to {
            HeldTo::Coordinate { second, last, .. } if second.is_angle() && self.first.is_angle() => Some(*last),
            HeldTo::Coordinate { .. } | HeldTo::Carriage { .. } => None,
        }
    }

    /// Sets it.
    pub(crate) fn set_counted(&mut self, angle: f64) {
        if let HeldTo::Coordinate { last, .. } = &mut self.to {
            *last = angle;
        }
    }

    /// That angle now, less than half a revolution from what it was; none of a tie that counts none.
    pub(crate) fn counted_at(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> Option<f64> {
        let last = self.counted()?;
        let HeldTo::Coordinate { second, .. } = &self.to else { return None };
        let within = second.value(motion)?;
        Some(within + TAU * turns(last, within))
    }

    /// Its row where bodies have these poses of their moving frames, and velocities; none where a coordinate has no
    /// direction.
    pub(crate) fn row_at(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> Option<RowsAt> {
        let first = self.first.at(Part::First, &motion)?;
        let point = match first.action {
            Action::Force { point, .. } => point,
            Action::Moment(_) => self.first.joint.anchor(&motion),
        };
        let (mut members, mut drivers) = (first.members.clone(), first.drivers.clone());
        let (off, rate, bias, action) = match &self.to {
            HeldTo::Coordinate { second, ratio, last } => {
                let second = second.at(Part::Second, &motion)?;
                members.extend(&second.members);
                drivers.extend(&second.drivers);
                let factor = -ratio * first.unit / second.unit;
                let rate = first.rate + factor * second.rate;
                let bias = first.bias + factor * second.bias;
                (apart(&first, &second, *ratio, *last), rate, bias, second.action.times(factor))
            }
            HeldTo::Carriage { body, start } => {
                let (pose, velocity) = motion(*body);
                drivers.push(Member { body: *body, arm: DVec3::ZERO, sign: 1.0, part: Part::Second });
                let value = pose.translation.x - start;
                let whole = if first.is_angle { libm::round((value - first.value) / TAU) } else { 0.0 };
                let action = Action::Force { direction: DVec3::X * -first.unit, point };
                (first.value - (value - TAU * whole), first.rate - first.unit * velocity.linear.x, first.bias, action)
            }
        };
        let kind = RowKind::Tied { first: first.action, second: action };
        let rows = vec![BilateralRow { kind, gap: off * first.unit, rate, bias }];
        Some(RowsAt { point, members, drivers, rows })
    }
}

/// How many whole revolutions an angle within half a revolution of zero has turned that was this one before, rad.
fn turns(last: f64, within: f64) -> f64 {
    libm::round((last - within) / TAU)
}

/// `q_1 - r q_2` in the unit of the first one, where the second one was `last` before, if it is an angle.
fn apart(first: &TiedAt, second: &TiedAt, ratio: f64, last: f64) -> f64 {
    let within = first.value - ratio * second.value;
    match (first.is_angle, second.is_angle) {
        (true, true) => {
            let turns = turns(last, second.value);
            let turned = DoubleDouble::new(0.0).plus_product(ratio, turns);
            let whole = libm::round(turned.value() - within / TAU);
            within + TAU * (DoubleDouble::new(whole).plus_product(-ratio, turns)).value()
        }
        (true, false) => within - TAU * libm::round(within / TAU),
        // The displacement says which revolution the angle is in.
        (false, true) => within - ratio * TAU * libm::round(within / (ratio * TAU)),
        (false, false) => within,
    }
}
