//! Collects the parts of a scene, and checks what needs no tier; `tier/scene_checks.rs` builds it.

use super::error::positive;
use super::{
    Body, Coordinate, CoordinateMotion, DEFAULT_GRAVITY, Force, Gear, GearEnd, Joint, Method, PairRule, Scene,
    SceneError, TrackId, force,
};
use crate::identity::body_id::BodyId;
use crate::identity::joint_id::JointId;
use polhode_spatial::DVec3;
use polhode_spatial::curve::Curve;
use std::collections::BTreeSet;
use std::sync::Arc;

/// Simulated time when none is given, s.
const DEFAULT_DURATION_S: f64 = 1.0;

/// Time between samples when none is given, s.
const DEFAULT_OUTPUT_INTERVAL_S: f64 = 0.01;

/// Collects the parts of a scene; [`SceneBuilder::build`] checks them together.
#[derive(Debug, Clone)]
pub struct SceneBuilder {
    scene: Scene,
}

impl Scene {
    /// Starts a scene: gravity [`DEFAULT_GRAVITY`], no bodies, method chosen by the plan.
    pub fn builder(name: impl Into<String>) -> SceneBuilder {
        SceneBuilder::new(name.into())
    }
}

impl SceneBuilder {
    fn new(name: String) -> Self {
        Self {
            scene: Scene {
                name,
                duration_s: DEFAULT_DURATION_S,
                output_interval_s: DEFAULT_OUTPUT_INTERVAL_S,
                gravity: DEFAULT_GRAVITY,
                method: Method::default(),
                bodies: Vec::new(),
                forces: Vec::new(),
                joints: Vec::new(),
                tracks: Vec::new(),
                gears: Vec::new(),
                coordinate_motions: Vec::new(),
                pair_rules: Vec::new(),
                no_contact: Vec::new(),
                start_separation_m: 0.0,
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

    /// One more body. [`SceneBuilder::add_body`] returns its handle.
    pub fn body(mut self, body: Body) -> Self {
        self.scene.bodies.push(body);
        self
    }

    /// Adds a body and returns its handle, for joints, forces and [`SceneBuilder::no_contact`].
    pub fn add_body(&mut self, body: Body) -> BodyId {
        self.scene.bodies.push(body);
        BodyId::new(self.scene.bodies.len() - 1)
    }

    /// One more force.
    pub fn force(mut self, force: Force) -> Self {
        self.scene.forces.push(force);
        self
    }

    /// One more joint.
    pub fn joint(mut self, joint: Joint) -> Self {
        self.scene.joints.push(joint);
        self
    }

    /// Adds a joint and returns its handle, for what a program asks of it or does to it.
    pub fn add_joint(&mut self, joint: Joint) -> JointId {
        self.scene.joints.push(joint);
        JointId::new(self.scene.joints.len() - 1)
    }

    /// Adds a track, a curve of the world at the start, and returns its handle, for
    /// [`JointKind::Track`](super::JointKind::Track).
    pub fn add_track(&mut self, curve: Curve) -> TrackId {
        self.scene.tracks.push(Arc::new(curve));
        TrackId::new(self.scene.tracks.len() - 1)
    }

    /// One more gear between two joints.
    pub fn gear(mut self, gear: Gear) -> Self {
        self.scene.gears.push(gear);
        self
    }

    /// A coordinate of a joint follows a motion, whatever acts on its bodies ([`CoordinateMotion`]).
    pub fn coordinate_motion(mut self, joint: JointId, coordinate: Coordinate, motion: CoordinateMotion) -> Self {
        self.scene.coordinate_motions.push((GearEnd { joint, coordinate: Some(coordinate) }, motion));
        self
    }

    /// One more rule for a pair of materials.
    pub fn pair_rule(mut self, rule: PairRule) -> Self {
        self.scene.pair_rules.push(rule);
        self
    }

    /// Bodies that do not collide with each other.
    pub fn no_contact(mut self, bodies: impl IntoIterator<Item = BodyId>) -> Self {
        self.scene.no_contact.push(bodies.into_iter().map(BodyId::index).collect());
        self
    }

    /// Overlap of bodies at the start that is removed by moving them apart, at most, m: 0, the default, allows none.
    pub fn start_separation_m(mut self, limit_m: f64) -> Self {
        self.scene.start_separation_m = limit_m;
        self
    }

    /// The builder that has collected these parts.
    pub(super) const fn of(scene: Scene) -> Self {
        Self { scene }
    }

    /// The parts as they were given, unchecked.
    pub(crate) fn parts(self) -> Scene {
        self.scene
    }
}

impl Scene {
    /// Checks the numbers of the scene itself.
    ///
    /// # Errors
    /// When one is out of range.
    pub(crate) fn check_numbers(&self) -> Result<(), SceneError> {
        positive("duration", self.duration_s)?;
        positive("output.interval", self.output_interval_s)?;
        let separation_m = self.start_separation_m;
        if !(separation_m >= 0.0 && separation_m.is_finite()) {
            let accepted = "a finite number of at least 0";
            return Err(SceneError::Number { key: "start.separate", value: separation_m, accepted });
        }
        if !self.gravity.is_finite() {
            return Err(SceneError::Number {
                key: "gravity",
                value: self.gravity.length(),
                accepted: "three finite numbers",
            });
        }
        Ok(())
    }

    /// Checks each body and each force, and that the bodies that are named exist.
    ///
    /// # Errors
    /// With the first that is refused.
    pub(crate) fn check_parts(&self) -> Result<(), SceneError> {
        let mut names = BTreeSet::new();
        for (number, body) in self.bodies.iter().enumerate() {
            body.check(number)?;
            if !names.insert(body.name.as_str()) {
                return Err(SceneError::DuplicateName(body.name.clone()));
            }
        }
        if let Some(&unknown) = self.no_contact.iter().flatten().find(|&&index| index >= self.bodies.len()) {
            return Err(SceneError::UnknownBody(unknown));
        }
        for (number, force) in self.forces.iter().enumerate() {
            force::check(number, force, &self.bodies)?;
        }
        force::check_integrator(self.method.integrator, &self.forces)
    }
}
