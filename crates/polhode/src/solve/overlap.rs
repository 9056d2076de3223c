//! Removal of penetration: the smallest displacement, in the mass metric, after which no bodies penetrate.
//!
//! With the separations `chi` of all contacts of the bodies, `dq = M^-1 J^T l` and `0 <= l _|_ G l + chi >= 0`:
//! penetrating bodies are moved until they touch, touching bodies are not pushed into others, and no bodies are pulled
//! together. This is repeated with newly detected contacts, since normals turn with the bodies. A contact point may
//! jump to another part of its features, as that of a ball within a ring. The contact then remains among the rows at
//! its old point too, with its separation updated by the displacement of the bodies: otherwise the rounds would
//! oscillate. Velocities are unchanged. A round moves bodies by at most `sqrt(d r)`, with the largest penetration d and
//! the size r; the next round removes the remainder.
//!
//! Pivots and joints of the bodies are rows of the same problem, whose gaps stay zero to first order. A displacement
//! `d` opens them by some `d^2/r`, so that rounds go on until they are closed too.

use crate::collision::contact_set;
use crate::identity::contact_id::ContactId;
use crate::joints::bilateral::Bilateral;
use crate::joints::held;
use crate::model::states_of::states_of;
use crate::model::{Model, tolerances};
use crate::rows::assembly::{Assembly, largest_change};
use crate::rows::groups::groups;
use polhode_contact::ContactGeometry;
use polhode_dynamics::BodyState;
use polhode_response::{Ask, Memory, Question, ResponseError, SolverStatus};
use polhode_spatial::{DVec3, Pose, Rotation};

/// Most rounds. Each squares the remaining penetration relative to the size, so that the third reaches rounding even
/// from a hundredth of the size. Limited rounds and contact points that jump take some more.
const MOST_ROUNDS: usize = 8;

/// Penetration that may remain, relative to the size of the smaller body, besides rounding: a quarter of what a
/// step aims at (`Settings::penetration_aim`, 1e-12).
const LEFT_OVERLAP_RELATIVE: f64 = 2.5e-13;

/// Fraction of the rounding of two poses (eight units in the last place) that may remain: two such units.
const LEFT_ROUNDING: f64 = 0.25;

/// What the solver may leave of what a round leaves anyway, in units of the largest displacement (no unit, 1e-4 to
/// 1e-2): it is many times the overlap where layers push each other.
const SHARE_OF_ROUND: f64 = 1e-2;

/// A contact point has jumped if it is farther away than this fraction of the size of the smaller body.
const MOVED_AWAY_RELATIVE: f64 = 1e-3;

/// Result of the removal of penetration.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Removed {
    /// Largest remaining penetration, m.
    pub(crate) left_m: f64,
    /// Largest displacement of any point of a body, m, bounded by its size.
    pub(crate) moved_m: f64,
    /// Number of problems that were not solved to their tolerance.
    pub(crate) fallbacks: u64,
}

/// A contact with its geometry, at the present poses or carried from earlier ones.
#[derive(Debug, Clone, Copy)]
struct Overlap {
    id: ContactId,
    geometry: ContactGeometry,
}

/// A contact of an earlier round, with the poses of its bodies then.
#[derive(Debug, Clone, Copy)]
struct Earlier {
    overlap: Overlap,
    poses: [Pose; 2],
}

impl Earlier {
    fn new(overlap: Overlap, states: &[BodyState]) -> Self {
        Self { overlap, poses: [states[overlap.id.a].pose, states[overlap.id.b].pose] }
    }

    /// The contact at its old point, with its separation updated by the displacement of the bodies since then.
    fn carried(&self, states: &[BodyState]) -> Overlap {
        let Overlap { id, mut geometry } = self.overlap;
        let displacement = |body: usize| {
            let then = if body == id.a { &self.poses[0] } else { &self.poses[1] };
            let now = &states[body].pose;
            let arm = geometry.point - then.translation;
            now.translation - then.translation + (now.rotation * then.rotation.inverse()).rotate(arm) - arm
        };
        geometry.separation += geometry.normal.dot(id.relative(displacement));
        Overlap { id, geometry }
    }
}

/// Contacts of some pairs within the touch distance, and the largest penetration.
#[derive(Debug, Default)]
pub(crate) struct Overlaps {
    contacts: Vec<Overlap>,
    /// The largest, m.
    pub(crate) deepest_m: f64,
    /// The contact that penetrates deepest; none when none penetrates.
    pub(crate) deepest: Option<ContactId>,
    /// Whether one penetrates by more than may remain.
    pub(crate) is_excess: bool,
}

impl Overlaps {
    /// Those of `pairs` at these states.
    pub(crate) fn find(model: &Model, states: &[BodyState], pairs: &[(usize, usize)]) -> Self {
        Self::within(model, states, pairs, 0.0)
    }

    /// With contacts up to a distance (m) beyond the touch distance: bodies displaced by as much may reach them.
    fn within(model: &Model, states: &[BodyState], pairs: &[(usize, usize)], beyond: f64) -> Self {
        let mut found = Self::default();
        for &(a, b) in pairs {
            let reach = tolerances::touch_distance(model, states, a, b) + beyond;
            for touch in contact_set::pair_at_poses(model, states, a, b, reach).contacts {
                let overlap = Overlap { id: touch.id, geometry: touch.kinematics.geometry };
                if lies_on_features(model, states, touch.id, &overlap.geometry)
                    && -overlap.geometry.separation > found.deepest_m
                {
                    (found.deepest_m, found.deepest) = (-overlap.geometry.separation, Some(touch.id));
                }
                found.is_excess |= is_excess(model, states, overlap.id, &overlap.geometry);
                found.contacts.push(overlap);
            }
        }
        found
    }

    /// The contacts whose bodies overlap by more than this part of the smaller body's size, and by how much, m.
    pub(crate) fn deeper_than(&self, model: &Model, states: &[BodyState], part: f64) -> Vec<(ContactId, f64)> {
        let deep = |overlap: &&Overlap| {
            let Overlap { id, geometry } = overlap;
            -geometry.separation > part * tolerances::pair_size(model, id.a, id.b)
                && lies_on_features(model, states, *id, geometry)
        };
        self.contacts.iter().filter(deep).map(|overlap| (overlap.id, -overlap.geometry.separation)).collect()
    }

    /// Removes the penetration of `bodies` (movable, ascending) into each other and into immovable ones, at the
    /// contacts of `pairs`.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn remove(
        mut self,
        model: &Model,
        states: &mut [BodyState],
        (bodies, pairs): (&[usize], &[(usize, usize)]),
        memory: &mut Memory,
    ) -> Result<Removed, ResponseError> {
        let start = states_of(states, bodies);
        let mut earlier: Vec<Earlier> = Vec::new();
        let mut fallbacks = 0;
        for round in 0..MOST_ROUNDS {
            if !self.is_excess && (round == 0 || open_joint(model, states, bodies) == 0.0) {
                break;
            }
            let jumped = earlier.iter().filter(|old| !self.has_at_place(model, old.overlap));
            let carried: Vec<Overlap> = jumped.map(|old| old.carried(states)).collect();
            earlier.extend(self.contacts.iter().map(|&overlap| Earlier::new(overlap, states)));
            let mut rows = std::mem::take(&mut self.contacts);
            rows.extend(carried);
            fallbacks += move_out(model, states, &rows, memory)?;
            self = Self::within(model, states, pairs, self.deepest_m);
        }
        let moved = bodies.iter().zip(&start).map(|(&body, start)| displacement(model, body, start, &states[body]));
        Ok(Removed { left_m: self.deepest_m, moved_m: moved.fold(0.0, f64::max), fallbacks })
    }

    /// Whether a contact is among these, at its old point.
    fn has_at_place(&self, model: &Model, old: Overlap) -> bool {
        let near = MOVED_AWAY_RELATIVE * tolerances::pair_size(model, old.id.a, old.id.b);
        let same = |now: &&Overlap| now.id == old.id && now.geometry.point.distance(old.geometry.point) <= near;
        let pair = |of: &Overlap| (of.id.a, of.id.b);
        // Pairs are in ascending order.
        let first = self.contacts.partition_point(|now| pair(now) < pair(&old));
        self.contacts[first..].iter().take_while(|now| pair(now) == pair(&old)).any(|now| same(&now))
    }
}

/// One round. Returns the number of problems that were not solved to their tolerance.
fn move_out(
    model: &Model,
    states: &mut [BodyState],
    rows: &[Overlap],
    memory: &mut Memory,
) -> Result<u64, ResponseError> {
    let mut fallbacks = 0;
    for group in groups(model, rows.iter().enumerate().map(|(index, row)| (index, row.id.a, row.id.b))) {
        let members: Vec<Overlap> = group.contacts.iter().map(|&index| rows[index]).collect();
        let open_joint = open_joint(model, states, &group.bodies);
        if open_joint == 0.0 && !members.iter().any(|row| is_excess(model, states, row.id, &row.geometry)) {
            continue;
        }
        let geometries = members.iter().map(|row| (row.id, row.geometry));
        let assembly = Assembly::new(model, states, &group.bodies, geometries)?;
        let separations = assembly.gaps(members.iter().map(|row| row.geometry.separation));
        let roundings = members.iter().map(|row| tolerances::rounding(model, states, row.id.a, row.id.b));
        let noise_floor = LEFT_ROUNDING * roundings.fold(f64::INFINITY, f64::min);
        let known = Question { constants: &separations, noise_floor, ..Question::default() };
        let found = assembly.answer(known, Ask::Displacement { accuracy: accuracy(model, &members) }, memory)?;
        fallbacks += u64::from(found.report.status != SolverStatus::Solved);
        let response = assembly.problem.response(&found.reactions)?;
        let share = share_of_move(model, (&members, open_joint), assembly.split(&response));
        for (body, linear, angular) in assembly.split(&response) {
            let pose = &mut states[body].pose;
            pose.translation += linear * share;
            pose.rotation = Rotation::from_rotation_vector(angular * share) * pose.rotation;
            model.keep_in_plane(body, &mut states[body]);
        }
    }
    Ok(fallbacks)
}

/// How exactly a round is worth being solved, relative to its largest overlap (no unit). What turning normals leave of
/// an overlap `d` of bodies of size `r` is about `d^2 / r`, and what may be left is a part of `r`: the next round
/// removes either.
fn accuracy(model: &Model, rows: &[Overlap]) -> f64 {
    let part = |row: &Overlap| -row.geometry.separation / tolerances::pair_size(model, row.id.a, row.id.b);
    let deepest = rows.iter().map(part).fold(LEFT_OVERLAP_RELATIVE, f64::max);
    SHARE_OF_ROUND * deepest.max(LEFT_OVERLAP_RELATIVE / deepest).min(1.0)
}

/// The fraction of a displacement within which its linearised contacts are valid. Bodies in a straight row between
/// walls leave a penetration `d` by a lateral displacement of `sqrt(d r)`, with their size `r`. The linearised problem
/// overestimates it: the straighter the row, the larger its lateral displacement, without bound.
fn share_of_move(
    model: &Model,
    (rows, open_joint): (&[Overlap], f64),
    changes: impl Iterator<Item = (usize, DVec3, DVec3)>,
) -> f64 {
    let deepest = rows.iter().map(|row| -row.geometry.separation).fold(open_joint, f64::max);
    let size = rows.iter().map(|row| tolerances::pair_size(model, row.id.a, row.id.b)).fold(f64::INFINITY, f64::min);
    ((deepest * size).sqrt() / largest_change(model, changes).max(f64::MIN_POSITIVE)).min(1.0)
}

/// The largest gap (m) of the pivots and joints of some bodies that is more than rounding; zero if none is.
fn open_joint(model: &Model, states: &[BodyState], bodies: &[usize]) -> f64 {
    let open = |bilateral: &Bilateral| {
        let (a, b) = bilateral.id.bodies();
        bilateral.gap() > LEFT_ROUNDING * tolerances::rounding(model, states, a, b)
    };
    held::bilaterals(model, states, bodies).filter(open).map(|bilateral| bilateral.gap()).fold(0.0, f64::max)
}

/// Whether a contact penetrates by more than may remain.
pub(crate) fn is_excess(model: &Model, states: &[BodyState], id: ContactId, geometry: &ContactGeometry) -> bool {
    let left = LEFT_OVERLAP_RELATIVE * tolerances::pair_size(model, id.a, id.b)
        + LEFT_ROUNDING * tolerances::rounding(model, states, id.a, id.b);
    lies_on_features(model, states, id, geometry) && geometry.separation < -left
}

/// A contact point outside its features measures no penetration; one at their boundary, within rounding, does.
fn lies_on_features(model: &Model, states: &[BodyState], id: ContactId, geometry: &ContactGeometry) -> bool {
    geometry.margin >= -tolerances::rounding(model, states, id.a, id.b)
}

/// How far any point of a body has moved, m, bounded by its size.
pub(crate) fn displacement(model: &Model, body: usize, from: &BodyState, to: &BodyState) -> f64 {
    let turn = (to.pose.rotation * from.pose.rotation.inverse()).to_rotation_vector();
    (to.pose.translation - from.pose.translation).length() + turn.length() * model.bodies[body].size
}
