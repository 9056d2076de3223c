//! The scene: everything a simulation starts from.
//!
//! A [`Scene`] is plain, validated data. Friction and restitution of a pair of bodies follow from their two materials
//! by the rule of [`Material::combined`], unless a [`PairRule`] overrides it. The file format is in polhode-scene.
//!
//! | module | holds |
//! |---|---|
//! | `builder` | [`SceneBuilder`]: collects the parts of a scene |
//! | `body` | [`Body`]: fixed, kinematic or moved by forces |
//! | `geometry` | [`Geometry`]: the shape of a body; [`ApproximateParts`]: how well it fills a mesh |
//! | `material` | [`Material`], [`PairRule`]: friction and restitution |
//! | `grain` | [`FrictionEllipse`]: friction along and across a grain |
//! | `force` | [`Force`]: forces besides uniform gravity and contact |
//! | `freedom` | [`Coordinate`], [`Freedom`]: what a joint leaves free; [`Limits`], springs, a [`Motor`] along it |
//! | `copies` | [`SceneCopy`]: scenes set otherwise; `joint_copy` does it for joints |
//! | `joint` | [`Joint`]: what holds two bodies, or one and the world; `joint_checks` says when it is refused |
//! | `track` | [`TrackId`], [`TrackHold`]: curves that bodies follow; `joint_on_track` places bodies on them |
//! | `gear` | [`Gear`]: coordinates of two joints that move together |
//! | `coordinate_motion` | [`CoordinateMotion`], which is prescribed |
//! | `strength` | [`Strength`]: the load at which a joint breaks |
//! | [`motion`] | prescribed motions of kinematic bodies |
//! | `method` | [`Method`]: the tier and the settings that override its choices |
//! | `laws` | [`ImpactLaw`], [`ContactMethod`], [`Response`], [`Integrator`] and other choices of a method |
//! | `restitution` | [`RestitutionSpeed`]: restitution that falls with speed |
//! | `penalty` | [`PenaltyMethod`]: the springs of the tier `penalty`; `spring_checks` says when they are refused |
//! | `error_estimation` | [`ErrorEstimation`]: how the error of a run is estimated |
//! | `promise` | [`Promise`]: how far a run may be from its scene and still end well |
//! | `pairs` | how many pairs of bodies may collide |
//! | `tiers` | [`Tier`]: the names of the tiers |
//! | `effects` | [`Effects`](crate::Effects): which effects a run simulates |
//! | `appearance` | [`Appearance`]: how a scene is shown |
//! | `few_digits` | numbers and lengths as messages say them |
//! | `error` | [`SceneError`]: why a scene is refused |

mod appearance;
mod body;
mod builder;
mod coordinate_motion;
mod copies;
pub(crate) mod effects;
mod error;
mod error_estimation;
pub(crate) mod few_digits;
mod force;
mod freedom;
mod gear;
mod geometry;
mod grain;
mod joint;
mod joint_checks;
mod joint_copy;
mod joint_on_track;
mod laws;
mod material;
mod method;
pub mod motion;
mod pairs;
mod penalty;
mod promise;
mod restitution;
pub(crate) mod spring_checks;
mod strength;
pub(crate) mod tiers;
mod track;

pub use appearance::{Appearance, BodyLook, COLORS, Standpoint};
pub use body::{Body, BodyMass};
pub use builder::SceneBuilder;
pub use coordinate_motion::CoordinateMotion;
pub use copies::{CopyError, ListOrder, SceneCopy};
pub(crate) use error::{MOST_NAMES, positive};
pub use error::{OverlapAtStart, SceneError};
pub use error_estimation::ErrorEstimation;
pub(crate) use force::MovingFrames;
pub use force::{Attachment, Force};
pub use freedom::{Coordinate, Drive, Freedom, FreedomError, JointFriction, Limits, LimitsError, Motor};
pub(crate) use gear::GearEnd;
pub use gear::{Gear, GearError};
pub use geometry::{ApproximateParts, Geometry};
pub use grain::FrictionEllipse;
pub(crate) use grain::GrainOf;
pub use joint::{Joint, JointKind};
pub use laws::{
    BroadPhaseMethod, ContactMethod, Coordinates, ImpactLaw, Integrator, Orientation, PropagationOrder, PulseExponent,
    Response, RotationRate,
};
pub use material::{Material, PairRule};
pub use method::{Crowding, Method};
pub use motion::{
    Excursion, Interpolation, MotionError, MotionTable, PrescribedMotion, SampledOrientations, Trajectory,
};
pub use penalty::{PenaltyMethod, SpringDamping, SpringFriction, SpringLaw};
pub use polhode_dynamics::field::{DragLaw, Frame, Signal};
pub use polhode_response::RestitutionLaw;
pub use promise::{OverlapLimit, Promise, PromiseChanges};
pub use restitution::RestitutionSpeed;
pub use strength::Strength;
pub use tiers::Tier;
pub(crate) use track::LEAST_SINE;
pub use track::{Follows, OneSide, TrackEnds, TrackHold, TrackId, TrackSprings};

use crate::identity::body_id::BodyId;
use polhode_spatial::DVec3;
use polhode_spatial::curve::Curve;
use std::sync::Arc;

/// Standard gravity of the scene format, m/s^2.
pub const DEFAULT_GRAVITY: DVec3 = DVec3::new(0.0, 0.0, -9.81);

/// Largest number of samples, or of steps, of a run.
const MOST_STEPS: f64 = 1e12;

/// A validated scene.
#[derive(Debug, Clone)]
pub struct Scene {
    pub(crate) name: String,
    pub(crate) duration_s: f64,
    pub(crate) output_interval_s: f64,
    pub(crate) gravity: DVec3,
    pub(crate) method: Method,
    pub(crate) bodies: Vec<Body>,
    pub(crate) forces: Vec<Force>,
    pub(crate) joints: Vec<Joint>,
    pub(crate) tracks: Vec<Arc<Curve>>,
    pub(crate) gears: Vec<Gear>,
    pub(crate) coordinate_motions: Vec<(GearEnd, CoordinateMotion)>,
    pub(crate) pair_rules: Vec<PairRule>,
    pub(crate) no_contact: Vec<Vec<usize>>,
    pub(crate) start_separation_m: f64,
}

impl Scene {
    /// The scene's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Simulated time, s.
    pub fn duration_s(&self) -> f64 {
        self.duration_s
    }

    /// Time between samples, s.
    pub fn output_interval_s(&self) -> f64 {
        self.output_interval_s
    }

    /// Acceleration of gravity, m/s^2.
    pub fn gravity(&self) -> DVec3 {
        self.gravity
    }

    /// Overlap of bodies at the start that is removed by moving them apart, at most, m.
    pub fn start_separation_m(&self) -> f64 {
        self.start_separation_m
    }

    /// The method asked for.
    pub fn method(&self) -> &Method {
        &self.method
    }

    /// The same scene with another method.
    pub fn with_method(mut self, method: Method) -> Self {
        self.method = method;
        self
    }

    /// The same scene with another duration (s).
    ///
    /// # Errors
    /// When the duration is not positive and finite.
    pub fn with_duration(mut self, duration_s: f64) -> Result<Self, SceneError> {
        self.duration_s = positive("duration", duration_s)?;
        Ok(self)
    }

    /// The same scene with samples at this interval.
    ///
    /// # Errors
    /// When the interval is not positive and finite, or there would be too many samples.
    pub fn with_output_interval(mut self, interval_s: f64) -> Result<Self, SceneError> {
        self.output_interval_s = positive("output.interval", interval_s)?;
        self.check_counts()?;
        Ok(self)
    }

    /// Checks that a run has at most [`MOST_STEPS`] samples and steps, so that it ends.
    pub(crate) fn check_counts(&self) -> Result<(), SceneError> {
        let duration_s = self.duration_s;
        let too_many = |interval_s: f64| duration_s / interval_s > MOST_STEPS;
        if too_many(self.output_interval_s) {
            return Err(SceneError::TooManySamples { duration_s, interval_s: self.output_interval_s });
        }
        match self.method.step_s.filter(|&step_s| too_many(step_s)) {
            Some(step_s) => Err(SceneError::TooManySteps { duration_s, step_s }),
            None => Ok(()),
        }
    }

    /// Checks body number `number`, which a program adds to a simulation.
    ///
    /// # Errors
    /// As [`SceneBuilder::build`].
    pub(crate) fn check_added_body(number: usize, body: &Body, name_is_taken: bool) -> Result<(), SceneError> {
        if name_is_taken {
            return Err(SceneError::DuplicateName(body.name.clone()));
        }
        body.check(number)
    }

    /// The bodies, in the order of the scene.
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// Forces besides gravity and contact.
    pub fn forces(&self) -> &[Force] {
        &self.forces
    }

    /// Friction and restitution of a pair of bodies of the scene.
    ///
    /// # Errors
    /// When the scene has no such body.
    pub fn material_between(&self, a: BodyId, b: BodyId) -> Result<Material, SceneError> {
        self.known(a)?;
        self.known(b)?;
        Ok(self.pair_material(a.index(), b.index()))
    }

    /// Whether two bodies of the scene may collide: forces move at least one, both have a shape, no joint holds them
    /// together, and no `no_contact` group names both.
    pub fn can_collide(&self, a: BodyId, b: BodyId) -> bool {
        self.known(a).is_ok() && self.known(b).is_ok() && self.may_collide(a.index(), b.index())
    }

    /// The handle of the body with this name.
    pub fn body_id(&self, name: &str) -> Option<BodyId> {
        self.bodies.iter().position(|body| body.name == name).map(BodyId::new)
    }

    fn known(&self, body: BodyId) -> Result<(), SceneError> {
        if body.index() < self.bodies.len() { Ok(()) } else { Err(SceneError::UnknownBody(body.index())) }
    }

    /// Gives the bodies of the material of this name this one; their numbers.
    pub(crate) fn replace_material(&mut self, material: &Material) -> Vec<usize> {
        let mut replaced = Vec::new();
        for (number, body) in self.bodies.iter_mut().enumerate() {
            if body.material.name() == material.name() {
                body.material = material.clone();
                replaced.push(number);
            }
        }
        replaced
    }

    /// Friction and restitution of a pair of bodies by their numbers.
    pub(crate) fn pair_material(&self, a: usize, b: usize) -> Material {
        let (ma, mb) = (&self.bodies[a].material, &self.bodies[b].material);
        let mut combined = ma.combined(mb);
        for rule in &self.pair_rules {
            rule.apply(ma, mb, &mut combined);
        }
        combined
    }

    /// Checks that no kinematic body whose velocity jumps during the run may touch a body that forces move: contacts
    /// would need an impulse, of which the table of a motion does not say how it passes.
    ///
    /// # Errors
    /// With the first such body.
    pub(crate) fn check_motions(&self) -> Result<(), SceneError> {
        for (index, body) in self.bodies.iter().enumerate() {
            let Some(t_s) = body.motion().and_then(|motion| motion.jump_between(0.0, self.duration_s)) else {
                continue;
            };
            let holds = |other: usize| self.joints.iter().any(|joint| joint.joins(index, other));
            let acts_on = |other: usize| self.may_collide(index, other) || holds(other);
            let moved = |other: &usize| !self.bodies[*other].is_fixed() && acts_on(*other);
            if let Some(other) = (0..self.bodies.len()).find(moved) {
                let [body, other] = [index, other].map(|body| self.bodies[body].name.clone());
                return Err(SceneError::MotionJumps { body, other, t_s });
            }
        }
        Ok(())
    }

    /// What is good to know about the scene before it runs: tables of motions that leave the range of their samples.
    pub fn warnings(&self) -> Vec<String> {
        let excursion = |body: &Body| {
            // Seen from axes other than its own, a monotone table leaves the range of a coordinate without any fault.
            let motion = body.motion().filter(|motion| motion.interpolation() == Some(Interpolation::Spline))?;
            let found = motion.excursion()?;
            Some(format!(
                "the motion of body {} is a spline: {found}; interpolation = \"monotone\" stays between the samples",
                body.name
            ))
        };
        self.bodies.iter().filter_map(excursion).collect()
    }

    /// Whether the surface of any body moves.
    pub(crate) fn has_moving_surfaces(&self) -> bool {
        self.bodies.iter().any(|body| body.surface_velocity != DVec3::ZERO)
    }

    /// Whether any two bodies may collide.
    pub fn any_may_collide(&self) -> bool {
        // Two neighbours in the list usually may collide; testing them first saves the count of all pairs.
        (1..self.bodies.len()).any(|body| self.may_collide(body - 1, body)) || self.colliding().count > 0
    }

    /// Whether two bodies may collide: forces move at least one, both have a shape, no joint holds them together, and
    /// no `no_contact` group names both.
    pub(crate) fn may_collide(&self, a: usize, b: usize) -> bool {
        let (body_a, body_b) = (&self.bodies[a], &self.bodies[b]);
        a != b
            && !(body_a.is_fixed() && body_b.is_fixed())
            && body_a.geometry.is_some()
            && body_b.geometry.is_some()
            && !self.no_contact.iter().any(|group| group.contains(&a) && group.contains(&b))
            && !self.joints.iter().any(|joint| joint.joins(a, b))
    }
}
