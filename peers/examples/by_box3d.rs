//! A scene in Box3D: poses and velocities at samples, for `python/same_scenes.py`, in the text of `same_scenes.rs`.
//!
//! ```text
//! by_box3d STEP SUBSTEPS RESTITUTION_THRESHOLD < SCENE
//! ```
//!
//! Box3D computes in f32. It has no plane: floor and wall are boxes of 200 m. It has no cylinder, and refuses it.

use polhode_peers::box3d::{
    Body, BodyCreateOptions, BodyDef, BodyType, Filter, MassData, Matrix3, MotionLocks, Quat, RevoluteJointDef,
    ShapeDef, SurfaceMaterial, Transform, Vec3, World,
};
use std::io::Read;
use std::time::Instant;

/// Half the size of what stands for a plane, m.
const PLANE: f32 = 100.0;

/// What the lines of a scene say.
#[derive(Default)]
struct Text {
    duration_s: f64,
    samples: usize,
    friction: f32,
    restitution: f32,
    gravity: Vec3,
    planes: Vec<Vec3>,
    bodies: Vec<(String, Vec<f64>)>,
    joints: Vec<Vec<f64>>,
}

fn vector(n: &[f64], at: usize) -> Vec3 {
    Vec3::new(n[at] as f32, n[at + 1] as f32, n[at + 2] as f32)
}

impl Text {
    fn line(&mut self, line: &str) -> Result<(), String> {
        let mut words = line.split_whitespace();
        let Some(kind) = words.next() else { return Ok(()) };
        let shape = if kind == "body" { words.next().unwrap_or_default() } else { "" };
        let n = words.map(str::parse).collect::<Result<Vec<f64>, _>>().map_err(|error| format!("{line}: {error}"))?;
        let needed = match kind {
            "run" | "material" => 2,
            "body" => 24,
            "joint" => 5,
            "gravity" => 3,
            _ => 0,
        };
        if n.len() < needed {
            return Err(format!("{line}: {needed} numbers are needed"));
        }
        match kind {
            "run" => (self.duration_s, self.samples) = (n[0], n[1] as usize),
            "material" => (self.friction, self.restitution) = (n[0] as f32, n[1] as f32),
            "gravity" => self.gravity = vector(&n, 0),
            "floor" => self.planes.push(Vec3::new(0.0, 0.0, 1.0)),
            "wall" => self.planes.push(Vec3::new(1.0, 0.0, 0.0)),
            "body" => self.bodies.push((shape.to_owned(), n)),
            "joint" => self.joints.push(n),
            _ => return Err(format!("{line}: unknown")),
        }
        Ok(())
    }

    fn surface(&self) -> ShapeDef {
        let material =
            SurfaceMaterial { friction: self.friction, restitution: self.restitution, ..SurfaceMaterial::default() };
        // Bodies of a scene with joints do not collide.
        let mask_bits = if self.joints.is_empty() { u64::MAX } else { 0 };
        let filter = Filter { mask_bits, ..Filter::default() };
        ShapeDef { surface_material: Some(material), filter, ..ShapeDef::default() }
    }
}

/// A body; what belongs to it lives as long as the world.
fn body<'w>(world: &'w World, text: &Text, shape: &str, n: &[f64]) -> Result<Body<'w>, String> {
    let def = BodyDef {
        body_type: if n[23] >= 2.0 { BodyType::Static } else { BodyType::Dynamic },
        position: vector(n, 7),
        rotation: Quat::new(vector(n, 11), n[10] as f32),
        linear_velocity: vector(n, 14),
        angular_velocity: vector(n, 17),
        ..BodyDef::default()
    };
    let body = world.create_body_with_options(def, BodyCreateOptions { allow_fast_rotation: true });
    let size = vector(n, 0);
    let half = Vec3::new(0.5 * size.x, 0.5 * size.y, 0.5 * size.z);
    std::mem::forget(match shape {
        "sphere" => body.create_sphere(Vec3::ZERO, size.x, text.surface()),
        "box" => body.create_box(half, text.surface()),
        "capsule" => {
            let end = Vec3::new(0.0, 0.0, half.y);
            body.create_capsule(Vec3::new(0.0, 0.0, -half.y), end, size.x, text.surface())
        }
        _ => return Err(format!("Box3D has no {shape}")),
    });
    if n[23] < 2.0 {
        let m = vector(n, 4);
        let inertia =
            Matrix3 { cx: Vec3::new(m.x, 0.0, 0.0), cy: Vec3::new(0.0, m.y, 0.0), cz: Vec3::new(0.0, 0.0, m.z) };
        body.set_mass_data(MassData { mass: n[3] as f32, center: Vec3::ZERO, inertia });
        let locked = n[23] >= 1.0;
        body.set_motion_locks(MotionLocks {
            linear_x: false,
            linear_y: locked,
            linear_z: locked,
            angular_x: locked,
            angular_y: locked,
            angular_z: locked,
        });
    }
    Ok(body)
}

/// Hinges along y: their axis is z of their frames.
fn hinge<'w>(world: &'w World, ground: &Body<'w>, bodies: &[Body<'w>], n: &[f64]) {
    let of = |k: f64| if k < 0.0 { ground } else { &bodies[k as usize] };
    let (a, b) = (of(n[0]), of(n[1]));
    let frame = |body: &Body<'w>| {
        let half = std::f32::consts::FRAC_1_SQRT_2;
        let q = body.rotation();
        // q* times the turn about x by -90 degrees.
        let (w, v) = (q.s, Vec3::new(-q.v.x, -q.v.y, -q.v.z));
        let turn = Vec3::new(half * (v.x - w), half * (v.y - v.z), half * (v.z + v.y));
        Transform::new(body.local_point(vector(n, 2)), Quat::new(turn, half * (w + v.x)))
    };
    let mut def = RevoluteJointDef::new(a, b);
    (def.base.local_frame_a, def.base.local_frame_b) = (frame(a), frame(b));
    std::mem::forget(world.create_revolute_joint(def));
}

fn tell(bodies: &[Body<'_>], t: f64) {
    for (k, body) in bodies.iter().enumerate() {
        let (p, q, v, w) = (body.position(), body.rotation(), body.linear_velocity(), body.angular_velocity());
        let numbers = [p.x, p.y, p.z, q.s, q.v.x, q.v.y, q.v.z, v.x, v.y, v.z, w.x, w.y, w.z];
        println!("state {t} {k} {}", numbers.map(|x| x.to_string()).join(" "));
    }
}

fn main() -> Result<(), String> {
    let arguments: Vec<f64> = std::env::args()
        .skip(1)
        .map(|word| word.parse().map_err(|error| format!("{word}: {error}")))
        .collect::<Result<_, _>>()?;
    let [step, substeps, threshold] = arguments[..] else {
        return Err("by_box3d STEP SUBSTEPS RESTITUTION_THRESHOLD < SCENE".to_owned());
    };
    let mut input = String::new();
    std::io::stdin().read_to_string(&mut input).map_err(|error| error.to_string())?;
    let mut text = Text::default();
    for line in input.lines() {
        text.line(line)?;
    }
    let world = World::new(text.gravity);
    world.set_sleeping_enabled(false);
    world.set_restitution_threshold(threshold as f32);
    let ground = world.create_body(BodyDef::default());
    let mut planes = Vec::new();
    for normal in &text.planes {
        let plane = world.create_body(BodyDef::static_at(Vec3::new(-PLANE * normal.x, 0.0, -PLANE * normal.z)));
        std::mem::forget(plane.create_box(Vec3::new(PLANE, PLANE, PLANE), text.surface()));
        planes.push(plane);
    }
    let bodies = text.bodies.iter().map(|(shape, n)| body(&world, &text, shape, n)).collect::<Result<Vec<_>, _>>()?;
    for joint in &text.joints {
        hinge(&world, &ground, &bodies, joint);
    }
    let (mut steps, mut wall_s) = (0u64, 0.0);
    for sample in 0..=text.samples {
        let end = text.duration_s * sample as f64 / text.samples as f64;
        let begin = Instant::now();
        while (steps as f64 + 0.5) * step < end {
            for (body, (_, n)) in bodies.iter().zip(&text.bodies) {
                body.apply_force_to_center(vector(n, 20), true);
            }
            world.step(step as f32, substeps as i32);
            steps += 1;
        }
        wall_s += begin.elapsed().as_secs_f64();
        tell(&bodies, steps as f64 * step);
    }
    println!("wall {wall_s}");
    Ok(())
}
