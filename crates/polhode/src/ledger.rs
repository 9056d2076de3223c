//! The ledger: where every joule went.
//!
//! `T + V + D_impact + D_friction + D_rest + D_damping - W_external + D_projection + D_numerical = E0`
//!
//! Every term is summed from its own measured source and none is the remainder, so that the closure checks the
//! book-keeping, and `D_numerical`, the energy that the integrator lost over smooth stages, is an honest statement of
//! accuracy. A positive `D` is energy lost. Sums are compensated. Momentum has a ledger of its own beside it.

use crate::MomentumLedger;
use polhode_spatial::CompensatedSum;

/// Energy booked by source, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Ledger {
    /// Lost in impacts, from impulses: `-p.(u- + u+)/2` with the relative velocities u, also where a kinematic body
    /// strikes.
    pub impact: CompensatedSum,
    /// Lost to friction.
    pub friction: CompensatedSum,
    /// Lost when small bounces were summed up or small velocities set to rest.
    pub rest: CompensatedSum,
    /// Lost to drag and dampers.
    pub damping: CompensatedSum,
    /// Work done by forces without a potential, by kinematic bodies and by a program.
    pub external: CompensatedSum,
    /// Lost (or, when negative, gained) by moving bodies out of each other and off inconsistent velocities.
    pub projection: CompensatedSum,
    /// Lost by the integrator over smooth stages: -(change of T + V - work).
    pub numerical: CompensatedSum,
    /// Total energy at the start, J, the potential counted from there.
    pub initial_j: f64,
    /// Total energy now, J, the potential counted from the start.
    pub current_j: f64,
    /// Largest `T + |V - V0|` so far, J: what closure is relative to.
    pub scale_j: f64,
    /// The same account of momentum.
    pub momentum: MomentumLedger,
}

impl Ledger {
    /// What is left unexplained, J.
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

    /// What is left unexplained, relative to the largest energy of the run.
    pub fn closure_relative(&self) -> f64 {
        let closure = self.closure_j().abs();
        if closure == 0.0 { 0.0 } else { closure / self.scale_j }
    }
}
