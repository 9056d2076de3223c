//! Springs, dampers and motors at joints as soft rows of a time step: solved for together with contacts and joints.
//!
//! Over a step of `h` such a source gives its coordinate the impulse of its mean force,
//!
//! `l = h f(q_m, u_m)`, `u_m = (u- + u+)/2`, `q_m = q + h/4 (u+ - u-)`
//!
//! with the value `q` in the middle of the step, and the rates `u-` before the kick of fields and `u+` after all
//! impulses. With `f = -k (q - q0) - c u + e` that is
//!
//! `l = h e - h k (q - q0) + a_k u- - a_c u- - a u+`, `a_k = h^2 k/4`, `a_c = h c/2`, `a = a_k + a_c`
//!
//! a held row of compliance `1/a`. It is the implicit midpoint rule: stable for any stiffness, of second order, and a
//! linear spring neither gains nor loses energy. Source: the symmetric splitting of Strang 1968; Hairer, Lubich and
//! Wanner 2006, chapter VI.
//!
//! A motor that asks for more than its bound in the middle of the step gives its bound: that part of the impulse is
//! known before. Limit: whether it is at its bound is decided once in a step.

/// A law of force along a coordinate in the unit of its row: `-k (q - q0) - c u + e`, N.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct LinearForce {
    /// k, N/m.
    pub(crate) stiffness: f64,
    /// c, N s/m.
    pub(crate) damping: f64,
    /// `k q0 + e`: the force at zero value and rate, N.
    pub(crate) at_zero: f64,
}

impl LinearForce {
    /// The impulse of its mean force over a step, N s.
    fn impulse(&self, of: &Mean, h: f64) -> f64 {
        h * (self.at_zero - self.stiffness * of.value - self.damping * of.rate)
    }
}

/// Mean value and rate of a coordinate in a step, m, m/s.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Mean {
    value: f64,
    rate: f64,
}

/// What exerts a force along a coordinate of a joint in a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Softness {
    /// Spring, damper and motor.
    pub(crate) spring: LinearForce,
    pub(crate) damper: LinearForce,
    pub(crate) motor: LinearForce,
    /// The value in the middle of the step, m.
    pub(crate) value: f64,
    /// `u-`, m/s.
    pub(crate) rate_before: f64,
    /// The rate after the kick, m/s.
    pub(crate) rate: f64,
    /// Length of the step, s.
    pub(crate) h: f64,
}

/// Works of a soft row in a step, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct SoftWork {
    pub(crate) spring: f64,
    pub(crate) damper: f64,
    pub(crate) motor: f64,
}

impl std::ops::Add for SoftWork {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { spring: self.spring + other.spring, damper: self.damper + other.damper, motor: self.motor + other.motor }
    }
}

impl Softness {
    fn sources(&self) -> [LinearForce; 3] {
        [self.spring, self.damper, self.motor]
    }

    /// `a`, kg.
    fn resistance(&self) -> f64 {
        let h = self.h;
        self.sources().iter().map(|own| h * (0.25 * h * own.stiffness + 0.5 * own.damping)).sum()
    }

    /// Whether its impulse depends on the motion after it.
    pub(crate) fn responds(&self) -> bool {
        self.resistance() > 0.0
    }

    /// `1/a`, 1/kg.
    pub(crate) fn compliance(&self) -> f64 {
        self.resistance().recip()
    }

    /// The constant term of the row: the rate after the kick less `l_0/a`, with the impulse `l_0` where `u+` is zero,
    /// m/s.
    pub(crate) fn constant(&self) -> f64 {
        self.rate - self.impulse(0.0) / self.resistance()
    }

    /// Its impulse where the rate after it is this (m/s), N s.
    fn impulse(&self, after: f64) -> f64 {
        let mean = self.mean(after);
        self.sources().iter().map(|own| own.impulse(&mean, self.h)).sum()
    }

    fn mean(&self, after: f64) -> Mean {
        let before = self.rate_before;
        Mean { value: self.value + 0.25 * self.h * (after - before), rate: 0.5 * (before + after) }
    }

    /// The works of its parts, of which `impulse` (N s) is the sum, where this `share` of all impulses of the group is
    /// applied: the rate then changes by that share of what the whole would change it by.
    pub(crate) fn works(&self, impulse: f64, share: f64) -> SoftWork {
        let after = (self.impulse(0.0) - impulse) / self.resistance();
        let mean = self.mean(after);
        let rate = 0.5 * (self.rate_before + self.rate + share * (after - self.rate));
        let work = |own: &LinearForce| share * own.impulse(&mean, self.h) * rate;
        SoftWork { spring: work(&self.spring), damper: work(&self.damper), motor: work(&self.motor) }
    }
}

#[cfg(test)]
mod tests {
    //! A soft row solved for one mass is the implicit midpoint rule.
    use super::*;

    /// A mass on a spring keeps its energy to rounding, whatever the step.
    #[test]
    fn a_linear_spring_keeps_its_energy() {
        for h in [1e-3, 0.1, 10.0] {
            let spring = LinearForce { stiffness: 7.0, ..LinearForce::default() };
            let none = LinearForce::default();
            let (mass, mut q, mut u) = (2.0, 0.3, 0.0_f64);
            let energy = |q: f64, u: f64| 0.5 * mass * u * u + 3.5 * q * q;
            let start = energy(q, u);
            for _ in 0..100 {
                let middle = q + 0.5 * h * u;
                let soft = Softness { spring, damper: none, motor: none, value: middle, rate_before: u, rate: u, h };
                let impulse = -soft.constant() / (1.0 / mass + soft.compliance());
                let after = u + impulse / mass;
                let works = soft.works(impulse, 1.0);
                assert!((works.spring - 0.5 * impulse * (u + after)).abs() < 1e-12 * start);
                (q, u) = (middle + 0.5 * h * after, after);
            }
            assert!((energy(q, u) / start - 1.0).abs() < 1e-12, "{h}: {}", energy(q, u) / start);
        }
    }

    /// Of an impulse that is shortened the parts do the work that the mass receives.
    #[test]
    fn a_share_of_an_impulse_does_the_work_of_that_share() {
        let (mass, h, u, share) = (2.0, 0.1, 1.3, 0.4);
        let spring = LinearForce { stiffness: 7.0, ..LinearForce::default() };
        let damper = LinearForce { damping: 3.0, ..LinearForce::default() };
        let motor = LinearForce { at_zero: 5.0, ..LinearForce::default() };
        let soft = Softness { spring, damper, motor, value: 0.3, rate_before: u, rate: u, h };
        let impulse = -soft.constant() / (1.0 / mass + soft.compliance());
        let after = u + share * impulse / mass;
        let works = soft.works(impulse, share);
        let given = 0.5 * mass * (after * after - u * u);
        assert!((works.spring + works.damper + works.motor - given).abs() < 1e-14 * given.abs());
    }
}
