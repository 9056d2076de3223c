//! How a run beside a run begins: by which method, with which steps, and from which states.
//!
//! It begins at the present of the run, with a copy of its model: what a program has changed is in it. A run by another
//! method refuses what its tier does not take, as any scene would; where bodies overlap they are moved apart before,
//! and by how much is part of the distance.

use crate::error::SimulationError;
use crate::error_estimate::references::StartOfRun;
use crate::model::plane_of_motion::PlanarBodies;
use crate::model::{Model, ModelBody};
use crate::report::frame::MotionKind;
use crate::report::run_error::ReferenceKind;
use crate::run::simulation::{Simulation, Start};
use crate::run::start_overlap;
use crate::scene::ErrorEstimation;
use crate::scene::{Method, Scene, SceneError};
use crate::solve::projection::{Removal, project_velocities};
use crate::tier::settings::Settings;
use polhode_dynamics::BodyState;
use polhode_spatial::{SplitMix64, Velocity};

/// The longest step (s) and the largest tolerance of a reference by other steps under error control. Steps alone would
/// change little where the tolerance bounds them, and the tolerance little where the steps do.
const LONG_STEP_S: f64 = 0.1;
const LARGE_TOLERANCE: f64 = 1e-4;

/// How many times larger the tolerance of a reference is where the run has a large one itself.
const LARGER_TOLERANCE: f64 = 100.0;

/// Seed of the signs of a disturbance.
const SIGNS: u64 = 52;

/// How many times shorter the steps under error control of another method are, and how much smaller its tolerance.
const SHORTER_STEPS: f64 = 0.37;
const SMALLER_TOLERANCE: f64 = 1e-1;

/// The smallest tolerance that rounding lets a step reach.
const SMALLEST_TOLERANCE: f64 = 1e-13;

/// How many times longer the time steps of a reference in stretches of crowded events are.
const LONGER_CROWDED_STEPS: f64 = 2.0;

/// A method of a reference.
#[derive(Debug, Clone)]
pub(super) struct ReferenceMethod {
    pub(super) settings: Settings,
    /// The method of its scene.
    pub(super) method: Method,
    /// In words.
    pub(super) words: String,
    /// What its distance from the run is multiplied by (no unit).
    pub(super) weight: f64,
}

impl Simulation {
    /// By which method a reference of this kind runs, the one that begins after so many others of its kind, in an
    /// estimate of this effort.
    pub(super) fn reference_method(&self, kind: ReferenceKind, effort: ErrorEstimation, begun: u32) -> ReferenceMethod {
        let factor = effort.step_factor(begun);
        match kind {
            ReferenceKind::OtherMethod => self.other_method(effort),
            ReferenceKind::Disturbed if self.disturbs_itself(effort) => ReferenceMethod {
                settings: self.core.settings.as_resolved(),
                method: self.scene.method().clone(),
                words: "the method of the run".to_owned(),
                weight: 1.0,
            },
            // Other tiers make contacts at other times, and differences grow at those.
            ReferenceKind::OtherSteps | ReferenceKind::Disturbed => self.other_steps(factor),
        }
    }

    /// Whether a disturbed run is one by the method of the run, and is compared with the run: what long steps at a
    /// large tolerance make of rounding depends on the steps that error control happens to take, and one by longer
    /// fixed steps may have left the motion of the run. A quick estimate cannot pay for a second run by fixed steps.
    pub(super) fn disturbs_itself(&self, effort: ErrorEstimation) -> bool {
        effort == ErrorEstimation::Full || self.core.settings.controls_error()
    }

    /// Another tier, with steps as long as they may be in a quick estimate; in one that is compared with itself, steps
    /// and tolerance as small as they may be.
    fn other_method(&self, effort: ErrorEstimation) -> ReferenceMethod {
        let (own, scene) = (&self.core.settings, self.scene.method());
        let tier = own.tier.facts().second_opinion;
        if tier == own.tier && !own.names_fixed_steps() {
            let mut settings = own.as_resolved();
            settings.step_s *= SHORTER_STEPS;
            settings.tolerance = (settings.tolerance * SMALLER_TOLERANCE).max(SMALLEST_TOLERANCE);
            let words = format!("tier {} at a tolerance of {:e}", tier.name(), settings.tolerance);
            return ReferenceMethod { settings, method: scene.clone(), words, weight: 1.5 };
        }
        // Contacts are found and followed at any step; long ones cost less, and are exact enough to be compared with.
        let step_s = (effort == ErrorEstimation::Quick).then_some(LONG_STEP_S);
        let method = Method {
            tier: Some(tier),
            step_s,
            impact: Some(own.impact),
            propagation_order: scene.propagation_order,
            pulse_exponent: scene.pulse_exponent,
            restitution_law: scene.restitution_law,
            max_events_per_step: scene.max_events_per_step,
            ..Method::default()
        };
        let settings = Settings::resolve(&method, tier);
        ReferenceMethod { settings, method, words: format!("tier {}", tier.name()), weight: 1.1 }
    }

    /// Longer steps: fixed ones by this factor.
    fn other_steps(&self, factor: f64) -> ReferenceMethod {
        let mut settings = self.core.settings.as_resolved();
        let method = self.scene.method().clone();
        if settings.tier.facts().controls_error() && !settings.names_fixed_steps() {
            let before = settings.tolerance;
            settings.step_s = LONG_STEP_S.max(settings.step_s);
            settings.tolerance = LARGE_TOLERANCE.max(LARGER_TOLERANCE * before);
            settings.crowd_step_factor = LONGER_CROWDED_STEPS;
            let words = format!("steps of {} s at a tolerance of {:e}", settings.step_s, settings.tolerance);
            let weight = 3.0 * before / settings.tolerance;
            return ReferenceMethod { settings, method, words, weight };
        }
        // Pairs are found once in a step: substeps become fewer before steps become longer.
        let substeps = (f64::from(settings.substeps) / factor).ceil();
        settings.step_s *= factor * substeps / f64::from(settings.substeps);
        settings.substeps = substeps as u32;
        settings.step_is_given = true;
        let words = format!("steps of {} s", settings.step_s);
        // Of first order the distance is `factor - 1` errors; the other factor is for what falls more slowly.
        ReferenceMethod { settings, method, words, weight: (1.7 / (factor - 1.0)).min(1.0) }
    }

    /// A reference by this method that begins there, disturbed by this part of its velocities.
    ///
    /// # Errors
    /// When its tier does not take the scene, or it cannot begin with these states.
    pub(super) fn beside(
        &self,
        by: &ReferenceMethod,
        from: &StartOfRun,
        disturbed_by: f64,
    ) -> Result<Self, SimulationError> {
        let scene = self.scene.clone().with_method(by.method.clone());
        let (model, at_start) = self.reference_model(by)?;
        let is_start = self.references.course.has_begun_at(from.t_s);
        if at_start.is_some() && !is_start {
            let what = format!("pivots in tier {} within a run by another tier", by.settings.tier.name());
            return Err(SceneError::NotYetAvailable { what, instead: "joints in their place".to_owned() }.into());
        }
        let mut states = at_start.unwrap_or_else(|| from.states.clone());
        if disturbed_by > 0.0 {
            self.disturb(&model, (&from.rested, &mut states), disturbed_by)?;
        }
        if by.settings.tier != self.core.settings.tier {
            start_overlap::move_apart(&model, &by.settings, (from.t_s, &mut states))?;
        }
        let (t_s, effects, settings) = (from.t_s, self.core.effects, by.settings);
        let start = Start { t_s, effects, settings, tier_reason: String::from("a reference") };
        let mut reference = Self::begin(&scene, (model, states), start)?;
        reference.core.executor = self.core.executor.clone();
        reference.core.accounts.take_no_samples();
        reference.ended = from.t_s >= self.scene.duration_s();
        Ok(reference)
    }

    /// The present of the run, where references that do not begin with it begin.
    pub(super) fn start_at_present(&self) -> StartOfRun {
        let rests = |motion: MotionKind| motion == MotionKind::Rest;
        StartOfRun {
            t_s: self.core.t,
            states: self.tier.states(&self.core),
            rested: self.tier.motions(&self.core).into_iter().map(rests).collect(),
        }
    }

    /// The model of a reference by this method: a copy, or where its tier holds pivots otherwise one made anew, with
    /// the states at the start of the run.
    ///
    /// # Errors
    /// When the tier of the method does not take the scene.
    pub(super) fn reference_model(
        &self,
        by: &ReferenceMethod,
    ) -> Result<(Model, Option<Vec<BodyState>>), SimulationError> {
        let own = &self.core.model;
        let scene: Scene = own.scene.clone().with_method(by.method.clone());
        if by.settings.tier != self.core.settings.tier {
            scene.check_method()?;
        }
        let mut model = own.clone();
        (model.scene, model.envelope, model.planar) = (scene, None, PlanarBodies::default());
        let rows = by.settings.pivot_rows(self.core.effects);
        let is_pivoted = |body: &ModelBody| body.held.is_some() || body.rigid.is_some_and(|rigid| rigid.is_pivoted());
        if rows == own.pivot_rows || !own.bodies.iter().any(is_pivoted) {
            return Ok((model, None));
        }
        let (model, states) = Model::new(&self.scene.clone().with_method(by.method.clone()), rows)?;
        Ok((model, Some(states)))
    }

    /// Changes the velocities of the bodies that do not rest by this part of them. Those that are about to begin get
    /// that part of the speed of a fall over their own size, up or down: what moves in a plane stays in it.
    fn disturb(
        &self,
        model: &Model,
        (rested, states): (&[bool], &mut [BodyState]),
        part: f64,
    ) -> Result<(), SimulationError> {
        let mut random = SplitMix64::new(SIGNS);
        let mut disturbed = Vec::new();
        for &body in &model.movable {
            let own = &model.bodies[body];
            let Some(rigid) = own.rigid.filter(|_| own.moves() && rested.get(body) != Some(&true)) else {
                continue;
            };
            let mut sign = || if random.uniform() < 0.5 { -part } else { part };
            let mut velocity = rigid.center_of_mass_velocity(&states[body]);
            if velocity == Velocity::ZERO {
                let speed = (model.gravity().length() * own.size).sqrt();
                velocity.linear = model.gravity().normalize_or_zero() * (sign() * speed);
            } else {
                velocity = Velocity::new(velocity.linear * (1.0 + sign()), velocity.angular * (1.0 + sign()));
            }
            states[body] = rigid.at_velocity(states[body].pose, velocity);
            disturbed.push(body);
        }
        let held = model.joints.with_jointed(disturbed);
        if model.joints.joints_among(&held).next().is_some() {
            project_velocities(model, states, &held, (&[], &[], &[]), Removal::Complete)
                .map_err(|source| SimulationError::of_response(self.core.t, source))?;
        }
        Ok(())
    }
}
