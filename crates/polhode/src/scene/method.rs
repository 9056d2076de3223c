//! The method: one tier and the knobs behind it.
//!
//! A knob that is given is used literally; one that is absent follows the tier. What is not built yet is not a member
//! here, so that it cannot be asked for.

use super::SceneError;

/// A set of methods with one promise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tier {
    /// The thesis's section 3.5 to the letter: RK4, fixed step, propagation, least-force linear programme.
    Thesis,
    /// Flight records, error-controlled contact phases, located impacts and force events, exact contact forces.
    Accurate,
}

/// How free motion and contact phases are integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Integrator {
    /// Classical Runge-Kutta on orientation and angular momentum, with the step given (tier `thesis`).
    Rk4,
    /// Closed-form flight; contact phases by DOP853 (tier `accurate`).
    Exact,
}

/// What happens when bodies hit each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ImpactLaw {
    /// One contact after the other until none approaches (thesis 3.3).
    Propagation,
    /// All contacts at once after Newton and Moreau (thesis 3.4, end).
    Simultaneous,
    /// Generalised reflection after Smith et al.: symmetric, and momentum still travels through chains.
    Reflection,
}

/// How the forces of resting contacts are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactMethod {
    /// The thesis's linear programme of least total force with its guesses of vanishing contacts.
    LeastForce,
    /// The exact complementarity problem by the active set.
    ActiveSet,
}

/// What a scene asks for; `None` leaves the choice to the plan.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Method {
    /// The tier.
    pub tier: Option<Tier>,
    /// Step, s: the fixed step of `thesis`, the upper bound of a step of `accurate`.
    pub step_s: Option<f64>,
    /// Integrator.
    pub integrator: Option<Integrator>,
    /// Impact law.
    pub impact: Option<ImpactLaw>,
    /// Contact forces.
    pub contact: Option<ContactMethod>,
    /// Local error per step of contact phases, relative to size and speed of each body.
    pub tolerance: Option<f64>,
    /// Largest number of events within one step.
    pub max_events_per_step: Option<u64>,
}

impl Method {
    /// Checks the numbers and that the knobs fit the tier.
    ///
    /// # Errors
    /// When a number is not positive, or two knobs are not yet available together.
    pub fn validate(&self) -> Result<(), SceneError> {
        if let Some(step) = self.step_s {
            super::builder::positive("method.step", step)?;
        }
        if let Some(tolerance) = self.tolerance {
            super::builder::positive("method.tolerance", tolerance)?;
            if tolerance > 0.1 {
                return Err(SceneError::Number {
                    key: "method.tolerance",
                    value: tolerance,
                    accepted: "a number in (0, 0.1]",
                });
            }
        }
        let refuse = |what: &str, instead: &str| {
            Err(SceneError::NotYetAvailable { what: what.to_owned(), instead: instead.to_owned() })
        };
        match (self.tier.unwrap_or(Tier::Accurate), self.integrator, self.contact) {
            (Tier::Thesis, Some(Integrator::Exact), _) => {
                refuse("integrator = \"exact\" with tier = \"thesis\"", "integrator = \"rk4\"")
            }
            (Tier::Accurate, Some(Integrator::Rk4), _) => {
                refuse("integrator = \"rk4\" with tier = \"accurate\"", "integrator = \"exact\", or tier = \"thesis\"")
            }
            (Tier::Accurate, _, Some(ContactMethod::LeastForce)) => refuse(
                "contact = \"least-force\" with tier = \"accurate\"",
                "contact = \"active-set\", or tier = \"thesis\"",
            ),
            _ => Ok(()),
        }
    }
}
