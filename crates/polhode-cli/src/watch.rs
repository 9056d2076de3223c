//! Who is told of a run while it goes on, and when it stops.

use crate::failure::{self, Failure};
use crate::progress::Progress;
use polhode::{BodySample, Event, Flow, Frame, Observer};
use polhode_scene::Unfinished;
use std::process;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// Tells all that a run is watched by, shows progress, and stops the run at Ctrl-C or when a checkpoint is due.
pub(crate) struct Watch<'a> {
    /// Files and pictures that are written.
    pub(crate) observers: Vec<&'a mut dyn Observer>,
    pub(crate) bar: &'a Progress,
    pub(crate) interrupt: &'a Interrupt,
    /// When the run stops next to be kept, s.
    pub(crate) stop_s: f64,
    /// Whether one of the observers has stopped the run: a file could not be written.
    pub(crate) is_stopped: bool,
}

impl Observer for Watch<'_> {
    fn sample(&mut self, t: f64, bodies: &[BodySample]) {
        self.observers.iter_mut().for_each(|observer| observer.sample(t, bodies));
    }

    fn event(&mut self, event: &Event) {
        self.observers.iter_mut().for_each(|observer| observer.event(event));
    }

    fn wants_frames(&self) -> bool {
        self.observers.iter().any(|observer| observer.wants_frames())
    }

    fn frame(&mut self, frame: &Frame) {
        self.observers.iter_mut().for_each(|observer| observer.frame(frame));
    }

    fn progress(&mut self, t: f64) -> Flow {
        self.bar.advance(t);
        let is_over = t >= self.stop_s || self.interrupt.has_come() || self.bar.wants_look();
        // All are told of the step at which the run stops: plots are of every step.
        let flows: Vec<Flow> = self.observers.iter_mut().map(|observer| observer.progress(t)).collect();
        self.is_stopped |= flows.contains(&Flow::Stop);
        if is_over || self.is_stopped { Flow::Stop } else { Flow::Continue }
    }
}

/// Whether Ctrl-C has been pressed.
pub(crate) struct Interrupt {
    pressed: Arc<AtomicBool>,
    unfinished: Arc<Mutex<Vec<Unfinished>>>,
}

impl Interrupt {
    /// From now on Ctrl-C ends the run at the end of its step; pressed again, the program at once.
    pub(crate) fn listen() -> Result<Self, Failure> {
        let pressed = Arc::new(AtomicBool::new(false));
        let unfinished: Arc<Mutex<Vec<Unfinished>>> = Arc::default();
        let (own, files) = (Arc::clone(&pressed), Arc::clone(&unfinished));
        let listens = ctrlc::set_handler(move || {
            if !own.swap(true, Ordering::SeqCst) {
                return failure::remark("note: the run stops at the end of its step; Ctrl-C again stops it at once");
            }
            for file in files.lock().unwrap_or_else(PoisonError::into_inner).iter() {
                if std::fs::rename(&file.temporary, &file.partial).is_ok() {
                    failure::note(&format!("note: what was computed is in {}", file.partial.display()));
                }
            }
            process::exit(i32::from(failure::INTERRUPTED));
        });
        listens.map_err(|error| Failure::InputOutput(format!("error: cannot listen to Ctrl-C: {error}")))?;
        Ok(Self { pressed, unfinished })
    }

    /// Files that a program which ends at once keeps under their partial names.
    pub(crate) fn keep(&self, files: Vec<Unfinished>) {
        *self.unfinished.lock().unwrap_or_else(PoisonError::into_inner) = files;
    }

    /// Whether it has.
    pub(crate) fn has_come(&self) -> bool {
        self.pressed.load(Ordering::SeqCst)
    }
}
