//! Measures the springs of a run: what [`SpringReport`] tells is noted here.

use super::contact::ContactSpring;
use crate::identity::body_id::BodyId;
use crate::report::springs::{SpringImpact, SpringReport};

/// Impacts that are kept one by one; all are counted.
const KEPT: usize = 256;

impl SpringReport {
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
