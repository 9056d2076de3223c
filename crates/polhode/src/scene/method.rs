//! The method: one tier and the knobs behind it.
//!
//! A knob that is given is used literally; one that is absent follows the tier. What is not built yet is not a member
//! here, so that it cannot be asked for.

use super::SceneError;
pub use polhode_contact::BroadPhaseMethod;
pub use polhode_dynamics::integrator::{Method as Integrator, Orientation, RotationRate};

/// A set of methods with one promise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tier {
    /// The thesis's section 3.5 to the letter: RK4, fixed step, propagation, least-force linear programme. It is kept for
    /// history and promises nothing of penetration.
    Thesis,
    /// Fixed steps at the level of velocities with exact complementarity; always gets through.
    Stepped,
    /// Flight records, error-controlled contact phases, located impacts and force events, exact contact forces.
    Accurate,
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

impl ImpactLaw {
    /// The name used in scenes and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Propagation => "propagation",
            Self::Simultaneous => "simultaneous",
            Self::Reflection => "reflection",
        }
    }
}

/// How the forces of resting contacts are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactMethod {
    /// The thesis's linear programme of least total force with its guesses of vanishing contacts.
    LeastForce,
    /// The exact complementarity problem by the active set.
    ActiveSet,
}

/// What happens at crowded events: events of an island that follow each other so closely that time hardly advances.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Crowding {
    /// It goes on by time steps at the level of velocities until they thin out.
    #[default]
    Step,
    /// The run ends with an error.
    Error,
}

impl Crowding {
    /// Whether time steps carry a run on.
    pub(crate) fn steps(self) -> bool {
        self == Self::Step
    }
}

/// What a scene asks for; `None` leaves the choice to the plan.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Method {
    /// The tier.
    pub tier: Option<Tier>,
    /// Step, s: the fixed step of `thesis` and `stepped`, the upper bound of a step of `accurate`.
    pub step_s: Option<f64>,
    /// Integrator of bodies that no contact holds; contact phases of `accurate` are integrated by DOP853.
    pub integrator: Option<Integrator>,
    /// Coordinates of orientation, for `rk4`.
    pub orientation: Option<Orientation>,
    /// Variable of rotation, for `rk4`.
    pub rotation_rate: Option<RotationRate>,
    /// Impact law.
    pub impact: Option<ImpactLaw>,
    /// Contact forces.
    pub contact: Option<ContactMethod>,
    /// How pairs that may touch are found; a choice of time alone, the results are the same bits.
    pub broad_phase: Option<BroadPhaseMethod>,
    /// Local error per step of contact phases, relative to size and speed of each body. Above the default (1e-11) it is also
    /// the penetration promised, relative to size.
    pub tolerance: Option<f64>,
    /// Largest number of events within one step.
    pub max_events_per_step: Option<u64>,
    /// What happens at crowded events.
    pub crowding: Option<Crowding>,
    /// Error allowed in a stretch of crowded events for each longest step, relative to the size of each body.
    pub crowding_tolerance: Option<f64>,
}

impl Method {
    /// Checks the numbers and that the knobs fit the tier.
    ///
    /// # Errors
    /// When a number is not positive, or two knobs are not yet available together.
    pub fn validate(&self) -> Result<(), SceneError> {
        if let Some(step) = self.step_s {
            super::error::positive("method.step", step)?;
        }
        if let Some(tolerance) = self.crowding_tolerance {
            super::error::positive("method.crowding_tolerance", tolerance)?;
        }
        if let Some(tolerance) = self.tolerance {
            super::error::positive("method.tolerance", tolerance)?;
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
        let tier = self.tier.unwrap_or(Tier::Accurate);
        if tier != Tier::Thesis && self.contact == Some(ContactMethod::LeastForce) {
            let tier = if tier == Tier::Stepped { "stepped" } else { "accurate" };
            return refuse(
                &format!("contact = \"least-force\" with tier = \"{tier}\""),
                "contact = \"active-set\", or tier = \"thesis\"",
            );
        }
        if let (Tier::Stepped, Some(integrator)) = (tier, self.integrator) {
            return refuse(
                &format!("integrator = \"{}\" with tier = \"stepped\"", integrator.name()),
                "no integrator: the tier moves bodies by exact drift with a kick",
            );
        }
        let representation = self.orientation.is_some() || self.rotation_rate.is_some();
        let rk4 = match self.integrator {
            Some(integrator) => integrator == Integrator::Rk4,
            None => tier == Tier::Thesis,
        };
        if representation && !rk4 {
            return refuse("orientation or rotation_rate without integrator = \"rk4\"", "integrator = \"rk4\"");
        }
        Ok(())
    }
}
