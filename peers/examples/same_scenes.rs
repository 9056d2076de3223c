//! A scene in rapier3d-f64: poses, velocities and contact impulses at samples, for `python/same_scenes.py`, which makes
//! the text of the scene and judges what comes back.
//!
//! ```text
//! same_scenes STEP ITERATIONS (simplified|coulomb) < SCENE
//! ```
//!
//! Numbers of a line are divided by blanks (SI units, quaternions `w x y z`). Lines of a scene: `run DURATION SAMPLES`,
//! `material FRICTION RESTITUTION`, `gravity VECTOR(3)`, `floor` or `wall`, `body SHAPE SIZE(3) MASS MOMENTS(3)
//! POSITION(3) QUATERNION(4) LINEAR(3) ANGULAR(3) FORCE(3) KIND` (kind 1 moves along x alone, 2 never), `joint A B
//! ANCHOR(3)`: a hinge along y, -1 is the world; bodies of a scene with joints do not collide. What comes back:
//! `state T BODY` and 13 numbers, `contact T A B POINT(3) NORMAL(3) IMPULSE(3) GAP H BACK`, `wall SECONDS`. Points and
//! gaps are of the poses before the step, from which the engine took them, `BACK` seconds before the states.

use polhode::spatial::{DVec3, Rotation};
use rapier3d::prelude::{
    ColliderBuilder, ColliderHandle, FrictionModel, MassProperties, PhysicsWorld, RevoluteJointBuilder,
    RigidBodyBuilder, RigidBodyHandle, SharedShape,
};
use std::collections::HashMap;
use std::io::Read;
use std::time::Instant;

/// A world that is being built or runs.
struct Run {
    world: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
    numbers: HashMap<ColliderHandle, usize>,
    /// Poses of colliders before the last step.
    before: HashMap<ColliderHandle, rapier3d::math::Pose>,
    duration_s: f64,
    samples: usize,
    friction: f64,
    restitution: f64,
    joined: bool,
}

fn vector(numbers: &[f64], at: usize) -> Result<DVec3, String> {
    match numbers.get(at..at + 3) {
        Some(&[x, y, z]) => Ok(DVec3::new(x, y, z)),
        _ => Err(format!("no vector at {at}")),
    }
}

impl Run {
    fn new(step_s: f64, iterations: usize, model: FrictionModel) -> Self {
        let mut world = PhysicsWorld { gravity: DVec3::NEG_Z * 9.81, ..PhysicsWorld::default() };
        world.integration_parameters.dt = step_s;
        world.integration_parameters.num_solver_iterations = iterations;
        world.integration_parameters.friction_model = model;
        Self {
            world,
            bodies: Vec::new(),
            numbers: HashMap::new(),
            before: HashMap::new(),
            duration_s: 0.0,
            samples: 0,
            friction: 0.0,
            restitution: 0.0,
            joined: false,
        }
    }

    fn plane(&mut self, normal: DVec3) {
        let collider = ColliderBuilder::new(SharedShape::halfspace(normal));
        self.world.insert(RigidBodyBuilder::fixed(), collider.friction(self.friction).restitution(self.restitution));
    }

    fn body(&mut self, shape: &str, n: &[f64]) -> Result<(), String> {
        let (size, mass, moments) = (vector(n, 0)?, n[3], vector(n, 4)?);
        let turn = Rotation::from_wxyz([n[10], n[11], n[12], n[13]]).map_err(|error| error.to_string())?;
        let pose = rapier3d::math::Pose::from_parts(vector(n, 7)?, turn.quaternion());
        let builder = if n[23] >= 2.0 { RigidBodyBuilder::fixed() } else { RigidBodyBuilder::dynamic() };
        let is_free = n[23] < 1.0;
        let body = builder
            .additional_mass_properties(MassProperties::new(DVec3::ZERO, mass, moments))
            .pose(pose)
            .linvel(vector(n, 14)?)
            .angvel(vector(n, 17)?)
            .enabled_translations(true, is_free, is_free)
            .enabled_rotations(is_free, is_free, is_free)
            .can_sleep(false);
        let collider = match shape {
            "sphere" => ColliderBuilder::ball(size.x),
            "box" => ColliderBuilder::cuboid(0.5 * size.x, 0.5 * size.y, 0.5 * size.z),
            "capsule" => ColliderBuilder::capsule_z(0.5 * size.y, size.x),
            // Its axis is y; that of the scene z.
            "cylinder" => {
                ColliderBuilder::cylinder(0.5 * size.y, size.x).rotation(DVec3::X * std::f64::consts::FRAC_PI_2)
            }
            _ => return Err(format!("shape {shape}")),
        };
        let collider = collider.density(0.0).friction(self.friction).restitution(self.restitution);
        let (body, collider) = self.world.insert(body, collider);
        self.world.bodies[body].add_force(vector(n, 20)?, true);
        self.numbers.insert(collider, self.bodies.len());
        self.bodies.push(body);
        Ok(())
    }

    fn joint(&mut self, n: &[f64]) -> Result<(), String> {
        let anchor = vector(n, 2)?;
        if !self.joined {
            self.joined = true;
            for (_, collider) in self.world.colliders.iter_mut() {
                collider.set_sensor(true);
            }
        }
        let world = self.world.insert_body(RigidBodyBuilder::fixed());
        let handle = |k: f64| if k < 0.0 { world } else { self.bodies[k as usize] };
        let ends = [handle(n[0]), handle(n[1])];
        let local = ends.map(|body| self.world.bodies[body].position().inverse() * anchor);
        let joint = RevoluteJointBuilder::new(DVec3::Y).local_anchor1(local[0]).local_anchor2(local[1]);
        self.world.insert_impulse_joint(ends[0], ends[1], joint);
        Ok(())
    }

    fn line(&mut self, line: &str) -> Result<(), String> {
        let mut words = line.split_whitespace();
        let Some(kind) = words.next() else { return Ok(()) };
        let shape = if kind == "body" { words.next().unwrap_or_default() } else { "" };
        let numbers =
            words.map(str::parse).collect::<Result<Vec<f64>, _>>().map_err(|error| format!("{line}: {error}"))?;
        let needed = match kind {
            "run" | "material" => 2,
            "body" => 24,
            "gravity" => 3,
            "joint" => 5,
            _ => 0,
        };
        if numbers.len() < needed {
            return Err(format!("{line}: {needed} numbers are needed"));
        }
        match kind {
            "run" => (self.duration_s, self.samples) = (numbers[0], numbers[1] as usize),
            "material" => (self.friction, self.restitution) = (numbers[0], numbers[1]),
            "gravity" => self.world.gravity = vector(&numbers, 0)?,
            "floor" => self.plane(DVec3::Z),
            "wall" => self.plane(DVec3::X),
            "body" => self.body(shape, &numbers)?,
            "joint" => self.joint(&numbers)?,
            _ => return Err(format!("{line}: unknown")),
        }
        Ok(())
    }

    fn tell(&self, t: f64) {
        for (k, handle) in self.bodies.iter().enumerate() {
            let body = &self.world.bodies[*handle];
            let (p, q, v, w) = (body.translation(), body.rotation(), body.linvel(), body.angvel());
            let numbers = [p.x, p.y, p.z, q.w, q.x, q.y, q.z, v.x, v.y, v.z, w.x, w.y, w.z];
            println!("state {t} {k} {}", numbers.map(|x| x.to_string()).join(" "));
        }
        let dt = self.world.integration_parameters.dt;
        let h = dt / self.world.integration_parameters.num_solver_iterations as f64;
        for pair in self.world.narrow_phase.contact_pairs() {
            let [Some(&one), Some(&two)] = [pair.collider1, pair.collider2].map(|handle| self.before.get(&handle))
            else {
                continue;
            };
            // Its normals point from the first body to the second.
            let bodies =
                [pair.collider2, pair.collider1].map(|handle| self.numbers.get(&handle).map_or(-1, |k| *k as i64));
            for manifold in pair.manifolds() {
                let normal = manifold.data.normal;
                for point in &manifold.points {
                    let [first, second] = [one * point.local_p1, two * point.local_p2];
                    let impulse = normal * point.data.warmstart_impulse - point.data.warmstart_tangent_world;
                    let middle = 0.5 * (first + second);
                    let numbers = [middle, normal, impulse].map(|v| format!("{} {} {}", v.x, v.y, v.z)).join(" ");
                    println!(
                        "contact {t} {} {} {numbers} {} {h} {dt}",
                        bodies[0],
                        bodies[1],
                        normal.dot(second - first)
                    );
                }
            }
        }
    }

    fn run(&mut self) {
        let dt = self.world.integration_parameters.dt;
        let (mut steps, mut wall_s) = (0u64, 0.0);
        for sample in 0..=self.samples {
            let end = self.duration_s * sample as f64 / self.samples as f64;
            let begin = Instant::now();
            while (steps as f64 + 0.5) * dt < end {
                if (steps as f64 + 1.5) * dt >= end {
                    self.before =
                        self.world.colliders.iter().map(|(handle, collider)| (handle, *collider.position())).collect();
                }
                self.world.step();
                steps += 1;
            }
            wall_s += begin.elapsed().as_secs_f64();
            self.tell(steps as f64 * dt);
        }
        println!("wall {wall_s}");
    }
}

fn main() -> Result<(), String> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [step, iterations, model] = &arguments[..] else {
        return Err("same_scenes STEP ITERATIONS MODEL < SCENE".to_owned());
    };
    let step = step.parse().map_err(|error| format!("{step}: {error}"))?;
    let iterations = iterations.parse().map_err(|error| format!("{iterations}: {error}"))?;
    let model = if model == "coulomb" { FrictionModel::Coulomb } else { FrictionModel::Simplified };
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).map_err(|error| error.to_string())?;
    let mut run = Run::new(step, iterations, model);
    for line in text.lines() {
        run.line(line)?;
    }
    run.run();
    Ok(())
}
