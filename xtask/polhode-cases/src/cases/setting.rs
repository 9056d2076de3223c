//! The same scene set differently in the world: turned, moved, in a moving frame, of another size or mass.
//!
//! With lengths times s under the same gravity, times are longer by sqrt(s), velocities too, and angular velocities are
//! smaller by it. What a turned or moved run must show is computed from the samples of the original one.

use super::run::Run;
use glam::DVec3;
use polhode::contact::{ConvexPolyhedron, HalfSpace, Shape, Sphere};
use polhode::scene::{Geometry, Material};
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, BodySample, Effects, Scene};
use std::error::Error;

/// How a scene is set in the world.
#[derive(Debug, Clone, Copy)]
pub(super) struct Setting {
    /// Factor of lengths.
    pub(super) length: f64,
    /// Factor of masses.
    pub(super) mass: f64,
    /// The turn of everything about the origin, gravity included.
    pub(super) turn: Rotation,
    /// The move of everything after the turn, m.
    pub(super) offset: DVec3,
    /// Velocity of the frame, m/s; fixed bodies stay where they are.
    pub(super) boost: DVec3,
}

impl Default for Setting {
    fn default() -> Self {
        Self { length: 1.0, mass: 1.0, turn: Rotation::IDENTITY, offset: DVec3::ZERO, boost: DVec3::ZERO }
    }
}

impl Setting {
    /// Factor of times.
    fn time(&self) -> f64 {
        self.length.sqrt()
    }

    fn point(&self, point: DVec3) -> DVec3 {
        self.turn.rotate(point) * self.length + self.offset
    }

    fn pose(&self, pose: &Pose) -> Pose {
        Pose::new(self.turn * pose.rotation, self.point(pose.translation))
    }

    fn velocity(&self, velocity: &Velocity) -> Velocity {
        let linear = self.turn.rotate(velocity.linear) * self.time() + self.boost;
        Velocity::new(linear, self.turn.rotate(velocity.angular) / self.time())
    }

    /// The scene in this setting.
    ///
    /// # Errors
    /// When it has what cannot be set elsewhere (force fields, meshes), or is refused.
    pub(super) fn apply(&self, scene: &Scene) -> Result<Scene, Box<dyn Error>> {
        if !scene.forces().is_empty() {
            return Err("force fields are not set elsewhere".into());
        }
        let mut set = Scene::builder(scene.name())
            .gravity(self.turn.rotate(scene.gravity()))
            .duration_s(scene.duration_s() * self.time())
            .output_interval_s(scene.output_interval_s() * self.time())
            .method(scene.method().clone());
        for index in 0..scene.bodies().len() {
            set = set.body(self.body(scene, index)?);
        }
        Ok(set.build()?)
    }

    fn body(&self, scene: &Scene, index: usize) -> Result<Body, Box<dyn Error>> {
        let body = &scene.bodies()[index];
        let mut set = match body.mass_properties() {
            None => Body::fixed(body.name()),
            Some(properties) => {
                let moved = self.velocity(body.initial_velocity());
                // The velocity of a pivoted body follows from its spin.
                let linear = if body.pivot_point().is_some() { DVec3::ZERO } else { moved.linear };
                Body::movable(body.name(), self.mass_properties(properties)?)
                    .velocity(Velocity::new(linear, moved.angular))
            }
        };
        // What two materials do to each other is what the scene tells; of two bodies one may have it for both.
        let own = BodyId::new(index);
        let partner = (0..scene.bodies().len()).map(BodyId::new).find(|&other| scene.can_collide(own, other));
        if let Some(partner) = partner {
            let pair = scene.material_between(own, partner)?;
            set = set.material(
                Material::new(body.name()).with_friction(pair.friction())?.with_restitution(pair.restitution())?,
            );
        }
        if let Some(pivot) = body.pivot_point() {
            set = set.pivot(self.point(pivot));
        }
        // The shape of a body that meets no other is for pictures alone.
        match body.shape().filter(|_| partner.is_some()) {
            None => {}
            Some(Geometry::Shape(shape)) => set = set.geometry(self.shape(shape)?.into()),
            Some(Geometry::Mesh(_)) => return Err("meshes are not set elsewhere".into()),
        }
        Ok(set.pose(self.pose(body.initial_pose())))
    }

    fn mass_properties(&self, properties: &MassProperties) -> Result<MassProperties, Box<dyn Error>> {
        let inertia = properties.inertia().matrix() * (self.mass * self.length * self.length);
        let mass = Mass::new(properties.mass() * self.mass)?;
        Ok(MassProperties::new(mass, properties.center_of_mass() * self.length, Inertia::new(inertia)?))
    }

    fn shape(&self, shape: &Shape) -> Result<Shape, Box<dyn Error>> {
        let scaled = |points: &[DVec3]| points.iter().map(|&point| point * self.length).collect::<Vec<_>>();
        Ok(match shape {
            Shape::Convex(convex) => {
                let faces = convex.faces().map(|face| face.vertices.to_vec()).collect();
                Shape::convex(ConvexPolyhedron::from_faces(scaled(convex.vertices()), faces)?)
            }
            Shape::Sphere(sphere) => {
                Shape::Sphere(Sphere::new(sphere.center() * self.length, sphere.radius() * self.length)?)
            }
            Shape::HalfSpace(plane) => {
                let normal = UnitVector::new(plane.normal())?;
                Shape::HalfSpace(HalfSpace::new(normal, plane.offset() * self.length)?)
            }
            Shape::Points(points) => Shape::points(scaled(points.points()))?,
            _ => return Err("a shape that is not set elsewhere".into()),
        })
    }

    /// How far two states of a body are apart that should be the same in two settings: position in units of the
    /// original (m), attitude (rad).
    fn distance(&self, t: f64, original: &BodySample, set: &BodySample, is_fixed: bool) -> f64 {
        let expected = self.pose(&original.pose);
        let carried = if is_fixed { DVec3::ZERO } else { self.boost * (t * self.time()) };
        let apart = (set.pose.translation - carried - expected.translation).length() / self.length;
        apart.max(expected.rotation.angle_to(set.pose.rotation))
    }
}

/// The largest difference between a scene and itself in another setting, over all samples: position in units of the
/// original (m), attitude (rad).
///
/// # Errors
/// When one of them does not run, or they have different samples.
pub(super) fn largest_difference(scene: &Scene, setting: &Setting) -> Result<f64, Box<dyn Error>> {
    let original = Run::of(scene, Effects::Planned)?;
    let set = Run::of(&setting.apply(scene)?, Effects::Planned)?;
    let (count, set_count) = (original.record.times_s.len(), set.record.times_s.len());
    if count != set_count {
        return Err(format!("{count} samples, and {set_count} in the other setting").into());
    }
    let mut most = 0.0f64;
    for ((&t, before), after) in original.record.times_s.iter().zip(&original.record.samples).zip(&set.record.samples) {
        for ((body, before), after) in scene.bodies().iter().zip(before).zip(after) {
            let distance = setting.distance(t, before, after, body.is_fixed());
            most = if distance <= most { most } else { distance };
        }
    }
    Ok(most)
}
