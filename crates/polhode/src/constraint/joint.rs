//! The joints of a scene as bilateral constraints: the list of their kinds.
//!
//! | kind | rows | leaves free |
//! |---|---|---|
//! | ball | those of a point (`point.rs`) | three rotations |
//! | hinge | those of a point, two of an axis (`hinge.rs`) | the rotation about the axis |

use super::end::End;
use super::hinge::{self, HingeAxis};
use super::point;
use super::row::RowsAt;
use crate::scene::{Joint, JointKind};
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, Pose, Rotation, Velocity};

/// What a joint keeps beside its point.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kept {
    Nothing,
    Axis(HingeAxis),
}

/// A joint of the model.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct WorldJoint {
    /// Its number in the scene.
    number: usize,
    /// A movable body.
    a: End,
    b: End,
    kept: Kept,
}

impl WorldJoint {
    /// A joint of the scene of a world at these states, those of the start; `length` is that of rows of rotation, m.
    pub(crate) fn new(
        (number, joint): (usize, &Joint),
        states: &[BodyState],
        moves: impl Fn(usize) -> bool,
        length: f64,
    ) -> Self {
        let end = |body: Option<usize>| match body.filter(|&body| moves(body)) {
            Some(body) => End::Body { body, arm: states[body].pose.inverse_transform_point(joint.anchor()) },
            None => End::World(joint.anchor()),
        };
        let (first, second) = (end(Some(joint.body())), end(joint.other()));
        // The first end is that of a movable body.
        let (a, b) = if first.body().is_some() { (first, second) } else { (second, first) };
        let attitude = |end: &End| end.body().map_or(Rotation::IDENTITY, |body| states[body].pose.rotation);
        let kept = match joint.kind() {
            JointKind::Ball => Kept::Nothing,
            JointKind::Hinge { axis } => Kept::Axis(HingeAxis::new(axis.get(), (attitude(&a), attitude(&b)), length)),
        };
        Self { number, a, b, kept }
    }

    /// The movable bodies that it holds.
    pub(crate) fn bodies(&self) -> impl Iterator<Item = usize> {
        self.a.body().into_iter().chain(self.b.body())
    }

    /// How many rows it has.
    pub(crate) fn rows(&self) -> usize {
        point::ROWS
            + match self.kept {
                Kept::Nothing => 0,
                Kept::Axis(_) => hinge::ROWS,
            }
    }

    /// Its number in the scene.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    /// Its rows where bodies have these poses of their moving frames, and velocities.
    pub(super) fn rows_at(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> RowsAt {
        let [mut a, mut b] = [&self.a, &self.b].map(|end| end.at(&motion));
        let gap = a.point - b.point;
        if self.b.body().is_some() {
            let middle = (a.point + b.point) * 0.5;
            [a, b] = [a, b].map(|end| end.at_point(middle));
        }
        let mut rows: Vec<_> = point::rows(gap, &a, &b).collect();
        match self.kept {
            Kept::Nothing => {}
            Kept::Axis(axis) => rows.extend(axis.rows(&a, &b)),
        }
        let members = a.member(1.0).into_iter().chain(b.member(-1.0)).collect();
        RowsAt { point: a.point, members, rows }
    }
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
    RowsAt { point: a.point, members: a.member(1.0).into_iter().collect(), rows }
}
