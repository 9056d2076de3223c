//! Random bodies thrown at walls, and bodies that touch a wall without pressing, each with its motion in closed form.
//!
//! A wall through the origin has the unit normal `n`, vertical or leaning over, so that gravity presses nothing against
//! it; it may glide along itself. Free flight up to the contact; an impact with Coulomb's friction; free flight again.
//! With the velocity `v = v_n n + v_t` at the contact, `v_n < 0`, the slip `u = v_t + w x r - w_wall` and the effective
//! mass `m_t` along the wall:
//!
//! `p_n = (1 + e) m |v_n|`, `p_t = -u min(m_t, mu p_n/|u|)`.
//!
//! A ball has `m_t = m k/(1 + k)` with the moment of inertia `k m R^2`. A box or a cylinder that lands flat, or a
//! capsule or a lying cylinder that slides along its axis, does not turn, so that `m_t = m`, as long as the centre of
//! pressure stays within the face: `mu h` below its half width, with the height `h` of the centre of mass. After an
//! impact without restitution, and for what touches from the start, the normal force is zero: friction has nothing to
//! act with, and the body falls freely along the wall.

use super::bodies::GRAVITY;
use glam::DVec3;
use polhode::contact::Shape;
use polhode::mesh::{Capsule, Cylinder, box_mesh, solid_box, solid_sphere};
use polhode::scene::{Material, PrescribedMotion};
use polhode::spatial::{Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodySample, Scene};
use polhode_oracles::random::Random;
use std::error::Error;
use std::f64::consts::TAU;

/// Moment of inertia of a ball over `m R^2`.
const BALL: f64 = 0.4;

/// Side of a wall that is a box or a mesh, m: no body reaches its edges.
const WALL: f64 = 100.0;

/// A scene of one body and one or two walls, and the state that the body must end in.
#[derive(Debug)]
pub(crate) struct Throw {
    /// What it is.
    pub(crate) name: String,
    /// The body is the first one.
    pub(crate) scene: Scene,
    /// Of the body at the end.
    pub(super) expected: Velocity,
    /// Its place at the end, m.
    pub(crate) place: DVec3,
}

/// What is thrown.
#[derive(Debug)]
struct Thrown {
    name: &'static str,
    properties: MassProperties,
    shape: Shape,
    /// Its attitude when its z axis is the normal of the wall and its x axis lies in it.
    attitude: Rotation,
    /// Distance of its centre from the wall while it touches, m.
    height: f64,
    /// Largest friction with which it does not tip.
    most_friction: f64,
    /// Whether it slides along its axis alone.
    is_lying: bool,
    /// Which spin keeps its contact: about the axis of this unit vector, in the frame of the wall; none for any.
    spin: Option<DVec3>,
}

/// One of the shapes.
fn thrown(random: &mut Random) -> Result<Thrown, Box<dyn Error>> {
    let mass = Mass::new(random.between(0.1, 10.0))?;
    let radius = random.between(0.05, 0.3);
    let length = random.between(2.0, 4.0) * radius;
    let upright = Rotation::IDENTITY;
    let lying = Rotation::from_rotation_vector(DVec3::Y * (0.25 * TAU));
    Ok(match random.below(5) {
        0 => Thrown {
            name: "ball",
            properties: solid_sphere(radius, mass)?,
            shape: Shape::sphere(radius)?,
            attitude: random.rotation(),
            height: radius,
            most_friction: f64::INFINITY,
            is_lying: false,
            spin: None,
        },
        1 => {
            let size = DVec3::new(random.between(0.3, 0.6), random.between(0.3, 0.6), radius);
            Thrown {
                name: "box",
                properties: solid_box(size, mass)?,
                shape: Shape::cuboid(size)?,
                attitude: upright,
                height: 0.5 * size.z,
                most_friction: 0.9 * size.x.min(size.y) / size.z,
                is_lying: false,
                spin: Some(DVec3::Z),
            }
        }
        2 => Thrown {
            name: "cylinder on its face",
            properties: Cylinder::new(radius, 0.5 * length)?.solid(mass)?,
            shape: Shape::cylinder(radius, 0.5 * length)?,
            attitude: upright,
            height: 0.25 * length,
            // Half of the radius: within the triangle of any three contact points.
            most_friction: 2.0 * radius / length,
            is_lying: false,
            spin: Some(DVec3::Z),
        },
        3 => Thrown {
            name: "cylinder on its side",
            properties: Cylinder::new(radius, length)?.solid(mass)?,
            shape: Shape::cylinder(radius, length)?,
            attitude: lying,
            height: radius,
            most_friction: 0.45 * length / radius,
            is_lying: true,
            spin: Some(DVec3::X),
        },
        _ => Thrown {
            name: "capsule",
            properties: Capsule::new(radius, length)?.solid(mass)?,
            shape: Shape::capsule(radius, length)?,
            attitude: lying,
            height: radius,
            most_friction: 0.45 * length / radius,
            is_lying: true,
            spin: Some(DVec3::X),
        },
    })
}

/// A wall: its frame (z is the normal, x and y lie in it), and how it glides along itself, m/s.
#[derive(Debug, Clone, Copy)]
struct Wall {
    frame: Rotation,
    glides: DVec3,
}

impl Wall {
    /// One of any azimuth that leans over by up to 0.3 rad, or is vertical.
    fn any(random: &mut Random) -> Self {
        let lean = if random.below(2) == 0 { 0.0 } else { random.between(0.0, 0.3) };
        let azimuth = random.between(0.0, TAU);
        let turn = |axis: DVec3, angle: f64| Rotation::from_rotation_vector(axis * angle);
        let about_normal = turn(DVec3::Z, random.between(0.0, TAU));
        let frame = turn(DVec3::Z, azimuth) * turn(DVec3::Y, 0.25 * TAU + lean) * about_normal;
        let glides = if random.below(4) == 0 {
            DVec3::new(random.between(-2.0, 2.0), random.between(-2.0, 2.0), 0.0)
        } else {
            DVec3::ZERO
        };
        Self { frame, glides: frame.rotate(glides) }
    }

    fn normal(&self) -> DVec3 {
        self.frame.rotate(DVec3::Z)
    }

    /// The body, given as a half-space, a box or a mesh.
    fn body(&self, random: &mut Random, material: &Material) -> Result<Body, Box<dyn Error>> {
        let half = DVec3::Z * (0.5 * WALL);
        let (shape, pose) = match random.below(3) {
            0 => (Shape::half_space(UnitVector::new(self.normal())?), Pose::IDENTITY),
            kind => {
                let pose = Pose::new(self.frame, self.frame.rotate(-half));
                let size = DVec3::splat(WALL);
                let mesh = || -> Result<Shape, Box<dyn Error>> {
                    let mesh = box_mesh(size)?;
                    Ok(Shape::triangle_mesh(mesh.mesh().vertices().to_vec(), mesh.mesh().triangles().to_vec())?)
                };
                (if kind == 1 { Shape::cuboid(size)? } else { mesh()? }, pose)
            }
        };
        let body = if self.glides == DVec3::ZERO {
            Body::fixed("wall")
        } else {
            Body::kinematic("wall", PrescribedMotion::constant_velocity(Velocity::new(self.glides, DVec3::ZERO))?)
        };
        Ok(body.geometry(shape.into()).pose(pose).material(material.clone()))
    }
}

/// A body in flight: its place (m) and velocity at some time.
#[derive(Debug, Clone, Copy)]
struct Flight {
    place: DVec3,
    velocity: Velocity,
}

impl Flight {
    fn after(self, t: f64) -> Self {
        let g = DVec3::Z * -GRAVITY;
        let linear = self.velocity.linear + g * t;
        Self {
            place: self.place + self.velocity.linear * t + g * (0.5 * t * t),
            velocity: Velocity { linear, ..self.velocity },
        }
    }
}

impl Throw {
    /// The throw of a random number.
    pub(crate) fn random(seed: u64) -> Result<Self, Box<dyn Error>> {
        let mut random = Random(seed);
        let (body, wall) = (thrown(&mut random)?, Wall::any(&mut random));
        let friction = random.between(0.0, 2.0).min(body.most_friction);
        let restitution = if random.below(2) == 0 { 0.0 } else { random.between(0.0, 1.0) };
        let material = Material::new("m")
            .with_friction(friction)?
            .with_restitution(restitution)?
            .with_static_friction(friction * random.between(1.0, 1.5))?;
        let touches = random.below(2) == 0;
        let n = wall.normal();
        // Until the end of the run, and until the contact.
        let (rest, fall) = (random.between(0.1, 0.5), if touches { 0.0 } else { random.between(0.01, 0.3) });
        let along = if body.is_lying && !touches {
            DVec3::X
        } else {
            DVec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.0)
        };
        let along = wall.frame.rotate(along) * random.between(0.0, 5.0);
        let is_still = random.below(4) == 0;
        let approach = if touches { 0.0 } else { random.between(0.5, 5.0) };
        let spins = touches || body.spin.is_none();
        let spin = match body.spin {
            None => random.vector(-10.0, 10.0),
            Some(axis) if spins => wall.frame.rotate(axis) * random.between(-10.0, 10.0),
            Some(_) => DVec3::ZERO,
        };
        let spin = if is_still { DVec3::ZERO } else { spin };
        let mut glides = wall.glides;
        if body.is_lying && !touches {
            // What lands on its side and slides across its axis would roll.
            glides = wall.frame.rotate(DVec3::X) * glides.dot(wall.frame.rotate(DVec3::X));
        }
        let wall = Wall { glides, ..wall };
        // At the contact, on the wall's plane: the flight before is followed backwards.
        let at_contact = Flight {
            place: n * body.height,
            velocity: Velocity::new((if is_still && touches { DVec3::ZERO } else { along }) - n * approach, spin),
        };
        let start = at_contact.after(-fall);
        let mut after = at_contact;
        if !touches {
            after.velocity = struck(&body, at_contact.velocity, (n, wall.glides), (friction, restitution));
        }
        let end = after.after(rest);
        let pose = Pose::new(wall.frame * body.attitude, start.place);
        let name = format!("{} {}, e = {restitution}", body.name, if touches { "that touches" } else { "thrown" });
        let movable = Body::movable("body", body.properties).geometry(body.shape.into()).pose(pose);
        let scene = Scene::builder("throw")
            .gravity(DVec3::Z * -GRAVITY)
            .duration_s(fall + rest)
            .output_interval_s(fall + rest)
            .body(movable.velocity(start.velocity).material(material.clone()))
            .body(wall.body(&mut random, &material)?)
            .build()?;
        Ok(Self { name, scene, expected: end.velocity, place: end.place })
    }

    /// The largest error of a state at the end, m, m/s or rad/s.
    pub(super) fn error(&self, end: &BodySample) -> f64 {
        let errors = [
            end.pose.translation - self.place,
            end.velocity.linear - self.expected.linear,
            end.velocity.angular - self.expected.angular,
        ];
        // What is not a number is infinitely wrong.
        errors
            .iter()
            .map(|error| error.length())
            .fold(0.0, |most: f64, one| if one.is_nan() { f64::INFINITY } else { most.max(one) })
    }
}

/// The velocity after an impact on a wall with this normal that glides at this velocity, with this friction and
/// restitution.
fn struck(body: &Thrown, before: Velocity, (n, glides): (DVec3, DVec3), (friction, e): (f64, f64)) -> Velocity {
    let mass = body.properties.mass();
    let arm = n * -body.height;
    let (share, turns) = if body.spin.is_none() { (BALL / (1.0 + BALL), true) } else { (1.0, false) };
    let approach = -n.dot(before.linear);
    let at_contact = before.linear + if turns { before.angular.cross(arm) } else { DVec3::ZERO };
    let slip = at_contact + n * approach - glides;
    let slip = slip - n * n.dot(slip);
    let normal = (1.0 + e) * mass * approach;
    let (held, most) = (share * mass * slip.length(), friction * normal);
    let tangential = if held > most { slip * (-most / slip.length()) } else { slip * (-share * mass) };
    let linear = before.linear + (n * normal + tangential) / mass;
    let moment = BALL * mass * body.height * body.height;
    let angular = before.angular + if turns { arm.cross(tangential) / moment } else { DVec3::ZERO };
    Velocity::new(linear, angular)
}
