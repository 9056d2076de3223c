//! A scene in polhode, with the defaults of a tier; one thread.

use super::judge::{Judged, Moved};
use super::scenes::{Form, Scene};
use polhode::contact::Shape;
use polhode::scene::{Material, Method, Tier};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, UnitVector, Velocity};
use polhode::{Body, BodyId, Certificate, Geometry, Simulation};
use std::time::Instant;

/// A run.
pub(crate) struct Ours {
    simulation: Simulation,
    /// Number of the first movable body.
    first: usize,
    step: f64,
    steps: usize,
}

impl Ours {
    pub(crate) fn new(scene: &Scene, tier: Tier) -> Result<Self, String> {
        Self::build(scene, tier).map_err(|error| error.to_string())
    }

    fn build(scene: &Scene, tier: Tier) -> Result<Self, Box<dyn std::error::Error>> {
        let method = Method { tier: Some(tier), step_s: Some(scene.step), ..Method::default() };
        let material = Material::new("rough").with_friction(scene.friction)?;
        let duration = scene.step * (scene.steps + 1) as f64;
        let mut builder =
            polhode::Scene::builder(scene.name).method(method).duration_s(duration).output_interval_s(duration);
        for (k, plane) in scene.planes.iter().enumerate() {
            let shape = Shape::half_space(UnitVector::new(plane.normal)?);
            let body = Body::fixed(format!("plane {k}")).geometry(shape.into());
            builder = builder.body(body.pose(Pose::from_translation(plane.point)).material(material.clone()));
        }
        for (k, member) in scene.members.iter().enumerate() {
            let inertia = Inertia::from_diagonal(member.form.moments(member.mass))?;
            let properties = MassProperties::new(Mass::new(member.mass)?, DVec3::ZERO, inertia);
            let shape = match member.form {
                Form::Box(edges) => Shape::cuboid(edges)?,
                Form::Sphere(radius) => Shape::sphere(radius)?,
            };
            let body = Body::movable(format!("body {k}"), properties).geometry(Geometry::Shape(shape));
            let velocity = Velocity::new(member.velocity, DVec3::ZERO);
            builder = builder.body(body.pose(member.pose).velocity(velocity).material(material.clone()));
        }
        let simulation = Simulation::new(&builder.build()?)?;
        Ok(Self { simulation, first: scene.planes.len(), step: scene.step, steps: 0 })
    }

    /// One step; its time, s.
    pub(crate) fn step(&mut self) -> Result<f64, String> {
        self.steps += 1;
        let begin = Instant::now();
        self.simulation.advance_to(self.steps as f64 * self.step).map_err(|error| error.to_string())?;
        Ok(begin.elapsed().as_secs_f64())
    }

    pub(crate) fn bodies(&self) -> Vec<Moved> {
        let moved = |sample: &polhode::BodySample| Moved {
            pose: sample.pose,
            linear: sample.velocity.linear,
            angular: sample.velocity.angular,
        };
        self.simulation.bodies().iter().skip(self.first).map(moved).collect()
    }

    /// Contacts with their mean forces of the last step, as impulses.
    pub(crate) fn contacts(&self) -> Vec<Judged> {
        let body = |id: BodyId| id.index().checked_sub(self.first);
        let views = self.simulation.contacts();
        let judged = views.iter().map(|view| Judged {
            bodies: [body(view.body_a), body(view.body_b)],
            point: view.point_m,
            normal: view.normal,
            impulse: (view.normal * view.normal_force_n + view.friction_n) * self.step,
            gap: view.separation_m,
        });
        judged.collect()
    }

    /// What the run itself tells.
    pub(crate) fn certificate(&self) -> Certificate {
        self.simulation.frame().certificate
    }
}
