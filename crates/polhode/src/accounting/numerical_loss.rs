//! Energy that the integrator has lost or gained between events, against the energy of the run.
//!
//! A method whose step is fixed may follow a force that is too fast for it: the energy then grows without bound, or
//! drains away, and the motion is another one. The ledger has that energy as `D_numerical`. A run in which it exceeds
//! the promised part of the largest energy (`crate::tier::promise`) is degraded, from the time on at which it first
//! does.
//!
//! The step that would do follows from the order p of the method: `D` grows as `h^p`. Where the energy has grown beyond
//! what the order describes, the fastest rates of the forces give it: an oscillation of rate w over the time T loses
//! about `w T (w h)^p`, a decay of rate c about `(c h)^p`.

use crate::model::{Model, Rates, rates};
use crate::report::broken_promise::BrokenPromise;
use crate::report::ledger::Ledger;
use crate::snapshot::content;
use polhode_dynamics::BodyState;

/// Beyond this part of the energy a loss no longer follows the order of the method (no unit).
const OF_THE_ORDER: f64 = 0.5;

/// What a step that is proposed should leave, as a part of the limit (no unit).
pub(super) const LEFT_BY_SHORTER_STEP: f64 = 0.5;

/// The smallest part of an energy that is told in per cent (no unit).
const READ_IN_PER_CENT: f64 = 1e-4;

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
    /// Compares the loss in the ledger at `t` (s) with its limit, relative to the largest energy.
    pub(crate) fn note(&mut self, model: &Model, (t, states): (f64, &[BodyState]), ledger: &Ledger, limit: f64) {
        let lost = ledger.numerical.value();
        // Nearly all steps of all runs end here, without a sum over the bodies.
        if lost.abs() <= self.relative * ledger.scale_j {
            return;
        }
        let scale = ledger.scale_j.max(rates::lifting_energy_j(model));
        let relative = (lost.abs() - POTENTIAL_ROUNDING * model.forces.start_potential().abs()) / scale;
        if relative > self.relative {
            (self.energy_j, self.relative) = (lost, relative);
        }
        if relative > limit && self.first.is_none() {
            self.first = Some(First { t, rates: rates::fastest_rates(model, states) });
        }
    }

    /// The largest loss or gain relative to the energy of the run.
    pub(crate) fn relative(&self) -> f64 {
        self.relative
    }

    /// What is wrong, where the loss exceeded its limit, relative to the largest energy, in a run by fixed steps or,
    /// without them, under error control.
    pub(crate) fn exceeded(&self, limit: f64, step: Option<FixedStep>) -> Option<BrokenPromise> {
        let First { t, rates } = self.first.filter(|_| self.relative > limit)?;
        let (done, size) = if self.energy_j < 0.0 { ("gained", -self.energy_j) } else { ("lost", self.energy_j) };
        let cure = match step {
            Some(step) => {
                let sufficient = self.sufficient(limit, step, rates);
                format!("a step of {sufficient:.1e} s instead of {:e} s would do", step.step_s)
            }
            None => "a smaller method.tolerance, or method.crowding_tolerance where events crowd, would do".to_owned(),
        };
        let what = format!(
            "the integrator {done} {size:.3e} J in all, {} of the largest energy of the run; the promised limit is {}",
            part(self.relative),
            part(limit)
        );
        Some(BrokenPromise::exceeding(what, self.relative, limit).at(t).cured_by(cure))
    }

    /// A step (s) whose loss stays below the limit, to the order of the method.
    fn sufficient(&self, limit: f64, FixedStep { step_s, order, duration_s }: FixedStep, rates: Rates) -> f64 {
        let root = |x: f64| libm::pow(x, 1.0 / f64::from(order.max(1)));
        let allowed = LEFT_BY_SHORTER_STEP * limit;
        let by_order = step_s * root(allowed / self.relative.max(limit));
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

/// A part of an energy in words: in per cent where it is large enough to be read so.
fn part(relative: f64) -> String {
    if relative > READ_IN_PER_CENT { format!("{:.3} %", 100.0 * relative) } else { format!("{relative:.3e}") }
}

#[cfg(test)]
mod tests {
    //! A loss within the promise is not told; one beyond it is, with both.
    use super::{First, NumericalLoss};
    use crate::model::Rates;

    #[test]
    fn a_loss_beyond_what_is_promised_is_told() {
        let first = Some(First { t: 0.5, rates: Rates { oscillation: 0.0, decay: 0.0 } });
        let loss = NumericalLoss { energy_j: -8e-5, relative: 3.5e-6, first };
        assert_eq!(loss.exceeded(4e-6, None), None);
        let told = loss.exceeded(1e-6, None).map(|told| told.to_string()).unwrap_or_default();
        assert!(told.contains("gained 8.000e-5 J") && told.contains("is 1.000e-6"), "{told}");
    }
}
