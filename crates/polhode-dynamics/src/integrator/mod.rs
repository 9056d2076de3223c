//! Integrators of free motion: one file per method, one trait, one state.
//!
//! | name | type | order | forces may depend on |
//! |---|---|---|---|
//! | `explicit-euler`, `semi-implicit-euler` | [`ExplicitEuler`], [`SemiImplicitEuler`] | 1 | anything |
//! | `implicit-gyroscopic` | [`ImplicitGyroscopic`] | 1 | anything |
//! | `rk4`, `rkmk4`, `cf4` | [`Rk4`], [`Rkmk4`], [`Cf4`] | 4 | anything |
//! | `splitting`, `splitting-4`, `splitting-6` | [`Splitting`] | 2, 4, 6 | poses, time |
//! | `moser-veselov`, `moser-veselov-4` | [`MoserVeselov`], [`MoserVeselov4`] | 2, 4 | poses, time |
//! | `implicit-midpoint` | [`ImplicitMidpoint`] | 2 | poses, time |
//! | `dop853` | [`AdaptiveDop853`] | 8, error-controlled | anything |
//! | `exact`, `exact-strang` | [`Exact`] | exact without forces, else 4, 2 | poses, time |
//! | `exact-adaptive` | [`AdaptiveExact`] | exact without forces, else 4, error-controlled | poses, time |
//!
//! [`Method`] knows them by name; [`event::locate`] finds when a function of the states changes its sign within the
//! last step of any of them.
//!
//! ```
//! use polhode_dynamics::integrator::{Method, MethodSettings, event};
//! use polhode_dynamics::{BodyState, DVec3, FreeMotion, Inertia, Mass, MassProperties, Pose, RigidBody};
//! let inertia = Inertia::from_diagonal(DVec3::new(1.0, 2.0, 3.0))?;
//! let bodies = [RigidBody::new(&MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, inertia))];
//! let motion = FreeMotion::new(&bodies, DVec3::NEG_Z * 9.81, &[]);
//! let mut method = Method::from_name("exact")?.build(&MethodSettings::default());
//! method.start(&motion, 0.0, &[BodyState::at_rest(Pose::from_translation(DVec3::Z))]);
//! method.step(&motion, 1.0)?;
//! let landing = event::locate(&mut *method, &motion, 0.0, &mut |_, states| states[0].pose.translation.z)?;
//! assert!((landing.unwrap() - f64::sqrt(2.0 / 9.81)).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | module | holds |
//! |---|---|
//! | `method` | the methods by name, as a scene or a comparison asks for them |
//! | `one_step` | what all methods of fixed step share |
//! | `loads` | what acts on each body at one stage of a method |
//! | `event` | location of events within a step |
//! | `within_step` | what every method checks before it shows states within its last step |
//! | `saved` | the variables that a method goes on from, as numbers |
//! | `single_evaluation` | methods that evaluate the loads once a step, at its start |
//! | `four_stages` | methods of four stages after the classical Runge-Kutta method |
//! | `lie_stage` | the stages of methods on the group of rotations |
//! | `orientation` | representations of orientation that the classical Runge-Kutta method integrates |
//! | `split_step` | methods that split the motion into kicks and drifts |
//! | `composition` | compositions of a method of order 2 into methods of higher order |
//! | `drift_kick` | the two halves of free motion that are solved exactly |
//! | `blanes_moan` | Blanes and Moan's composition of order 4 with six kicks |
//! | `body_axes` | small formulae in body axes that several methods share |
//! | `cayley_equation` | the equation of implicit maps of free rotation whose turn is Cayley's map of a vector |

pub mod adaptive_exact;
mod blanes_moan;
mod body_axes;
mod cayley_equation;
pub mod cf4;
mod composition;
pub mod dop853;
mod drift_kick;
pub mod event;
pub mod exact;
pub mod explicit_euler;
mod four_stages;
pub mod implicit_gyroscopic;
pub mod implicit_midpoint;
mod lie_stage;
mod loads;
pub mod method;
pub mod moser_veselov;
mod one_step;
pub mod orientation;
pub mod rk4;
pub mod rkmk4;
mod saved;
pub mod semi_implicit_euler;
mod single_evaluation;
mod split_step;
pub mod splitting;
mod within_step;

pub use adaptive_exact::AdaptiveExact;
pub use cf4::Cf4;
pub use dop853::{AdaptiveDop853, Tolerance};
pub use exact::Exact;
pub use explicit_euler::ExplicitEuler;
pub use implicit_gyroscopic::ImplicitGyroscopic;
pub use implicit_midpoint::ImplicitMidpoint;
pub use method::{Method, MethodSettings, UnknownMethod};
pub use moser_veselov::{MoserVeselov, MoserVeselov4};
pub use orientation::{Orientation, RotationRate};
pub use rk4::Rk4;
pub use rkmk4::Rkmk4;
pub use saved::NotItsVariables;
pub use semi_implicit_euler::SemiImplicitEuler;
pub use splitting::{Splitting, Splitting4};

use crate::{BodyState, FreeMotion};
use std::fmt::Debug;

/// Steps within one of the caller, or attempts at them; some seconds of work. Guards against waiting for ever near a
/// singularity.
const MOST_STEPS: u32 = 1 << 21;

/// A one-step method for free bodies.
///
/// The method keeps its own variables from step to step (a matrix that has drifted from a rotation, say, is what it
/// goes on from); [`Integrator::states`] shows them as states of bodies. It must be given the same motion at every
/// step, and started anew when bodies, gravity or fields have changed.
pub trait Integrator: Debug + Send {
    /// Order of convergence of the states at a fixed time.
    fn order(&self) -> u32;

    /// Sets the states, at `t` (s), that the next step starts from.
    fn start(&mut self, motion: &FreeMotion<'_>, t: f64, states: &[BodyState]);

    /// Advances by `h` (s).
    ///
    /// # Errors
    /// See [`IntegrationError`]; the states are then those before the step.
    fn step(&mut self, motion: &FreeMotion<'_>, h: f64) -> Result<(), IntegrationError>;

    /// Time reached, s.
    fn time(&self) -> f64;

    /// States at [`Integrator::time`].
    fn states(&self) -> &[BodyState];

    /// Parts that the last step was made of, one after the other and of one length.
    fn inner_steps(&self) -> u32 {
        1
    }

    /// Estimated error of the last step in units of what the tolerance allows, of methods that control it.
    fn step_error(&self) -> Option<f64> {
        None
    }

    /// Writes the states at `t` within the last step, to the method's own order: the method's own step of that length
    /// from the start of the last one, unless it has a cheaper interpolation of its order.
    ///
    /// # Errors
    /// See [`IntegrationError`].
    fn states_within(
        &mut self,
        motion: &FreeMotion<'_>,
        t: f64,
        states: &mut [BodyState],
    ) -> Result<(), IntegrationError>;

    /// The method's own variables, of the start of the last step and of the time reached: what [`Integrator::restore`]
    /// goes on from with the same bits.
    fn save(&self) -> Vec<f64>;

    /// Goes on from variables that a method of the same kind and settings has saved for the bodies of this motion.
    ///
    /// # Errors
    /// When the numbers are not such variables; nothing has changed then.
    fn restore(&mut self, motion: &FreeMotion<'_>, saved: &[f64]) -> Result<(), NotItsVariables>;
}

/// Why a step could not be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum IntegrationError {
    /// A state has become NaN or infinite.
    #[error("a state became NaN or infinite in the step from t = {t} s: shorten the step, or check masses and fields")]
    NotFinite {
        /// Start of the step, s.
        t: f64,
    },
    /// The method splits forces from motion, which a force that depends on velocities does not allow.
    #[error("{method} cannot integrate a field whose force depends on velocities (drag, damper): use dop853 or rk4")]
    VelocityDependentField {
        /// Name of the method.
        method: &'static str,
    },
    /// An implicit equation was not solved.
    #[error(
        "the implicit equation of the step changed by {change:e} (relative) after {iterations} iterations: shorten the \
         step"
    )]
    NoConvergence {
        /// Iterations made.
        iterations: usize,
        /// Relative change in the last one.
        change: f64,
    },
    /// Error control asks for a step that no longer advances the time.
    #[error(
        "at t = {t} s the tolerance asks for steps below {smallest_s:e} s: loosen it, or look for a singular force"
    )]
    StepTooSmall {
        /// Time reached, s.
        t: f64,
        /// The shortest step allowed, s.
        smallest_s: f64,
    },
    /// The coordinates of the attitude are singular there.
    #[error(
        "the attitude came within {distance:e} rad of a singularity of its coordinates at t = {t} s, where steps of \
         this length need {limit:e} rad: use quaternions, or a shorter step"
    )]
    SingularAttitude {
        /// Time, s.
        t: f64,
        /// Distance from the singularity, rad.
        distance: f64,
        /// The smallest distance that the step allows, rad.
        limit: f64,
    },
    /// The states do not belong to the bodies.
    #[error("{states} states for {bodies} bodies: call start with one state per body, in their order")]
    StateCount {
        /// States given.
        states: usize,
        /// Bodies of the motion.
        bodies: usize,
    },
    /// A time outside the last step was asked for.
    #[error("t = {t} s lies outside the last step, from {from} s to {to} s")]
    OutsideStep {
        /// Time asked for, s.
        t: f64,
        /// Start of the last step, s.
        from: f64,
        /// End of the last step, s.
        to: f64,
    },
}
