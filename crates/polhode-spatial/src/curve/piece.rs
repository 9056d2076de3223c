//! A piece of a curve: one formula over a range of its parameter.
//!
//! | piece | point at the parameter `u` |
//! |---|---|
//! | bend | `c' = e cos(a) + l sin(a)`, `a = k u + k' u^2/2`: straight, an arc of a circle, or a clothoid |
//! | helix | `o + R (x cos u + y sin u) + h u a`: a circle without `h` |
//! | polynomial | `sum a_k u^k` |
//! | wave | `o + e u + A f cos(w u)` |
//! | cycloid | `o + R e (u + sin u) + R f (1 - cos u)`: the path of a point of a wheel that rolls under a ceiling |
//!
//! `e` is the heading and `l` the left of it, `k` the curvature at the start (1/m) and `k'` its rate (1/m^2): a
//! curvature that changes evenly along the way makes a clothoid (Cornu's spiral; Levien 2008). The parameter of a bend
//! is the arc length, m. The point of a bend is an integral, taken from a place at which it is known (`quadrature.rs`).

use super::quadrature::integral;
use glam::DVec3;

/// One formula of a curve. Vectors without a unit are unit vectors.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Piece {
    Bend {
        heading: DVec3,
        left: DVec3,
        /// 1/m.
        curvature: f64,
        /// 1/m^2.
        curvature_rate: f64,
    },
    Helix {
        center: DVec3,
        x: DVec3,
        y: DVec3,
        axis: DVec3,
        /// m.
        radius: f64,
        /// Displacement along the axis for each radian, m.
        advance: f64,
    },
    /// Coefficients from the lowest.
    Polynomial(Vec<DVec3>),
    Wave {
        start: DVec3,
        along: DVec3,
        up: DVec3,
        /// m.
        amplitude: f64,
        /// rad/m.
        wavenumber: f64,
    },
    Cycloid {
        lowest: DVec3,
        along: DVec3,
        up: DVec3,
        /// m.
        radius: f64,
    },
}

/// A piece over a range of its parameter.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stretch {
    pub(super) piece: Piece,
    pub(super) from: f64,
    pub(super) to: f64,
}

/// A point of a piece with its derivatives by the parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Jet {
    pub(super) point: DVec3,
    pub(super) first: DVec3,
    pub(super) second: DVec3,
    pub(super) third: DVec3,
}

impl Jet {
    /// How fast the arc length grows with the parameter.
    pub(super) fn speed(&self) -> f64 {
        self.first.length()
    }

    /// Unit vector.
    pub(super) fn tangent(&self) -> DVec3 {
        self.first / self.speed()
    }

    /// Derivative of the tangent by the arc length, 1/m.
    pub(super) fn curvature(&self) -> DVec3 {
        let tangent = self.tangent();
        (self.second - tangent * tangent.dot(self.second)) / self.first.length_squared()
    }

    /// Derivative of the curvature by the arc length, 1/m^2.
    pub(super) fn curvature_rate(&self) -> DVec3 {
        let (speed, tangent, curvature) = (self.speed(), self.tangent(), self.curvature());
        let (turning, speeding) = (curvature * speed, tangent.dot(self.second));
        let across =
            self.third - tangent * tangent.dot(self.third) - turning * speeding - tangent * turning.dot(self.second);
        (across / (speed * speed) - curvature * (2.0 * speeding / speed)) / speed
    }
}

impl Piece {
    /// The point at a parameter with its derivatives, where the point at another one is known.
    pub(super) fn at(&self, u: f64, (known, known_point): (f64, DVec3)) -> Jet {
        match self {
            Self::Bend { heading, left, curvature, curvature_rate } => {
                let angle = |u: f64| u * (curvature + 0.5 * curvature_rate * u);
                let direction = |u: f64| {
                    let (sin, cos) = libm::sincos(angle(u));
                    *heading * cos + *left * sin
                };
                let is_straight = *curvature == 0.0 && *curvature_rate == 0.0;
                let way =
                    if is_straight { *heading * (u - known) } else { integral(DVec3::ZERO, (known, u), direction) };
                let (sin, cos) = libm::sincos(angle(u));
                let across = *left * cos - *heading * sin;
                let (point, first, bend) = (known_point + way, direction(u), curvature + curvature_rate * u);
                Jet { point, first, second: across * bend, third: across * *curvature_rate - first * (bend * bend) }
            }
            Self::Helix { center, x, y, axis, radius, advance } => {
                let (sin, cos) = libm::sincos(u);
                let out = (*x * cos + *y * sin) * *radius;
                Jet {
                    point: *center + out + *axis * (advance * u),
                    first: (*y * cos - *x * sin) * *radius + *axis * *advance,
                    second: -out,
                    third: (*x * sin - *y * cos) * *radius,
                }
            }
            Self::Polynomial(coefficients) => {
                let (mut point, mut first, mut half_second) = (DVec3::ZERO, DVec3::ZERO, DVec3::ZERO);
                let mut sixth_third = DVec3::ZERO;
                for &coefficient in coefficients.iter().rev() {
                    sixth_third = sixth_third * u + half_second;
                    half_second = half_second * u + first;
                    first = first * u + point;
                    point = point * u + coefficient;
                }
                Jet { point, first, second: half_second * 2.0, third: sixth_third * 6.0 }
            }
            Self::Wave { start, along, up, amplitude, wavenumber } => {
                let (sin, cos) = libm::sincos(wavenumber * u);
                let height = *up * *amplitude;
                Jet {
                    point: *start + *along * u + height * cos,
                    first: *along - height * (wavenumber * sin),
                    second: -height * (wavenumber * wavenumber * cos),
                    third: height * (wavenumber * wavenumber * wavenumber * sin),
                }
            }
            Self::Cycloid { lowest, along, up, radius } => {
                let (sin, cos) = libm::sincos(u);
                // 1 - cos u without cancellation.
                let half = libm::sin(0.5 * u);
                let (along, up) = (*along * *radius, *up * *radius);
                Jet {
                    point: *lowest + along * (u + sin) + up * (2.0 * half * half),
                    first: along * (1.0 + cos) + up * sin,
                    second: up * cos - along * sin,
                    third: -up * sin - along * cos,
                }
            }
        }
    }

    /// Its point at a parameter, where no other one is known; of a bend `start` is that of zero.
    pub(super) fn first_point(&self, u: f64, start: DVec3) -> DVec3 {
        match self {
            Self::Bend { .. } => start,
            _ => self.at(u, (u, start)).point,
        }
    }

    /// How fast the arc length grows with the parameter where that is the same everywhere.
    pub(super) fn even_speed(&self) -> Option<f64> {
        match self {
            Self::Bend { .. } => Some(1.0),
            Self::Helix { radius, advance, .. } => Some(libm::hypot(*radius, *advance)),
            Self::Polynomial(_) | Self::Wave { .. } | Self::Cycloid { .. } => None,
        }
    }

    /// The arc length between two parameters, m.
    pub(super) fn arc_length(&self, (from, to): (f64, f64)) -> f64 {
        match self.even_speed() {
            Some(speed) => speed * (to - from),
            None => integral(0.0, (from, to), |u| self.at(u, (u, DVec3::ZERO)).speed()),
        }
    }
}
