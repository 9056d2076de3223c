//! The surface of a body by its triangles: in the body's own frame, and placed in the world.

use super::box_tree::{Bounds, BoxTree, bounds};
use super::crossing::{self, Triangle};
use super::inward;
use glam::DVec3;
use polhode::mesh::TriangleMesh;
use polhode_spatial::Pose;
use std::collections::BTreeMap;

/// Marks of a body that does not hold its centre of mass, at the most.
const MOST_MARKS: usize = 64;

/// Ways out of a body, relative to its size: along an axis, so that few boxes are in the way; the others for where that
/// one meets a side or a corner.
const WAYS_OUT: [DVec3; 5] = [
    DVec3::new(2.0, 0.0, 0.0),
    DVec3::new(0.0, -2.0, 0.0),
    DVec3::new(1.931, 0.127, 0.0911),
    DVec3::new(-0.173, 0.311, 1.877),
    DVec3::new(0.0713, -1.913, 0.253),
];

/// A body in its own frame.
#[derive(Debug)]
pub(super) struct Surface {
    pub(super) vertices: Vec<DVec3>,
    /// None of a body of points.
    pub(super) triangles: Vec<[usize; 3]>,
    /// Over the triangles, or over the points of a body that has none.
    pub(super) tree: BoxTree,
    /// Closed and turned outward.
    pub(super) is_solid: bool,
    /// For each vertex of a solid the unit vector along which it goes into the solid under all its triangles.
    pub(super) inward: Vec<DVec3>,
    /// Diagonal of the box about it, m.
    pub(super) size: f64,
    /// The centre of mass of a solid, if it holds it; else places inside it.
    pub(super) marks: Vec<DVec3>,
}

impl Surface {
    /// A body of points.
    pub(super) fn of_points(points: &[DVec3]) -> Self {
        Self::new(points.to_vec(), Vec::new())
    }

    /// A body with this mesh.
    pub(super) fn of_mesh(mesh: &TriangleMesh) -> Self {
        let triangles = mesh.triangles().iter().map(|corners| corners.map(|v| v as usize)).collect();
        Self::new(mesh.vertices().to_vec(), triangles)
    }

    fn new(vertices: Vec<DVec3>, triangles: Vec<[usize; 3]>) -> Self {
        let (low, high) = bounds(vertices.iter().copied());
        let tree = BoxTree::new(&boxes(&vertices, &triangles));
        let (volume, center) = volume(&vertices, &triangles);
        let is_solid = volume > 0.0 && is_closed(&triangles);
        let inward = if is_solid { inward::directions(&vertices, &triangles) } else { Vec::new() };
        let size = (high - low).length();
        let mut surface = Self { vertices, triangles, tree, is_solid, inward, size, marks: Vec::new() };
        if is_solid {
            surface.marks = if surface.contains(center) == Some(true) { vec![center] } else { surface.inner_places() };
        }
        surface
    }

    pub(super) fn triangle(&self, index: usize) -> Triangle {
        self.triangles[index].map(|v| self.vertices[v])
    }

    /// Whether a place in the body's frame is inside; nothing when it is on the surface.
    pub(super) fn contains(&self, place: DVec3) -> Option<bool> {
        if !self.tree.is_near(place, 0.0) {
            return Some(false);
        }
        is_inside(place, self.size, |bounds| self.tree.near(bounds, 0.0), |index| self.triangle(index))
    }

    /// Places inside the solid: halfway from a triangle to where the straight way inwards leaves the solid again.
    fn inner_places(&self) -> Vec<DVec3> {
        let every = self.triangles.len().div_ceil(MOST_MARKS);
        let place = |index: usize| {
            let [a, b, c] = self.triangle(index);
            let (from, inward) = ((a + b + c) / 3.0, (c - a).cross(b - a).try_normalize()?);
            let way = [from, from + 2.0 * self.size * inward];
            let found = self.tree.near(bounds(way), 0.0).into_iter().filter(|&other| other != index);
            let depth = |other: usize| {
                let [a, b, c] = self.triangle(other);
                let normal = (b - a).cross(c - a);
                let along = normal.dot(a - from) / normal.dot(inward);
                crossing::goes_through(way, [a, b, c]).then_some(along)
            };
            let nearest = found.filter_map(depth).fold(f64::INFINITY, f64::min);
            Some(from + 0.5 * nearest * inward)
        };
        let places = (0..self.triangles.len()).step_by(every).filter_map(place);
        places.filter(|&place| place.is_finite() && self.contains(place) == Some(true)).collect()
    }
}

/// The boxes of the triangles, or of the points where there are none.
fn boxes(vertices: &[DVec3], triangles: &[[usize; 3]]) -> Vec<Bounds> {
    if triangles.is_empty() {
        return vertices.iter().map(|&v| (v, v)).collect();
    }
    triangles.iter().map(|corners| bounds(corners.map(|v| vertices[v]))).collect()
}

/// Whether every side of a triangle is the side of another one that runs along it the other way.
fn is_closed(triangles: &[[usize; 3]]) -> bool {
    let mut balance: BTreeMap<[usize; 2], i64> = BTreeMap::new();
    for [a, b] in triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]) {
        *balance.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
    }
    balance.values().all(|&count| count == 0)
}

/// Volume of what the triangles enclose, m^3, and its centre.
fn volume(vertices: &[DVec3], triangles: &[[usize; 3]]) -> (f64, DVec3) {
    let origin = vertices.first().copied().unwrap_or_default();
    let (mut volume, mut moment) = (0.0, DVec3::ZERO);
    for corners in triangles {
        let [a, b, c] = corners.map(|v| vertices[v] - origin);
        let part = a.dot(b.cross(c)) / 6.0;
        volume += part;
        moment += part * (a + b + c) / 4.0;
    }
    (volume, origin + moment / volume)
}

/// Whether a place is inside a surface of this size; nothing when it is on it.
fn is_inside(
    place: DVec3,
    size: f64,
    near: impl Fn(Bounds) -> Vec<usize>,
    triangle: impl Fn(usize) -> Triangle,
) -> Option<bool> {
    let count = |out: &DVec3| {
        let way = [place, place + size * *out];
        crossing::crossings(way, near(bounds(way)).into_iter().map(&triangle))
    };
    WAYS_OUT.iter().find_map(count).map(|count| count % 2 == 1)
}

/// A body placed in the world: every vertex is rounded once.
#[derive(Debug, Clone)]
pub(super) struct Placed<'a> {
    pub(super) surface: &'a Surface,
    pub(super) pose: Pose,
    pub(super) vertices: Vec<DVec3>,
    pub(super) tree: BoxTree,
}

impl<'a> Placed<'a> {
    pub(super) fn new(surface: &'a Surface, pose: Pose) -> Self {
        let mut placed = Self { surface, pose, vertices: surface.vertices.clone(), tree: surface.tree.clone() };
        placed.move_to(pose);
        placed
    }

    pub(super) fn move_to(&mut self, pose: Pose) {
        self.pose = pose;
        self.vertices.clear();
        self.vertices.extend(self.surface.vertices.iter().map(|&vertex| pose.transform_point(vertex)));
        let (vertices, triangles) = (&self.vertices, &self.surface.triangles);
        self.tree.fit(|item| match triangles.get(item) {
            Some(corners) => bounds(corners.map(|v| vertices[v])),
            None => (vertices[item], vertices[item]),
        });
    }
}

/// A placed body whose corners have been moved by no more than [`Moved::most`].
#[derive(Debug, Clone, Copy)]
pub(super) struct Moved<'a> {
    pub(super) placed: &'a Placed<'a>,
    /// All corners, m.
    pub(super) shift: DVec3,
    /// Every corner on its own way into the solid, m.
    pub(super) inward: f64,
}

impl<'a> Moved<'a> {
    /// As it is.
    pub(super) const fn not(placed: &'a Placed<'a>) -> Self {
        Self { placed, shift: DVec3::ZERO, inward: 0.0 }
    }

    /// How far a corner has been moved at the most, m.
    fn most(&self) -> f64 {
        self.shift.length() + self.inward
    }

    pub(super) fn triangle(&self, index: usize) -> Triangle {
        let Placed { surface, pose, vertices, .. } = self.placed;
        surface.triangles[index].map(|v| {
            let inward = if self.inward == 0.0 { DVec3::ZERO } else { pose.rotation.rotate(surface.inward[v]) };
            vertices[v] + (self.shift + self.inward * inward)
        })
    }

    /// A point of a body of points.
    pub(super) fn point(&self, index: usize) -> DVec3 {
        self.placed.vertices[index] + self.shift
    }

    /// Whether a place in the world is inside; nothing when it is on the surface.
    pub(super) fn contains(&self, place: DVec3) -> Option<bool> {
        if !self.placed.tree.is_near(place, self.most()) {
            return Some(false);
        }
        let near = |bounds| self.placed.tree.near(bounds, self.most());
        is_inside(place, self.placed.surface.size, near, |index| self.triangle(index))
    }
}

#[cfg(test)]
mod tests {
    //! What is inside a solid, and the marks of one that does not hold its centre of mass.
    use super::*;
    use polhode::mesh::{Refinement, Torus, box_mesh};

    #[test]
    fn a_box_holds_its_middle_and_a_ring_has_marks_in_its_tube() {
        let cube = Surface::of_mesh(box_mesh(DVec3::ONE).expect("a cube").mesh());
        assert!(cube.is_solid && cube.marks.len() == 1 && cube.marks[0].length() < 1e-15, "{:?}", cube.marks);
        assert_eq!([0.4, 0.5, 0.6].map(|x| cube.contains(DVec3::X * x)), [Some(true), None, Some(false)]);
        let ring = Torus::new(0.3, 0.05).and_then(|ring| ring.mesh(Refinement::COARSEST)).expect("a ring");
        let ring = Surface::of_mesh(ring.mesh());
        assert!(ring.marks.len() > MOST_MARKS / 2);
        let from_circle = |p: &DVec3| DVec3::new((p.x * p.x + p.y * p.y).sqrt() - 0.3, 0.0, p.z).length();
        assert!(ring.marks.iter().all(|mark| from_circle(mark) < 0.04), "{:?}", ring.marks);
    }

    #[test]
    fn an_open_surface_is_no_solid() {
        let cube = box_mesh(DVec3::ONE).expect("a cube");
        let open = TriangleMesh::new(cube.mesh().vertices().to_vec(), cube.mesh().triangles()[1..].to_vec());
        assert!(!Surface::of_mesh(&open.expect("a mesh")).is_solid);
    }
}
