//! The numbers of a step: softness of contacts, substeps, thresholds.
//!
//! A contact gives way as a spring of [`FREQUENCY_HZ`] (at most a quarter of the rate of substeps, or it would not be followed) with the
//! damping ratio [`DAMPING`]; one with a body that does not move is twice as stiff. Source: docs/REFERENCES.md, Catto 2024.

use crate::world::World;
use polhode_response::sequential_impulses::{Softness, SweepRule};
use polhode_spatial::DVec3;

/// Frequency of the spring of a contact, Hz.
const FREQUENCY_HZ: f64 = 30.0;

/// Largest frequency as a part of the rate of substeps (no unit).
const OF_THE_RATE: f64 = 0.25;

/// Damping ratio of a contact (no unit): overlaps are pushed apart without a bounce.
const DAMPING: f64 = 10.0;

/// How much stiffer contacts with bodies are that do not move (no unit).
const WITH_FIXED: f64 = 2.0;

/// Speed at which overlaps are pushed apart at most, m/s.
const PUSH_M_S: f64 = 3.0;

/// A contact that approaches more slowly than gravity makes it in this many steps does not bounce (no unit): it rests.
const RESTING_STEPS: f64 = 2.0;

/// The numbers of a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rules {
    pub(super) substeps: u32,
    /// Length of a substep, s.
    pub(super) h: f64,
    /// What gravity gives in a substep, m/s.
    pub(super) kick: DVec3,
    /// Whether other forces act than gravity on centres of mass.
    pub(super) has_loads: bool,
    pub(super) soft: SweepRule,
    pub(super) relax: SweepRule,
}

impl Rules {
    /// Those of a step of this length (s) in so many substeps.
    pub(super) fn new(step_s: f64, substeps: u32, world: &World) -> Self {
        let gravity = world.gravity();
        let h = step_s / f64::from(substeps);
        let frequency = FREQUENCY_HZ.min(OF_THE_RATE / h);
        let soft = SweepRule {
            between: Softness::of_spring(frequency, DAMPING, h),
            with_fixed: Softness::of_spring(WITH_FIXED * frequency, DAMPING, h),
            push: PUSH_M_S,
            inverse_step: 1.0 / h,
            colliding: RESTING_STEPS * gravity.length() * step_s,
        };
        let relax = SweepRule { between: Softness::RIGID, with_fixed: Softness::RIGID, ..soft };
        Self { substeps, h, kick: gravity * h, has_loads: world.has_loads(), soft, relax }
    }
}
