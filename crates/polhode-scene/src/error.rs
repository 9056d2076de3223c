//! What can be wrong with a scene file.

use crate::document::{KeyPath, Step};
use crate::format::MATERIAL_KEYS;
use crate::robot::RobotFileError;
use polhode::SceneError;
use polhode::contact::{ApproximateError, ShapeError};
use polhode::dynamics::field::FieldError;
use polhode::mesh::{MeshError, PrimitiveError, PrismError};
use polhode::scene::{FreedomError, GearError, LimitsError, MotionError, OverlapAtStart};
use polhode::spatial::curve::CurveError;
use polhode::spatial::{InertiaError, MassPropertiesError, RotationError, UnitVectorError};
use std::fmt::{self, Write as _};
use std::io;
use std::path::PathBuf;
use thiserror::Error;

pub use crate::mesh_file_error::MeshFileError;

/// Why a scene file could not be loaded.
#[derive(Debug, Error)]
pub enum SceneFileError {
    /// The file could not be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The file is larger than any scene.
    #[error("{} is larger than {limit} bytes, which no scene is: shapes of many points belong into mesh \
        files", path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// The largest size accepted, bytes.
        limit: u64,
    },
    /// The file is not UTF-8 text.
    #[error("{}:{line}: not a scene file: byte {offset} is not UTF-8 text", path.display())]
    NotText {
        /// The file.
        path: PathBuf,
        /// Line of the first byte that is no text, from 1.
        line: usize,
        /// The byte, from 0.
        offset: usize,
    },
    /// A robot file that stands for a scene is refused.
    #[error(transparent)]
    Robot(#[from] RobotFileError),
    /// A table of boxes that stands for a scene is refused.
    #[error("{}:{line}: {what}; columns of a table of boxes: {accepted}", path.display())]
    Boxes {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: u64,
        /// What is wrong.
        what: String,
        /// What is accepted.
        accepted: String,
    },
    /// The content is refused.
    #[error("{0}")]
    Refused(Box<Refused>),
    /// Several things in the content are refused, in the order of the file: at least two.
    #[error("{}", shown(_0))]
    Several(Vec<Refused>),
}

/// Most errors of a scene that are shown: more do not help.
pub(crate) const MOST_ERRORS: usize = 20;

/// Errors below each other, and how many there are.
fn shown(errors: &[Refused]) -> String {
    let mut text = String::new();
    for error in errors.iter().take(MOST_ERRORS) {
        let _ = write!(text, "{error}\n\n");
    }
    let more = if errors.len() > MOST_ERRORS { " are shown; there are more" } else { "" };
    let _ = write!(text, "{} errors{more}", errors.len().min(MOST_ERRORS));
    text
}

impl SceneFileError {
    /// Of all that is refused; at least one.
    pub(crate) fn of_all(mut errors: Vec<Refused>) -> Self {
        errors.sort_by_key(|error| error.at);
        match (errors.pop(), errors.is_empty()) {
            (Some(only), true) => Self::Refused(Box::new(only)),
            (last, _) => {
                errors.extend(last);
                Self::Several(errors)
            }
        }
    }

    /// The error of a scene that a robot file stands for: that of the robot, if it is the only one.
    pub(crate) fn of_robot(self) -> Self {
        match self {
            Self::Refused(refused) => match *refused {
                Refused { cause: Refusal::Robot(error), .. } => Self::Robot(error),
                other => Self::Refused(Box::new(other)),
            },
            other => other,
        }
    }

    /// Whether reading a file failed, as opposed to what stands in it.
    pub fn is_input_output(&self) -> bool {
        match self {
            Self::Read { .. } => true,
            Self::Refused(refused) => refused.is_input_output(),
            Self::Robot(error) => error.is_input_output(),
            Self::Several(errors) => errors.iter().all(Refused::is_input_output),
            Self::TooLarge { .. } | Self::NotText { .. } | Self::Boxes { .. } => false,
        }
    }

    /// What is refused first, when it is the content.
    pub fn refused(&self) -> Option<&Refused> {
        match self {
            Self::Refused(refused) => Some(refused),
            Self::Several(errors) => errors.first(),
            _ => None,
        }
    }

    /// All that is refused of the content, in the order of the file.
    pub fn all_refused(&self) -> &[Refused] {
        match self {
            Self::Refused(refused) => std::slice::from_ref(&**refused),
            Self::Several(errors) => errors,
            _ => &[],
        }
    }
}

/// Content that is refused; shown with the place and the line.
#[derive(Debug)]
pub struct Refused {
    /// Where.
    pub place: Place,
    /// Why.
    pub cause: Refusal,
    pub(crate) rendered: String,
    /// Where in the texts of the document, bytes: the order of errors.
    pub(crate) at: usize,
}

impl Refused {
    /// What is accepted instead, or what mends it, in a sentence; none when the cause says it already.
    pub fn cure(&self) -> Option<String> {
        self.cause.accepted()
    }

    fn is_input_output(&self) -> bool {
        match &self.cause {
            Refusal::MeshFile(MeshFileError::Read { .. }) => true,
            Refusal::Robot(error) => error.is_input_output(),
            _ => false,
        }
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.rendered)
    }
}

/// A place in a scene file or on the command line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The file, or what else the value comes from.
    pub origin: String,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Dotted path of the key; empty when no key is to blame.
    pub key: String,
}

/// Why content is refused.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Refusal {
    /// The text is not TOML.
    #[error("not TOML: {0}")]
    Syntax(String),
    /// A key that the format does not have.
    #[error("unknown key `{key}`")]
    UnknownKey {
        /// The key.
        key: String,
        /// Keys that are accepted here.
        accepted: String,
    },
    /// A word that is not among those accepted.
    #[error("unknown value `{value}`")]
    UnknownValue {
        /// The value.
        value: String,
        /// Values that are accepted here.
        accepted: String,
    },
    /// A key that must be there is not.
    #[error("missing key `{0}`")]
    MissingKey(String),
    /// A value is of the wrong type or length.
    #[error("{found} is not accepted here")]
    Type {
        /// What was found.
        found: String,
        /// What is accepted.
        accepted: String,
    },
    /// A body has no kind of shape, or several.
    #[error("a shape is exactly one of the kinds")]
    ShapeKinds,
    /// A force has no kind, or several.
    #[error("a force is exactly one of the kinds")]
    ForceKinds,
    /// A prescribed motion has no kind, or several.
    #[error("a motion is exactly one of the kinds")]
    MotionKinds,
    /// A prescribed motion of a coordinate has no kind, or several.
    #[error("a motion of a coordinate is exactly one of the kinds")]
    CoordinateMotionKinds,
    /// A joint has no kind, or several.
    #[error("a joint is exactly one of the kinds")]
    JointKinds,
    /// The curve of a track has no kind, or several.
    #[error("a curve is exactly one of the kinds")]
    CurveKinds,
    /// A motor has no drive, or several.
    #[error("a motor is exactly one of `effort`, `velocity` and `position`")]
    MotorKinds,
    /// An array has no kind of layout, or several.
    #[error("a layout is exactly one of the kinds")]
    LayoutKinds,
    /// Arrays hold more bodies than a scene may have.
    #[error("{found} bodies are too many: a scene with arrays may have {limit}, which make 2^31 pairs")]
    TooManyBodies {
        /// How many bodies there are up to the end of the array.
        found: u64,
        /// The limit.
        limit: u64,
    },
    /// The region of a drop is too small for its bodies.
    #[error(
        "the region has room for {room} of {count} bodies, each in a ball of {ball_m} m in diameter: a larger `size` \
         or a smaller `count` is needed"
    )]
    NoRoom {
        /// How many bodies there are.
        count: u32,
        /// For how many there is room.
        room: u64,
        /// Diameter of the ball that holds a body, m.
        ball_m: f64,
    },
    /// Something else that the format's reader refuses.
    #[error("{0}")]
    Other(String),
    /// Asked for is something that is designed but not built.
    #[error("not yet available: {what}")]
    NotYetAvailable {
        /// What.
        what: String,
        /// What can be used instead.
        instead: String,
    },
    /// Another version of the format.
    #[error("version {0} of the scene format is not known")]
    Version(u32),
    /// A number is outside what is accepted.
    #[error("{value} is not accepted")]
    Number {
        /// The value.
        value: f64,
        /// What is accepted.
        accepted: &'static str,
    },
    /// A value set from outside cannot be set.
    #[error("cannot be set: {0}")]
    Override(String),
    /// A name that nothing bears.
    #[error("no {kind} is named `{name}`")]
    UnknownName {
        /// What should bear the name.
        kind: &'static str,
        /// The name.
        name: String,
        /// Names that are borne.
        known: String,
    },
    /// A name is borne twice.
    #[error("two bodies are named `{0}`")]
    DuplicateName(String),
    /// A body is named twice in one list.
    #[error("body `{0}` is named twice")]
    Repeated(String),
    /// Two keys exclude each other.
    #[error("`{key}` and `{other}` cannot both be given")]
    Excludes {
        /// The key.
        key: &'static str,
        /// The key it excludes.
        other: &'static str,
    },
    /// A key has no meaning beside another.
    #[error("`{key}` has no meaning for {what}")]
    Meaningless {
        /// The key.
        key: &'static str,
        /// For what it has no meaning.
        what: &'static str,
    },
    /// Two patterns of names drive one joint.
    #[error("joint `{joint}` is driven by `{other}` too: its own name decides")]
    DrivenTwice {
        /// The joint.
        joint: String,
        /// The other pattern.
        other: String,
    },
    /// A body lacks a key.
    #[error("{what} needs {needed}")]
    Needs {
        /// What kind of body.
        what: &'static str,
        /// What it needs.
        needed: &'static str,
    },
    /// The engine refuses the scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// Mass, density or inertia are refused.
    #[error(transparent)]
    MassProperties(#[from] MassPropertiesError),
    /// A primitive is refused.
    #[error(transparent)]
    Primitive(#[from] PrimitiveError),
    /// A mesh bounds no solid or has no mass properties.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A rotation is refused.
    #[error(transparent)]
    Rotation(#[from] RotationError),
    /// A direction is refused.
    #[error(transparent)]
    Direction(#[from] UnitVectorError),
    /// A mesh file bounds no solid.
    #[error("{file}: {source}")]
    Solid {
        /// The file, as the scene names it.
        file: String,
        /// Why.
        source: MeshError,
    },
    /// A prism or a wedge is refused.
    #[error(transparent)]
    Prism(#[from] PrismError),
    /// A shape is refused.
    #[error(transparent)]
    Shape(#[from] ShapeError),
    /// A force is refused.
    #[error(transparent)]
    Field(#[from] FieldError),
    /// A prescribed motion is refused.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// Limits of a joint are refused.
    #[error(transparent)]
    Limits(#[from] LimitsError),
    /// A spring, a damper or a motor of a joint is refused.
    #[error(transparent)]
    Freedom(#[from] FreedomError),
    /// The curve of a track is refused.
    #[error(transparent)]
    Curve(#[from] CurveError),
    /// A gear that is refused.
    #[error(transparent)]
    Gear(#[from] GearError),
    /// A mesh file is refused.
    #[error(transparent)]
    MeshFile(#[from] MeshFileError),
    /// A robot file is refused.
    #[error(transparent)]
    Robot(RobotFileError),
    /// A mesh has no approximate convex parts.
    #[error(transparent)]
    Approximate(ApproximateError),
    /// Approximate convex parts fill a mesh less well than demanded.
    #[error(
        "the volume of the {parts} convex parts differs from that of the solid by {found:e} of it, the limit is \
         {limit:e}: allow more `parts`, a larger `error`, or leave `approximate` out for exact parts"
    )]
    ApproximateVolume {
        /// How many parts there are.
        parts: usize,
        /// Difference of their volume from that of the solid, relative to it.
        found: f64,
        /// The limit given.
        limit: f64,
    },
}

impl From<InertiaError> for Refusal {
    fn from(error: InertiaError) -> Self {
        Self::MassProperties(error.into())
    }
}

impl Refusal {
    /// What the reader of the format says of a value at `path`, in the format's own terms.
    pub(crate) fn from_message(message: &str, path: &KeyPath) -> Self {
        let kinds = Kinds::at(path);
        let quoted = |rest: &str| rest.split_once('`').map(|(name, tail)| (name.to_owned(), tail.to_owned()));
        let expected = |tail: &str| tail.split_once("expected ").map_or(tail, |(_, list)| list).replace("one of ", "");
        if let Some((key, tail)) = message.strip_prefix("unknown field `").and_then(quoted) {
            return Self::UnknownKey { key, accepted: expected(&tail) };
        }
        if let Some((value, tail)) = message.strip_prefix("unknown variant `").and_then(quoted) {
            return Self::UnknownValue { value, accepted: expected(&tail) };
        }
        if let Some((key, _)) = message.strip_prefix("missing field `").and_then(quoted) {
            return Self::MissingKey(key);
        }
        let typed = message
            .strip_prefix("invalid type: ")
            .or_else(|| message.strip_prefix("invalid value: "))
            .or_else(|| message.strip_prefix("invalid "))
            .and_then(|rest| rest.split_once(", expected "));
        if let Some((found, accepted)) = typed {
            return Self::Type { found: plain(found, kinds), accepted: plain(accepted, kinds) };
        }
        // A shape, a force, a joint or a motion is a table with the one key that names its kind.
        if message.starts_with("wanted exactly 1 element") || message == "wanted string or table" {
            return match kinds {
                Kinds::Shapes => Self::ShapeKinds,
                Kinds::Forces => Self::ForceKinds,
                Kinds::Motions => Self::MotionKinds,
                Kinds::CoordinateMotions => Self::CoordinateMotionKinds,
                Kinds::Joints => Self::JointKinds,
                Kinds::Layouts => Self::LayoutKinds,
                Kinds::Curves => Self::CurveKinds,
            };
        }
        Self::Other(message.to_owned())
    }

    /// What is accepted instead, in a sentence; `None` when the message says it already.
    pub(crate) fn accepted(&self) -> Option<String> {
        match self {
            Self::UnknownKey { key, accepted } if is_of_material(key, accepted) => Some(format!(
                "`{key}` is a key of a material: write it below [materials.NAME], and `material = \"NAME\"` here; \
                 accepted: {accepted}"
            )),
            Self::UnknownKey { key: word, accepted } | Self::UnknownValue { value: word, accepted } => {
                Some(format!("{}accepted: {accepted}", meant(word, accepted)))
            }
            Self::UnknownName { name, known, .. } => Some(format!("{}accepted: {known}", meant(name, known))),
            Self::Type { accepted, .. } => Some(format!("accepted: {accepted}")),
            Self::Scene(SceneError::InitialOverlap(pairs)) => mend(pairs),
            Self::Solid { file, source: MeshError::Seams { distance_m, .. } } => Some(format!(
                "to merge them: `polhode mesh {file} --repair{} -o MENDED.obj`, and name that file here",
                weld_tolerance(*distance_m)
            )),
            Self::Solid { file, source: MeshError::NotSolid(_) } => Some(format!(
                "`polhode mesh {file}` shows where, `polhode mesh {file} --repair -o MENDED.obj` mends what can be \
                 mended: name that file here"
            )),
            Self::Number { accepted, .. } => Some(format!("accepted: {accepted}")),
            Self::ShapeKinds => Some(format!("accepted: one of {}", crate::format::SHAPES)),
            Self::ForceKinds => Some(format!("accepted: one of {}", crate::format::FORCES)),
            Self::MotionKinds => Some(format!("accepted: one of {}", crate::format::MOTIONS)),
            Self::CoordinateMotionKinds => Some(format!("accepted: one of {}", crate::format::COORDINATE_MOTIONS)),
            Self::JointKinds => Some(format!("accepted: one of {}", crate::format::JOINTS)),
            Self::CurveKinds => Some(format!("accepted: one of {}", crate::format::CURVES)),
            Self::LayoutKinds => Some(format!("accepted: one of {}", crate::format::LAYOUTS)),
            Self::Version(_) => Some(format!("accepted: {}", crate::format::VERSION)),
            Self::NotYetAvailable { instead, .. } => Some(format!("use {instead}")),
            Self::Excludes { .. } => Some("give one of them".to_owned()),
            Self::DuplicateName(_) => Some("names must differ".to_owned()),
            Self::DrivenTwice { .. } => Some("name the joint itself in `drives`".to_owned()),
            Self::Repeated(_) | Self::Meaningless { .. } => Some("remove it".to_owned()),
            _ => None,
        }
    }
}

/// Which kinds a table with one key has in a part of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kinds {
    Shapes,
    Forces,
    Motions,
    CoordinateMotions,
    Joints,
    Layouts,
    Curves,
}

impl Kinds {
    fn at(path: &KeyPath) -> Self {
        let steps = path.steps();
        if steps.first() == Some(&Step::key("forces")) {
            Self::Forces
        } else if steps.first() != Some(&Step::key("bodies")) && steps.last() == Some(&Step::key("motion")) {
            Self::CoordinateMotions
        } else if steps.first() == Some(&Step::key("joints")) {
            Self::Joints
        } else if steps.first() == Some(&Step::key("tracks")) {
            Self::Curves
        } else if steps.contains(&Step::key("layout")) {
            Self::Layouts
        } else if steps.contains(&Step::key("motion")) {
            Self::Motions
        } else {
            Self::Shapes
        }
    }
}

/// Names of Rust types in the words of the format.
fn plain(text: &str, kinds: Kinds) -> String {
    match text {
        "f64" => "a number".to_owned(),
        "u32" | "u64" => "a whole number of at least 0".to_owned(),
        "a sequence" => "an array".to_owned(),
        "map" => "a table or date".to_owned(),
        "unit variant" => "a single word".to_owned(),
        "newtype variant" => match kinds {
            Kinds::Shapes => "a shape with its keys, such as shape.box.size = [1, 1, 1]",
            Kinds::Forces => "a force with its keys, such as type.torque = { body = \"wheel\", torque = [0, 0, 1] }",
            Kinds::Joints => {
                "a joint with its keys, such as type.hinge = { bodies = [\"door\"], anchor = [0, 0, 0], axis = [0, 0, \
                 1] }"
            }
            Kinds::Layouts => "a layout with its keys, such as layout.pyramid = { base = 10, spacing = [0.44, 0.4] }",
            Kinds::Curves => {
                "a curve with its keys, such as curve.circle = { center = [0, 0, 0], axis = [0, 1, 0], \
                radius = 1 }"
            }
            Kinds::CoordinateMotions => "a motion with its keys, such as motion.rate = 1.0",
            Kinds::Motions => "a motion with its keys, such as motion.constant.velocity = [1, 0, 0]",
        }
        .to_owned(),
        _ if text.starts_with("struct ") => "a table".to_owned(),
        _ if text.starts_with("enum ") => "a word".to_owned(),
        _ => text.to_owned(),
    }
}

/// Names in a message, quoted; at most [`LONGEST_LIST`] of them.
pub(crate) fn list<S: AsRef<str>>(names: &[S]) -> String {
    let mut text =
        names.iter().take(LONGEST_LIST).map(|name| format!("`{}`", name.as_ref())).collect::<Vec<_>>().join(", ");
    if names.len() > LONGEST_LIST {
        let _ = write!(text, " and {} more", names.len() - LONGEST_LIST);
    }
    text
}

/// Names as [`list`] shows them, those most like `name` first; `none` when there are none.
pub(crate) fn nearest(name: &str, names: &[&str], none: &str) -> String {
    if names.is_empty() {
        return none.to_owned();
    }
    let mut sorted = names.to_vec();
    sorted.sort_by_cached_key(|known| edits(name, known));
    list(&sorted)
}

/// Whether a key that was given to something with a material is one of a material.
fn is_of_material(key: &str, accepted: &str) -> bool {
    accepted.contains("`material`") && MATERIAL_KEYS.contains(&key)
}

/// The question whether one of a list of quoted words was meant; empty when none is like the word.
pub(crate) fn meant(word: &str, list: &str) -> String {
    let near = list.split('`').skip(1).step_by(2).map(|known| (edits(word, known), known)).min();
    near.filter(|(_, known)| is_slip_of(word, known))
        .map_or_else(String::new, |(_, known)| format!("did you mean `{known}`? "))
}

/// Whether a word is another one but for a few slips of the pen: a character too many or too few, another one, or two
/// neighbours exchanged.
pub fn is_slip_of(word: &str, known: &str) -> bool {
    let edits = edits(word, known);
    edits > 0 && edits <= MOST_SLIPS && 2 * edits <= word.chars().count()
}

/// The option that merges vertices within a distance (m), for the command line; empty where equal ones are meant.
pub fn weld_tolerance(distance_m: f64) -> String {
    if distance_m == 0.0 { String::new() } else { format!(" --weld-tolerance {distance_m:e}") }
}

/// How the overlaps of a start are mended, when they are small: the overlap that counts as touch is 1e-9 of a body's
/// size, and what a file of few digits gives is below a thousandth.
fn mend(pairs: &[OverlapAtStart]) -> Option<String> {
    let deepest_m = pairs.iter().map(|pair| pair.depth_m).fold(0.0, f64::max);
    let is_small = pairs.iter().all(|pair| pair.depth_m <= MENDED_OF_TOUCH * pair.allowed_m);
    // Rounded up to two digits, so that it is enough.
    let limit = format!("{:.1e}", 1.05 * deepest_m);
    is_small
        .then(|| format!("to have them moved apart: `--set start.separate={limit}`, or `[start] separate = {limit}`"))
}

/// Overlaps up to this many times the one that counts as touch are taken for the rounding of a file.
const MENDED_OF_TOUCH: f64 = 1e6;

/// How many slips of the pen (a character put in, left out, replaced, or exchanged with its neighbour) make `b` of `a`,
/// of the first [`COMPARED`] characters of each.
fn edits(a: &str, b: &str) -> usize {
    let [a, b] = [a, b].map(|word| word.chars().take(COMPARED).collect::<String>());
    strsim::osa_distance(&a, &b)
}

/// Most slips of the pen of a word that is taken for another.
const MOST_SLIPS: usize = 3;

/// Characters that are compared of each name: longer ones differ early or are not a slip of the pen, and a file may
/// hold a million of them.
const COMPARED: usize = 32;

/// Longest list of names in a message: more do not help.
const LONGEST_LIST: usize = 20;
