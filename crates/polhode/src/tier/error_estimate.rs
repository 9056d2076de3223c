//! The estimated error of a run by fixed steps, of the tiers `stepped` and `thesis`.
//!
//! Every [`EVERY`]-th step, the first among them, is compared with two steps of half its length from the same states.
//! The differences of position and velocity estimate the error of the step, and each stands for the steps up to the
//! next comparison. A step that is divided, because impacts or ends of slip are in it, is compared as well: its
//! difference is its own, and stands for itself. Errors of velocity go on: in a step of h an error `dv` moves a body by
//! `h dv`, until the body rests. The sums of all magnitudes, without cancellation, are the estimate
//!
//! `e_x += |dx| + h e_v`, `e_v += |dv|`
//!
//! of each body, with its rotation times its size added to both. In the tier `thesis`, where bodies overlap by what
//! they move until a contact is found, the deepest overlap of a body is added to its sum.
//!
//! How it fails: an error that falls between two comparisons (one impact of a heap) is not seen, and a motion that
//! amplifies errors (a die that is about to fall on one face or another) makes them larger than their sum. A motion
//! that damps errors makes them smaller.

use crate::model::{Model, tolerances};
use crate::snapshot::SnapshotError;
use crate::solve::overlap::displacement;
use polhode_dynamics::BodyState;

/// How many steps a comparison stands for. It costs two steps, so that an estimate adds a fourth to a run.
pub(crate) const EVERY: u64 = 8;

/// Sums of the estimated errors of one body.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct BodyError {
    /// m.
    position: f64,
    /// m/s.
    velocity: f64,
    /// The deepest overlap that no step has prevented, m.
    overlap: f64,
}

/// The estimated errors of all bodies.
#[derive(Debug, Clone, Default)]
pub(crate) struct ErrorEstimate {
    of_bodies: Vec<BodyError>,
}

impl ErrorEstimate {
    /// None yet, of this many bodies.
    pub(crate) fn new(bodies: usize) -> Self {
        Self { of_bodies: vec![BodyError::default(); bodies] }
    }

    /// Takes up a body that has been added.
    pub(crate) fn add_body(&mut self) {
        self.of_bodies.push(BodyError::default());
    }

    /// Lets errors of velocity move the bodies for `h` (s); those of bodies that rest now have ended.
    pub(crate) fn go_on(&mut self, model: &Model, states: &[BodyState], h: f64) {
        for (body, error) in self.of_bodies.iter_mut().enumerate() {
            error.position += h * error.velocity;
            if error.velocity > 0.0 && tolerances::point_speed(model, states, body) == 0.0 {
                error.velocity = 0.0;
            }
        }
    }

    /// Adds the difference of one step of a body and the same in two halves, which stands for so many steps.
    pub(crate) fn compare(
        &mut self,
        model: &Model,
        body: usize,
        (whole, halves): (&BodyState, &BodyState),
        stands_for: u64,
    ) {
        let [one, two] = [whole, halves].map(|state| model.velocity(body, state));
        let size = model.bodies[body].size;
        let faster = (one.linear - two.linear).length() + (one.angular - two.angular).length() * size;
        let error = &mut self.of_bodies[body];
        error.position += stands_for as f64 * displacement(model, body, whole, halves);
        error.velocity += stands_for as f64 * faster;
    }

    /// Records that two bodies overlap by this much (m).
    pub(crate) fn overlap(&mut self, (a, b): (usize, usize), depth_m: f64) {
        for body in [a, b] {
            let error = &mut self.of_bodies[body];
            error.overlap = error.overlap.max(depth_m);
        }
    }

    /// As plain data: position (m), velocity (m/s) and overlap (m) of each body.
    pub(crate) fn save(&self) -> Vec<[f64; 3]> {
        self.of_bodies.iter().map(|error| [error.position, error.velocity, error.overlap]).collect()
    }

    /// From such data of this many bodies.
    ///
    /// # Errors
    /// When they are of another number of bodies.
    pub(crate) fn restored(saved: &[[f64; 3]], bodies: usize) -> Result<Self, SnapshotError> {
        if saved.len() != bodies {
            return Err(SnapshotError::Invalid("it does not say the error of each body"));
        }
        let error = |&[position, velocity, overlap]: &[f64; 3]| BodyError { position, velocity, overlap };
        Ok(Self { of_bodies: saved.iter().map(error).collect() })
    }

    /// The largest error of position relative to the size of a body (of a body without a size in metres).
    pub(crate) fn largest(&self, model: &Model) -> f64 {
        let relative = |(body, error): (usize, &BodyError)| {
            let (size, error) = (model.bodies[body].size, error.position + error.overlap);
            if size > 0.0 { error / size } else { error }
        };
        let moving = self.of_bodies.iter().enumerate().filter(|(body, _)| model.bodies[*body].moves());
        moving.map(relative).fold(0.0, f64::max)
    }
}
