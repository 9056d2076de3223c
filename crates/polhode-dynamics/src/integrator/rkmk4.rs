//! The Runge-Kutta-Munthe-Kaas method of order 4: the classical method in the Lie algebra of rotations.
//!
//! The attitude within a step is `q exp(u)`, u a rotation vector in body axes that starts at zero, with
//!
//! ```text
//! u' = w + u x w / 2 + u x (u x w) / 12,    w = I^-1 R^T L
//! ```
//!
//! (the inverse of the differential of exp, cut where the classical method of order 4 no longer sees it). The attitude
//! is a rotation by construction and `|L|` is exact in free motion; position, velocity and L take the same stages.
//! Order 4; explicit, neither symplectic nor symmetric. Source: docs/REFERENCES.md, Munthe-Kaas 1998.

use super::IntegrationError;
use super::body_axes::exp;
use super::four_stages::{FourStageMap, FourStages, NODES, mean};
use super::lie_stage::{Stage, Vectors};
use super::loads::Load;
use super::one_step::{OneStep, Span, integrator_by_driver};
use crate::{BodyState, RigidBody};
use glam::DVec3;

/// The method.
#[derive(Debug)]
pub struct Rkmk4(OneStep<FourStageMap<Stages>>);

impl Rkmk4 {
    /// Without bodies until it is started.
    pub fn new() -> Self {
        Self(OneStep::new(FourStageMap::default()))
    }
}

impl Default for Rkmk4 {
    fn default() -> Self {
        Self::new()
    }
}

integrator_by_driver!(Rkmk4);

/// A stage and the rotation vector from the start to it.
#[derive(Debug, Clone, Copy)]
struct TurnedStage {
    stage: Stage,
    u: DVec3,
}

#[derive(Debug, Clone, Copy, Default)]
struct Rates {
    u: DVec3,
    vectors: Vectors,
}

#[derive(Debug)]
struct Stages;

/// The inverse of the differential of exp at u, applied to w, up to terms of third order in u.
#[inline]
fn inverse_differential(u: DVec3, w: DVec3) -> DVec3 {
    let c = u.cross(w);
    w + c * 0.5 + u.cross(c) * (1.0 / 12.0)
}

#[inline]
fn turned(start: &BodyState, rates: &Vectors, reach: f64, u: DVec3) -> Stage {
    Stage::reached(start, start.pose.rotation.quaternion() * exp(u), rates, reach)
}

impl FourStages for Stages {
    type Variables = BodyState;
    type Stage = TurnedStage;
    type Rates = Rates;

    #[inline]
    fn first(start: &BodyState) -> TurnedStage {
        TurnedStage { stage: Stage::first(start), u: DVec3::ZERO }
    }

    #[inline]
    fn stage<const INDEX: usize>(start: &BodyState, rates: &[Rates; 4], h: f64) -> TurnedStage {
        let (k, reach) = (&rates[INDEX - 1], NODES[INDEX] * h);
        let u = k.u * reach;
        TurnedStage { stage: turned(start, &k.vectors, reach, u), u }
    }

    #[inline]
    fn state(_body: &RigidBody, stage: &TurnedStage) -> BodyState {
        stage.stage.state()
    }

    #[inline]
    fn rates(body: &RigidBody, at: &TurnedStage, load: Load, _span: Span) -> Result<Rates, IntegrationError> {
        let w = at.stage.angular_velocity(body);
        Ok(Rates { u: inverse_differential(at.u, w), vectors: at.stage.rates(load) })
    }

    #[inline]
    fn end(start: &BodyState, rates: &[Rates; 4], h: f64) -> BodyState {
        turned(start, &Vectors::mean(rates, |k| &k.vectors), h, mean(rates, |k| k.u) * h).state()
    }
}
