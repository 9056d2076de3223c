//! Surfaces that a program changes: another friction or restitution while a simulation goes on.

use crate::action_error::ActionError;
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::run::simulation::Simulation;
use crate::scene::{Body, Material};

impl Simulation {
    /// The materials of the bodies at present, by [`BodyId::index`].
    pub fn materials(&self) -> impl Iterator<Item = &Material> {
        self.core.model.scene.bodies().iter().map(Body::made_of)
    }

    /// Friction and restitution between two bodies at present; none for a handle of no body.
    pub fn material_between(&self, a: BodyId, b: BodyId) -> Option<Material> {
        self.core.model.scene.material_between(a, b).ok()
    }

    /// Gives all bodies of the material of this name another friction and restitution, from the present on: what a
    /// slider changes while a simulation runs. Rules for pairs of materials stay. A snapshot is of a simulation with
    /// these materials: to restore one, set the materials that it had first.
    ///
    /// ```
    /// use polhode::mesh::solid_box;
    /// use polhode::prelude::*;
    /// // A brick of friction 0.5 slides on; on ice it would slide further.
    /// let material = |friction| Material::new("brick").with_friction(friction);
    /// let size = DVec3::new(0.2, 0.1, 0.1);
    /// let brick = Body::movable("brick", solid_box(size, Mass::new(2.0)?)?)
    ///     .geometry(Shape::cuboid(size)?.into())
    ///     .material(material(0.5)?)
    ///     .pose(Pose::from_translation(DVec3::Z * 0.05))
    ///     .velocity(Velocity::new(DVec3::X * 2.0, DVec3::ZERO));
    /// let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into()).material(material(0.5)?);
    /// let scene = Scene::builder("ice").body(floor).body(brick).build()?;
    /// let mut simulation = Simulation::new(&scene)?;
    /// simulation.advance_to(0.1)?;
    /// simulation.set_material(&material(0.0)?)?;
    /// let brick = simulation.body_id("brick").ok_or("no brick")?;
    /// let speed = 2.0 - 0.5 * 9.81 * 0.1;
    /// simulation.advance_to(1.0)?;
    /// assert!((simulation.body(brick).velocity.linear.x - speed).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When no body has a material of this name ([`ActionError`]), or a scene with it would be refused (the tier has no
    /// such friction, springs cannot do such a restitution); then nothing has changed.
    pub fn set_material(&mut self, material: &Material) -> Result<(), SimulationError> {
        let mut scene = self.core.model.scene.clone();
        let concerned = scene.replace_material(material);
        if concerned.is_empty() {
            let known = scene.bodies().iter().map(|body| body.made_of().name().to_owned());
            let known: std::collections::BTreeSet<String> = known.filter(|name| !name.is_empty()).collect();
            let known = known.into_iter().collect::<Vec<_>>().join(", ");
            return Err(ActionError::UnknownMaterial { name: material.name().to_owned(), known }.into());
        }
        scene.check_materials()?;
        let held: Vec<usize> = concerned.into_iter().filter(|&body| self.core.model.bodies[body].moves()).collect();
        // What rests on a body of the material, or against it, is concerned as well.
        let concerned = if held.is_empty() { self.core.model.movable.clone() } else { held };
        let again = material.clone();
        self.act(&concerned, &[], "set_material", |simulation| {
            simulation.core.model.scene = scene;
            simulation.core.model.find_what_collides();
            Ok(())
        })?;
        self.repeat_beside(|beside| beside.set_material(&again));
        Ok(())
    }
}
