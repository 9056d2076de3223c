//! A random scene as plain data: what is written to a scene file, and what the judge knows of it. SI units.

use glam::{DQuat, DVec3};

/// A scene.
#[derive(Debug, Clone)]
pub struct Model {
    /// The seed that it was made from.
    pub seed: u64,
    /// Acceleration of gravity, m/s^2.
    pub gravity: DVec3,
    /// Simulated time, s.
    pub duration: f64,
    /// Time between samples, s.
    pub interval: f64,
    /// Upper bound of a step, s.
    pub step: f64,
    /// The law of an impact with friction; the default when absent.
    pub restitution_law: Option<RestitutionLaw>,
    /// The law of several impacts at once; the default when absent.
    pub impact: Option<&'static str>,
    /// Materials, each named by its number.
    pub materials: Vec<Material>,
    /// Bodies.
    pub bodies: Vec<Body>,
    /// Forces besides gravity.
    pub forces: Vec<Force>,
}

/// The law of an impact with friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RestitutionLaw {
    /// By this word of the scene format.
    Named(&'static str),
    /// Chatterjee and Ruina, with this tangential restitution.
    ChatterjeeRuina(f64),
}

impl RestitutionLaw {
    /// Whether an impact by this law may raise the energy of the bodies.
    pub fn may_add_energy(self) -> bool {
        matches!(self, Self::Named("newton" | "whittaker"))
    }
}

/// Coefficients of a material.
#[derive(Debug, Clone, Copy)]
pub struct Material {
    /// Coefficient of sliding.
    pub friction: f64,
    /// Coefficient at rest.
    pub static_friction: f64,
    /// m
    pub rolling: f64,
    /// m
    pub spinning: f64,
    /// Coefficient of restitution.
    pub restitution: f64,
}

/// A body.
#[derive(Debug, Clone)]
pub struct Body {
    /// As the scene names it.
    pub name: String,
    /// Its form.
    pub form: Form,
    /// Whether and how it moves.
    pub role: Role,
    /// Of the body's own origin, m.
    pub position: DVec3,
    /// From the body to the world.
    pub orientation: DQuat,
    /// Of the centre of mass, m/s.
    pub velocity: DVec3,
    /// rad/s
    pub angular_velocity: DVec3,
    /// Number of its material.
    pub material: usize,
    /// The point of the world that is held fixed in the body, m.
    pub pivot: Option<DVec3>,
}

/// What moves a body.
#[derive(Debug, Clone)]
pub enum Role {
    /// Nothing.
    Fixed,
    /// A function of time.
    Moved(Motion),
    /// Forces; mass in kg.
    Free(f64),
}

/// A prescribed motion.
#[derive(Debug, Clone)]
pub enum Motion {
    /// Velocity, m/s, and angular velocity, rad/s.
    Constant(DVec3, DVec3),
    /// An oscillation.
    Sine {
        /// m
        amplitude: DVec3,
        /// Axis of a turn, and its largest angle, rad.
        turn: Option<(DVec3, f64)>,
        /// Hz
        frequency: f64,
        /// rad
        phase: f64,
    },
    /// Times, s, and positions, m.
    Table(Vec<f64>, Vec<DVec3>),
}

/// A shape, in the body's own frame.
#[derive(Debug, Clone)]
pub enum Form {
    /// Solid below the plane through the body's position with this outward unit normal.
    HalfSpace(DVec3),
    /// Full edges, m.
    Cuboid(DVec3),
    /// Radius, m.
    Sphere(f64),
    /// Radius and height, m, about z.
    Cylinder(f64, f64),
    /// Radius and height, m, about z, the apex above; the origin is the centre of mass.
    Cone(f64, f64),
    /// Radius and height without the caps, m, about z.
    Capsule(f64, f64),
    /// Radii of the circle in the middle of the tube and of the tube, m, about z.
    Torus(f64, f64),
    /// A convex polyhedron.
    Convex(Triangles),
    /// A polyhedron that is not convex, and the convex solids that it is the union of.
    Mesh(Triangles, Vec<Triangles>),
    /// Parts that are fixed to each other.
    Compound(Vec<Part>),
}

/// A closed surface.
#[derive(Debug, Clone)]
pub struct Triangles {
    /// Corners, m.
    pub vertices: Vec<DVec3>,
    /// Anticlockwise seen from outside.
    pub triangles: Vec<[usize; 3]>,
}

/// A part of a compound.
#[derive(Debug, Clone)]
pub struct Part {
    /// Its form.
    pub form: Form,
    /// Where it stands in the body, m.
    pub position: DVec3,
    /// How it is turned in the body.
    pub orientation: DQuat,
}

/// A force besides gravity.
#[derive(Debug, Clone)]
pub enum Force {
    /// A spring from the centre of a body to the world.
    Anchored {
        /// Number of the body.
        body: usize,
        /// In the body's frame, m.
        point: DVec3,
        /// In the world, m.
        anchor: DVec3,
        /// N/m
        stiffness: f64,
        /// m
        rest_length: f64,
        /// N s/m
        damping: f64,
    },
    /// A spring between two bodies.
    Between {
        /// Numbers of the bodies.
        bodies: [usize; 2],
        /// In their frames, m.
        points: [DVec3; 2],
        /// N/m
        stiffness: f64,
        /// m
        rest_length: f64,
        /// N s/m
        damping: f64,
    },
    /// On every body: linear or quadratic, coefficients of velocity (N s/m or N s^2/m^2) and of turning.
    Drag {
        /// Whether it grows with the square of the velocity.
        is_quadratic: bool,
        /// N s/m or N s^2/m^2
        translational: f64,
        /// N m s or N m s^2
        rotational: f64,
    },
}

impl Body {
    /// Whether forces move it.
    pub fn is_free(&self) -> bool {
        matches!(self.role, Role::Free(_))
    }
}

impl Form {
    /// Distance of the farthest point from the origin at the most, m; infinite for a half-space.
    pub fn reach(&self) -> f64 {
        match self {
            Self::HalfSpace(_) => f64::INFINITY,
            Self::Cuboid(size) => 0.5 * size.length(),
            Self::Sphere(radius) => *radius,
            Self::Cylinder(radius, height) => radius.hypot(0.5 * height),
            Self::Cone(radius, height) => radius.hypot(0.25 * height).max(0.75 * height),
            Self::Capsule(radius, height) => radius + 0.5 * height,
            Self::Torus(major, minor) => major + minor,
            Self::Convex(solid) | Self::Mesh(solid, _) => {
                solid.vertices.iter().map(|vertex| vertex.length()).fold(0.0, f64::max)
            }
            Self::Compound(parts) => {
                parts.iter().map(|part| part.position.length() + part.form.reach()).fold(0.0, f64::max)
            }
        }
    }
}
