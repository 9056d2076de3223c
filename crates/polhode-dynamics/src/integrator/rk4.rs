//! The classical Runge-Kutta method of order 4 on any representation of orientation: the thesis's integrator.
//!
//! `x' = v, v' = a`, the coordinates of the attitude by their own kinematic equation ([`super::orientation`]), and for
//! the rotation either `L' = torque` with `w = R I^-1 R^T L`, or the angular velocity itself by the thesis's equation 9
//! with a torque, `w' = R I^-1 R^T (torque - w x (R I R^T w))` (thesis 3.3, "Simulating Motion when in Free Fall",
//! which recommends L: in free motion one equation less, and L is exact). Order 4; a free rotation loses a little
//! energy. Source of the method: docs/REFERENCES.md, Hairer, Norsett and Wanner, II.1.

use super::four_stages::{FourStageMap, FourStages, NODES, mean};
use super::loads::Load;
use super::one_step::{OneStep, Span, Variables, integrator_by_driver};
use super::orientation::euler_angles::EulerAngles;
use super::orientation::matrix::{Matrix, MatrixUnorthogonalized};
use super::orientation::quaternion::{Quaternion, QuaternionThreeNumbers, QuaternionUnnormalized};
use super::orientation::{Frame, Orientation, Representation, RotationRate, Stored};
use super::saved::{NotItsVariables, Reader};
use super::{IntegrationError, Integrator};
use crate::{BodyState, RigidBody};
use glam::DVec3;
use polhode_spatial::Pose;
use std::fmt::Debug;
use std::marker::PhantomData;

/// The method.
#[derive(Debug)]
pub struct Rk4(Box<dyn Integrator>);

impl Rk4 {
    /// With the attitude and the rate of rotation as given; without bodies until it is started.
    pub fn new(orientation: Orientation, rate: RotationRate) -> Self {
        match rate {
            RotationRate::AngularMomentum => Self::with_rate::<Momentum>(orientation),
            RotationRate::AngularVelocity => Self::with_rate::<Velocity>(orientation),
        }
    }

    fn with_rate<V: RateVariable + 'static>(orientation: Orientation) -> Self {
        match orientation {
            Orientation::Quaternion => Self::of::<Quaternion, V>(),
            Orientation::QuaternionUnnormalized => Self::of::<QuaternionUnnormalized, V>(),
            Orientation::QuaternionThreeNumbers => Self::of::<QuaternionThreeNumbers, V>(),
            Orientation::Matrix => Self::of::<Matrix, V>(),
            Orientation::MatrixUnorthogonalized => Self::of::<MatrixUnorthogonalized, V>(),
            Orientation::EulerAngles => Self::of::<EulerAngles, V>(),
        }
    }

    fn of<R: Representation + 'static, V: RateVariable + 'static>() -> Self {
        Self(Box::new(OneStep::new(FourStageMap::<Stages<R, V>>::default())))
    }
}

impl Default for Rk4 {
    fn default() -> Self {
        Self::new(Orientation::default(), RotationRate::default())
    }
}

integrator_by_driver!(Rk4);

/// The variable that stands for the rate of rotation.
trait RateVariable: Copy + Debug + Send {
    fn of(body: &RigidBody, state: &BodyState) -> DVec3;
    /// Angular velocity in body axes, rad/s.
    fn in_body<F: Frame>(body: &RigidBody, frame: F, value: DVec3) -> DVec3;
    /// Rate of the variable under `torque`, where `in_body` is the angular velocity.
    fn rate<F: Frame>(body: &RigidBody, frame: F, in_body: DVec3, torque: DVec3) -> DVec3;
    fn angular_momentum<F: Frame>(body: &RigidBody, frame: F, value: DVec3) -> DVec3;
}

/// L, world axes.
#[derive(Debug, Clone, Copy)]
struct Momentum;

impl RateVariable for Momentum {
    fn of(_body: &RigidBody, state: &BodyState) -> DVec3 {
        state.angular_momentum
    }

    #[inline]
    fn in_body<F: Frame>(body: &RigidBody, frame: F, value: DVec3) -> DVec3 {
        body.inverse_inertia() * frame.to_body(value)
    }

    #[inline]
    fn rate<F: Frame>(_body: &RigidBody, _frame: F, _in_body: DVec3, torque: DVec3) -> DVec3 {
        torque
    }

    #[inline]
    fn angular_momentum<F: Frame>(_body: &RigidBody, _frame: F, value: DVec3) -> DVec3 {
        value
    }
}

/// w, world axes.
#[derive(Debug, Clone, Copy)]
struct Velocity;

impl RateVariable for Velocity {
    fn of(body: &RigidBody, state: &BodyState) -> DVec3 {
        body.angular_velocity(state)
    }

    #[inline]
    fn in_body<F: Frame>(_body: &RigidBody, frame: F, value: DVec3) -> DVec3 {
        frame.to_body(value)
    }

    #[inline]
    fn rate<F: Frame>(body: &RigidBody, frame: F, in_body: DVec3, torque: DVec3) -> DVec3 {
        let gyroscopic = in_body.cross(body.inertia() * in_body);
        frame.to_world(body.inverse_inertia() * (frame.to_body(torque) - gyroscopic))
    }

    #[inline]
    fn angular_momentum<F: Frame>(body: &RigidBody, frame: F, value: DVec3) -> DVec3 {
        frame.to_world(body.inertia() * frame.to_body(value))
    }
}

/// The variables of a body, or their rates.
#[derive(Debug, Clone, Copy)]
struct Coordinates<C, V> {
    orientation: C,
    rotation_rate: DVec3,
    position: DVec3,
    velocity: DVec3,
    variable: PhantomData<V>,
}

impl<C: Default, V> Default for Coordinates<C, V> {
    fn default() -> Self {
        let (zero, variable) = (DVec3::ZERO, PhantomData);
        Self { orientation: C::default(), rotation_rate: zero, position: zero, velocity: zero, variable }
    }
}

impl<C, V> Coordinates<C, V>
where
    C: Copy + std::ops::Add<Output = C> + std::ops::Mul<f64, Output = C>,
{
    /// These, `h` (s) along `rates`.
    #[inline]
    fn along(&self, rates: &Self, h: f64) -> Self {
        Self {
            orientation: self.orientation + rates.orientation * h,
            rotation_rate: self.rotation_rate + rates.rotation_rate * h,
            position: self.position + rates.position * h,
            velocity: self.velocity + rates.velocity * h,
            variable: PhantomData,
        }
    }
}

/// Coordinates that know their representation, which the numbers alone do not tell.
#[derive(Debug, Clone, Copy)]
struct Kept<R: Representation, V>(Coordinates<R::Coordinates, V>);

impl<R: Representation, V: RateVariable> Variables for Kept<R, V> {
    #[inline]
    fn of(body: &RigidBody, state: &BodyState) -> Self {
        Self(Coordinates {
            orientation: R::of(state.pose.rotation),
            rotation_rate: V::of(body, state),
            position: state.pose.translation,
            velocity: state.linear_velocity,
            variable: PhantomData,
        })
    }

    #[inline]
    fn state(&self, body: &RigidBody) -> BodyState {
        let kept = &self.0;
        let rotation = R::rotation(&kept.orientation);
        BodyState {
            pose: Pose::new(rotation, kept.position),
            linear_velocity: kept.velocity,
            angular_momentum: V::angular_momentum(body, rotation, kept.rotation_rate),
        }
    }

    #[inline]
    fn is_finite(&self) -> bool {
        let kept = &self.0;
        R::is_finite(&kept.orientation)
            && kept.rotation_rate.is_finite()
            && kept.position.is_finite()
            && kept.velocity.is_finite()
    }

    fn write(&self, numbers: &mut Vec<f64>) {
        let kept = &self.0;
        kept.orientation.write(numbers);
        numbers.extend([kept.rotation_rate, kept.position, kept.velocity].iter().flat_map(DVec3::to_array));
    }

    fn read(numbers: &mut Reader<'_>) -> Result<Self, NotItsVariables> {
        Ok(Self(Coordinates {
            orientation: R::Coordinates::read(numbers)?,
            rotation_rate: numbers.vector()?,
            position: numbers.vector()?,
            velocity: numbers.vector()?,
            variable: PhantomData,
        }))
    }
}

#[derive(Debug)]
struct Stages<R, V>(PhantomData<(R, V)>);

impl<R: Representation, V: RateVariable> FourStages for Stages<R, V> {
    type Variables = Kept<R, V>;
    type Stage = Kept<R, V>;
    type Rates = Coordinates<R::Coordinates, V>;

    #[inline]
    fn first(start: &Kept<R, V>) -> Kept<R, V> {
        *start
    }

    #[inline]
    fn stage<const INDEX: usize>(start: &Kept<R, V>, rates: &[Self::Rates; 4], h: f64) -> Kept<R, V> {
        Kept(start.0.along(&rates[INDEX - 1], NODES[INDEX] * h))
    }

    #[inline]
    fn state(body: &RigidBody, stage: &Kept<R, V>) -> BodyState {
        stage.state(body)
    }

    #[inline]
    fn rates(body: &RigidBody, stage: &Kept<R, V>, load: Load, span: Span) -> Result<Self::Rates, IntegrationError> {
        let at = &stage.0;
        let frame = R::frame(&at.orientation);
        let w = V::in_body(body, frame, at.rotation_rate);
        Ok(Coordinates {
            orientation: R::rate(&at.orientation, w, span)?,
            rotation_rate: V::rate(body, frame, w, load.torque),
            position: at.velocity,
            velocity: load.acceleration,
            variable: PhantomData,
        })
    }

    #[inline]
    fn end(start: &Kept<R, V>, rates: &[Self::Rates; 4], h: f64) -> Kept<R, V> {
        let mean = Coordinates {
            orientation: mean(rates, |k| k.orientation),
            rotation_rate: mean(rates, |k| k.rotation_rate),
            position: mean(rates, |k| k.position),
            velocity: mean(rates, |k| k.velocity),
            variable: PhantomData,
        };
        let mut end = start.0.along(&mean, h);
        end.orientation = R::settled(end.orientation);
        Kept(end)
    }
}
