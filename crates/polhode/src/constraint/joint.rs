//! The joints of a scene as bilateral constraints: the list of their kinds.
//!
//! | kind | keeps | leaves free |
//! |---|---|---|
//! | ball | a point | three rotations |
//! | hinge | a point and an axis (`hinge.rs`) | the rotation about the axis |
//! | universal | a point, and two axes at right angles (`universal.rs`) | the rotations about both |
//! | fixed | a point and the attitude (`fixed.rs`) | nothing |
//! | slider | a line and the attitude (`slider.rs`) | the displacement along the line |
//! | cylindrical | an axis (`cylindrical.rs`) | the rotation about it and the displacement along it |
//! | screw | an axis, and a displacement along it for each rotation (`screw.rs`) | the rotation with its displacement |
//! | rod | the distance of two points | all but displacements along their line |
//! | rope | nothing: limits of a distance are stops | all |
//! | planar | a point in a plane, and its normal (`planar.rs`) | displacements in it, the rotation about the normal |
//! | track | a point on a curve or on one side of it (`track.rs`), or nothing | displacement along it, all rotations |

use super::coordinate::{CoordinateAt, Measured};
use super::end::{End, EndKinematics, Order};
use super::joint_coordinate::{JointCoordinate, coordinates, quarters_near};
use super::kept::Kept;
use super::row::RowsAt;
use super::stop::Stop;
use super::track::Guide;
use super::tree_joint::TreeJoint;
use super::{ConstraintId, cylindrical, fixed, hinge, on_track, planar, point, screw, slider, universal};
use crate::identity::body_id::BodyId;
use crate::scene::{Coordinate, Joint, JointKind, Motor, TrackHold};
use polhode_contact::ContactKinematics;
use polhode_spatial::curve::Curve;
use polhode_spatial::{DVec3, Pose, Rotation, Velocity};
use std::sync::Arc;

/// How a joint holds a body at the start: the pose of its moving frame, if that can change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum HeldBody {
    Fixed,
    Movable(Pose),
    Kinematic(Pose),
}

/// Where bodies were when a program added a joint: its anchor is a point of the world then, not at the start.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct AddedJoint {
    /// Its number.
    pub(crate) number: usize,
    /// The poses of its bodies.
    pub(crate) poses: Vec<Pose>,
}

/// A joint of the model.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ModelJoint {
    /// Its number in the scene.
    number: usize,
    a: End,
    b: End,
    kept: Kept,
    coordinates: Vec<JointCoordinate>,
    /// Limits of its coordinates.
    stops: Vec<Stop>,
    /// As one of a tree in coordinates of its own.
    of_tree: Option<TreeJoint>,
    /// Whether it is a line between two points: a rod or a rope.
    is_along_line: bool,
    /// Its axis and one at right angles to it, in the axes of its second end, unit vectors.
    axes_of_b: [DVec3; 2],
    /// Length of its rows of rotation, m.
    length: f64,
    /// Its track, if it is one.
    guide: Option<Arc<Guide>>,
    hold: Option<TrackHold>,
    lets_go_at_ends: bool,
}

impl ModelJoint {
    /// A joint of a scene with these tracks, where this is how bodies are held at the start. `length` is that of rows
    /// of rotation, m.
    pub(crate) fn new(
        (number, joint): (usize, &Joint),
        tracks: &[Arc<Curve>],
        held: impl Fn(usize) -> HeldBody,
        length: f64,
    ) -> Self {
        let held = |body: Option<usize>| body.map(|body| (body, held(body)));
        let [a, b] = [held(Some(joint.body().index())), held(joint.other().map(BodyId::index))];
        let end = |held: Option<(usize, HeldBody)>, anchor: DVec3| match held {
            None | Some((_, HeldBody::Fixed)) => End::World(anchor),
            Some((body, HeldBody::Movable(pose))) => End::Body { body, arm: pose.inverse_transform_point(anchor) },
            Some((body, HeldBody::Kinematic(pose))) => End::Driver { body, arm: pose.inverse_transform_point(anchor) },
        };
        let attitude = |held: Option<(usize, HeldBody)>| match held {
            None | Some((_, HeldBody::Fixed)) => Rotation::IDENTITY,
            Some((_, HeldBody::Movable(pose) | HeldBody::Kinematic(pose))) => pose.rotation,
        };
        let attitudes = (attitude(a), attitude(b));
        let guide = on_track::guide(joint, tracks, attitudes.1).map(Arc::new);
        let axes_of_b = axes_at_start(joint.kind()).map(|axis| attitudes.1.inverse_rotate(axis));
        let kept = match joint.kind() {
            JointKind::Ball => Kept::point(),
            JointKind::Hinge { axis } => hinge::kept(axis.get(), attitudes),
            JointKind::Universal { axes: [first, second] } => universal::kept((first.get(), second.get()), attitudes),
            JointKind::Fixed => fixed::kept(attitudes),
            JointKind::Slider { axis } => slider::kept(axis.get(), attitudes),
            JointKind::Cylindrical { axis } => cylindrical::kept(axis.get(), attitudes),
            JointKind::Screw { axis, lead } => screw::kept((axis.get(), lead), attitudes),
            JointKind::Planar { normal } => planar::kept(normal.get(), attitudes),
            JointKind::Rod { to } => Kept::distance((joint.anchor() - to).length()),
            JointKind::Rope { .. } => Kept::nothing(),
            JointKind::Track { hold, .. } => on_track::kept(guide.as_ref(), hold, attitudes),
        };
        let coordinates = coordinates(joint, attitudes, length, guide.as_ref());
        let of_track = guide.iter().flat_map(|guide| on_track::stops(guide, joint.kind()));
        let stops = coordinates.iter().flat_map(Stop::of).chain(of_track).collect();
        let of_tree = of_tree(joint, [a, b]);
        let (a, b) = (end(a, joint.anchor()), end(b, joint.other_anchor()));
        let is_along_line = matches!(joint.kind(), JointKind::Rod { .. } | JointKind::Rope { .. });
        let (hold, lets_go_at_ends) = (on_track::hold(joint.kind()), on_track::lets_go_at_ends(joint.kind()));
        Self {
            number,
            a,
            b,
            kept,
            coordinates,
            stops,
            of_tree,
            is_along_line,
            axes_of_b,
            length,
            guide,
            hold,
            lets_go_at_ends,
        }
    }

    /// The same joint in coordinates of its own; none where its kind has none, and of a kinematic body.
    pub(crate) fn tree_joint(&self) -> Option<TreeJoint> {
        self.of_tree
    }

    /// The movable bodies that it holds.
    pub(crate) fn bodies(&self) -> impl Iterator<Item = usize> {
        self.a.body().into_iter().chain(self.b.body())
    }

    /// The kinematic body that it holds, if there is one.
    pub(crate) fn driver(&self) -> Option<usize> {
        self.a.driver().or_else(|| self.b.driver())
    }

    /// Whether it keeps anything: limits alone are stops.
    pub(crate) fn has_rows(&self) -> bool {
        self.kept.rows() > 0
    }

    /// Its identity among constraints.
    pub(crate) fn id(&self) -> ConstraintId {
        let mut held = self.bodies();
        let first = held.next().unwrap_or_default();
        let second = held.next().or_else(|| self.driver()).unwrap_or(first);
        ConstraintId::Joint { joint: self.number, bodies: (first, second) }
    }

    /// Its movable bodies and its kinematic one, A <= B; the same body twice if it holds a body to the world.
    pub(crate) fn pair(&self) -> (usize, usize) {
        let mut held = self.bodies();
        let first = held.next().unwrap_or_default();
        let second = held.next().or_else(|| self.driver()).unwrap_or(first);
        (first.min(second), first.max(second))
    }

    /// How many stops it has.
    pub(crate) fn stops(&self) -> usize {
        self.stops.len()
    }

    pub(crate) fn stop(&self, place: usize) -> Option<&Stop> {
        self.stops.get(place)
    }

    /// One of its stops where bodies have these poses of their moving frames, and velocities.
    pub(crate) fn stop_at(
        &self,
        place: usize,
        motion: impl Fn(usize) -> (Pose, Velocity),
    ) -> Option<ContactKinematics> {
        self.stop(place)?.at(|measured, near| self.coordinate_at((measured, near), motion), self.order())
    }

    /// Which end the first body of its pair is at.
    pub(crate) fn order(&self) -> Order {
        let is_first = self.a.body().or_else(|| self.a.driver()) == Some(self.pair().0);
        if is_first { Order::Same } else { Order::Reversed }
    }

    /// A coordinate where bodies have these poses of their moving frames, and velocities: its value lies within half a
    /// revolution of the second number, m.
    pub(crate) fn coordinate_at(
        &self,
        (measured, near): (&Measured, f64),
        motion: impl Fn(usize) -> (Pose, Velocity),
    ) -> Option<CoordinateAt> {
        let [a, b] = [&self.a, &self.b].map(|end| end.at(&motion));
        measured.at(&a, &b, self.length, near)
    }

    /// The same with its ends there.
    pub(crate) fn coordinate_with_ends(
        &self,
        (measured, near): (&Measured, f64),
        motion: impl Fn(usize) -> (Pose, Velocity),
    ) -> Option<(CoordinateAt, [EndKinematics; 2])> {
        let [a, b] = [&self.a, &self.b].map(|end| end.at(&motion));
        Some((measured.at(&a, &b, self.length, near)?, [a, b]))
    }

    /// The velocity of its first body at its anchor relative to the second one or the world there, and its angular
    /// velocity relative to that.
    pub(crate) fn slip(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> Velocity {
        let [a, b] = [&self.a, &self.b].map(|end| end.at(&motion));
        let b = b.at_point(a.point);
        Velocity::new(a.velocity - b.velocity, a.angular - b.angular)
    }

    /// Where it holds its first body, world, m.
    pub(crate) fn anchor(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> DVec3 {
        self.a.at(motion).point
    }

    /// The axis of one of its coordinates (unit vector, world): of an angle or a displacement; zero of a distance.
    pub(crate) fn axis_of(&self, place: usize, motion: impl Fn(usize) -> (Pose, Velocity)) -> DVec3 {
        let Some(own) = self.coordinates.get(place) else { return DVec3::ZERO };
        let [a, b] = [&self.a, &self.b].map(|end| end.at(&motion));
        match (&own.measured, own.measured.axis()) {
            (Measured::Along(guide), _) => guide.along(&a, &b, 0.0).direction,
            (_, axis) => axis.map_or(DVec3::ZERO, |axis| b.rotation.rotate(axis)),
        }
    }

    /// Its own axes (unit vectors, world): its axis, and two at right angles to it, fixed in its second end. Of a rod,
    /// a rope and a track the first is their line.
    pub(crate) fn axes(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> [DVec3; 3] {
        let [a, b] = [&self.a, &self.b].map(|end| end.at(&motion));
        let line = match self.guide() {
            Some(guide) => Some(guide.along(&a, &b, 0.0).direction),
            None if self.is_along_line => (a.point - b.point).try_normalize(),
            None => None,
        };
        let [first, second] = match line {
            Some(line) => [line, line.any_orthonormal_vector()],
            None => self.axes_of_b.map(|axis| b.rotation.rotate(axis)),
        };
        [first, second, first.cross(second)]
    }

    /// Length of its rows of rotation, m.
    pub(crate) fn length(&self) -> f64 {
        self.length
    }

    /// Its coordinates.
    pub(crate) fn coordinates(&self) -> &[JointCoordinate] {
        &self.coordinates
    }

    /// The place of a coordinate among its coordinates; without a name that of the only one.
    pub(crate) fn place_of(&self, coordinate: Option<Coordinate>) -> Option<usize> {
        match coordinate {
            Some(coordinate) => self.coordinates.iter().position(|own| own.coordinate == coordinate),
            None => (self.coordinates.len() == 1).then_some(0),
        }
    }

    /// The rate of a coordinate, rad/s or m/s, where bodies have these poses of their moving frames, and velocities;
    /// none of one that it does not have.
    pub(crate) fn rate_of(
        &self,
        coordinate: Option<Coordinate>,
        motion: impl Fn(usize) -> (Pose, Velocity),
    ) -> Option<f64> {
        let own = self.coordinates.get(self.place_of(coordinate)?)?;
        let at = self.coordinate_at((&own.measured, own.near * own.unit), motion)?;
        Some(at.moment.map_or(at.rate, |moment| moment.rate) / own.unit)
    }

    /// What its angles that turn on are near to, rad.
    pub(crate) fn turned(&self) -> impl Iterator<Item = f64> {
        self.coordinates.iter().filter(|own| own.turns_on).map(|own| own.near)
    }

    /// The same where bodies have these poses of their moving frames, and velocities.
    pub(crate) fn turned_at(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> Vec<f64> {
        let angle = |own: &JointCoordinate| self.coordinate_at((&own.measured, own.near * own.unit), &motion);
        let near = |own| angle(own).map_or(own.near, |at| quarters_near(at.value / own.unit));
        self.coordinates.iter().filter(|own| own.turns_on).map(near).collect()
    }

    /// Replaces it. Returns whether forces at the joint depend on it.
    pub(crate) fn follow(&mut self, turned: &[f64]) -> bool {
        let turning = self.coordinates.iter_mut().filter(|own| own.turns_on);
        let mut is_sprung = false;
        // A joint has one angle.
        for (own, &near) in turning.zip(turned) {
            own.near = near;
            is_sprung |= own.is_sprung();
        }
        is_sprung
    }

    /// Gives one of its coordinates another motor, or none. Returns whether it has that coordinate.
    pub(crate) fn set_motor(&mut self, coordinate: Coordinate, motor: Option<Motor>) -> bool {
        let own = self.coordinates.iter_mut().find(|own| own.coordinate == coordinate);
        let has_it = own.is_some();
        if let Some(own) = own {
            own.freedom = own.freedom.driven_by(motor);
        }
        has_it
    }

    /// The movable bodies at its first and second end.
    pub(crate) fn ends(&self) -> [Option<usize>; 2] {
        [self.a.body(), self.b.body()]
    }

    /// Its ends in given states.
    pub(crate) fn ends_at(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> [EndKinematics; 2] {
        [&self.a, &self.b].map(|end| end.at(&motion))
    }

    /// Its track, if it is one.
    pub(crate) fn guide(&self) -> Option<&Guide> {
        self.guide.as_deref()
    }

    /// Whether it holds a body to a track.
    pub(crate) fn is_on_track(&self) -> bool {
        self.guide.is_some()
    }

    /// Whether it is a track that lets go at its ends.
    pub(crate) fn lets_go_at_ends(&self) -> bool {
        self.lets_go_at_ends && self.guide().is_some_and(|guide| guide.ends().is_some())
    }

    /// Whether its body is beyond an end at which it lets go.
    pub(crate) fn has_passed_end(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> bool {
        let [a, b] = self.ends_at(motion);
        self.lets_go_at_ends && self.guide().is_some_and(|guide| guide.is_beyond(&a, &b))
    }

    /// How its track holds its body, if it is one.
    pub(crate) fn hold(&self) -> Option<TrackHold> {
        self.hold
    }

    /// How many rows it has.
    pub(crate) fn rows(&self) -> usize {
        self.kept.rows()
    }

    /// Its number in the scene.
    pub(crate) fn number(&self) -> usize {
        self.number
    }

    /// Its rows where bodies have these poses of their moving frames, and velocities.
    pub(crate) fn rows_at(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> RowsAt {
        let [a, b] = [&self.a, &self.b].map(|end| end.at(&motion));
        self.kept.rows_at(a, b, self.length)
    }
}

/// The axis of a joint and one at right angles to it, at the start, world: that along which an angle is zero. Of a
/// joint without an axis they are those of the world.
fn axes_at_start(kind: JointKind) -> [DVec3; 2] {
    let own = match kind {
        JointKind::Planar { normal } => Some(normal),
        JointKind::Universal { axes: [_, second] } => Some(second),
        kind => kind.axis(),
    };
    own.map_or([DVec3::X, DVec3::Y], |axis| [axis.get(), axis.get().any_orthonormal_vector()])
}

/// A joint between bodies that are held so, in coordinates of its own.
fn of_tree(joint: &Joint, held: [Option<(usize, HeldBody)>; 2]) -> Option<TreeJoint> {
    let [a, b] = held.map(|held| match held {
        None | Some((_, HeldBody::Fixed)) => Some((None, Pose::IDENTITY)),
        Some((body, HeldBody::Movable(pose))) => Some((Some(body), pose)),
        Some((_, HeldBody::Kinematic(_))) => None,
    });
    TreeJoint::of(joint, [a?, b?])
}

/// Length of the rows of rotation of a joint between bodies of these sizes: that of the smaller one, m.
pub(crate) fn row_length(sizes: impl Iterator<Item = f64>) -> f64 {
    sizes.fold(f64::INFINITY, f64::min)
}

/// The rows of a pivot: a point of a body, with an arm in its axes (m), at a place of the world (m).
pub(crate) fn pivot_rows(
    (body, arm): (usize, DVec3),
    place: DVec3,
    motion: impl Fn(usize) -> (Pose, Velocity),
) -> RowsAt {
    let [a, b] = [End::Body { body, arm }, End::World(place)].map(|end| end.at(&motion));
    let rows = point::rows(a.point - b.point, &a, &b).collect();
    RowsAt { point: a.point, members: a.member(1.0).into_iter().collect(), drivers: Vec::new(), rows }
}
