//! Surfaces to be drawn: triangles with a normal at every corner, and lines.

use polhode::spatial::DVec3;

/// A surface to be drawn, m. Where two faces meet at a sharp edge its vertices stand twice, each with the normal of its
/// face.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SurfaceMesh {
    /// Where the vertices are.
    pub positions: Vec<DVec3>,
    /// Outward unit normals at the vertices.
    pub normals: Vec<DVec3>,
    /// Vertices of every triangle, anticlockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Pairs of vertices to be joined by a line: sharp edges, and on round shapes the circles that show how they turn.
    pub lines: Vec<[u32; 2]>,
}

impl SurfaceMesh {
    /// Adds a vertex; its number.
    pub(crate) fn add_vertex(&mut self, position: DVec3, normal: DVec3) -> u32 {
        self.positions.push(position);
        self.normals.push(normal);
        self.positions.len() as u32 - 1
    }

    /// Adds the triangles and lines of another surface, moved and scaled.
    pub(crate) fn add_moved(&mut self, other: &Self, offset: DVec3, scale: f64) {
        let first = self.positions.len() as u32;
        self.positions.extend(other.positions.iter().map(|&p| p * scale + offset));
        self.normals.extend_from_slice(&other.normals);
        self.triangles.extend(other.triangles.iter().map(|corners| corners.map(|corner| corner + first)));
        self.lines.extend(other.lines.iter().map(|ends| ends.map(|end| end + first)));
    }

    /// The positions of the corners of all triangles, m.
    pub fn corner_positions(&self) -> impl Iterator<Item = [DVec3; 3]> + '_ {
        self.triangles.iter().map(|corners| corners.map(|corner| self.positions[corner as usize]))
    }

    /// Smallest and largest coordinates; none of a surface without vertices.
    pub fn bounds(&self) -> Option<[DVec3; 2]> {
        let first = *self.positions.first()?;
        Some(self.positions.iter().fold([first; 2], |[low, high], &p| [low.min(p), high.max(p)]))
    }
}
