//! The force of a contact spring along its normal.
//!
//! | growth | elastic force | elastic energy | plain damper | Hunt and Crossley |
//! |---|---|---|---|---|
//! | linear | k d | k d^2/2 | c d' | k d a d' |
//! | Hertz | k d^(3/2) | 2 k d^(5/2)/5 | c d^(1/4) d' | k d^(3/2) a d' |
//!
//! d is the overlap (m), d' its rate (m/s, positive while bodies approach), k the stiffness (N/m; Hertz N/m^(3/2)), c
//! the coefficient of the damper (N s/m; Hertz N s/m^(5/4)), a that of Hunt and Crossley (s/m). A contact never pulls:
//! where the sum is negative the force is zero. A law that a step has frozen is continued past that, and past the end
//! of the overlap, as an odd function of d, so that it is as smooth there as within ([`NormalSpring::continued`]).
//! Source: docs/REFERENCES.md, Hertz; Hunt and Crossley; Tsuji, Tanaka and Ishida. How it fails: never; NaN gives NaN.

use super::SpringError;

/// Depth of a linear spring at the greatest compression of an elastic impact at speed v: `v sqrt(m/k)`. Hertz:
/// `(5 m v^2/(4 k))^(2/5)`.
const HERTZ_DEPTH_POWER: f64 = 0.4;

/// How the elastic force grows with the overlap.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Growth {
    /// In proportion to it.
    Linear,
    /// With its power 3/2: two elastic balls (Hertz).
    Hertz,
}

/// The damper beside a spring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Damping {
    /// `c d'`, for Hertz `c d^(1/4) d'`.
    Plain(f64),
    /// The elastic force times `a d'`.
    HuntCrossley(f64),
}

/// A spring with a damper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalSpring {
    growth: Growth,
    stiffness: f64,
    damping: Damping,
}

impl NormalSpring {
    /// A spring without damping.
    ///
    /// # Errors
    /// When the stiffness is not positive and finite.
    pub fn elastic(growth: Growth, stiffness: f64) -> Result<Self, SpringError> {
        if !(stiffness.is_finite() && stiffness > 0.0) {
            return Err(SpringError::Number { what: "the stiffness (N/m, or N/m^(3/2))", value: stiffness });
        }
        Ok(Self { growth, stiffness, damping: Damping::Plain(0.0) })
    }

    /// The same spring with a plain damper of this ratio for an effective mass (kg).
    pub fn with_plain_damping(self, ratio: f64, mass: f64) -> Self {
        let of_hertz = match self.growth {
            Growth::Linear => 1.0,
            Growth::Hertz => 0.5 * 5f64.sqrt(),
        };
        let coefficient = 2.0 * ratio * of_hertz * (self.stiffness * mass).sqrt();
        Self { damping: Damping::Plain(coefficient), ..self }
    }

    /// How the elastic force grows.
    pub fn growth(&self) -> Growth {
        self.growth
    }

    /// k, N/m; Hertz N/m^(3/2).
    pub fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// The damper.
    pub fn damping(&self) -> Damping {
        self.damping
    }

    /// The same spring with another damper.
    pub fn with_damping(self, damping: Damping) -> Self {
        Self { damping, ..self }
    }

    /// Elastic force at an overlap (m), N; zero without overlap.
    pub fn elastic_force(&self, depth: f64) -> f64 {
        if depth <= 0.0 {
            return 0.0;
        }
        match self.growth {
            Growth::Linear => self.stiffness * depth,
            Growth::Hertz => self.stiffness * depth * depth.sqrt(),
        }
    }

    /// Elastic energy at an overlap (m), J.
    pub fn energy(&self, depth: f64) -> f64 {
        if depth <= 0.0 {
            return 0.0;
        }
        match self.growth {
            Growth::Linear => 0.5 * self.stiffness * depth * depth,
            Growth::Hertz => 0.4 * self.stiffness * depth * depth * depth.sqrt(),
        }
    }

    /// Derivative of the elastic force in the overlap, N/m.
    pub fn slope(&self, depth: f64) -> f64 {
        match self.growth {
            Growth::Linear => self.stiffness,
            Growth::Hertz => 1.5 * self.stiffness * depth.max(0.0).sqrt(),
        }
    }

    /// Elastic force and damper together at an overlap (m) and its rate (m/s), N: negative where the damper would pull.
    pub fn unclipped(&self, depth: f64, rate: f64) -> f64 {
        let elastic = self.elastic_force(depth);
        match (self.damping, self.growth) {
            (Damping::HuntCrossley(a), _) => elastic * (1.0 + a * rate),
            (Damping::Plain(c), Growth::Linear) => elastic + c * rate,
            (Damping::Plain(c), Growth::Hertz) => elastic + c * depth.max(0.0).sqrt().sqrt() * rate,
        }
    }

    /// The force between the bodies, N: never negative, zero without overlap.
    pub fn force(&self, depth: f64, rate: f64) -> f64 {
        if depth < 0.0 {
            return 0.0;
        }
        let force = self.unclipped(depth, rate);
        // Written so that NaN stays NaN.
        if force < 0.0 { 0.0 } else { force }
    }

    /// The force at an overlap (m) and its rate (m/s) as if the contact went on where bodies part and where the damper
    /// pulls, N: smooth there, and not a force between bodies.
    pub fn continued(&self, depth: f64, rate: f64) -> f64 {
        let elastic = if depth < 0.0 { -self.elastic_force(-depth) } else { self.elastic_force(depth) };
        match self.damping {
            Damping::HuntCrossley(a) => elastic * (1.0 + a * rate),
            Damping::Plain(_) => elastic + self.damper(depth.abs()) * rate,
        }
    }

    /// Coefficient of the damper at an overlap (m): the derivative of the force in the rate, N s/m.
    pub fn damper(&self, depth: f64) -> f64 {
        match (self.damping, self.growth) {
            (Damping::HuntCrossley(a), _) => a * self.elastic_force(depth),
            (Damping::Plain(c), Growth::Linear) => c,
            (Damping::Plain(c), Growth::Hertz) => c * depth.max(0.0).sqrt().sqrt(),
        }
    }

    /// Greatest overlap (m) of an elastic impact of an effective mass (kg) at a speed (m/s).
    pub fn impact_depth(&self, mass: f64, speed: f64) -> f64 {
        match self.growth {
            Growth::Linear => speed * (mass / self.stiffness).sqrt(),
            Growth::Hertz => libm::pow(1.25 * mass * speed * speed / self.stiffness, HERTZ_DEPTH_POWER),
        }
    }

    /// Overlap (m) at which the elastic force is this load (N).
    pub fn static_depth(&self, load: f64) -> f64 {
        match self.growth {
            Growth::Linear => load / self.stiffness,
            Growth::Hertz => libm::cbrt((load / self.stiffness) * (load / self.stiffness)),
        }
    }

    /// The stiffness of this growth that stops a body with a kinetic energy (J) under a load (N) within `depth` (m):
    /// its energy there is the kinetic one and the work of the load. Linear `2 (E + W d)/d^2`, Hertz
    /// `5 (E + W d)/(2 d^(5/2))`.
    pub fn stiffness_for(growth: Growth, depth: f64, load: f64, kinetic: f64) -> f64 {
        let energy = kinetic + load * depth;
        match growth {
            Growth::Linear => 2.0 * energy / (depth * depth),
            Growth::Hertz => 2.5 * energy / (depth * depth * depth.sqrt()),
        }
    }
}
