//! What acts along a freedom of a joint: limits, each of them a stop that bodies meet as they meet each other, a
//! spring, a damper, a motor, and dry friction.

use thiserror::Error;

/// A coordinate along which a joint leaves its bodies free.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Coordinate {
    /// The angle of the body about the axis, relative to the other body or the world, rad; zero at the start.
    Angle,
    /// The displacement of the body along the axis, m; zero at the start.
    Displacement,
    /// The distance of the two anchors, m.
    Distance,
}

impl Coordinate {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Angle, Self::Displacement, Self::Distance];

    /// Its name in scene files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Angle => "angle",
            Self::Displacement => "displacement",
            Self::Distance => "distance",
        }
    }

    /// Its unit.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Angle => "rad",
            Self::Displacement | Self::Distance => "m",
        }
    }
}

/// Why limits are refused. Each message names the value and what is accepted.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum LimitsError {
    /// The lower limit is not below the upper one, or one of them is NaN.
    #[error("limits from {lower} to {upper} are not accepted: two numbers are needed, the lower one first")]
    Order {
        /// The lower limit.
        lower: f64,
        /// The upper limit.
        upper: f64,
    },
    /// The restitution of the stops is out of range.
    #[error("restitution of limits is {0}: a number from 0 to 1 is needed")]
    Restitution(f64),
}

/// The range of a coordinate, between two stops.
///
/// ```
/// use polhode::scene::Limits;
/// let limits = Limits::new(-0.5, 0.5)?.with_restitution(0.2)?;
/// assert_eq!((limits.lower(), limits.upper(), limits.restitution()), (-0.5, 0.5, 0.2));
/// # Ok::<(), polhode::scene::LimitsError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    lower: f64,
    upper: f64,
    restitution: f64,
}

impl Limits {
    /// From `lower` to `upper` (rad of an angle, m otherwise). An infinite number means no stop on that side.
    ///
    /// # Errors
    /// When the lower one is not below the upper one.
    pub fn new(lower: f64, upper: f64) -> Result<Self, LimitsError> {
        if lower < upper {
            Ok(Self { lower, upper, restitution: 0.0 })
        } else {
            Err(LimitsError::Order { lower, upper })
        }
    }

    /// The same limits with this coefficient of restitution: 0, the default, stops the bodies.
    ///
    /// # Errors
    /// When it is not from 0 to 1.
    pub fn with_restitution(self, restitution: f64) -> Result<Self, LimitsError> {
        if (0.0..=1.0).contains(&restitution) {
            Ok(Self { restitution, ..self })
        } else {
            Err(LimitsError::Restitution(restitution))
        }
    }

    /// The lower limit, rad or m.
    pub const fn lower(&self) -> f64 {
        self.lower
    }

    /// The upper limit, rad or m.
    pub const fn upper(&self) -> f64 {
        self.upper
    }

    /// Coefficient of restitution of its stops.
    pub const fn restitution(&self) -> f64 {
        self.restitution
    }
}

/// What drives a coordinate of a joint: a force along it on the body, and the opposite on the other body or the world.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Drive {
    /// A constant effort: a torque (N m) of an angle, a force (N) otherwise.
    Effort(f64),
    /// A servo that regulates the rate (rad/s, m/s) by `gain (velocity - rate)`.
    Velocity {
        /// The rate that it is to reach.
        velocity: f64,
        /// Effort for each unit of the difference, N m s/rad or N s/m.
        gain: f64,
    },
    /// A servo that regulates the coordinate (rad, m) by `stiffness (position - value) - damping rate`.
    Position {
        /// The value that it is to reach.
        position: f64,
        /// Effort for each unit of the difference, N m/rad or N/m.
        stiffness: f64,
        /// Effort against each unit of the rate, N m s/rad or N s/m.
        damping: f64,
    },
}

/// A motor at a coordinate of a joint. What it does on the bodies is external work.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motor {
    drive: Drive,
    most: f64,
}

impl Motor {
    /// A motor with this drive, whose effort has no bound.
    ///
    /// # Errors
    /// When a number is not finite, or a gain is negative.
    pub fn new(drive: Drive) -> Result<Self, FreedomError> {
        match drive {
            Drive::Effort(effort) => finite("effort", effort)?,
            Drive::Velocity { velocity, gain } => {
                finite("velocity", velocity)?;
                not_negative("gain", gain)?;
            }
            Drive::Position { position, stiffness, damping } => {
                finite("position", position)?;
                not_negative("stiffness", stiffness)?;
                not_negative("damping", damping)?;
            }
        }
        Ok(Self { drive, most: f64::INFINITY })
    }

    /// The same motor with an effort of at most this magnitude (N m, N).
    ///
    /// # Errors
    /// When it is negative or NaN.
    pub fn at_most(self, effort: f64) -> Result<Self, FreedomError> {
        if effort >= 0.0 {
            Ok(Self { most: effort, ..self })
        } else {
            Err(number("most", effort, "a number of at least 0"))
        }
    }

    /// What it drives by.
    pub const fn drive(&self) -> Drive {
        self.drive
    }

    /// Its largest effort, N m or N; infinite without a bound.
    pub const fn most(&self) -> f64 {
        self.most
    }

    /// Its effort at a value of the coordinate (rad, m) and a rate, N m or N.
    pub fn effort(&self, value: f64, rate: f64) -> f64 {
        let asked = match self.drive {
            Drive::Effort(effort) => effort,
            Drive::Velocity { velocity, gain } => gain * (velocity - rate),
            Drive::Position { position, stiffness, damping } => stiffness * (position - value) - damping * rate,
        };
        asked.clamp(-self.most, self.most)
    }
}

/// Dry friction of a joint along a coordinate: an effort of this size against the motion, and one of at most the effort
/// of breakaway that holds the coordinate where it is; with a bearing it grows with the force that the joint bears.
///
/// ```
/// use polhode::scene::JointFriction;
/// let friction = JointFriction::new(0.3)?.with_breakaway(0.4)?;
/// assert_eq!((friction.effort(), friction.breakaway()), (0.3, 0.4));
/// // A journal of 10 mm radius adds 0.1 of 10 mm times the force that it bears.
/// let journal = friction.with_bearing(0.1, 0.01)?;
/// assert_eq!(journal.arm(), 0.001);
/// # Ok::<(), polhode::scene::FreedomError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct JointFriction {
    effort: f64,
    breakaway: f64,
    arm: f64,
}

impl JointFriction {
    /// Friction of this effort (N m of an angle, N otherwise), in motion and at rest.
    ///
    /// # Errors
    /// When it is not above zero and finite.
    pub fn new(effort: f64) -> Result<Self, FreedomError> {
        if effort > 0.0 && effort.is_finite() {
            Ok(Self { effort, breakaway: effort, arm: 0.0 })
        } else {
            Err(number("effort of friction", effort, "a finite number above 0"))
        }
    }

    /// The same friction, which holds what is at rest up to this effort (N m, N).
    ///
    /// # Errors
    /// When it is below the effort in motion, or not finite.
    pub fn with_breakaway(self, breakaway: f64) -> Result<Self, FreedomError> {
        if breakaway >= self.effort && breakaway.is_finite() {
            Ok(Self { breakaway, ..self })
        } else {
            Err(number("breakaway of friction", breakaway, "a finite number of at least the effort in motion"))
        }
    }

    /// The same friction with that of a bearing, `coefficient` times the force on it across the axis: of an angle times
    /// the radius (m) at which it rubs, of a displacement times 1 (`radius` is 1 there). At rest it is larger as
    /// breakaway is than the effort. Of [`JointFriction::default`] it is all there is.
    ///
    /// # Errors
    /// When the coefficient or the radius is negative or not finite.
    pub fn with_bearing(self, coefficient: f64, radius: f64) -> Result<Self, FreedomError> {
        not_negative("coefficient of a bearing", coefficient)?;
        not_negative("radius of a bearing", radius)?;
        Ok(Self { arm: coefficient * radius, ..self })
    }

    /// Of a bearing: the effort for each newton on it across the axis, m of an angle, a coefficient otherwise; zero
    /// without one.
    pub const fn arm(&self) -> f64 {
        self.arm
    }

    /// The largest friction at rest over that in motion.
    pub fn static_ratio(&self) -> f64 {
        if self.effort > 0.0 { self.breakaway / self.effort } else { 1.0 }
    }

    /// In motion, N m or N.
    pub const fn effort(&self) -> f64 {
        self.effort
    }

    /// The largest one at rest, N m or N.
    pub const fn breakaway(&self) -> f64 {
        self.breakaway
    }
}

/// What acts along one coordinate of a joint: limits, a spring, a damper, a motor, dry friction. Nothing by default.
///
/// ```
/// use polhode::scene::{Drive, Freedom, Limits, Motor};
/// let motor = Motor::new(Drive::Velocity { velocity: 2.0, gain: 5.0 })?.at_most(1.5)?;
/// let freedom = Freedom::default().with_limits(Limits::new(-1.0, 1.0)?).with_spring(20.0, 0.1)?.with_motor(motor);
/// assert_eq!(freedom.motor().map(|motor| motor.effort(0.0, 0.0)), Some(1.5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Freedom {
    limits: Option<Limits>,
    stiffness: f64,
    rest: f64,
    damping: f64,
    motor: Option<Motor>,
    friction: Option<JointFriction>,
}

impl Freedom {
    /// With these limits.
    pub const fn with_limits(self, limits: Limits) -> Self {
        Self { limits: Some(limits), ..self }
    }

    /// With a spring of this stiffness (N m/rad or N/m) that is at rest at this value (rad, m).
    ///
    /// # Errors
    /// When the stiffness is negative, or a number is not finite.
    pub fn with_spring(self, stiffness: f64, rest: f64) -> Result<Self, FreedomError> {
        not_negative("stiffness", stiffness)?;
        finite("rest", rest)?;
        Ok(Self { stiffness, rest, ..self })
    }

    /// With a damper of this constant, N m s/rad or N s/m.
    ///
    /// # Errors
    /// When it is negative or not finite.
    pub fn with_damping(self, damping: f64) -> Result<Self, FreedomError> {
        not_negative("damping", damping)?;
        Ok(Self { damping, ..self })
    }

    /// With a motor.
    pub const fn with_motor(self, motor: Motor) -> Self {
        Self { motor: Some(motor), ..self }
    }

    /// With dry friction.
    pub const fn with_friction(self, friction: JointFriction) -> Self {
        Self { friction: Some(friction), ..self }
    }

    /// Its limits.
    pub const fn limits(&self) -> Option<Limits> {
        self.limits
    }

    /// Stiffness of its spring, N m/rad or N/m; zero without one.
    pub const fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// Where its spring is at rest, rad or m.
    pub const fn rest(&self) -> f64 {
        self.rest
    }

    /// Constant of its damper, N m s/rad or N s/m; zero without one.
    pub const fn damping(&self) -> f64 {
        self.damping
    }

    /// Its motor.
    pub const fn motor(&self) -> Option<Motor> {
        self.motor
    }

    /// Its dry friction.
    pub const fn friction(&self) -> Option<JointFriction> {
        self.friction
    }

    /// The same with another motor, or none.
    pub(crate) const fn driven_by(self, motor: Option<Motor>) -> Self {
        Self { motor, ..self }
    }

    /// The same along the coordinate with the opposite sign.
    pub(crate) fn reversed(self) -> Self {
        let limits = self.limits.map(|own| Limits { lower: -own.upper, upper: -own.lower, ..own });
        let motor = self.motor.map(|own| {
            let drive = match own.drive {
                Drive::Effort(effort) => Drive::Effort(-effort),
                Drive::Velocity { velocity, gain } => Drive::Velocity { velocity: -velocity, gain },
                Drive::Position { position, stiffness, damping } => {
                    Drive::Position { position: -position, stiffness, damping }
                }
            };
            Motor { drive, ..own }
        });
        Self { limits, rest: -self.rest, motor, ..self }
    }

    /// Whether it exerts forces besides those of its stops and its friction.
    pub(crate) fn has_forces(&self) -> bool {
        self.stiffness > 0.0 || self.damping > 0.0 || self.motor.is_some()
    }
}

/// Why a spring, a damper, a motor or friction is refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error("{quantity} of a joint is {value}: {accepted} is needed")]
pub struct FreedomError {
    quantity: &'static str,
    value: f64,
    accepted: &'static str,
}

impl FreedomError {
    /// A quantity that has a value where another one is accepted.
    pub(super) const fn new(quantity: &'static str, value: f64, accepted: &'static str) -> Self {
        Self { quantity, value, accepted }
    }
}

const fn number(quantity: &'static str, value: f64, accepted: &'static str) -> FreedomError {
    FreedomError { quantity, value, accepted }
}

fn finite(quantity: &'static str, value: f64) -> Result<(), FreedomError> {
    if value.is_finite() { Ok(()) } else { Err(number(quantity, value, "a finite number")) }
}

fn not_negative(quantity: &'static str, value: f64) -> Result<(), FreedomError> {
    if value >= 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(number(quantity, value, "a finite number of at least 0"))
    }
}
