//! How deep two bodies are in each other: by how much their corners must be moved until their surfaces do not meet.
//!
//! Whether triangles meet is decided without rounding (`crossing.rs`), so that moves which part two surfaces are a
//! *proof*: whatever the moves are, the depth is at most the longest of them. Tried are every corner of one solid on
//! its own way inwards, as where bodies touch at several places in several directions, and one body as a whole, along
//! normals of the triangles that meet and along the common perpendiculars of their sides. The least move that is tried
//! need not be the least of all: the depth found is an upper bound.
//!
//! Two bodies of which one is within the other have surfaces that do not meet; that is found by their marks.

use super::crossing;
use super::surface::{Moved, Placed};
use glam::DVec3;

/// Directions that are tried, at the most.
const MOST_DIRECTIONS: usize = 64;

/// Unit vectors whose product exceeds one less this are one direction.
const ONE_DIRECTION: f64 = 1e-9;

/// Halvings of the interval that holds a depth, which begins with three times its lower end.
const HALVINGS: u32 = 24;

/// The least length found, m, by which corners are moved until two bodies do not meet, when it is more than `allowed`;
/// else zero. `hint` is the direction that parted them last, and is tried first.
pub(super) fn depth(a: &Placed<'_>, b: &Placed<'_>, allowed: f64, hint: &mut Option<DVec3>) -> f64 {
    if is_parted(a, b, allowed, hint) {
        return 0.0;
    }
    let most = 2.0 * a.surface.size.min(b.surface.size);
    let (mut low, mut high) = (allowed, 4.0 * allowed.max(f64::MIN_POSITIVE));
    while !is_parted(a, b, high, hint) {
        if high > most {
            return high;
        }
        (low, high) = (high, 4.0 * high);
    }
    for _ in 0..HALVINGS {
        let middle = low.midpoint(high);
        if is_parted(a, b, middle, hint) { high = middle } else { low = middle }
    }
    high
}

/// Whether moves of no more than `by` (m) are found that part two bodies.
fn is_parted(a: &Placed<'_>, b: &Placed<'_>, by: f64, hint: &mut Option<DVec3>) -> bool {
    let near = near_pairs(a, b, by);
    let (a, b) = (Moved::not(a), Moved::not(b));
    let is_apart = |a, b| !near.iter().any(|&pair| is_met(a, b, pair));
    let along = |direction: DVec3| is_apart(Moved { shift: by * direction, ..a }, b);
    // Surfaces that touch cost most to tell as they are: they come after those that recede.
    if hint.is_some_and(along)
        || a.placed.surface.is_solid && is_apart(Moved { inward: by, ..a }, b)
        || b.placed.surface.is_solid && is_apart(a, Moved { inward: by, ..b })
        || is_apart(a, b)
    {
        return true;
    }
    let met: Vec<[usize; 2]> = near.iter().copied().filter(|&pair| is_met(a, b, pair)).collect();
    let found = directions(a, b, &met).into_iter().find(|&direction| along(direction));
    *hint = found.or(*hint);
    found.is_some()
}

/// The triangles of two bodies that may meet when one body is moved by no more than `by`, m; of a body of points every
/// point that may be in the other body, beside the other's first triangle.
fn near_pairs(a: &Placed<'_>, b: &Placed<'_>, by: f64) -> Vec<[usize; 2]> {
    let points =
        |cloud: &Placed<'_>, of: &Placed<'_>| of.tree.bounds().map_or(Vec::new(), |bounds| cloud.tree.near(bounds, by));
    if b.surface.triangles.is_empty() {
        points(b, a).into_iter().map(|point| [0, point]).collect()
    } else if a.surface.triangles.is_empty() {
        points(a, b).into_iter().map(|point| [point, 0]).collect()
    } else {
        a.tree.near_pairs(&b.tree, by)
    }
}

/// Whether a triangle or point of A meets one of B. A point meets a solid that holds it.
fn is_met(a: Moved<'_>, b: Moved<'_>, [i, j]: [usize; 2]) -> bool {
    let is_cloud = |of: Moved<'_>| of.placed.surface.triangles.is_empty();
    match (is_cloud(a), is_cloud(b)) {
        (false, false) => crossing::meet(a.triangle(i), b.triangle(j)),
        (false, true) => a.placed.surface.is_solid && a.contains(b.point(j)) != Some(false),
        (true, false) => b.placed.surface.is_solid && b.contains(a.point(i)) != Some(false),
        (true, true) => false,
    }
}

/// Unit vectors along which A may be moved out of what it meets.
fn directions(a: Moved<'_>, b: Moved<'_>, met: &[[usize; 2]]) -> Vec<DVec3> {
    let triangle = |of: Moved<'_>, index: usize| {
        let is_there = index < of.placed.surface.triangles.len();
        is_there.then(|| of.triangle(index))
    };
    let normal = |[p, q, r]: [DVec3; 3]| (q - p).cross(r - p).normalize_or_zero();
    let pairs = || met.iter().map(|&[i, j]| (triangle(a, i), triangle(b, j)));
    let out_of_b: Vec<DVec3> = pairs().filter_map(|(_, of_b)| of_b.map(normal)).collect();
    let out_of_a: Vec<DVec3> = pairs().filter_map(|(of_a, _)| of_a.map(|corners| -normal(corners))).collect();
    let sums = [out_of_b.iter().sum::<DVec3>(), out_of_a.iter().sum::<DVec3>()].map(DVec3::normalize_or_zero);
    let normals = sums.into_iter().chain(out_of_b).chain(out_of_a);
    let edges = |[p, q, r]: [DVec3; 3]| [q - p, r - q, p - r];
    let across = pairs().filter_map(|(of_a, of_b)| Some((edges(of_a?), edges(of_b?)))).flat_map(|(of_a, of_b)| {
        of_a.into_iter().flat_map(move |u| of_b.into_iter().map(move |v| u.cross(v).normalize_or_zero()))
    });
    let mut found: Vec<DVec3> = Vec::new();
    // An open surface may be turned either way, and so may a perpendicular.
    for direction in normals.chain(across).flat_map(|n| [n, -n]) {
        let is_known = found.iter().any(|known| known.dot(direction) > 1.0 - ONE_DIRECTION);
        if direction != DVec3::ZERO && !is_known {
            found.push(direction);
        }
        if found.len() == MOST_DIRECTIONS {
            break;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    //! Depths that are known.
    use super::super::surface::Surface;
    use super::*;
    use polhode::mesh::{TriangleMesh, box_mesh};
    use polhode_spatial::{Pose, Rotation};

    fn cube() -> Surface {
        Surface::of_mesh(box_mesh(DVec3::ONE).expect("a cube").mesh())
    }

    fn at(position: DVec3, turn: DVec3) -> Pose {
        Pose::new(Rotation::from_rotation_vector(turn), position)
    }

    fn between((a, pose_a): (&Surface, Pose), (b, pose_b): (&Surface, Pose), allowed: f64) -> f64 {
        depth(&Placed::new(a, pose_a), &Placed::new(b, pose_b), allowed, &mut None)
    }

    #[test]
    fn a_cube_in_a_cube_is_as_deep_as_it_has_come() {
        let cube = cube();
        let sunk = |by: f64| {
            let above = at(DVec3::Z * (1.0 - by), DVec3::ZERO);
            between((&cube, above), (&cube, Pose::IDENTITY), 1e-12)
        };
        assert!((sunk(1e-9) - 1e-9).abs() < 1e-14, "{}", sunk(1e-9));
        assert_eq!([sunk(1e-13), sunk(0.0), sunk(-1e-15)], [0.0; 3]);
        assert!(sunk(3e-12) > 2.9e-12);
    }

    #[test]
    fn crossed_edges_are_apart_by_their_perpendicular() {
        // Both stand on an edge, these crossed at a right angle: half a diagonal each.
        let cube = cube();
        let lower = at(DVec3::ZERO, DVec3::X * std::f64::consts::FRAC_PI_4);
        let of_gap = |gap: f64| {
            let upper = at(DVec3::Z * (2.0_f64.sqrt() + gap), DVec3::Y * std::f64::consts::FRAC_PI_4);
            between((&cube, upper), (&cube, lower), 1e-13)
        };
        assert!((of_gap(-1e-6) - 1e-6).abs() < 1e-12, "{}", of_gap(-1e-6));
        assert_eq!(of_gap(1e-9), 0.0);
    }

    #[test]
    fn a_block_in_a_notch_touches_three_walls_at_once() {
        // Wider than the notch by 1e-6: no shift frees it, but receding by half of that does.
        let outline =
            [[-2.0, -1.0], [2.0, -1.0], [2.0, 1.0], [0.5, 1.0], [0.5, 0.0], [-0.5, 0.0], [-0.5, 1.0], [-2.0, 1.0]];
        let vertices = [-1.0, 1.0].iter().flat_map(|&z| outline.map(|[x, y]| DVec3::new(x, y, z))).collect();
        let inside = [[0, 5, 7], [7, 5, 6], [0, 1, 5], [5, 1, 4], [1, 2, 4], [4, 2, 3]];
        let mut triangles = Vec::new();
        for [a, b, c] in inside {
            triangles.extend([[a, c, b], [a + 8, b + 8, c + 8]]);
        }
        for corner in 0..8 {
            let next = (corner + 1) % 8;
            triangles.extend([[corner, next, next + 8], [corner, next + 8, corner + 8]]);
        }
        let notched = Surface::of_mesh(&TriangleMesh::new(vertices, triangles).expect("a mesh"));
        assert!(notched.is_solid);
        let block = |width: f64| {
            let mesh = box_mesh(DVec3::new(width, 1.0, 1.0)).expect("a box");
            let block = Surface::of_mesh(mesh.mesh());
            between((&block, Pose::from_translation(DVec3::Y * 0.5)), (&notched, Pose::IDENTITY), 1e-12)
        };
        assert_eq!([block(0.999), block(1.0), block(1.0 + 1e-12)], [0.0; 3]);
        let found = block(1.0 + 1e-6);
        assert!(found > 0.5e-6 && found < 1e-6, "{found}");
    }

    #[test]
    fn a_triangle_cuts_a_cube_as_deep_as_its_plane_lies() {
        let corners = [DVec3::new(-9.0, -9.0, 0.3), DVec3::new(9.0, -9.0, 0.3), DVec3::new(0.0, 9.0, 0.3)];
        let ground = Surface::of_mesh(&TriangleMesh::new(corners.to_vec(), vec![[0, 1, 2]]).expect("a mesh"));
        let found = between((&cube(), Pose::IDENTITY), (&ground, Pose::IDENTITY), 1e-12);
        assert!((found - 0.2).abs() < 1e-6, "{found}");
    }

    #[test]
    fn points_are_in_a_cube_or_not() {
        let cloud = |height: f64| Surface::of_points(&[DVec3::X * 9.0, DVec3::new(0.1, 0.2, height)]);
        let of_height = |height: f64| between((&cube(), Pose::IDENTITY), (&cloud(height), Pose::IDENTITY), 1e-12);
        assert_eq!([of_height(0.6), of_height(0.5), of_height(0.5 - 1e-13)], [0.0; 3]);
        assert!(of_height(0.5 - 1e-6) > 0.9e-6);
        // The side at y = 0.5 is the nearest.
        assert!(of_height(0.0) > 0.299);
    }
}
