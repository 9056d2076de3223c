//! What a run promises, where a scene sets other limits than its tier.

use schemars::JsonSchema;
use serde::Deserialize;

/// Limits beyond which a run is degraded (exit code 1); what is absent is that of the tier.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PromiseEntry {
    /// Overlap of two bodies, relative to the size of the smaller one. When absent 1e-9 (accurate), 1e-3 (stepped), 0.1
    /// (fast), 1e-2 (thesis), twice the stated penetration (penalty), the envelope (micro-collisions).
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub overlap: Option<f64>,
    /// Gap of a joint, relative to the size of its smaller body, and of its rotations, rad. When absent 1e-9
    /// (accurate), 1e-6 (stepped, penalty), 1e-2 (fast).
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub joint_gap: Option<f64>,
    /// Energy that projections, and the method, may give or take, relative to the largest energy. When absent 1e-9
    /// (accurate), 1e-3 (stepped), 5e-2 (fast), 1e-2 (the others).
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub energy: Option<f64>,
    /// Residual of the solution of any problem. When absent 1e-8 (accurate, stepped, micro-collisions), none (the
    /// others).
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub residual: Option<f64>,
    /// Violation of Coulomb's law, relative to the largest force of its problem. When absent 1e-5 (accurate, stepped),
    /// none (the others).
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub friction: Option<f64>,
    /// How far the loads that a step tells may be off Newton's law of a body, relative to their sum. When absent 1e-9
    /// (stepped), none (the others).
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub loads: Option<f64>,
    /// Estimated error of the run, relative to the size of a body. When absent it is told, and not held against the
    /// run.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub error: Option<f64>,
}
