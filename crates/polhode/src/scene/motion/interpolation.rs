//! How a table of samples is joined to a motion.

/// What is between the samples of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
#[non_exhaustive]
pub enum Interpolation {
    /// The spline, slowed down at the samples next to which it would leave the range of two neighbouring samples: every
    /// coordinate rises, falls or stays between two samples as the samples do. Velocity and acceleration are
    /// continuous.
    #[default]
    Monotone,
    /// The clamped cubic spline of the samples, of fourth order for samples of a smooth motion. It overshoots where the
    /// samples turn or stop. Velocity and acceleration are continuous.
    Spline,
    /// A constant velocity and a constant angular velocity from sample to sample. Velocities jump at the samples.
    Linear,
}
