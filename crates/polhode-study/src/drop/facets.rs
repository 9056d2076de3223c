//! The faces on which a body can rest: statics of its convex hull.
//!
//! A body on a plane touches it with its convex hull alone. It rests on a face of the hull where the foot of the centre
//! of mass C lies within the face. With the height h of C above the face (m), the foot's distance b from an edge (m,
//! positive inside) and the distance r of C from the line of the edge (m), `r^2 = h^2 + b^2`:
//!
//! - the plane may be tilted by `atan(b/h)` before the body tips over the edge: the least over all edges is what a face
//!   survives;
//! - tipping over the edge lifts C to r, if its foot on the line of the edge lies between both faces, as seen from C;
//!   else C rises no higher than above the face beyond. The least rise is the barrier of the face: with less energy
//!   than that (times the weight) nothing tips.
//!
//! Faces that are one plane to single precision, in which STL files are written, are one face. The hull is that of
//! `polhode-contact`, with which the body collides. Fails: never; a hull that is flat is refused before.

use polhode::contact::{ConvexPolyhedron, Edge};
use polhode::spatial::rounding::HUNDREDS_OF_TERMS;
use polhode::spatial::{DVec3, DisjointSets};

/// How far points of one plane may lie beside it, relative to the size of the body (no unit): coordinates of a few
/// operations in single precision.
const SINGLE_PRECISION: f64 = 8.0 * f32::EPSILON as f64;

/// A face of the hull.
#[derive(Debug, Clone, PartialEq)]
pub struct Facet {
    /// Outward unit normal, in the body's frame.
    pub normal: DVec3,
    /// Height of the centre of mass above it, m.
    pub height_m: f64,
    /// Area, m^2.
    pub area_m2: f64,
    /// Corners of the hull that lie in it.
    pub corners: usize,
    /// The least angle by which the plane may be tilted before the body tips over an edge, rad; not above zero where
    /// it does not rest on this face.
    pub tilt_rad: f64,
    /// The least rise of the centre of mass on a way off the face, m; zero where it does not rest on it.
    pub barrier_m: f64,
}

impl Facet {
    /// Whether the body rests on it.
    pub fn holds(&self) -> bool {
        self.tilt_rad > 0.0
    }
}

/// All faces of a hull, about the centre of mass.
#[derive(Debug, Clone)]
pub struct Facets {
    list: Vec<Facet>,
    /// Corners of the hull from the centre of mass, in the body's axes, m.
    arms: Vec<DVec3>,
    size_m: f64,
}

impl Facets {
    /// Of a hull, for a centre of mass (m) in its frame.
    pub fn new(hull: &ConvexPolyhedron, center_of_mass: DVec3) -> Self {
        let arms: Vec<DVec3> = hull.vertices().iter().map(|&vertex| vertex - center_of_mass).collect();
        let (group_of, groups) = groups(hull);
        let size_m = hull.size();
        let mut list: Vec<Facet> = groups.iter().map(|members| begun(hull, &arms, members)).collect();
        let heights: Vec<f64> = list.iter().map(|facet| facet.height_m).collect();
        for edge in hull.edges() {
            let sides = edge.faces.map(|face| group_of[face as usize]);
            if sides[0] == sides[1] {
                continue;
            }
            let (at, along) = (arms[edge.vertices[0] as usize], edge.direction);
            let inside = [(along.cross(list[sides[0]].normal)).dot(at), (along.cross(list[sides[1]].normal)).dot(-at)];
            for (own, other) in [(0, 1), (1, 0)] {
                let facet = &mut list[sides[own]];
                facet.tilt_rad = facet.tilt_rad.min(libm::atan2(inside[own], facet.height_m));
                let to_line = at.reject_from_normalized(along).length();
                let top = if inside[other] > 0.0 { to_line } else { heights[sides[other]] };
                facet.barrier_m = facet.barrier_m.min(top - facet.height_m);
            }
        }
        for facet in &mut list {
            // A foot on an edge to rounding is held by nothing.
            if facet.tilt_rad * facet.height_m <= HUNDREDS_OF_TERMS * size_m {
                facet.tilt_rad = facet.tilt_rad.min(0.0);
            }
            facet.barrier_m = if facet.holds() { facet.barrier_m.max(0.0) } else { 0.0 };
        }
        list.sort_by(|a, b| b.holds().cmp(&a.holds()).then(b.barrier_m.total_cmp(&a.barrier_m)));
        Self { list, arms, size_m }
    }

    /// The faces: those on which the body rests first, the one that is hardest to leave before the others.
    pub fn list(&self) -> &[Facet] {
        &self.list
    }

    /// Size of the body, m.
    pub fn size_m(&self) -> f64 {
        self.size_m
    }

    /// The largest distance of a corner from the centre of mass, m.
    pub fn radius_m(&self) -> f64 {
        self.arms.iter().map(|arm| arm.length()).fold(0.0, f64::max)
    }

    /// How far the body reaches from its centre of mass in a direction, a unit vector in the body's axes, m.
    pub fn reach_m(&self, direction: DVec3) -> f64 {
        self.arms.iter().map(|arm| arm.dot(direction)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The face whose normal is nearest to a direction; none without faces.
    pub fn nearest(&self, direction: DVec3) -> Option<usize> {
        let along = |facet: &Facet| facet.normal.dot(direction);
        (0..self.list.len()).max_by(|&a, &b| along(&self.list[a]).total_cmp(&along(&self.list[b])))
    }

    /// The face that the body lies on and can no longer leave, on a plane towards `down` (a unit vector in the body's
    /// axes), when its energy lifts its centre of mass to this height (m) above the plane at most.
    ///
    /// It cannot leave the face that is nearest where the height is below every way off it, and the body can be laid
    /// down on it without rising above that height: along the arc from `down` to the face each corner stays nearer.
    pub fn held_on(&self, down: DVec3, height_m: f64) -> Option<usize> {
        let nearest = self.nearest(down)?;
        let facet = &self.list[nearest];
        let is_below = facet.holds() && height_m < facet.height_m + facet.barrier_m;
        (is_below && self.arms.iter().all(|&arm| most_along(arm, down, facet.normal) < height_m.next_up()))
            .then_some(nearest)
    }
}

/// The largest component of a vector along any direction of the shorter arc between two unit vectors.
fn most_along(arm: DVec3, from: DVec3, to: DVec3) -> f64 {
    let ends = arm.dot(from).max(arm.dot(to));
    let Some(axis) = from.cross(to).try_normalize() else { return ends };
    // Where the arm, in the plane of the arc, points between its ends, its whole length there counts.
    let flat = arm.reject_from_normalized(axis);
    let is_between = from.cross(flat).dot(axis) > 0.0 && flat.cross(to).dot(axis) > 0.0;
    if is_between { flat.length() } else { ends }
}

/// The faces of the hull that are one plane: for each face the number of its group, and the groups.
fn groups(hull: &ConvexPolyhedron) -> (Vec<usize>, Vec<Vec<usize>>) {
    let faces: Vec<_> = hull.faces().collect();
    let vertices = hull.vertices();
    let tolerance = SINGLE_PRECISION * hull.size();
    let lies_in = |face: usize, plane: usize| {
        let (normal, offset) = (faces[plane].normal, faces[plane].offset);
        faces[face].vertices.iter().all(|&vertex| (normal.dot(vertices[vertex as usize]) - offset).abs() <= tolerance)
    };
    let mut sets = DisjointSets::new(faces.len());
    for Edge { faces: [a, b], .. } in hull.edges() {
        let [a, b] = [*a as usize, *b as usize];
        if lies_in(a, b) || lies_in(b, a) {
            sets.join(a, b);
        }
    }
    let (mut group_of, mut groups) = (vec![0; faces.len()], Vec::<Vec<usize>>::new());
    for face in 0..faces.len() {
        let first = sets.smallest(face);
        if first == face {
            group_of[face] = groups.len();
            groups.push(vec![face]);
        } else {
            group_of[face] = group_of[first];
            groups[group_of[first]].push(face);
        }
    }
    (group_of, groups)
}

/// A facet of these faces whose edges have not been looked at: its plane is that of the largest.
fn begun(hull: &ConvexPolyhedron, arms: &[DVec3], members: &[usize]) -> Facet {
    let (mut area_m2, mut largest, mut normal) = (0.0, 0.0, DVec3::Z);
    let mut corners = Vec::new();
    for face in members.iter().filter_map(|&face| hull.face(face)) {
        let first = arms[face.vertices[0] as usize];
        let edges = face.vertices.windows(2).map(|pair| [arms[pair[0] as usize], arms[pair[1] as usize]]);
        let twice: DVec3 = edges.map(|[a, b]| (a - first).cross(b - first)).sum();
        let area = 0.5 * twice.length();
        area_m2 += area;
        if area > largest {
            (largest, normal) = (area, face.normal);
        }
        corners.extend_from_slice(face.vertices);
    }
    corners.sort_unstable();
    corners.dedup();
    let height_m = corners.iter().map(|&corner| normal.dot(arms[corner as usize])).fold(f64::NEG_INFINITY, f64::max);
    let (tilt_rad, barrier_m) = (f64::INFINITY, f64::INFINITY);
    Facet { normal, height_m, area_m2, corners: corners.len(), tilt_rad, barrier_m }
}

#[cfg(test)]
mod tests {
    //! Tilts, barriers and numbers of faces of solids whose statics has a closed form, in any attitude and unit.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;
    use polhode::spatial::Rotation;

    fn facets(points: &[DVec3], center: DVec3) -> Facets {
        Facets::new(&ConvexPolyhedron::from_points(points).unwrap(), center)
    }

    fn corners(size: DVec3) -> Vec<DVec3> {
        let sign = |i: u32, bit: u32| if i >> bit & 1 == 1 { 0.5 } else { -0.5 };
        (0..8).map(|i| size * DVec3::new(sign(i, 0), sign(i, 1), sign(i, 2))).collect()
    }

    /// A box of edges a, b, c on the face a x b tips at atan(min(a, b)/c), and must rise to half of a diagonal.
    #[test]
    fn a_box_rests_on_six_faces() {
        let size = DVec3::new(0.3, 0.2, 0.1);
        for scale in [1e-4, 1.0, 1e4] {
            let turn = Rotation::from_rotation_vector(DVec3::new(0.4, -1.1, 2.0));
            let (from, at) = (turn.rotate(DVec3::X), DVec3::new(3.0, 4.0, 5.0) * scale);
            let points: Vec<_> = corners(size * scale).into_iter().map(|p| turn.rotate(p) + at).collect();
            let found = facets(&points, at);
            assert_eq!(found.list().len(), 6);
            assert!(found.list().iter().all(Facet::holds));
            let broad = &found.list()[0];
            assert!((broad.tilt_rad - libm::atan2(0.2, 0.1)).abs() < 1e-12, "{broad:?}");
            assert!((broad.barrier_m / scale - (0.5 * 0.1_f64.hypot(0.2) - 0.05)).abs() < 1e-12);
            assert!((broad.area_m2 / scale / scale - 0.06).abs() < 1e-12);
            let end = found.nearest(from).unwrap();
            assert!((found.list()[end].tilt_rad - libm::atan2(0.1, 0.3)).abs() < 1e-12);
        }
    }

    /// Coordinates in single precision make no faces of their own.
    #[test]
    fn faces_of_single_precision_are_one() {
        let turn = Rotation::from_rotation_vector(DVec3::new(0.4, -1.1, 2.0));
        let rounded = |p: DVec3| (p.as_vec3()).as_dvec3();
        let points: Vec<_> = corners(DVec3::new(3.0, 2.0, 1.0)).into_iter().map(|p| rounded(turn.rotate(p))).collect();
        let found = facets(&points, DVec3::ZERO);
        assert_eq!(found.list().len(), 6);
        assert!((found.list()[0].tilt_rad - libm::atan2(2.0, 1.0)).abs() < 1e-6);
    }

    /// A slanted prism whose centre of mass lies beyond an edge does not rest on that face.
    #[test]
    fn a_face_with_the_centre_of_mass_beyond_it_holds_nothing() {
        let points: Vec<_> = corners(DVec3::ONE).into_iter().map(|p| p + DVec3::X * (2.5 * p.z)).collect();
        for (center, is_held) in [(DVec3::ZERO, false), (DVec3::new(-1.0, 0.0, -0.3), true)] {
            let found = facets(&points, center);
            let own = &found.list()[found.nearest(-DVec3::Z).unwrap()];
            assert_eq!((own.holds(), own.barrier_m > 0.0), (is_held, is_held), "{own:?}");
        }
    }

    /// What is below the barrier and near the face stays; more energy, or another attitude, may leave it.
    #[test]
    fn what_cannot_tip_is_held() {
        let found = facets(&corners(DVec3::ONE), DVec3::ZERO);
        let down = |angle: f64| DVec3::new(libm::sin(angle), 0.0, -libm::cos(angle));
        let low = 0.5_f64.hypot(0.5);
        let base = found.nearest(-DVec3::Z).unwrap();
        assert_eq!(found.held_on(down(0.1), low - 1e-9), Some(base));
        assert_eq!(found.held_on(down(0.1), low + 1e-9), None);
        // So far tilted that it stands higher than its energy allows: no such motion, and no answer.
        assert_eq!(found.held_on(down(0.7), 0.6), None);
    }
}
