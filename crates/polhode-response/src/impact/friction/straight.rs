//! A piece of the path along which all rates are constant: a contact that sticks, or slips without turning.
//!
//! `u_n` and the speed of slip are linear in the normal impulse `x`, the works are quadratic, and every end is a closed
//! form. In a plane the whole path is made of such pieces (Wang and Mason 1992).

use super::plane::Tangent;
use super::restitution::{Happening, Stage};

/// A piece with constant rates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Straight {
    /// Tangential impulse over normal impulse.
    pub(super) ratio: Tangent,
    /// Coefficient of friction while it slips; 0 while it sticks, when friction does no work.
    pub(super) working_friction: f64,
    /// `u_n` at the start, m/s.
    pub(super) normal_velocity: f64,
    /// `du_n/dp_n`, 1/kg.
    pub(super) normal_rate: f64,
    /// Speed of slip at the start, m/s.
    pub(super) speed: f64,
    /// Its rate, 1/kg.
    pub(super) speed_rate: f64,
}

impl Straight {
    /// The normal impulse to what happens first, N s.
    pub(super) fn first(&self, stage: Stage) -> (f64, Happening) {
        let mut first = (f64::INFINITY, Happening::Wedged);
        let mut consider = |at: Option<f64>, what: Happening| {
            if let Some(at) = at.filter(|at| *at < first.0) {
                first = (at.max(0.0), what);
            }
        };
        let (u, rate) = (self.normal_velocity, self.normal_rate);
        if matches!(stage, Stage::Compression) {
            consider((rate > 0.0).then(|| -u / rate), Happening::CompressionEnds);
        } else {
            consider(self.end(stage), Happening::ImpactEnds);
            consider((rate < 0.0).then(|| u / -rate), Happening::CompressionBegins);
        }
        consider((self.speed_rate < 0.0).then(|| self.speed / -self.speed_rate), Happening::SlipStops);
        first
    }

    /// The normal impulse that is left of the restitution; none when its end is not reached.
    fn end(&self, stage: Stage) -> Option<f64> {
        let (u, rate) = (self.normal_velocity, self.normal_rate);
        match stage {
            Stage::Compression => None,
            Stage::UntilVelocity(velocity) => (rate > 0.0).then(|| (velocity - u) / rate),
            Stage::ForImpulse(left) => Some(left),
            Stage::ForWork(left) => {
                // u x + rate x^2 / 2 = left, in the form without cancellation.
                let root = (u * u + 2.0 * rate * left).max(-1.0).sqrt();
                let impulse = 2.0 * left / (u + root);
                impulse.is_finite().then_some(impulse)
            }
        }
    }

    /// Work of the normal impulse over a normal impulse `x`, J.
    pub(super) fn normal_work(&self, x: f64) -> f64 {
        x * (self.normal_velocity + 0.5 * self.normal_rate * x)
    }

    /// Work of friction over a normal impulse `x`, J.
    pub(super) fn friction_work(&self, x: f64) -> f64 {
        -self.working_friction * x * (self.speed + 0.5 * self.speed_rate * x)
    }
}
