//! Who is told of a run while it goes on, and when it stops.

use crate::failure::Failure;
use indicatif::{ProgressBar, ProgressStyle};
use polhode::{BodySample, Event, Flow, Frame, Observer};
use std::io::IsTerminal;
use std::process;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Tells all that a run is watched by, shows progress, and stops the run at Ctrl-C or when a checkpoint is due.
pub(crate) struct Watch<'a> {
    /// Files and pictures that are written.
    pub(crate) observers: Vec<&'a mut dyn Observer>,
    pub(crate) bar: &'a Bar,
    pub(crate) interrupt: &'a Interrupt,
    /// When the run stops next to be kept, s.
    pub(crate) stop_s: f64,
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
        let is_over = t >= self.stop_s || self.interrupt.has_come();
        // All are told of the step at which the run stops: plots are of every step.
        let flows: Vec<Flow> = self.observers.iter_mut().map(|observer| observer.progress(t)).collect();
        if is_over || flows.contains(&Flow::Stop) { Flow::Stop } else { Flow::Continue }
    }
}

/// Whether Ctrl-C has been pressed.
pub(crate) struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// From now on Ctrl-C ends the run at the end of its step; pressed again, the program at once.
    pub(crate) fn listen() -> Result<Self, Failure> {
        let pressed = Arc::new(AtomicBool::new(false));
        let own = Arc::clone(&pressed);
        let listens = ctrlc::set_handler(move || {
            if own.swap(true, Ordering::SeqCst) {
                process::exit(i32::from(crate::failure::INTERRUPTED));
            }
        });
        listens.map_err(|error| Failure::InputOutput(format!("error: cannot listen to Ctrl-C: {error}")))?;
        Ok(Self(pressed))
    }

    /// Whether it has.
    pub(crate) fn has_come(&self) -> bool {
        self.0.load(Ordering::SeqCst)
    }
}

/// Parts that the bar divides the duration into.
const PARTS: f64 = 1000.0;

/// A progress bar on stderr, when that is a terminal.
pub(crate) struct Bar {
    bar: Option<ProgressBar>,
    duration_s: f64,
}

impl Bar {
    pub(crate) fn new(duration_s: f64) -> Self {
        let bar = std::io::stderr().is_terminal().then(|| {
            let bar = ProgressBar::new(PARTS as u64);
            match ProgressStyle::with_template("{wide_bar} {msg} {elapsed} (eta {eta})") {
                Ok(style) => bar.with_style(style),
                Err(_) => bar,
            }
        });
        Self { bar, duration_s }
    }

    pub(crate) fn advance(&self, t: f64) {
        if let Some(bar) = &self.bar {
            bar.set_position((PARTS * t / self.duration_s) as u64);
            bar.set_message(format!("{t:.3} of {} s", self.duration_s));
        }
    }

    /// Writes a note to stderr, above the bar.
    pub(crate) fn note(&self, message: &str) {
        match &self.bar {
            Some(bar) => bar.suspend(|| crate::failure::note(message)),
            None => crate::failure::note(message),
        }
    }

    pub(crate) fn clear(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
