//! Who is told of a run while it goes on, and when it stops.

use crate::interrupt::Interrupt;
use crate::progress::Progress;
use polhode::{BodyError, BodySample, ContactSample, Energy, Event, Flow, Frame, JointSample, Observer};

/// Tells all that a run is watched by, shows progress, and stops the run at Ctrl-C, SIGTERM or when a checkpoint is
/// due.
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
        self.bar.happened();
        self.observers.iter_mut().for_each(|observer| observer.event(event));
    }

    fn wants_frames(&self) -> bool {
        self.observers.iter().any(|observer| observer.wants_frames())
    }

    fn frame(&mut self, frame: &Frame) {
        self.observers.iter_mut().for_each(|observer| observer.frame(frame));
    }

    fn wants_joints(&self) -> bool {
        self.observers.iter().any(|observer| observer.wants_joints())
    }

    fn joints(&mut self, t: f64, joints: &[JointSample]) {
        self.observers.iter_mut().for_each(|observer| observer.joints(t, joints));
    }

    fn wants_contacts(&self) -> bool {
        self.observers.iter().any(|observer| observer.wants_contacts())
    }

    fn contacts(&mut self, t: f64, contacts: &[ContactSample]) {
        self.observers.iter_mut().for_each(|observer| observer.contacts(t, contacts));
    }

    fn wants_energies(&self) -> bool {
        self.observers.iter().any(|observer| observer.wants_energies())
    }

    fn energy(&mut self, t: f64, energy: &Energy) {
        self.observers.iter_mut().for_each(|observer| observer.energy(t, energy));
    }

    fn wants_errors(&self) -> bool {
        self.observers.iter().any(|observer| observer.wants_errors())
    }

    fn errors(&mut self, t: f64, errors: Option<&[BodyError]>) {
        self.observers.iter_mut().for_each(|observer| observer.errors(t, errors));
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
