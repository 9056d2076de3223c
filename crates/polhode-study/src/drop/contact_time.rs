//! How long an impact lasts, and how hard it is: Hertz's law for a rounded corner.
//!
//! A rigid body is struck in no time: an impulse J (N s) and no force. With Young's moduli and Poisson's ratios of both
//! materials, and the radius R (m) to which corners and edges are rounded, the contact is a spring `k d^(3/2)`,
//! `k = (4/3) E* sqrt(R)`. For the effective mass m (kg) at the point and the speed v (m/s) with which it strikes, an
//! elastic impact reaches the depth `d = (5 m v^2/(4 k))^(2/5)` (m), the force `F = k d^(3/2)` (N), and lasts
//! `T = (4/5) sqrt(pi) Gamma(2/5)/Gamma(9/10) d/v = 2.9432 d/v` (s). The speed is that of a lone impact of the same
//! impulse, `v = J/((1 + e) m)` with the restitution e: friction and other points that are struck at once change it.
//! The deceleration is that of the centre of mass, from the forces of all points of one instant.
//!
//! What the law leaves out: waves in the body, plastic flow (which limits the force of metals), and faces that land
//! flat, whose contact is stiffer. Source: docs/REFERENCES.md, Hertz 1882; Johnson 1985. Fails: never.

use polhode::response::penalty::{ElasticPair, Growth, NormalSpring, SpringError};
use std::f64::consts::PI;

/// The law of a corner on a floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ContactLaw {
    spring: NormalSpring,
    restitution: f64,
}

/// What an impulse at a point means over the time of the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OverTime {
    /// The greatest force, N.
    pub(super) force_n: f64,
    /// How long bodies touch, s.
    pub(super) time_s: f64,
}

impl ContactLaw {
    /// Of two materials (Young's modulus, Pa, and Poisson's ratio each; a rigid one has none), the radius of corners
    /// (m) and the restitution.
    ///
    /// # Errors
    /// When both are rigid, or a number is not positive and finite.
    pub(super) fn new(materials: [Option<[f64; 2]>; 2], radius_m: f64, restitution: f64) -> Result<Self, SpringError> {
        let stiffness = ElasticPair::new(materials)?.hertz_stiffness(radius_m);
        let spring = NormalSpring::elastic(Growth::Hertz, stiffness)?;
        Ok(Self { spring, restitution })
    }

    /// Of an impulse (N s) at a point of this effective mass (kg).
    pub(super) fn over_time(&self, impulse_ns: f64, mass_kg: f64) -> OverTime {
        let speed = impulse_ns / ((1.0 + self.restitution) * mass_kg);
        let depth = self.spring.impact_depth(mass_kg, speed);
        let duration = 0.8 * PI.sqrt() * libm::tgamma(0.4) / libm::tgamma(0.9);
        OverTime { force_n: self.spring.elastic_force(depth), time_s: duration * depth / speed }
    }
}

#[cfg(test)]
mod tests {
    //! A ball that bounces elastically off a plate: Hertz's own numbers.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;

    /// A steel ball of 10 mm falls on steel at 1 m/s. The spring's motion, integrated in small steps, is the oracle.
    #[test]
    fn a_steel_ball_on_steel() {
        let steel = Some([210e9, 0.3]);
        let (radius, mass, speed) = (0.005, 7850.0 * 4.0 / 3.0 * PI * 0.005_f64.powi(3), 1.0);
        let law = ContactLaw::new([steel, steel], radius, 1.0).unwrap();
        let found = law.over_time(2.0 * mass * speed, mass);
        let k = 4.0 / 3.0 * 0.5 * 210e9 / (1.0 - 0.09) * radius.sqrt();
        let (mut t, mut d, mut v, mut most) = (0.0, 0.0_f64, speed, 0.0_f64);
        let step = found.time_s / 1e6;
        while d >= 0.0 {
            v -= 0.5 * step * k * d * d.sqrt() / mass;
            d += step * v;
            v -= 0.5 * step * k * d.max(0.0) * d.max(0.0).sqrt() / mass;
            t += step;
            most = most.max(k * d.max(0.0) * d.max(0.0).sqrt());
        }
        assert!((found.time_s / t - 1.0).abs() < 1e-5, "{} {t}", found.time_s);
        assert!((found.force_n / most - 1.0).abs() < 1e-9, "{} {most}", found.force_n);
    }
}
