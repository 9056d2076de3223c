//! Runs made visible: one HTML page with a viewer, stills, moving pictures, animated models and plots.
//!
//! It shows what it is told and simulates nothing: a [`Scene`](polhode::Scene) gives the bodies, an
//! [`Observer`](polhode::Observer) or a trajectory gives their motion. It reads no clock, has no global, prints nothing
//! and writes to whatever is given to it. The same motion gives the same bytes.
//!
//! | module | holds |
//! |---|---|
//! | [`surface_mesh`], [`mod@tessellation`] | triangles, normals and sharp edges of every shape |
//! | [`shown_scene`], [`shown_body`] | what is shown: bodies and their parts |
//! | [`mesh_library`] | meshes that bodies share |
//! | [`quanta`], [`chunk`] | frames as integers, packed |
//! | `turning` | orientations between two frames |
//! | `penetration` | how deep bodies overlap, as plots and pages show it |
//! | [`event_list`], [`series`] | events in words, and quantities over time |
//! | `error_steps` | estimated errors over time |
//! | [`page`] | the page writer, which streams while the run goes on |
//! | [`live`], [`play_page`] | a page that runs a scene itself |
//! | [`recording`] | poses over time, for pictures and models |
//! | [`extent`], [`framing`], `planar` | what a picture holds, and whence it is best seen |
//! | [`fixtures`] | what is drawn of joints, springs and tracks |
//! | [`overlay`], `annotations`, `scale` | velocities, forces and paths over a picture; words, axes and a scale on it |
//! | [`camera`], [`light`], [`raster`] | a software rasteriser with depth, light, shadow and anti-aliasing |
//! | [`still`], [`animation`] | PNG; GIF, APNG and WebP |
//! | [`glb`] | animated models as binary glTF |
//! | [`plot`] | figures as SVG |
//! | [`error`] | [`ViewError`] |
//! | `colors` | colours of pictures, models and pages |
//! | `lengths` | numbers and lengths in few letters |
//! | `text` | data as text inside a page |
//! | `thinning` | leaving out samples that come too often |

pub mod animation;
pub mod camera;
pub mod chunk;
pub mod error;
pub mod event_list;
pub mod extent;
pub mod fixtures;
pub mod framing;
pub mod glb;
pub mod light;
pub mod live;
pub mod mesh_library;
pub mod overlay;
pub mod page;
pub mod play_page;
pub mod plot;
pub mod quanta;
pub mod raster;
pub mod recording;
pub mod series;
pub mod shown_body;
pub mod shown_scene;
pub mod still;
pub mod surface_mesh;
pub mod tessellation;

mod annotations;
mod colors;
mod error_steps;
mod lengths;
mod penetration;
mod planar;
mod scale;
mod text;
mod thinning;
mod turning;

pub use error::ViewError;
pub use mesh_library::MeshLibrary;
pub use page::{FrameSource, Page, PageRun};
pub use recording::Recording;
pub use shown_scene::ShownScene;

// The program in the README is compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
