//! The plan: which effects are simulated, by which methods, and why.
//!
//! A plan is derived from the scene, and every decision about a run is in it. For every [`Effect`] it holds whether the
//! effect is simulated, the measured fact that decides it, and what the decision saves. Leaving out an absent effect,
//! or skipping bodies at rest, gives the same bits as simulating all effects ([`Effects::All`]). A reduction gives the
//! same motion to 1e-12 over a second: planar motion instead of motion in space, or rotation about a pivot alone
//! instead of constraint rows that hold the body there.

use crate::constraint::joint::ModelJoint;
use crate::model::Model;
use crate::plan::free_method::Choice;
use crate::plan::planar::PlanarFinding;
pub use crate::scene::effects::Effects;
use crate::scene::{
    Body, BroadPhaseMethod, ContactMethod, Coordinate, Coordinates, ImpactLaw, Integrator, Joint, Promise, Response,
    Scene, Tier,
};
use crate::snapshot::{SnapshotError, content};
use crate::tier::settings::Settings;
use polhode_spatial::{DVec3, DisjointSets};

/// An effect that the plan may leave out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Effect {
    /// Uniform gravity.
    Gravity,
    /// Free rotation of bodies whose principal moments differ; the others turn about fixed axes.
    GeneralRotation,
    /// Spin about a principal axis at a constant rate.
    SteadyRotation,
    /// Motion of all bodies parallel to one plane: three velocity components a body, and one contact of each mirror
    /// pair.
    PlanarMotion,
    /// Free flight, under gravity alone, in closed form.
    BallisticFlight,
    /// Contact between bodies.
    Contact,
    /// Impacts with a coefficient of restitution above zero.
    Restitution,
    /// Islands at rest, which are skipped until an event.
    Rest,
    /// Friction.
    Friction,
    /// Joints.
    Joints,
    /// Drag and other force fields.
    ForceFields,
}

impl Effect {
    /// The name used in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Gravity => "gravity",
            Self::GeneralRotation => "general rotation",
            Self::SteadyRotation => "steady rotation",
            Self::PlanarMotion => "planar motion",
            Self::BallisticFlight => "ballistic flight",
            Self::Contact => "contact",
            Self::Restitution => "restitution",
            Self::Rest => "rest",
            Self::Friction => "friction",
            Self::Joints => "joints",
            Self::ForceFields => "force fields",
        }
    }
}

/// Whether an effect is simulated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Decision {
    /// The effect is simulated, or the reduction is used.
    On,
    /// The effect is left out, or the reduction is not used.
    Off,
}

/// The decision about one effect.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct EffectDecision {
    /// The effect.
    pub effect: Effect,
    /// Whether it is on.
    pub decision: Decision,
    /// The measured fact that decides it.
    pub fact: String,
    /// What the decision saves, or costs.
    pub saves: String,
}

/// Methods and effects of a run, with the reasons for them.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Plan {
    /// The tier.
    pub tier: Tier,
    /// Why this tier.
    pub tier_reason: String,
    /// Integrator of bodies without active contacts.
    pub integrator: Integrator,
    /// Why this integrator.
    pub integrator_reason: String,
    /// Impact law.
    pub impact: ImpactLaw,
    /// Method of contact forces.
    pub contact: ContactMethod,
    /// How bodies that touch act on each other.
    pub response: Response,
    /// Broad phase: how pairs that may touch are found.
    pub broad_phase: BroadPhaseMethod,
    /// Step, s: fixed in the tiers `thesis` and `stepped`, an upper bound in tier `accurate`.
    pub step_s: f64,
    /// Local error per step of constrained motion (dimensionless).
    pub tolerance: f64,
    /// What the run promises.
    pub promise: Promise,
    /// Largest number of events in one step.
    pub max_events_per_step: u64,
    /// One decision per effect.
    pub effects: Vec<EffectDecision>,
}

impl Plan {
    /// Derives the plan of a scene from settings and findings.
    pub(crate) fn derive(model: &Model, settings: &Settings, effects: Effects, findings: &Findings) -> Self {
        Self {
            tier: settings.tier,
            tier_reason: findings.tier_reason.clone(),
            integrator: settings.integrator,
            integrator_reason: findings.choice.reason.clone(),
            impact: settings.impact,
            contact: settings.contact,
            response: settings.response,
            broad_phase: settings.broad_phase,
            step_s: settings.step_s,
            tolerance: settings.tolerance,
            promise: settings.promise,
            max_events_per_step: settings.max_events_per_step,
            effects: decisions(model, settings, effects, findings),
        }
    }
}

impl Plan {
    /// The same plan with another decision about planar motion.
    pub(crate) fn with_planar(&self, found: &PlanarFinding) -> Self {
        let planar = planar_decision(found);
        let effects = self.effects.iter().map(|own| if own.effect == planar.effect { &planar } else { own });
        Self { effects: effects.cloned().collect(), ..self.clone() }
    }

    /// The decisions that differ from an earlier plan, in words.
    pub(crate) fn changes_from(&self, before: &Self) -> Vec<String> {
        let mut changes = Vec::new();
        if self.integrator != before.integrator {
            let (old, new) = (before.integrator.name(), self.integrator.name());
            changes.push(format!("integrator {new} instead of {old}: {}", self.integrator_reason));
        }
        for (now, then) in self.effects.iter().zip(&before.effects) {
            if now.decision != then.decision {
                let on = if now.decision == Decision::On { "on" } else { "off" };
                changes.push(format!("{} {on}: {}", now.effect.name(), now.fact));
            }
        }
        changes
    }

    /// The plan as a snapshot holds it; none when it is still the plan of the start.
    pub(crate) fn save(&self, at_start: &Self) -> Option<content::Plan> {
        let effect = |effect: &EffectDecision| content::EffectDecision {
            is_on: effect.decision == Decision::On,
            fact: effect.fact.clone(),
            saves: effect.saves.clone(),
        };
        (self != at_start).then(|| content::Plan {
            integrator_reason: self.integrator_reason.clone(),
            effects: self.effects.iter().map(effect).collect(),
        })
    }

    /// The plan of a snapshot, with this integrator; `self` is the plan of the start.
    ///
    /// # Errors
    /// When the snapshot does not decide about the same effects.
    pub(crate) fn restored(
        &self,
        saved: Option<&content::Plan>,
        integrator: Integrator,
    ) -> Result<Self, SnapshotError> {
        let Some(saved) = saved else { return Ok(self.clone()) };
        if saved.effects.len() != self.effects.len() {
            return Err(SnapshotError::Invalid("its plan does not have one decision for each effect"));
        }
        let both = self.effects.iter().zip(&saved.effects);
        let effects = both.map(|(own, saved)| decision(own.effect, saved.is_on, saved.fact.clone(), &saved.saves));
        let integrator_reason = saved.integrator_reason.clone();
        Ok(Self { integrator, integrator_reason, effects: effects.collect(), ..self.clone() })
    }
}

/// What has been measured of a scene, from which the plan is derived.
#[derive(Debug, Clone)]
pub(crate) struct Findings {
    /// Time of the measurements, s.
    pub(crate) t_s: f64,
    pub(crate) touching_pairs: usize,
    /// Why the tier of the settings was taken.
    pub(crate) tier_reason: String,
    pub(crate) choice: Choice,
    pub(crate) planar: PlanarFinding,
}

/// One decision per effect.
fn decisions(model: &Model, settings: &Settings, effects: Effects, findings: &Findings) -> Vec<EffectDecision> {
    let mut list = motion_decisions(model, settings, findings);
    list.extend(contact_decisions(model, effects, findings));
    list.push(friction_decision(&model.scene));
    list.push(joint_decision(model));
    let loaded = model.loaded_count();
    let pivots = present(model).filter(|(_, body)| body.pivot_point().is_some()).count();
    list.push(decision(
        Effect::ForceFields,
        loaded > 0,
        format!("{} force fields and {pivots} pivots, acting on {loaded} bodies", model.free_motion().fields().len()),
        if loaded > 0 { "nothing: fields are evaluated at every stage" } else { "all evaluations of fields" },
    ));
    list
}

/// The bodies of the scene that have not been removed, with their indices.
fn present(model: &Model) -> impl Iterator<Item = (usize, &Body)> {
    model.scene.bodies().iter().enumerate().filter(|&(body, _)| !model.bodies[body].removed)
}

/// What constraint rows save.
const SOLVED: &str = "nothing: their forces are solved for at every stage, with those of contacts";

const REDUCED: &str =
    "constraint rows, their reactions and projections; the same motion to 1e-11 while it is not chaotic";

/// Whether joints close a loop: one connects bodies, or a body and the world, that others connect already.
fn has_loop(model: &Model) -> bool {
    // The world is one more body.
    let ground = model.bodies.len();
    let mut sets = DisjointSets::new(ground + 1);
    // A rope has no row: it closes nothing.
    model.joints.list.iter().filter(|joint| joint.rows() > 0).any(|joint| {
        let mut ends = joint.bodies().chain([ground]);
        let (a, b) = (ends.next().unwrap_or(ground), ends.next().unwrap_or(ground));
        let closes = sets.smallest(a) == sets.smallest(b);
        sets.join(a, b);
        closes
    })
}

/// The decision about joints. Constraint rows hold those of the scene, and pivots, unless the motion is reduced to
/// rotation about them.
fn joint_decision(model: &Model) -> EffectDecision {
    if !model.joints.list.is_empty() {
        let rows: usize = model.joints.list.iter().map(ModelJoint::rows).sum();
        let form = if has_loop(model) { "some of them close loops" } else { "none of them closes a loop" };
        let stops: usize = model.joints.list.iter().map(ModelJoint::stops).sum();
        let limits = if stops > 0 { format!(", {stops} limits") } else { String::new() };
        let tracks = model.joints.list.iter().filter(|joint| joint.is_on_track()).count();
        let tracks = if tracks > 0 { format!(", {tracks} of them on tracks") } else { String::new() };
        let fact = format!("{} joints with {rows} constraint rows{limits}{tracks}, {form}", model.joints.list.len());
        if model.scene.method().coordinates == Some(Coordinates::Reduced) {
            let bodies = model.joints.held_by_rows.len();
            let fact = format!("{fact}; {bodies} bodies in the coordinates of joints (method.coordinates)");
            return decision(Effect::Joints, true, fact, REDUCED);
        }
        return decision(Effect::Joints, true, fact, SOLVED);
    }
    let pivots = present(model).filter(|(_, body)| body.pivot_point().is_some()).count();
    let rows = model.joints.held_by_rows.len();
    let (fact, saves) = match (pivots, rows) {
        (0, _) => ("the scene has no joints and no pivots".to_owned(), "all work on joints"),
        (_, 0) => (
            format!("the motion of {pivots} bodies is reduced to rotation about their pivots"),
            "three constraint rows a pivot and their projection; the same motion to 1e-12 over a second",
        ),
        _ if rows == pivots => (format!("three constraint rows hold each of {pivots} bodies at its pivot"), SOLVED),
        _ => (
            format!(
                "three constraint rows hold each of {rows} of {pivots} bodies at its pivot; the motion of the others \
                 is reduced to rotation about their pivots"
            ),
            SOLVED,
        ),
    };
    decision(Effect::Joints, rows > 0, fact, saves)
}

/// Effects of motion between contacts.
fn motion_decisions(model: &Model, settings: &Settings, findings: &Findings) -> Vec<EffectDecision> {
    let (gravity, planar) = (model.gravity(), &findings.planar);
    let movable = model.bodies.iter().filter(|body| body.moves()).count();
    let flying = if settings.flies() { movable - model.loaded_count() } else { 0 };
    vec![
        decision(
            Effect::Gravity,
            gravity != DVec3::ZERO,
            format!("g = ({}, {}, {}) m/s^2", gravity.x, gravity.y, gravity.z),
            "nothing: gravity is part of the closed form of free flight",
        ),
        rotation_decision(model),
        steady_decision(model),
        planar_decision(planar),
        decision(
            Effect::BallisticFlight,
            flying > 0,
            format!("{flying} of {movable} movable bodies are under gravity alone between contacts"),
            "all steps of a free flight: one evaluation, without an error of integration",
        ),
    ]
}

fn planar_decision(found: &PlanarFinding) -> EffectDecision {
    let is_on = found.planar.plane().is_some();
    let saves = if is_on {
        "three of six velocity components a body, and one of every two mirrored contacts"
    } else {
        "nothing"
    };
    decision(Effect::PlanarMotion, is_on, found.fact.clone(), saves)
}

/// Effects of contact: of shapes, and of joints at their limits.
fn contact_decisions(model: &Model, effects: Effects, findings: &Findings) -> Vec<EffectDecision> {
    let pairs = model.scene.colliding();
    let limits: usize = model.joints.list.iter().map(ModelJoint::stops).sum();
    let meets = pairs.count > 0 || limits > 0;
    let restitution = pairs.largest_restitution.max(model.joints.largest_restitution_of_stops());
    let rest = match effects {
        Effects::Planned => decision(
            Effect::Rest,
            meets,
            "islands at zero velocity whose contact forces certify equilibrium are skipped until an event".to_owned(),
            "all work on resting islands; the same bits as without",
        ),
        Effects::All => decision(
            Effect::Rest,
            false,
            "the run simulates all effects: contacts and forces of resting islands are computed at every step"
                .to_owned(),
            "nothing",
        ),
    };
    let of_joints = if limits > 0 { format!(", joints have {limits} limits") } else { String::new() };
    let touching = findings.touching_pairs;
    let fact = format!("{} pairs may collide, {touching} touch at t = {}{of_joints}", pairs.count, findings.t_s);
    vec![
        decision(
            Effect::Contact,
            meets,
            fact,
            match (pairs.count, limits) {
                (0, 0) => "all collision detection",
                (0, _) => "all collision detection of shapes",
                _ => "nothing: bodies near each other are searched for contacts, at every step of those that move",
            },
        ),
        decision(
            Effect::Restitution,
            restitution > 0.0,
            format!("largest coefficient of restitution of a pair: {restitution}"),
            if restitution > 0.0 { "nothing" } else { "the phase of restitution of every impact" },
        ),
        rest,
    ]
}

/// The decision about friction.
fn friction_decision(scene: &Scene) -> EffectDecision {
    let colliding = scene.colliding();
    let largest = colliding.largest_friction;
    let of_joint = |joint: &Joint| {
        let is_rough =
            |&&coordinate: &&Coordinate| joint.freedom(coordinate).is_some_and(|own| own.friction().is_some());
        joint.kind().coordinates().iter().filter(is_rough).count()
    };
    let at_joints: usize = scene.joints().iter().map(of_joint).sum();
    let joints = match at_joints {
        0 => String::new(),
        1 => ", dry friction at 1 coordinate of a joint".to_owned(),
        many => format!(", dry friction at {many} coordinates of joints"),
    };
    if colliding.have_friction() {
        let rotational = colliding.largest_rotational_friction;
        let moments = if rotational > 0.0 {
            format!(", largest friction of rolling or spinning: {rotational} m")
        } else {
            String::new()
        };
        let grain = if scene.has_grain() { ", different along a grain and across it" } else { "" };
        let surfaces = if scene.has_moving_surfaces() { ", with surfaces that move" } else { "" };
        let fact =
            format!("largest coefficient of static friction of a pair: {largest}{moments}{grain}{surfaces}{joints}");
        return decision(Effect::Friction, true, fact, "nothing: contacts stick or slide, by exact cones");
    }
    let (on, saves) = match at_joints {
        0 => (false, "all work on friction"),
        _ => (true, "nothing: joints stick or slip, as contacts do"),
    };
    decision(Effect::Friction, on, format!("every pair has friction 0{joints}"), saves)
}

fn decision(effect: Effect, on: bool, fact: String, saves: &str) -> EffectDecision {
    let decision = if on { Decision::On } else { Decision::Off };
    EffectDecision { effect, decision, fact, saves: saves.to_owned() }
}

/// The decision about general rotation: it is left out when the three principal moments of every body are equal.
fn rotation_decision(model: &Model) -> EffectDecision {
    let mut general = 0;
    let mut spherical = 0;
    for properties in present(model).filter_map(|(_, body)| body.mass_properties()) {
        let moments = properties.principal_axes().moments();
        if moments.x == moments.z { spherical += 1 } else { general += 1 }
    }
    decision(
        Effect::GeneralRotation,
        general > 0,
        format!("{general} bodies with different principal moments, {spherical} with equal ones"),
        if general > 0 {
            "nothing; only bodies with equal moments or a spin about a principal axis need no elliptic functions"
        } else {
            "elliptic functions: every rotation is about a fixed axis"
        },
    )
}

/// The decision about steady rotation: a body that spins about a principal axis without torque keeps axis and rate.
fn steady_decision(model: &Model) -> EffectDecision {
    let (mut steady, mut turning) = (0, 0);
    let mut off_axis = 0.0f64;
    for (body, entry) in present(model) {
        let Some(rigid) = &model.bodies[body].rigid else { continue };
        let pose = entry.initial_pose();
        let w = entry.initial_velocity().angular;
        if w == DVec3::ZERO || model.is_loaded(body) {
            continue;
        }
        turning += 1;
        let momentum = rigid.angular_momentum_at(pose.rotation, w);
        let defect = momentum.cross(w).length() / (momentum.length() * w.length());
        off_axis = off_axis.max(defect);
        steady += usize::from(defect == 0.0);
    }
    decision(
        Effect::SteadyRotation,
        steady > 0,
        format!(
            "{steady} of {turning} bodies that spin without torque do so about a principal axis (largest sine of the \
             angle between spin and angular momentum {off_axis:.1e}, limit 0)"
        ),
        if steady > 0 { "elliptic functions: the rotation is about a fixed axis" } else { "nothing" },
    )
}
