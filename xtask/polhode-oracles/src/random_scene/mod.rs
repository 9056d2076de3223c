//! Random scenes, each made from a seed: bodies of all shapes, materials, laws and prescribed motions.
//!
//! `cargo xtask random-scene SEED -o FILE.toml` writes one as a scene file with its meshes beside it, so that whatever
//! a random case finds can be run, seen and cured. The case is `xtask/polhode-cases/src/cases/random_scenes`, its judge
//! `xtask/polhode-oracles/src/judge`.
//!
//! | module | holds |
//! |---|---|
//! | `model` | the scene as plain data |
//! | `generate` | the scene of a seed |
//! | `polyhedra` | polyhedra whose faces and convex pieces are known |
//! | `copies` | the same scene mirrored, turned, moved, in other units |
//! | `reader` | a scene file as a model |
//! | `written` | scene file and mesh files |

pub mod copies;
pub mod generate;
pub mod model;
mod polyhedra;
pub mod reader;
pub mod written;

use clap::Args;
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

/// What the command takes.
#[derive(Debug, Args)]
pub struct Options {
    /// Seed of the scene.
    seed: u64,
    /// Scene file that is written.
    #[arg(short, long)]
    output: PathBuf,
}

/// Runs the command.
///
/// # Errors
/// When a file cannot be written.
pub fn run(options: &Options) -> Result<ExitCode, Box<dyn Error>> {
    let stem = options.output.file_stem().ok_or("the output has no name")?.to_string_lossy().into_owned();
    let written = generate::scene(options.seed).written(&stem);
    let folder = options.output.parent().map_or_else(PathBuf::new, PathBuf::from);
    std::fs::write(&options.output, written.text)?;
    for (name, text) in written.meshes {
        std::fs::write(folder.join(name), text)?;
    }
    Ok(ExitCode::SUCCESS)
}
