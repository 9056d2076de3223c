//! The velocities with which a mechanism begins whose joints follow prescribed motions, where its bodies have none.
//!
//! The rows `J v` of all joints, gears and prescribed motions of the mechanism have to have given rates at the start:
//! zero of what joints keep, `s'(0)` of a coordinate that follows `s(t)`. Of all velocities that do so those of least
//! kinetic energy are taken, `v = -M^-1 J^T f` with `J M^-1 J^T f = u`, where `u` are the rates (m/s) of bodies at
//! rest: as if the drive had begun with a jerk. A mechanism of which the drives leave nothing free has one such motion.
//!
//! Velocities that a scene gives are left as they are: a mechanism with any of its own is checked, not changed.
//! Assumption: bodies without a pivot.

use super::row::{RowsAt, push_in_space};
use super::tie::{HeldTo, Tie, Tied};
use crate::scene::{Gear, Scene};
use polhode_dynamics::RigidBody;
use polhode_response::{Ask, ContactProblem, Memory, Question, ResponseError, RowProblem, solve};
use polhode_spatial::{DVec3, DisjointSets, Motion, Pose, Velocity};
use std::collections::BTreeSet;

/// Rounds of correction: the second one takes away what rounding of the first has left.
const ROUNDS: usize = 2;

impl Scene {
    /// Gives the bodies of mechanisms with prescribed motions, all at rest as they are given, velocities that agree
    /// with these. What cannot be found is left to the checks of velocities.
    pub(crate) fn find_start_velocities(&mut self) {
        if self.coordinate_motions.is_empty() || !self.names_what_there_is() {
            return;
        }
        for bodies in self.driven_mechanisms() {
            let is_at_rest = |body: &usize| *self.bodies[*body].initial_velocity() == Velocity::ZERO;
            let is_free = |body: &usize| self.bodies[*body].pivot_point().is_none();
            if !bodies.iter().all(|body| is_at_rest(body) && is_free(body)) {
                continue;
            }
            for _ in 0..ROUNDS {
                let Ok(changes) = self.changes_of_velocity(&bodies) else { break };
                for (&body, change) in bodies.iter().zip(changes) {
                    let own = *self.bodies[body].initial_velocity();
                    let sum = Velocity::new(own.linear + change.linear, own.angular + change.angular);
                    self.bodies[body].velocity = sum;
                }
            }
        }
    }

    /// Whether gears and prescribed motions are of joints that exist; those are checked later.
    fn names_what_there_is(&self) -> bool {
        let of_gears = self.gears.iter().flat_map(Gear::ends);
        let mut ends = of_gears.chain(self.coordinate_motions.iter().map(|(end, _)| *end));
        let bodies = self.bodies.len();
        let joints_exist = self.joints.iter().all(|joint| joint.bodies().all(|body| body < bodies));
        joints_exist && ends.all(|end| end.joint.index() < self.joints.len())
    }

    /// The movable bodies of each mechanism that has a prescribed motion, ascending.
    fn driven_mechanisms(&self) -> Vec<Vec<usize>> {
        let moves = |body: &usize| self.bodies[*body].mass_properties().is_some() && !self.bodies[*body].is_fixed();
        let mut sets = DisjointSets::new(self.bodies.len());
        let mut join = |together: Vec<usize>| together.windows(2).for_each(|pair| sets.join(pair[0], pair[1]));
        let of_joint = |joint: usize| self.joints[joint].bodies().filter(moves).collect::<Vec<usize>>();
        (0..self.joints.len()).for_each(|joint| join(of_joint(joint)));
        for gear in &self.gears {
            join(gear.ends().into_iter().flat_map(|end| of_joint(end.joint.index())).collect());
        }
        let roots: Vec<usize> = (0..self.bodies.len()).map(|body| sets.smallest(body)).collect();
        let driven = self.coordinate_motions.iter().filter_map(|(end, _)| of_joint(end.joint.index()).first().copied());
        let driven: BTreeSet<usize> = driven.map(|body| roots[body]).collect();
        let members = |root: &usize| (0..roots.len()).filter(moves).filter(|body| roots[*body] == *root).collect();
        driven.iter().map(members).collect()
    }

    /// By how much the velocities of these bodies have to change.
    fn changes_of_velocity(&self, bodies: &[usize]) -> Result<Vec<Velocity>, ResponseError> {
        let inverse_mass = |&body: &usize| {
            let own = &self.bodies[body];
            let block = |properties| RigidBody::new(properties).inverse_mass_block(own.initial_pose().rotation);
            own.mass_properties().map_or([0.0; WIDTH * WIDTH], block)
        };
        let mut problem = ContactProblem::new(WIDTH, bodies.iter().flat_map(inverse_mass).collect())?;
        let mut rates = Vec::new();
        for own in self.rows_at_start(bodies) {
            push_in_space(&mut problem, |body| bodies.binary_search(&body).ok(), (&own.members, &own.rows))?;
            rates.extend(own.rows.iter().map(|row| row.rate));
        }
        let known = Question { constants: &rates, ..Question::default() };
        let asked = RowProblem { rows: &problem, joints: 0..rates.len(), known };
        let answer = solve(&asked, Ask::HoldAll, &mut Memory::default())?;
        let changes = problem.response(&answer.reactions)?;
        let change = |own: &[f64]| Velocity::new(DVec3::from_slice(&own[..3]), DVec3::from_slice(&own[3..]));
        Ok(changes.chunks_exact(WIDTH).map(change).collect())
    }

    /// The rows of joints, gears and prescribed motions between these bodies at the start.
    fn rows_at_start(&self, bodies: &[usize]) -> Vec<RowsAt> {
        let motion = |body: usize| self.motion_at_start(body);
        let is_own = |joint: usize| self.joints[joint].bodies().any(|body| bodies.binary_search(&body).is_ok());
        let at_start = |joint: usize| self.joint_at_start(joint, &self.joints[joint]);
        let own = (0..self.joints.len()).filter(|joint| is_own(*joint));
        let mut rows: Vec<RowsAt> = own.map(|joint| at_start(joint).rows_at(motion)).collect();
        let tied = |joint: usize, coordinate| {
            let joint = at_start(joint);
            let place = joint.place_of(coordinate)?;
            Some(Tied { joint, place, start: 0.0 })
        };
        for (number, gear) in self.gears.iter().enumerate() {
            let [first, second] = gear.ends();
            let ends = [first, second].map(|end| tied(end.joint.index(), end.coordinate));
            let ([Some(first_end), Some(second_end)], true) = (ends, is_own(first.joint.index())) else { continue };
            let to = HeldTo::Coordinate { second: Box::new(second_end), ratio: gear.ratio(), last: 0.0 };
            rows.extend(Tie { number, first: first_end, to }.row_at(motion));
        }
        let carriage = self.bodies.len();
        for (end, own) in self.coordinate_motions.iter().filter(|(end, _)| is_own(end.joint.index())) {
            let Some(first) = tied(end.joint.index(), end.coordinate) else { continue };
            let pose = own.along_x().initial_pose(&Pose::IDENTITY);
            let rate = own.along_x().from_pose(&pose).velocity(0.0);
            let with_carriage = |body: usize| if body == carriage { (Pose::IDENTITY, rate) } else { motion(body) };
            let to = HeldTo::Carriage { body: carriage, start: 0.0 };
            rows.extend(Tie { number: 0, first, to }.row_at(with_carriage));
        }
        rows
    }
}

/// Numbers of a velocity.
const WIDTH: usize = 6;
