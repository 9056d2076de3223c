//! How a run is accompanied by the same run with time steps twice as long in its stretches of crowded events, and the
//! error of these stretches estimated by the distance of the two.
//!
//! It begins at the first such stretch, from the states there, follows every action of the program, and is compared
//! with the run at the end. Of time steps of length `h` the error is `e ~ h^p`, with `p` 2 between changes of contact
//! and 1 across them, whatever amplifies it later. That of the companion is `2^p e`, and the distance of the two runs
//! `(2^p - 1) e`, from `e` to `3 e`. The estimate is [`ESTIMATE_SAFETY`] times this distance, and the positions are at
//! least as uncertain as the errors of the steps themselves. Source: step doubling (docs/REFERENCES.md, Hairer, Norsett
//! and Wanner), applied to the whole motion and not to one step.
//!
//! Assumes that the error falls with the steps. Limit: two motions that have lost all memory of each other (chaos) are
//! as far apart as the scene is wide, which says that the error is as large. Where the companion ends with an error,
//! the estimate is absent, and a warning says why.

use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::report::run_report::CrowdingError;
use crate::run::companion::Companion;
use crate::run::simulation::Simulation;
use crate::snapshot::content::{self, Content};
use crate::solve::overlap::displacement;
use crate::tier::facts::TierFeature;

/// How many times longer its time steps are (no unit).
const STEP_FACTOR: f64 = 2.0;

/// The estimate in distances of the two runs (no unit, 1 to 3): where errors fall more slowly than with the length of
/// the steps, the distance is less than the error.
const ESTIMATE_SAFETY: f64 = 2.0;

/// The estimated error, relative to the size of the body, beyond which a warning says that its place is not known (no
/// unit, 0.01 to 1).
const PLACE_UNKNOWN: f64 = 0.1;

impl Companion<Simulation> {
    /// The companion as plain data.
    pub(crate) fn save(&self) -> content::Companion {
        match self {
            Self::None | Self::Itself => content::Companion::None,
            Self::Beside(companion) => content::Companion::Beside(Box::new(companion.content())),
            Self::Lost(reason) => content::Companion::Lost(reason.clone()),
        }
    }
}

impl Simulation {
    /// The companion that continues from this content.
    ///
    /// # Errors
    /// When the content contradicts itself.
    fn companion_from(&self, content: &Content) -> Result<Companion<Self>, SimulationError> {
        let mut settings = self.core.settings;
        settings.crowd_step_factor = STEP_FACTOR;
        self.twin(content, settings).map(|twin| Companion::Beside(Box::new(twin)))
    }

    /// The companion of a snapshot.
    ///
    /// # Errors
    /// When its content contradicts itself.
    pub(crate) fn restored_companion(&self, saved: &content::Companion) -> Result<Companion<Self>, SimulationError> {
        match saved {
            content::Companion::None => Ok(Companion::None),
            content::Companion::Beside(content) => self.companion_from(content),
            content::Companion::Lost(reason) => Ok(Companion::Lost(reason.clone())),
        }
    }

    /// Lets the companion follow: it begins with the first stretch of crowded events.
    pub(crate) fn accompany(&mut self) {
        let is_needed = self.core.settings.takes(TierFeature::CrowdedStretches) && self.core.accounts.has_crowded();
        if matches!(self.companion, Companion::None) && is_needed {
            let tier = self.tier.save_with_longer_steps(STEP_FACTOR);
            let begun = self.companion_from(&Content { tier, ..self.content() });
            self.companion = begun.unwrap_or_else(|error| Companion::Lost(error.to_string()));
        }
        // It is brought up seldom: each time costs the evaluation of its steps.
        if matches!(&self.companion, Companion::Beside(own) if self.time() - own.time() >= self.core.settings.step_s) {
            self.bring_companion();
        }
    }

    /// Advances the companion to the present of the run.
    pub(crate) fn bring_companion(&mut self) {
        let t = self.time();
        self.with_companion(|companion| companion.advance_to(t));
    }

    /// Repeats an action of the program on the companion.
    pub(crate) fn repeat_on_companion(&mut self, action: impl FnOnce(&mut Self) -> Result<(), SimulationError>) {
        self.bring_companion();
        self.with_companion(action);
    }

    /// Does something with the companion, if there is one. One that fails is lost.
    fn with_companion(&mut self, work: impl FnOnce(&mut Self) -> Result<(), SimulationError>) {
        let Companion::Beside(companion) = &mut self.companion else { return };
        if let Err(error) = work(companion) {
            self.companion = Companion::Lost(error.to_string());
        }
    }

    /// The estimated error at the present that stretches of crowded events have caused; none without one. The companion
    /// has been brought to the present.
    pub(crate) fn crowding_error(&self) -> Option<CrowdingError> {
        let Companion::Beside(companion) = &self.companion else { return None };
        let (own, other) = (self.tier.states(&self.core), companion.tier.states(&companion.core));
        let model = &self.core.model;
        let local: f64 = self.core.accounts.crowded.errors();
        let mut estimate =
            CrowdingError { position_m: 0.0, body: None, velocity_m_s: 0.0, angular_velocity_rad_s: 0.0 };
        for &body in model.movable.iter().filter(|&&body| model.bodies[body].moves()) {
            let apart = ESTIMATE_SAFETY * displacement(model, body, &own[body], &other[body]);
            let position_m = apart.max(local * model.bodies[body].size);
            if position_m > estimate.position_m {
                (estimate.position_m, estimate.body) = (position_m, Some(BodyId::new(body)));
            }
            let [one, two] = [&own, &other].map(|states| model.velocity(body, &states[body]));
            let (linear, angular) = ((one.linear - two.linear).length(), (one.angular - two.angular).length());
            estimate.velocity_m_s = estimate.velocity_m_s.max(ESTIMATE_SAFETY * linear);
            estimate.angular_velocity_rad_s = estimate.angular_velocity_rad_s.max(ESTIMATE_SAFETY * angular);
        }
        Some(estimate)
    }

    /// What a warning says where an estimated error leaves a body in no known place; none where all are known.
    pub(crate) fn unknown_motion(&self, error: &CrowdingError) -> Option<String> {
        let body = self.core.model.bodies.get(error.body?.index())?;
        let relative = error.position_m / body.size;
        (relative > PLACE_UNKNOWN).then(|| {
            format!(
                "where {} is at the end is not known: the estimated error of stretches of crowded events is \
                 {relative:.2} of its size. A smaller method.crowding_tolerance may do; where the motion amplifies \
                 every difference nothing does",
                body.name
            )
        })
    }
}
