//! Bodies under the scene's force fields, and under contact forces that are constant over a step (thesis, equations 15
//! and 16).

use polhode_dynamics::field::{self, Account, Dependence, Field, Wrench};
use polhode_dynamics::{BodyState, FreeMotion, RigidBody};
use polhode_spatial::DVec3;
use std::sync::Arc;

/// The forces on the movable bodies during a step.
#[derive(Debug)]
pub(super) struct LoadedBodies {
    fields: [Box<dyn Field>; 1],
}

impl Default for LoadedBodies {
    fn default() -> Self {
        Self::new(Arc::from(Vec::new()), Vec::new())
    }
}

impl LoadedBodies {
    /// The scene's fields, and a constant load per movable body, with torques about the centres of mass.
    pub(super) fn new(fields: Arc<[Box<dyn Field>]>, loads: Vec<Wrench>) -> Self {
        Self { fields: [Box::new(FieldsAndLoads { fields, loads })] }
    }

    /// The motion of `bodies` under gravity and these forces.
    pub(super) fn motion<'a>(&'a self, bodies: &'a [RigidBody], gravity: DVec3) -> FreeMotion<'a> {
        FreeMotion::new(bodies, gravity, &self.fields)
    }
}

/// The scene's fields and the constant loads as one field for an integrator.
#[derive(Debug)]
struct FieldsAndLoads {
    fields: Arc<[Box<dyn Field>]>,
    loads: Vec<Wrench>,
}

impl Field for FieldsAndLoads {
    fn dependence(&self) -> Dependence {
        self.fields.iter().map(|field| field.dependence()).max().unwrap_or(Dependence::Poses)
    }

    fn account(&self) -> Account {
        Account::External
    }

    fn acts_on(&self, body: usize) -> bool {
        let load = self.loads.get(body).is_some_and(|load| *load != Wrench::default());
        load || self.fields.iter().any(|field| field.acts_on(body))
    }

    fn corner_between(&self, from: f64, to: f64) -> Option<f64> {
        field::corner_between(&self.fields, from, to)
    }

    fn add_wrenches(&self, t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        for field in self.fields.iter() {
            field.add_wrenches(t, bodies, states, wrenches);
        }
        for (wrench, load) in wrenches.iter_mut().zip(&self.loads) {
            wrench.force += load.force;
            wrench.torque += load.torque;
        }
    }

    fn potential_energy(&self, bodies: &[RigidBody], states: &[BodyState]) -> f64 {
        self.fields.iter().map(|field| field.potential_energy(bodies, states)).sum()
    }
}
