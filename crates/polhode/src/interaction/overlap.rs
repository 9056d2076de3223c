//! Overlap is moved out: the smallest displacement, in the metric of mass, that leaves no overlap.
//!
//! With the separations `chi` of all contacts of the bodies, `dq = M^-1 J^T l` and `0 <= l _|_ G l + chi >= 0`: what overlaps is
//! moved until it touches, what touches is not pushed into anything else, and nothing is pulled together. Repeated with
//! contacts found afresh, since normals turn with the bodies. A contact whose place has jumped to another part of its features,
//! as that of a ball within a ring does, stays among the rows at its old place too, its separation carried along with the
//! bodies: otherwise the rounds would push to and fro. Pivots stay in place. Velocities stay. A round moves bodies by no more
//! than `sqrt(d r)`, with the largest overlap d and the size r; what that leaves is for the next.

use super::assembly::{Assembly, largest_change};
use super::groups::groups;
use crate::collision::contact_set::ContactId;
use crate::world::World;
use polhode_contact::ContactGeometry;
use polhode_dynamics::BodyState;
use polhode_response::{ComplementaritySolver, Delassus, ResponseError, SolverSettings, SolverStatus};
use polhode_spatial::{DVec3, Pose, Rotation};

/// Rounds: each squares what is left of an overlap relative to the size, so that the third is at rounding also for overlaps
/// of a hundredth of the size; a round that is cut short, or contacts whose place jumps, take some more.
const MOST_ROUNDS: usize = 8;

/// Overlap that is left, relative to the size of the smaller body, besides rounding: a quarter of what a run is judged by
/// (1e-12).
const LEFT_RELATIVE: f64 = 2.5e-13;

/// The part of the rounding of two poses (eight units in the last place) that may be left: two such units.
const LEFT_ROUNDING: f64 = 0.25;

/// The place of a contact has jumped when it is farther away than this fraction of the size of the smaller body.
const JUMPED_RELATIVE: f64 = 1e-3;

/// What moving bodies out of each other has done.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Removed {
    /// Largest overlap that is left, m.
    pub(crate) left_m: f64,
    /// Largest displacement of any point of a body, m, bounded by its size.
    pub(crate) moved_m: f64,
    /// Problems that were not solved as asked.
    pub(crate) fallbacks: u64,
}

/// A contact at present.
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

    /// The contact at its old place, its separation as the bodies have moved since.
    fn carried(&self, states: &[BodyState]) -> Overlap {
        let Overlap { id, mut geometry } = self.overlap;
        let [a, b] = [(id.a, &self.poses[0]), (id.b, &self.poses[1])].map(|(body, then)| {
            let now = &states[body].pose;
            let arm = geometry.point - then.translation;
            now.translation - then.translation + (now.rotation * then.rotation.inverse()).rotate(arm) - arm
        });
        geometry.separation += geometry.normal.dot(a - b);
        Overlap { id, geometry }
    }
}

/// Contacts of some pairs within touch, and the largest overlap.
#[derive(Debug, Default)]
pub(crate) struct Overlaps {
    contacts: Vec<Overlap>,
    /// The largest, m.
    pub(crate) deepest_m: f64,
    /// The contact that overlaps most; none when none overlaps.
    pub(crate) deepest: Option<ContactId>,
    /// Whether one is more than may be left.
    pub(crate) is_excess: bool,
}

impl Overlaps {
    /// Those of `pairs` at these states.
    pub(crate) fn find(world: &World, states: &[BodyState], pairs: &[(usize, usize)]) -> Self {
        Self::within(world, states, pairs, 0.0)
    }

    /// With contacts up to a distance (m) beyond touch: what is moved by as much may come to touch them.
    fn within(world: &World, states: &[BodyState], pairs: &[(usize, usize)], beyond: f64) -> Self {
        let mut found = Self::default();
        for &(a, b) in pairs {
            let reach = world.touch_distance(states, a, b) + beyond;
            for touch in world.contacts_of_pair(states, a, b, reach) {
                let overlap = Overlap { id: touch.id, geometry: touch.kinematics.geometry };
                if lies_on_features(world, states, touch.id, &overlap.geometry)
                    && -overlap.geometry.separation > found.deepest_m
                {
                    (found.deepest_m, found.deepest) = (-overlap.geometry.separation, Some(touch.id));
                }
                found.is_excess |= is_excess(world, states, overlap.id, &overlap.geometry);
                found.contacts.push(overlap);
            }
        }
        found
    }

    /// Moves `bodies` (movable, ascending) out of each other and of immovable ones, where the contacts of `pairs` overlap.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn remove(
        mut self,
        world: &World,
        states: &mut [BodyState],
        (bodies, pairs): (&[usize], &[(usize, usize)]),
        (solver, delassus): (&mut ComplementaritySolver, &mut Delassus),
    ) -> Result<Removed, ResponseError> {
        let start: Vec<BodyState> = bodies.iter().map(|&body| states[body]).collect();
        let mut earlier: Vec<Earlier> = Vec::new();
        let mut fallbacks = 0;
        for _ in 0..MOST_ROUNDS {
            if !self.is_excess {
                break;
            }
            let jumped = earlier.iter().filter(|old| !self.has_at_place(world, &old.overlap));
            let carried: Vec<Overlap> = jumped.map(|old| old.carried(states)).collect();
            earlier.extend(self.contacts.iter().map(|&overlap| Earlier::new(overlap, states)));
            let mut rows = std::mem::take(&mut self.contacts);
            rows.extend(carried);
            fallbacks += move_out(world, states, &rows, (&mut *solver, &mut *delassus))?;
            self = Self::within(world, states, pairs, self.deepest_m);
        }
        let moved = bodies.iter().zip(&start).map(|(&body, start)| displacement(world, body, start, &states[body]));
        Ok(Removed { left_m: self.deepest_m, moved_m: moved.fold(0.0, f64::max), fallbacks })
    }

    /// Whether a contact is among these, at the place where it was.
    fn has_at_place(&self, world: &World, old: &Overlap) -> bool {
        let near = JUMPED_RELATIVE * world.pair_size(old.id.a, old.id.b);
        let same = |now: &Overlap| now.id == old.id && now.geometry.point.distance(old.geometry.point) <= near;
        self.contacts.iter().any(same)
    }
}

/// One round; the number of problems that were not solved as asked.
fn move_out(
    world: &World,
    states: &mut [BodyState],
    rows: &[Overlap],
    (solver, delassus): (&mut ComplementaritySolver, &mut Delassus),
) -> Result<u64, ResponseError> {
    let mut fallbacks = 0;
    for group in groups(world, rows.iter().enumerate().map(|(index, row)| (index, row.id.a, row.id.b))) {
        let members: Vec<Overlap> = group.contacts.iter().map(|&index| rows[index]).collect();
        if !members.iter().any(|row| is_excess(world, states, row.id, &row.geometry)) {
            continue;
        }
        let geometries = members.iter().map(|row| (row.id, row.geometry));
        let assembly = Assembly::new(world, states, &group.bodies, geometries)?;
        let mut separations: Vec<f64> = members.iter().map(|row| row.geometry.separation).collect();
        separations.extend(assembly.pivots().iter().flat_map(|pivot| pivot.gap.to_array()));
        assembly.problem.delassus_into(delassus);
        let roundings = members.iter().map(|row| world.rounding(states, row.id.a, row.id.b));
        let noise_floor = LEFT_ROUNDING * roundings.fold(f64::INFINITY, f64::min);
        solver.set_settings(SolverSettings { noise_floor, ..SolverSettings::default() });
        let solution = solver.solve(&assembly.problem, delassus, &separations, None)?;
        fallbacks += u64::from(solution.report.status != SolverStatus::Solved);
        let response = assembly.problem.response(&solution.forces)?;
        let share = share_of_move(world, &members, assembly.split(&response));
        for (body, linear, angular) in assembly.split(&response) {
            let pose = &mut states[body].pose;
            pose.translation += linear * share;
            pose.rotation = Rotation::from_rotation_vector(angular * share) * pose.rotation;
            world.keep_in_plane(body, &mut states[body]);
        }
    }
    Ok(fallbacks)
}

/// The part of a displacement up to which the contacts are those that it was found for. Bodies in a straight row between walls
/// get out of an overlap `d` by going aside by `sqrt(d r)`, `r` being their size: the less the row is bent, the farther aside
/// the contacts at the start would send them, without end.
fn share_of_move(world: &World, rows: &[Overlap], changes: impl Iterator<Item = (usize, DVec3, DVec3)>) -> f64 {
    let deepest = rows.iter().map(|row| -row.geometry.separation).fold(0.0, f64::max);
    let size = rows.iter().map(|row| world.pair_size(row.id.a, row.id.b)).fold(f64::INFINITY, f64::min);
    ((deepest * size).sqrt() / largest_change(world, changes).max(f64::MIN_POSITIVE)).min(1.0)
}

/// Whether a contact overlaps by more than may be left.
pub(crate) fn is_excess(world: &World, states: &[BodyState], id: ContactId, geometry: &ContactGeometry) -> bool {
    let left = LEFT_RELATIVE * world.pair_size(id.a, id.b) + LEFT_ROUNDING * world.rounding(states, id.a, id.b);
    lies_on_features(world, states, id, geometry) && geometry.separation < -left
}

/// A point beside its features overlaps nothing; one at their end, to rounding, does.
fn lies_on_features(world: &World, states: &[BodyState], id: ContactId, geometry: &ContactGeometry) -> bool {
    geometry.margin >= -world.rounding(states, id.a, id.b)
}

/// How far any point of a body has moved, m, bounded by its size.
pub(crate) fn displacement(world: &World, body: usize, from: &BodyState, to: &BodyState) -> f64 {
    let turn = (to.pose.rotation * from.pose.rotation.inverse()).to_rotation_vector();
    (to.pose.translation - from.pose.translation).length() + turn.length() * world.bodies[body].size
}
