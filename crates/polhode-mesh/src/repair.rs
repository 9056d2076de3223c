//! Repair: the safe mends of what [`diagnose`] finds, each reported with its count.
//!
//! In this order, each only where the mesh has the defect that it mends:
//!
//! | repair | what it does | what it leaves |
//! |---|---|---|
//! | [`Weld`](Repair::Weld) | merges vertices within a tolerance | meshes that it would not bring nearer to closed |
//! | [`DropDuplicates`](Repair::DropDuplicates) | drops repeated triangles | opposite ones: walls without thickness |
//! | [`DropDegenerate`](Repair::DropDegenerate) | drops triangles that name a vertex twice | |
//! | | swaps those on a line with a neighbour | those without a neighbour to swap with: harmless |
//! | [`Flip`](Repair::Flip) | makes neighbours run the same way round | surfaces with one side only |
//! | | then parts face outward, voids inward | |
//! | [`FillHoles`](Repair::FillHoles) | closes holes up to a size | larger ones, of a tangled rim, and sheets |
//! | | by the triangulation of least area | |
//! | [`DropUnused`](Repair::DropUnused) | drops vertices that no triangle uses | |
//!
//! A mesh that bounds a solid keeps its triangles, for only the harmless defects are mended then and welding is for
//! open edges alone. No vertex moves. Not looked for are surfaces that cross themselves, so a filled hole may be where
//! a modeller meant an opening: the volume before and after says what it did.
//!
//! | module | holds |
//! |---|---|
//! | `degenerate` | triangles that repeat another, and triangles without area |
//! | `holes` | closing of holes |
//! | `orientation` | which way round triangles run |
//! | `report` | what repair did and what is left |

mod degenerate;
mod holes;
mod orientation;
mod report;

pub use crate::mend::Repair;
pub use report::{RepairReport, RepairStep};

use crate::diagnosis::{DefectKind, Diagnosis, diagnose};
use crate::solid_mesh::SolidMesh;
use crate::triangle_mesh::{MeshError, TriangleMesh};
use crate::weld::weld;

/// How far repair goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RepairOptions {
    /// Vertices within this distance are merged, m; from 0 (equal positions alone, the default) to a small part of the
    /// smallest feature.
    pub weld_tolerance: f64,
    /// Largest hole that is filled: the diagonal of the box around its rim, as a fraction of the mesh's. From 0 (none)
    /// to 1 (any); the default of 0.25 fills the openings of scans and not the end of an open tube.
    pub largest_hole: f64,
}

impl Default for RepairOptions {
    fn default() -> Self {
        Self { weld_tolerance: 0.0, largest_hole: 0.25 }
    }
}

/// Mends what can be mended safely.
///
/// ```
/// use polhode_mesh::{DVec3, Repair, RepairOptions, SolidMesh, box_mesh, repair};
/// let cube = box_mesh(DVec3::ONE)?.into_mesh();
/// let (mended, report) = repair(&cube.flipped(), &RepairOptions::default())?;
/// assert_eq!((report.steps[0].repair, report.steps[0].count), (Repair::Flip, 12));
/// assert!(report.after.is_solid());
/// assert!((SolidMesh::new(mended)?.volume_integrals().volume - 1.0).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`MeshError::Tolerance`] and [`MeshError::HoleSize`] for options out of their range; [`MeshError::Empty`] when
/// nothing but degenerate triangles was there.
pub fn repair(mesh: &TriangleMesh, options: &RepairOptions) -> Result<(TriangleMesh, RepairReport), MeshError> {
    if !(0.0..=1.0).contains(&options.largest_hole) {
        return Err(MeshError::HoleSize(options.largest_hole));
    }
    let before = diagnose(mesh);
    let mut bench = Bench { mesh: mesh.clone(), diagnosis: before.clone(), steps: Vec::new() };
    let welded = weld(mesh, options.weld_tolerance)?;
    if welded.merged > 0 {
        bench.weld(welded.mesh, welded.merged);
    }
    if bench.has(DefectKind::DuplicateTriangle) {
        let (mesh, count) = degenerate::without_duplicates(&bench.mesh)?;
        bench.step(Repair::DropDuplicates, mesh, count);
    }
    if bench.has(DefectKind::DegenerateTriangle) {
        let (mesh, count) = degenerate::without_degenerate(&bench.mesh)?;
        bench.step(Repair::DropDegenerate, mesh, count);
    }
    bench.flip_and_fill(options)?;
    if bench.has(DefectKind::UnusedVertex) {
        let (mesh, count) = without_unused(&bench.mesh)?;
        bench.step(Repair::DropUnused, mesh, count);
    }
    let volume = |mesh: &TriangleMesh| SolidMesh::new(mesh.clone()).ok().map(|solid| solid.volume_integrals().volume);
    let (volume_before, volume_after) = (volume(mesh), volume(&bench.mesh));
    let report = RepairReport { steps: bench.steps, before, after: bench.diagnosis, volume_before, volume_after };
    Ok((bench.mesh, report))
}

/// The mesh being mended, and what was done to it.
struct Bench {
    mesh: TriangleMesh,
    diagnosis: Diagnosis,
    steps: Vec<RepairStep>,
}

impl Bench {
    fn has(&self, kind: DefectKind) -> bool {
        self.diagnosis.get(kind).is_some()
    }

    /// Takes over the result of a repair that changed `count` things.
    fn step(&mut self, repair: Repair, mesh: TriangleMesh, count: usize) {
        if count == 0 {
            return;
        }
        let triangles = mesh.triangles().len() as isize - self.mesh.triangles().len() as isize;
        self.diagnosis = diagnose(&mesh);
        self.mesh = mesh;
        match self.steps.iter_mut().find(|step| step.repair == repair) {
            Some(step) => {
                step.count += count;
                step.triangles += triangles;
            }
            None => self.steps.push(RepairStep { repair, count, triangles }),
        }
    }

    /// Takes over a welded mesh when it is nearer to a solid: fewer edges that are not those of two triangles in
    /// opposite directions.
    fn weld(&mut self, welded: TriangleMesh, merged: usize) {
        let faults = |diagnosis: &Diagnosis| -> usize {
            let kinds = [DefectKind::OpenEdge, DefectKind::NonManifoldEdge, DefectKind::InconsistentWinding];
            kinds.iter().filter_map(|&kind| diagnosis.get(kind)).map(|defect| defect.count).sum()
        };
        if faults(&diagnose(&welded)) < faults(&self.diagnosis) {
            self.step(Repair::Weld, welded, merged);
        }
    }

    fn flip_and_fill(&mut self, options: &RepairOptions) -> Result<(), MeshError> {
        if self.has(DefectKind::InconsistentWinding) {
            let (mesh, count) = orientation::consistent(&self.mesh)?;
            self.step(Repair::Flip, mesh, count);
        }
        if self.has(DefectKind::OpenEdge) {
            let (mesh, count) = holes::filled(&self.mesh, options.largest_hole)?;
            self.step(Repair::FillHoles, mesh, count);
        }
        if self.has(DefectKind::Inverted) {
            let (mesh, count) = orientation::outward(&self.mesh)?;
            self.step(Repair::Flip, mesh, count);
        }
        Ok(())
    }
}

/// The mesh without vertices that no triangle uses, and how many there were.
fn without_unused(mesh: &TriangleMesh) -> Result<(TriangleMesh, usize), MeshError> {
    let mut new_index = vec![None; mesh.vertices().len()];
    for &index in mesh.triangles().iter().flatten() {
        new_index[index as usize] = Some(0);
    }
    let mut vertices = Vec::new();
    for (slot, &position) in new_index.iter_mut().zip(mesh.vertices()) {
        if let Some(index) = slot {
            *index = vertices.len() as u32;
            vertices.push(position);
        }
    }
    let count = mesh.vertices().len() - vertices.len();
    let triangles =
        mesh.triangles().iter().map(|t| t.map(|index| new_index[index as usize].unwrap_or_default())).collect();
    Ok((TriangleMesh::new(vertices, triangles)?, count))
}
