//! Whether springs at contacts can do what a scene asks: restitution, moduli, radii of curvature, friction, integrator.

use super::{Coordinate, Geometry, Integrator, Material, Scene, SceneError, SpringFriction, SpringLaw};
use polhode_contact::Shape;
use polhode_response::penalty::ElasticPair;

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
    /// When a restitution is not one, springs along the contact have a grain, regularised friction has a static
    /// coefficient of its own, a joint has a limit, or bodies have no moduli or no radii of curvature for Hertz's law.
    pub(crate) fn check_springs(&self) -> Result<(), SceneError> {
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
            let relation = method.relation();
            let number = relation.number_for(relation.reachable(material.restitution()));
            number.map_err(|source| SceneError::SpringRestitution { materials: names(a, b), source })?;
            if material.grain().is_some() && method.friction == Some(SpringFriction::Mindlin) {
                return Err(SceneError::NotYetAvailable {
                    what: "friction with a grain by springs along the contact (method.penalty.friction = \"mindlin\")"
                        .to_owned(),
                    instead: "method.penalty.friction = \"regularised\"".to_owned(),
                });
            }
            let [kinetic, at_rest] = [material.friction_ellipse(), material.static_ellipse()];
            if method.is_regularised(&material) && at_rest != kinetic {
                return Err(SceneError::NotYetAvailable {
                    what: format!(
                        "static friction above kinetic (`{}` on `{}`) where friction of springs is regularised, which \
                         does not stick",
                        self.bodies[a].material.name(),
                        self.bodies[b].material.name()
                    ),
                    instead: "method.penalty.friction = \"mindlin\" without a grain, or response = \"constraint\""
                        .to_owned(),
                });
            }
            if is_hertz {
                elastic_pair(&self.bodies[a].material, &self.bodies[b].material)?;
            }
        }
        self.check_jointed_springs()?;
        if is_hertz { self.check_curvature() } else { Ok(()) }
    }

    /// Checks that joints have no limits: springs have no stops.
    ///
    /// # Errors
    /// With the first joint that has one.
    fn check_jointed_springs(&self) -> Result<(), SceneError> {
        for (number, joint) in self.joints.iter().enumerate() {
            let is_limited = |&coordinate: &Coordinate| joint.limits(coordinate).is_some();
            if joint.kind().coordinates().iter().any(is_limited) {
                return Err(SceneError::NotYetAvailable {
                    what: format!("a limit of joint {number} with response = \"penalty\""),
                    instead: "the joint without it, or response = \"constraint\"".to_owned(),
                });
            }
        }
        Ok(())
    }

    /// The smallest restitution of materials that may meet and what a damped spring reaches instead; none where all are
    /// reached.
    pub(crate) fn restitution_out_of_reach(&self) -> Option<[f64; 2]> {
        let method = self.method.penalty.unwrap_or_default();
        let all = self.material_pairs().into_iter().map(|(a, b)| self.pair_material(a, b).restitution());
        let least = all.fold(f64::INFINITY, f64::min);
        let reached = method.relation().reachable(least);
        (reached > least).then_some([least, reached])
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
