//! What springs were asked for and what they reached: penetration, restitution, stiffness.

use super::contact::ContactSpring;
use crate::BodyId;

/// Impacts that are kept one by one; all are counted.
const KEPT: usize = 256;

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
    /// Restitution asked and reached, where materials ask for less than a damper reaches: the strongest damping acts then.
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
    /// Greatest penetration in units of the one asked, of all steps and within them; none of springs with a stiffness of their own.
    pub fn penetration_relative(&self) -> Option<f64> {
        self.penetration_asked_m.map(|asked| self.penetration_m / asked)
    }

    /// Records a contact that has ended.
    pub(super) fn note_impact(&mut self, impact: SpringImpact) {
        self.impacts += 1;
        if self.first_impacts.len() < KEPT {
            self.first_impacts.push(impact);
        }
        let off = |impact: &SpringImpact| (impact.restitution() - impact.restitution_asked).abs();
        let is_comparable = impact.is_alone && impact.approach_m_s > 0.0;
        if is_comparable && self.worst_restitution.as_ref().is_none_or(|worst| off(&impact) > off(worst)) {
            self.worst_restitution = Some(impact);
        }
    }

    /// Records a spring at an overlap (m) in a step of a length (s).
    pub(super) fn note_step(&mut self, spring: &ContactSpring, depth: f64, h: f64) {
        let frequency = spring.frequency(depth);
        self.fastest_rad_s = self.fastest_rad_s.max(frequency);
        self.frequency_step = self.frequency_step.max(frequency * h);
        self.penetration_m = self.penetration_m.max(depth);
    }

    /// Takes in what another part of the run measured.
    pub(super) fn append(&mut self, other: &Self) {
        self.penetration_m = self.penetration_m.max(other.penetration_m);
        self.fastest_rad_s = self.fastest_rad_s.max(other.fastest_rad_s);
        self.frequency_step = self.frequency_step.max(other.frequency_step);
        let beyond = other.impacts.saturating_sub(other.first_impacts.len() as u64);
        other.first_impacts.iter().for_each(|impact| self.note_impact(*impact));
        self.impacts += beyond;
        if let Some(worst) = other.worst_restitution {
            let off = |impact: &SpringImpact| (impact.restitution() - impact.restitution_asked).abs();
            if self.worst_restitution.as_ref().is_none_or(|known| off(&worst) > off(known)) {
                self.worst_restitution = Some(worst);
            }
        }
    }
}

impl ContactSpring {
    /// Angular frequency (rad/s) of its effective mass on the spring as it is at an overlap (m).
    pub(super) fn frequency(&self, depth: f64) -> f64 {
        (self.normal.slope(depth) / self.mass).sqrt()
    }

    /// What is known of the contact at its end at `t` (s), where its bodies separate at a speed (m/s).
    pub(super) fn ended(&self, t: f64, separation: f64) -> SpringImpact {
        SpringImpact {
            begun_s: self.passage.begun_s,
            duration_s: t - self.passage.begun_s,
            bodies: [BodyId::new(self.id.a), BodyId::new(self.id.b)],
            approach_m_s: self.passage.approach,
            separation_m_s: separation,
            penetration_m: self.passage.deepest,
            force_n: self.passage.hardest,
            restitution_asked: self.restitution,
            is_alone: self.passage.alone,
        }
    }
}
