//! The estimated error of a run by fixed time steps.
//!
//! Every [`EVERY`]-th step, the first among them, is compared with two steps of half its length from the same states. The
//! differences of position and velocity estimate the error of the step, and each stands for the steps up to the next
//! comparison. Errors of velocity go on: in a step of h an error `dv` moves a body by `h dv`, until the body rests. The
//! sums of all magnitudes, without cancellation, are the estimate
//!
//! `e_x += |dx| + h e_v`, `e_v += |dv|`
//!
//! of each body, with its rotation times its size added to both.
//!
//! How it fails: an error that falls between two comparisons (one impact in a run) is not seen, and a motion that
//! amplifies errors (a die that is about to fall on one face or another) makes them larger than their sum. A motion that
//! damps errors makes them smaller.

use crate::interaction::overlap::displacement;
use crate::world::World;
use polhode_dynamics::BodyState;

/// How many steps a comparison stands for. It costs two steps, so that an estimate adds a fourth to a run.
pub(super) const EVERY: u64 = 8;

/// Sums of the estimated errors of one body.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct BodyError {
    /// m.
    pub(super) position: f64,
    /// m/s.
    pub(super) velocity: f64,
}

/// The estimated errors of all bodies.
#[derive(Debug, Clone, Default)]
pub(super) struct ErrorEstimate {
    pub(super) of_bodies: Vec<BodyError>,
}

impl ErrorEstimate {
    /// None yet, of this many bodies.
    pub(super) fn new(bodies: usize) -> Self {
        Self { of_bodies: vec![BodyError::default(); bodies] }
    }

    /// Takes up a body that has been added.
    pub(super) fn add_body(&mut self) {
        self.of_bodies.push(BodyError::default());
    }

    /// Lets errors of velocity move the bodies for `h` (s); those of bodies that rest now have ended.
    pub(super) fn go_on(&mut self, world: &World, states: &[BodyState], h: f64) {
        for (body, error) in self.of_bodies.iter_mut().enumerate() {
            error.position += h * error.velocity;
            if error.velocity > 0.0 && world.point_speed(states, body) == 0.0 {
                error.velocity = 0.0;
            }
        }
    }

    /// Adds the difference of one step of a body and the same in two halves.
    pub(super) fn compare(&mut self, world: &World, body: usize, whole: &BodyState, halves: &BodyState) {
        let [one, two] = [whole, halves].map(|state| world.velocity(body, state));
        let size = world.bodies[body].size;
        let faster = (one.linear - two.linear).length() + (one.angular - two.angular).length() * size;
        let error = &mut self.of_bodies[body];
        error.position += EVERY as f64 * displacement(world, body, whole, halves);
        error.velocity += EVERY as f64 * faster;
    }

    /// The largest error of position relative to the size of a body (of a body without a size in metres).
    pub(super) fn largest(&self, world: &World) -> f64 {
        let relative = |(body, error): (usize, &BodyError)| {
            let size = world.bodies[body].size;
            if size > 0.0 { error.position / size } else { error.position }
        };
        self.of_bodies.iter().enumerate().map(relative).fold(0.0, f64::max)
    }
}
