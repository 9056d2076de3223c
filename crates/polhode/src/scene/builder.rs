//! Builds a scene from its parts and checks them together.

use super::error::positive;
use super::laws::ImpactLaw;
use super::{
    Body, Coordinate, CoordinateMotion, DEFAULT_GRAVITY, Force, Gear, GearEnd, Joint, Method, PairRule, Response,
    Scene, SceneError, Tier, TierFeature, TrackId, force,
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

    /// The scene.
    ///
    /// # Errors
    /// When a number is out of range, a name is empty or used twice, a body that does not exist is named, or the scene
    /// asks for something that is not yet available. Bodies that overlap are found later, by
    /// [`Simulation::new`](crate::Simulation::new).
    pub fn build(self) -> Result<Scene, SceneError> {
        let mut scene = self.scene;
        positive("duration", scene.duration_s)?;
        positive("output.interval", scene.output_interval_s)?;
        let separation_m = scene.start_separation_m;
        if !(separation_m >= 0.0 && separation_m.is_finite()) {
            let accepted = "a finite number of at least 0";
            return Err(SceneError::Number { key: "start.separate", value: separation_m, accepted });
        }
        if !scene.gravity.is_finite() {
            return Err(SceneError::Number {
                key: "gravity",
                value: scene.gravity.length(),
                accepted: "three finite numbers",
            });
        }
        scene.method.validate()?;
        scene.check_counts()?;
        let mut names = BTreeSet::new();
        for (number, body) in scene.bodies.iter().enumerate() {
            body.check(number)?;
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
        scene.place_on_tracks()?;
        scene.check_joints()?;
        scene.check_ties()?;
        scene.check_joint_method()?;
        scene.check_coordinates()?;
        scene.check_grains()?;
        scene.check_motions()?;
        let tier = scene.method.named_tier().unwrap_or_default().facts();
        if !tier.takes(TierFeature::Friction) && scene.colliding().have_friction() {
            let instead = Tier::names_with(TierFeature::Friction);
            return Err(SceneError::FrictionInTier { tier: tier.name, instead });
        }
        if scene.method.impact == Some(ImpactLaw::Pulse) && scene.colliding().largest_rotational_friction > 0.0 {
            let what = "impact = \"pulse\" where contacts resist rolling or spinning".to_owned();
            let instead = "rolling_friction = 0 and spinning_friction = 0, or impact = \"energetic\", \"poisson\" or \
                \"reflection\""
                .to_owned();
            return Err(SceneError::NotYetAvailable { what, instead });
        }
        if let (false, Some(effect)) = (tier.takes(TierFeature::SurfaceEffects), scene.surface_effect())
            && tier.takes(TierFeature::Friction)
        {
            let instead = format!("tier {}", Tier::names_with(TierFeature::SurfaceEffects));
            return Err(SceneError::NotYetAvailable {
                what: format!("{effect} with tier = \"{}\"", tier.name),
                instead,
            });
        }
        if tier.own_response == Some(Response::Penalty) {
            scene.check_springs()?;
        }
        Ok(scene)
    }
}
