//! The arguments of `polhode mesh`.

use clap::Args;
use std::path::PathBuf;

/// Arguments of `mesh`.
#[derive(Debug, Args)]
pub(crate) struct MeshArgs {
    /// Mesh file (.obj, .stl, .off, .ply)
    pub(crate) file: PathBuf,
    /// Matter throughout; the mesh must bound a solid (the default)
    #[arg(long, conflicts_with = "hollow")]
    pub(crate) solid: bool,
    /// Matter in the surface alone; the mesh may be open
    #[arg(long)]
    pub(crate) hollow: bool,
    /// Density, kg/m^3 (kg/m^2 with --hollow) [default: 1]
    #[arg(long, value_name = "D", conflicts_with = "mass", allow_negative_numbers = true)]
    pub(crate) density: Option<f64>,
    /// Mass of the whole body, kg
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    pub(crate) mass: Option<f64>,
    #[command(flatten)]
    pub(crate) repair: MeshRepairArgs,
    #[command(flatten)]
    pub(crate) frame: MeshFrameArgs,
    #[command(flatten)]
    pub(crate) studies: MeshStudyArgs,
    #[command(flatten)]
    pub(crate) output: MeshOutputArgs,
    /// Prints the report as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// Repair before anything else.
#[derive(Debug, Args)]
pub(crate) struct MeshRepairArgs {
    /// Mends what can be mended safely, and reports each mend
    #[arg(long)]
    pub(crate) repair: bool,
    /// Distance within which vertices are merged by --repair, m (after --scale)
    #[arg(long, value_name = "M", default_value_t = 0.0, requires = "repair", allow_negative_numbers = true)]
    pub(crate) weld_tolerance: f64,
    /// Largest hole that --repair fills, as a fraction of the mesh's diagonal
    #[arg(long, value_name = "F", default_value_t = 0.25, requires = "repair", allow_negative_numbers = true)]
    pub(crate) largest_hole: f64,
}

/// The mesh, or its convex parts, as files.
#[derive(Debug, Args)]
pub(crate) struct MeshOutputArgs {
    /// Writes the mesh as it was measured (.obj, .stl, .off, .ply); with --decompose each part, numbered
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// How numbers are written [default: what keeps every bit]
    #[arg(long, value_enum, requires = "output")]
    pub(crate) encoding: Option<MeshEncoding>,
}

/// How the numbers of a mesh file are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum MeshEncoding {
    /// Decimal numbers
    Text,
    /// Bytes (STL and PLY)
    Binary,
}

/// The frame that a mesh is brought into first.
#[derive(Debug, Args)]
pub(crate) struct MeshFrameArgs {
    /// Multiplies all lengths by this first
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true)]
    pub(crate) scale: Option<f64>,
    /// Moves the centre of mass to the origin
    #[arg(long)]
    pub(crate) recentre: bool,
    /// Turns the principal axes to the axes, moments ascending, with the centre of mass at the origin
    #[arg(long)]
    pub(crate) principal: bool,
}

/// Other ways to the mass properties, to set beside the exact result.
#[derive(Debug, Args)]
pub(crate) struct MeshStudyArgs {
    /// Shows what the thesis's choices of a reference point cost in accuracy
    #[arg(long)]
    pub(crate) compare_reference_points: bool,
    /// Parts the solid into convex parts along planes; together they fill it
    #[arg(long, conflicts_with_all = ["hollow", "approximate"])]
    pub(crate) decompose: bool,
    /// Parts it into few convex parts that nearly fill it (V-HACD)
    #[arg(long, conflicts_with = "hollow")]
    pub(crate) approximate: bool,
    /// Shows a Monte Carlo estimate from N points beside the exact result (solids)
    #[arg(long, value_name = "N", conflicts_with = "hollow")]
    pub(crate) monte_carlo: Option<u64>,
    /// Seed of the Monte Carlo estimate
    #[arg(long, value_name = "S", default_value_t = 1, requires = "monte_carlo")]
    pub(crate) seed: u64,
}
