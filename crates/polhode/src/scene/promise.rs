//! What a run promises: how far it may be from its scene at any step or sample and still end well.
//!
//! | quantity | relative to | accurate | stepped | fast | penalty | micro-collisions | thesis |
//! |---|---|---|---|---|---|---|---|
//! | overlap of two bodies | the smaller body | 1e-9 | 1e-3 | 0.1 | twice the stated one | the envelope | 1e-2 |
//! | gap of a joint; its rotations, rad | the smaller body | 1e-9 | 1e-6 | 1e-2 | 1e-6 | - | - |
//! | energy from projections, and from the method | the largest energy | 1e-9 | 1e-3 | 5e-2 | 1e-2 | 1e-2 | 1e-2 |
//! | residual of each solve | its problem | 1e-8 | 1e-8 | - | - | 1e-8 | - |
//! | violation of Coulomb's law | the largest force | 1e-5 | 1e-5 | - | - | - | - |
//! | loads off Newton's law over a step | their sum | - | 1e-9 | - | - | - | - |
//! | estimated error of the run, before its horizon | the body | 1e-6 | 1e-2 | 1e-2 | 1e-2 | 1e-2 | 1e-2 |
//!
//! A scene may set others ([`PromiseChanges`]). Where a tolerance of the method is above a limit it is the limit. What
//! the rounding of coordinates makes of a distance is added to its limit: it is told, and is no failure.
//! `crate::tier::promise` holds a run to its promise.
//!
//! The numbers are choices, in steps of what each tier is for: `accurate` leaves a hundred times what its tolerance of
//! 1e-11 does in a step; `stepped` what cannot be seen; `fast` what can be seen and is not taken for a fault of the
//! scene.

use super::SceneError;

/// What a run promises. [`TierFacts::promise`](crate::tier::TierFacts::promise) has that of a tier, and
/// [`Plan::promise`](crate::Plan::promise) that of a run.
///
/// ```
/// use polhode::scene::{OverlapLimit, Tier};
/// let promise = Tier::default().facts().promise;
/// assert_eq!(promise.overlap, OverlapLimit::OfSize(1e-9));
/// assert_eq!(promise.joint_gap, Some(1e-9));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Promise {
    /// How deep two bodies may overlap.
    pub overlap: OverlapLimit,
    /// How far a joint may be from what it keeps: relative to the size of its smaller body, and in rad where it keeps a
    /// rotation. None: the tier has no joints.
    pub joint_gap: Option<f64>,
    /// Energy that projections, and the method, may give or take in a run, relative to its largest energy.
    pub energy: f64,
    /// Residual of the solution of any problem (natural map, relative). None: the tier solves none to a residual.
    pub residual: Option<f64>,
    /// By how much forces of friction may violate Coulomb's law, relative to the largest force of their problem. None:
    /// the tier does not measure it.
    pub friction: Option<f64>,
    /// By how much the loads that a step tells may be off Newton's law of a body, relative to the sum of their
    /// magnitudes. None: the tier makes no such steps.
    pub loads: Option<f64>,
    /// Estimated error of the run before its horizon, relative to the size of a body.
    pub error: f64,
}

/// How deep two bodies may overlap.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum OverlapLimit {
    /// This part of the size of the smaller one.
    OfSize(f64),
    /// So many times the penetration that the springs of the scene are made for; not limited where the springs are
    /// given.
    OfStatedPenetration(f64),
    /// So many times the depth of the collision envelope.
    OfEnvelope(f64),
}

impl Promise {
    /// With what a scene sets in its place.
    pub(crate) fn changed(self, changes: &PromiseChanges) -> Self {
        Self {
            overlap: changes.overlap.map_or(self.overlap, OverlapLimit::OfSize),
            joint_gap: changes.joint_gap.or(self.joint_gap),
            energy: changes.energy.unwrap_or(self.energy),
            residual: changes.residual.or(self.residual),
            friction: changes.friction.or(self.friction),
            loads: changes.loads.or(self.loads),
            error: changes.error.unwrap_or(self.error),
        }
    }

    /// The same where a method is asked for this tolerance (no unit): no limit is below it.
    pub(crate) fn at_least(self, tolerance: f64) -> Self {
        let overlap = match self.overlap {
            OverlapLimit::OfSize(part) => OverlapLimit::OfSize(part.max(tolerance)),
            other => other,
        };
        Self {
            overlap,
            joint_gap: self.joint_gap.map(|gap| gap.max(tolerance)),
            energy: self.energy.max(tolerance),
            error: self.error.max(tolerance),
            ..self
        }
    }
}

/// The limits that a scene sets in place of those of its tier.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PromiseChanges {
    /// Overlap of two bodies, relative to the size of the smaller one.
    pub overlap: Option<f64>,
    /// [`Promise::joint_gap`].
    pub joint_gap: Option<f64>,
    /// [`Promise::energy`].
    pub energy: Option<f64>,
    /// [`Promise::residual`].
    pub residual: Option<f64>,
    /// [`Promise::friction`].
    pub friction: Option<f64>,
    /// [`Promise::loads`].
    pub loads: Option<f64>,
    /// [`Promise::error`].
    pub error: Option<f64>,
}

impl PromiseChanges {
    /// Checks that every limit that is given is positive.
    ///
    /// # Errors
    /// When one is not, or is not finite.
    pub fn validate(&self) -> Result<(), SceneError> {
        let given = [
            ("promise.overlap", self.overlap),
            ("promise.joint_gap", self.joint_gap),
            ("promise.energy", self.energy),
            ("promise.residual", self.residual),
            ("promise.friction", self.friction),
            ("promise.loads", self.loads),
            ("promise.error", self.error),
        ];
        for (key, limit) in given {
            if let Some(limit) = limit {
                super::error::positive(key, limit)?;
            }
        }
        Ok(())
    }
}
