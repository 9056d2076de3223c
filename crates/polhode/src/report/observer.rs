//! Observers receive samples and events of a run.

pub use crate::report::body_sample::BodySample;
use crate::report::contact_sample::ContactSample;
use crate::report::energy::Energy;
use crate::report::event::Event;
use crate::report::frame::Frame;
use crate::report::joint_sample::JointSample;
use crate::report::run_error::BodyError;

/// Whether a run continues.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flow {
    /// Continue.
    Continue,
    /// Stop after this step; the report covers what has been computed.
    Stop,
}

/// Receives samples and events while a simulation runs.
pub trait Observer {
    /// All bodies at the time `t_s`, in the order of the scene. The first is t = 0, the last exactly the duration.
    fn sample(&mut self, t_s: f64, bodies: &[BodySample]);

    /// An event, in order of time.
    fn event(&mut self, event: &Event) {
        let _ = event;
    }

    /// Whether [`Observer::sample`] is called. Without samples, bodies in free flight are not evaluated between events.
    /// Their motion is the same to the last bit, but the scales of the ledgers (the largest energy and momentum so far)
    /// are then taken from fewer times.
    fn wants_samples(&self) -> bool {
        true
    }

    /// Whether [`Observer::frame`] is called. A frame costs a solve for the contact forces.
    fn wants_frames(&self) -> bool {
        false
    }

    /// Everything that a viewer draws at the time of a sample. It is called after that sample, if
    /// [`Observer::wants_frames`].
    fn frame(&mut self, frame: &Frame) {
        let _ = frame;
    }

    /// Whether [`Observer::joints`] is called. What joints bear costs a solve for the contact forces.
    fn wants_joints(&self) -> bool {
        false
    }

    /// The joints at the time of a sample, in the order of their handles. It is called after that sample, if
    /// [`Observer::wants_joints`].
    fn joints(&mut self, t_s: f64, joints: &[JointSample]) {
        let _ = (t_s, joints);
    }

    /// Whether [`Observer::contacts`] is called. It costs a solve for the contact forces, and a factorisation of all
    /// their rows.
    fn wants_contacts(&self) -> bool {
        false
    }

    /// The contacts that touch at the time of a sample, with their forces and what of them is not unique. It is called
    /// after that sample, if [`Observer::wants_contacts`].
    fn contacts(&mut self, t_s: f64, contacts: &[ContactSample]) {
        let _ = (t_s, contacts);
    }

    /// Whether [`Observer::energy`] is called.
    fn wants_energies(&self) -> bool {
        false
    }

    /// The energies at the time of a sample. It is called after that sample, if [`Observer::wants_energies`].
    fn energy(&mut self, t_s: f64, energy: &Energy) {
        let _ = (t_s, energy);
    }

    /// Whether [`Observer::errors`] is called.
    fn wants_errors(&self) -> bool {
        false
    }

    /// The estimated errors of the bodies at the time of a sample, in the order of the scene; none where they are not
    /// known. It is called once for every sample, in their order, if [`Observer::wants_errors`]: some samples later,
    /// when the run has been compared with its references at that time or after it, and at its end at the latest. A run
    /// that stops before its end owes the last ones to its observer when it goes on.
    fn errors(&mut self, t_s: f64, errors: Option<&[BodyError]>) {
        let _ = (t_s, errors);
    }

    /// Called after every step with the time reached, s.
    fn progress(&mut self, t_s: f64) -> Flow {
        let _ = t_s;
        Flow::Continue
    }
}

/// Keeps all samples and events in memory.
#[derive(Debug, Clone, Default)]
pub struct Recorder {
    /// Times of the samples, s.
    pub times_s: Vec<f64>,
    /// Samples: one row of all bodies per time.
    pub samples: Vec<Vec<BodySample>>,
    /// Estimated errors: one row of all bodies per time, as far as they are told; an empty one where none is known.
    pub errors: Vec<Vec<BodyError>>,
    /// Events.
    pub events: Vec<Event>,
}

impl Observer for Recorder {
    fn sample(&mut self, t_s: f64, bodies: &[BodySample]) {
        self.times_s.push(t_s);
        self.samples.push(bodies.to_vec());
    }

    fn event(&mut self, event: &Event) {
        self.events.push(*event);
    }

    fn wants_errors(&self) -> bool {
        true
    }

    fn errors(&mut self, _t_s: f64, errors: Option<&[BodyError]>) {
        self.errors.push(errors.unwrap_or_default().to_vec());
    }
}

/// An observer that wants no samples and ignores events.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unobserved;

impl Observer for Unobserved {
    fn sample(&mut self, _t_s: f64, _bodies: &[BodySample]) {}

    fn wants_samples(&self) -> bool {
        false
    }
}
