//! `polhode stands`: whether bodies stand, how firmly, what moves first, and what each contact carries.
//!
//! A scene stands when limit analysis (`polhode::stability`) finds forces within the cones of friction that hold all
//! bodies at rest, and none moves in the first step. The two are independent: one solves for forces, the other
//! integrates.

use crate::args::{SceneArgs, StandsArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::scene::{self, SceneText};
use crate::stdout;
use crate::text::stands::{self, Standing};
use polhode::{BodyId, BodySample, Effects, ErrorEstimation, Simulation, SimulationError};
use polhode_scene::{LoadedScene, Override};
use polhode_study::Threads;
use std::sync::Arc;

/// A body moves that is this part as fast as one that falls, at least (no unit, 1e-6 to 1e-2): what stands is held to
/// the residual of its contact problem.
const MOVES: f64 = 1e-3;

/// Says whether the bodies stand; exit code 1 where they do not.
pub(crate) fn stands(args: &StandsArgs) -> Result<(), Failure> {
    let progress = Progress::new("looking for what holds the bodies");
    let loaded = loaded(&args.scene)?;
    let standing = found(&loaded).map_err(|error| scene::failed(&loaded, error))?;
    drop(progress);
    if args.json {
        stdout::json(&stands::json(&loaded.scene, &standing))?;
    } else {
        stdout::text(&stands::page(&loaded.scene, &standing, args.contacts))?;
    }
    if standing.stands() { Ok(()) } else { Err(Failure::Check(String::new())) }
}

/// The scene: by time steps, unless it names a tier, since the most accurate one takes long over hundreds of contacts
/// that move.
fn loaded(args: &SceneArgs) -> Result<LoadedScene, Failure> {
    let text = SceneText::of(&args.scene)?;
    let mut changes = scene::overrides(&args.changes)?;
    let loaded = text.load(&changes)?;
    if loaded.scene.method().tier.is_some() {
        return Ok(loaded);
    }
    changes.push(Override::new("stands", "method.tier", "stepped"));
    Ok(text.load(&changes)?)
}

/// Looks at the scene as it is, and at its first step.
fn found(loaded: &LoadedScene) -> Result<Standing, SimulationError> {
    // In space, also where the motion is planar: a push comes from any side.
    let mut simulation = Simulation::with_effects(&loaded.scene, Effects::All)?.estimating(ErrorEstimation::Off);
    simulation.set_executor(Arc::new(Threads::of_machine()));
    let stability = simulation.stability()?;
    // What touches nothing moves, and is in no analysis. Events at the start are steps of no length.
    let t_s = loop {
        let t_s = simulation.step()?.t_s;
        if t_s > 0.0 {
            break t_s;
        }
    };
    let least = MOVES * loaded.scene.gravity().length() * t_s;
    let speed_of = |own: &BodySample| own.velocity.linear.length() + own.velocity.angular.length();
    let moves = |number: usize| loaded.scene.bodies().get(number).is_some_and(|body| !body.is_fixed());
    let speeds = simulation.bodies().into_iter().enumerate().map(|(number, own)| (BodyId::new(number), speed_of(&own)));
    let mut moving: Vec<(BodyId, f64)> = speeds.filter(|(body, speed)| moves(body.index()) && *speed > least).collect();
    moving.sort_by(|a, b| b.1.total_cmp(&a.1));
    Ok(Standing { stability, contacts: simulation.contacts(), moving: moving.into_iter().map(|own| own.0).collect() })
}
