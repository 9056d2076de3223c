//! A robot as its file describes it: a tree of links that joints connect, in the frames of the file, in SI units.
//! Nothing here knows which format it was read from.
//!
//! `X_PL` is the pose of a link in its parent at the reference value of its joint, `X_LG` that of a geometry in its
//! link.

use super::finding::RobotPlace;
use crate::files::Files;
use glam::{DMat3, DVec3};
use polhode::spatial::{Pose, UnitVector};
use std::path::PathBuf;

/// A robot.
#[derive(Debug, Clone)]
pub struct Robot {
    /// Its name.
    pub name: String,
    /// Where it begins.
    pub place: RobotPlace,
    /// Its links; the first is the root.
    pub links: Vec<Link>,
    /// What connects them: each link but the root is the child of one.
    pub joints: Vec<RobotJoint>,
    /// What closes loops.
    pub loops: Vec<Closure>,
    /// Coordinates that follow others.
    pub followers: Vec<Follower>,
    /// Pairs of links that do not collide.
    pub apart: Vec<[usize; 2]>,
    /// Motors that its file gives and that are simulated.
    pub actuators: Vec<Actuator>,
    /// Names of all that its file gives, in its order.
    pub actuator_names: Vec<String>,
    /// States that its file gives by name.
    pub keyframes: Vec<Keyframe>,
    /// Gravity that its file gives, m/s^2, in the frame of the model.
    pub gravity: Option<DVec3>,
    /// What holds the root when the scene does not say.
    pub root: Root,
    /// The files that it was read from.
    pub files: Vec<PathBuf>,
    /// Where these and its meshes are.
    pub(crate) source: Files,
}

/// What the root link of a file stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Root {
    /// A link as any other: it is free unless it has no mass.
    Link,
    /// The world: ground, and what stands around the robot.
    World,
}

/// A rigid part.
#[derive(Debug, Clone)]
pub struct Link {
    /// Its name.
    pub name: String,
    /// Where it is given.
    pub place: RobotPlace,
    /// Its mass properties.
    pub inertial: Option<Inertial>,
    /// What collides.
    pub collisions: Vec<Geom>,
    /// What is seen.
    pub visuals: Vec<Geom>,
}

/// Mass properties as a file gives them: not checked yet.
#[derive(Debug, Clone)]
pub struct Inertial {
    /// Where they are given.
    pub place: RobotPlace,
    /// Mass, kg.
    pub mass: f64,
    /// `X_LC`: the frame of the inertia in the link, with its origin at the centre of mass.
    pub frame: Pose,
    /// Inertia about the centre of mass in the axes of `frame`, kg m^2.
    pub inertia: DMat3,
}

/// A geometry of a link.
#[derive(Debug, Clone)]
pub struct Geom {
    /// Where it is given.
    pub place: RobotPlace,
    /// `X_LG`.
    pub pose: Pose,
    /// What it is.
    pub form: GeomForm,
}

/// What a geometry is, in its own frame.
#[derive(Debug, Clone)]
pub enum GeomForm {
    /// A box about the origin.
    Box {
        /// Full edges, m.
        size: DVec3,
    },
    /// A ball about the origin.
    Sphere {
        /// Radius, m.
        radius: f64,
    },
    /// A cylinder about the z axis.
    Cylinder {
        /// Radius, m.
        radius: f64,
        /// Height, m.
        height: f64,
    },
    /// A capsule about the z axis.
    Capsule {
        /// Radius, m.
        radius: f64,
        /// Height without the caps, m.
        height: f64,
    },
    /// An ellipsoid about the origin.
    Ellipsoid {
        /// Semi-axes, m.
        semi_axes: DVec3,
    },
    /// All below the plane z = 0.
    Plane,
    /// A mesh in a file.
    Mesh {
        /// As the file names it.
        name: String,
        /// Where it is, if it was found.
        path: Option<PathBuf>,
        /// What its coordinates are multiplied by.
        scale: DVec3,
    },
}

/// What connects a link to its parent.
#[derive(Debug, Clone)]
pub struct RobotJoint {
    /// Its name.
    pub name: String,
    /// Where it is given.
    pub place: RobotPlace,
    /// Number of the parent link.
    pub parent: usize,
    /// Number of the child link.
    pub child: usize,
    /// `X_PL` at the reference values of the coordinates.
    pub origin: Pose,
    /// The point that stays, in the frame of the child, m.
    pub anchor: DVec3,
    /// What it leaves free.
    pub kind: RobotJointKind,
    /// What acts along its coordinates, in the order of those of the engine's joint of this kind.
    pub coordinates: Vec<RobotCoordinate>,
}

/// What a joint leaves free. Axes are in the frame of the child at the reference values of its coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RobotJointKind {
    /// Nothing.
    Fixed,
    /// All motions.
    Free,
    /// All rotations about the anchor.
    Ball,
    /// Rotation about an axis.
    Hinge {
        /// The axis.
        axis: UnitVector,
    },
    /// Displacement along an axis.
    Slider {
        /// The axis.
        axis: UnitVector,
    },
    /// Both.
    Cylindrical {
        /// The axis.
        axis: UnitVector,
    },
    /// Rotations about two axes at right angles.
    Universal {
        /// That of the child, that of the parent.
        axes: [UnitVector; 2],
    },
    /// Displacements in a plane and rotation about its normal.
    Planar {
        /// The normal.
        normal: UnitVector,
    },
}

impl RobotJointKind {
    /// How many numbers a keyframe has for its coordinates and for their rates.
    pub(crate) const fn sizes(self) -> [usize; 2] {
        match self {
            Self::Free => [7, 6],
            Self::Ball => [4, 3],
            Self::Hinge { .. } | Self::Slider { .. } => [1, 1],
            Self::Fixed | Self::Cylindrical { .. } | Self::Universal { .. } | Self::Planar { .. } => [0, 0],
        }
    }

    /// Its name in messages.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Fixed => "fixed",
            Self::Free => "free",
            Self::Ball => "ball",
            Self::Hinge { .. } => "hinge",
            Self::Slider { .. } => "slider",
            Self::Cylindrical { .. } => "cylindrical",
            Self::Universal { .. } => "universal",
            Self::Planar { .. } => "planar",
        }
    }
}

/// A coordinate of a joint.
#[derive(Debug, Clone, PartialEq)]
pub struct RobotCoordinate {
    /// Its name: that of the joint in the file.
    pub name: String,
    /// Where it is given.
    pub place: RobotPlace,
    /// Its value in the pose of the file, rad or m.
    pub reference: f64,
    /// The smallest and the largest value, rad or m.
    pub limits: Option<[f64; 2]>,
    /// Constant of a damper, N m s/rad or N s/m.
    pub damping: f64,
    /// Friction: the torque or force that resists motion, N m or N.
    pub friction: f64,
    /// Stiffness of a spring, N m/rad or N/m.
    pub stiffness: f64,
    /// The value at which the spring is at rest, rad or m.
    pub rest: f64,
    /// The largest effort of its motors, N m or N; none where the file has no bound.
    pub effort_limit: Option<EffortLimit>,
}

/// The largest effort of the motors of a coordinate.
#[derive(Debug, Clone, PartialEq)]
pub struct EffortLimit {
    /// Where it is given.
    pub place: RobotPlace,
    /// What it is in the file, as in "effort of the limit".
    pub what: &'static str,
    /// Its size, N m or N.
    pub most: f64,
}

/// A motor of a file at a coordinate of a joint.
///
/// With the gear `r`, the control `u` and the coordinate `q` it exerts the effort `r f` (N m, N) along the coordinate,
/// `f = (g0 + g1 l + g2 l') u + b0 + b1 l + b2 l'` with `l = r q`: the affine actuator of MJCF (docs/REFERENCES.md,
/// MJCF).
#[derive(Debug, Clone, PartialEq)]
pub struct Actuator {
    /// Its name.
    pub name: String,
    /// Where it is given.
    pub place: RobotPlace,
    /// What its file calls it: `motor`, `position`, ...
    pub kind: String,
    /// Name of the joint.
    pub joint: String,
    /// `r`: what it moves for each unit of the coordinate.
    pub gear: f64,
    /// `g0`, `g1`, `g2`.
    pub gain: [f64; 3],
    /// `b0`, `b1`, `b2`.
    pub bias: [f64; 3],
    /// Its damping over the critical one, where the file gives it so: it takes the place of `-b2`.
    pub damping_ratio: Option<f64>,
    /// The smallest and the largest control.
    pub control_range: Option<[f64; 2]>,
    /// The smallest and the largest `f`, N m or N.
    pub force_range: Option<[f64; 2]>,
}

/// A state that a file gives by name.
#[derive(Debug, Clone, PartialEq)]
pub struct Keyframe {
    /// Its name; its number where it has none.
    pub name: String,
    /// Where it is given.
    pub place: RobotPlace,
    /// Coordinates of the joints one after the other: pose of a free joint (m, quaternion w x y z), quaternion of a
    /// ball joint, rad or m of others.
    pub coordinates: Option<Vec<f64>>,
    /// Their rates: velocity along the axes of the model and angular velocity along those of the body of a free joint,
    /// angular velocity of a ball joint, rad/s or m/s of others.
    pub rates: Option<Vec<f64>>,
    /// Controls of all actuators of the file, in its order.
    pub controls: Option<Vec<f64>>,
}

/// A coordinate that follows another one: `q = multiplier q_leader + offset`.
#[derive(Debug, Clone, PartialEq)]
pub struct Follower {
    /// Where it is given.
    pub place: RobotPlace,
    /// Its name: that of its joint in the file.
    pub name: String,
    /// The name of the one that it follows.
    pub leader: String,
    /// rad or m for each rad or m of the leader.
    pub multiplier: f64,
    /// rad or m.
    pub offset: f64,
}

impl Follower {
    /// Whether it is held at its offset: what it follows does not move it.
    pub fn is_held(&self) -> bool {
        self.multiplier == 0.0
    }
}

/// What closes a loop between two links.
#[derive(Debug, Clone)]
pub struct Closure {
    /// Its name.
    pub name: String,
    /// Where it is given.
    pub place: RobotPlace,
    /// Numbers of the two links.
    pub links: [usize; 2],
    /// Where it is, in the frame of each; the second is where the first one is at the reference values when absent.
    pub frames: [Option<Pose>; 2],
    /// What it holds.
    pub kind: ClosureKind,
}

/// What a closure holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ClosureKind {
    /// One point.
    Point,
    /// All.
    Weld,
}

impl Robot {
    /// The files that it is made of, with those of its meshes.
    pub(crate) fn all_files(&self) -> Vec<PathBuf> {
        let geoms = self.links.iter().flat_map(|link| link.collisions.iter().chain(&link.visuals));
        let of_meshes = geoms.filter_map(|geom| match &geom.form {
            GeomForm::Mesh { path, .. } => path.clone(),
            _ => None,
        });
        self.files.iter().cloned().chain(of_meshes).collect()
    }

    /// The names of its coordinates.
    pub(crate) fn coordinate_names(&self) -> Vec<&str> {
        self.joints.iter().flat_map(|joint| &joint.coordinates).map(|own| own.name.as_str()).collect()
    }

    /// The joint at which a link hangs.
    pub fn joint_of(&self, link: usize) -> Option<&RobotJoint> {
        self.joints.iter().find(|joint| joint.child == link)
    }
}
