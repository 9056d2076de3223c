//! The method: a tier, and settings that override its choices.
//!
//! A setting that is given is used as it is; for one that is absent the tier or the plan chooses. The enumerations here
//! have only members that are implemented, so that a scene cannot ask for others.

use super::ErrorEstimation;
use super::SceneError;
use super::laws::{
    BroadPhaseMethod, ContactMethod, Coordinates, ImpactLaw, Integrator, Orientation, PropagationOrder, PulseExponent,
    Response, RotationRate,
};
use super::penalty::PenaltyMethod;
use super::promise::PromiseChanges;
use super::tiers::Tier;
use polhode_response::RestitutionLaw;

/// Most substeps of a step: beyond, a shorter step costs no more.
const MOST_SUBSTEPS: u32 = 1000;

/// What a run does at crowded events: events of an island that follow each other so closely that time hardly advances.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
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
    /// Substeps of a step, of the tier that has them; at least 1.
    pub substeps: Option<u32>,
    /// Integrator of bodies without active contacts. Constrained motion of the tier `accurate` is integrated by DOP853,
    /// or by RK4 when that is given here.
    pub integrator: Option<Integrator>,
    /// Coordinates of orientation, for `rk4`.
    pub orientation: Option<Orientation>,
    /// Variable of rotation, for `rk4`.
    pub rotation_rate: Option<RotationRate>,
    /// Impact law.
    pub impact: Option<ImpactLaw>,
    /// Which contact [`ImpactLaw::Propagation`] strikes first; by key when absent.
    pub propagation_order: Option<PropagationOrder>,
    /// Exponent of the springs of [`ImpactLaw::Pulse`]; Hertz's when absent.
    pub pulse_exponent: Option<PulseExponent>,
    /// Law of restitution of impacts with friction.
    pub restitution_law: Option<RestitutionLaw>,
    /// Contact forces.
    pub contact: Option<ContactMethod>,
    /// How bodies that touch act on each other.
    pub response: Option<Response>,
    /// Depth of the envelope of micro-collisions, m; a thousandth of the smallest body that moves when absent.
    pub collision_envelope_m: Option<f64>,
    /// Broad phase: how pairs that may touch are found. It affects the computing time only; results are the same bits.
    pub broad_phase: Option<BroadPhaseMethod>,
    /// Error allowed under error control, relative to size and speed of each body: of each step of constrained motion,
    /// and of free motion by an integrator that controls its error. No promised limit is below it.
    pub tolerance: Option<f64>,
    /// In which coordinates bodies that joints hold are integrated.
    pub coordinates: Option<Coordinates>,
    /// Largest number of events within one step.
    pub max_events_per_step: Option<u64>,
    /// What happens at crowded events.
    pub crowding: Option<Crowding>,
    /// Error allowed within a stretch of crowded events per [`Method::step_s`], relative to the size of each body.
    pub crowding_tolerance: Option<f64>,
    /// How the error of the run is estimated. The motion does not depend on it.
    pub error: Option<ErrorEstimation>,
    /// The springs of the tier `penalty`.
    pub penalty: Option<PenaltyMethod>,
    /// Limits in place of those that the tier promises.
    pub promise: PromiseChanges,
}

impl Method {
    /// The first setting given that only the default tier has; none where no such setting is given.
    pub(crate) fn first_of_default_tier(&self) -> Option<&'static str> {
        let given = [
            (self.tolerance.is_some(), "method.tolerance"),
            (self.integrator.is_some(), "method.integrator"),
            (self.orientation.is_some(), "method.orientation"),
            (self.rotation_rate.is_some(), "method.rotation_rate"),
            (self.coordinates == Some(Coordinates::Reduced), "method.coordinates"),
            (self.contact.is_some(), "method.contact"),
            (self.substeps.is_some(), "method.substeps"),
            (self.response.is_some(), "method.response"),
            (self.crowding.is_some(), "method.crowding"),
            (self.crowding_tolerance.is_some(), "method.crowding_tolerance"),
        ];
        given.into_iter().find(|(is_given, _)| *is_given).map(|(_, key)| key)
    }

    /// Checks the numbers.
    ///
    /// # Errors
    /// When one is out of range.
    pub(crate) fn check_numbers(&self) -> Result<(), SceneError> {
        if let Some(step) = self.step_s {
            super::error::positive("method.step", step)?;
        }
        if let Some(substeps) = self.substeps.filter(|substeps| !(1..=MOST_SUBSTEPS).contains(substeps)) {
            let accepted = "a whole number from 1 to 1000";
            return Err(SceneError::Number { key: "method.substeps", value: f64::from(substeps), accepted });
        }
        self.promise.validate()?;
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
        Ok(())
    }
}
