//! Methods of four stages after the classical Runge-Kutta method: rates at t, twice at t + h/2, at t + h.
//!
//! The loads are evaluated at the states of all bodies at each stage. A motion without loads is integrated body by
//! body, which keeps a body's stages in registers; the numbers are the same.

use super::IntegrationError;
use super::loads::{Load, Loads};
use super::one_step::{Span, StepMap, Variables};
use crate::{BodyState, FreeMotion, RigidBody};
use std::fmt::Debug;

/// Times of the stages, in steps: also how far the rates of the stage before reach to a stage.
pub(crate) const NODES: [f64; 4] = [0.0, 0.5, 0.5, 1.0];

/// `(k1 + 2 k2 + 2 k3 + k4)/6`, the weights of the classical method, of a part of the rates.
#[inline]
pub(crate) fn mean<R, T>(rates: &[R; 4], part: impl Fn(&R) -> T) -> T
where
    T: std::ops::Add<Output = T> + std::ops::Mul<f64, Output = T>,
{
    let [a, b, c, d] = rates;
    (part(a) + (part(b) + part(c)) * 2.0 + part(d)) * (1.0 / 6.0)
}

/// The stages of one body.
pub(crate) trait FourStages: Debug + Send {
    /// What is kept from step to step.
    type Variables: Variables;
    /// Where rates are evaluated.
    type Stage: Copy + Debug + Send;
    /// Rates at a stage.
    type Rates: Copy + Debug + Default + Send;

    /// The first stage: the start.
    fn first(start: &Self::Variables) -> Self::Stage;

    /// The stage of number `INDEX` (1 to 3) from the rates of those before.
    fn stage<const INDEX: usize>(start: &Self::Variables, rates: &[Self::Rates; 4], h: f64) -> Self::Stage;

    /// The state at a stage.
    fn state(body: &RigidBody, stage: &Self::Stage) -> BodyState;

    /// The rates at a stage. The span is the step's, to judge them and to report its start.
    fn rates(body: &RigidBody, stage: &Self::Stage, load: Load, span: Span) -> Result<Self::Rates, IntegrationError>;

    /// The variables at the end of the step.
    fn end(start: &Self::Variables, rates: &[Self::Rates; 4], h: f64) -> Self::Variables;
}

/// The step of all bodies.
#[derive(Debug)]
pub(crate) struct FourStageMap<S: FourStages> {
    stages: Vec<S::Stage>,
    rates: Vec<[S::Rates; 4]>,
    loads: Loads,
}

impl<S: FourStages> Default for FourStageMap<S> {
    fn default() -> Self {
        Self { stages: Vec::new(), rates: Vec::new(), loads: Loads::default() }
    }
}

impl<S: FourStages> FourStageMap<S> {
    fn advance_loaded(
        &mut self,
        motion: &FreeMotion<'_>,
        span: Span,
        from: &[S::Variables],
        to: &mut [S::Variables],
    ) -> Result<(), IntegrationError> {
        let Span { t, h } = span;
        self.rates.clear();
        self.rates.resize(from.len(), [S::Rates::default(); 4]);
        for (index, node) in NODES.into_iter().enumerate() {
            self.stages.clear();
            self.stages.extend(from.iter().zip(&self.rates).map(|(start, k)| match index {
                0 => S::first(start),
                1 => S::stage::<1>(start, k, h),
                2 => S::stage::<2>(start, k, h),
                _ => S::stage::<3>(start, k, h),
            }));
            let states = motion.bodies().iter().zip(&self.stages).map(|(body, stage)| S::state(body, stage));
            self.loads.evaluate(motion, t + node * h, states);
            let stages = motion.bodies().iter().zip(&self.stages).zip(&mut self.rates);
            for (body_index, ((body, stage), k)) in stages.enumerate() {
                k[index] = S::rates(body, stage, self.loads.on(motion, body, body_index), span)?;
            }
        }
        for ((start, end), k) in from.iter().zip(to).zip(&self.rates) {
            *end = S::end(start, k, h);
        }
        Ok(())
    }
}

impl<S: FourStages> StepMap for FourStageMap<S> {
    type Variables = S::Variables;

    fn order(&self) -> u32 {
        4
    }

    fn advance(
        &mut self,
        motion: &FreeMotion<'_>,
        span: Span,
        from: &[S::Variables],
        to: &mut [S::Variables],
    ) -> Result<(), IntegrationError> {
        if motion.has_loads() {
            return self.advance_loaded(motion, span, from, to);
        }
        let h = span.h;
        for ((body, start), end) in motion.bodies().iter().zip(from).zip(to) {
            let load = Load::unloaded(motion, body);
            let mut k = [S::Rates::default(); 4];
            k[0] = S::rates(body, &S::first(start), load, span)?;
            k[1] = S::rates(body, &S::stage::<1>(start, &k, h), load, span)?;
            k[2] = S::rates(body, &S::stage::<2>(start, &k, h), load, span)?;
            k[3] = S::rates(body, &S::stage::<3>(start, &k, h), load, span)?;
            *end = S::end(start, &k, h);
        }
        Ok(())
    }
}
