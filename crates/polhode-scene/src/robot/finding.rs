//! What a robot file is refused for, what differs from what it asks for, and what of it is ignored: each with its
//! place, its size and its cure.

use crate::mesh_file_error::MeshFileError;
use glam::DVec3;
use polhode::contact::ShapeError;
use polhode::mesh::{MeshError, PrimitiveError};
use polhode::spatial::{InertiaError, MassPropertiesError};
use std::fmt;
use std::path::Path;
use std::sync::Arc;
use thiserror::Error;

/// A place in a robot file.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct RobotPlace {
    /// The file.
    pub file: Arc<Path>,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
}

impl fmt::Display for RobotPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.file.display(), self.line, self.column)
    }
}

/// What a finding means for the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The file is refused.
    Refused,
    /// The robot is loaded, and is likely not what was meant.
    Warning,
    /// Something in the file has no effect.
    Ignored,
    /// Something acts that one may not expect of a file: what it is.
    Read,
}

impl Severity {
    /// As messages begin.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Refused => "error",
            Self::Warning => "warning",
            Self::Ignored => "ignored",
            Self::Read => "read",
        }
    }
}

/// What was found: where, of what, and what is wrong.
#[derive(Debug)]
pub struct Finding {
    /// Where.
    pub place: RobotPlace,
    /// What it is about, as in "link `arm`".
    pub subject: String,
    /// What is wrong.
    pub defect: RobotDefect,
}

impl Finding {
    /// What it means for the robot.
    pub fn severity(&self) -> Severity {
        self.defect.severity()
    }

    /// What to do about it.
    pub fn cure(&self) -> String {
        self.defect.cure()
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}: {}: {}", self.place, self.severity().name(), self.subject, self.defect)?;
        let cure = self.cure();
        if cure.is_empty() { Ok(()) } else { write!(f, "\n  cure: {cure}") }
    }
}

/// What can be wrong with a robot file. Each message has the value; [`Finding::cure`] says what is accepted.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum RobotDefect {
    /// The text is not XML.
    #[error("not XML: {0}")]
    Xml(String),
    /// The root is that of no robot.
    #[error("the root element is <{0}>")]
    Root(String),
    /// The file is a template that still has to be expanded.
    #[error("{0} is written in xacro, a language of macros, and not in URDF")]
    Xacro(String),
    /// An element is missing.
    #[error("<{0}> is missing")]
    MissingElement(&'static str),
    /// An attribute is missing.
    #[error("attribute `{0}` is missing")]
    MissingAttribute(&'static str),
    /// An attribute is not made of the numbers it needs.
    #[error("{attribute}=\"{value}\" is not accepted")]
    Numbers {
        /// The attribute.
        attribute: String,
        /// What it is.
        value: String,
        /// What is accepted.
        accepted: String,
    },
    /// A word is not among those accepted.
    #[error("{attribute}=\"{value}\" is not known")]
    Word {
        /// The attribute.
        attribute: &'static str,
        /// What it is.
        value: String,
        /// What is accepted.
        accepted: &'static str,
    },
    /// A name is borne twice.
    #[error("a second {0} of this name")]
    DuplicateName(&'static str),
    /// A name that nothing bears.
    #[error("no {kind} is named `{name}`")]
    UnknownName {
        /// What should bear it.
        kind: &'static str,
        /// The name.
        name: String,
    },
    /// A link hangs at two joints.
    #[error("it is the child of two joints, `{first}` and this one")]
    TwoParents {
        /// The first joint.
        first: String,
    },
    /// Links hang at each other in a circle.
    #[error("it hangs at itself, over {0}")]
    Cycle(String),
    /// Several links hang at nothing.
    #[error("it hangs at no joint, as `{0}` does not either")]
    SecondRoot(String),
    /// There is no link.
    #[error("it has no links")]
    Empty,
    /// Elements are nested too deep, or files include each other.
    #[error("{what} are nested deeper than {limit}")]
    Depth {
        /// What.
        what: &'static str,
        /// The limit.
        limit: usize,
    },
    /// An included file cannot be read.
    #[error("cannot read {file}: {reason}")]
    Include {
        /// The file.
        file: String,
        /// Why.
        reason: String,
    },
    /// An axis has no direction.
    #[error("its axis {0} has no length")]
    Axis(DVec3),
    /// The lower limit is above the upper one.
    #[error("its limits contradict each other: the lower one is {lower}, the upper one {upper}, which leaves {} less \
        than nothing", upper - lower)]
    Limits {
        /// The lower limit, rad or m.
        lower: f64,
        /// The upper limit, rad or m.
        upper: f64,
    },
    /// The limits leave one value.
    #[error("its limits leave it one value, {0}")]
    NoRange(f64),
    /// The limits span a revolution or more.
    #[error("its limits span {} rad, a revolution or more: they are not kept", few(*_0))]
    Revolution(f64),
    /// A bound of a motor leaves it nothing.
    #[error("its {what} is at most {value}: no motor could move it")]
    Bound {
        /// Which bound.
        what: &'static str,
        /// The bound, N m or N, rad/s or m/s.
        value: f64,
    },
    /// A coordinate is outside its limits at the start.
    #[error("it is at {value}, outside its limits from {lower} to {upper}")]
    BeyondLimits {
        /// The value, rad or m.
        value: f64,
        /// The lower limit.
        lower: f64,
        /// The upper limit.
        upper: f64,
    },
    /// The zero of a coordinate is outside its limits, and it starts elsewhere.
    #[error("zero is outside its limits from {lower} to {upper}: it starts at {start}")]
    StartMoved {
        /// The lower limit, rad or m.
        lower: f64,
        /// The upper limit, rad or m.
        upper: f64,
        /// Where it starts.
        start: f64,
    },
    /// A joint that cannot start elsewhere than at zero is asked to.
    #[error("a {0} joint starts as its file says, and has no coordinate that can be given")]
    NoCoordinate(&'static str),
    /// A mass is none.
    #[error("mass {0} kg is no mass")]
    Mass(f64),
    /// A link has inertia and no mass.
    #[error("it has inertia and a mass of 0")]
    InertiaWithoutMass,
    /// An inertia that no body can have.
    #[error("no body can have this inertia: {0}")]
    Inertia(InertiaError),
    /// An inertia that no body can have was replaced.
    #[error("no body can have its principal moments {}: they are replaced by {} kg m^2", few_of(*found), few_of(*made))]
    InertiaRepaired {
        /// Moments that the file gives, kg m^2, ascending.
        found: DVec3,
        /// The nearest moments that a body can have.
        made: DVec3,
    },
    /// Mass properties that do not add up.
    #[error(transparent)]
    MassProperties(#[from] MassPropertiesError),
    /// A link that moves has no mass.
    #[error("it moves and has no mass: forces would accelerate it without bound")]
    Massless,
    /// A link that moves has a mass in one point or on one line.
    #[error("it turns and has no inertia about some axis: {0}")]
    NoInertia(InertiaError),
    /// A link without mass, at the end of its branch, is left out.
    #[error("it has no mass and carries none: it is left out, with its joint")]
    LeftOut,
    /// A size is not positive.
    #[error("a {what} of {value} m is not accepted")]
    Size {
        /// Which size.
        what: &'static str,
        /// The size, m.
        value: f64,
    },
    /// A shape is refused.
    #[error(transparent)]
    Shape(#[from] ShapeError),
    /// A primitive has no mass properties.
    #[error(transparent)]
    Primitive(PrimitiveError),
    /// A mesh is refused.
    #[error("{file}: {source}")]
    Mesh {
        /// The file.
        file: String,
        /// Why.
        source: MeshError,
    },
    /// A mesh that gives a mass bounds no solid.
    #[error("{file} gives its mass, and {source}")]
    MassOfMesh {
        /// The file.
        file: String,
        /// Why.
        source: MeshError,
    },
    /// A mesh file cannot be used.
    #[error(transparent)]
    MeshFile(#[from] MeshFileError),
    /// A mesh file is in no folder that was looked at.
    #[error("mesh {0} is not found")]
    MeshNotFound(String),
    /// A mesh for collisions is in a format that is not read.
    #[error("collision mesh {0} is in a format that is not read: the link collides without it")]
    MeshFormat(String),
    /// A mesh has no convex hull.
    #[error("the hull of mesh {file} has no volume ({source}): the link collides without it")]
    FlatMesh {
        /// The file.
        file: String,
        /// Why.
        source: ShapeError,
    },
    /// A shape for collisions that there is not.
    #[error("a {0} does not collide: the link collides without it")]
    NoSuchShape(&'static str),
    /// A mesh does not bound a solid.
    #[error("mesh {file} bounds no solid: {defect}")]
    OpenMesh {
        /// The file.
        file: String,
        /// What is wrong with it.
        defect: String,
    },
    /// A mesh faces inward.
    #[error("mesh {file} faces inward: its volume is {} m^3", few(*volume))]
    InvertedMesh {
        /// The file.
        file: String,
        /// Signed volume, m^3.
        volume: f64,
    },
    /// A mesh is mirrored by its scale.
    #[error("mesh {file} is mirrored by its scale {scale}")]
    Mirrored {
        /// The file.
        file: String,
        /// The scale.
        scale: DVec3,
    },
    /// The mass of a link does not fit its shape.
    #[error("{mass} kg in a shape of {} m^3 are {} kg/m^3, which no part of a robot has", few(*volume), few(*density))]
    Density {
        /// Mass, kg.
        mass: f64,
        /// Volume of the shapes, m^3.
        volume: f64,
        /// Their ratio, kg/m^3.
        density: f64,
    },
    /// The centre of mass is outside the shape.
    #[error("its centre of mass is {} m outside the box around its shape, which is {} m \
        large", few(*distance), few(*size))]
    CenterOutside {
        /// Distance from the box, m.
        distance: f64,
        /// Diagonal of the box, m.
        size: f64,
    },
    /// The inertia does not fit the shape.
    #[error(
        "its principal moments {} are {} times those of its shape evenly filled with its mass, {} kg m^2",
        few_of(*found), few(*ratio), few_of(*expected)
    )]
    InertiaAgainstShape {
        /// Moments that the file gives, kg m^2, ascending.
        found: DVec3,
        /// Moments of the shape, kg m^2, ascending.
        expected: DVec3,
        /// The ratio farthest from one.
        ratio: f64,
    },
    /// Two links overlap at the start.
    #[error("it overlaps `{other}` by {} m at the start", few(*depth))]
    Overlap {
        /// The other link.
        other: String,
        /// How deep, m.
        depth: f64,
    },
    /// A loop is open.
    #[error("its loop does not close: at the start its ends are {} m apart", few(*_0))]
    OpenLoop(f64),
    /// A loop is turned.
    #[error("its loop does not close: at the start its ends are turned by {} rad to each other", few(*_0))]
    TurnedLoop(f64),
    /// Joints of one body that are no joint together.
    #[error("its {count} joints are no joint of this engine together: {why}")]
    Joints {
        /// How many there are.
        count: usize,
        /// Why not.
        why: &'static str,
    },
    /// Limits, springs or dampers of a joint that has no coordinate for them.
    #[error(
        "it is part of a {0} joint, along whose coordinates nothing acts: its limits, springs, dampers and friction \
         are not kept"
    )]
    Unlimited(&'static str),
    /// A configuration gives a coordinate that follows another one a value that does not follow.
    #[error("it follows `{leader}` and is at {value} then, but its configuration says {given}")]
    Follows {
        /// What it follows.
        leader: String,
        /// Its value then, rad or m.
        value: f64,
        /// The value of the configuration.
        given: f64,
    },
    /// A name that nothing bears, among names that are borne.
    #[error("no {kind} is named `{name}`")]
    UnknownOf {
        /// What should bear it.
        kind: &'static str,
        /// The name.
        name: String,
        /// Names that are borne, the nearest first.
        known: String,
    },
    /// A range of controls or efforts that does not rise.
    #[error("its {what} goes from {lower} to {upper}")]
    Range {
        /// Which range.
        what: &'static str,
        /// Its first number.
        lower: f64,
        /// Its second number.
        upper: f64,
    },
    /// An actuator that is not simulated.
    #[error("{0}: it is left out and exerts nothing")]
    ActuatorLeftOut(String),
    /// An actuator whose activation lags behind its control.
    #[error("its filter is not simulated: its effort follows its control at once")]
    NoFilter,
    /// An effort whose bounds differ to both sides.
    #[error("its effort is bounded by {lower} and {upper}: here by {most} to both sides")]
    OneBound {
        /// The lower bound, N m or N.
        lower: f64,
        /// The upper bound, N m or N.
        upper: f64,
        /// What is kept.
        most: f64,
    },
    /// Several actuators of a joint with bounds of their own.
    #[error("{count} actuators drive it, each with its own bound: here their sum is bounded by {most}")]
    SumOfBounds {
        /// How many.
        count: usize,
        /// The sum of the bounds, N m or N.
        most: f64,
    },
    /// A control is outside its range.
    #[error("its control is {value}, outside its range from {lower} to {upper}: it is moved into it")]
    ControlBeyond {
        /// The control.
        value: f64,
        /// The lower end of the range.
        lower: f64,
        /// The upper end.
        upper: f64,
    },
    /// A keyframe has not as many numbers as the robot.
    #[error("`{key}` has {found} numbers, and the robot needs {needed}")]
    KeyLength {
        /// Which numbers.
        key: &'static str,
        /// How many there are.
        found: usize,
        /// How many are needed.
        needed: usize,
        /// What each is for.
        each: &'static str,
    },
    /// A keyframe has a coordinate outside its limits.
    #[error("its keyframe puts it at {value}, outside its limits from {lower} to {upper}: it starts at {start}")]
    KeyBeyond {
        /// The value, rad or m.
        value: f64,
        /// The lower limit.
        lower: f64,
        /// The upper limit.
        upper: f64,
        /// Where it starts.
        start: f64,
    },
    /// Limits of a joint whose motion is prescribed.
    #[error("its limits are not kept: its motion is prescribed")]
    PrescribedBeyond,
    /// What acts.
    #[error("{0}")]
    Read(String),
    /// Something has no effect.
    #[error("{what}{}: {why}", times(*count))]
    Ignored {
        /// What.
        what: String,
        /// How often it occurs.
        count: usize,
        /// Why, or what that means.
        why: &'static str,
    },
}

/// A number to six digits: what is measured is not known better than it is meant.
fn few(number: f64) -> f64 {
    format!("{number:.5e}").parse().unwrap_or(number)
}

/// Three numbers likewise.
fn few_of(vector: DVec3) -> DVec3 {
    DVec3::new(few(vector.x), few(vector.y), few(vector.z))
}

/// How often, when it is not once.
fn times(count: usize) -> String {
    if count == 1 { String::new() } else { format!(" ({count} times)") }
}

impl RobotDefect {
    /// What it means for the robot.
    pub fn severity(&self) -> Severity {
        match self {
            Self::Ignored { .. } | Self::LeftOut => Severity::Ignored,
            Self::NoRange(_)
            | Self::Revolution(_)
            | Self::StartMoved { .. }
            | Self::Bound { .. }
            | Self::MeshFormat(_)
            | Self::FlatMesh { .. }
            | Self::NoSuchShape(_)
            | Self::InertiaRepaired { .. }
            | Self::OpenMesh { .. }
            | Self::InvertedMesh { .. }
            | Self::Mirrored { .. }
            | Self::Density { .. }
            | Self::CenterOutside { .. }
            | Self::InertiaAgainstShape { .. }
            | Self::Overlap { .. }
            | Self::ActuatorLeftOut(_)
            | Self::NoFilter
            | Self::OneBound { .. }
            | Self::SumOfBounds { .. }
            | Self::ControlBeyond { .. }
            | Self::KeyBeyond { .. }
            | Self::Unlimited(_) => Severity::Warning,
            Self::Read(_) | Self::PrescribedBeyond => Severity::Read,
            _ => Severity::Refused,
        }
    }

    /// What to do about it, or what is accepted; empty where there is nothing to do.
    pub fn cure(&self) -> String {
        let text = match self {
            Self::Root(_) => "accepted: <robot> (URDF) or <mujoco> (MJCF)",
            Self::Xacro(_) => "expand it first: `xacro FILE.xacro > FILE.urdf`",
            Self::Numbers { accepted, .. } => return format!("accepted: {accepted}"),
            Self::Word { accepted, .. } => return format!("accepted: {accepted}"),
            Self::DuplicateName(_) => "names must differ",
            Self::TwoParents { .. } => "a link hangs at one joint: close loops by joints of the scene",
            Self::Cycle(_) => {
                "the joints of a URDF make a tree: take out one of these joints, and close the loop by a joint of the \
                 scene"
            }
            Self::SecondRoot(_) => "one link is the root: join the others to it, by fixed joints if need be",
            Self::Axis(_) => "accepted: a direction of any length but zero",
            Self::Limits { .. } => "exchange them, or name the kind `continuous` (URDF) or limited=\"false\" (MJCF)",
            Self::NoRange(_) => "it is taken as fixed: give it a range, or name it `fixed`",
            Self::Revolution(_) => "limits less than 2 pi apart are kept",
            Self::Bound { .. } => "give it the largest effort and velocity of its motor, or take the attribute out",
            Self::BeyondLimits { .. } => "give a value within them in `configuration`",
            Self::StartMoved { .. } => "say where it starts in `configuration` of [[models]]",
            Self::NoCoordinate(_) => "take it out of `configuration`",
            Self::Mass(_) => "accepted: a finite number of at least 0",
            Self::InertiaWithoutMass => {
                "give it its mass, or have the inertia left out: `--set models.0.unphysical=repair`"
            }
            Self::Inertia(_) => {
                "take it from the CAD program anew (about the centre of mass, kg m^2), compute it from a mesh \
                 (`polhode mesh FILE --mass M`), or have it replaced by the nearest one that a body can have: `--set \
                 models.0.unphysical=repair`"
            }
            Self::Massless => "give it an <inertial>, or fix it to its parent",
            Self::NoInertia(_) => "give it an inertia about all axes, however small",
            Self::Size { .. } => "accepted: a positive, finite number",
            Self::MassOfMesh { .. } => {
                "give the body an <inertial>, or mend the mesh: `polhode mesh FILE --repair -o MENDED.obj`"
            }
            Self::MeshNotFound(_) => "name the folder that holds its package in `packages` of [[models]]",
            Self::MeshFormat(_) => "convert it to OBJ, STL, OFF or PLY",
            Self::FlatMesh { .. } => "give it a thickness, or a box in its place",
            Self::NoSuchShape(_) => "accepted: boxes, spheres, cylinders, capsules and meshes",
            Self::OpenMesh { .. } => {
                "`polhode mesh FILE --repair -o MENDED.obj`; collisions use its hull, and are not affected"
            }
            Self::InvertedMesh { .. } => {
                "`polhode mesh FILE --repair -o MENDED.obj` turns it; collisions use its hull, and are not affected"
            }
            Self::Mirrored { .. } => {
                "its triangles are turned, so that it faces outward; a left part from a right one is meant so"
            }
            Self::Density { .. } => "check the unit of the mass (kg) and the scale of the shape (m)",
            Self::CenterOutside { .. } => "check the origin of <inertial>: in metres, in the frame of the link",
            Self::InertiaAgainstShape { .. } => "check the unit (kg m^2), and that it is about the centre of mass",
            Self::Overlap { .. } => "links of one robot do not collide unless `self_collision` is asked for",
            Self::OpenLoop(_) | Self::TurnedLoop(_) => "give a `configuration` in which it closes, or move its anchors",
            Self::UnknownOf { known, .. } => return format!("known: {known}"),
            Self::Range { .. } => "accepted: two numbers, the smaller one first",
            Self::ActuatorLeftOut(_) => "hinges and sliders are driven by `drives` of [[models]]",
            Self::KeyLength { needed, each, .. } => return format!("accepted: {needed} numbers: {each}"),
            Self::Joints { .. } => "put a body with mass between them",
            _ => "",
        };
        text.to_owned()
    }
}

/// All that was found while a file was read.
#[derive(Debug, Default)]
pub(super) struct Findings(Vec<Finding>);

impl Findings {
    /// One more.
    pub(super) fn add(&mut self, place: &RobotPlace, subject: impl Into<String>, defect: RobotDefect) {
        self.0.push(Finding { place: place.clone(), subject: subject.into(), defect });
    }

    /// Whether the file is refused.
    pub(super) fn refuse(&self) -> bool {
        self.0.iter().any(|finding| finding.severity() == Severity::Refused)
    }

    /// All of another list too.
    pub(super) fn extend(&mut self, other: Self) {
        self.0.extend(other.0);
    }

    /// More of them.
    pub(super) fn add_all(&mut self, more: Vec<Finding>) {
        self.0.extend(more);
    }

    /// All of them: what refuses the file first, then by place.
    pub(super) fn into_sorted(self) -> Vec<Finding> {
        let mut list = self.0;
        list.sort_by(|a, b| a.severity().cmp(&b.severity()).then_with(|| a.place.cmp(&b.place)));
        list
    }
}
