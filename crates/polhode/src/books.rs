//! Keeping the ledger: every change of energy is booked where it happens.

use crate::world::World;
use crate::{Energy, Ledger};
use polhode_dynamics::BodyState;
use polhode_spatial::CompensatedSum;

/// Total energy of the bodies named, J.
pub(crate) fn energy_of(world: &World, states: &[BodyState], bodies: &[usize]) -> f64 {
    let sum: CompensatedSum = bodies
        .iter()
        .flat_map(|&body| {
            let (kinetic, potential) = world.energies(body, &states[body]);
            [kinetic, potential]
        })
        .collect();
    sum.value()
}

/// The ledger of a run in progress.
#[derive(Debug, Clone)]
pub(crate) struct Books {
    pub(crate) ledger: Ledger,
    /// Potential energy at the start, J, zero at the world's origin: what reported energies contain and the ledger does
    /// not.
    initial_potential_j: f64,
}

impl Books {
    /// Opens the books at the state given.
    pub(crate) fn open(world: &World, states: &[BodyState]) -> Self {
        let (kinetic, potential) = totals(world, states);
        let initial_j = kinetic + potential;
        let mut books = Self {
            ledger: Ledger { initial_j, current_j: initial_j, ..Ledger::default() },
            initial_potential_j: world.initial_potential(),
        };
        books.note_scale(kinetic, potential);
        books
    }

    /// Takes note of the energies now: the total, and the scale that closure is relative to.
    pub(crate) fn observe(&mut self, world: &World, states: &[BodyState]) -> Energy {
        let (kinetic_j, potential) = totals(world, states);
        self.ledger.current_j = kinetic_j + potential;
        self.note_scale(kinetic_j, potential);
        let potential_j = self.initial_potential_j + potential;
        let initial_j = self.initial_potential_j + self.ledger.initial_j;
        Energy { initial_j, final_j: kinetic_j + potential_j, kinetic_j, potential_j }
    }

    fn note_scale(&mut self, kinetic: f64, potential: f64) {
        let scale = kinetic + potential.abs();
        // A scene that stays at rest has no energy of its own to be relative to: its potential energy serves.
        let scale = if scale == 0.0 { self.initial_potential_j.abs() } else { scale };
        self.ledger.scale_j = self.ledger.scale_j.max(scale);
    }
}

/// Kinetic energy of the scene, and potential energy against that at the start, J.
fn totals(world: &World, states: &[BodyState]) -> (f64, f64) {
    let mut kinetic = CompensatedSum::ZERO;
    let mut potential = CompensatedSum::ZERO;
    for (index, state) in states.iter().enumerate() {
        let (t, v) = world.energies(index, state);
        kinetic.add(t);
        potential.add(v);
    }
    (kinetic.value(), potential.value())
}
