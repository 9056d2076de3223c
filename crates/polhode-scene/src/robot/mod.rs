//! Robots from files: URDF and MJCF.
//!
//! A file is read into a tree of links in its own frames ([`Robot`]), whatever its format, and then assembled into
//! bodies and joints of a scene. All that is wrong with it, differs from it or is ignored of it is a [`Finding`] with
//! its place and its cure.
//!
//! | module | holds |
//! |---|---|
//! | `read` | [`read_robot`]: from a file to a robot |
//! | `model` | [`Robot`]: links, joints and what they have |
//! | `finding` | [`Finding`]: what was found, where, and what to do about it |
//! | `element`, `reading` | XML as a tree with places; attributes |
//! | `urdf`, `mjcf` | the formats |
//! | `joint_extras` | what joints have that is not simulated, for all formats |
//! | `mesh_path` | where meshes are |
//! | `text` | the text of a file, and why it could not be used |
//! | `tree` | whether the joints make a tree |
//! | `posture` | from coordinates to poses |
//! | `rates` | from rates of coordinates to velocities |
//! | `drive` | motors: of the scene, and of actuators of the file |
//! | `weld` | links that move as one, and the sum of their masses |
//! | `combine` | joints one after the other that are one joint |
//! | `shapes` | what collides |
//! | `doctor` | [`examine`]: whether what a file says fits together |
//! | `stage` | the scene that a robot file stands for |
//! | `assemble` | bodies and joints of a scene |

mod assemble;
mod combine;
mod doctor;
mod drive;
mod element;
mod finding;
mod joint_extras;
mod mesh_path;
mod mjcf;
mod model;
mod posture;
mod rates;
mod read;
mod reading;
mod shapes;
mod stage;
mod text;
mod tree;
mod urdf;
mod weld;

pub(crate) use assemble::{Assembly, NamedJoint, RobotGear, assembled};
pub use assemble::{Base, Placement, SelfCollision};
pub use doctor::examine;
pub use drive::{MotorBound, RobotDrive};
pub use finding::{Finding, RobotDefect, RobotPlace, Severity};
pub use model::{
    Actuator, Closure, ClosureKind, EffortLimit, Follower, Geom, GeomForm, Inertial, Keyframe, Link, Robot,
    RobotCoordinate, RobotJoint, RobotJointKind, Root,
};
pub(crate) use read::read_robot_of;
pub use read::{RobotFile, read_robot, read_text};
pub(crate) use stage::{is_robot_file, scene_of};
pub use text::{LARGEST_ROBOT_FILE, RobotFileError};
pub use weld::Unphysical;
