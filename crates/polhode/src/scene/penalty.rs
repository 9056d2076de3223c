//! The knobs of the tier `penalty`: laws of the springs between bodies that overlap.
//!
//! What is absent has a default that is not tuned: linear springs with the damper of Hunt and Crossley and sprung
//! friction, as stiff as keeps the overlap within a thousandth of the smallest body.

use super::{Material, SceneError};
use polhode_response::penalty::Relation;

/// How the elastic force of a contact grows with the overlap.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum SpringLaw {
    /// In proportion, with a stiffness from a stated penetration.
    #[default]
    Linear,
    /// With the power 3/2: elastic balls after Hertz, with the moduli of their materials.
    Hertz,
}

/// The damper beside the springs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum SpringDamping {
    /// In proportion to the elastic force too (Hunt and Crossley): the force begins and ends at zero.
    #[default]
    HuntCrossley,
    /// In proportion to the rate of the overlap: the force begins with a jump.
    Plain,
}

/// Friction of the springs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum SpringFriction {
    /// By a spring in the tangent plane that gives way at Coulomb's limit (Mindlin): a contact may stick.
    #[default]
    Mindlin,
    /// Coulomb's law smoothed at a small speed of slip: a contact always creeps.
    Regularised,
}

/// What a scene asks of springs; `None` leaves the choice to the tier.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PenaltyMethod {
    /// How the elastic force grows.
    pub law: Option<SpringLaw>,
    /// The damper.
    pub damping: Option<SpringDamping>,
    /// Friction.
    pub friction: Option<SpringFriction>,
    /// The penetration that linear springs are to keep, m: their stiffness follows from it, the weights and the speeds.
    pub penetration_m: Option<f64>,
    /// The stiffness of linear springs, N/m, in place of a penetration.
    pub stiffness_n_m: Option<f64>,
    /// The speed of slip at which regularised friction is at 1/sqrt(2) of Coulomb's, m/s.
    pub slip_speed_m_s: Option<f64>,
}

impl PenaltyMethod {
    /// Checks the numbers, and that the knobs do not contradict each other.
    ///
    /// # Errors
    /// When a number is not positive and finite, or two knobs exclude each other.
    pub(crate) fn validate(&self) -> Result<(), SceneError> {
        let numbers = [
            ("method.penalty.penetration_m", self.penetration_m),
            ("method.penalty.stiffness_n_m", self.stiffness_n_m),
            ("method.penalty.slip_speed_m_s", self.slip_speed_m_s),
        ];
        for (key, value) in numbers {
            value.map_or(Ok(0.0), |value| super::error::positive(key, value))?;
        }
        let contradicts = |key, reason| Err(SceneError::PenaltyKnob { key, reason });
        if self.penetration_m.is_some() && self.stiffness_n_m.is_some() {
            return contradicts("stiffness_n_m", "the stiffness follows from penetration_m: give one of both");
        }
        let is_hertz = self.law == Some(SpringLaw::Hertz);
        let given = self.penetration_m.map(|_| "penetration_m").or(self.stiffness_n_m.map(|_| "stiffness_n_m"));
        if let (true, Some(key)) = (is_hertz, given) {
            let reason = "law = \"hertz\" has its stiffness from youngs_modulus_pa and poisson_ratio of the materials: \
                          leave it out, or give law = \"linear\"";
            return contradicts(key, reason);
        }
        if self.slip_speed_m_s.is_some() && self.friction != Some(SpringFriction::Regularised) {
            let reason = "only friction = \"regularised\" has a speed of slip: give that too, or leave it out";
            return contradicts("slip_speed_m_s", reason);
        }
        Ok(())
    }

    /// Whether friction of a pair of this material is regularised: as named, or because it has a grain, along which a
    /// spring has no direction of its own.
    pub(crate) fn is_regularised(&self, material: &Material) -> bool {
        self.friction.unwrap_or_default() == SpringFriction::Regularised || material.grain().is_some()
    }

    /// The relation of damping to restitution.
    pub(crate) fn relation(&self) -> Relation {
        match self.damping.unwrap_or_default() {
            SpringDamping::HuntCrossley => Relation::HuntCrossley,
            SpringDamping::Plain => Relation::Plain,
        }
    }
}
