//! Coulomb's law with an ellipse in place of the circle: friction along and across a grain.
//!
//! In the tangent basis `t_1` (along the grain), `t_2` (across) let `M = diag(mu_1, mu_2)`. The force of friction lies
//! in `|M^-1 f| <= f_n`, and that of a slip along `d` is the one of largest dissipation,
//!
//! `f = -f_n M^2 d / |M d|`,
//!
//! where the normal of the ellipse points against the slip. It is opposite to the slip along the axes alone. With rows
//! `s_i t_i`, `s_i = mu_i / m`, `m = max(mu_1, mu_2)`, forces `lambda_i = f_i / s_i` and slips `v_i = s_i u_i` satisfy
//! the law of a circle with coefficient `m`, work included: `lambda.v = f.u`. Source: docs/REFERENCES.md, Michalowski
//! and Mroz 1978.

use crate::scene::FrictionEllipse;
use polhode_spatial::DVec3;

impl FrictionEllipse {
    /// Whether friction is the same in all directions.
    pub(crate) fn is_circle(self) -> bool {
        self.along == self.across
    }

    /// `s_1`, `s_2`: both 1 for a circle.
    pub(crate) fn scales(self) -> [f64; 2] {
        if self.is_circle() { [1.0; 2] } else { [self.along, self.across].map(|own| own / self.largest()) }
    }

    /// Length of a force whose parts along the basis are these, with rows `s_i t_i`: what the coefficient `m` limits.
    pub(crate) fn length(self, parts: &[f64]) -> f64 {
        parts.iter().zip(self.scales()).fold(0.0, |sum: f64, (part, scale)| libm::hypot(sum, part / scale))
    }

    /// Direction and coefficient of what friction opposes: a slip along `direction` (unit vectors) bears
    /// `-coefficient f_n` times that direction.
    pub(crate) fn opposed(self, basis: [DVec3; 2], direction: DVec3) -> (DVec3, f64) {
        if self.is_circle() {
            return (direction, self.along);
        }
        let [along, across] = basis.map(|tangent| tangent.dot(direction));
        let (along, across) = (self.along * along, self.across * across);
        let length = libm::hypot(along, across);
        let force = basis[0] * (self.along * along) + basis[1] * (self.across * across);
        let coefficient = force.length();
        if coefficient > 0.0 { (force / coefficient, coefficient / length) } else { (direction, self.largest()) }
    }

    /// The direction of the slip (unit vector) against which friction bears this force; none for no force.
    pub(crate) fn slip_against(self, basis: [DVec3; 2], force: DVec3) -> Option<DVec3> {
        if self.is_circle() {
            return (-force).try_normalize();
        }
        let [along, across] = self.scales();
        let slip =
            basis[0] * (basis[0].dot(force) / (along * along)) + basis[1] * (basis[1].dot(force) / (across * across));
        (-slip).try_normalize()
    }

    /// Whether it is smaller than another one in some direction.
    pub(crate) fn is_below(self, other: Self) -> bool {
        self.along < other.along || self.across < other.across
    }
}
