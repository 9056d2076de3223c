//! A scene in rapier3d-f64, with its defaults (4 substeps), on one thread.
//!
//! Its impulses are those of its last substep: they, with the velocities after it, are what its solver has come to.
//! They are judged with Coulomb friction at each point, which it offers beside its default (one friction for each
//! face), since only then each of its contacts has a law of its own.

use super::judge::{Judged, Moved};
use super::scenes::{Form, Scene};
use polhode::spatial::{DVec3, Pose, Rotation};
use rapier3d::prelude::{
    ColliderBuilder, ColliderHandle, FrictionModel, MassProperties, PhysicsWorld, RigidBodyBuilder, RigidBodyHandle,
};
use std::collections::HashMap;
use std::time::Instant;

/// What is left as it is, and what is not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Settings {
    /// Defaults.
    Defaults,
    /// Bodies do not fall asleep.
    Awake,
    /// Bodies do not fall asleep, and each point has its own friction.
    Judged,
}

/// A run.
pub(crate) struct Peer {
    world: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
    numbers: HashMap<ColliderHandle, usize>,
}

fn pose(pose: &Pose) -> rapier3d::math::Pose {
    rapier3d::math::Pose::from_parts(pose.translation, pose.rotation.quaternion())
}

impl Peer {
    pub(crate) fn new(scene: &Scene, settings: Settings) -> Self {
        let mut world = PhysicsWorld { gravity: DVec3::NEG_Z * 9.81, ..PhysicsWorld::default() };
        world.integration_parameters.dt = scene.step;
        if settings == Settings::Judged {
            world.integration_parameters.friction_model = FrictionModel::Coulomb;
        }
        for plane in &scene.planes {
            let collider = ColliderBuilder::new(rapier3d::prelude::SharedShape::halfspace(plane.normal));
            let body = RigidBodyBuilder::fixed().translation(plane.point);
            world.insert(body, collider.friction(scene.friction));
        }
        let (mut bodies, mut numbers) = (Vec::new(), HashMap::new());
        for (number, member) in scene.members.iter().enumerate() {
            let properties = MassProperties::new(DVec3::ZERO, member.mass, member.form.moments(member.mass));
            let body = RigidBodyBuilder::dynamic()
                .additional_mass_properties(properties)
                .pose(pose(&member.pose))
                .linvel(member.velocity)
                .can_sleep(settings == Settings::Defaults);
            let collider = match member.form {
                Form::Box(edges) => ColliderBuilder::cuboid(0.5 * edges.x, 0.5 * edges.y, 0.5 * edges.z),
                Form::Sphere(radius) => ColliderBuilder::ball(radius),
            };
            let (body, collider) = world.insert(body, collider.density(0.0).friction(scene.friction));
            bodies.push(body);
            numbers.insert(collider, number);
        }
        Self { world, bodies, numbers }
    }

    /// One step; its time, s.
    pub(crate) fn step(&mut self) -> f64 {
        let begin = Instant::now();
        self.world.step();
        begin.elapsed().as_secs_f64()
    }

    pub(crate) fn bodies(&self) -> Vec<Moved> {
        let moved = |handle: &RigidBodyHandle| {
            let body = &self.world.bodies[*handle];
            let pose = body.position();
            Moved {
                pose: Pose::new(Rotation::renormalized(pose.rotation), pose.translation),
                linear: body.linvel(),
                angular: body.angvel(),
            }
        };
        self.bodies.iter().map(moved).collect()
    }

    /// Its contacts with their impulses in the last substep.
    pub(crate) fn contacts(&self) -> Vec<Judged> {
        let mut judged = Vec::new();
        for pair in self.world.narrow_phase.contact_pairs() {
            let poses = [pair.collider1, pair.collider2].map(|handle| *self.world.colliders[handle].position());
            // Its normals point from the first body to the second.
            let bodies = [pair.collider2, pair.collider1].map(|handle| self.numbers.get(&handle).copied());
            for manifold in pair.manifolds() {
                let normal = manifold.data.normal;
                for point in &manifold.points {
                    let [first, second] = [poses[0] * point.local_p1, poses[1] * point.local_p2];
                    let impulse = normal * point.data.warmstart_impulse - point.data.warmstart_tangent_world;
                    let point = 0.5 * (first + second);
                    judged.push(Judged { bodies, point, normal, impulse, gap: normal.dot(second - first) });
                }
            }
        }
        judged
    }

    /// The length of a substep as a part of a step.
    pub(crate) fn substep(&self) -> f64 {
        1.0 / self.world.integration_parameters.num_solver_iterations as f64
    }
}
