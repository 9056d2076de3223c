//! The ledger of momentum: where every newton-second went.
//!
//! `P + D_rest + D_projection + D_numerical - J_gravity - J_support - J_fields - J_program = P0`
//!
//! and the same for the angular momentum `L_Q = sum L + (x - Q) x m v` about a point Q that is fixed in the world, the
//! centre of mass of the movable bodies at the start. J is what the outside gave: gravity, force fields, and the fixed
//! bodies through impacts and resting contacts; forces between bodies that move cancel. What a pivot gives is a support
//! too; a body of which turning about its pivot alone is left passes its momentum on to the world and counts as fixed.
//! As in the ledger of energy every term has its own source and none is the remainder. P in N s, L in N m s.

use polhode_spatial::{CompensatedSum, DVec3};

/// Linear momentum, N s, and angular momentum about the ledger's point, N m s; or what changes them.
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
    /// Both parts of each component's sum, the linear ones first.
    pub(crate) fn parts(&self) -> [[f64; 2]; 6] {
        self.components.map(|sum| sum.parts())
    }

    /// The sum of such parts.
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

/// Momentum booked by source.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MomentumLedger {
    /// Q: the point of the world that angular momentum is about, m.
    pub about: DVec3,
    /// Given by gravity.
    pub gravity: MomentumSum,
    /// Given by fixed and kinematic bodies, through impacts and the forces of resting contacts, and by pivots that rows
    /// hold.
    pub support: MomentumSum,
    /// Given by force fields.
    pub fields: MomentumSum,
    /// Given by a program: impulses, velocities and poses that it set, bodies that it added or removed.
    pub program: MomentumSum,
    /// Lost when small bounces were summed up or small velocities set to rest.
    pub rest: MomentumSum,
    /// Lost by moving bodies out of each other and off inconsistent velocities.
    pub projection: MomentumSum,
    /// Lost by the integrator over smooth stages.
    pub numerical: MomentumSum,
    /// At the start.
    pub initial: Momentum,
    /// Now.
    pub current: Momentum,
    /// Largest linear momentum so far, N s: sum of magnitudes over bodies, or what gravity gave if that is more.
    pub scale_linear: f64,
    /// The same for angular momentum, N m s.
    pub scale_angular: f64,
}

impl MomentumLedger {
    /// What is left unexplained.
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

    /// What is left unexplained, relative to the largest momentum of the run: the worse of linear and angular.
    pub fn closure_relative(&self) -> f64 {
        let relative = |closure: DVec3, scale: f64| if closure == DVec3::ZERO { 0.0 } else { closure.length() / scale };
        let closure = self.closure();
        relative(closure.linear, self.scale_linear).max(relative(closure.angular, self.scale_angular))
    }
}
