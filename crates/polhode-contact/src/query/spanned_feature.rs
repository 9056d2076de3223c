//! The smallest feature of a polytope that contains given vertices.

use super::piece::Core;
use crate::SurfaceFeature;

impl Core<'_> {
    /// The vertex feature; for a segment, which is the axis of a capsule, the cap at its end.
    pub(crate) const fn corner(&self, vertex: u32) -> SurfaceFeature {
        match self {
            Self::Segment(_) => SurfaceFeature::Cap(vertex),
            _ => SurfaceFeature::Vertex(vertex),
        }
    }

    /// The smallest feature that contains the vertices: the vertex if there is one, their edge if two are joined by
    /// one, otherwise a face that contains them all.
    pub(crate) fn spanned(&self, vertices: &[u32]) -> SurfaceFeature {
        let first = vertices.first().copied().unwrap_or(0);
        match self {
            _ if vertices.len() < 2 => self.corner(first),
            Self::Polyhedron(polyhedron) => {
                let mut edges = polyhedron.edges_at.of(first as usize).iter();
                let joins = |edge: &&u32| {
                    let ends = polyhedron.edges[**edge as usize].vertices;
                    vertices.len() == 2 && vertices.iter().all(|v| ends.contains(v))
                };
                if let Some(&edge) = edges.find(joins) {
                    return SurfaceFeature::Edge(edge);
                }
                let mut faces = polyhedron.faces_at.of(first as usize).iter();
                let has_all = |face: &u32| vertices.iter().all(|&v| polyhedron.faces_at.of(v as usize).contains(face));
                SurfaceFeature::Face(faces.find(|face| has_all(face)).copied().unwrap_or(0))
            }
            Self::Triangle(_) if vertices.len() == 2 => {
                SurfaceFeature::Edge(if vertices == [0, 2] { 2 } else { first })
            }
            Self::Triangle(_) => SurfaceFeature::Face(0),
            _ => SurfaceFeature::Side(0),
        }
    }
}
