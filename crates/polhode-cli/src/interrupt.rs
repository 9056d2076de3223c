//! Ctrl-C and SIGTERM: the first ends a run at the end of its step and drawing at the end of its frame, the second ends the
//! program at once. Neither loses what was computed.

use crate::failure::{self, Failure};
use polhode_scene::Unfinished;
use std::io;
use std::path::PathBuf;
use std::process;
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// Whether the program has been asked to end, and by what.
pub(crate) struct Interrupt {
    asked: Arc<Asked>,
}

/// What those who listen to signals share with the run.
#[derive(Default)]
struct Asked {
    /// The exit code of what has asked for an end; 0 as long as nothing has.
    code: AtomicU8,
    /// Files that a program which ends at once keeps under their partial names.
    unfinished: Mutex<Vec<Unfinished>>,
    /// Temporary files that it removes.
    temporary: Mutex<Vec<PathBuf>>,
}

impl Interrupt {
    /// From now on Ctrl-C, and where there is such a thing SIGTERM, ends the run at the end of its step; either of them
    /// after that ends the program at once.
    ///
    /// # Errors
    /// When signals cannot be listened to.
    pub(crate) fn listen() -> Result<Self, Failure> {
        let asked = Arc::new(Asked::default());
        let own = Arc::clone(&asked);
        ctrlc::set_handler(move || own.ask(failure::INTERRUPTED)).map_err(|error| cannot_listen("Ctrl-C", &error))?;
        listen_to_sigterm(&asked)?;
        Ok(Self { asked })
    }

    /// Files that a program which ends at once keeps under their partial names.
    pub(crate) fn keep(&self, files: Vec<Unfinished>) {
        *self.asked.unfinished.lock().unwrap_or_else(PoisonError::into_inner) = files;
    }

    /// Temporary files that a program which ends at once removes: nobody could open them.
    pub(crate) fn remove(&self, files: Vec<PathBuf>) {
        *self.asked.temporary.lock().unwrap_or_else(PoisonError::into_inner) = files;
    }

    /// Whether the program has been asked to end.
    pub(crate) fn has_come(&self) -> bool {
        self.code() != 0
    }

    /// The exit code of a run that was asked to end; 0 of one that was not.
    pub(crate) fn code(&self) -> u8 {
        self.asked.code.load(Ordering::SeqCst)
    }
}

impl Asked {
    /// Someone asks for an end that has this exit code.
    fn ask(&self, code: u8) {
        if self.code.compare_exchange(0, code, Ordering::SeqCst, Ordering::SeqCst).is_ok() {
            return failure::remark("note: stopping at the end of this step or frame; Ctrl-C again stops at once");
        }
        for file in self.unfinished.lock().unwrap_or_else(PoisonError::into_inner).drain(..) {
            match file.keep() {
                Ok(partial) => failure::note(&format!("note: what was computed is in {}", partial.display())),
                // The run has just come to its end and moved the file to its own name.
                Err(error) if error.kind() == io::ErrorKind::NotFound => {}
                Err(error) => failure::note(&format!("error: cannot keep what was computed: {error}")),
            }
        }
        for file in self.temporary.lock().unwrap_or_else(PoisonError::into_inner).drain(..) {
            // One that has been moved to its name is gone.
            let _ = std::fs::remove_file(file);
        }
        process::exit(i32::from(code));
    }
}

fn cannot_listen(to: &str, error: &impl std::fmt::Display) -> Failure {
    Failure::InputOutput(format!("error: cannot listen to {to}: {error}"))
}

/// SIGTERM is what schedulers and a machine that is switched off send.
#[cfg(unix)]
fn listen_to_sigterm(asked: &Arc<Asked>) -> Result<(), Failure> {
    let listens = signal_hook::iterator::Signals::new([signal_hook::consts::SIGTERM]);
    let mut signals = listens.map_err(|error| cannot_listen("SIGTERM", &error))?;
    let own = Arc::clone(asked);
    let thread = std::thread::Builder::new().spawn(move || {
        signals.forever().for_each(|_| own.ask(failure::TERMINATED));
    });
    thread.map(drop).map_err(|error| cannot_listen("SIGTERM", &error))
}

#[cfg(not(unix))]
fn listen_to_sigterm(_asked: &Arc<Asked>) -> Result<(), Failure> {
    Ok(())
}
