//! Methods that split the motion into kicks and drifts, each with its own map of free rotation.
//!
//! As in [`super::exact`], a kick changes momenta under the loads at the present poses, and a drift is motion without
//! loads: `x += h v + h^2 g/2`, `v += h g`, exactly, and a turn of the attitude by the method's map, in which L stays
//! as it is to the last bit. The composition gives the order. Without loads a kick does nothing and the turns alone are
//! composed. Fields whose force depends on velocities cannot be split so; they are refused.

use super::IntegrationError;
use super::body_axes::to_body;
use super::drift_kick::{Stages, kick};
use super::one_step::{Span, StepMap};
use crate::field::{Dependence, Wrench};
use crate::{BodyState, FreeMotion, RigidBody};
use glam::{DQuat, DVec3};
use polhode_spatial::Rotation;
use std::fmt::Debug;
use std::marker::PhantomData;

/// A map of free rotation.
pub(crate) trait Turn: Debug + Send {
    /// The rotation `R_P0P1` over `h` (s, not zero) of a body with the principal `moments` (kg m^2) and the angular
    /// momentum `p` along its principal axes (kg m^2/s).
    fn turn(moments: DVec3, p: DVec3, h: f64) -> Result<DQuat, IntegrationError>;
}

/// The step of all bodies.
#[derive(Debug)]
pub(crate) struct SplitStep<T> {
    method: &'static str,
    order: u32,
    /// Fractions of the drifts where nothing acts.
    unloaded: &'static [f64],
    loaded: &'static Stages,
    wrenches: Vec<Wrench>,
    turn: PhantomData<T>,
}

impl<T: Turn> SplitStep<T> {
    /// `method` is the name that errors give.
    pub(crate) const fn new(
        method: &'static str,
        order: u32,
        unloaded: &'static [f64],
        loaded: &'static Stages,
    ) -> Self {
        Self { method, order, unloaded, loaded, wrenches: Vec::new(), turn: PhantomData }
    }
}

/// Motion without loads over `h` (s).
#[inline]
fn drift<T: Turn>(body: &RigidBody, gravity: DVec3, state: &mut BodyState, h: f64) -> Result<(), IntegrationError> {
    let gain = gravity * h;
    state.pose.translation += (state.linear_velocity + gain * 0.5) * h;
    state.linear_velocity += gain;
    let q = state.pose.rotation.quaternion();
    let p = to_body(q, state.angular_momentum);
    let axes = body.axes();
    // Most bodies are given along their principal axes, where the turn needs no change of axes.
    let turn = if axes == Rotation::IDENTITY {
        T::turn(body.moments(), p, h)?
    } else {
        let turn = T::turn(body.moments(), axes.inverse_rotate(p), h)?;
        let v = axes.rotate(DVec3::new(turn.x, turn.y, turn.z));
        DQuat::from_xyzw(v.x, v.y, v.z, turn.w)
    };
    state.pose.rotation = Rotation::renormalized(q * turn);
    Ok(())
}

impl<T: Turn> StepMap for SplitStep<T> {
    type Variables = BodyState;

    fn order(&self) -> u32 {
        self.order
    }

    fn advance(
        &mut self,
        motion: &FreeMotion<'_>,
        span: Span,
        from: &[BodyState],
        to: &mut [BodyState],
    ) -> Result<(), IntegrationError> {
        let Span { t, h } = span;
        if !motion.has_loads() {
            for ((body, start), end) in motion.bodies().iter().zip(from).zip(to) {
                let mut state = *start;
                for fraction in self.unloaded {
                    drift::<T>(body, motion.free_acceleration(body), &mut state, fraction * h)?;
                }
                *end = state;
            }
            return Ok(());
        }
        if motion.dependence() == Dependence::Velocities {
            return Err(IntegrationError::VelocityDependentField { method: self.method });
        }
        to.copy_from_slice(from);
        let mut reached = 0.0;
        for &(drifted, kicked) in self.loaded {
            if drifted != 0.0 {
                reached += drifted;
                for (body, state) in motion.bodies().iter().zip(&mut *to) {
                    drift::<T>(body, motion.free_acceleration(body), state, drifted * h)?;
                }
            }
            if kicked != 0.0 {
                kick(motion, t + reached * h, kicked * h, to, &mut self.wrenches);
            }
        }
        Ok(())
    }
}
