//! The springs of the tier penalty.

use schemars::JsonSchema;
use serde::Deserialize;

/// Springs and dampers where bodies overlap; what is absent is chosen without tuning.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PenaltyEntry {
    /// How the elastic force grows with the overlap; linear when absent.
    pub law: Option<SpringLawName>,
    /// The damper, which follows from restitution; hunt-crossley when absent.
    pub damping: Option<SpringDampingName>,
    /// Friction of the springs; mindlin when absent.
    pub friction: Option<SpringFrictionName>,
    /// Penetration that linear springs are to keep, m; a thousandth of the smallest body when absent. Stiffness follows
    /// from it, the weights and the speeds of the scene.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub penetration_m: Option<f64>,
    /// Stiffness of linear springs, N/m, in place of a penetration.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub stiffness_n_m: Option<f64>,
    /// Speed of slip, m/s, at which regularised friction is at 0.71 of Coulomb's; it needs `friction = "regularised"`.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub slip_speed_m_s: Option<f64>,
}

/// How the elastic force grows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SpringLawName {
    /// In proportion to the overlap.
    Linear,
    /// With its power 3/2 after Hertz, from the elastic moduli of the materials: balls, on balls and on flat faces.
    Hertz,
}

/// The damper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SpringDampingName {
    /// In proportion to the elastic force too: forces begin and end at zero.
    HuntCrossley,
    /// In proportion to the rate of the overlap: forces begin with a jump.
    Plain,
}

/// Friction of the springs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SpringFrictionName {
    /// By a spring in the tangent plane that gives way at Coulomb's limit.
    Mindlin,
    /// Coulomb's law smoothed at a small speed of slip: contacts creep.
    Regularised,
}
