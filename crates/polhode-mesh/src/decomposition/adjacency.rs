//! Which faces of a piece meet at which edges, and which of the edges are reflex.
//!
//! An edge is reflex when the material between its two faces turns through more than half a turn. Where more than two
//! faces meet at an edge (pieces that touch there), those are paired that bound the same wedge of material.

use super::chain::{Edge, Face};
use super::cut::Space;
use glam::DVec3;
use std::f64::consts::TAU;

/// An edge with the two faces that bound the material beside it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Joint {
    /// In the direction in which the first face runs along it.
    pub(super) edge: Edge,
    /// Indices of the two faces; the second runs along the edge backwards.
    pub(super) faces: [u32; 2],
}

/// The joints of a piece.
#[derive(Debug)]
pub(super) struct Adjacency {
    /// All of them, ordered by edge.
    pub(super) joints: Vec<Joint>,
    /// The reflex ones.
    pub(super) reflex: Vec<Joint>,
}

impl Adjacency {
    pub(super) fn of(space: &Space, faces: &[Face]) -> Self {
        let mut uses: Vec<(Edge, bool, u32)> = Vec::new();
        for (index, face) in (0u32..).zip(faces) {
            uses.extend(face.edges.iter().map(|&(from, to)| ((from.min(to), from.max(to)), from > to, index)));
        }
        uses.sort_unstable();
        let mut joints = Vec::with_capacity(uses.len() / 2);
        for group in uses.chunk_by(|p, q| p.0 == q.0) {
            let ascending = group.partition_point(|&(_, is_descending, _)| !is_descending);
            let (up, down) = group.split_at(ascending);
            let mut free: Vec<u32> = down.iter().map(|&(_, _, face)| face).collect();
            for &(edge, _, first) in up {
                let angle = |&second: &u32| wedge(space, faces, Joint { edge, faces: [first, second] });
                let nearest = (0..free.len()).min_by(|&i, &j| angle(&free[i]).total_cmp(&angle(&free[j])));
                if let Some(nearest) = nearest {
                    joints.push(Joint { edge, faces: [first, free.remove(nearest)] });
                }
            }
        }
        let reflex = joints.iter().copied().filter(|&joint| is_reflex(space, faces, joint)).collect();
        Self { joints, reflex }
    }
}

/// The directions from an edge into its two faces, and the outward normal of the first; lengths do not matter.
fn directions(space: &Space, faces: &[Face], joint: Joint) -> (DVec3, DVec3, DVec3) {
    let [first, second] = joint.faces.map(|face| space.normal(&faces[face as usize]));
    let (from, to) = joint.edge;
    let along = space.positions[to as usize] - space.positions[from as usize];
    (first.cross(along), along.cross(second), first)
}

/// Angle of the material between the faces, from 0 to a full turn, rad.
fn wedge(space: &Space, faces: &[Face], joint: Joint) -> f64 {
    let (into_first, into_second, normal) = directions(space, faces, joint);
    let angle = libm::atan2(-normal.dot(into_second) * into_first.length(), into_first.dot(into_second));
    if angle < 0.0 { angle + TAU } else { angle }
}

/// Whether the material turns through more than half a turn, by more than rounding: each face must stand in front of
/// the plane of the other by more than the tolerance, for the plane of a sliver is not well known but that of its
/// neighbour is.
fn is_reflex(space: &Space, faces: &[Face], joint: Joint) -> bool {
    let (_, into_second, normal) = directions(space, faces, joint);
    if normal.dot(into_second) <= 0.0 {
        return false;
    }
    let stands_in_front = |face: u32, other: u32| {
        let (face, other) = (&faces[face as usize], &faces[other as usize]);
        let (plane, normal) = (&space.planes[other.plane as usize], space.normal(other));
        face.edges.iter().any(|&(v, _)| normal.dot(space.positions[v as usize] - plane.origin) > space.tolerance)
    };
    let [first, second] = joint.faces;
    stands_in_front(second, first) && stands_in_front(first, second)
}
