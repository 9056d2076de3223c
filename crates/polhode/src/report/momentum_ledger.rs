//! The ledger of momentum: the change of linear and angular momentum, booked by cause.
//!
//! `P + D_rest + D_projection + D_numerical - J_gravity - J_support - J_fields - J_program = P0`
//!
//! and the same for the angular momentum `L_Q = sum L + (x - Q) x m v` about a point Q that is fixed in the world: the
//! centre of mass of the movable bodies at the start. J is the impulse of external forces: gravity, force fields, and
//! fixed bodies through impacts and active contacts. Forces between movable bodies cancel. Forces of pivots belong to
//! the support; a body that is reduced to rotation about its pivot passes its momentum on to the world and counts as
//! fixed. As in the ledger of energy, every term is computed from its own cause and none is the remainder. P in N s, L
//! in N m s.

use polhode_spatial::{CompensatedSum, DVec3};

/// Linear momentum, N s, and angular momentum about the ledger's point Q, N m s; or a change of both.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Momentum {
    /// Linear part, N s.
    pub linear: DVec3,
    /// Angular part, N m s.
    pub angular: DVec3,
}

impl std::ops::Sub for Momentum {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { linear: self.linear - other.linear, angular: self.angular - other.angular }
    }
}

impl std::ops::Add for Momentum {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { linear: self.linear + other.linear, angular: self.angular + other.angular }
    }
}

/// A compensated sum of momenta.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MomentumSum {
    components: [CompensatedSum; 6],
}

impl MomentumSum {
    /// The sum and its compensation, of each component, the linear ones first.
    pub(crate) fn parts(&self) -> [[f64; 2]; 6] {
        self.components.map(|sum| sum.parts())
    }

    /// The sum with these parts.
    pub(crate) fn from_parts(parts: [[f64; 2]; 6]) -> Self {
        Self { components: parts.map(CompensatedSum::from_parts) }
    }

    /// Adds one term.
    pub fn add(&mut self, term: Momentum) {
        let numbers = term.linear.to_array().into_iter().chain(term.angular.to_array());
        for (sum, number) in self.components.iter_mut().zip(numbers) {
            sum.add(number);
        }
    }

    /// The sum so far.
    pub fn value(&self) -> Momentum {
        let [x, y, z, l, m, n] = self.components.map(|sum| sum.value());
        Momentum { linear: DVec3::new(x, y, z), angular: DVec3::new(l, m, n) }
    }
}

/// Momentum booked by cause.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct MomentumLedger {
    /// Q: the point of the world about which angular momentum is taken, m.
    pub about: DVec3,
    /// Impulse of gravity.
    pub gravity: MomentumSum,
    /// Impulse of fixed and kinematic bodies, through impacts and contact forces, and of pivots with constraint rows.
    pub support: MomentumSum,
    /// Impulse of force fields.
    pub fields: MomentumSum,
    /// Impulse of the program: impulses that it applied, velocities and poses that it set, bodies that it added or
    /// removed.
    pub program: MomentumSum,
    /// Lost when small bounces were summed up in closed form, and when small velocities were set to zero at rest.
    pub rest: MomentumSum,
    /// Lost by projections of positions and velocities.
    pub projection: MomentumSum,
    /// Lost by the integrator between events.
    pub numerical: MomentumSum,
    /// Momentum at the start.
    pub initial: Momentum,
    /// Momentum now.
    pub current: Momentum,
    /// Largest linear momentum so far, N s: the sum of magnitudes over the bodies, or the impulse of gravity if that is
    /// more.
    pub scale_linear: f64,
    /// The same for angular momentum, N m s.
    pub scale_angular: f64,
}

impl MomentumLedger {
    /// The closure: the part of the change of momentum that no term explains.
    pub fn closure(&self) -> Momentum {
        let mut sum = MomentumSum::default();
        for term in [self.current, self.rest.value(), self.projection.value(), self.numerical.value()] {
            sum.add(term);
        }
        let given = [self.gravity.value(), self.support.value(), self.fields.value(), self.program.value()];
        for term in given.into_iter().chain([self.initial]) {
            sum.add(Momentum::default() - term);
        }
        sum.value()
    }

    /// Magnitude of the closure relative to the largest momentum of the run: the larger of the linear and angular
    /// parts.
    pub fn closure_relative(&self) -> f64 {
        let relative = |closure: DVec3, scale: f64| if closure == DVec3::ZERO { 0.0 } else { closure.length() / scale };
        let closure = self.closure();
        relative(closure.linear, self.scale_linear).max(relative(closure.angular, self.scale_angular))
    }
}
