//! The methods by name, as a scene or a comparison asks for them.

use super::dop853::Tolerance;
use super::{
    AdaptiveDop853, AdaptiveExact, Cf4, Exact, ExplicitEuler, ImplicitGyroscopic, ImplicitMidpoint, Integrator,
    MoserVeselov, MoserVeselov4, Orientation, Rk4, Rkmk4, RotationRate, SemiImplicitEuler, Splitting, Splitting4,
};
use crate::field::Dependence;
use thiserror::Error;

/// A method of free motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Method {
    /// [`ExplicitEuler`], order 1.
    ExplicitEuler,
    /// [`SemiImplicitEuler`], order 1.
    SemiImplicitEuler,
    /// [`ImplicitGyroscopic`], order 1.
    ImplicitGyroscopic,
    /// [`Rk4`], order 4, the thesis's.
    Rk4,
    /// [`Rkmk4`], order 4.
    Rkmk4,
    /// [`Cf4`], order 4.
    Cf4,
    /// [`Splitting`], order 2.
    Splitting,
    /// [`Splitting::of_order_4`].
    Splitting4,
    /// [`Splitting::of_order_6`].
    Splitting6,
    /// [`MoserVeselov`], order 2.
    MoserVeselov,
    /// [`MoserVeselov4`], order 4 in free motion.
    MoserVeselov4,
    /// [`ImplicitMidpoint`], order 2.
    ImplicitMidpoint,
    /// [`AdaptiveDop853`], order 8, error-controlled.
    Dop853,
    /// [`Exact::blanes_moan`]: exact in free motion, order 4 under forces.
    Exact,
    /// [`Exact::strang`]: exact in free motion, order 2 under forces.
    ExactStrang,
    /// [`AdaptiveExact`]: exact in free motion, order 4 under forces, error-controlled.
    ExactAdaptive,
}

/// What some methods need to know beside their name; the others do not read it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MethodSettings {
    /// Of [`Method::Dop853`] and [`Method::ExactAdaptive`].
    pub tolerance: Tolerance,
    /// Coordinates of [`Method::Rk4`].
    pub orientation: Orientation,
    /// Variable of rotation of [`Method::Rk4`].
    pub rotation_rate: RotationRate,
    /// Composition of [`Method::Splitting4`].
    pub splitting_4: Splitting4,
}

/// A name that no method has.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("unknown integrator {0:?}: one of {names}", names = Method::ALL.map(Method::name).join(", "))]
pub struct UnknownMethod(pub String);

impl Method {
    /// All methods, from the crudest to the most accurate of each kind.
    pub const ALL: [Self; 16] = [
        Self::ExplicitEuler,
        Self::SemiImplicitEuler,
        Self::ImplicitGyroscopic,
        Self::Rk4,
        Self::Rkmk4,
        Self::Cf4,
        Self::Splitting,
        Self::Splitting4,
        Self::Splitting6,
        Self::MoserVeselov,
        Self::MoserVeselov4,
        Self::ImplicitMidpoint,
        Self::Dop853,
        Self::Exact,
        Self::ExactStrang,
        Self::ExactAdaptive,
    ];

    /// Its name in scene files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::ExplicitEuler => "explicit-euler",
            Self::SemiImplicitEuler => "semi-implicit-euler",
            Self::ImplicitGyroscopic => "implicit-gyroscopic",
            Self::Rk4 => "rk4",
            Self::Rkmk4 => "rkmk4",
            Self::Cf4 => "cf4",
            Self::Splitting => "splitting",
            Self::Splitting4 => "splitting-4",
            Self::Splitting6 => "splitting-6",
            Self::MoserVeselov => "moser-veselov",
            Self::MoserVeselov4 => "moser-veselov-4",
            Self::ImplicitMidpoint => "implicit-midpoint",
            Self::Dop853 => "dop853",
            Self::Exact => "exact",
            Self::ExactStrang => "exact-strang",
            Self::ExactAdaptive => "exact-adaptive",
        }
    }

    /// The method of that name.
    ///
    /// # Errors
    /// When there is none.
    pub fn from_name(name: &str) -> Result<Self, UnknownMethod> {
        let known = Self::ALL.into_iter().find(|method| method.name() == name);
        known.ok_or_else(|| UnknownMethod(name.to_owned()))
    }

    /// Order of convergence, as [`Integrator::order`].
    pub fn order(self) -> u32 {
        self.build(&MethodSettings::default()).order()
    }

    /// Whether a motion without loads is exact, whatever the step.
    pub const fn is_exact_without_loads(self) -> bool {
        matches!(self, Self::Exact | Self::ExactStrang | Self::ExactAdaptive)
    }

    /// Whether a tolerance, not the step, decides the error.
    pub const fn controls_error(self) -> bool {
        matches!(self, Self::Dop853 | Self::ExactAdaptive)
    }

    /// Whether the method can integrate forces that depend on this; it refuses the others with
    /// [`super::IntegrationError::VelocityDependentField`].
    pub const fn takes(self, dependence: Dependence) -> bool {
        match dependence {
            Dependence::Poses | Dependence::PosesAndTime => true,
            Dependence::Velocities => matches!(
                self,
                Self::ExplicitEuler
                    | Self::SemiImplicitEuler
                    | Self::ImplicitGyroscopic
                    | Self::Rk4
                    | Self::Rkmk4
                    | Self::Cf4
                    | Self::Dop853
            ),
        }
    }

    /// The integrator, to be started with states.
    pub fn build(self, settings: &MethodSettings) -> Box<dyn Integrator> {
        match self {
            Self::ExplicitEuler => Box::new(ExplicitEuler::new()),
            Self::SemiImplicitEuler => Box::new(SemiImplicitEuler::new()),
            Self::ImplicitGyroscopic => Box::new(ImplicitGyroscopic::new()),
            Self::Rk4 => Box::new(Rk4::new(settings.orientation, settings.rotation_rate)),
            Self::Rkmk4 => Box::new(Rkmk4::new()),
            Self::Cf4 => Box::new(Cf4::new()),
            Self::Splitting => Box::new(Splitting::new()),
            Self::Splitting4 => Box::new(Splitting::of_order_4(settings.splitting_4)),
            Self::Splitting6 => Box::new(Splitting::of_order_6()),
            Self::MoserVeselov => Box::new(MoserVeselov::new()),
            Self::MoserVeselov4 => Box::new(MoserVeselov4::new()),
            Self::ImplicitMidpoint => Box::new(ImplicitMidpoint::new()),
            Self::Dop853 => Box::new(AdaptiveDop853::new(settings.tolerance)),
            Self::Exact => Box::new(Exact::blanes_moan()),
            Self::ExactStrang => Box::new(Exact::strang()),
            Self::ExactAdaptive => Box::new(AdaptiveExact::new(settings.tolerance)),
        }
    }
}

impl std::fmt::Display for Method {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl std::str::FromStr for Method {
    type Err = UnknownMethod;

    fn from_str(name: &str) -> Result<Self, UnknownMethod> {
        Self::from_name(name)
    }
}
