//! Quickhull: outward triangles of the convex hull of points, with exact predicates.
//!
//! A tetrahedron grows by one point at a time: the farthest of those outside some face. The faces that the point sees
//! (strictly, by the exact sign) are one connected cap, because coplanar triangles have one and the same sign; the cap
//! is replaced by triangles from its border to the point, and the points outside the removed faces are handed on.

use crate::predicates::{are_collinear, side_of_plane};
use glam::DVec3;

/// No face: the neighbour of an edge that is not linked yet.
const NONE: u32 = u32::MAX;

/// A triangle of the growing hull.
struct Face {
    corners: [u32; 3],
    /// The face across the edge from corner i to corner i + 1.
    neighbors: [u32; 3],
    /// Points strictly in front of the face that no other face has taken.
    outside: Vec<u32>,
    /// The farthest of them, with its determinant.
    farthest: Option<(u32, f64)>,
    is_alive: bool,
}

struct Hull<'a> {
    points: &'a [DVec3],
    faces: Vec<Face>,
    /// For each face the number of the point that last saw it.
    seen_by: Vec<u32>,
    round: u32,
}

/// Outward triangles of the hull of points near one, or none when all lie in one plane.
pub(super) fn triangles(points: &[DVec3]) -> Option<Vec<[u32; 3]>> {
    let start = first_tetrahedron(points)?;
    let mut hull = Hull { points, faces: Vec::new(), seen_by: Vec::new(), round: 0 };
    hull.begin(start);
    // First come, first served: the hull grows evenly, and few points are handed on often.
    let mut next = 0;
    while next < hull.faces.len() as u32 {
        let face = next;
        next += 1;
        if hull.faces[face as usize].is_alive
            && let Some((apex, _)) = hull.faces[face as usize].farthest
        {
            hull.add(apex, face)?;
        }
    }
    Some(hull.faces.iter().filter(|face| face.is_alive).map(|face| face.corners).collect())
}

/// Four points that span a volume, as an outward tetrahedron: extreme ones, so that few points are left outside.
fn first_tetrahedron(points: &[DVec3]) -> Option<[u32; 4]> {
    let farthest = |measure: &dyn Fn(DVec3) -> f64| {
        let mut best = (0, f64::NEG_INFINITY);
        for (index, &point) in (0u32..).zip(points) {
            let value = measure(point);
            if value > best.1 {
                best = (index, value);
            }
        }
        best.0
    };
    let at = |index: u32| points[index as usize];
    let a = farthest(&|p| -p.x);
    let b = farthest(&|p| p.distance_squared(at(a)));
    let mut c = farthest(&|p| (p - at(a)).cross(at(b) - at(a)).length_squared());
    if are_collinear(at(a), at(b), at(c)) {
        // Rounding has hidden how far points are off the line: any that is off will do.
        c = (0u32..).zip(points).find(|&(_, &p)| !are_collinear(at(a), at(b), p))?.0;
    }
    let plane = [at(a), at(b), at(c)];
    let d = farthest(&|p| side_of_plane(plane, p).abs());
    let side = side_of_plane(plane, at(d));
    match side {
        _ if side < 0.0 => Some([a, b, c, d]),
        _ if side > 0.0 => Some([a, c, b, d]),
        _ => None,
    }
}

impl Hull<'_> {
    /// The tetrahedron whose fourth point lies behind the first three, with all points dealt out.
    fn begin(&mut self, [a, b, c, d]: [u32; 4]) {
        self.push([a, b, c], [1, 2, 3]);
        self.push([b, a, d], [0, 3, 2]);
        self.push([c, b, d], [0, 1, 3]);
        self.push([a, c, d], [0, 2, 1]);
        let all = (0..self.points.len() as u32).collect();
        self.deal(all, 0);
    }

    fn push(&mut self, corners: [u32; 3], neighbors: [u32; 3]) {
        self.faces.push(Face { corners, neighbors, outside: Vec::new(), farthest: None, is_alive: true });
        self.seen_by.push(0);
    }

    fn height(&self, face: u32, point: u32) -> f64 {
        let corners = self.faces[face as usize].corners;
        if corners.contains(&point) {
            return 0.0;
        }
        side_of_plane(corners.map(|corner| self.points[corner as usize]), self.points[point as usize])
    }

    /// Gives each point to the first face from `first_face` on that it is outside of; the others are inside the hull.
    fn deal(&mut self, points: Vec<u32>, first_face: u32) {
        for point in points {
            for face in first_face..self.faces.len() as u32 {
                let height = self.height(face, point);
                if height > 0.0 {
                    let face = &mut self.faces[face as usize];
                    face.outside.push(point);
                    if face.farthest.is_none_or(|(_, best)| height > best) {
                        face.farthest = Some((point, height));
                    }
                    break;
                }
            }
        }
    }

    /// Adds a point that lies outside `face`. None when the border of what it sees is not one loop, which exact
    /// predicates rule out.
    fn add(&mut self, apex: u32, face: u32) -> Option<()> {
        self.round += 1;
        let mut visible = vec![face];
        self.seen_by[face as usize] = self.round;
        // Edges (from, to) of visible faces whose other side is not visible, with the face and edge there.
        let mut border: Vec<(u32, u32, u32)> = Vec::new();
        let mut next = 0;
        while let Some(&current) = visible.get(next) {
            next += 1;
            for i in 0..3 {
                let Face { corners, neighbors, .. } = &self.faces[current as usize];
                let (from, to, other) = (corners[i], corners[(i + 1) % 3], neighbors[i]);
                if self.seen_by[other as usize] == self.round {
                    continue;
                }
                if self.height(other, apex) > 0.0 {
                    self.seen_by[other as usize] = self.round;
                    visible.push(other);
                } else {
                    border.push((from, to, other));
                }
            }
        }
        // A face that was found visible after its neighbour had been looked at is no border.
        border.retain(|&(_, _, other)| self.seen_by[other as usize] != self.round);
        border.sort_unstable();
        let mut orphans = Vec::new();
        for &face in &visible {
            let face = &mut self.faces[face as usize];
            face.is_alive = false;
            face.farthest = None;
            orphans.append(&mut face.outside);
        }
        orphans.retain(|&point| point != apex);
        let first_new = self.faces.len() as u32;
        for (index, &(from, to, other)) in (first_new..).zip(&border) {
            self.push([from, to, apex], [other, NONE, NONE]);
            let face = &mut self.faces[other as usize];
            let edge = (0..3).find(|&i| (face.corners[i], face.corners[(i + 1) % 3]) == (to, from))?;
            face.neighbors[edge] = index;
        }
        // The border is a loop: the new face that begins where this one ends is its neighbour.
        for index in 0..border.len() {
            let next = border.binary_search_by_key(&border[index].1, |&(from, _, _)| from).ok()?;
            self.faces[first_new as usize + index].neighbors[1] = first_new + next as u32;
            self.faces[first_new as usize + next].neighbors[2] = first_new + index as u32;
        }
        self.deal(orphans, first_new);
        Some(())
    }
}
