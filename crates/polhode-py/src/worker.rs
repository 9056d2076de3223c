//! Work in a thread of its own. The thread that asked for it waits, lets other threads of Python work, and looks for Ctrl-C.

use crate::errors;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

/// How long Ctrl-C may go unseen.
const LOOK_EVERY: Duration = Duration::from_millis(50);
/// How long a step may take to end after Ctrl-C: what is left of two seconds is for handing over what was computed.
const PATIENCE: Duration = Duration::from_millis(1500);
/// Stack of the thread, bytes: that of a program's first thread.
const STACK: usize = 8 << 20;

/// How the wait for work has ended.
pub(crate) enum Ended<T> {
    /// It is done.
    Done(T),
    /// What a handler of a signal has raised, and the result if the work has ended in time.
    Signal(PyErr, Option<T>),
    /// The thread has gone without a word.
    Lost,
}

/// Work that a thread does.
pub(crate) struct Worker<T> {
    given: Receiver<T>,
}

impl<T: Send + 'static> Worker<T> {
    /// Starts the thread.
    pub(crate) fn start(compute: impl FnOnce() -> T + Send + 'static) -> PyResult<Self> {
        let (give, given) = channel();
        let work = move || {
            // Nobody takes it when whoever waited has gone.
            let _ = give.send(compute());
        };
        let thread = std::thread::Builder::new().name("polhode".to_owned()).stack_size(STACK).spawn(work);
        thread.map_err(|error| PyRuntimeError::new_err(format!("no thread can be started for the run: {error}")))?;
        Ok(Self { given })
    }

    /// Waits for the end, and looks for signals meanwhile; `stop` asks the work to end early.
    pub(crate) fn wait(self, py: Python<'_>, stop: impl Fn() + Sync + Send) -> Ended<T> {
        py.detach(move || {
            loop {
                match self.given.recv_timeout(LOOK_EVERY) {
                    Ok(done) => return Ended::Done(done),
                    Err(RecvTimeoutError::Disconnected) => return Ended::Lost,
                    Err(RecvTimeoutError::Timeout) => {}
                }
                if let Some(raised) = errors::raised_by_signal() {
                    stop();
                    return Ended::Signal(raised, self.given.recv_timeout(PATIENCE).ok());
                }
            }
        })
    }
}

/// The thread of some work has ended without a result.
pub(crate) fn lost() -> PyErr {
    PyRuntimeError::new_err("the run broke off: a bug, whatever the scene was")
}
