//! The scene of a seed: 1 to 8 bodies that forces move, of all shapes, thrown, set down or stacked on ground and among
//! walls, obstacles and bodies of prescribed motion, or among themselves in space; materials, laws and forces at
//! random.
//!
//! No body is put where the judge finds it nearer to another one than a gap, except bodies that are meant to touch:
//! those are set on the ground or on each other to rounding.

use super::model::{Body, Force, Form, Material, Model, Motion, Part, RestitutionLaw, Role};
use super::polyhedra;
use crate::judge;
use crate::random::Random;
use glam::{DQuat, DVec3};
use std::f64::consts::TAU;

/// Attempts to find a free place for a body.
const ATTEMPTS: usize = 60;
/// Least gap between bodies that are not meant to touch, m.
const GAP: f64 = 1e-3;
/// Samples of a scene.
const SAMPLES: f64 = 100.0;
/// An odd number that spreads seeds over the states of the random numbers.
const SPREAD: u64 = 0xD1B5_4A32_D192_ED03;

/// The scene of this seed.
pub fn scene(seed: u64) -> Model {
    // Not a multiple of the increment of the sequence, of which seeds that follow each other would be shifted pieces.
    let mut random = Random(seed.wrapping_add(1).wrapping_mul(SPREAD));
    let mut generator = Generator { random: &mut random, model: empty(seed) };
    generator.setting();
    generator.bodies();
    generator.forces();
    generator.model
}

fn empty(seed: u64) -> Model {
    Model {
        seed,
        gravity: DVec3::new(0.0, 0.0, -9.81),
        duration: 1.0,
        interval: 0.01,
        step: 0.01,
        restitution_law: None,
        impact: None,
        materials: Vec::new(),
        bodies: Vec::new(),
        forces: Vec::new(),
    }
}

struct Generator<'a> {
    random: &'a mut Random,
    model: Model,
}

impl Generator<'_> {
    /// Duration, laws, materials, and what does not move by forces.
    fn setting(&mut self) {
        self.model.duration = self.random.one_of(&[0.5, 1.0, 1.5]);
        self.model.interval = self.model.duration / SAMPLES;
        self.model.restitution_law = match self.random.below(8) {
            0 => Some(RestitutionLaw::Named("poisson")),
            1 => Some(RestitutionLaw::Named("newton")),
            2 => Some(RestitutionLaw::Named("whittaker")),
            3 => Some(RestitutionLaw::ChatterjeeRuina(self.random.between(-1.0, 1.0))),
            4 => Some(RestitutionLaw::Named("stronge")),
            _ => None,
        };
        self.model.impact = match self.random.below(6) {
            0 => Some("propagation"),
            1 => Some("simultaneous"),
            2 => Some("reflection"),
            _ => None,
        };
        for _ in 0..=self.random.below(3) {
            let material = self.material();
            self.model.materials.push(material);
        }
        match self.random.below(6) {
            0 => self.model.gravity = DVec3::ZERO,
            1 => self.slope(),
            2 => self.moving_floor(),
            3 => self.obstacles(),
            _ => self.tray(),
        }
    }

    fn material(&mut self) -> Material {
        let random = &mut *self.random;
        let any = random.between(0.0, 2.0);
        let friction = random.one_of(&[0.0, 0.1, 0.3, 0.5, 1.0, any]);
        let more = random.between(1.0, 2.0);
        let static_friction = friction * random.one_of(&[1.0, 1.0, more]);
        let length = random.between(0.0, 0.005);
        let bounce = random.unit();
        Material {
            friction,
            static_friction,
            rolling: random.one_of(&[0.0, 0.0, length]),
            spinning: random.one_of(&[0.0, 0.0, 2.0 * length]),
            restitution: random.one_of(&[0.0, 0.0, 0.3, 0.5, 1.0, bounce]),
        }
    }

    fn any_material(&mut self) -> usize {
        self.random.below(self.model.materials.len())
    }

    fn still(&mut self, form: Form, position: DVec3, orientation: DQuat, role: Role) {
        let (name, material) = (format!("ground-{}", self.model.bodies.len()), self.any_material());
        let (velocity, angular_velocity) = (DVec3::ZERO, DVec3::ZERO);
        let body = Body { name, form, role, position, orientation, velocity, angular_velocity, material, pivot: None };
        self.model.bodies.push(body);
    }

    /// Level ground, and up to two walls.
    fn tray(&mut self) {
        self.still(Form::HalfSpace(DVec3::Z), DVec3::ZERO, DQuat::IDENTITY, Role::Fixed);
        for _ in 0..self.random.below(3) {
            let angle = self.random.between(0.0, TAU);
            let inwards = DVec3::new(libm::cos(angle), libm::sin(angle), 0.0);
            let distance = self.random.between(0.4, 0.8);
            self.still(Form::HalfSpace(inwards), inwards * -distance, DQuat::IDENTITY, Role::Fixed);
        }
    }

    /// An inclined plane.
    fn slope(&mut self) {
        let (angle, azimuth) = (self.random.between(0.02, 0.8), self.random.between(0.0, TAU));
        let sine = libm::sin(angle);
        let normal = DVec3::new(sine * libm::cos(azimuth), sine * libm::sin(azimuth), libm::cos(angle));
        self.still(Form::HalfSpace(normal), DVec3::ZERO, DQuat::IDENTITY, Role::Fixed);
    }

    /// A plate of prescribed motion over level ground.
    fn moving_floor(&mut self) {
        self.still(Form::HalfSpace(DVec3::Z), DVec3::Z * -2.0, DQuat::IDENTITY, Role::Fixed);
        let (form, tilt) = match self.random.below(3) {
            0 => (Form::HalfSpace(DVec3::Z), false),
            1 => (Form::Cylinder(1.5, 0.1), true),
            _ => (Form::Cuboid(DVec3::new(3.0, 3.0, 0.1)), true),
        };
        let top = if tilt { -0.05 } else { 0.0 };
        let random = &mut *self.random;
        let motion = match random.below(4) {
            0 => {
                let spin = if tilt { DVec3::Z * random.between(-3.0, 3.0) } else { DVec3::ZERO };
                let sideways = random.vector(-0.5, 0.5) * DVec3::new(1.0, 1.0, 0.2);
                Motion::Constant(sideways, spin)
            }
            1 => {
                let times = vec![0.0, 0.3, 0.5, 0.9];
                let rise = random.vector(-0.2, 0.2);
                let at = DVec3::Z * top;
                Motion::Table(times, vec![at, at + rise, at + 1.5 * rise, at + 0.5 * rise])
            }
            _ => {
                let turn = tilt && random.below(2) == 0;
                let axis = random.direction();
                Motion::Sine {
                    amplitude: random.vector(-0.05, 0.05),
                    turn: turn.then_some((axis, random.between(0.01, 0.2))),
                    frequency: random.between(0.5, 5.0),
                    phase: 0.0,
                }
            }
        };
        self.still(form, DVec3::Z * top, DQuat::IDENTITY, Role::Moved(motion));
    }

    /// Level ground with fixed bodies on it.
    fn obstacles(&mut self) {
        self.still(Form::HalfSpace(DVec3::Z), DVec3::ZERO, DQuat::IDENTITY, Role::Fixed);
        for _ in 0..=self.random.below(3) {
            let (size, place) = (self.random.between(0.2, 0.5), self.random.vector(-0.4, 0.4));
            let form = self.form(size);
            let height = self.random.between(0.0, 0.4);
            let orientation = self.orientation();
            self.still(form, DVec3::new(place.x, place.y, height), orientation, Role::Fixed);
        }
    }

    fn orientation(&mut self) -> DQuat {
        match self.random.below(3) {
            0 => DQuat::IDENTITY,
            1 => DQuat::from_rotation_z(self.random.between(0.0, TAU)),
            _ => DQuat::from_axis_angle(self.random.direction(), self.random.between(0.0, TAU)).normalize(),
        }
    }

    /// Any shape of about this size, m.
    fn form(&mut self, size: f64) -> Form {
        if self.random.below(8) == 0 {
            return self.compound(size);
        }
        match self.random.below(8) {
            0 => polyhedra::convex(self.random, size),
            1 => polyhedra::not_convex(self.random, size),
            _ => self.primitive(size),
        }
    }

    fn primitive(&mut self, size: f64) -> Form {
        let random = &mut *self.random;
        let radius = size * random.between(0.2, 0.5);
        let height = size * random.between(0.2, 1.0);
        match random.below(7) {
            0 | 1 => Form::Cuboid(random.vector(0.2, 1.0) * size),
            2 => Form::Sphere(radius),
            3 => Form::Cylinder(radius, height),
            4 => Form::Cone(radius, height),
            5 => Form::Capsule(0.6 * radius, height),
            _ => Form::Torus(radius, radius * random.between(0.15, 0.5)),
        }
    }

    fn compound(&mut self, size: f64) -> Form {
        let count = 2 + self.random.below(2);
        let part = |generator: &mut Self| Part {
            form: generator.primitive(0.6 * size),
            position: generator.random.vector(-0.4, 0.4) * size,
            orientation: generator.orientation(),
        };
        Form::Compound((0..count).map(|_| part(self)).collect())
    }

    /// Bodies that forces move.
    fn bodies(&mut self) {
        let count = self.random.one_of(&[1, 1, 1, 2, 2, 2, 3, 3, 4, 5, 6, 8]);
        let in_space = self.model.gravity == DVec3::ZERO;
        let is_set = !in_space && self.random.below(3) == 0;
        for _ in 0..count {
            if is_set && self.random.below(4) > 0 {
                self.set_down();
            } else {
                self.thrown(in_space);
            }
        }
    }

    fn free(&mut self, form: Form) -> Body {
        let mass = libm::exp10(self.random.between(-1.0, 1.0));
        Body {
            name: format!("body-{}", self.model.bodies.len()),
            form,
            role: Role::Free(mass),
            position: DVec3::ZERO,
            orientation: DQuat::IDENTITY,
            velocity: DVec3::ZERO,
            angular_velocity: DVec3::ZERO,
            material: self.any_material(),
            pivot: None,
        }
    }

    /// A body at a free place, with a velocity; none when no place is found.
    fn thrown(&mut self, in_space: bool) {
        let size = self.random.between(0.1, 0.4);
        let form = self.form(size);
        let mut body = self.free(form);
        for _ in 0..ATTEMPTS {
            body.orientation = self.orientation();
            let place = self.random.vector(-0.4, 0.4);
            body.position = if in_space { place } else { DVec3::new(place.x, place.y, 0.5 + place.z) };
            let is_free = self.model.bodies.iter().all(|other| judge::are_apart(&body, other, GAP));
            if is_free {
                let towards = -body.position * DVec3::new(1.0, 1.0, if in_space { 1.0 } else { 0.3 });
                body.velocity = towards * self.random.between(0.0, 4.0) + self.random.vector(-1.0, 1.0);
                body.angular_velocity = self.random.vector(-1.0, 1.0) * self.random.one_of(&[0.0, 3.0, 10.0]);
                if !in_space && self.random.below(12) == 0 {
                    body.pivot = Some(body.position + self.random.vector(-0.2, 0.2));
                    body.velocity = DVec3::ZERO;
                }
                self.model.bodies.push(body);
                return;
            }
        }
    }

    /// A body that lies on the first plane or on the body that was set down last, and may slide; none where there is no
    /// free place.
    fn set_down(&mut self) {
        let Some(ground) = self.model.bodies.iter().find(|body| matches!(body.form, Form::HalfSpace(_))).cloned()
        else {
            return self.thrown(false);
        };
        let Form::HalfSpace(normal) = ground.form else { return };
        let size = self.random.between(0.1, 0.4);
        let radius = size * self.random.between(0.3, 0.5);
        let height = size * self.random.between(0.3, 1.0);
        let (form, lift) = match self.random.below(6) {
            0 => (Form::Sphere(radius), radius),
            1 => (Form::Cylinder(radius, height), 0.5 * height),
            2 => (Form::Cone(radius, height), 0.25 * height),
            3 => (Form::Torus(radius, 0.3 * radius), 0.3 * radius),
            _ => {
                let edges = self.random.vector(0.3, 1.0) * size;
                (Form::Cuboid(edges), 0.5 * edges.z)
            }
        };
        let mut body = self.free(form);
        let level = (DQuat::from_rotation_arc(DVec3::Z, normal)
            * DQuat::from_rotation_z(self.random.between(0.0, TAU)))
        .normalize();
        for _ in 0..ATTEMPTS {
            let place = self.random.vector(-0.4, 0.4);
            let along = place - normal * normal.dot(place);
            body.orientation = if normal == DVec3::Z && self.random.below(2) == 0 { DQuat::IDENTITY } else { level };
            body.position = ground.position + along + normal * lift;
            let others = self.model.bodies.iter().filter(|other| other.name != ground.name);
            if others.into_iter().all(|other| judge::are_apart(&body, other, GAP)) {
                let speed = self.random.one_of(&[0.0, 0.0, 1.0, 3.0]);
                let along = self.random.vector(-1.0, 1.0) * speed;
                body.velocity = along - normal * normal.dot(along);
                self.model.bodies.push(body);
                return;
            }
        }
    }

    /// Sometimes springs or drag.
    fn forces(&mut self) {
        let free: Vec<usize> = (0..self.model.bodies.len()).filter(|&body| self.model.bodies[body].is_free()).collect();
        let Some(&first) = free.first() else { return };
        let stiffness = libm::exp10(self.random.between(0.5, 2.5));
        let damping = self.random.one_of(&[0.0, 0.0, 0.5]);
        let rest_length = self.random.between(0.1, 0.6);
        let point = self.random.vector(-0.1, 0.1);
        let force = match self.random.below(16) {
            0 => {
                let anchor = self.model.bodies[first].position + self.random.vector(-0.5, 0.5);
                Force::Anchored { body: first, point, anchor, stiffness, rest_length, damping }
            }
            1 => {
                let Some(&second) = free.get(1) else { return };
                let points = [point, self.random.vector(-0.1, 0.1)];
                Force::Between { bodies: [first, second], points, stiffness, rest_length, damping }
            }
            2 => Force::Drag {
                is_quadratic: self.random.below(2) == 0,
                translational: self.random.between(0.01, 1.0),
                rotational: self.random.one_of(&[0.0, 0.001]),
            },
            _ => return,
        };
        self.model.forces.push(force);
    }
}
