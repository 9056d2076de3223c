//! Welding: vertices at the same place become one.
//!
//! Vertices are taken in order; each joins the earliest one kept so far that is within the tolerance of it, and is kept
//! itself when there is none. So what is kept does not move, kept vertices are farther apart than the tolerance, and
//! the result depends on nothing but the order of the file. Kept vertices lie in a grid of cells of edge `CELL`
//! tolerances: a cell holds few of them, and only the cells that a ball of the tolerance touches are searched.

use crate::triangle_mesh::{MeshError, TriangleMesh};
use glam::DVec3;
use std::collections::BTreeMap;

/// Edge of a cell in tolerances: larger cells hold more vertices, smaller ones make a ball touch more cells.
const CELL: f64 = 4.0;

/// Smallest tolerance beside the largest coordinate (dimensionless): two roundings of that coordinate, 2^-51. Below it
/// only equal positions are merged, which is all that can be told from rounding there.
const SMALLEST_TOLERANCE: f64 = 2.0 * f64::EPSILON;

/// A welded mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Welded {
    /// The mesh; its triangles are those of the original in order, its vertices the kept ones in order.
    pub mesh: TriangleMesh,
    /// Number of vertices that joined an earlier one.
    pub merged: usize,
}

/// Merges vertices whose distance is at most `tolerance` (m); 0 merges equal positions alone (0 and -0 are equal).
///
/// A triangle may become degenerate by this; [`repair`](crate::repair::repair) drops it.
///
/// ```
/// use polhode_mesh::{DVec3, TriangleMesh, weld};
/// let near = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1.0, 1e-7, 0.0), DVec3::new(1.0, 1.0, 0.0), DVec3::Y];
/// let mesh = TriangleMesh::new(near.to_vec(), vec![[0, 1, 2], [3, 4, 5]])?;
/// assert_eq!(weld(&mesh, 0.0)?.merged, 1);
/// let welded = weld(&mesh, 1e-6)?;
/// assert_eq!((welded.merged, welded.mesh.triangles()), (2, [[0, 1, 2], [1, 3, 2]].as_slice()));
/// # Ok::<(), polhode_mesh::MeshError>(())
/// ```
///
/// # Errors
/// [`MeshError::Tolerance`] when the tolerance is negative, NaN or infinite.
pub fn weld(mesh: &TriangleMesh, tolerance: f64) -> Result<Welded, MeshError> {
    if !(tolerance >= 0.0 && tolerance.is_finite()) {
        return Err(MeshError::Tolerance(tolerance));
    }
    let largest = mesh.vertices().iter().fold(0.0f64, |largest, v| largest.max(v.abs().max_element()));
    let kept = if tolerance <= SMALLEST_TOLERANCE * largest {
        equal_positions(mesh.vertices())
    } else {
        near_positions(mesh.vertices(), tolerance)
    };
    joined(mesh, &kept)
}

/// A mesh whose vertices at equal positions are one.
pub(crate) fn merged_exactly(mesh: TriangleMesh) -> TriangleMesh {
    let kept = equal_positions(mesh.vertices());
    // The mesh is readable as it was; its indices only become smaller.
    joined(&mesh, &kept).map_or(mesh, |welded| welded.mesh)
}

/// The mesh in which every vertex is replaced by the earlier or same one that `kept` names.
fn joined(mesh: &TriangleMesh, kept: &[u32]) -> Result<Welded, MeshError> {
    let mut new_index = vec![0u32; kept.len()];
    let mut vertices = Vec::new();
    for ((old, &keeper), &position) in kept.iter().enumerate().zip(mesh.vertices()) {
        new_index[old] = if keeper as usize == old {
            vertices.push(position);
            vertices.len() as u32 - 1
        } else {
            new_index[keeper as usize]
        };
    }
    let merged = mesh.vertices().len() - vertices.len();
    let triangles = mesh.triangles().iter().map(|t| t.map(|index| new_index[index as usize])).collect();
    Ok(Welded { mesh: TriangleMesh::new(vertices, triangles)?, merged })
}

/// For each vertex the first at its position.
pub(crate) fn equal_positions(vertices: &[DVec3]) -> Vec<u32> {
    // Adding zero turns -0.0 into 0.0, which is the same position. Sorted with their positions beside them, so that no
    // comparison has to look one up.
    let mut order: Vec<([u64; 3], u32)> =
        vertices.iter().zip(0u32..).map(|(&v, index)| ((v + 0.0).to_array().map(f64::to_bits), index)).collect();
    order.sort_unstable();
    let mut kept = vec![0; vertices.len()];
    for group in order.chunk_by(|a, b| a.0 == b.0) {
        let first = group[0].1;
        for &(_, index) in group {
            kept[index as usize] = first;
        }
    }
    kept
}

/// For each vertex the earliest kept one within the tolerance, or itself.
fn near_positions(vertices: &[DVec3], tolerance: f64) -> Vec<u32> {
    let mut grid = Grid { edge: CELL * tolerance, newest: BTreeMap::new(), older: vec![u32::MAX; vertices.len()] };
    let mut kept = Vec::with_capacity(vertices.len());
    for (&position, index) in vertices.iter().zip(0u32..) {
        let near = grid.earliest_within(vertices, position, tolerance);
        if near.is_none() {
            grid.insert(position, index);
        }
        kept.push(near.unwrap_or(index));
    }
    kept
}

/// Kept vertices by cell.
struct Grid {
    /// Edge of a cell, m.
    edge: f64,
    /// The vertex that was kept last in each cell that has one.
    newest: BTreeMap<[i64; 3], u32>,
    /// For each kept vertex the one kept before it in its cell, or `u32::MAX`.
    older: Vec<u32>,
}

impl Grid {
    /// Cells are numbered by integers below 2^51, because the tolerance is no smaller than rounding.
    fn cell(&self, position: DVec3) -> [i64; 3] {
        (position / self.edge).floor().to_array().map(|coordinate| coordinate as i64)
    }

    fn insert(&mut self, position: DVec3, index: u32) {
        let cell = self.cell(position);
        if let Some(before) = self.newest.insert(cell, index) {
            self.older[index as usize] = before;
        }
    }

    fn earliest_within(&self, vertices: &[DVec3], position: DVec3, tolerance: f64) -> Option<u32> {
        let (low, high) = (self.cell(position - tolerance), self.cell(position + tolerance));
        let mut earliest: Option<u32> = None;
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let mut kept = self.newest.get(&[x, y, z]).copied();
                    while let Some((index, other)) = kept.and_then(|i| vertices.get(i as usize).map(|v| (i, v))) {
                        if other.distance(position) <= tolerance && earliest.is_none_or(|best| index < best) {
                            earliest = Some(index);
                        }
                        kept = self.older.get(index as usize).copied();
                    }
                }
            }
        }
        earliest
    }
}
