//! A contact that slides: whether a finite force exists (Painleve 1895).
//!
//! A contact that touches (`u_n = 0`) and slides in the direction `d` has the normal acceleration `b + a f_n`, with `b`
//! that without a contact force and `a = K_nn - mu k.d` ([`Coulomb`]). Coulomb's law asks for
//! `0 <= f_n _|_ b + a f_n >= 0`:
//!
//! | `a` | `b` | |
//! |---|---|---|
//! | positive | negative | one force, `f_n = -b / a` |
//! | positive | not negative | no force |
//! | not positive | negative | no force at all satisfies the law: an impact without a collision |
//! | negative | not negative | indeterminate: no force, or `f_n = -b / a`, or an impact |
//!
//! The impact without a collision follows the path of an impact from zero approach: the bodies are driven into each
//! other until the slip has stopped, and leave from there. It is what stiffer and stiffer contacts tend to.
//!
//! Source: Painleve 1895; Lecornu 1905; Genot and Brogliato 1999.

use super::collision_matrix::CollisionMatrix;
use super::coulomb::Coulomb;
use super::law::RestitutionLaw;
use super::outcome::FrictionalImpact;
use super::plane;
use super::single::SingleFrictionalImpact;
use crate::error::{ResponseError, check_finite};

/// A contact that touches and slides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingContact {
    /// The collision matrix of the contact, 1/kg.
    pub collision: CollisionMatrix,
    /// Slip along the two tangents, m/s; not zero.
    pub slip: [f64; 2],
    /// Coefficient of friction (no unit), at least 0.
    pub friction: f64,
    /// Normal acceleration without a force at this contact, m/s^2.
    pub free_acceleration: f64,
}

/// Which forces a contact that slides can have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SlidingForce {
    /// One force, N.
    Regular(f64),
    /// None: the contact opens, or stays just so.
    Separates,
    /// No finite force satisfies Coulomb's law: an impulse without a collision.
    Inconsistent,
    /// Coulomb's law allows the contact to open, to slide on with this force (N), and an impulse: it does not decide.
    Indeterminate(f64),
}

impl SlidingContact {
    /// `a`, the normal acceleration by a unit of normal force with its friction, 1/kg.
    ///
    /// # Errors
    /// When a number is not finite, the slip is zero, or the friction is negative.
    pub fn normal_rate(&self) -> Result<f64, ResponseError> {
        check_finite("slip", &self.slip)?;
        check_finite("free acceleration", &[self.free_acceleration])?;
        if !(self.friction >= 0.0 && self.friction.is_finite()) {
            return Err(ResponseError::Friction { contact: 0, friction: self.friction });
        }
        let direction = plane::direction(self.slip).ok_or(ResponseError::NoSlip)?;
        Ok(Coulomb { matrix: self.collision, friction: self.friction }.normal_rate(direction))
    }

    /// Which forces the contact can have.
    ///
    /// ```
    /// use polhode_response::{CollisionMatrix, SlidingContact, SlidingForce};
    /// // Painleve's rod: 1 kg, 2 m, at 60 degrees to the floor, pushed along by its upper end.
    /// let (sin, cos) = (0.75_f64.sqrt(), 0.5);
    /// let rod = SlidingContact {
    ///     collision: CollisionMatrix::planar(1.0 + 3.0 * cos * cos, -3.0 * sin * cos, 1.0 + 3.0 * sin * sin)?,
    ///     slip: [-1.0, 0.0],
    ///     friction: 1.5,
    ///     free_acceleration: -9.81,
    /// };
    /// assert_eq!(rod.forces()?, SlidingForce::Inconsistent);
    /// assert!(matches!(SlidingContact { friction: 0.5, ..rod }.forces()?, SlidingForce::Regular(_)));
    /// # Ok::<(), polhode_response::ResponseError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`normal_rate`](Self::normal_rate).
    pub fn forces(&self) -> Result<SlidingForce, ResponseError> {
        let (rate, free) = (self.normal_rate()?, self.free_acceleration);
        let force = -free / rate;
        Ok(match (rate > 0.0, free < 0.0) {
            (true, true) if force.is_finite() => SlidingForce::Regular(force),
            (_, true) => SlidingForce::Inconsistent,
            (false, false) if force.is_finite() => SlidingForce::Indeterminate(force),
            (_, false) => SlidingForce::Separates,
        })
    }

    /// The impact without a collision: the path of an impact that begins with this slip and no approach. Nothing
    /// happens where the contact does not jam, whatever accelerates it. With Newton's law and `e > 0` too the bodies
    /// part without restitution, for there is no approach to restore.
    ///
    /// # Errors
    /// Those of [`normal_rate`](Self::normal_rate) and [`SingleFrictionalImpact::resolve`].
    pub fn impact_without_collision(
        &self,
        restitution: f64,
        law: RestitutionLaw,
    ) -> Result<FrictionalImpact, ResponseError> {
        self.normal_rate()?;
        let velocity_before = [0.0, self.slip[0], self.slip[1]];
        let (collision, friction) = (self.collision, self.friction);
        SingleFrictionalImpact { collision, velocity_before, friction, restitution, law }.resolve()
    }
}
