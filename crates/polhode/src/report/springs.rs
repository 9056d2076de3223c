//! What springs were asked for and what they reached: penetration, restitution, stiffness.

use crate::identity::body_id::BodyId;

/// A contact from its begin to its end.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SpringImpact {
    /// When it began, s.
    pub begun_s: f64,
    /// How long it lasted, s.
    pub duration_s: f64,
    /// Its bodies.
    pub bodies: [BodyId; 2],
    /// Speed of approach at the begin, m/s.
    pub approach_m_s: f64,
    /// Speed of separation at the end, m/s.
    pub separation_m_s: f64,
    /// Greatest overlap at the end of a step, m; every greatest overlap ends one.
    pub penetration_m: f64,
    /// Greatest normal force at the end of a step, N.
    pub force_n: f64,
    /// Restitution asked of the pair.
    pub restitution_asked: f64,
    /// Whether no other contact acted on its bodies meanwhile: only then the restitution asked is that reached.
    pub is_alone: bool,
}

impl SpringImpact {
    /// Restitution reached: speed of separation per speed of approach.
    pub fn restitution(&self) -> f64 {
        self.separation_m_s / self.approach_m_s
    }
}

/// What the springs of a run were asked for and what they reached.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct SpringReport {
    /// Penetration that linear springs were to keep, m; none of springs with a stiffness of their own.
    pub penetration_asked_m: Option<f64>,
    /// Restitution asked and reached, where materials ask for less than a damper reaches: the strongest damping acts
    /// then.
    pub out_of_reach: Option<[f64; 2]>,
    /// Greatest penetration, m.
    pub penetration_m: f64,
    /// Number of contacts that have begun and ended.
    pub impacts: u64,
    /// The first of them.
    pub first_impacts: Vec<SpringImpact>,
    /// Of those that acted alone the one whose restitution is farthest from that asked.
    pub worst_restitution: Option<SpringImpact>,
    /// Largest angular frequency of a spring, rad/s.
    pub fastest_rad_s: f64,
    /// Largest product of that frequency and a step made with the spring (no unit).
    pub frequency_step: f64,
}

impl SpringReport {
    /// Greatest penetration in units of the one asked, of all steps and within them; none of springs with a stiffness
    /// of their own.
    pub fn penetration_relative(&self) -> Option<f64> {
        self.penetration_asked_m.map(|asked| self.penetration_m / asked)
    }
}
