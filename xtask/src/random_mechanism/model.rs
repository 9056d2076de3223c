//! A random mechanism as plain data. Points and directions are those of the world at the start; whatever turns with a
//! body or is a number is kept as the words of the scene file.

use glam::{DQuat, DVec3};

/// A scene.
#[derive(Debug, Clone)]
pub(crate) struct Mechanism {
    pub(crate) seed: u64,
    /// The kind that it is made as.
    pub(crate) kind: &'static str,
    /// Whether nothing happens within it: no impact, no end of a contact, no stop or start of a slip.
    pub(crate) is_smooth: bool,
    /// s
    pub(crate) duration: f64,
    /// The longest step that a tier of fixed steps is given, s.
    pub(crate) step: f64,
    /// m/s^2
    pub(crate) gravity: DVec3,
    pub(crate) bodies: Vec<Member>,
    pub(crate) joints: Vec<Joint>,
    /// Lines of gears; they name joints.
    pub(crate) gears: Vec<String>,
    pub(crate) tracks: Vec<Curve>,
    pub(crate) forces: Vec<Force>,
    /// Materials, as lines of their tables.
    pub(crate) materials: Vec<String>,
    /// Names of bodies that do not collide.
    pub(crate) apart: Vec<String>,
}

/// A body.
#[derive(Debug, Clone)]
pub(crate) struct Member {
    pub(crate) name: String,
    /// The length that its motion is measured in, m.
    pub(crate) size: f64,
    /// Key and value of its shape, in its own frame.
    pub(crate) shape: Option<String>,
    pub(crate) role: Role,
    /// m
    pub(crate) position: DVec3,
    pub(crate) orientation: DQuat,
    /// m/s
    pub(crate) velocity: DVec3,
    /// rad/s
    pub(crate) angular_velocity: DVec3,
    pub(crate) material: Option<usize>,
    /// Further lines, of its own frame.
    pub(crate) more: Vec<String>,
    /// Whether nothing holds or touches it at the start, so that it may start a little elsewhere.
    pub(crate) is_loose: bool,
}

/// What moves a body.
#[derive(Debug, Clone)]
pub(crate) enum Role {
    /// Nothing.
    Fixed,
    /// A function of time: the name of the motion and its keys. Its velocities at the start are those of the body.
    Moved(&'static str, Keys),
    /// Forces; mass in kg, principal moments in its own axes in kg m^2 if the shape does not say them.
    Free(f64, Option<DVec3>),
}

/// Keys of a table and their values.
pub(crate) type Keys = Vec<(&'static str, Value)>;

/// A value that is placed with the scene.
#[derive(Debug, Clone)]
pub(crate) enum Value {
    Point(DVec3),
    Points(Vec<DVec3>),
    Direction(DVec3),
    /// Words that do not change.
    Text(String),
}

/// A joint.
#[derive(Debug, Clone)]
pub(crate) struct Joint {
    pub(crate) name: String,
    pub(crate) kind: JointKind,
    /// One body or two.
    pub(crate) bodies: Vec<usize>,
    /// One point, or two of a rod and a rope, m.
    pub(crate) anchors: Vec<DVec3>,
    /// The axis or normal; two of a universal joint; of a track its tangent, which is not written.
    pub(crate) axes: Vec<DVec3>,
    /// Of a screw its displacement for each revolution, of a rope its length, m.
    pub(crate) length: f64,
    /// What acts along its coordinates, and other keys.
    pub(crate) keys: Keys,
    /// The rate that is prescribed: of the angle if it is one, rad/s, else of the displacement, m/s.
    pub(crate) rate: Option<(Coordinate, f64)>,
}

/// The kinds of joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum JointKind {
    Ball,
    Hinge,
    Universal,
    Fixed,
    Slider,
    Cylindrical,
    Screw,
    Planar,
    Rod,
    Rope,
    Track,
}

/// A coordinate of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Coordinate {
    Angle,
    Displacement,
}

/// A track.
#[derive(Debug, Clone)]
pub(crate) struct Curve {
    pub(crate) kind: &'static str,
    pub(crate) keys: Keys,
}

/// A force besides gravity.
#[derive(Debug, Clone)]
pub(crate) struct Force {
    pub(crate) kind: &'static str,
    pub(crate) keys: Keys,
}

impl Member {
    /// Whether forces move it.
    pub(crate) fn is_free(&self) -> bool {
        matches!(self.role, Role::Free(..))
    }
}

impl Coordinate {
    /// Its key in a scene file.
    pub(crate) fn key(self) -> &'static str {
        match self {
            Self::Angle => "angle",
            Self::Displacement => "displacement",
        }
    }
}
