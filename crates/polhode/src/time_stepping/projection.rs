//! Overlap that a step has left is moved out: the smallest displacement, in the metric of mass, that leaves no overlap.
//!
//! With the separations `chi` of all contacts of the bodies, `dq = M^-1 J^T l` and `0 <= l _|_ G l + chi >= 0`: what overlaps is
//! moved until it touches, what touches is not pushed into anything else, and nothing is pulled together. Repeated with
//! contacts found afresh, since normals turn with the bodies. Velocities stay; the change of energy is booked.

use super::NO_WORK_J;
use super::contacts::connected;
use super::report::TimeStepReport;
use super::step::TimeStepper;
use crate::collision::contact_set::ContactId;
use crate::interaction::assembly::Assembly;
use crate::world::World;
use polhode_contact::ContactGeometry;
use polhode_dynamics::BodyState;
use polhode_response::{ResponseError, SolverSettings};
use polhode_spatial::Rotation;

/// Rounds of projection: each squares what is left of an overlap relative to the size, so that the third is at rounding
/// also for overlaps of a hundredth of the size.
const MOST_ROUNDS: usize = 4;

/// Overlap that is left, relative to the size of the smaller body, besides rounding: a quarter of what a run is judged by
/// (1e-12).
const LEFT_RELATIVE: f64 = 2.5e-13;

/// The part of the rounding of two poses (eight units in the last place) that may be left: two such units.
const LEFT_ROUNDING: f64 = 0.25;

/// Contacts of the pairs at present, with the largest overlap, m, and whether one is to be moved out.
struct Overlaps {
    contacts: Vec<(ContactId, ContactGeometry)>,
    deepest: f64,
    excess: bool,
}

impl TimeStepper {
    /// Moves bodies out of each other where the contacts of `pairs` overlap.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn project(
        &mut self,
        world: &World,
        states: &mut [BodyState],
        bodies: &[usize],
        pairs: &[(usize, usize)],
        report: &mut TimeStepReport,
    ) -> Result<(), ResponseError> {
        let mut overlaps = overlaps(world, states, pairs, 0.0);
        report.max_penetration_m = report.max_penetration_m.max(overlaps.deepest);
        if overlaps.excess {
            let start: Vec<BodyState> = bodies.iter().map(|&body| states[body]).collect();
            let before = report.books.balance(world, states, bodies);
            for _ in 0..MOST_ROUNDS {
                self.move_out(world, states, bodies, &overlaps, report)?;
                overlaps = self::overlaps(world, states, pairs, overlaps.deepest);
                if !overlaps.excess {
                    break;
                }
            }
            let after = report.books.balance(world, states, bodies);
            report.books.projection(before, after, NO_WORK_J);
            for (&body, start) in bodies.iter().zip(&start) {
                let moved = displacement(world, body, start, &states[body]);
                report.max_projection_m = report.max_projection_m.max(moved);
            }
        }
        report.left_penetration_m = overlaps.deepest;
        Ok(())
    }

    fn move_out(
        &mut self,
        world: &World,
        states: &mut [BodyState],
        bodies: &[usize],
        overlaps: &Overlaps,
        report: &mut TimeStepReport,
    ) -> Result<(), ResponseError> {
        let contacts = overlaps.contacts.iter().enumerate();
        for group in connected(bodies, contacts.map(|(index, (id, _))| (index, *id))) {
            let members: Vec<_> = group.contacts.iter().map(|&index| overlaps.contacts[index]).collect();
            if members.iter().all(|(id, geometry)| !is_excess(world, states, *id, geometry.separation)) {
                continue;
            }
            let assembly = Assembly::new(world, states, &group.bodies, members.iter().copied())?;
            let separations: Vec<f64> = members.iter().map(|(_, geometry)| geometry.separation).collect();
            assembly.problem.delassus_into(&mut self.delassus);
            self.solver.set_settings(SolverSettings::default());
            let solution = self.solver.solve(&assembly.problem, &self.delassus, &separations, None)?;
            report.fallbacks += u64::from(solution.report.status != polhode_response::SolverStatus::Solved);
            for (body, linear, angular) in assembly.split(&assembly.problem.response(&solution.forces)?) {
                let pose = &mut states[body].pose;
                pose.translation += linear;
                pose.rotation = Rotation::from_rotation_vector(angular) * pose.rotation;
                world.keep_in_plane(body, &mut states[body]);
            }
        }
        Ok(())
    }
}

/// The contacts of the pairs within a distance beyond touch: what is moved by as much may come to touch them.
fn overlaps(world: &World, states: &[BodyState], pairs: &[(usize, usize)], beyond: f64) -> Overlaps {
    let mut found = Overlaps { contacts: Vec::new(), deepest: 0.0, excess: false };
    for &(a, b) in pairs {
        let reach = world.touch_distance(states, a, b) + beyond;
        for touch in world.contacts_of_pair(states, a, b, reach) {
            let geometry = touch.kinematics.geometry;
            // A point beside its features overlaps nothing.
            if geometry.margin >= 0.0 {
                found.deepest = found.deepest.max(-geometry.separation);
                found.excess |= is_excess(world, states, touch.id, geometry.separation);
            }
            found.contacts.push((touch.id, geometry));
        }
    }
    found
}

/// Whether a contact overlaps by more than may be left.
fn is_excess(world: &World, states: &[BodyState], id: ContactId, separation: f64) -> bool {
    let left = LEFT_RELATIVE * world.pair_size(id.a, id.b) + LEFT_ROUNDING * world.rounding(states, id.a, id.b);
    separation < -left
}

/// How far any point of a body has moved, m, bounded by its size.
pub(super) fn displacement(world: &World, body: usize, from: &BodyState, to: &BodyState) -> f64 {
    let turn = (to.pose.rotation * from.pose.rotation.inverse()).to_rotation_vector();
    (to.pose.translation - from.pose.translation).length() + turn.length() * world.bodies[body].size
}
