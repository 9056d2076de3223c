//! What keeps an elastic body from being made or moved: the value, the limit, and what to do.

use thiserror::Error;

/// Why there is no elastic body, or no motion of it.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ElasticError {
    /// A size, a modulus, a density, a speed or a time that must be a positive number.
    #[error("{what} is {value} {unit}: give a positive finite number")]
    NotPositive {
        /// What it is.
        what: &'static str,
        /// Its unit.
        unit: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number that must be finite.
    #[error("{what} is {value} {unit}: give a finite number")]
    NotFinite {
        /// What it is.
        what: &'static str,
        /// Its unit.
        unit: &'static str,
        /// Its value.
        value: f64,
    },
    /// A Poisson ratio that no stable solid has.
    #[error(
        "Poisson ratio is {value}: it lies between -1 and 0.5, both excluded; for a solid that hardly changes its \
         volume take 0.49"
    )]
    Poisson {
        /// Its value.
        value: f64,
    },
    /// Elements that are none, or too many.
    #[error("{value} elements: give from 1 to {most}")]
    Elements {
        /// How many.
        value: usize,
        /// The most there may be.
        most: usize,
    },
    /// An element that names a node that is not there.
    #[error("element {element} names node {node}, and there are {nodes}: name nodes from 0 to one less")]
    NoSuchNode {
        /// The element.
        element: usize,
        /// The node that it names.
        node: usize,
        /// How many there are.
        nodes: usize,
    },
    /// Displacements or velocities that are not those of the nodes.
    #[error("{given} {what} for {nodes} nodes: give one for each node")]
    Length {
        /// What was given.
        what: &'static str,
        /// How many.
        given: usize,
        /// How many nodes there are.
        nodes: usize,
    },
    /// An element that is folded where it begins.
    #[error(
        "element {element} has the Jacobian {jacobian} m^2 at one of its corners: it must be positive everywhere; name \
         corners anticlockwise, and make no corner reflex"
    )]
    Folded {
        /// The element.
        element: usize,
        /// Its smallest Jacobian, m^2.
        jacobian: f64,
    },
    /// An element that folds during the motion.
    #[error(
        "element {element} folds at {t_s} s: the ratio of its volume to that at rest is {ratio}, and must stay \
         positive; lower the speed, or take a stiffer material or a finer mesh"
    )]
    Folds {
        /// The element.
        element: usize,
        /// The determinant of its deformation gradient.
        ratio: f64,
        /// When, s.
        t_s: f64,
    },
    /// A time step that central differences are not stable with.
    #[error(
        "a step of {step_s} s is beyond the limit of {limit_s} s, above which central differences are unstable: take a \
         shorter one, or fewer elements"
    )]
    StepBeyondLimit {
        /// The step, s.
        step_s: f64,
        /// The longest one, s.
        limit_s: f64,
    },
    /// Nodes that are below the floor where the motion begins.
    #[error("node {node} is {depth_m} m below the floor at the start: begin above it")]
    BelowFloor {
        /// The node.
        node: usize,
        /// How deep, m.
        depth_m: f64,
    },
    /// A confined rectangle that is tilted or turns.
    #[error("a confined rectangle is tilted by {tilt_rad} rad: its nodes move along vertical lines, so drop it flat")]
    TiltedAndConfined {
        /// The tilt, rad.
        tilt_rad: f64,
    },
    /// A rectangle whose slowest vibration takes too long.
    #[error(
        "the rectangle is {ratio} times as long as it is thin, and may be {most} times: its bending would take too \
         long to watch"
    )]
    Slender {
        /// The longer side over the shorter one.
        ratio: f64,
        /// The most.
        most: f64,
    },
    /// A tilt beyond a right angle.
    #[error("the tilt is {tilt_rad} rad: give one within a right angle, from {least} to {most}")]
    Tilt {
        /// The tilt, rad.
        tilt_rad: f64,
        /// The least one.
        least: f64,
        /// The most.
        most: f64,
    },
    /// Errors of the integration that are no longer small.
    #[error(
        "at {t_s} s the time steps have changed the energy by {numerical_j} J, more than {limit_j} J: take a shorter \
         step or a lower speed"
    )]
    Diverged {
        /// When, s.
        t_s: f64,
        /// What the steps have changed, J for each metre of depth.
        numerical_j: f64,
        /// What they may, J for each metre of depth.
        limit_j: f64,
    },
    /// A body that has not left the floor in the time that it was given.
    #[error(
        "the rectangle has not left the floor for good after {t_s} s ({steps} steps): drop it faster, or more upright"
    )]
    StaysDown {
        /// The time, s.
        t_s: f64,
        /// Steps.
        steps: usize,
    },
    /// Too few meshes for an extrapolation.
    #[error("{given} meshes: an extrapolation takes {least} or more, each twice as fine as the one before")]
    Meshes {
        /// How many.
        given: usize,
        /// The fewest.
        least: usize,
    },
}

/// A positive finite number, or the error that says which is none.
pub(crate) fn positive(what: &'static str, unit: &'static str, value: f64) -> Result<f64, ElasticError> {
    if value > 0.0 && value.is_finite() { Ok(value) } else { Err(ElasticError::NotPositive { what, unit, value }) }
}

/// A finite number, or the error that says which is none.
pub(crate) fn finite(what: &'static str, unit: &'static str, value: f64) -> Result<f64, ElasticError> {
    if value.is_finite() { Ok(value) } else { Err(ElasticError::NotFinite { what, unit, value }) }
}
