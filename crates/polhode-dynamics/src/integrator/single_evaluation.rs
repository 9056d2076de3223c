//! Methods that evaluate the loads once per step, at its start: the Euler methods.

use super::IntegrationError;
use super::loads::{Load, Loads};
use super::one_step::{Span, StepMap};
use crate::{BodyState, FreeMotion, RigidBody};
use std::fmt::Debug;
use std::marker::PhantomData;

/// The step of one body under a constant load.
pub(crate) trait BodyStep: Debug + Send {
    /// The state after `h` (s).
    fn step(body: &RigidBody, state: &BodyState, load: Load, h: f64) -> BodyState;
}

/// The step of all bodies.
#[derive(Debug)]
pub(crate) struct SingleEvaluation<S> {
    loads: Loads,
    step: PhantomData<S>,
}

impl<S> Default for SingleEvaluation<S> {
    fn default() -> Self {
        Self { loads: Loads::default(), step: PhantomData }
    }
}

impl<S: BodyStep> StepMap for SingleEvaluation<S> {
    type Variables = BodyState;

    fn order(&self) -> u32 {
        1
    }

    fn advance(
        &mut self,
        motion: &FreeMotion<'_>,
        span: Span,
        from: &[BodyState],
        to: &mut [BodyState],
    ) -> Result<(), IntegrationError> {
        let loaded = motion.has_loads();
        if loaded {
            self.loads.evaluate(motion, span.t, from.iter().copied());
        }
        for (index, ((body, state), next)) in motion.bodies().iter().zip(from).zip(to).enumerate() {
            let load = if loaded { self.loads.on(motion, body, index) } else { Load::unloaded(motion, body) };
            *next = S::step(body, state, load, span.h);
        }
        Ok(())
    }
}
