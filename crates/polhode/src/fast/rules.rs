//! The numbers of a step: softness of contacts, substeps, thresholds.
//!
//! A contact gives way as a spring whose frequency is an eighth of the rate of substeps (30 Hz with four in 1/60 s),
//! with the damping ratio [`DAMPING`]; one with a body that does not move is twice as stiff ([`DAMPING_WITH_FIXED`]),
//! as joints are ([`JOINT_DAMPING`]). Nothing here is an absolute time or length, so that a scene in other units moves
//! as before. Source: docs/REFERENCES.md, Catto 2024, which has 30 Hz, the damping ratio 10 and 3 m/s.

use crate::model::Model;
use crate::scene::ContactMethod;
use polhode_response::sequential_impulses::{Softness, SweepOrder, SweepRule};

/// By how much overlaps of a pair may grow in a step that finds contacts only once, relative to the smaller body (no
/// unit, 2e-2 to 1e-1): half of what the tier promises.
pub(super) const OVERLAP_GROWTH: f64 = 5e-2;

/// Frequency of the spring of a contact as a part of the rate of substeps (no unit): a quarter is the most that is
/// followed.
const OF_THE_RATE: f64 = 0.125;

/// Damping ratio of a contact (no unit, 5 to 10): overlaps are pushed apart without a bounce. The larger, the less a
/// tall stack sinks before it is borne, and the longer it swings: a contact forgets `1 / (1 + h w (2 z + h w))` of its
/// impulse in a substep, a thirteenth here.
const DAMPING: f64 = 7.5;

/// That of a contact with a body that does not move (no unit): nothing swings on a contact that stands on the ground.
const DAMPING_WITH_FIXED: f64 = 5.0;

/// How much stiffer contacts with bodies are that do not move (no unit).
const WITH_FIXED: f64 = 2.0;

/// Damping ratio of a joint (no unit, 1 to 5): the smaller it is, the faster a gap closes, and the more of its impulse
/// a joint forgets in a substep.
const JOINT_DAMPING: f64 = 2.0;

/// How far overlaps are pushed apart in a step at most, in sizes of the smallest body that moves (no unit, 0.05 to
/// 0.2).
const PUSH_OF_SIZE: f64 = 0.1;

/// A contact that approaches more slowly than gravity makes it in this many steps does not bounce (no unit): it rests.
const RESTING_STEPS: f64 = 2.0;

/// Sweeps of the relax stage with conjugate gradients between them (no unit, 2 to 30): fewer are hardly better than
/// one.
const CONJUGATE_SWEEPS: u32 = 8;

/// Pieces of a substep that is divided.
const QUARTERS: u32 = 4;

/// The numbers of a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rules {
    pub(super) substeps: u32,
    /// Length of a substep, s.
    pub(super) h: f64,
    /// Frequency of the spring of a contact, Hz.
    frequency: f64,
    /// Whether other forces act than gravity on centres of mass.
    pub(super) has_loads: bool,
    /// Whether force fields are among them: they may couple any bodies.
    pub(super) has_fields: bool,
    pub(super) soft: SweepRule,
    /// Of joints: as stiff as contacts with bodies that do not move.
    pub(super) soft_joints: SweepRule,
    pub(super) relax: SweepRule,
    /// Sweeps of the relax stage: with more than one, conjugate gradients are between them.
    pub(super) relax_sweeps: u32,
    /// Substeps of all steps before, if the steps are of one kind; only whether they are even or odd matters.
    substeps_before: u64,
}

impl Rules {
    /// Those of a step of this length (s) in so many substeps, where a whole step has the length `whole_s` (s). The
    /// softness of contacts and the speed at which overlaps are pushed apart are those of whole steps: a step that a
    /// sample or a program cuts short would else push with what a whole step may move, in no time.
    pub(super) fn new(step_s: f64, whole_s: f64, substeps: u32, model: &Model) -> Self {
        let gravity = model.gravity();
        let h = step_s / f64::from(substeps);
        let frequency = OF_THE_RATE * f64::from(substeps) / whole_s;
        let moving = model.bodies.iter().filter(|body| body.moves() && body.size > 0.0);
        let smallest = moving.map(|body| body.size).fold(f64::INFINITY, f64::min);
        let relax = SweepRule {
            between: Softness::RIGID,
            with_fixed: Softness::RIGID,
            push: PUSH_OF_SIZE * smallest / whole_s,
            inverse_step: 1.0 / h,
            colliding: RESTING_STEPS * gravity.length() * whole_s,
        };
        let rules = Self {
            substeps,
            h,
            frequency,
            has_loads: model.has_loads(),
            has_fields: model.forces.has_fields(),
            soft: relax,
            soft_joints: relax,
            relax,
            relax_sweeps: 1,
            substeps_before: 0,
        };
        rules.with_substep(h)
    }

    /// The same with substeps of this length (s).
    fn with_substep(self, h: f64) -> Self {
        let relax = SweepRule { inverse_step: 1.0 / h, ..self.relax };
        let soft = SweepRule {
            between: Softness::of_spring(self.frequency, DAMPING, h),
            with_fixed: Softness::of_spring(WITH_FIXED * self.frequency, DAMPING_WITH_FIXED, h),
            ..relax
        };
        let joint = Softness::of_spring(WITH_FIXED * self.frequency, JOINT_DAMPING, h);
        let soft_joints = SweepRule { between: joint, with_fixed: joint, ..soft };
        Self { h, soft, soft_joints, relax, ..self }
    }

    /// The same by a method of contact forces.
    pub(super) fn by(self, contact: ContactMethod) -> Self {
        let relax_sweeps = if contact == ContactMethod::ConjugateGradients { CONJUGATE_SWEEPS } else { 1 };
        Self { relax_sweeps, ..self }
    }

    /// The same after so many steps.
    pub(super) fn after(self, steps: u64) -> Self {
        Self { substeps_before: steps.wrapping_mul(u64::from(self.substeps)), ..self }
    }

    /// Into how many pieces a step is divided: its substeps, and one of these into quarters.
    pub(super) fn pieces(&self) -> u32 {
        if self.substeps > 1 { self.substeps } else { QUARTERS }
    }

    /// Those of one of its pieces.
    pub(super) fn of_piece(&self, number: u32) -> Self {
        let substeps_before = self.substeps_before.wrapping_add(u64::from(number));
        let own = Self { substeps: 1, substeps_before, ..*self };
        if self.substeps > 1 { own } else { own.with_substep(self.h / f64::from(QUARTERS)) }
    }

    /// The orders of both sweeps of a substep: onward and back, in the next one back and onward, and so on from step to
    /// step.
    ///
    /// What a sweep leaves of an error is no symmetric matrix times it: errors turn as they fade, and the impulses that
    /// are carried over make a stack swing. A sweep and its adjoint, which goes back, leave a symmetric one, without
    /// negative eigenvalues: nothing turns. So the sweeps of a substep are adjoint to each other, and those of one kind
    /// in two substeps are. Source: docs/REFERENCES.md, Saad 2003, 4.1 (symmetric Gauss-Seidel).
    pub(super) fn orders(&self, substep: u32) -> [SweepOrder; 2] {
        use SweepOrder::{Back, Onward};
        let is_even = self.substeps_before.wrapping_add(u64::from(substep)).is_multiple_of(2);
        if is_even { [Onward, Back] } else { [Back, Onward] }
    }
}
