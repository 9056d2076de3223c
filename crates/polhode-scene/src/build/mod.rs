//! From the format to the engine's scene.
//!
//! Every value goes through the constructor that checks it; what a constructor refuses is reported at the key it came
//! from. Nothing here looks at the text: places are paths of keys.
//!
//! | module | holds |
//! |---|---|
//! | `appearance` | how a scene is shown |
//! | `approximate` | few convex parts that nearly fill a mesh |
//! | `array` | many equal bodies |
//! | `bodies` | bodies by name, for what refers to them |
//! | `body` | a body: its pose, motion, shape and mass |
//! | `drives` | what drives the joints of a robot |
//! | `fault` | what is refused and at which key; checks of numbers |
//! | `force` | forces |
//! | `gear` | gears, and joints by name |
//! | `coordinate_motion` | prescribed motions of joints |
//! | `layout` | where the bodies of an array stand |
//! | `mass` | mass properties from mass or density, shape and inertia |
//! | `materials` | materials and rules for pairs of them |
//! | `matter` | what the mass of a body is spread over |
//! | `method` | tier and knobs |
//! | `penalty` | springs at contacts |
//! | `model` | robots from files of their own |
//! | `motion` | kinematic bodies and their prescribed motions |
//! | `placement` | where a body or a part of one stands |
//! | `pivot` | the velocity of a body on a pivot |
//! | `scene` | the whole scene |
//! | `shape` | shapes, and the meshes they are read from |
//! | `signal` | signals, which forces are multiplied by |
//! | `spring` | springs |
//! | `track` | tracks, and the joints that hold bodies to them |
//! | `uncertain` | what of a scene is uncertain |
//! | `joint` | joints |

mod appearance;
mod approximate;
mod array;
mod bodies;
mod body;
mod coordinate_motion;
mod drives;
mod fault;
mod force;
mod gear;
mod joint;
mod layout;
mod mass;
mod materials;
mod matter;
mod method;
mod model;
mod motion;
mod penalty;
mod pivot;
mod placement;
mod scene;
mod shape;
mod signal;
mod spring;
mod track;
mod uncertain;

pub(crate) use model::PlacedRobot;
pub(crate) use scene::{Built, path_of, scene};
pub(crate) use uncertain::build as uncertain;
