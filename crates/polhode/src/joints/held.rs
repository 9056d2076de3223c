//! Which bodies of the world bilateral constraints hold, and by which.

use crate::constraint::ConstraintId;
use crate::constraint::joint::{ModelJoint, pivot_rows};
use crate::constraint::tie::Tie;
use crate::joints::bilateral::Bilateral;
use crate::model::{Joints, Model};
use polhode_dynamics::BodyState;
use polhode_spatial::{DisjointSets, Pose, Velocity};
use std::collections::BTreeSet;

impl Joints {
    /// Whether constraint rows hold any body.
    pub(crate) fn has_rows(&self) -> bool {
        !self.held_by_rows.is_empty()
    }

    /// Whether constraint rows hold this body.
    pub(crate) fn is_held_by_rows(&self, body: usize) -> bool {
        self.held_by_rows.binary_search(&body).is_ok()
    }

    /// The joints that hold some of these bodies, in the order of the scene.
    pub(crate) fn joints_among(&self, bodies: &[usize]) -> impl Iterator<Item = &ModelJoint> {
        self.joint_places_among(bodies).into_iter().map(|joint| &self.list[joint])
    }

    /// The places of these joints in the world.
    pub(crate) fn joint_places_among(&self, bodies: &[usize]) -> Vec<usize> {
        let bodies = if self.list.is_empty() { &[] } else { bodies };
        let mut joints: Vec<usize> =
            bodies.iter().filter_map(|body| self.of_body.get(body)).flatten().copied().collect();
        joints.sort_unstable();
        joints.dedup();
        joints
    }

    /// The kinematic bodies that joints and ties hold to these; one with several joints is repeated.
    pub(crate) fn drivers_of<'a>(&'a self, bodies: &'a [usize]) -> impl Iterator<Item = usize> + 'a {
        let bodies = if self.drivers.is_empty() { &[] } else { bodies };
        self.joints_among(bodies)
            .filter_map(ModelJoint::driver)
            .chain(self.ties_among(bodies).filter_map(Tie::carriage))
    }

    /// The bodies that joints hold to this kinematic one, and all that joints connect to them, ascending.
    pub(crate) fn driven_by(&self, driver: usize) -> Vec<usize> {
        let own = self.list.iter().filter(|joint| joint.driver() == Some(driver));
        self.with_jointed(own.flat_map(ModelJoint::bodies).collect())
    }

    /// These bodies and all that joints and ties connect to them, ascending.
    pub(crate) fn with_jointed(&self, bodies: Vec<usize>) -> Vec<usize> {
        if self.list.is_empty() {
            return bodies;
        }
        let mut found: BTreeSet<usize> = bodies.iter().copied().collect();
        let mut left = bodies;
        while let Some(body) = left.pop() {
            let joints = self.of_body.get(&body).into_iter().flatten();
            let reached = joints.flat_map(|&joint| self.list[joint].bodies());
            left.extend(reached.filter(|&other| found.insert(other)));
            let tied = self.ties_of_body.get(&body).into_iter().flatten().flat_map(|&tie| self.ties[tie].bodies());
            left.extend(tied.filter(|&other| found.insert(other)));
        }
        found.into_iter().collect()
    }

    /// Those of these bodies that constraint rows hold.
    pub(crate) fn held_among(&self, bodies: &[usize]) -> Vec<usize> {
        let bodies = if self.has_rows() { bodies } else { &[] };
        bodies.iter().copied().filter(|&body| self.is_held_by_rows(body)).collect()
    }
}

/// The bilateral constraints of these bodies in these states: the pivots with constraint rows, in the order of the
/// bodies, then the joints, in that of the scene, then the ties.
pub(crate) fn bilaterals<'a>(
    model: &'a Model,
    states: &'a [BodyState],
    bodies: &'a [usize],
) -> impl Iterator<Item = Bilateral> + 'a {
    bilaterals_by(model, bodies, |body| motion_of(model, states, body))
}

/// The same where bodies have these poses of their moving frames, and velocities.
pub(crate) fn bilaterals_by<'a>(
    model: &'a Model,
    bodies: &'a [usize],
    motion: impl Fn(usize) -> (Pose, Velocity) + Copy + 'a,
) -> impl Iterator<Item = Bilateral> + 'a {
    let bodies = if model.joints.held_by_rows.is_empty() { &[] } else { bodies };
    let joints = model.joints.joints_among(bodies).map(move |joint| Bilateral::new(joint.id(), joint.rows_at(motion)));
    let ties = model.joints.ties_among(bodies).filter_map(move |tie| {
        let rows = tie.row_at(motion)?;
        let (first, last) = (rows.members.first()?.body, rows.members.last()?.body);
        Some(Bilateral::new(ConstraintId::Tie { tie: tie.number(), bodies: (first, last) }, rows))
    });
    bodies.iter().filter_map(move |&body| pivot_by(model, body, motion)).chain(joints).chain(ties)
}

/// The pivot of a body with constraint rows; none for any other body.
pub(crate) fn pivot(model: &Model, states: &[BodyState], body: usize) -> Option<Bilateral> {
    pivot_by(model, body, |body| motion_of(model, states, body))
}

fn pivot_by(model: &Model, body: usize, motion: impl Fn(usize) -> (Pose, Velocity)) -> Option<Bilateral> {
    let held = model.bodies[body].held?;
    let rows = pivot_rows((body, held.arm), held.place, motion);
    Some(Bilateral::new(ConstraintId::Pivot { body }, rows))
}

/// The pose of the moving frame of a body, and its velocity.
pub(crate) fn motion_of(model: &Model, states: &[BodyState], body: usize) -> (Pose, Velocity) {
    (states[body].pose, model.velocity(body, &states[body]))
}

/// Whether joints and pivots of these bodies (ascending) close loops, through the world or kinematic bodies too.
/// Gears and prescribed motions close none.
pub(crate) fn has_loops_among(model: &Model, bodies: &[usize]) -> bool {
    // The world is the last place.
    let mut sets = DisjointSets::new(bodies.len() + 1);
    let place = |body: usize| bodies.binary_search(&body).unwrap_or(bodies.len());
    let pivoted = bodies.iter().filter(|&&body| model.bodies[body].held.is_some());
    let pivots = pivoted.map(|&body| [place(body), bodies.len()]);
    let joints = model.joints.joints_among(bodies).filter(|joint| joint.has_rows()).map(|joint| {
        let mut held = joint.bodies().map(place);
        [held.next().unwrap_or(bodies.len()), held.next().unwrap_or(bodies.len())]
    });
    pivots.chain(joints).any(|[a, b]| {
        let is_closed = sets.smallest(a) == sets.smallest(b);
        sets.join(a, b);
        is_closed
    })
}
