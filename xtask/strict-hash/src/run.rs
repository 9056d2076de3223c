//! The run of a scene file, with everything that was observed.
//!
//! Either each step is made once, as in any run, or twice: from a snapshot of the state before the step, the simulation
//! is restored and the step made again. Samples and events of both, and the snapshots after them, must have the same
//! bits; the run goes on from the second. Its record then has the strict hash of the run in which each step was made
//! once, if restoring a snapshot loses nothing.

use crate::hash::strict_hash;
use polhode::{Recorder, Scene, Simulation, SimulationError};
use polhode_scene::SceneFileError;
use std::path::Path;
use thiserror::Error;

/// How often each step is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Repeat {
    /// Once.
    No,
    /// Twice, each time from the snapshot of the state before it.
    EachStep,
}

/// Why a scene file has no strict hash.
#[derive(Debug, Error)]
pub enum Failure {
    /// The file is refused.
    #[error(transparent)]
    File(#[from] SceneFileError),
    /// The simulation failed.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
    /// A step that was made again has other bits.
    #[error(
        "the step from t = {t_s} s has other bits when it is repeated from its snapshot ({part} differ): look at what \
         of the state the snapshot does not hold"
    )]
    Repeated {
        /// Time at the start of the step, s.
        t_s: f64,
        /// What differs.
        part: &'static str,
    },
}

/// Samples and events of the run of a scene file, with the effects that its plan finds.
///
/// # Errors
/// When the file is refused, the simulation fails, or a repeated step has other bits.
pub fn record_of(file: &Path, repeat: Repeat) -> Result<Recorder, Failure> {
    let scene = polhode_scene::load(file)?;
    match repeat {
        Repeat::No => {
            let mut record = Recorder::default();
            Simulation::new(&scene)?.run_observed(&mut record)?;
            Ok(record)
        }
        Repeat::EachStep => with_repeated_steps(&scene),
    }
}

fn with_repeated_steps(scene: &Scene) -> Result<Recorder, Failure> {
    let mut simulation = Simulation::new(scene)?;
    let mut record = Recorder::default();
    while !simulation.has_ended() {
        let t_s = simulation.time();
        let before = simulation.snapshot();
        let first = observed_step(&mut simulation)?;
        let after = simulation.snapshot().to_bytes();
        simulation.restore(&before)?;
        let second = observed_step(&mut simulation)?;
        if strict_hash(&first) != strict_hash(&second) {
            return Err(Failure::Repeated { t_s, part: "samples or events" });
        }
        if simulation.snapshot().to_bytes() != after {
            return Err(Failure::Repeated { t_s, part: "snapshots of the end" });
        }
        record.times_s.extend(second.times_s);
        record.samples.extend(second.samples);
        record.events.extend(second.events);
    }
    Ok(record)
}

/// Samples and events of one step.
fn observed_step(simulation: &mut Simulation) -> Result<Recorder, SimulationError> {
    let mut record = Recorder::default();
    simulation.step_observed(&mut record)?;
    Ok(record)
}

#[cfg(test)]
mod tests {
    //! A run with impacts and rest has the same bits when each of its steps is made twice, and a file that is not there
    //! says so.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    fn shipped(scene: &str) -> std::path::PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/scenes").join(format!("{scene}.toml"))
    }

    #[test]
    fn repeated_steps_change_no_bit() {
        for scene in ["bouncing-ball", "box-drop"] {
            let [once, twice] =
                [Repeat::No, Repeat::EachStep].map(|repeat| strict_hash(&record_of(&shipped(scene), repeat).unwrap()));
            assert_eq!(once, twice, "{scene}");
        }
    }

    #[test]
    fn a_file_that_is_missing_is_an_error() {
        assert!(matches!(record_of(&shipped("no such scene"), Repeat::No), Err(Failure::File(_))));
    }
}
