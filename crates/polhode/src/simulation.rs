//! A simulation: a scene in motion.

use crate::accurate::Engine;
use crate::body_queries::BodyQueries;
use crate::free_method;
use crate::observer::{Flow, Observer};
use crate::plan::Findings;
use crate::planar::{self, PlanarFinding};
use crate::report::{Outcome, RunReport};
use crate::scene::Tier;
use crate::settings::Settings;
use crate::stepped::SteppedEngine;
use crate::thesis::ThesisEngine;
use crate::world::World;
use crate::{Effects, Plan, Scene, SimulationError};
use polhode_contact::QueryError;
use polhode_spatial::DVec3;

/// Acceleration of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Acceleration {
    /// Of the centre of mass, world, m/s^2.
    pub linear: DVec3,
    /// Angular, world, rad/s^2.
    pub angular: DVec3,
}

/// A scene in motion.
#[derive(Debug)]
pub struct Simulation {
    scene: Scene,
    plan: Plan,
    tier: TierEngine,
}

/// The engine of a tier.
#[derive(Debug)]
enum TierEngine {
    Accurate(Box<Engine>),
    Thesis(Box<ThesisEngine>),
    Stepped(Box<SteppedEngine>),
}

impl Simulation {
    /// Prepares a scene: makes the plan, finds what touches and checks that nothing overlaps.
    ///
    /// # Errors
    /// When bodies overlap at the start or the contact forces of the start cannot be found.
    pub fn new(scene: &Scene, effects: Effects) -> Result<Self, SimulationError> {
        // The method or the duration may have been put in after the scene was built.
        scene.check_times()?;
        let mut settings = Settings::resolve(scene.method());
        let (mut world, mut states) = World::new(scene)?;
        let choice = free_method::choose(&world, &states, &settings);
        settings.integrator = choice.integrator;
        let planar = match effects {
            Effects::Planned => planar::find(&world, &states, &settings),
            Effects::All => PlanarFinding::off("all effects asked for: every body moves in space"),
        };
        world.enter_plane(planar.plane, &mut states);
        let engine = Engine::new(world.clone(), states.clone(), settings, effects)?;
        let plan = Plan::derive(&world, &settings, effects, engine.touching_pairs(), &Findings { choice, planar });
        let tier = match settings.tier {
            Tier::Accurate => TierEngine::Accurate(Box::new(engine)),
            Tier::Thesis => TierEngine::Thesis(Box::new(ThesisEngine::new(world, states, settings))),
            Tier::Stepped => TierEngine::Stepped(Box::new(SteppedEngine::new(world, states, settings, effects))),
        };
        Ok(Self { scene: scene.clone(), plan, tier })
    }

    /// The plan.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Accelerations of all bodies now, in the order of the scene.
    ///
    /// # Errors
    /// When the contact forces cannot be found.
    pub fn accelerations(&mut self) -> Result<Vec<Acceleration>, SimulationError> {
        match &mut self.tier {
            TierEngine::Accurate(engine) => engine.accelerations(),
            TierEngine::Thesis(engine) => engine.accelerations(),
            TierEngine::Stepped(engine) => engine.accelerations(),
        }
    }

    /// Runs to the end of the scene's duration.
    ///
    /// # Errors
    /// See [`SimulationError`].
    pub fn run(&mut self, observer: &mut dyn Observer) -> Result<RunReport, SimulationError> {
        let mut outcome = Outcome::Completed;
        while self.time() < self.scene.duration_s() {
            match &mut self.tier {
                TierEngine::Accurate(engine) => engine.step(observer)?,
                TierEngine::Thesis(engine) => engine.step(observer)?,
                TierEngine::Stepped(engine) => engine.step(observer)?,
            }
            if observer.progress(self.time()) == Flow::Stop {
                outcome = Outcome::Stopped;
                break;
            }
        }
        Ok(self.report(outcome))
    }

    /// Time reached, s.
    pub fn time(&self) -> f64 {
        match &self.tier {
            TierEngine::Accurate(engine) => engine.time(),
            TierEngine::Thesis(engine) => engine.time(),
            TierEngine::Stepped(engine) => engine.time(),
        }
    }

    /// The bodies where they stand now, for questions: what is nearest, what a ray meets, what overlaps what. An example
    /// stands at [`BodyQueries`].
    ///
    /// # Errors
    /// When a pose is not finite.
    pub fn queries(&self) -> Result<BodyQueries<'_>, QueryError> {
        let (world, states) = match &self.tier {
            TierEngine::Accurate(engine) => engine.bodies(),
            TierEngine::Thesis(engine) => engine.bodies(),
            TierEngine::Stepped(engine) => engine.bodies(),
        };
        BodyQueries::new(world, states)
    }

    fn report(&mut self, outcome: Outcome) -> RunReport {
        let simulated_s = self.time();
        let mut report = RunReport {
            scene: self.scene.name().to_owned(),
            plan: self.plan.clone(),
            outcome,
            duration_s: self.scene.duration_s(),
            simulated_s,
            steps: 0,
            events: 0,
            energy: crate::Energy::default(),
            ledger: crate::Ledger::default(),
            certificate: crate::Certificate::default(),
            warnings: Vec::new(),
            bodies: Vec::new(),
        };
        match &mut self.tier {
            TierEngine::Accurate(engine) => engine.fill(&mut report),
            TierEngine::Thesis(engine) => engine.fill(&mut report),
            TierEngine::Stepped(engine) => engine.fill(&mut report),
        }
        report
    }
}
