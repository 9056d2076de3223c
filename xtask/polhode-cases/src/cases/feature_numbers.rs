//! A polyhedron twice: as the contact crate makes it, and as exact arithmetic finds it from the same points; and which
//! number each vertex, edge and face of the one has in the other.
//!
//! Here alone features that the crate names become those of [`polhode_oracles::exact`]: vertices by their places, edges
//! by their ends, faces by their vertices. A body of the crate's that has not exactly the faces of the hull has no such
//! numbers, which is a finding.

use glam::DVec3;
use polhode_contact::{ContactFeature, ConvexPolyhedron, SeparatingAxis, Shape, Side};
use polhode_oracles::exact::feature::Feature;
use polhode_oracles::exact::pair::AxisOf;
use polhode_oracles::exact::polyhedron::Polyhedron;
use std::collections::BTreeMap;

/// A body that is judged.
#[derive(Debug, Clone)]
pub(super) struct JudgedBody {
    pub(super) shape: Shape,
    pub(super) polyhedron: Polyhedron,
    /// Nothing when the crate has made another polyhedron.
    pub(super) numbers: Option<Numbers>,
}

impl JudgedBody {
    /// The hull of some points, m; nothing when either has none.
    pub(super) fn hull(points: &[DVec3]) -> Option<Self> {
        Some(Self::new(ConvexPolyhedron::from_points(points).ok()?, Polyhedron::hull(points)?))
    }

    /// A box about the origin with these edge lengths, m.
    pub(super) fn cuboid(size: DVec3) -> Option<Self> {
        Some(Self::new(ConvexPolyhedron::cuboid(size).ok()?, Polyhedron::cuboid(size)?))
    }

    fn new(made: ConvexPolyhedron, polyhedron: Polyhedron) -> Self {
        let numbers = Numbers::of(&made, &polyhedron);
        Self { shape: Shape::convex(made), polyhedron, numbers }
    }
}

/// For each vertex, edge and face of the crate's polyhedron the number in the exact one.
#[derive(Debug, Clone)]
pub(super) struct Numbers {
    vertices: Vec<usize>,
    edges: Vec<usize>,
    faces: Vec<usize>,
}

impl Numbers {
    fn of(made: &ConvexPolyhedron, exact: &Polyhedron) -> Option<Self> {
        if made.vertices().len() != exact.vertices.len() {
            return None;
        }
        let place = |v: &DVec3| exact.vertices.iter().position(|w| w == v);
        let vertices = made.vertices().iter().map(place).collect::<Option<Vec<usize>>>()?;
        let ends = exact.edges.iter().map(|edge| edge.vertices.to_vec());
        let edges = made.edges().iter().map(|edge| edge.vertices.to_vec());
        let corners = exact.faces.iter().map(|face| face.vertices.clone());
        let faces = made.faces().map(|face| face.vertices.to_vec());
        Some(Self { edges: matched(ends, edges, &vertices)?, faces: matched(corners, faces, &vertices)?, vertices })
    }
}

/// The numbers of sets of vertices among the exact ones; nothing when they are not the same sets.
fn matched(
    exact: impl Iterator<Item = Vec<usize>>,
    made: impl Iterator<Item = Vec<u32>>,
    vertices: &[usize],
) -> Option<Vec<usize>> {
    let sorted = |mut set: Vec<usize>| {
        set.sort_unstable();
        set
    };
    let number: BTreeMap<Vec<usize>, usize> = exact.enumerate().map(|(number, set)| (sorted(set), number)).collect();
    let named = |set: Vec<u32>| set.iter().map(|&v| vertices.get(v as usize).copied()).collect::<Option<Vec<usize>>>();
    let found = made.map(|set| number.get(&sorted(named(set)?)).copied()).collect::<Option<Vec<usize>>>()?;
    (found.len() == number.len()).then_some(found)
}

/// A contact of the crate's between two bodies of these numbers; nothing for what polyhedra do not have.
pub(super) fn feature([a, b]: [&Numbers; 2], of: ContactFeature) -> Option<Feature> {
    let stands = |vertex_of, [own, other]: [&Numbers; 2], vertex: u32, face: u32| {
        let (vertex, face) = (*own.vertices.get(vertex as usize)?, *other.faces.get(face as usize)?);
        Some(Feature::VertexFace { vertex_of, vertex, face })
    };
    match of {
        ContactFeature::VertexFace { vertex_of: Side::A, vertex, face } => stands(0, [a, b], vertex, face),
        ContactFeature::VertexFace { vertex_of: Side::B, vertex, face } => stands(1, [b, a], vertex, face),
        ContactFeature::EdgeEdge { edge_a, edge_b } => {
            let (edge_a, edge_b) = (*a.edges.get(edge_a as usize)?, *b.edges.get(edge_b as usize)?);
            Some(Feature::EdgeEdge { edge_a, edge_b })
        }
        _ => None,
    }
}

/// The axis that the crate took to decide; nothing for what polyhedra do not have.
pub(super) fn axis([a, b]: [&Numbers; 2], of: SeparatingAxis) -> Option<AxisOf> {
    match of {
        SeparatingAxis::FaceA(face) => Some(AxisOf::FaceA(*a.faces.get(face as usize)?)),
        SeparatingAxis::FaceB(face) => Some(AxisOf::FaceB(*b.faces.get(face as usize)?)),
        SeparatingAxis::Edges(i, j) => Some(AxisOf::Edges(*a.edges.get(i as usize)?, *b.edges.get(j as usize)?)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    //! Features of a box have the same places under both numbers.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn features_of_a_box_are_found_again() {
        let body = JudgedBody::cuboid(DVec3::new(1.0, 2.0, 3.0)).unwrap();
        let numbers = body.numbers.unwrap();
        let Shape::Convex(made) = &body.shape else { panic!("a box is convex") };
        for (face, &number) in made.faces().zip(&numbers.faces) {
            assert_eq!(face.normal, body.polyhedron.faces[number].normal);
        }
        for (edge, &number) in made.edges().iter().zip(&numbers.edges) {
            assert_eq!(edge.direction.abs(), body.polyhedron.edges[number].direction.abs());
        }
    }

    #[test]
    fn another_polyhedron_has_no_numbers() {
        let made = ConvexPolyhedron::cuboid(DVec3::new(1.0, 2.0, 3.0)).unwrap();
        assert!(Numbers::of(&made, &Polyhedron::cuboid(DVec3::new(1.0, 2.0, 3.1)).unwrap()).is_none());
    }
}
