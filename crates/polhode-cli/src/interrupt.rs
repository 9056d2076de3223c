//! Ctrl-C and SIGTERM are acted on within two seconds, wherever the program is.
//!
//! At first they end the program at once. While a run makes its steps, or pictures are drawn frame by frame
//! ([`Interrupt::wait_for_steps`]), the first one ends the work at the end of that step or frame, so that a checkpoint
//! can be written; a second one, or a step that has not ended [`PATIENCE`] later, ends the program at once. In no case
//! is lost what was computed: files that hold whole samples are kept under their partial names, and all other temporary
//! files removed.

use crate::failure::{self, Failure};
use polhode_scene::Unfinished;
use std::path::PathBuf;
use std::process;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// How long a step or a frame may take to end after the program has been asked to: what is left of the two seconds is
/// for moving files.
const PATIENCE: Duration = Duration::from_millis(1500);

/// Whether the program has been asked to end, and by what.
#[derive(Clone)]
pub(crate) struct Interrupt {
    asked: Arc<Asked>,
}

/// What those who listen to signals share with the work.
#[derive(Default)]
struct Asked {
    /// The exit code of what has asked for an end; 0 as long as nothing has.
    code: AtomicU8,
    /// Whether the work looks at [`Interrupt::has_come`] after every step or frame.
    looks: AtomicBool,
    /// Whether the work has seen that an end is asked for, and is ending.
    has_seen: AtomicBool,
    files: Mutex<Files>,
}

/// What a program that ends at once does with its files.
#[derive(Default)]
struct Files {
    /// Kept under their partial names.
    unfinished: Vec<Unfinished>,
    /// Removed.
    temporary: Vec<PathBuf>,
}

impl Interrupt {
    /// From now on Ctrl-C, and where there is such a thing SIGTERM, are listened to. Called once, at the start.
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

    /// Creates files that a program which ends at once keeps under their partial names: those that `unfinished` names.
    /// It does not end between their creation and this note of them.
    ///
    /// # Errors
    /// Those of `create`.
    pub(crate) fn keep<T, E>(
        &self,
        create: impl FnOnce() -> Result<T, E>,
        unfinished: impl FnOnce(&T) -> Vec<Unfinished>,
    ) -> Result<T, E> {
        let mut files = self.asked.files();
        let created = create()?;
        files.unfinished = unfinished(&created);
        Ok(created)
    }

    /// Creates files that a program which ends at once removes, since nobody could open them: those that `temporary`
    /// names. It does not end between their creation and this note of them.
    ///
    /// # Errors
    /// Those of `create`.
    pub(crate) fn remove<T, E>(
        &self,
        create: impl FnOnce() -> Result<T, E>,
        temporary: impl FnOnce(&T) -> Vec<PathBuf>,
    ) -> Result<T, E> {
        let mut files = self.asked.files();
        let created = create()?;
        files.temporary.extend(temporary(&created));
        Ok(created)
    }

    /// Moves files to their names and tells them. The program does not end meanwhile, and afterwards leaves alone the
    /// files that it was to keep: each is named once, by who has moved it.
    pub(crate) fn move_kept<T>(&self, move_files: impl FnOnce() -> T) -> T {
        let mut files = self.asked.files();
        let moved = move_files();
        files.unfinished.clear();
        moved
    }

    /// From now on the work looks after every step or frame whether it is to end.
    pub(crate) fn wait_for_steps(&self) {
        self.asked.looks.store(true, Ordering::SeqCst);
    }

    /// Whether the program has been asked to end. Who asks is taken to end the work now, however long that takes.
    pub(crate) fn has_come(&self) -> bool {
        let has_come = self.code() != 0;
        if has_come {
            self.asked.has_seen.store(true, Ordering::SeqCst);
        }
        has_come
    }

    /// The exit code of a run that was asked to end; 0 of one that was not.
    pub(crate) fn code(&self) -> u8 {
        self.asked.code.load(Ordering::SeqCst)
    }
}

impl Asked {
    fn files(&self) -> MutexGuard<'_, Files> {
        self.files.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Someone asks for an end that has this exit code.
    fn ask(self: &Arc<Self>, code: u8) {
        let is_first = self.code.compare_exchange(0, code, Ordering::SeqCst, Ordering::SeqCst).is_ok();
        if !is_first || !self.looks.load(Ordering::SeqCst) {
            self.end(code);
        }
        failure::remark("note: stopping at the end of this step or frame; Ctrl-C again stops at once");
        let own = Arc::clone(self);
        let waits = std::thread::Builder::new().spawn(move || {
            std::thread::sleep(PATIENCE);
            if !own.has_seen.load(Ordering::SeqCst) {
                own.end(code);
            }
        });
        if waits.is_err() {
            self.end(code);
        }
    }

    /// Ends the program at once.
    fn end(&self, code: u8) -> ! {
        let mut files = self.files();
        for file in files.unfinished.drain(..) {
            match file.keep() {
                Ok(partial) => failure::note(&format!("note: what was computed is in {}", partial.display())),
                Err(error) => failure::note(&format!("error: cannot keep what was computed: {error}")),
            }
        }
        for file in files.temporary.drain(..) {
            // One that has been moved to its name is gone.
            let _ = std::fs::remove_file(file);
        }
        failure::note("interrupted");
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
