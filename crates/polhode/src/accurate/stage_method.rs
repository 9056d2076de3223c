//! The Runge-Kutta methods that move an island, with the forces of its constraints at every stage.
//!
//! | method | order | error | within a step |
//! |---|---|---|---|
//! | DOP853 | 8 | estimated; the step is chosen so that it stays below the tolerance | its own dense output |
//! | DOP853 in reduced coordinates (`reduced_step.rs`) | 8 | the same | polynomials through eight times of it |
//! | classical (`integrator = "rk4"`) | 4 | not estimated; the step is fixed | polynomials through shorter steps |
//!
//! The classical method is that of the thesis (3.3, "Simulating Motion when in Free Fall"), here with the contact
//! forces of 3.4 at each of the four stages; the tier `thesis` keeps them constant over a step. A step that an event
//! cuts short is repeated with the shorter length. The states within a step are therefore those of shorter steps from
//! the same start, at eight times, and a polynomial interpolates them: an event is located on the states that the
//! repeated step will have. Source of the methods: docs/REFERENCES.md, Hairer, Norsett and Wanner, II.1 and II.5.

use super::reduced_step::ReducedStep;
use super::system::ContactSystem;
use crate::scene::Coordinates;
use crate::tier::settings::Settings;
use polhode_dynamics::{DenseStep, Dop853, Rk4};
use polhode_response::ResponseError;

/// A method that integrates constrained motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum StageMethod {
    Dop853,
    Classical,
    /// DOP853 in the coordinates of joints.
    Reduced,
}

impl StageMethod {
    /// The scene's method: DOP853, unless it names the classical method.
    pub(super) fn of(settings: &Settings) -> Self {
        match settings.coordinates {
            _ if settings.constrains_by_rk4() => Self::Classical,
            Coordinates::Reduced => Self::Reduced,
            _ => Self::Dop853,
        }
    }

    /// A step from (`t`, `state`) over `h` (s).
    ///
    /// # Errors
    /// Those of the system.
    pub(super) fn attempt(
        self,
        system: &mut ContactSystem<'_>,
        (t, h): (f64, f64),
        state: Vec<f64>,
    ) -> Result<MethodStep, ResponseError> {
        match self {
            Self::Reduced => {
                // The scene has been checked: its islands are trees, and touch nothing unless a program adds a body.
                let made = if system.is_held_by_contacts() {
                    None
                } else {
                    ReducedStep::attempt(system, (t, h), state.clone())?
                };
                let Some(step) = made else { return Self::Dop853.attempt(system, (t, h), state) };
                Ok(MethodStep::Reduced(Box::new(step)))
            }
            Self::Dop853 => {
                let mut method = Dop853::new(state.len());
                method.attempt_unscaled(system, t, &state, h)?;
                Ok(MethodStep::Dop853(Box::new(method)))
            }
            Self::Classical => {
                let mut end = state.clone();
                Rk4::new(state.len()).step(system, t, h, &mut end)?;
                Ok(MethodStep::Classical { t, h, start: state, end })
            }
        }
    }
}

/// A step of a method.
#[derive(Debug)]
pub(super) enum MethodStep {
    Dop853(Box<Dop853>),
    Reduced(Box<ReducedStep>),
    Classical { t: f64, h: f64, start: Vec<f64>, end: Vec<f64> },
}

impl MethodStep {
    /// Flat state at its end.
    pub(super) fn end_state(&self) -> &[f64] {
        match self {
            Self::Dop853(method) => method.end_state(),
            Self::Reduced(step) => step.end_state(),
            Self::Classical { end, .. } => end,
        }
    }

    /// The method with an error estimate for each number of the bodies, if it has one.
    pub(super) fn embedded(&self) -> Option<&Dop853> {
        match self {
            Self::Dop853(method) => Some(method),
            Self::Reduced(_) | Self::Classical { .. } => None,
        }
    }

    /// Whether it estimates its error.
    pub(super) const fn estimates_error(&self) -> bool {
        matches!(self, Self::Dop853(_) | Self::Reduced(_))
    }

    /// The state at any time within the step.
    ///
    /// # Errors
    /// Those of the system.
    pub(super) fn dense(&mut self, system: &mut ContactSystem<'_>) -> Result<DenseStep, ResponseError> {
        match self {
            Self::Dop853(method) => method.dense(system),
            Self::Reduced(step) => step.dense(system),
            Self::Classical { t, h, start, end } => {
                let mut method = Rk4::new(start.len());
                DenseStep::through_values(*t, *h, |x| {
                    if x <= 0.0 {
                        return Ok(start.clone());
                    }
                    if x >= 1.0 {
                        return Ok(end.clone());
                    }
                    let mut state = start.clone();
                    method.step(system, *t, x * *h, &mut state)?;
                    Ok(state)
                })
            }
        }
    }
}
