//! The ledger of energy: the change of the total energy, booked by cause.
//!
//! `T + V + D_impact + D_friction + D_rest + D_damping - W_external + D_projection + D_numerical = E0`
//!
//! T is the kinetic and V the potential energy, E0 their sum at the start; a positive D is energy lost. Every term is
//! computed from its own cause and none is the remainder of the others. What is left of the equation, the closure,
//! therefore checks the book-keeping, and `D_numerical`, the energy that the integrator lost between events, measures
//! its accuracy. Sums are compensated. [`crate::report::momentum_ledger`] does the same for momentum.

use crate::report::momentum_ledger::MomentumLedger;
use polhode_spatial::CompensatedSum;

/// Energy booked by cause, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Ledger {
    /// Lost in impacts: `-p.(u- + u+)/2` from the impulses p and the relative velocities u before and after, also for
    /// impacts of kinematic bodies.
    pub impact: CompensatedSum,
    /// Lost to friction.
    pub friction: CompensatedSum,
    /// Lost when small bounces were summed up in closed form, and when small velocities were set to zero at rest.
    pub rest: CompensatedSum,
    /// Lost to drag and dampers.
    pub damping: CompensatedSum,
    /// Work done on the bodies by forces without a potential, by kinematic bodies and by a program.
    pub external: CompensatedSum,
    /// Lost (or, when negative, gained) by projections: of overlaps and separations of active contacts, and of their
    /// velocities.
    pub projection: CompensatedSum,
    /// Lost by the integrator between events: `-(change of T + V) + work` of the forces.
    pub numerical: CompensatedSum,
    /// Total energy at the start, J, with potential energy zero at the start.
    pub initial_j: f64,
    /// Total energy now, J, with potential energy zero at the start.
    pub current_j: f64,
    /// Largest `T + |V - V0|` so far, J: the scale of [`Ledger::closure_relative`].
    pub scale_j: f64,
    /// The ledger of momentum.
    pub momentum: MomentumLedger,
}

impl Ledger {
    /// The closure, J: the part of the change of energy that no term explains.
    pub fn closure_j(&self) -> f64 {
        let mut sum = CompensatedSum::new(self.current_j);
        sum.extend([
            self.impact.value(),
            self.friction.value(),
            self.rest.value(),
            self.damping.value(),
            -self.external.value(),
            self.projection.value(),
            self.numerical.value(),
            -self.initial_j,
        ]);
        sum.value()
    }

    /// Magnitude of the closure, relative to the largest energy of the run.
    pub fn closure_relative(&self) -> f64 {
        let closure = self.closure_j().abs();
        if closure == 0.0 { 0.0 } else { closure / self.scale_j }
    }
}
