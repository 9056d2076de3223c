//! The answer for one scene.

use super::error::StandsError;
use super::mechanism::{Mechanism, mechanism_at_push};
use crate::sweep::LoadAnywhere;
use crate::threads::Threads;
use polhode::stability::{Beginning, FrictionMargin};
use polhode::{
    Body, BodyId, BodySample, ContactView, Effects, ErrorEstimation, Simulation, SimulationError, Stability,
};
use polhode_scene::{LoadedScene, Override};
use std::fmt;
use std::sync::Arc;

/// A body moves that is this part as fast as one that falls, at least (no unit, 1e-6 to 1e-2): what stands is held to
/// the residual of its contact problem.
const MOVES: f64 = 1e-3;

/// Friction needed, of that which there is, up to which bodies stand: the analysis is good to six digits.
const ENOUGH: f64 = 1.0;

/// The scene that is asked about.
#[derive(Clone, Copy)]
pub struct Question<'a> {
    /// Reads it.
    pub load: &'a LoadAnywhere<'a>,
    /// Changes that it has.
    pub given: &'a [Override],
}

impl fmt::Debug for Question<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Question").field("given", &self.given).finish_non_exhaustive()
    }
}

/// What was found.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Standing {
    /// How far the bodies at rest are from moving.
    pub stability: Stability,
    /// What touches, with its forces.
    pub contacts: Vec<ContactView>,
    /// Bodies that move in the first step, the fastest first.
    pub moving: Vec<BodyId>,
    /// The motion that begins, now or where the least margin ends; none where nothing does.
    pub mechanism: Option<Mechanism>,
}

impl Standing {
    /// Whether they stand.
    pub fn stands(&self) -> bool {
        self.moving.is_empty() && is_held(&self.stability.friction)
    }

    /// The bodies that move first, the fastest first: those of the first step, else those of the mechanism. Each with
    /// how it begins, where the mechanism has it.
    pub fn first(&self) -> Vec<(BodyId, Option<Beginning>)> {
        let bodies = self.mechanism.iter().flat_map(|own| &own.bodies);
        let begins = |body: BodyId| bodies.clone().find(|own| own.body == body).map(|own| own.beginning);
        if self.moving.is_empty() {
            bodies.clone().map(|own| (own.body, Some(own.beginning))).collect()
        } else {
            self.moving.iter().map(|&body| (body, begins(body))).collect()
        }
    }
}

impl Question<'_> {
    /// The scene with these changes besides its own: by time steps, unless it names a tier, since the most accurate one
    /// takes long over hundreds of contacts that move.
    ///
    /// # Errors
    /// When it is refused.
    pub fn loaded(&self, changes: &[Override]) -> Result<LoadedScene, StandsError> {
        let mut all: Vec<Override> = self.given.iter().chain(changes).cloned().collect();
        let loaded = (self.load)(&all)?;
        if loaded.scene.method().tier.is_some() {
            return Ok(loaded);
        }
        all.push(Override::new("stands", "method.tier", "stepped"));
        Ok((self.load)(&all)?)
    }

    /// Whether it stands, with all margins; and the scene.
    ///
    /// # Errors
    /// When the scene is refused or the engine ends.
    pub fn standing(&self) -> Result<(LoadedScene, Standing), StandsError> {
        let loaded = self.loaded(&[])?;
        let standing = found(&loaded).map_err(|error| failed(&loaded, error))?;
        Ok((loaded, standing))
    }

    /// Whether it stands with these changes.
    ///
    /// # Errors
    /// As [`Question::standing`].
    pub fn stands_with(&self, changes: &[Override]) -> Result<bool, StandsError> {
        let loaded = self.loaded(changes)?;
        let stands = || {
            let mut simulation = simulation(&loaded)?;
            Ok(is_held(&simulation.friction_margin()?) && moving(&loaded, &mut simulation)?.is_empty())
        };
        stands().map_err(|error| failed(&loaded, error))
    }
}

fn is_held(friction: &FrictionMargin) -> bool {
    friction.needed.is_some_and(|needed| needed <= ENOUGH)
}

fn failed(loaded: &LoadedScene, error: SimulationError) -> StandsError {
    match error {
        SimulationError::Scene(error) => loaded.explain(error).into(),
        source => StandsError::Simulation { scene: loaded.scene.name().to_owned(), source: Box::new(source) },
    }
}

/// In space, also where the motion is planar: a push comes from any side.
fn simulation(loaded: &LoadedScene) -> Result<Simulation, SimulationError> {
    let mut simulation = Simulation::with_effects(&loaded.scene, Effects::All)?.estimating(ErrorEstimation::Off);
    simulation.set_executor(Arc::new(Threads::of_machine()));
    Ok(simulation)
}

/// Looks at the scene as it is, and at its first step.
fn found(loaded: &LoadedScene) -> Result<Standing, SimulationError> {
    let mut simulation = simulation(loaded)?;
    let stability = simulation.stability()?;
    let touching = simulation.contacts();
    let moving = moving(loaded, &mut simulation)?;
    let mechanism = match (&moving[..], is_held(&stability.friction)) {
        // Where statics has many motions, the first step has the one that begins.
        ([_, ..], _) => Mechanism::now(&loaded.scene, &simulation.moving_bodies(), &touching),
        ([], true) => mechanism_at_push(&loaded.scene, &stability, &touching),
        ([], false) => Mechanism::now(&loaded.scene, &stability.friction.begins, &touching),
    };
    Ok(Standing { stability, contacts: simulation.contacts(), moving, mechanism })
}

/// The bodies that the first step moves, the fastest first: what touches nothing is in no analysis.
fn moving(loaded: &LoadedScene, simulation: &mut Simulation) -> Result<Vec<BodyId>, SimulationError> {
    // Events at the start are steps of no length.
    let t_s = loop {
        let t_s = simulation.step()?.t_s;
        if t_s > 0.0 {
            break t_s;
        }
    };
    let least = MOVES * loaded.scene.gravity().length() * t_s;
    let of_body = |(body, own): (&Body, BodySample)| {
        if body.is_fixed() {
            0.0
        } else {
            own.velocity.linear.length() + radius_m(body) * own.velocity.angular.length()
        }
    };
    let speeds = loaded.scene.bodies().iter().zip(simulation.bodies()).map(of_body);
    let mut moving: Vec<(BodyId, f64)> = speeds
        .enumerate()
        .filter(|(_, speed)| *speed > least)
        .map(|(body, speed)| (BodyId::new(body), speed))
        .collect();
    moving.sort_by(|a, b| b.1.total_cmp(&a.1));
    Ok(moving.into_iter().map(|own| own.0).collect())
}

/// The distance from its centre of mass at which a body turns as fast as it does on the mean (the root of the mean
/// square), m: that of a body whose mass is not given, since a motion carries it, is not asked for.
fn radius_m(body: &Body) -> f64 {
    let square =
        |own: &polhode::spatial::MassProperties| 0.5 * own.principal_axes().moments().element_sum() / own.mass();
    body.mass_properties().map_or(0.0, |own| square(own).sqrt())
}
