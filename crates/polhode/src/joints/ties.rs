//! The ties of the world (`tie.rs`): made from the gears and prescribed motions of the scene, and found by their
//! bodies.

use crate::constraint::ConstraintId;
use crate::constraint::row::{Action, BilateralRow, RowKind};
use crate::constraint::tie::{HeldTo, Tie, Tied};
use crate::joints::bilateral::{Bilateral, Reaction};
use crate::model::Joints;
use crate::report::joint_efforts::Cause;
use crate::scene::{Coordinate, Gear, GearEnd, Scene};
use polhode_spatial::{DVec3, Pose, Velocity};
use std::collections::{BTreeMap, BTreeSet};

/// What a tie does to the first body of a joint, world.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LoadOfTie {
    /// The number of the joint.
    pub(crate) joint: usize,
    /// Along which of its coordinates it acts, and why.
    pub(crate) along: (Coordinate, Cause),
    /// Where the force acts, m.
    pub(crate) point: DVec3,
    /// N.
    pub(crate) force: DVec3,
    /// N m.
    pub(crate) moment: DVec3,
}

impl Joints {
    /// Makes the ties of the scene, between bodies with these motions at the start.
    pub(crate) fn make_ties(&mut self, scene: &Scene, motion: impl Fn(usize) -> (Pose, Velocity) + Copy) {
        let tied = |end: GearEnd| -> Option<Tied> {
            let joint = self.joint_numbered(end.joint.index())?;
            let place = joint.place_of(end.coordinate)?;
            let made = Tied { joint: joint.clone(), place, start: 0.0 };
            let start = made.value(motion)?;
            Some(Tied { start, ..made })
        };
        let gear = |(number, gear): (usize, &Gear)| {
            let [first, second] = gear.ends().map(tied);
            let to = HeldTo::Coordinate { second: Box::new(second?), ratio: gear.ratio(), last: 0.0 };
            Some(Tie { number, first: first?, to })
        };
        let gears = scene.gears.len();
        let mut ties: Vec<Tie> = scene.gears.iter().enumerate().filter_map(gear).collect();
        let motions = scene.coordinate_motions.iter().zip(self.carriages.clone()).enumerate();
        ties.extend(motions.filter_map(|(number, ((end, _), body))| {
            let to = HeldTo::Carriage { body, start: motion(body).0.translation.x };
            Some(Tie { number: gears + number, first: tied(*end)?, to })
        }));
        self.ties = ties;
        self.index_ties();
    }

    /// Enters the ties whose joints are there at their bodies.
    pub(crate) fn index_ties(&mut self) {
        let mut ties_of: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (place, tie) in self.ties.iter().enumerate().filter(|(_, tie)| self.is_at_work(tie)) {
            for body in tie.bodies() {
                ties_of.entry(body).or_default().push(place);
            }
        }
        self.ties_of_body = ties_of;
    }

    /// Whether the joints of a tie are there.
    fn is_at_work(&self, tie: &Tie) -> bool {
        tie.joints().all(|joint| self.joint_numbered(joint.number()).is_some())
    }

    /// The ties whose joints are there.
    pub(crate) fn ties_at_work(&self) -> impl Iterator<Item = &Tie> {
        self.ties.iter().filter(|tie| self.is_at_work(tie))
    }

    /// The ties of these bodies, in order.
    pub(crate) fn ties_among(&self, bodies: &[usize]) -> impl Iterator<Item = &Tie> {
        let bodies = if self.ties.is_empty() { &[] } else { bodies };
        let ties: BTreeSet<usize> =
            bodies.iter().filter_map(|body| self.ties_of_body.get(body)).flatten().copied().collect();
        ties.into_iter().map(|tie| &self.ties[tie])
    }

    /// What a tie is, in words.
    pub(crate) fn name_of_tie(&self, number: usize) -> String {
        let tie = self.ties.iter().find(|tie| tie.number == number);
        match tie.map(|tie| (&tie.to, tie.first.joint.number())) {
            Some((HeldTo::Carriage { .. }, joint)) => format!("the prescribed motion of joint {joint}"),
            _ => format!("gear {number}"),
        }
    }

    /// What the reaction of a tie does at its joints: to the first body of each.
    pub(crate) fn joint_loads_of_tie(&self, of: &Bilateral, reaction: Reaction) -> Vec<LoadOfTie> {
        let ConstraintId::Tie { tie, .. } = of.id else { return Vec::new() };
        let Some(tie) = self.ties.iter().find(|own| own.number == tie) else { return Vec::new() };
        let Some(BilateralRow { kind: RowKind::Tied { first, second }, .. }) = of.rows.first() else {
            return Vec::new();
        };
        let multiplier = of.multiplier(reaction);
        let cause = match tie.to {
            HeldTo::Carriage { .. } => Cause::PrescribedMotion,
            HeldTo::Coordinate { .. } => Cause::Gear,
        };
        let load = |(tied, action): (&Tied, &Action)| {
            let (joint, coordinate) = (tied.joint.number(), tied.joint.coordinates().get(tied.place)?.coordinate);
            let along = (coordinate, cause);
            Some(match action.times(multiplier) {
                Action::Force { direction, point } => {
                    LoadOfTie { joint, along, point, force: direction, moment: DVec3::ZERO }
                }
                Action::Moment(moment) => LoadOfTie { joint, along, point: of.point, force: DVec3::ZERO, moment },
            })
        };
        tie.coordinates().zip([first, second]).filter_map(load).collect()
    }
}
