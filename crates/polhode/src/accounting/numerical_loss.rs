//! Energy that the integrator has lost or gained between events, against the energy of the run.
//!
//! A method whose step is fixed may follow a force that is too fast for it: the energy then grows without bound, or
//! drains away, and the motion is another one. The ledger has that energy as `D_numerical`. A run in which it exceeds
//! [`LIMIT_RELATIVE`] of the largest energy is degraded, from the time on at which it first does.
//!
//! A method under error control promises less than that: what its tolerance allows in each step (`crate::promise`).
//!
//! The step that would do follows from the order p of the method: `D` grows as `h^p`. Where the energy has grown beyond
//! what the order describes, the fastest rates of the forces give it: an oscillation of rate w over the time T loses
//! about `w T (w h)^p`, a decay of rate c about `(c h)^p`.

use crate::Ledger;
use crate::snapshot::content;
use crate::world::{Rates, World};
use polhode_dynamics::BodyState;

/// The part of the largest energy of a run that its integrator may lose or gain (no unit, 1e-3 to 1e-1). A speed is then
/// wrong by half of that: a motion that differs by half a hundredth looks the same, and one that differs by more is told.
/// Methods under error control stay below 1e-9.
pub(crate) const LIMIT_RELATIVE: f64 = 1e-2;

/// Beyond this part of the energy a loss no longer follows the order of the method (no unit).
const OF_THE_ORDER: f64 = 0.5;

/// What the step that is proposed should leave, as a part of the limit (no unit).
const MARGIN: f64 = 0.5;

/// Rounding of a potential energy over a run, relative to it (no unit): what is lost below it is no loss.
const POTENTIAL_ROUNDING: f64 = 1e-12;

/// The loss when it first exceeded its limit.
#[derive(Debug, Clone, Copy)]
struct First {
    /// s.
    t: f64,
    rates: Rates,
}

/// The largest loss or gain of a run so far.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct NumericalLoss {
    /// The one with the largest size, J; a gain is negative.
    energy_j: f64,
    /// Relative to the largest energy of the run until then.
    relative: f64,
    first: Option<First>,
}

/// A method with a fixed step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FixedStep {
    /// s.
    pub(crate) step_s: f64,
    pub(crate) order: u32,
    /// Duration of the run, s.
    pub(crate) duration_s: f64,
}

impl NumericalLoss {
    /// Compares the loss in the ledger at `t` (s) with its limit.
    pub(crate) fn note(&mut self, world: &World, states: &[BodyState], t: f64, ledger: &Ledger) {
        let lost = ledger.numerical.value();
        // Nearly all steps of all runs end here, without a sum over the bodies.
        if lost.abs() <= self.relative * ledger.scale_j {
            return;
        }
        let scale = ledger.scale_j.max(world.lifting_energy_j());
        let relative = (lost.abs() - POTENTIAL_ROUNDING * world.start_potential().abs()) / scale;
        if relative > self.relative {
            (self.energy_j, self.relative) = (lost, relative);
        }
        if relative > LIMIT_RELATIVE && self.first.is_none() {
            self.first = Some(First { t, rates: world.fastest_rates(states) });
        }
    }

    /// The largest loss or gain relative to the energy of the run.
    pub(crate) fn relative(&self) -> f64 {
        self.relative
    }

    /// What is wrong, where the limit was exceeded.
    pub(crate) fn exceeded(&self, step: Option<FixedStep>) -> Option<String> {
        let First { t, rates } = self.first?;
        let (done, size) = if self.energy_j < 0.0 { ("gained", -self.energy_j) } else { ("lost", self.energy_j) };
        let percent = 100.0 * self.relative;
        let cure = match step {
            Some(step) => {
                format!("a step of {:.1e} s instead of {:e} s would do", self.sufficient(step, rates), step.step_s)
            }
            None => "a smaller tolerance would do".to_owned(),
        };
        Some(format!(
            "t = {t} s: degraded: the integrator {done} {size:.3e} J in all, {percent:.3} % of the largest energy of the \
             run; the limit is {} %: {cure}",
            100.0 * LIMIT_RELATIVE
        ))
    }

    /// What is wrong, where the loss is larger than a method under error control promises, relative to the energy of the
    /// run.
    pub(crate) fn broken(&self, promised: f64) -> Option<String> {
        (self.relative > promised).then(|| {
            let (done, size) = if self.energy_j < 0.0 { ("gained", -self.energy_j) } else { ("lost", self.energy_j) };
            let relative = self.relative;
            format!(
                "degraded: the integrator {done} {size:.3e} J in all, {relative:.3e} of the largest energy of the run; the \
                 promised limit is {promised:.3e}: a smaller method.tolerance, or method.crowding_tolerance where events \
                 crowd, would do"
            )
        })
    }

    /// A step (s) whose loss stays below the limit, to the order of the method.
    fn sufficient(&self, FixedStep { step_s, order, duration_s }: FixedStep, rates: Rates) -> f64 {
        let root = |x: f64| libm::pow(x, 1.0 / f64::from(order.max(1)));
        let allowed = MARGIN * LIMIT_RELATIVE;
        let by_order = step_s * root(allowed / self.relative.max(LIMIT_RELATIVE));
        let step_s = if self.relative <= OF_THE_ORDER || rates.is_zero() {
            by_order
        } else {
            let swings = (rates.oscillation * duration_s).max(1.0);
            let oscillation = root(allowed / swings) / rates.oscillation;
            let decay = root(allowed) / rates.decay;
            by_order.min(oscillation).min(decay)
        };
        // Two digits, rounded down.
        step_s * 0.95
    }

    /// As plain data.
    pub(super) fn save(&self) -> content::NumericalLoss {
        let first = self.first.map(|First { t, rates }| {
            let Rates { oscillation, decay } = rates;
            content::FirstLoss { t, oscillation, decay }
        });
        content::NumericalLoss { energy_j: self.energy_j, relative: self.relative, first }
    }

    /// From such data.
    pub(super) fn restored(saved: &content::NumericalLoss) -> Self {
        let first = |content::FirstLoss { t, oscillation, decay }| First { t, rates: Rates { oscillation, decay } };
        let first = saved.first.map(first);
        Self { energy_j: saved.energy_j, relative: saved.relative, first }
    }
}

#[cfg(test)]
mod tests {
    //! A loss within the promise is not told; one beyond it is, with both.
    use super::NumericalLoss;

    #[test]
    fn a_loss_beyond_what_the_tolerance_promises_is_told() {
        let loss = NumericalLoss { energy_j: -8e-5, relative: 3.5e-6, first: None };
        assert_eq!(loss.broken(4e-6), None);
        assert_eq!(loss.broken(f64::INFINITY), None);
        let told = loss.broken(1e-6).unwrap_or_default();
        assert!(told.contains("gained 8.000e-5 J") && told.contains("1.000e-6"), "{told}");
    }
}
