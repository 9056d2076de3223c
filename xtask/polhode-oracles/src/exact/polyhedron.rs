//! The convex hull of some points with its faces and edges, exact for the coordinates as given.
//!
//! Gift wrapping: a plane through three points that has none beyond it carries a face, which is the convex polygon of
//! all points in that plane; about each edge of it the plane is turned until it meets the next point, which gives the
//! face on the other side. On which side of a plane a point lies is decided without rounding, so that the faces are
//! those of the points and of no tolerance. Points inside the body, a face or an edge are no vertices. The work is the
//! number of points times the number of faces.
//!
//! Written for judging alone: it shares no code with the hulls of polhode-mesh and polhode-contact. There is none of
//! flat points, and none of points of which it is a matter of tolerance whether two faces are one (`LEAST_STEP`).

use super::dyadic::ExactVector;
use super::orientation::orientation;
use glam::DVec3;
use std::collections::BTreeMap;

/// Faces of which neither leaves the plane of the other by more than this, relative to the size, may count as one: what
/// is judged makes one of those that do not by 1e-10. Such bodies are not judged.
const LEAST_STEP: f64 = 1e-9;

/// Sine of the angle in a triangle below which its normal is summed exactly.
const SLENDER: f64 = 0.1;

/// A face.
#[derive(Debug, Clone)]
pub struct Face {
    /// Anticlockwise, seen from outside.
    pub vertices: Vec<usize>,
    /// `edges[i]` joins `vertices[i]` to the next one.
    pub edges: Vec<usize>,
    /// Outward unit normal.
    pub normal: DVec3,
}

/// An edge.
#[derive(Debug, Clone, Copy)]
pub struct Edge {
    /// Numbers of its ends.
    pub vertices: [usize; 2],
    /// The loop of the first face runs along the edge, that of the second one against it.
    pub faces: [usize; 2],
    /// Unit vector from the first vertex to the second.
    pub direction: DVec3,
}

/// A convex polyhedron.
#[derive(Debug, Clone)]
pub struct Polyhedron {
    /// In the frame of the body, m.
    pub vertices: Vec<DVec3>,
    /// Its faces.
    pub faces: Vec<Face>,
    /// Its edges.
    pub edges: Vec<Edge>,
    /// Largest distance of two vertices, m.
    pub size: f64,
}

impl Polyhedron {
    /// The convex hull of some points, m; nothing when they are flat, or when two of its faces are almost one.
    pub fn hull(points: &[DVec3]) -> Option<Self> {
        let loops = loops(points)?;
        let mut corners: Vec<usize> = loops.iter().flatten().copied().collect();
        corners.sort_unstable();
        corners.dedup();
        let number: BTreeMap<usize, usize> =
            corners.iter().enumerate().map(|(number, &point)| (point, number)).collect();
        let vertices: Vec<DVec3> = corners.iter().map(|&point| points[point]).collect();
        let of_vertices = |corners: &Vec<usize>| corners.iter().map(|point| number[point]).collect::<Vec<usize>>();
        let polyhedron = Self::of_loops(vertices, &loops.iter().map(of_vertices).collect::<Vec<_>>())?;
        (polyhedron.least_step() > LEAST_STEP * polyhedron.size).then_some(polyhedron)
    }

    /// A box about the origin with these edge lengths, m.
    pub fn cuboid(size: DVec3) -> Option<Self> {
        let sign = |i: u32, bit: u32| if i >> bit & 1 == 1 { 0.5 } else { -0.5 };
        let corner = |i: u32| DVec3::new(sign(i, 0), sign(i, 1), sign(i, 2)) * size;
        Self::hull(&(0..8).map(corner).collect::<Vec<_>>())
    }

    /// Nothing when an edge has one face only.
    fn of_loops(vertices: Vec<DVec3>, loops: &[Vec<usize>]) -> Option<Self> {
        let mut face_along = BTreeMap::new();
        for (face, corners) in loops.iter().enumerate() {
            face_along.extend(sides(corners).map(|side| (side, face)));
        }
        let (mut edges, mut number) = (Vec::new(), BTreeMap::new());
        for (&[from, to], &face) in face_along.iter().filter(|([from, to], _)| from < to) {
            let direction = (vertices[to] - vertices[from]).normalize();
            number.insert([from, to], edges.len());
            edges.push(Edge { vertices: [from, to], faces: [face, *face_along.get(&[to, from])?], direction });
        }
        let edge = |[from, to]: [usize; 2]| number.get(&[from.min(to), from.max(to)]).copied();
        let face = |corners: &Vec<usize>| {
            let edges = sides(corners).map(edge).collect::<Option<Vec<usize>>>()?;
            Some(Face { vertices: corners.clone(), edges, normal: unit_normal(&vertices, corners) })
        };
        let faces = loops.iter().map(face).collect::<Option<Vec<Face>>>()?;
        let distances = vertices.iter().flat_map(|v| vertices.iter().map(move |w| v.distance(*w)));
        let size = distances.fold(0.0, f64::max);
        Some(Self { vertices, faces, edges, size })
    }

    /// By how much two faces of an edge leave each other's plane, of the edge at which that is least, m.
    fn least_step(&self) -> f64 {
        let depth = |of: &Face, below: &Face| {
            let origin = self.vertices[below.vertices[0]];
            of.vertices.iter().map(|&v| below.normal.dot(origin - self.vertices[v])).fold(0.0, f64::max)
        };
        let steps = self.edges.iter().map(|edge| {
            let [left, right] = edge.faces.map(|face| &self.faces[face]);
            depth(left, right).max(depth(right, left))
        });
        steps.fold(f64::INFINITY, f64::min)
    }
}

/// The directed sides of a loop.
fn sides(corners: &[usize]) -> impl Iterator<Item = [usize; 2]> + '_ {
    (0..corners.len()).map(|k| [corners[k], corners[(k + 1) % corners.len()]])
}

/// The faces of the hull as anticlockwise loops of points.
fn loops(points: &[DVec3]) -> Option<Vec<Vec<usize>>> {
    let mut loops = vec![face_in(points, first_plane(points)?)?];
    let mut known: BTreeMap<[usize; 2], usize> = sides(&loops[0]).map(|side| (side, 0)).collect();
    let mut at = 0;
    while at < loops.len() {
        for [from, to] in sides(&loops[at].clone()) {
            if known.contains_key(&[to, from]) {
                continue;
            }
            let face = face_in(points, turned_about(points, [to, from], &loops[at])?)?;
            known.extend(sides(&face).map(|side| (side, loops.len())));
            loops.push(face);
        }
        at += 1;
    }
    Some(loops)
}

fn corners(points: &[DVec3], plane: [usize; 3]) -> [DVec3; 3] {
    plane.map(|k| points[k])
}

/// Whether one point comes before another one by its coordinates: the first of all is a vertex.
fn is_before(p: DVec3, q: DVec3) -> bool {
    (p.x, p.y, p.z) < (q.x, q.y, q.z)
}

fn first_of(points: &[DVec3], among: impl Iterator<Item = usize>) -> Option<usize> {
    among.reduce(|first, k| if is_before(points[k], points[first]) { k } else { first })
}

/// Three points whose plane has none beyond it and some below it.
fn first_plane(points: &[DVec3]) -> Option<[usize; 3]> {
    let first = first_of(points, 0..points.len())?;
    let pairs = (0..points.len()).flat_map(|b| (0..points.len()).map(move |c| [first, b, c]));
    pairs.into_iter().find(|&plane| {
        let mut is_above = false;
        let mut is_below = false;
        for &point in points {
            let sign = orientation(corners(points, plane), point);
            is_above |= sign > 0;
            is_below |= sign < 0;
            if is_above {
                break;
            }
        }
        is_below && !is_above
    })
}

/// The plane about an edge (in the sense in which its face will run) that has no point beyond it; `other` is the face
/// on the other side of the edge.
fn turned_about(points: &[DVec3], [from, to]: [usize; 2], other: &[usize]) -> Option<[usize; 3]> {
    let of_other = [other[0], other[1], other[2]];
    let mut off_other = (0..points.len()).filter(|&k| orientation(corners(points, of_other), points[k]) < 0);
    let mut plane = [from, to, off_other.next()?];
    for k in off_other {
        if orientation(corners(points, plane), points[k]) > 0 {
            plane[2] = k;
        }
    }
    Some(plane)
}

/// The convex polygon of the points in a plane that has none beyond it, anticlockwise seen from outside.
fn face_in(points: &[DVec3], plane: [usize; 3]) -> Option<Vec<usize>> {
    let sign = |k: usize| orientation(corners(points, plane), points[k]);
    let signs: Vec<i32> = (0..points.len()).map(sign).collect();
    let below = points[signs.iter().position(|&sign| sign < 0)?];
    let within: Vec<usize> = (0..points.len()).filter(|&k| signs[k] == 0).collect();
    let first = first_of(points, within.iter().copied())?;
    let mut polygon = vec![first];
    let mut at = first;
    loop {
        let mut next: Option<usize> = None;
        for &k in within.iter().filter(|&&k| points[k] != points[at]) {
            let Some(best) = next else {
                next = Some(k);
                continue;
            };
            // Seen from outside, what is below the plane is behind it.
            let right = orientation([points[at], points[best], points[k]], below);
            if right > 0 || right == 0 && is_between(points[best], points[at], points[k]) {
                next = Some(k);
            }
        }
        at = next?;
        if points[at] == points[first] {
            return Some(polygon);
        }
        polygon.push(at);
        if polygon.len() > within.len() {
            return None;
        }
    }
}

/// Whether a point of a line lies between two others.
fn is_between(point: DVec3, from: DVec3, to: DVec3) -> bool {
    from.min(to).cmple(point).all() && point.cmple(from.max(to)).all()
}

/// Unit normal of a loop of vertices by the sum of the areas of a fan of triangles; exactly summed where the triangles
/// are so slender that f64 would lose digits.
fn unit_normal(vertices: &[DVec3], corners: &[usize]) -> DVec3 {
    let Some((&first, rest)) = corners.split_first() else { return DVec3::NAN };
    let from = |v: usize| vertices[v] - vertices[first];
    let fan = || rest.windows(2).map(|e| [from(e[0]), from(e[1])]);
    let normal: DVec3 = fan().map(|[p, q]| p.cross(q)).sum();
    let products: f64 = fan().map(|[p, q]| p.length() * q.length()).sum();
    if normal.length() > SLENDER * products {
        return normal.normalize();
    }
    let exact = |v: usize| &ExactVector::from(vertices[v]) - &ExactVector::from(vertices[first]);
    let zero = ExactVector::from(DVec3::ZERO);
    let normal = rest.windows(2).fold(zero, |sum, e| &sum + &exact(e[0]).cross(&exact(e[1])));
    let square = normal.dot(&normal);
    DVec3::from_array(normal.0.map(|component| component.over_root_less(&square, 0.0)))
}

#[cfg(test)]
mod tests {
    //! Hulls whose faces are known.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    fn counts(polyhedron: &Polyhedron) -> [usize; 3] {
        [polyhedron.vertices.len(), polyhedron.edges.len(), polyhedron.faces.len()]
    }

    #[test]
    fn a_grid_of_points_is_a_cube() {
        let grid = (0..27).map(|i| DVec3::new(f64::from(i % 3), f64::from(i / 3 % 3), f64::from(i / 9)));
        let cube = Polyhedron::hull(&grid.collect::<Vec<_>>()).unwrap();
        assert_eq!(counts(&cube), [8, 12, 6]);
        assert!((cube.size - 2.0 * 3.0_f64.sqrt()).abs() < 1e-15);
        assert!(cube.faces.iter().all(|face| face.vertices.len() == 4 && face.normal.abs().max_element() == 1.0));
        for face in &cube.faces {
            assert!(face.normal.dot(cube.vertices[face.vertices[0]] - DVec3::ONE) > 0.0, "{face:?} points inward");
        }
    }

    #[test]
    fn a_plate_a_millionth_thick_keeps_its_edges_and_a_flat_one_is_none() {
        assert_eq!(counts(&Polyhedron::cuboid(DVec3::new(0.3, 0.7, 1e-6)).unwrap()), [8, 12, 6]);
        assert!(Polyhedron::cuboid(DVec3::new(0.3, 0.7, 0.0)).is_none());
    }

    #[test]
    fn faces_that_are_almost_one_are_not_judged() {
        let roof = |height: f64| {
            let base = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
            let top = base.map(|p| p + DVec3::Z);
            Polyhedron::hull(&[&base[..], &top, &[DVec3::new(0.5, 0.5, 1.0 + height)]].concat())
        };
        assert_eq!(counts(&roof(1e-3).unwrap()), [9, 16, 9]);
        assert!(roof(1e-12).is_none());
        assert_eq!(counts(&roof(0.0).unwrap()), [8, 12, 6]);
    }

    #[test]
    fn edges_lie_between_their_faces() {
        let points: Vec<DVec3> =
            (0..20).map(|k| DVec3::new(f64::from(k * 7 % 11), f64::from(k * k % 13), f64::from(k * 3 % 17))).collect();
        let hull = Polyhedron::hull(&points).unwrap();
        let [vertices, edges, faces] = counts(&hull);
        assert_eq!(vertices + faces, edges + 2);
        for edge in &hull.edges {
            let [left, right] = edge.faces.map(|face| hull.faces[face].normal);
            assert!(left.cross(right).dot(edge.direction) > 0.0, "{edge:?}");
        }
    }
}
