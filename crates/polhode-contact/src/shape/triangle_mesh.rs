//! Triangle meshes as ground: surfaces, open or closed, of a body that does not move.
//!
//! The surface is thin and has two sides: a body that penetrates it is pushed out on the side on which less of it
//! penetrates, which is the side it comes from. A closed mesh is hollow: a body inside it touches the inner side.
//! Neighbouring triangles in one plane form a flat patch, which is one face, so that a body which slides over them
//! keeps its contact. Patch `p` is face `2 p` seen from outside (triangles anticlockwise) and face `2 p + 1` seen from
//! inside. Vertices with equal coordinates are joined and have the lowest of their numbers; edges are numbered in the
//! order in which they first occur in the triangles.

use super::error::{LARGEST_LENGTH, ShapeError, check_point};
use super::point_cloud::largest_distance;
use super::polyhedron::ConvexPolyhedron;
use super::support::middle_coordinate;
use super::topology;
use super::triangle::area_vector;
use crate::bounding::BoxTree;
use crate::bounding::aabb::Aabb;
use crate::clearance::COINCIDENCE;
use crate::shape::lists::Lists;
use glam::DVec3;
use polhode_spatial::Pose;
use std::collections::BTreeMap;

/// A plane part of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Patch {
    /// Outward unit normal.
    pub(crate) normal: DVec3,
    /// `normal . x` of its points, m.
    pub(crate) offset: f64,
}

/// An edge of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MeshEdge {
    pub(crate) vertices: [u32; 2],
    pub(crate) direction: DVec3,
    pub(crate) length: f64,
    /// Sum of the unit vectors out of its triangles, in their planes: the middle of the normals that contacts on the
    /// edge may have.
    pub(crate) outward: DVec3,
    /// Whether it lies within a patch.
    pub(crate) flat: bool,
}

/// A surface of triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct TriangleMesh {
    pub(crate) vertices: Vec<DVec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The triangles with joined vertices.
    pub(crate) joined: Vec<[u32; 3]>,
    pub(crate) patches: Vec<Patch>,
    /// Patch of every triangle.
    pub(crate) patch_of: Vec<u32>,
    pub(crate) edges: Vec<MeshEdge>,
    /// Edges of every triangle: the k-th runs from corner k to the next.
    pub(crate) edges_of: Vec<[u32; 3]>,
    /// For each edge of every triangle the unit vector in its plane, perpendicular to the edge and out of the triangle.
    pub(crate) sides: Vec<[DVec3; 3]>,
    /// Triangles at every edge.
    pub(crate) at_edge: Lists,
    /// Triangles at every vertex.
    pub(crate) at_vertex: Lists,
    pub(crate) tree: BoxTree,
    size: f64,
    radius: f64,
}

impl TriangleMesh {
    /// From vertices in the body's frame (m) and triangles, anticlockwise seen from outside.
    ///
    /// # Errors
    /// When there is no triangle, one names a vertex that does not exist or has no area (its height is below 1e-12 of
    /// its longest side), two are the same, or a coordinate is not finite.
    pub fn new(vertices: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, ShapeError> {
        if triangles.is_empty() {
            return Err(ShapeError::NoPart { what: "triangles" });
        }
        // Edges (three for each triangle) and faces (two) must fit into 32 bits.
        let (most, limit) = (vertices.len().max(triangles.len()), u32::MAX as usize / 3);
        if most > limit {
            return Err(ShapeError::TooManyPoints { count: most, limit });
        }
        vertices.iter().try_for_each(|&vertex| check_point("vertex", vertex))?;
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&v| v as usize >= vertices.len()) {
                return Err(ShapeError::NoSuchVertex { triangle, vertex, vertices: vertices.len() });
            }
        }
        let joined = joined(&vertices, &triangles);
        let normals = normals(&vertices, &joined)?;
        let at_vertex = Lists::new(vertices.len(), items_of(&joined));
        let used: Vec<DVec3> = used_vertices(&vertices, &at_vertex).collect();
        let size = largest_distance(&used);
        let (mut edges, edges_of) = edges_of(&vertices, &joined);
        let sides_of = |(t, n): (&[u32; 3], &DVec3)| [0, 1, 2].map(|k| side_of(&vertices, t, *n, k));
        let sides: Vec<[DVec3; 3]> = joined.iter().zip(&normals).map(sides_of).collect();
        let at_edge = Lists::new(edges.len(), items_of(&edges_of));
        let (patches, patch_of) = patches(&vertices, &joined, &normals, &edges_of, &at_edge, COINCIDENCE * size);
        for (index, edge) in edges.iter_mut().enumerate() {
            let around = at_edge.of(index);
            edge.flat = matches!(around, [t, u] if patch_of[*t as usize] == patch_of[*u as usize]);
            let outward = around.iter().map(|&t| {
                let k = edges_of[t as usize].iter().position(|&e| e as usize == index).unwrap_or(0);
                sides[t as usize][k]
            });
            edge.outward = outward.sum();
        }
        let corners = |t: &[u32; 3]| Aabb::of_points(t.iter().map(|&v| vertices[v as usize]));
        let boxes: Vec<Aabb> = joined.iter().map(corners).collect();
        let radius = used.iter().map(|vertex| vertex.length()).fold(0.0, f64::max);
        let tree = BoxTree::new(&boxes);
        Ok(Self {
            vertices,
            triangles,
            joined,
            patches,
            patch_of,
            edges,
            edges_of,
            sides,
            at_edge,
            at_vertex,
            tree,
            size,
            radius,
        })
    }

    /// Vertices in the body's frame, m.
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// Corners of every triangle, anticlockwise seen from outside.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The flat patch of a triangle: its outer side is face `2 p`, its inner side face `2 p + 1`.
    pub fn patch(&self, triangle: usize) -> Option<u32> {
        self.patch_of.get(triangle).copied()
    }

    pub(super) fn placed(&self, pose: &Pose) -> Result<Self, ShapeError> {
        let vertices = self.vertices.iter().map(|&vertex| pose.transform_point(vertex)).collect();
        Self::new(vertices, self.triangles.clone())
    }

    pub(super) const fn size(&self) -> f64 {
        self.size
    }

    pub(crate) fn bounds(&self) -> Aabb {
        self.tree.bounds()
    }

    /// Largest distance of a point of the surface from the frame's origin, m.
    pub(crate) const fn radius(&self) -> f64 {
        self.radius
    }

    /// The vertices that belong to a triangle, m.
    pub(crate) fn used_vertices(&self) -> impl Iterator<Item = DVec3> {
        used_vertices(&self.vertices, &self.at_vertex)
    }

    /// Corners of a triangle that exists, m.
    pub(crate) fn corners(&self, triangle: u32) -> [DVec3; 3] {
        self.joined[triangle as usize].map(|v| self.vertices[v as usize])
    }

    /// Distance of a point from the nearest vertex that belongs to a triangle, m.
    pub(crate) fn distance_to_vertex(&self, x: DVec3) -> f64 {
        let here = Aabb::of_point(x);
        self.tree.least(f64::INFINITY, 0.0, &|bounds: &Aabb| bounds.distance(&here), &mut |triangle, _| {
            self.corners(triangle).iter().map(|corner| corner.distance(x)).fold(f64::INFINITY, f64::min)
        })
    }

    /// The plane of a face, which is a patch seen from one side.
    pub(crate) fn face_plane(&self, face: u32) -> Option<Patch> {
        let patch = *self.patches.get(face as usize / 2)?;
        Some(if face.is_multiple_of(2) { patch } else { Patch { normal: -patch.normal, offset: -patch.offset } })
    }

    /// A triangle as a polyhedron of two faces and no thickness, with the normals of its patch.
    pub(crate) fn flat_polyhedron(&self, triangle: u32) -> ConvexPolyhedron {
        let patch = self.patches[self.patch_of[triangle as usize] as usize];
        topology::flat_triangle(self.corners(triangle), patch.normal)
    }
}

fn items_of(of: &[[u32; 3]]) -> impl Iterator<Item = (u32, u32)> + Clone + '_ {
    of.iter().enumerate().flat_map(|(t, keys)| keys.iter().map(move |&key| (key, t as u32)))
}

/// The vertices that belong to a triangle; others are not part of the surface.
fn used_vertices(vertices: &[DVec3], at_vertex: &Lists) -> impl Iterator<Item = DVec3> {
    vertices.iter().enumerate().filter(|(index, _)| !at_vertex.of(*index).is_empty()).map(|(_, &place)| place)
}

/// The triangles with every vertex replaced by the lowest one with equal coordinates.
fn joined(vertices: &[DVec3], triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut places = BTreeMap::new();
    // Adding zero makes -0 and 0 equal keys.
    let key = |p: DVec3| (p + 0.0).to_array().map(f64::to_bits);
    let first: Vec<u32> =
        vertices.iter().enumerate().map(|(i, &p)| *places.entry(key(p)).or_insert(i as u32)).collect();
    triangles.iter().map(|t| t.map(|v| first[v as usize])).collect()
}

/// Outward unit normals; an error for a triangle without area, or one that occurs twice.
fn normals(vertices: &[DVec3], triangles: &[[u32; 3]]) -> Result<Vec<DVec3>, ShapeError> {
    let mut seen = BTreeMap::new();
    let mut normals = Vec::with_capacity(triangles.len());
    for (triangle, corners) in triangles.iter().enumerate() {
        let mut sorted = *corners;
        sorted.sort_unstable();
        let [a, b, c] = corners.map(|v| vertices[v as usize]);
        let longest = (b - a).length().max((c - b).length()).max((a - c).length());
        // Scaled, so that no square overflows or underflows.
        let area = area_vector([a, b, c].map(|corner| (corner - a) / longest));
        let height = area.length() * longest;
        if !(longest <= LARGEST_LENGTH && height > COINCIDENCE * longest) {
            return Err(ShapeError::NoArea { triangle, height, longest });
        }
        if let Some(&double) = seen.get(&sorted) {
            return Err(ShapeError::Double { triangle, of: double });
        }
        seen.insert(sorted, triangle);
        normals.push(area / area.length());
    }
    Ok(normals)
}

/// Unit vector in a triangle's plane, perpendicular to its k-th side and out of the triangle.
fn side_of(vertices: &[DVec3], triangle: &[u32; 3], normal: DVec3, k: usize) -> DVec3 {
    let at = |k: usize| vertices[triangle[k % 3] as usize];
    (at(k + 1) - at(k)).cross(normal).normalize_or_zero()
}

/// Edges in the order in which they first occur in the triangles, and the edges of every triangle.
fn edges_of(vertices: &[DVec3], triangles: &[[u32; 3]]) -> (Vec<MeshEdge>, Vec<[u32; 3]>) {
    let mut numbers = BTreeMap::new();
    let mut edges = Vec::new();
    let mut of = Vec::with_capacity(triangles.len());
    for triangle in triangles {
        let mut own = [0; 3];
        for (k, own) in own.iter_mut().enumerate() {
            let (from, to) = (triangle[k], triangle[(k + 1) % 3]);
            *own = *numbers.entry((from.min(to), from.max(to))).or_insert_with(|| {
                let along = vertices[to as usize] - vertices[from as usize];
                let length = along.length();
                let (direction, outward) = (along / length, DVec3::ZERO);
                edges.push(MeshEdge { vertices: [from, to], direction, length, outward, flat: false });
                edges.len() as u32 - 1
            });
        }
        of.push(own);
    }
    (edges, of)
}

/// Each patch is grown from its triangle of lowest number over neighbours (two triangles at an edge, with the same
/// orientation) whose vertices lie in its plane. The normal of a patch is the mean of its triangles' normals weighted
/// by area; its offset is the middle of the smallest and largest offset of its vertices.
fn patches(
    vertices: &[DVec3],
    triangles: &[[u32; 3]],
    normals: &[DVec3],
    edges_of: &[[u32; 3]],
    at_edge: &Lists,
    tolerance: f64,
) -> (Vec<Patch>, Vec<u32>) {
    let corners = |t: u32| triangles[t as usize].map(|v| vertices[v as usize]);
    let mut patch_of = vec![u32::MAX; triangles.len()];
    let mut patches = Vec::new();
    let mut members: Vec<u32> = Vec::new();
    for seed in 0..triangles.len() as u32 {
        if patch_of[seed as usize] != u32::MAX {
            continue;
        }
        let (number, normal, origin) = (patches.len() as u32, normals[seed as usize], corners(seed)[0]);
        patch_of[seed as usize] = number;
        members.clear();
        members.push(seed);
        let mut next = 0;
        while let Some(&triangle) = members.get(next) {
            next += 1;
            for &edge in &edges_of[triangle as usize] {
                let [t, u] = *at_edge.of(edge as usize) else { continue };
                let other = if t == triangle { u } else { t };
                let plane = corners(other).iter().all(|&v| normal.dot(v - origin).abs() <= tolerance);
                if patch_of[other as usize] == u32::MAX && plane && normal.dot(normals[other as usize]) > 0.0 {
                    patch_of[other as usize] = number;
                    members.push(other);
                }
            }
        }
        let whole: DVec3 = members.iter().map(|&t| area_vector(corners(t))).sum();
        let normal = if members.len() > 1 { whole.try_normalize().unwrap_or(normal) } else { normal };
        let offset = middle_coordinate(members.iter().flat_map(|&t| corners(t)), normal);
        patches.push(Patch { normal, offset });
    }
    (patches, patch_of)
}
