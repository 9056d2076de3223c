//! Scene files in, trajectories and reports out.
//!
//! The only part of polhode that knows a file format. It reads no clock, starts no thread and prints nothing.
//!
//! | module | holds |
//! |---|---|
//! | [`mod@format`] | the scene format, version 1, as plain data |
//! | [`mod@load`] | [`load`](load()): from a file to a [`polhode::Scene`] |
//! | [`error`] | [`SceneFileError`]: file, line, column, key and what is accepted, with the line shown |
//! | [`mod@schema`] | [`schema`](schema()): the JSON Schema of the format |
//! | [`output`] | [`Outputs`]: trajectories as CSV, NPY and JSON, events and joints as CSV |
//! | [`checkpoint`] | [`Checkpoint`]: a run that can be continued later |
//! | [`mod@compare`] | [`compare`](compare()): two trajectories, number by number |
//! | [`csv`] | comma-separated values |
//! | [`trajectory`] | [`TrajectoryReader`]: a trajectory read back, held against its scene |
//! | [`report`] | reports and plans as JSON |
//! | [`shown`] | what pages and plots say of a run |
//! | [`mesh_file`], [`mesh_report`] | mesh files; diagnosis and mass properties |
//! | [`names`] | words for methods |
//! | [`quantity`] | quantities of bodies, joints and contacts by name |
//! | [`uncertain`] | what of a scene is uncertain, which a sweep draws |
//! | `build` | from the format to the engine's scene |
//! | `document` | a scene file that knows where each of its values stands |
//! | `robot` | robots from URDF and MJCF files |
//! | `boxes` | a table of boxes as a scene |
//! | `trajectory_rows` | the rows of a trajectory in a CSV file, read one by one |
//! | `scaled_arrays` | the arrays of a scene with another number of bodies |
//! | `files` | the files that a scene names: on disk, or given with its text |
//! | `mesh_file_error` | why a mesh file could not be used |
//!
//! ```
//! let text = r#"
//!     format = 1
//!     duration = 2.0
//!     [[bodies]]
//!     name = "ball"
//!     shape.sphere.radius = 0.1
//!     mass = 1.0
//! "#;
//! let loaded = polhode_scene::load_text("ball.toml", text, &[])?;
//! assert_eq!(loaded.scene.bodies()[0].name(), "ball");
//!
//! let error = polhode_scene::load_text("ball.toml", &text.replace("mass = 1.0", "mass = -1.0"), &[]).unwrap_err();
//! assert!(error.to_string().contains("mass must be a positive number of kilograms, found -1"));
//! # Ok::<(), polhode_scene::SceneFileError>(())
//! ```
//!
//! # Stages
//!
//! In the order of the calls, from a scene file to the files of a run; paths are in `src`.
//!
//! | stage | what it does | where |
//! |---|---|---|
//! | read | reads the file, up to a largest length | `load.rs`, `files.rs` |
//! | document | parses the text | `document/mod.rs`, `document/repair.rs` |
//! | | adds values set from outside, and keeps the place of every key | `document/overrides.rs`, `document/tree.rs` |
//! | format | turns keys into plain data | `format/scene.rs` |
//! | build | makes bodies, forces and method through the constructors that check them | `build/scene.rs` |
//! | meshes | reads the mesh files that bodies name | `mesh_file.rs` |
//! | error | shows the line of a key that is refused | `error.rs`, `document/source.rs` |
//! | output | writes samples and events while the run goes on | `output/outputs.rs`, `output/atomic_file.rs` |
//! | checkpoint | stores a run and loads it again | `checkpoint.rs` |
//! | report | writes plan and report as JSON | `report.rs` |

pub mod checkpoint;
pub mod compare;
pub mod csv;
pub mod error;
pub mod format;
pub mod load;
pub mod mesh_file;
pub mod mesh_report;
pub mod names;
pub mod output;
pub mod quantity;
pub mod report;
pub mod robot;
pub mod schema;
pub mod shown;
pub mod trajectory;
pub mod uncertain;

mod boxes;
mod build;
mod document;
mod files;
mod mesh_file_error;
mod scaled_arrays;
mod trajectory_rows;

pub use boxes::{boxes_json, is_boxes};
pub use checkpoint::{Checkpoint, CheckpointError};
pub use compare::{CompareError, Comparison, RowPair, Tolerance, compare, compare_rows};
pub use document::Override;
pub use error::{MeshFileError, Place, Refusal, Refused, SceneFileError, is_slip_of, weld_tolerance};
pub use files::GivenFiles;
pub use load::{LoadedScene, load, load_text, load_with, load_with_files, scene_text_of};
pub use mesh_file::read_mesh;
pub use mesh_report::{Filling, MeshReport};
pub use output::{AtomicFile, CsvStream, LeftBehind, OutputError, Outputs, Unfinished};
pub use quantity::{Quantity, QuantityError};
pub use report::{
    broken_json, certificate_json, plan_json, plan_with_accelerations_json, report_json, scene_report_json,
    stability_json,
};
pub use schema::schema;
pub use shown::{ended_line, methods_line, page_report_json, shown_failure, shown_outcome};
pub use trajectory::{FilePlace, TRAJECTORY_ENDINGS, TrajectoryError, TrajectoryReader, is_trajectory};
pub use uncertain::{Distribution, Draw, StartPose, Uncertain};

// The program in the README is compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
