//! Loading the scene that a command names.

use crate::args::{ChangeArgs, EffectsArg, SceneArgs};
use crate::failure::Failure;
use polhode::{Effects, Simulation, SimulationError};
use polhode_scene::{LoadedScene, Override, load_with};

/// The scene with the changes of the command line.
pub(crate) fn load(args: &SceneArgs) -> Result<LoadedScene, Failure> {
    Ok(load_with(&args.scene, &overrides(&args.changes)?)?)
}

/// The changes of the command line.
pub(crate) fn overrides(args: &ChangeArgs) -> Result<Vec<Override>, Failure> {
    let mut overrides = Vec::new();
    for text in &args.set {
        overrides.push(change("--set", text)?);
    }
    let flags = [
        ("--tier", "method.tier", &args.tier),
        ("--step", "method.step", &args.step),
        ("--duration", "duration", &args.duration),
    ];
    for (flag, key, value) in flags {
        if let Some(value) = value {
            overrides.push(Override::new(format!("command line ({flag})"), key, value));
        }
    }
    Ok(overrides)
}

/// One change that an option of this name gives.
pub(crate) fn change(option: &str, text: &str) -> Result<Override, Failure> {
    Override::parse(format!("command line ({option})"), text).ok_or_else(|| {
        Failure::Usage(format!("error: {option} {text}: not of the form KEY=VALUE, such as {option} duration=5"))
    })
}

/// The scene, ready to run.
pub(crate) fn prepare(loaded: &LoadedScene, args: &ChangeArgs) -> Result<Simulation, Failure> {
    Simulation::new(&loaded.scene, effects(args)).map_err(|error| failed(loaded, error))
}

/// The effects that are simulated.
pub(crate) fn effects(args: &ChangeArgs) -> Effects {
    match args.effects {
        EffectsArg::Planned => Effects::Planned,
        EffectsArg::All => Effects::All,
    }
}

/// A failure of the engine: a scene that is refused is shown at its place, anything else is a failed check.
pub(crate) fn failed(loaded: &LoadedScene, error: SimulationError) -> Failure {
    match error {
        SimulationError::Scene(error) => loaded.explain(error).into(),
        error => Failure::Check(format!("error: {}: {error}", loaded.scene.name())),
    }
}
