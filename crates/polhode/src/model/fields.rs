//! The force fields over the movable bodies, and what a program applies to them.

use super::field_index::{FieldBuffers, FieldIndex};
use crate::constraint::joint_forces::JointForce;
use polhode_dynamics::field::{Account, Dependence, Field, Wrench};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The force fields over the movable bodies, and what they act on.
#[derive(Debug, Clone)]
pub(crate) struct Forces {
    pub(super) fields: Arc<[Box<dyn Field>]>,
    /// Those of them that act at joints, which follow each other from `first_of_joints` on.
    pub(crate) of_joints: Vec<JointForce>,
    pub(crate) first_of_joints: usize,
    /// Whether a field, or the torque of gravity about a pivot, can act on any body.
    pub(super) load_any: bool,
    /// Bodies with a force that changes with time even while they rest, ascending.
    pub(super) driven: Vec<usize>,
    /// For each field that couples bodies (a spring, mutual gravity): the bodies that it couples.
    pub(crate) couplings: Vec<Vec<usize>>,
    pub(super) index: FieldIndex,
    pub(super) buffers: FieldBuffers,
    /// Force and torque (N, N m, world) that a program applies, by body.
    pub(super) applied: BTreeMap<usize, Wrench>,
    /// Potential energy of the fields at the start, J.
    pub(super) initial_potential_j: f64,
    /// [`Model::sum_start_potentials`], J.
    pub(super) start_potential_j: f64,
}

impl Default for Forces {
    /// No force.
    fn default() -> Self {
        Self {
            fields: Arc::from(Vec::new()),
            of_joints: Vec::new(),
            first_of_joints: 0,
            load_any: false,
            driven: Vec::new(),
            couplings: Vec::new(),
            index: FieldIndex::default(),
            buffers: FieldBuffers::default(),
            applied: BTreeMap::new(),
            initial_potential_j: 0.0,
            start_potential_j: 0.0,
        }
    }
}

impl Forces {
    /// The forces and torques (N, N m) that a program applies, by body, as plain numbers.
    pub(crate) fn applied(&self) -> Vec<(usize, [[f64; 3]; 2])> {
        let numbers = |(&body, wrench): (&usize, &Wrench)| (body, [wrench.force.to_array(), wrench.torque.to_array()]);
        self.applied.iter().map(numbers).collect()
    }

    /// The force fields, shared.
    pub(crate) fn shared_fields(&self) -> Arc<[Box<dyn Field>]> {
        Arc::clone(&self.fields)
    }

    /// Whether a step gives the field of this number as a kick: all but the forces at joints that are not among
    /// `kicks`.
    pub(super) fn is_kick(&self, number: usize, kicks: &[usize]) -> bool {
        let at_joints = self.first_of_joints..self.first_of_joints + self.of_joints.len();
        !at_joints.contains(&number) || kicks.contains(&number)
    }

    /// Whether a force on the body changes with time even while all bodies rest.
    pub(crate) fn is_driven(&self, body: usize) -> bool {
        self.driven.binary_search(&body).is_ok()
    }

    /// Whether any force field acts.
    pub(crate) fn has_fields(&self) -> bool {
        !self.fields.is_empty()
    }

    /// Whether any force field depends on velocities.
    pub(crate) fn has_loads_of_velocities(&self) -> bool {
        self.fields.iter().any(|field| field.dependence() == Dependence::Velocities)
    }

    /// Whether any force field's work belongs to this account.
    pub(crate) fn has_fields_of(&self, account: Account) -> bool {
        self.fields.iter().any(|field| field.account() == account)
    }
}

impl Forces {
    /// [`Model::sum_start_potentials`] of the bodies that are there now, J.
    pub(crate) fn start_potential(&self) -> f64 {
        self.start_potential_j
    }
}
