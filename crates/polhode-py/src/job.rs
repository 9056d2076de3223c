//! Work in a thread of its own. The thread that asked for it waits, lets other threads of Python work, tells how far
//! the work is, and looks for Ctrl-C.

use polhode::Flow;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

/// How long Ctrl-C may go unseen.
const LOOK_EVERY: Duration = Duration::from_millis(50);
/// How long a step may take to end after Ctrl-C: what is left of two seconds is for handing over what was computed.
const PATIENCE: Duration = Duration::from_millis(1500);
/// Stack of the thread, bytes: that of a program's first thread.
const STACK: usize = 8 << 20;

/// What the thread that works and the one that waits share: how far the work is, and whether it is to end.
#[derive(Debug, Default)]
pub(crate) struct Watch {
    stop: AtomicBool,
    done: AtomicU64,
    all: AtomicU64,
}

impl Watch {
    /// So much of all is done; whether to go on.
    pub(crate) fn reached(&self, done: f64, all: f64) -> Flow {
        self.done.store(done.to_bits(), Ordering::Relaxed);
        self.all.store(all.to_bits(), Ordering::Relaxed);
        if self.stop.load(Ordering::Relaxed) { Flow::Stop } else { Flow::Continue }
    }

    /// How much of all is done.
    fn so_far(&self) -> (f64, f64) {
        let load = |number: &AtomicU64| f64::from_bits(number.load(Ordering::Relaxed));
        (load(&self.done), load(&self.all))
    }
}

/// How the wait for work has ended.
pub(crate) enum Ended<T> {
    Done(T),
    /// What a handler of a signal, or who was told, has raised; and the work if it has ended in time.
    Raised(PyErr, Option<T>),
}

impl<T> Ended<T> {
    /// What the work has given.
    ///
    /// # Errors
    /// What was raised meanwhile.
    pub(crate) fn whole(self) -> PyResult<T> {
        match self {
            Self::Done(done) => Ok(done),
            Self::Raised(raised, _) => Err(raised),
        }
    }
}

/// Works in a thread of its own; `told` is called with how much of all is done.
///
/// # Errors
/// When no thread can be started, or it has gone without a word.
pub(crate) fn work<T: Send + 'static>(
    py: Python<'_>,
    told: Option<Py<PyAny>>,
    compute: impl FnOnce(&Watch) -> T + Send + 'static,
) -> PyResult<Ended<T>> {
    let (give, given) = channel();
    let watch = Arc::new(Watch::default());
    let watched = Arc::clone(&watch);
    // Nobody takes it when whoever waited has gone.
    let compute = move || drop(give.send(compute(&watched)));
    let thread = std::thread::Builder::new().name("polhode".to_owned()).stack_size(STACK).spawn(compute);
    thread.map_err(|error| PyRuntimeError::new_err(format!("no thread can be started for the work: {error}")))?;
    let ended = py.detach(move || wait(&given, &watch, told.as_ref()));
    ended.ok_or_else(|| PyRuntimeError::new_err("the work broke off: a bug, whatever the scene was"))
}

/// Waits for the end, and looks for signals meanwhile; none when the thread has gone without a word.
fn wait<T>(given: &Receiver<T>, watch: &Watch, told: Option<&Py<PyAny>>) -> Option<Ended<T>> {
    loop {
        match given.recv_timeout(LOOK_EVERY) {
            Ok(done) => return Some(Ended::Done(done)),
            Err(RecvTimeoutError::Disconnected) => return None,
            Err(RecvTimeoutError::Timeout) => {}
        }
        let looked = Python::attach(|py| {
            py.check_signals()?;
            told.map_or(Ok(()), |told| told.call1(py, watch.so_far()).map(drop))
        });
        if let Err(raised) = looked {
            watch.stop.store(true, Ordering::Relaxed);
            return Some(Ended::Raised(raised, given.recv_timeout(PATIENCE).ok()));
        }
    }
}
