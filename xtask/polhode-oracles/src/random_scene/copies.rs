//! The same scene set differently in the world: mirrored, turned, moved, in other units, or started a little elsewhere.
//!
//! In other units lengths are larger by `4^k` and times by `2^k`, so that accelerations are the same numbers, and
//! masses by a power of 4: every number of the scene is then scaled without rounding, and so are the square roots of
//! masses that a Cholesky factor of inverse masses takes, as those of lengths.

use super::model::{Body, Force, Form, Material, Model, Motion, Part, Role, Triangles};
use glam::{DQuat, DVec3};

/// How a scene is set in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SceneCopy {
    /// Mirrored in the plane x = 0.
    Mirrored,
    /// Turned about z by this angle, rad.
    Turned(f64),
    /// Moved by this vector, m.
    Moved(DVec3),
    /// In other units.
    Scaled {
        /// Lengths are larger by 4 to this power, times by 2 to it.
        power: i32,
        /// Masses are larger by 4 to this power.
        mass_power: i32,
    },
    /// Velocities at the start differ by this part of themselves.
    Disturbed(f64),
}

/// Factors of units.
#[derive(Debug, Clone, Copy)]
struct Units {
    length: f64,
    time: f64,
    mass: f64,
}

impl SceneCopy {
    /// The name of its row.
    pub fn name(self) -> &'static str {
        match self {
            Self::Mirrored => "mirrored",
            Self::Turned(_) => "turned",
            Self::Moved(_) => "moved",
            Self::Scaled { .. } => "scaled",
            Self::Disturbed(_) => "disturbed",
        }
    }

    fn units(self) -> Units {
        match self {
            Self::Scaled { power, mass_power } => {
                Units { length: 4.0_f64.powi(power), time: 2.0_f64.powi(power), mass: 4.0_f64.powi(mass_power) }
            }
            _ => Units { length: 1.0, time: 1.0, mass: 1.0 },
        }
    }

    /// Factor of lengths.
    pub fn length(self) -> f64 {
        self.units().length
    }

    /// A vector of the world, without its unit.
    fn direction(self, v: DVec3) -> DVec3 {
        match self {
            Self::Mirrored => DVec3::new(-v.x, v.y, v.z),
            Self::Turned(angle) => DQuat::from_rotation_z(angle) * v,
            Self::Moved(_) | Self::Scaled { .. } | Self::Disturbed(_) => v,
        }
    }

    /// An axis of rotation, whose sense a mirror turns round.
    fn axis(self, v: DVec3) -> DVec3 {
        if self == Self::Mirrored { -self.direction(v) } else { self.direction(v) }
    }

    /// A point of the world.
    pub fn point(self, p: DVec3) -> DVec3 {
        let moved = if let Self::Moved(by) = self { by } else { DVec3::ZERO };
        self.direction(p) * self.units().length + moved
    }

    /// A point in the frame of a body.
    fn own_point(self, p: DVec3) -> DVec3 {
        let p = if self == Self::Mirrored { DVec3::new(-p.x, p.y, p.z) } else { p };
        p * self.units().length
    }

    /// The orientation of a body.
    pub fn orientation(self, q: DQuat) -> DQuat {
        match self {
            Self::Mirrored => self.own_orientation(q),
            Self::Turned(angle) => (DQuat::from_rotation_z(angle) * q).normalize(),
            Self::Moved(_) | Self::Scaled { .. } | Self::Disturbed(_) => q,
        }
    }

    /// The orientation of a part in the frame of a body.
    fn own_orientation(self, q: DQuat) -> DQuat {
        if self == Self::Mirrored { DQuat::from_xyzw(q.x, -q.y, -q.z, q.w) } else { q }
    }

    /// A velocity.
    pub fn velocity(self, v: DVec3) -> DVec3 {
        self.direction(v) * (self.units().length / self.units().time)
    }

    /// An angular velocity.
    pub fn angular_velocity(self, w: DVec3) -> DVec3 {
        self.axis(w) / self.units().time
    }

    /// The scene in this setting.
    pub fn of(self, model: &Model) -> Model {
        let Units { length, time, .. } = self.units();
        Model {
            gravity: self.direction(model.gravity),
            duration: model.duration * time,
            interval: model.interval * time,
            step: model.step * time,
            materials: model
                .materials
                .iter()
                .map(|m| Material { rolling: m.rolling * length, spinning: m.spinning * length, ..*m })
                .collect(),
            bodies: model.bodies.iter().map(|body| self.body(body)).collect(),
            forces: model.forces.iter().map(|force| self.force(force)).collect(),
            ..model.clone()
        }
    }

    fn body(self, body: &Body) -> Body {
        let is_half_space = matches!(body.form, Form::HalfSpace(_));
        let factor = if let Self::Disturbed(by) = self { 1.0 + by } else { 1.0 };
        Body {
            name: body.name.clone(),
            form: match &body.form {
                Form::HalfSpace(normal) => Form::HalfSpace(self.direction(*normal)),
                form => self.form(form),
            },
            role: match &body.role {
                Role::Fixed => Role::Fixed,
                Role::Moved(motion) => Role::Moved(self.motion(motion)),
                Role::Free(mass) => Role::Free(mass * self.units().mass),
            },
            position: self.point(body.position),
            orientation: if is_half_space { body.orientation } else { self.orientation(body.orientation) },
            velocity: self.velocity(body.velocity) * factor,
            angular_velocity: self.angular_velocity(body.angular_velocity) * factor,
            material: body.material,
            pivot: body.pivot.map(|pivot| self.point(pivot)),
        }
    }

    fn triangles(self, solid: &Triangles) -> Triangles {
        let turned = |[a, b, c]: [usize; 3]| if self == Self::Mirrored { [a, c, b] } else { [a, b, c] };
        Triangles {
            vertices: solid.vertices.iter().map(|&vertex| self.own_point(vertex)).collect(),
            triangles: solid.triangles.iter().map(|&triangle| turned(triangle)).collect(),
        }
    }

    fn form(self, form: &Form) -> Form {
        let s = self.units().length;
        match form {
            Form::HalfSpace(normal) => Form::HalfSpace(*normal),
            Form::Cuboid(size) => Form::Cuboid(*size * s),
            Form::Sphere(radius) => Form::Sphere(radius * s),
            Form::Cylinder(radius, height) => Form::Cylinder(radius * s, height * s),
            Form::Cone(radius, height) => Form::Cone(radius * s, height * s),
            Form::Capsule(radius, height) => Form::Capsule(radius * s, height * s),
            Form::Torus(major, minor) => Form::Torus(major * s, minor * s),
            Form::Convex(solid) => Form::Convex(self.triangles(solid)),
            Form::Mesh(solid, pieces) => {
                Form::Mesh(self.triangles(solid), pieces.iter().map(|piece| self.triangles(piece)).collect())
            }
            Form::Compound(parts) => Form::Compound(parts.iter().map(|part| self.part(part)).collect()),
        }
    }

    fn part(self, part: &Part) -> Part {
        Part {
            form: self.form(&part.form),
            position: self.own_point(part.position),
            orientation: self.own_orientation(part.orientation),
        }
    }

    fn motion(self, motion: &Motion) -> Motion {
        let Units { length, time, .. } = self.units();
        match motion {
            Motion::Constant(v, w) => Motion::Constant(self.velocity(*v), self.angular_velocity(*w)),
            Motion::Sine { amplitude, turn, frequency, phase } => Motion::Sine {
                amplitude: self.direction(*amplitude) * length,
                turn: turn.map(|(axis, angle)| (self.axis(axis), angle)),
                frequency: frequency / time,
                phase: *phase,
            },
            Motion::Table(times, positions) => Motion::Table(
                times.iter().map(|t| t * time).collect(),
                positions.iter().map(|&position| self.point(position)).collect(),
            ),
        }
    }

    fn force(self, force: &Force) -> Force {
        let Units { length, time, mass } = self.units();
        // Accelerations are the same numbers: forces grow as masses.
        let (per_length, per_speed) = (mass / length, mass / (length / time));
        match force {
            Force::Anchored { body, point, anchor, stiffness, rest_length, damping } => Force::Anchored {
                body: *body,
                point: self.own_point(*point),
                anchor: self.point(*anchor),
                stiffness: stiffness * per_length,
                rest_length: rest_length * length,
                damping: damping * per_speed,
            },
            Force::Between { bodies, points, stiffness, rest_length, damping } => Force::Between {
                bodies: *bodies,
                points: points.map(|point| self.own_point(point)),
                stiffness: stiffness * per_length,
                rest_length: rest_length * length,
                damping: damping * per_speed,
            },
            Force::Drag { is_quadratic: false, translational, rotational } => Force::Drag {
                is_quadratic: false,
                translational: translational * per_speed,
                rotational: rotational * mass * length * time,
            },
            Force::Drag { is_quadratic: true, translational, rotational } => Force::Drag {
                is_quadratic: true,
                translational: translational * mass / length,
                rotational: rotational * mass * length * time * time,
            },
        }
    }
}
