//! Drops: on which faces a body comes to rest. They run in a thread that Ctrl-C ends.

use crate::errors;
use crate::job::{self, Ended};
use crate::loaded::Loaded;
use polhode::spatial::DVec3;
use polhode::{Effects, Flow};
use polhode_study::Threads;
use polhode_study::drop::{DropError, RestPoses, Setting, Start, Throws, json};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// How a body is let go: number of throws and seed; height, longest time, place; radius of corners.
type Asked = (u64, u64, Option<f64>, Option<f64>, Option<[f64; 3]>, Option<f64>);

/// Throws a body of a scene, or of one scene into another: everything as JSON, as `polhode drop --json` prints it.
/// `told` is called with how much of all is done.
#[pyfunction]
#[pyo3(signature = (loaded, body, on, asked, workers, told))]
pub(crate) fn rest_poses(
    py: Python<'_>,
    loaded: &Loaded,
    body: Option<String>,
    on: Option<&Loaded>,
    asked: Asked,
    workers: Option<usize>,
    told: Option<Py<PyAny>>,
) -> PyResult<String> {
    let (count, seed, height_m, longest_s, place, corner_radius_m) = asked;
    let start = Start { height_m, place: place.map(DVec3::from_array), longest_s };
    let workers = workers.map_or(Ok(Threads::of_machine().0), |workers| {
        NonZeroUsize::new(workers).ok_or_else(|| errors::value("workers: at least 1 is needed, found 0"))
    })?;
    let throws = Throws { count, seed, workers, corner_radius_m };
    let scenes = [Some(loaded), on].map(|own| own.map(|own| Arc::clone(&own.scene)));
    let ended = job::work(py, told, move |watch| {
        let [Some(own), on] = &scenes else { return Err(DropError::Stopped { done: 0, all: count }) };
        let setting = match on {
            None => Setting::of_scene(&own.scene, body.as_deref(), Effects::Planned, start)?,
            Some(on) => {
                let thrown = Setting::of_scene(&own.scene, body.as_deref(), Effects::Planned, start)?;
                Setting::onto(&on.scene, thrown.into_body(), Effects::Planned, start)?
            }
        };
        let (stop, mut done) = (AtomicBool::new(false), 0);
        let is_stopped = || stop.load(Ordering::Relaxed);
        let poses = RestPoses::of(&setting, &throws, &is_stopped, |_| {
            done += 1;
            if watch.reached(f64::from(done), count as f64) == Flow::Stop {
                stop.store(true, Ordering::Relaxed);
            }
            Ok(())
        })?;
        Ok(json(&setting, &throws, &poses).to_string())
    })?;
    match ended {
        Ended::Done(done) => done.map_err(|error| refused(py, error)),
        Ended::Raised(raised, _) if raised.is_instance_of::<PyKeyboardInterrupt>(py) => {
            Err(errors::plain(py, "Interrupted", "the throws were interrupted"))
        }
        Ended::Raised(raised, _) => Err(raised),
    }
}

/// Why nothing was thrown, as an exception.
fn refused(py: Python<'_>, error: DropError) -> PyErr {
    match error {
        DropError::File(error) => errors::scene(py, &error),
        error => errors::value(error),
    }
}
