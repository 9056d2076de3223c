//! The knobs of the tier `penalty`: laws of the springs between bodies that overlap.
//!
//! What is absent has a default that is not tuned: linear springs with the damper of Hunt and Crossley and sprung
//! friction, as stiff as keeps the overlap within a thousandth of the smallest body.

use super::{Geometry, Integrator, Material, Scene, SceneError};
use polhode_contact::Shape;
use polhode_response::penalty::{ElasticPair, Relation};

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
    pub(super) fn validate(&self) -> Result<(), SceneError> {
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

    /// The relation of damping to restitution.
    pub(crate) fn relation(&self) -> Relation {
        match self.damping.unwrap_or_default() {
            SpringDamping::HuntCrossley => Relation::HuntCrossley,
            SpringDamping::Plain => Relation::Plain,
        }
    }
}

/// E* and G* of two bodies; one of a material without moduli is rigid.
///
/// # Errors
/// When both are rigid.
pub(crate) fn elastic_pair(a: &Material, b: &Material) -> Result<ElasticPair, SceneError> {
    ElasticPair::new([a, b].map(Material::elastic_constants))
        .map_err(|_| SceneError::HertzModulus { materials: [a, b].map(|material| material.name().to_owned()) })
}

impl Scene {
    /// The materials of two bodies.
    pub(crate) fn pair_materials(&self, a: usize, b: usize) -> [&Material; 2] {
        [a, b].map(|body| &self.bodies[body].material)
    }

    /// Checks that springs can do what the materials ask.
    ///
    /// # Errors
    /// When a restitution is out of reach of a damped spring, friction has a grain or resists rotation, or bodies have no moduli
    /// or no radii of curvature for Hertz's law.
    pub(super) fn check_springs(&self) -> Result<(), SceneError> {
        let method = self.method.penalty.unwrap_or_default();
        let taken = [Integrator::Dop853, Integrator::Rk4, Integrator::SemiImplicitEuler, Integrator::ImplicitMidpoint];
        if let Some(integrator) = self.method.integrator.filter(|named| !taken.contains(named)) {
            return Err(SceneError::NotYetAvailable {
                what: format!("integrator = \"{}\" with response = \"penalty\"", integrator.name()),
                instead: taken.map(|one| format!("\"{}\"", one.name())).join(" or "),
            });
        }
        let unused = [
            (self.method.impact.is_some(), "impact"),
            (self.method.restitution_law.is_some(), "restitution_law"),
            (self.method.contact.is_some(), "contact"),
            (self.method.crowding.is_some(), "crowding"),
            (self.method.crowding_tolerance.is_some(), "crowding_tolerance"),
        ];
        if let Some((_, key)) = unused.into_iter().find(|(is_given, _)| *is_given) {
            let what = format!("method.{key} with response = \"penalty\", which has no such law");
            return Err(SceneError::NotYetAvailable { what, instead: "the scene without it".to_owned() });
        }
        let names = |a: usize, b: usize| [a, b].map(|body| self.bodies[body].material.name().to_owned());
        let is_hertz = method.law == Some(SpringLaw::Hertz);
        for (a, b) in self.material_pairs() {
            let material = self.pair_material(a, b);
            let reachable = method.relation().number_for(material.restitution());
            reachable.map_err(|source| SceneError::SpringRestitution { materials: names(a, b), source })?;
            let what = if material.grain().is_some() {
                "friction with a grain"
            } else if material.rolling_friction() > 0.0 || material.spinning_friction() > 0.0 {
                "friction of rolling or spinning"
            } else {
                if is_hertz {
                    elastic_pair(&self.bodies[a].material, &self.bodies[b].material)?;
                }
                continue;
            };
            let instead = "response = \"constraint\"".to_owned();
            return Err(SceneError::NotYetAvailable { what: format!("{what} with response = \"penalty\""), instead });
        }
        if is_hertz { self.check_curvature() } else { Ok(()) }
    }

    /// Checks that every pair that may touch has radii of curvature: a ball, on a ball or on what has flat faces.
    fn check_curvature(&self) -> Result<(), SceneError> {
        let shaped = self.bodies.iter().filter(|body| body.shape().is_some());
        for body in shaped {
            let is_round = matches!(body.shape(), Some(Geometry::Shape(Shape::Sphere(_))));
            let is_flat = matches!(body.shape(), Some(Geometry::Shape(Shape::HalfSpace(_) | Shape::Convex(_))));
            let moves = !body.is_fixed() && body.motion().is_none();
            if !is_round && (moves || !is_flat) {
                return Err(SceneError::HertzShape { body: body.name().to_owned() });
            }
        }
        Ok(())
    }
}
