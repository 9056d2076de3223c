//! Bodies under gravity and forces that stay the same over a step (thesis, equations 15 and 16).

use polhode_dynamics::free_fall::FreeFall;
use polhode_dynamics::state::{ANGULAR_MOMENTUM, LINEAR_VELOCITY, WIDTH, normalize};
use polhode_dynamics::{RigidBody, System};
use polhode_spatial::DVec3;
use std::convert::Infallible;

/// Force and moment about the centre of mass on one body, N and N m, world.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Load {
    pub(super) force: DVec3,
    pub(super) moment: DVec3,
}

/// Movable bodies, one after the other, each under its load.
#[derive(Debug)]
pub(super) struct LoadedBodies<'a> {
    bodies: &'a [RigidBody],
    loads: &'a [Load],
    free: FreeFall<'a>,
}

impl<'a> LoadedBodies<'a> {
    pub(super) fn new(bodies: &'a [RigidBody], loads: &'a [Load], gravity: DVec3) -> Self {
        Self { bodies, loads, free: FreeFall::new(bodies, gravity) }
    }
}

impl System for LoadedBodies<'_> {
    type Error = Infallible;

    fn dimension(&self) -> usize {
        self.free.dimension()
    }

    fn derivative(&mut self, t: f64, state: &[f64], rates: &mut [f64]) -> Result<(), Infallible> {
        self.free.derivative(t, state, rates)?;
        for ((body, load), rate) in self.bodies.iter().zip(self.loads).zip(rates.as_chunks_mut::<WIDTH>().0) {
            let acceleration = load.force * body.inverse_mass();
            for axis in 0..3 {
                rate[LINEAR_VELOCITY + axis] += acceleration[axis];
                rate[ANGULAR_MOMENTUM + axis] += load.moment[axis];
            }
        }
        Ok(())
    }

    fn normalize(&self, state: &mut [f64]) {
        normalize(state);
    }
}
