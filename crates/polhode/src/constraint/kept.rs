//! What a joint keeps of the relative motion of its bodies: the parts that each kind of joint is put together from.

use super::end::EndKinematics;
use super::perpendicular::Perpendicular;
use super::row::RowsAt;
use super::thread::Thread;
use super::track::{self, Guide};
use super::track_frame::Followed;
use super::{coordinate, line, point};
use polhode_spatial::{DVec3, Rotation};
use std::sync::Arc;

/// Along which directions the point of A stays at that of B.
#[derive(Debug, Clone, PartialEq)]
enum StaysAlong {
    All,
    /// Unit vectors fixed in B, in its axes.
    Some(Vec<DVec3>),
    /// Along the line through both: their distance stays this, m.
    Line(f64),
    /// Across a track, with what of the body turns with it.
    Track(Arc<Guide>, Option<Followed>),
}

/// What a joint keeps.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Kept {
    displacement: StaysAlong,
    rotation: Vec<Perpendicular>,
    thread: Option<Thread>,
}

impl Kept {
    /// A point: A does not move away from B, but turns.
    pub(crate) fn point() -> Self {
        Self { displacement: StaysAlong::All, rotation: Vec::new(), thread: None }
    }

    /// A point of A does not move along these directions of the world (unit vectors), fixed in B with this attitude.
    pub(crate) fn along<const N: usize>(directions: [DVec3; N], b: Rotation) -> Self {
        let directions = directions.iter().map(|direction| b.inverse_rotate(*direction)).collect();
        Self { displacement: StaysAlong::Some(directions), rotation: Vec::new(), thread: None }
    }

    /// Nothing.
    pub(crate) fn nothing() -> Self {
        Self { displacement: StaysAlong::Some(Vec::new()), rotation: Vec::new(), thread: None }
    }

    /// A point of A stays at this distance (m) from one of B.
    pub(crate) fn distance(distance: f64) -> Self {
        Self { displacement: StaysAlong::Line(distance), rotation: Vec::new(), thread: None }
    }

    /// A point of A stays on a track, and this follows it.
    pub(crate) fn track(guide: &Arc<Guide>, followed: Option<Followed>) -> Self {
        Self { displacement: StaysAlong::Track(Arc::clone(guide), followed), rotation: Vec::new(), thread: None }
    }

    /// These pairs of directions of the world, the first fixed in A and the second in B, stay perpendicular too.
    pub(crate) fn with_rotation<const N: usize>(
        mut self,
        pairs: [(DVec3, DVec3); N],
        attitudes: (Rotation, Rotation),
    ) -> Self {
        self.rotation.extend(pairs.map(|pair| Perpendicular::new(pair, attitudes)));
        self
    }

    /// A displacement that goes with a rotation is kept too.
    pub(crate) fn with_thread(self, thread: Thread) -> Self {
        Self { thread: Some(thread), ..self }
    }

    /// How many rows it has.
    pub(crate) fn rows(&self) -> usize {
        let displacement = match &self.displacement {
            StaysAlong::All => point::ROWS,
            StaysAlong::Some(directions) => directions.len(),
            StaysAlong::Line(_) => 1,
            StaysAlong::Track(_, followed) => track::ROWS + followed.as_ref().map_or(0, Followed::rows),
        };
        displacement + self.rotation.len() + usize::from(self.thread.is_some())
    }

    /// The rows of these ends; `length` is that of rows of rotation, m. Where both are bodies and the point of A stays
    /// at that of B, the force acts between them; where it slides, at the point of A.
    pub(crate) fn rows_at(&self, mut a: EndKinematics, mut b: EndKinematics, length: f64) -> RowsAt {
        let gap = a.point - b.point;
        let thread = self.thread.as_ref().and_then(|thread| thread.row(&a, &b));
        let mut rows: Vec<_> = match &self.displacement {
            StaysAlong::All => {
                if !a.is_in_world() && !b.is_in_world() {
                    let middle = (a.point + b.point) * 0.5;
                    [a, b] = [a, b].map(|end| end.at_point(middle));
                }
                point::rows(gap, &a, &b).collect()
            }
            StaysAlong::Some(directions) => {
                b = b.at_point(a.point);
                directions.iter().map(|&direction| line::row(direction, gap, &a, &b)).collect()
            }
            StaysAlong::Line(distance) => {
                let row = coordinate::distance(&a, &b).map(|at| at.row(*distance));
                b = b.at_point(a.point);
                row.into_iter().collect()
            }
            StaysAlong::Track(guide, followed) => {
                let mut rows = guide.rows(&a, &b).to_vec();
                rows.extend(followed.iter().flat_map(|own| own.rows_at(guide, (&a, &b), length)));
                b = b.at_point(a.point);
                rows
            }
        };
        rows.extend(self.rotation.iter().map(|pair| pair.row(&a, &b, length)));
        rows.extend(thread);
        let members = a.member(1.0).into_iter().chain(b.member(-1.0)).collect();
        let drivers = a.driver(1.0).into_iter().chain(b.driver(-1.0)).collect();
        RowsAt { point: a.point, members, drivers, rows }
    }
}
