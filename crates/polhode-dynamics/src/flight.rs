//! Flight records: bodies in free flight under uniform gravity.
//!
//! With `s = t - t0`: `p = p0 + s v0 + s^2 g/2`, `v = v0 + s g`, L constant, and the rotation is exact
//! ([`crate::exact_rotation`]). A flight is evaluated from its record and never chained from step to step, so that the
//! motion depends neither on the step nor on what was asked before: the same (record, t) gives the same bits. The
//! record is replaced only at an impulse or a change of forces. Source: thesis 3.3; docs/ARCHITECTURE.md, flight
//! record.

use crate::exact_rotation::Path;
use crate::{BodyState, FreeRotation, RigidBody};
use glam::{DQuat, DVec3};
use polhode_spatial::rounding;
use polhode_spatial::{CompensatedSum, Motion, MotionBounds, Pose, Rotation, Velocity};

/// Flights that are evaluated together where many are asked for.
const TOGETHER: usize = 4;

/// A body in free flight since `t0`.
#[derive(Debug, Clone, Copy, PartialEq)]
// In this order: what an evaluation reads stands together.
#[repr(C)]
pub struct Flight {
    t0: f64,
    gravity: DVec3,
    start: BodyState,
    rotation: FreeRotation,
    body: RigidBody,
}

impl Flight {
    /// The flight of `body` that passes `state` at `t0` (s) under `gravity` (m/s^2, world).
    pub fn new(body: &RigidBody, t0: f64, state: &BodyState, gravity: DVec3) -> Self {
        let axes = state.pose.rotation * body.axes();
        let rotation = FreeRotation::new(body.moments(), axes, state.angular_momentum);
        Self { t0, gravity, start: *state, rotation, body: *body }
    }

    /// As [`Flight::new`], of a body that turns steadily about a principal axis ([`FreeRotation::steady`]).
    pub fn steady(body: &RigidBody, t0: f64, state: &BodyState, gravity: DVec3) -> Self {
        let axes = state.pose.rotation * body.axes();
        let rotation = FreeRotation::steady(body.moments(), axes, state.angular_momentum);
        Self { t0, gravity, start: *state, rotation, body: *body }
    }

    /// Time of the record, s.
    pub const fn t0(&self) -> f64 {
        self.t0
    }

    /// The body.
    pub const fn body(&self) -> &RigidBody {
        &self.body
    }

    /// State at the time of the record.
    pub const fn start(&self) -> &BodyState {
        &self.start
    }

    /// The acceleration of the centre of mass, m/s^2.
    pub const fn gravity(&self) -> DVec3 {
        self.gravity
    }

    /// The rotation's record.
    pub const fn rotation(&self) -> &FreeRotation {
        &self.rotation
    }

    /// State at `t` (s), before or after the record's time; at that time exactly the record's state.
    pub fn state(&self, t: f64) -> BodyState {
        self.state_from(t, self.rotation.relative(t - self.t0))
    }

    /// Writes the states at `t` (s) of flights into their places among `states`: the bits of [`Flight::state`], in less
    /// time where there are many. A place that there is not is passed over.
    pub fn write_states<'a>(flights: impl Iterator<Item = (usize, &'a Self)>, t: f64, states: &mut [BodyState]) {
        let mut groups = [(Path::Series, Group::default()), (Path::Elliptic, Group::default())];
        for (place, flight) in flights {
            let path = flight.rotation.path(t - flight.t0);
            let Some((_, group)) = groups.iter_mut().find(|(own, _)| *own == path) else {
                write(states, place, flight.state(t));
                continue;
            };
            group.members[group.count] = Some((place, flight));
            group.count += 1;
            if group.count == TOGETHER {
                group.write(path, t, states);
            }
        }
        for (path, group) in &mut groups {
            group.write(*path, t, states);
        }
    }

    /// The state at `t` (s), when the principal axes have turned so since the record.
    fn state_from(&self, t: f64, relative: Rotation) -> BodyState {
        BodyState {
            pose: self.pose_from(t, relative),
            linear_velocity: self.linear_velocity(t),
            angular_momentum: self.start.angular_momentum,
        }
    }

    /// The way of the centre of mass since the time of the record, m.
    fn path(&self, t: f64) -> DVec3 {
        let s = t - self.t0;
        (self.start.linear_velocity + self.gravity * (0.5 * s)) * s
    }

    fn pose_from(&self, t: f64, relative: Rotation) -> Pose {
        Pose::new(self.start.pose.rotation * in_body_axes(self.body.axes(), relative), self.position(t))
    }

    fn linear_velocity(&self, t: f64) -> DVec3 {
        self.start.linear_velocity + self.gravity * (t - self.t0)
    }
}

impl Motion for Flight {
    fn pose(&self, t: f64) -> Pose {
        self.pose_from(t, self.rotation.relative(t - self.t0))
    }

    fn position(&self, t: f64) -> DVec3 {
        self.start.pose.translation + self.path(t)
    }

    fn velocity(&self, t: f64) -> Velocity {
        self.body.velocity(&self.state(t))
    }

    fn bounds(&self, t0: f64, t1: f64) -> MotionBounds {
        // The velocity runs along a segment, and the length of a vector is convex: its largest value is at an end.
        let speed = self.linear_velocity(t0).length().max(self.linear_velocity(t1).length());
        MotionBounds {
            speed: speed * (1.0 + rounding::DOZENS_OF_TERMS),
            acceleration: self.gravity.length() * (1.0 + rounding::DOZENS_OF_TERMS),
            angular_speed: self.rotation.angular_speed_bound(),
            angular_acceleration: self.rotation.angular_acceleration_bound(),
        }
    }

    fn residue(&self, t: f64) -> Option<DVec3> {
        let (start, path) = (self.start.pose.translation, self.path(t));
        let lost = |start: f64, path: f64| {
            let mut sum = CompensatedSum::new(start);
            sum.add(path);
            sum.parts()[1]
        };
        Some(DVec3::new(lost(start.x, path.x), lost(start.y, path.y), lost(start.z, path.z)))
    }
}

/// Flights that are evaluated together, each with its place among the states.
#[derive(Debug, Default)]
struct Group<'a> {
    members: [Option<(usize, &'a Flight)>; TOGETHER],
    count: usize,
}

impl Group<'_> {
    /// Writes their states, and is empty then.
    fn write(&mut self, path: Path, t: f64, states: &mut [BodyState]) {
        if let [Some(a), Some(b), Some(c), Some(d)] = self.members {
            let together = [a, b, c, d];
            let times = together.map(|(_, flight)| t - flight.t0);
            let turned = FreeRotation::relative_of(together.map(|(_, flight)| &flight.rotation), times, path);
            for ((place, flight), turned) in together.into_iter().zip(turned) {
                write(states, place, flight.state_from(t, turned));
            }
        } else {
            for (place, flight) in self.members.into_iter().flatten() {
                write(states, place, flight.state(t));
            }
        }
        *self = Self::default();
    }
}

fn write(states: &mut [BodyState], place: usize, state: BodyState) {
    if let Some(own) = states.get_mut(place) {
        *own = state;
    }
}

/// A rotation relative to the principal axes, seen from the body's: `R_BP r R_PB`, whose quaternion is that of r with
/// its vector part turned. The identity stays the identity to the last bit.
fn in_body_axes(axes: Rotation, relative: Rotation) -> Rotation {
    let q = relative.quaternion();
    let v = axes.rotate(DVec3::new(q.x, q.y, q.z));
    Rotation::renormalized(DQuat::from_xyzw(v.x, v.y, v.z, q.w))
}
