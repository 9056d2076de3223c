//! The method: a tier, and settings that override its choices.
//!
//! A setting that is given is used as it is; for one that is absent the tier or the plan chooses. The enumerations here
//! have only members that are implemented, so that a scene cannot ask for others.

use super::SceneError;
pub use polhode_contact::BroadPhaseMethod;
pub use polhode_dynamics::integrator::{Method as Integrator, Orientation, RotationRate};
use polhode_response::RestitutionLaw;

/// A set of methods with one promise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tier {
    /// The algorithm of the thesis's section 3.5, unchanged: RK4 at a fixed step, propagation of impulses, linear
    /// programme of least total force. It is kept for comparison and has no limit of penetration.
    Thesis,
    /// Fixed time steps at the level of velocities, with an exact complementarity problem at each. Every step has a
    /// solution; its error depends on the length of the step.
    Stepped,
    /// Free flight in closed form, constrained motion under error control, located events, exact contact forces.
    Accurate,
}

/// The law that determines the impulses of an impact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ImpactLaw {
    /// One contact after the other until none approaches (thesis 3.3).
    Propagation,
    /// All contacts at once after Newton and Moreau (thesis 3.4, end).
    Simultaneous,
    /// Generalised reflection after Smith et al.: it keeps the symmetry of a scene, and momentum passes through chains
    /// of bodies.
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
    /// The thesis's linear programme of least total force, with its guesses of which contacts open and bear no force.
    LeastForce,
    /// The exact complementarity problem by the active set.
    ActiveSet,
}

/// How bodies that touch act on each other. The members besides [`Response::Constraint`] are the models that the thesis
/// tries first (section 3.3) and rejects: they are wrong, each in its own way, and only the tier `thesis` has them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Response {
    /// By forces that keep contacts from closing, and by impulses where bodies approach.
    #[default]
    Constraint,
    /// By impulses alone, where bodies approach. Between two steps a resting body falls freely: it sinks.
    Impulse,
    /// By impulses where bodies approach, after which bodies that overlap are moved apart. Lifting a body gives it
    /// energy: it never comes to rest.
    ImpulseProjection,
    /// By impulses at every contact that overlaps, whether the bodies approach or separate. An impulse at a contact
    /// that separates pulls: bodies stay caught in each other.
    ImpulseUnconditional,
}

impl Response {
    /// The name used in scenes and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Constraint => "constraint",
            Self::Impulse => "impulse",
            Self::ImpulseProjection => "impulse-projection",
            Self::ImpulseUnconditional => "impulse-unconditional",
        }
    }
}

/// What a run does at crowded events: events of an island that follow each other so closely that time hardly advances.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Crowding {
    /// It advances the island by time steps at the level of velocities until the events are fewer.
    #[default]
    Step,
    /// The run ends with an error.
    Error,
}

impl Crowding {
    /// Whether a run advances by time steps at crowded events.
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
    /// Integrator of bodies without active contacts. Constrained motion of the tier `accurate` is integrated by DOP853,
    /// or by RK4 when that is given here.
    pub integrator: Option<Integrator>,
    /// Coordinates of orientation, for `rk4`.
    pub orientation: Option<Orientation>,
    /// Variable of rotation, for `rk4`.
    pub rotation_rate: Option<RotationRate>,
    /// Impact law.
    pub impact: Option<ImpactLaw>,
    /// Law of restitution of impacts with friction.
    pub restitution_law: Option<RestitutionLaw>,
    /// Contact forces.
    pub contact: Option<ContactMethod>,
    /// How bodies that touch act on each other.
    pub response: Option<Response>,
    /// Broad phase: how pairs that may touch are found. It affects the computing time only; results are the same bits.
    pub broad_phase: Option<BroadPhaseMethod>,
    /// Error allowed under error control, relative to size and speed of each body: of each step of constrained motion,
    /// and of free motion by an integrator that controls its error. Above the default (1e-11) it is also the promised
    /// limit of penetration, relative to size.
    pub tolerance: Option<f64>,
    /// Largest number of events within one step.
    pub max_events_per_step: Option<u64>,
    /// What happens at crowded events.
    pub crowding: Option<Crowding>,
    /// Error allowed within a stretch of crowded events per [`Method::step_s`], relative to the size of each body.
    pub crowding_tolerance: Option<f64>,
}

impl Method {
    /// Checks the numbers, and that the settings are available together.
    ///
    /// # Errors
    /// When a number is out of range, or two settings are not yet available together.
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
        if let Some(RestitutionLaw::ChatterjeeRuina { tangential_restitution: value }) = self.restitution_law
            && !(-1.0..=1.0).contains(&value)
        {
            let (key, accepted) = ("method.tangential_restitution", "a number in [-1, 1]");
            return Err(SceneError::Number { key, value, accepted });
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
        if let (Tier::Accurate | Tier::Stepped, Some(response)) = (tier, self.response)
            && response != Response::Constraint
        {
            return refuse(
                &format!("response = \"{}\" with this tier", response.name()),
                "response = \"constraint\", or tier = \"thesis\"",
            );
        }
        if let (Tier::Stepped, Some(integrator)) = (tier, self.integrator) {
            return refuse(
                &format!("integrator = \"{}\" with tier = \"stepped\"", integrator.name()),
                "tier = \"stepped\" without an integrator (it has its own: exact flight with forces as a kick)",
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
