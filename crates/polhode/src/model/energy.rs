//! Energies of the bodies, and their centre of mass at the start.
//!
//! Potential energies are measured from the start of the run: far from the world's origin the potential itself is so
//! large that its rounding exceeds its changes.

use super::bodies::Model;
use polhode_dynamics::BodyState;
use polhode_dynamics::energy::potential_energy;
use polhode_spatial::{CompensatedSum, DVec3};

impl Model {
    /// Kinetic energy of one body, and its potential energy relative to that at the start, J.
    pub(crate) fn energies(&self, index: usize, state: &BodyState) -> (f64, f64) {
        let body = &self.bodies[index];
        body.rigid.as_ref().filter(|_| !body.removed).map_or((0.0, 0.0), |rigid| {
            let risen = rigid.center_of_mass_position(state) - body.start;
            (rigid.kinetic_energy(state), potential_energy(rigid.mass(), self.gravity(), risen))
        })
    }

    /// Potential energy of the conservative fields, J.
    pub(crate) fn field_potential(&self, states: &[BodyState]) -> f64 {
        if self.forces.fields.is_empty() {
            return 0.0;
        }
        let states = self.movable_states(states);
        self.forces.fields.iter().map(|field| field.potential_energy(&self.rigid, &states)).sum()
    }

    /// Potential energy of the conservative fields relative to that at the start, J.
    pub(crate) fn field_energy(&self, states: &[BodyState]) -> f64 {
        self.field_potential(states) - self.forces.initial_potential_j
    }

    /// Potential energy of the bodies that are there where each began, J: gravity, zero at the world's origin, and that
    /// of the fields at the start of the run. Reported potential energies are counted from it. It is computed from the
    /// bodies anew, so that no order of adding and removing leaves anything behind.
    pub(super) fn sum_start_potentials(&self) -> f64 {
        let bodies = self.bodies.iter().filter(|body| !body.removed);
        let potentials =
            bodies.filter_map(|body| Some(potential_energy(body.rigid.as_ref()?.mass(), self.gravity(), body.start)));
        potentials.collect::<CompensatedSum>().value() + self.forces.initial_potential_j
    }

    /// Centre of mass of the movable bodies at the start, m; the origin when there are none.
    pub(crate) fn initial_center_of_mass(&self) -> DVec3 {
        let (mut mass, mut moment) = (0.0, DVec3::ZERO);
        for (rigid, start) in self.bodies.iter().filter_map(|body| Some((body.rigid.as_ref()?, body.start))) {
            mass += rigid.mass();
            moment += start * rigid.mass();
        }
        if mass > 0.0 { moment / mass } else { DVec3::ZERO }
    }
}
