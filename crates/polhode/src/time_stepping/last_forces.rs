//! The forces of the last step at contacts and bilateral constraints: what the next step starts from.
//!
//! Contacts are found again by their identity. Forces (N) are impulses over the length of their step, so that steps of
//! other lengths start from them too. They are part of the state of a run: solutions are the same to the residual of
//! the solver, but not to the last bit, wherever they start.

use crate::constraint::ConstraintId;
use crate::identity::contact_id::{ContactId, Feature};
use crate::model::Model;
use crate::rows::assembly::Assembly;
use crate::snapshot::parts::{restored_id, save_contact};
use crate::snapshot::{SnapshotError, content};
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

/// What a contact bore, on A.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct ContactForce {
    /// Along its normal, N.
    normal: f64,
    /// In its tangent plane, world, N.
    along: DVec3,
    /// Of friction of rolling and spinning, world, N m.
    moment: DVec3,
}

/// The forces of the last step.
#[derive(Debug, Clone, Default)]
pub(super) struct LastForces {
    /// Of the contacts of each pair, by their features.
    by_pair: BTreeMap<(usize, usize), BTreeMap<Feature, ContactForce>>,
    /// Of the rows of each bilateral constraint, N.
    bilaterals: BTreeMap<ConstraintId, Vec<f64>>,
}

impl LastForces {
    fn of(&self, id: ContactId) -> Option<&ContactForce> {
        self.by_pair.get(&(id.a, id.b))?.get(&id.feature)
    }

    /// The reactions of all rows of an assembly, the first of which are these contacts, in a step of `h` (s); none
    /// where no force is known.
    pub(super) fn start(&self, assembly: &Assembly, contacts: usize, h: f64) -> Option<Vec<f64>> {
        let mut start = vec![0.0; assembly.problem.len()];
        for (row, start) in start.iter_mut().enumerate().take(contacts) {
            let id = assembly.constraint(row).and_then(|constraint| constraint.contact());
            *start = id.and_then(|id| self.of(id)).map_or(0.0, |force| h * force.normal);
        }
        let mut row = contacts;
        for bilateral in assembly.bilaterals() {
            let forces = self.bilaterals.get(&bilateral.id).filter(|forces| forces.len() == bilateral.rows.len());
            for (start, force) in start[row..].iter_mut().zip(forces.into_iter().flatten()) {
                *start = h * force;
            }
            row += bilateral.rows.len();
        }
        let tangents = assembly.tangents().iter();
        let along = tangents.map(|row| self.of(row.id).map_or(0.0, |force| h * row.along.normal.dot(force.along)));
        let about = assembly.of_rotations(&start).map(|(row, _)| {
            let moment = self.of(row.id).map_or(DVec3::ZERO, |force| force.moment);
            h * moment.dot(row.axis) / row.axis.length_squared()
        });
        let others: Vec<f64> = along.chain(about).collect();
        for (start, reaction) in start[row..].iter_mut().zip(others) {
            *start = reaction;
        }
        start.iter().any(|reaction| *reaction != 0.0).then_some(start)
    }

    /// Takes the reactions of all rows of an assembly, the first of which are these contacts, in a step of `h` (s).
    pub(super) fn note(&mut self, assembly: &Assembly, reactions: &[f64], contacts: usize, h: f64) {
        let mut forces: BTreeMap<ContactId, ContactForce> = BTreeMap::new();
        for (row, reaction) in reactions.iter().enumerate().take(contacts) {
            if let Some(id) = assembly.constraint(row).and_then(|constraint| constraint.contact()) {
                forces.entry(id).or_default().normal = reaction / h;
            }
        }
        for (row, reaction) in assembly.of_tangents(reactions) {
            forces.entry(row.id).or_default().along += row.along.normal * (reaction / h);
        }
        for (row, reaction) in assembly.of_rotations(reactions) {
            forces.entry(row.id).or_default().moment += row.axis * (reaction / h);
        }
        for (id, force) in forces {
            self.by_pair.entry((id.a, id.b)).or_default().insert(id.feature, force);
        }
        let mut row = contacts;
        for bilateral in assembly.bilaterals() {
            let own = reactions.get(row..row + bilateral.rows.len()).unwrap_or_default();
            self.bilaterals.insert(bilateral.id, own.iter().map(|reaction| reaction / h).collect());
            row += bilateral.rows.len();
        }
    }

    /// Takes forces of contacts on A: along the normal and in the tangent plane, world, N.
    pub(super) fn take_held(&mut self, forces: impl Iterator<Item = (ContactId, f64, DVec3)>) {
        for (id, normal, along) in forces {
            let force = ContactForce { normal, along, moment: DVec3::ZERO };
            self.by_pair.entry((id.a, id.b)).or_default().insert(id.feature, force);
        }
    }

    /// Takes the forces of these pairs, and of the bilateral constraints of these bodies (ascending), from others.
    pub(super) fn take_from(&mut self, others: &Self, bodies: &[usize], pairs: &[(usize, usize)]) {
        for pair in pairs {
            match others.by_pair.get(pair) {
                Some(contacts) => self.by_pair.insert(*pair, contacts.clone()),
                None => self.by_pair.remove(pair),
            };
        }
        let own = |id: &ConstraintId| bodies.binary_search(&id.bodies().0).is_ok();
        self.bilaterals
            .extend(others.bilaterals.iter().filter(|(id, _)| own(id)).map(|(&id, forces)| (id, forces.clone())));
    }

    /// Forgets the contacts of `pairs` that are not in `carrying`, which are sorted.
    pub(super) fn keep(&mut self, pairs: &[(usize, usize)], carrying: &[ContactId]) {
        if self.by_pair.is_empty() {
            return;
        }
        for &(a, b) in pairs {
            let Some(contacts) = self.by_pair.get_mut(&(a, b)) else { continue };
            contacts.retain(|&feature, _| carrying.binary_search(&ContactId { a, b, feature }).is_ok());
            if contacts.is_empty() {
                self.by_pair.remove(&(a, b));
            }
        }
    }

    /// Keeps the forces of these contacts, and forgets those of all others.
    pub(super) fn keep_contacts(&mut self, stays: impl Fn(ContactId) -> bool) {
        for (&(a, b), contacts) in &mut self.by_pair {
            contacts.retain(|&feature, _| stays(ContactId { a, b, feature }));
        }
        self.by_pair.retain(|_, contacts| !contacts.is_empty());
    }

    /// As plain data.
    pub(super) fn save(&self) -> content::LastForces {
        let of_pair = |(&(a, b), contacts): (&(usize, usize), &BTreeMap<Feature, ContactForce>)| {
            let saved = |(&feature, force): (&Feature, &ContactForce)| {
                let ContactForce { normal, along, moment } = *force;
                let (along, moment) = (along.to_array(), moment.to_array());
                content::LastForce { id: save_contact(ContactId { a, b, feature }), normal, along, moment }
            };
            contacts.iter().map(saved).collect::<Vec<_>>()
        };
        let bilateral = |(&id, forces): (&ConstraintId, &Vec<f64>)| {
            let of = match id {
                ConstraintId::Contact(_) => return None,
                ConstraintId::Pivot { body } => content::Held::Pivot(body),
                ConstraintId::Joint { joint, bodies } => content::Held::Joint(joint, bodies),
                ConstraintId::Tie { tie, bodies } => content::Held::Tie(tie, bodies),
            };
            Some((of, forces.clone()))
        };
        content::LastForces {
            contacts: self.by_pair.iter().flat_map(of_pair).collect(),
            bilaterals: self.bilaterals.iter().filter_map(bilateral).collect(),
        }
    }

    /// From plain data.
    ///
    /// # Errors
    /// When a contact is not of two bodies that can touch.
    pub(super) fn restored(model: &Model, saved: &content::LastForces) -> Result<Self, SnapshotError> {
        let mut restored = Self::default();
        for force in &saved.contacts {
            let id = restored_id(model, &force.id)?;
            let (along, moment) = (DVec3::from_array(force.along), DVec3::from_array(force.moment));
            let force = ContactForce { normal: force.normal, along, moment };
            restored.by_pair.entry((id.a, id.b)).or_default().insert(id.feature, force);
        }
        for (held, forces) in &saved.bilaterals {
            let id = match *held {
                content::Held::Pivot(body) => ConstraintId::Pivot { body },
                content::Held::Joint(joint, bodies) => ConstraintId::Joint { joint, bodies },
                content::Held::Tie(tie, bodies) => ConstraintId::Tie { tie, bodies },
            };
            restored.bilaterals.insert(id, forces.clone());
        }
        Ok(restored)
    }
}
