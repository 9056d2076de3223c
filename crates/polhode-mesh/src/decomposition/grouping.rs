//! Pieces that have fallen apart: which faces bound the same body.

use super::adjacency::{Adjacency, Joint};
use super::chain::{Edge, Face, loops, twice_area};
use super::cut::Space;
use crate::triangle_mesh::Bounds;
use glam::DVec3;
use polhode_spatial::{CompensatedSum, DisjointSets};
use std::collections::BTreeMap;

/// A piece that does not fall apart, or not for certain.
#[derive(Debug)]
pub(super) struct Group {
    pub(super) faces: Vec<Face>,
    /// Its reflex edges; the indices are those of its faces.
    pub(super) reflex: Vec<Joint>,
}

/// A loop of a face.
struct Sheet {
    face: u32,
    edges: Vec<Edge>,
}

/// The bodies of a piece. Bodies without reflex edges are convex and come apart for certain; a void stays with every
/// body whose bounding box holds it.
pub(super) fn groups(space: &Space, faces: &[Face], adjacency: &Adjacency) -> Vec<Group> {
    let sheets = Sheets::of(space, faces);
    let mut sets = DisjointSets::new(sheets.all.len());
    for &Joint { edge, faces: [first, second] } in &adjacency.joints {
        let (from, to) = edge;
        if let (Some(p), Some(q)) = (sheets.with(first, edge), sheets.with(second, (to, from))) {
            sets.join(p, q);
        }
    }
    if !adjacency.reflex.is_empty() {
        join_holes(space, faces, &sheets.all, &mut sets);
        join_voids(space, faces, &sheets.all, &mut sets);
    }
    split(faces, &sheets, &mut sets, &adjacency.reflex)
}

/// The loops of all faces of a piece, in the order of the faces.
struct Sheets {
    all: Vec<Sheet>,
    /// The first sheet of each face; one more entry than faces.
    first: Vec<usize>,
}

impl Sheets {
    fn of(space: &Space, faces: &[Face]) -> Self {
        let mut sheets = Self { all: Vec::with_capacity(faces.len()), first: Vec::with_capacity(faces.len() + 1) };
        for (face, index) in faces.iter().zip(0u32..) {
            sheets.first.push(sheets.all.len());
            let found = loops(&face.edges, &space.positions, space.normal(face));
            sheets.all.extend(found.into_iter().map(|edges| Sheet { face: index, edges }));
        }
        sheets.first.push(sheets.all.len());
        sheets
    }

    /// The sheet of a face that holds an edge. Nearly all faces have one sheet.
    fn with(&self, face: u32, edge: Edge) -> Option<usize> {
        let [first, end] = [0, 1].map(|k| self.first.get(face as usize + k).copied().unwrap_or_default());
        match end.saturating_sub(first) {
            0 => None,
            1 => Some(first),
            _ => (first..end).find(|&index| self.all[index].edges.contains(&edge)),
        }
    }
}

/// A hole belongs to one of the loops of its face; which one does not matter as long as they stay together.
fn join_holes(space: &Space, faces: &[Face], sheets: &[Sheet], sets: &mut DisjointSets) {
    let indices: Vec<usize> = (0..sheets.len()).collect();
    for face in indices.chunk_by(|&p, &q| sheets[p].face == sheets[q].face) {
        let normal = space.normal(&faces[sheets[face[0]].face as usize]);
        let is_hole = |&sheet: &usize| {
            let (area, length) = twice_area(&sheets[sheet].edges, &space.positions, normal);
            area < -space.tolerance * length
        };
        if face.len() > 1 && face.iter().any(is_hole) {
            face.windows(2).for_each(|pair| sets.join(pair[0], pair[1]));
        }
    }
}

/// A body of negative volume is a void and belongs to a body around it.
fn join_voids(space: &Space, faces: &[Face], sheets: &[Sheet], sets: &mut DisjointSets) {
    let mut bodies: BTreeMap<usize, (f64, Bounds)> = BTreeMap::new();
    let apex = apex(space, faces);
    for (index, sheet) in sheets.iter().enumerate() {
        let around = Bounds::of(sheet.edges.iter().map(|&(v, _)| space.positions[v as usize]));
        let normal = space.normal(&faces[sheet.face as usize]);
        let body = bodies.entry(sets.smallest(index)).or_insert((0.0, around));
        body.0 += cone(space, &sheet.edges, normal, apex);
        body.1 = Bounds::of([body.1.min, body.1.max, around.min, around.max]);
    }
    let voids: Vec<(usize, Bounds)> =
        bodies.iter().filter(|(_, body)| body.0 < 0.0).map(|(&index, body)| (index, body.1)).collect();
    for (void, bounds) in voids {
        for (&other, (_, around)) in &bodies {
            if around.contains(bounds.min) && around.contains(bounds.max) {
                sets.join(void, other);
            }
        }
    }
}

/// Volume that closed faces bound, m^3.
pub(super) fn volume(space: &Space, faces: &[Face]) -> f64 {
    let apex = apex(space, faces);
    let cones = faces.iter().map(|face| cone(space, &face.edges, space.normal(face), apex));
    cones.collect::<CompensatedSum>().value()
}

/// A vertex, as the common apex of cones.
fn apex(space: &Space, faces: &[Face]) -> DVec3 {
    let first = faces.first().and_then(|face| face.edges.first());
    first.map_or(DVec3::ZERO, |&(vertex, _)| space.positions[vertex as usize])
}

/// Signed volume of the cone over a chain, m^3.
fn cone(space: &Space, edges: &[Edge], normal: DVec3, apex: DVec3) -> f64 {
    let Some(&(first, _)) = edges.first() else { return 0.0 };
    let height = normal.dot(space.positions[first as usize] - apex);
    twice_area(edges, &space.positions, normal).0 * height / 6.0
}

/// The groups with their faces, in the order of their first sheets.
fn split(faces: &[Face], sheets: &Sheets, sets: &mut DisjointSets, reflex: &[Joint]) -> Vec<Group> {
    let mut number: BTreeMap<usize, usize> = BTreeMap::new();
    // For each group its faces, and which faces of the piece they were, ascending because sheets are.
    let mut groups: Vec<(Group, Vec<u32>)> = Vec::new();
    for (index, sheet) in sheets.all.iter().enumerate() {
        let group = *number.entry(sets.smallest(index)).or_insert_with(|| {
            groups.push((Group { faces: Vec::new(), reflex: Vec::new() }, Vec::new()));
            groups.len() - 1
        });
        let (Group { faces: own, .. }, origins) = &mut groups[group];
        match (own.last_mut(), origins.last()) {
            (Some(face), Some(&origin)) if origin == sheet.face => face.edges.extend(&sheet.edges),
            _ => {
                own.push(Face { edges: sheet.edges.clone(), ..faces[sheet.face as usize] });
                origins.push(sheet.face);
            }
        }
    }
    for &joint in reflex {
        let Some(sheet) = sheets.with(joint.faces[0], joint.edge) else { continue };
        let Some(&group) = number.get(&sets.smallest(sheet)) else { continue };
        let (Group { reflex: own, .. }, origins) = &mut groups[group];
        if let [Ok(first), Ok(second)] = joint.faces.map(|face| origins.binary_search(&face)) {
            own.push(Joint { faces: [first as u32, second as u32], ..joint });
        }
    }
    groups.into_iter().map(|(group, _)| group).collect()
}
