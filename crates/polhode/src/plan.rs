//! The plan: which effects a scene calls for, and why.
//!
//! A plan is derived from the scene and printed; it decides nothing in secret. For every [`Effect`] it holds whether it
//! is simulated, the measured fact that decides it and what leaving it out saves. Leaving out an absent effect or
//! skipping rest gives the same bits as simulating everything (`Effects::All`); a reduction (a plane instead of space,
//! turning alone instead of a body that rows hold at its pivot) gives the same motion to 1e-12 over a second.

pub use crate::effects::Effects;
use crate::free_method::Choice;
use crate::planar::PlanarFinding;
use crate::scene::{Body, BroadPhaseMethod, ContactMethod, ImpactLaw, Integrator, Scene, Tier};
use crate::settings::Settings;
use crate::snapshot::{SnapshotError, content};
use crate::world::World;
use polhode_spatial::DVec3;

/// An effect that a scene may or may not call for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effect {
    /// Uniform gravity.
    Gravity,
    /// Rotation with three different principal moments (otherwise: spherical inertia or steady axes).
    GeneralRotation,
    /// Spin about a principal axis, at one rate.
    SteadyRotation,
    /// Motion in one plane: three velocities a body, one contact of each mirror pair.
    PlanarMotion,
    /// Flights in closed form, with no force but gravity.
    BallisticFlight,
    /// Contact between bodies.
    Contact,
    /// Restitution above zero.
    Restitution,
    /// Islands in certified equilibrium are skipped until an event.
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
    /// Simulated, or used.
    On,
    /// Left out.
    Off,
}

/// The decision about one effect.
#[derive(Debug, Clone, PartialEq)]
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

/// Methods and effects of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// The tier.
    pub tier: Tier,
    /// Why this tier.
    pub tier_reason: String,
    /// Integrator of bodies that no contact holds.
    pub integrator: Integrator,
    /// Why this integrator.
    pub integrator_reason: String,
    /// Impact law.
    pub impact: ImpactLaw,
    /// Method of contact forces.
    pub contact: ContactMethod,
    /// How pairs that may touch are found.
    pub broad_phase: BroadPhaseMethod,
    /// Step, s: fixed in the tiers `thesis` and `stepped`, an upper bound in tier `accurate`.
    pub step_s: f64,
    /// Local error per step of contact phases (dimensionless).
    pub tolerance: f64,
    /// Largest number of events in one step.
    pub max_events_per_step: u64,
    /// One decision per effect.
    pub effects: Vec<EffectDecision>,
}

impl Plan {
    /// The plan for a scene: what it calls for, and why.
    pub(crate) fn derive(world: &World, settings: &Settings, effects: Effects, findings: &Findings) -> Self {
        let scene = &world.scene;
        let tier_reason = match (scene.method().tier, settings.tier) {
            (Some(_), _) => "asked for".to_owned(),
            (None, _) => "the default: located events and exact contact forces".to_owned(),
        };
        Self {
            tier: settings.tier,
            tier_reason,
            integrator: settings.integrator,
            integrator_reason: findings.choice.reason.clone(),
            impact: settings.impact,
            contact: settings.contact,
            broad_phase: settings.broad_phase,
            step_s: settings.step_s,
            tolerance: settings.tolerance,
            max_events_per_step: settings.max_events_per_step,
            effects: decisions(world, settings, effects, findings),
        }
    }
}

impl Plan {
    /// What is decided otherwise than in a plan before, in words.
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

    /// What a snapshot keeps of the plan: nothing where it is the one of the start.
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

    /// The plan of a snapshot with this integrator; `self` is that of the start.
    ///
    /// # Errors
    /// When it does not decide about the same effects.
    pub(crate) fn restored(
        &self,
        saved: Option<&content::Plan>,
        integrator: Integrator,
    ) -> Result<Self, SnapshotError> {
        let Some(saved) = saved else { return Ok(self.clone()) };
        if saved.effects.len() != self.effects.len() {
            return Err(SnapshotError::Invalid("its plan does not decide about the effects that there are"));
        }
        let both = self.effects.iter().zip(&saved.effects);
        let effects = both.map(|(own, saved)| decision(own.effect, saved.is_on, saved.fact.clone(), &saved.saves));
        let integrator_reason = saved.integrator_reason.clone();
        Ok(Self { integrator, integrator_reason, effects: effects.collect(), ..self.clone() })
    }
}

/// What was found out about a scene before its plan.
#[derive(Debug, Clone)]
pub(crate) struct Findings {
    /// When, s.
    pub(crate) t_s: f64,
    pub(crate) touching_pairs: usize,
    pub(crate) choice: Choice,
    pub(crate) planar: PlanarFinding,
}

/// One decision per effect.
fn decisions(world: &World, settings: &Settings, effects: Effects, findings: &Findings) -> Vec<EffectDecision> {
    let mut list = motion_decisions(world, settings, findings);
    list.extend(contact_decisions(&world.scene, effects, findings));
    list.push(decision(Effect::Friction, false, "every pair has friction 0".to_owned(), "everything about it"));
    list.push(joint_decision(world));
    let loaded = world.loaded_count();
    let pivots = present(world).filter(|(_, body)| body.pivot_point().is_some()).count();
    list.push(decision(
        Effect::ForceFields,
        loaded > 0,
        format!("{} force fields and {pivots} pivots, acting on {loaded} bodies", world.free_motion().fields().len()),
        if loaded > 0 { "nothing: evaluated at every stage" } else { "everything about it" },
    ));
    list
}

/// The bodies of the scene that have not been removed, with their numbers.
fn present(world: &World) -> impl Iterator<Item = (usize, &Body)> {
    world.scene.bodies().iter().enumerate().filter(|&(body, _)| !world.bodies[body].removed)
}

/// Pivots are the joints that there are: held by rows, or solved once and for all.
fn joint_decision(world: &World) -> EffectDecision {
    let pivots = present(world).filter(|(_, body)| body.pivot_point().is_some()).count();
    let rows = world.held_by_rows.len();
    let (fact, saves) = match (pivots, rows) {
        (0, _) => ("the scene has none".to_owned(), "everything about it"),
        (_, 0) => (
            format!("of {pivots} bodies at pivots turning alone is left: no row holds them"),
            "three rows a pivot and their projection; agrees with them to 1e-12 over a second",
        ),
        _ if rows == pivots => (
            format!("three rows hold each of {pivots} bodies at pivots"),
            "nothing: their forces are solved for at every stage, with those of contacts",
        ),
        _ => (
            format!("three rows hold each of {rows} of {pivots} bodies at pivots; of the others turning alone is left"),
            "nothing: their forces are solved for at every stage, with those of contacts",
        ),
    };
    decision(Effect::Joints, rows > 0, fact, saves)
}

/// Effects of motion between contacts.
fn motion_decisions(world: &World, settings: &Settings, findings: &Findings) -> Vec<EffectDecision> {
    let (gravity, planar) = (world.gravity(), &findings.planar);
    let movable = world.bodies.iter().filter(|body| body.moves()).count();
    let flying = if settings.flies() { movable - world.loaded_count() } else { 0 };
    vec![
        decision(
            Effect::Gravity,
            gravity != DVec3::ZERO,
            format!("g = ({}, {}, {}) m/s^2", gravity.x, gravity.y, gravity.z),
            "nothing: it is part of the closed form of flight",
        ),
        rotation_decision(world),
        steady_decision(world),
        decision(
            Effect::PlanarMotion,
            planar.plane.is_some(),
            planar.fact.clone(),
            if planar.plane.is_some() {
                "three of six velocities, and one of every two mirrored contacts"
            } else {
                "nothing"
            },
        ),
        decision(
            Effect::BallisticFlight,
            flying > 0,
            format!("{flying} of {movable} movable bodies are under no force but gravity between contacts"),
            "one evaluation per flight, whatever its length; no error from the step",
        ),
    ]
}

/// Effects of contact.
fn contact_decisions(scene: &Scene, effects: Effects, findings: &Findings) -> Vec<EffectDecision> {
    let pairs = scene.colliding();
    let rest = match effects {
        Effects::Planned => decision(
            Effect::Rest,
            pairs.count > 0,
            "groups whose forces certify equilibrium at zero velocity are skipped until an event".to_owned(),
            "all work on resting groups; the same bits as without",
        ),
        Effects::All => decision(
            Effect::Rest,
            false,
            "all effects asked for: contacts and forces of resting groups are computed at every step".to_owned(),
            "nothing",
        ),
    };
    vec![
        decision(
            Effect::Contact,
            pairs.count > 0,
            format!("{} pairs may collide, {} touch at t = {}", pairs.count, findings.touching_pairs, findings.t_s),
            if pairs.count > 0 { "nothing: searched for at every step" } else { "all collision detection" },
        ),
        decision(
            Effect::Restitution,
            pairs.largest_restitution > 0.0,
            format!("largest coefficient of restitution of a pair: {}", pairs.largest_restitution),
            if pairs.largest_restitution > 0.0 { "nothing" } else { "the phase of restitution of every impact" },
        ),
        rest,
    ]
}

fn decision(effect: Effect, on: bool, fact: String, saves: &str) -> EffectDecision {
    let decision = if on { Decision::On } else { Decision::Off };
    EffectDecision { effect, decision, fact, saves: saves.to_owned() }
}

/// Rotation needs the general solution unless every body's inertia is spherical or none turns.
fn rotation_decision(world: &World) -> EffectDecision {
    let mut general = 0;
    let mut spherical = 0;
    for properties in present(world).filter_map(|(_, body)| body.mass_properties()) {
        let moments = properties.principal_axes().moments();
        if moments.x == moments.z { spherical += 1 } else { general += 1 }
    }
    decision(
        Effect::GeneralRotation,
        general > 0,
        format!("{general} bodies with different principal moments, {spherical} with equal ones"),
        if general > 0 {
            "nothing; spherical bodies and steady axes take one rotation instead of elliptic functions"
        } else {
            "elliptic functions: every rotation is about a fixed axis"
        },
    )
}

/// A body that spins about a principal axis, under no torque, goes on doing so at one rate.
fn steady_decision(world: &World) -> EffectDecision {
    let (mut steady, mut turning) = (0, 0);
    let mut off_axis = 0.0f64;
    for (body, entry) in present(world) {
        let Some(rigid) = &world.bodies[body].rigid else { continue };
        let pose = entry.initial_pose();
        let w = entry.initial_velocity().angular;
        if w == DVec3::ZERO || world.is_loaded(body) {
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
            "{steady} of {turning} free spins are about a principal axis (largest sine to it {off_axis:.1e}, limit 0)"
        ),
        if steady > 0 { "elliptic functions: one turn about a fixed axis" } else { "nothing" },
    )
}
