//! Building and checking a scene.

use super::{Body, DEFAULT_GRAVITY, Force, Geometry, Method, PairRule, PrescribedMotion, Scene, SceneError, force};
use polhode_contact::Shape;
use polhode_spatial::DVec3;
use std::collections::BTreeSet;

/// Simulated time when none is given, s.
const DEFAULT_DURATION_S: f64 = 1.0;

/// Time between samples when none is given, s.
const DEFAULT_OUTPUT_INTERVAL_S: f64 = 0.01;

/// Samples or steps of a run at the most.
const MOST_STEPS: f64 = 1e12;

/// How far the velocity given to a pivoted body may be from that of its rotation, relative to it.
const PIVOT_VELOCITY_RELATIVE: f64 = 1e-9;

/// Collects the parts of a scene; [`SceneBuilder::build`] checks them together.
#[derive(Debug, Clone)]
pub struct SceneBuilder {
    scene: Scene,
}

impl SceneBuilder {
    pub(super) fn new(name: String) -> Self {
        Self {
            scene: Scene {
                name,
                duration_s: DEFAULT_DURATION_S,
                output_interval_s: DEFAULT_OUTPUT_INTERVAL_S,
                gravity: DEFAULT_GRAVITY,
                method: Method::default(),
                bodies: Vec::new(),
                forces: Vec::new(),
                pair_rules: Vec::new(),
                no_contact: Vec::new(),
            },
        }
    }

    /// Simulated time, s.
    pub fn duration_s(mut self, duration_s: f64) -> Self {
        self.scene.duration_s = duration_s;
        self
    }

    /// Time between samples, s.
    pub fn output_interval_s(mut self, interval_s: f64) -> Self {
        self.scene.output_interval_s = interval_s;
        self
    }

    /// Acceleration of gravity, m/s^2.
    pub fn gravity(mut self, gravity: DVec3) -> Self {
        self.scene.gravity = gravity;
        self
    }

    /// The method.
    pub fn method(mut self, method: Method) -> Self {
        self.scene.method = method;
        self
    }

    /// One more body.
    pub fn body(mut self, body: Body) -> Self {
        self.scene.bodies.push(body);
        self
    }

    /// One more force.
    pub fn force(mut self, force: Force) -> Self {
        self.scene.forces.push(force);
        self
    }

    /// One more rule for a pair of materials.
    pub fn pair_rule(mut self, rule: PairRule) -> Self {
        self.scene.pair_rules.push(rule);
        self
    }

    /// Bodies (by number, in the order added) that do not collide with each other.
    pub fn no_contact(mut self, bodies: Vec<usize>) -> Self {
        self.scene.no_contact.push(bodies);
        self
    }

    /// The scene.
    ///
    /// # Errors
    /// When a number is out of range, a name is empty or used twice, or something not yet available is asked for.
    /// Overlap at the start is found when a simulation is made.
    pub fn build(self) -> Result<Scene, SceneError> {
        let scene = self.scene;
        positive("duration", scene.duration_s)?;
        positive("output.interval", scene.output_interval_s)?;
        if !scene.gravity.is_finite() {
            return Err(SceneError::Number {
                key: "gravity",
                value: scene.gravity.length(),
                accepted: "three finite numbers",
            });
        }
        scene.method.validate()?;
        check_counts(&scene)?;
        let mut names = BTreeSet::new();
        for (number, body) in scene.bodies.iter().enumerate() {
            check_body(number, body)?;
            if !names.insert(body.name.as_str()) {
                return Err(SceneError::DuplicateName(body.name.clone()));
            }
        }
        if let Some(&unknown) = scene.no_contact.iter().flatten().find(|&&index| index >= scene.bodies.len()) {
            return Err(SceneError::UnknownBody(unknown));
        }
        for (number, force) in scene.forces.iter().enumerate() {
            force::check(number, force, &scene.bodies)?;
        }
        force::check_integrator(scene.method.integrator, &scene.forces)?;
        Ok(scene)
    }
}

/// A run must end: neither samples nor steps may be more than can be counted down in a lifetime.
pub(super) fn check_counts(scene: &Scene) -> Result<(), SceneError> {
    let too_many = |interval: f64| scene.duration_s / interval > MOST_STEPS;
    if too_many(scene.output_interval_s) {
        let (key, accepted) = ("output.interval", "at least duration / 1e12");
        return Err(SceneError::Number { key, value: scene.output_interval_s, accepted });
    }
    if let Some(value) = scene.method.step_s.filter(|&step| too_many(step)) {
        let (key, accepted) = ("method.step", "at least duration / 1e12");
        return Err(SceneError::Number { key, value, accepted });
    }
    Ok(())
}

pub(super) fn check_body(number: usize, body: &Body) -> Result<(), SceneError> {
    if body.name.is_empty() {
        return Err(SceneError::EmptyName(number));
    }
    let not_finite = |quantity| Err(SceneError::NotFinite { body: body.name.clone(), quantity });
    if !body.pose.is_finite() {
        return not_finite("its pose");
    }
    if !body.velocity.is_finite() {
        return not_finite("its velocity");
    }
    if let Some(motion) = body.motion() {
        return check_kinematic(body, motion);
    }
    if let Some(pivot) = body.pivot {
        check_pivot(body, pivot)?;
    }
    if body.is_fixed() && !body.velocity.is_zero() {
        return Err(SceneError::FixedBodyMoves(body.name.clone()));
    }
    match &body.geometry {
        Some(Geometry::Shape(Shape::HalfSpace(_))) if !body.is_fixed() => {
            Err(SceneError::MovingHalfSpace(body.name.clone()))
        }
        Some(Geometry::Shape(Shape::TriangleMesh(_))) if !body.is_fixed() => {
            Err(SceneError::MovingSurface(body.name.clone()))
        }
        _ => Ok(()),
    }
}

/// A kinematic body has no velocity or pivot of its own, and starts where its motion does.
fn check_kinematic(body: &Body, motion: &PrescribedMotion) -> Result<(), SceneError> {
    if body.pivot.is_some() {
        return Err(SceneError::KinematicBodyPivots(body.name.clone()));
    }
    if !body.velocity.is_zero() {
        return Err(SceneError::KinematicBodyHasVelocity(body.name.clone()));
    }
    motion.check_start(&body.pose).map_err(|source| SceneError::Motion { body: body.name.clone(), source })
}

/// A pivoted body moves about a point that stays: a velocity of its centre of mass, when it is given, must be that of
/// the rotation.
fn check_pivot(body: &Body, pivot: DVec3) -> Result<(), SceneError> {
    if !pivot.is_finite() {
        return Err(SceneError::NotFinite { body: body.name.clone(), quantity: "its pivot" });
    }
    let Some(properties) = body.mass_properties() else { return Err(SceneError::FixedBodyPivots(body.name.clone())) };
    let arm = body.pose.transform_point(properties.center_of_mass()) - pivot;
    let turning = body.velocity.angular.cross(arm);
    let difference = (body.velocity.linear - turning).length();
    if body.velocity.linear != DVec3::ZERO
        && difference > PIVOT_VELOCITY_RELATIVE * body.velocity.angular.length() * arm.length()
    {
        let needed = turning.to_array();
        return Err(SceneError::PivotMoves { body: body.name.clone(), difference, needed });
    }
    Ok(())
}

/// `value` when it is positive and finite.
pub(super) fn positive(key: &'static str, value: f64) -> Result<f64, SceneError> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(SceneError::Number { key, value, accepted: "a positive number" })
    }
}
