//! A random mechanism as plain data. Points and directions are those of the world at the start; whatever turns with a
//! body or is a number is kept as the words of the scene file.

use glam::{DQuat, DVec3};

/// A scene.
#[derive(Debug, Clone)]
pub struct Mechanism {
    /// The seed that it was made from.
    pub seed: u64,
    /// The kind that it is made as.
    pub kind: &'static str,
    /// Whether nothing happens within it: no impact, no end of a contact, no stop or start of a slip.
    pub is_smooth: bool,
    /// s
    pub duration: f64,
    /// The longest step that a tier of fixed steps is given, s.
    pub step: f64,
    /// m/s^2
    pub gravity: DVec3,
    /// All bodies.
    pub bodies: Vec<Member>,
    /// All joints.
    pub joints: Vec<Joint>,
    /// Lines of gears; they name joints.
    pub gears: Vec<String>,
    /// The curves that joints follow.
    pub tracks: Vec<Curve>,
    /// The forces.
    pub forces: Vec<Force>,
    /// Materials, as lines of their tables.
    pub materials: Vec<String>,
    /// Names of bodies that do not collide.
    pub apart: Vec<String>,
}

/// A body.
#[derive(Debug, Clone)]
pub struct Member {
    /// As the scene names it.
    pub name: String,
    /// The length that its motion is measured in, m.
    pub size: f64,
    /// Key and value of its shape, in its own frame.
    pub shape: Option<String>,
    /// Whether and how it moves.
    pub role: Role,
    /// m
    pub position: DVec3,
    /// From the body to the world.
    pub orientation: DQuat,
    /// m/s
    pub velocity: DVec3,
    /// rad/s
    pub angular_velocity: DVec3,
    /// Which of the materials.
    pub material: Option<usize>,
    /// Further lines, of its own frame.
    pub more: Vec<String>,
    /// Whether nothing holds or touches it at the start, so that it may start a little elsewhere.
    pub is_loose: bool,
}

/// What moves a body.
#[derive(Debug, Clone)]
pub enum Role {
    /// Nothing.
    Fixed,
    /// A function of time: the name of the motion and its keys. Its velocities at the start are those of the body.
    Moved(&'static str, Keys),
    /// Forces; mass in kg, principal moments in its own axes in kg m^2 if the shape does not say them.
    Free(f64, Option<DVec3>),
}

/// Keys of a table and their values.
pub type Keys = Vec<(&'static str, Value)>;

/// A value that is placed with the scene.
#[derive(Debug, Clone)]
pub enum Value {
    /// A point of the world.
    Point(DVec3),
    /// Points of the world.
    Points(Vec<DVec3>),
    /// A direction of the world.
    Direction(DVec3),
    /// Words that do not change.
    Text(String),
}

/// A joint.
#[derive(Debug, Clone)]
pub struct Joint {
    /// As the scene names it.
    pub name: String,
    /// Its kind.
    pub kind: JointKind,
    /// One body or two.
    pub bodies: Vec<usize>,
    /// One point, or two of a rod and a rope, m.
    pub anchors: Vec<DVec3>,
    /// The axis or normal; two of a universal joint; of a track its tangent, which is not written.
    pub axes: Vec<DVec3>,
    /// Of a screw its displacement for each revolution, of a rope its length, m.
    pub length: f64,
    /// What acts along its coordinates, and other keys.
    pub keys: Keys,
    /// The rate that is prescribed: of the angle if it is one, rad/s, else of the displacement, m/s.
    pub rate: Option<(Coordinate, f64)>,
}

/// The kinds of joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JointKind {
    /// A ball joint.
    Ball,
    /// A hinge.
    Hinge,
    /// A universal joint.
    Universal,
    /// No relative motion.
    Fixed,
    /// A slider.
    Slider,
    /// A cylindrical joint.
    Cylindrical,
    /// A screw.
    Screw,
    /// Motion in a plane.
    Planar,
    /// A distance that is kept.
    Rod,
    /// A distance that is not exceeded.
    Rope,
    /// A point on a track.
    Track,
}

/// A coordinate of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coordinate {
    /// Of a rotation.
    Angle,
    /// Of a displacement.
    Displacement,
}

/// A track.
#[derive(Debug, Clone)]
pub struct Curve {
    /// As the scene format calls it.
    pub kind: &'static str,
    /// What it is given.
    pub keys: Keys,
}

/// A force besides gravity.
#[derive(Debug, Clone)]
pub struct Force {
    /// As the scene format calls it.
    pub kind: &'static str,
    /// What it is given.
    pub keys: Keys,
}

impl Member {
    /// Whether forces move it.
    pub fn is_free(&self) -> bool {
        matches!(self.role, Role::Free(..))
    }
}

impl Coordinate {
    /// Its key in a scene file.
    pub fn key(self) -> &'static str {
        match self {
            Self::Angle => "angle",
            Self::Displacement => "displacement",
        }
    }
}
