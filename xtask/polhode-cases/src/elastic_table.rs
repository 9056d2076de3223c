//! `cargo xtask elastic`: contact time, impulse and effective restitution of elastic rectangles against width to height
//! and tilt, and how many digits the meshes hold; a section of `docs/elastic-body.md`.
//!
//! Each drop is made on meshes of about 200, 800, 3200 and 12 800 elements (`--meshes 4`), by eight step lengths each.
//! Their means are kept in `fixtures/reference/elastic/drops.json`, so that others can compare them, and `cargo xtask
//! verify` makes some of them again. Times are in units of `2 H/c_p`, impulses in those of `m v`, so that moduli,
//! density and size do not matter; Poisson's ratio (0.3) does, and the speed (a thirty-seventh of c_p) hardly.

use clap::Args;
use polhode_elastic::{Cells, ElasticError, ElasticMaterial, Extrapolated, Mean, MeshedDrops, Quantity, RectangleDrop};
use serde::{Deserialize, Serialize};
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::ExitCode;

/// The document, and the means, from the root of the workspace.
const DOCUMENT: &str = "docs/elastic-body.md";
const RECORD: &str = "fixtures/reference/elastic/drops.json";

/// Heading of the section, and what the next one begins with.
const HEADING: &str = "## To how many digits\n";
const NEXT: &str = "\n## ";

/// Elements of the coarsest mesh, about: those of Figure 2.
const ELEMENTS: usize = 200;

/// Width over height, and tilt in degrees.
const DROPS: [[f64; 2]; 10] = [
    [0.25, 0.0],
    [0.5, 0.0],
    [1.0, 0.0],
    [2.0, 0.0],
    [4.0, 0.0],
    [2.0, 5.0],
    [2.0, 15.0],
    [2.0, 30.0],
    [2.0, 45.0],
    [2.0, 75.0],
];

/// Digits that an entry is asked for.
const ASKED: f64 = 4.0;

/// What to measure.
#[derive(Debug, Args)]
pub struct Options {
    /// Meshes, each with four times the elements of the one before. The finest takes most of the time.
    #[arg(long, default_value_t = 4, value_parser = clap::value_parser!(u8).range(3..=5))]
    meshes: u8,
    /// Writes the section from the means that are kept, without measuring.
    #[arg(long)]
    kept: bool,
}

/// A mean and its standard error.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct KeptMean {
    /// The mean.
    pub value: f64,
    error: f64,
}

/// What a mesh gives.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct KeptMesh {
    columns: usize,
    rows: usize,
    /// From the first to the last touch, in units of `2 H/c_p`.
    pub contact_time: KeptMean,
    /// In units of `m v`.
    pub impulse: KeptMean,
    /// Velocity up over velocity down before.
    pub restitution: KeptMean,
}

/// A drop.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct KeptDrop {
    /// Width over height.
    pub aspect: f64,
    /// Degrees.
    pub tilt_deg: f64,
    /// The meshes, the coarsest first.
    pub meshes: Vec<KeptMesh>,
}

/// Measures and writes.
///
/// # Errors
/// A drop that fails, a file that cannot be read or written, a document without the section.
pub fn run(options: &Options, root: &Path) -> Result<ExitCode, Box<dyn Error>> {
    let drops = if options.kept {
        kept(root)?
    } else {
        let drops = DROPS.iter().map(|&[aspect, tilt_deg]| {
            eprintln!("elastic: W/H {aspect}, {tilt_deg} degrees");
            measured(aspect, tilt_deg, usize::from(options.meshes))
        });
        let drops: Vec<KeptDrop> = drops.collect::<Result<_, _>>()?;
        fs::write(root.join(RECORD), serde_json::to_string_pretty(&drops)? + "\n")?;
        drops
    };
    let document = fs::read_to_string(root.join(DOCUMENT))?;
    let (before, rest) = document.split_once(HEADING).ok_or_else(|| format!("{DOCUMENT} has no {HEADING}"))?;
    let after = rest.find(NEXT).map_or("", |at| &rest[at..]);
    fs::write(root.join(DOCUMENT), format!("{before}{}{after}", section(&drops)?))?;
    Ok(ExitCode::SUCCESS)
}

/// The means that are kept.
///
/// # Errors
/// When the file cannot be read or understood.
pub fn kept(root: &Path) -> Result<Vec<KeptDrop>, Box<dyn Error>> {
    Ok(serde_json::from_str(&fs::read_to_string(root.join(RECORD))?)?)
}

/// A drop on so many meshes.
///
/// # Errors
/// When the impact cannot be computed.
pub fn measured(aspect: f64, tilt_deg: f64, meshes: usize) -> Result<KeptDrop, ElasticError> {
    let (height, speed) = (1.0, 1.0);
    let material = ElasticMaterial::new(1e6, 0.3, 1000.0)?;
    let drop = RectangleDrop::new(aspect * height, height, material, speed)?.tilted(f64::to_radians(tilt_deg))?;
    let momentum = material.density() * drop.width() * drop.height() * speed;
    let wave_s = 2.0 * drop.height() / material.dilatational_speed();
    let cells = std::iter::successors(Some(drop.cells(ELEMENTS)), |cells| Some(cells.halved())).take(meshes);
    let mesh = |cells: Cells| {
        let drops = MeshedDrops::of(&drop, cells)?;
        let mean = |quantity: Quantity, unit: f64| {
            let Mean { value, error } = drops.mean(quantity);
            KeptMean { value: value / unit, error: error / unit }
        };
        Ok(KeptMesh {
            columns: cells.columns,
            rows: cells.rows,
            contact_time: mean(Quantity::ContactTime, wave_s),
            impulse: mean(Quantity::Impulse, momentum),
            restitution: mean(Quantity::Restitution, 1.0),
        })
    };
    Ok(KeptDrop { aspect, tilt_deg, meshes: cells.map(mesh).collect::<Result<_, ElasticError>>()? })
}

/// The section of the document.
fn section(drops: &[KeptDrop]) -> Result<String, ElasticError> {
    let most = drops.iter().flat_map(|drop| &drop.meshes).map(|mesh| mesh.columns * mesh.rows).max().unwrap_or(0);
    let mut table = String::new();
    for drop in drops {
        let _ = write!(table, "| {} | {} |", drop.aspect, drop.tilt_deg);
        for limit in limits(drop)? {
            let digits = digits(&limit);
            let _ = write!(table, " {:.4} +- {:.4} | {:.2} | {digits:.1} |", limit.value, limit.error, limit.order);
        }
        table.push('\n');
    }
    let Reached { entries, reached } = Reached::of(drops)?;
    Ok(format!(
        "{HEADING}
Contact time (first to last touch, in units of `2 H/c_p`), impulse (of `m v`) and effective restitution (velocity up \
over velocity
down) for nu = 0.3, from meshes of 200 to {most} elements: the limit by Richardson extrapolation with the observed \
order, its
estimated error, that order, and the digits that hold, `-log10` of the relative error. Four digits are reached by \
{reached} of {entries}
entries. `cargo xtask elastic` makes this section (the finest meshes take most of its time); the means of all meshes \
are in
`{RECORD}`, and `cargo xtask verify --only \"elastic body\"` makes some of them again.

| W/H | tilt, degrees | contact time | order | digits | impulse | order | digits | restitution | order | digits |
|---|---|---|---|---|---|---|---|---|---|---|
{table}"
    ))
}

/// Limits of the contact time, the impulse and the restitution of a drop.
fn limits(drop: &KeptDrop) -> Result<[Extrapolated; 3], ElasticError> {
    let limit = |quantity: fn(&KeptMesh) -> KeptMean| {
        let means: Vec<Mean> =
            drop.meshes.iter().map(quantity).map(|KeptMean { value, error }| Mean { value, error }).collect();
        Extrapolated::of_means(&means)
    };
    Ok([limit(|mesh| mesh.contact_time)?, limit(|mesh| mesh.impulse)?, limit(|mesh| mesh.restitution)?])
}

/// How many entries of the table hold the digits that are asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Reached {
    /// Entries of the table.
    pub entries: usize,
    /// Those with as many digits.
    pub reached: usize,
}

impl Reached {
    /// Counts the entries of these drops.
    ///
    /// # Errors
    /// A drop with fewer than three meshes.
    pub fn of(drops: &[KeptDrop]) -> Result<Self, ElasticError> {
        let limits: Vec<[Extrapolated; 3]> = drops.iter().map(limits).collect::<Result<_, _>>()?;
        let limits = limits.as_flattened();
        let reached = limits.iter().filter(|limit| digits(limit) >= ASKED).count();
        Ok(Self { entries: limits.len(), reached })
    }
}

/// Decimal digits that hold; none is less than none.
fn digits(limit: &Extrapolated) -> f64 {
    (-(limit.error / limit.value.abs()).log10()).max(0.0)
}

#[cfg(test)]
mod tests {
    //! The section of the document is what the command writes of the means that are kept.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn the_document_has_the_table_of_the_kept_means() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let document = fs::read_to_string(root.join(DOCUMENT)).unwrap();
        let drops = kept(&root).unwrap();
        assert_eq!(drops.len(), DROPS.len());
        assert!(document.contains(&section(&drops).unwrap()), "run cargo xtask elastic --kept");
    }
}
