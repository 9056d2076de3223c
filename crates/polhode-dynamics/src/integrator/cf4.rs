//! The commutator-free method of order 4 of Celledoni, Marthinsen and Owren.
//!
//! With `k = I^-1 R^T L` at each stage (body axes), exp of rotation vectors, and stages reached from the start q:
//!
//! ```text
//! q,  q exp(h k1/2),  q exp(h k2/2),  q exp(h k1/2) exp(h (k3 - k1/2))
//! q+ = q exp(h (3 k1 + 2 k2 + 2 k3 - k4)/12) exp(h (-k1 + 2 k2 + 2 k3 + 3 k4)/12)
//! ```
//!
//! No commutators and no series: the attitude is a rotation by construction and `|L|` is exact in free motion.
//! In a vector space these exponentials are sums and the method is the classical one, which is what position, velocity
//! and L take. Order 4. Source: docs/REFERENCES.md, Celledoni, Marthinsen and Owren 2003.

use super::IntegrationError;
use super::body_axes::exp;
use super::four_stages::{FourStageMap, FourStages, NODES};
use super::lie_stage::{Stage, Vectors};
use super::loads::Load;
use super::one_step::{OneStep, Span, integrator_by_driver};
use crate::{BodyState, RigidBody};
use glam::{DQuat, DVec3};

/// The method.
#[derive(Debug)]
pub struct Cf4(OneStep<FourStageMap<Stages>>);

impl Cf4 {
    /// Without bodies until it is started.
    pub fn new() -> Self {
        Self(OneStep::new(FourStageMap::default()))
    }
}

impl Default for Cf4 {
    fn default() -> Self {
        Self::new()
    }
}

integrator_by_driver!(Cf4);

#[derive(Debug, Clone, Copy, Default)]
struct Rates {
    w: DVec3,
    /// Attitude of the stage, from which the last stage goes on.
    attitude: DQuat,
    vectors: Vectors,
}

#[derive(Debug)]
struct Stages;

impl FourStages for Stages {
    type Variables = BodyState;
    type Stage = Stage;
    type Rates = Rates;

    #[inline]
    fn first(start: &BodyState) -> Stage {
        Stage::first(start)
    }

    #[inline]
    fn stage<const INDEX: usize>(start: &BodyState, rates: &[Rates; 4], h: f64) -> Stage {
        let (k, reach) = (&rates[INDEX - 1], NODES[INDEX] * h);
        let attitude = if INDEX == 3 {
            rates[1].attitude * exp((k.w - rates[0].w * 0.5) * h)
        } else {
            start.pose.rotation.quaternion() * exp(k.w * reach)
        };
        Stage::reached(start, attitude, &k.vectors, reach)
    }

    #[inline]
    fn state(_body: &RigidBody, stage: &Stage) -> BodyState {
        stage.state()
    }

    #[inline]
    fn rates(body: &RigidBody, stage: &Stage, load: Load, _span: Span) -> Result<Rates, IntegrationError> {
        Ok(Rates { w: stage.angular_velocity(body), attitude: stage.attitude, vectors: stage.rates(load) })
    }

    #[inline]
    fn end(start: &BodyState, rates: &[Rates; 4], h: f64) -> BodyState {
        let [a, b, c, d] = [rates[0].w, rates[1].w, rates[2].w, rates[3].w];
        let (middle, twelfth) = ((b + c) * 2.0, h / 12.0);
        let (first, second) = ((a * 3.0 + middle - d) * twelfth, (d * 3.0 + middle - a) * twelfth);
        let attitude = start.pose.rotation.quaternion() * (exp(first) * exp(second));
        Stage::reached(start, attitude, &Vectors::mean(rates, |k| &k.vectors), h).state()
    }
}
