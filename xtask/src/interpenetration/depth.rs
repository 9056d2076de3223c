//! How deep two convex pieces are in each other.
//!
//! The depth is the least distance that one must move by to be out of the other: the least overlap along any
//! direction, and of two polyhedra it is along a normal of a face of either or along the common perpendicular of an edge
//! of each (docs/REFERENCES.md, Gottschalk, separating axes). Directions are computed with twice the digits and rounded
//! once, so that the one that is tried is off by 1e-16 even for edges that are parallel to 1e-12; the overlap along
//! the direction tried is then a *proof*: whatever the direction is, moving by the overlap along it parts the two. Overlaps
//! are first computed plainly with a bound of their rounding, and with twice the digits only where that bound leaves
//! the question open.

use super::part::Part;
use super::wide::{height, perpendicular};
use glam::DVec3;

/// Rounding of a plain `n . (p - o)` in units of epsilon times the largest coordinate: three differences, products and
/// two sums, doubled.
const HEIGHT_ROUNDING: f64 = 16.0;

/// The depth of `a` in `b`, m, as soon as it is found to be at most `allowed`; else the least over all directions.
/// Negative when they are apart. `hint` is tried first and becomes the direction that was best.
pub(super) fn depth(a: &Part, b: &Part, allowed: f64, hint: &mut Option<DVec3>) -> f64 {
    let mut least = f64::INFINITY;
    let mut best = None;
    let boxes = a.box_overlap(b);
    if boxes <= allowed {
        return boxes;
    }
    let mut is_enough = |direction: DVec3| {
        let overlap = overlap(a, b, direction, allowed);
        if overlap < least {
            least = overlap;
            best = Some(direction);
        }
        overlap <= allowed
    };
    let found = hint.is_some_and(&mut is_enough) || [a, b].into_iter().flat_map(face_normals).any(&mut is_enough) || {
        let (of_a, of_b) = (a.edges_near(b), b.edges_near(a));
        of_a.iter()
            .flat_map(|&edge_a| of_b.iter().map(move |&edge_b| (edge_a, edge_b)))
            .filter_map(|(edge_a, edge_b)| perpendicular(edge_a, edge_b))
            .any(&mut is_enough)
    };
    if found {
        *hint = best;
    }
    least
}

fn face_normals(part: &Part) -> impl Iterator<Item = DVec3> + '_ {
    part.faces.iter().filter_map(|&[a, b, c]| perpendicular(part.ends([a, b]), part.ends([a, c])))
}

/// The smaller of the overlaps along a unit direction and against it, m.
fn overlap(a: &Part, b: &Part, direction: DVec3, allowed: f64) -> f64 {
    let origin = a.vertices[0];
    let plain = |point: DVec3| direction.dot(point - origin);
    let result = least_overlap(range(a, plain), range(b, plain));
    let reach = [a.low, a.high, b.low, b.high].into_iter().map(|corner| corner.abs().max_element()).fold(0.0, f64::max);
    if (result - allowed).abs() > HEIGHT_ROUNDING * f64::EPSILON * reach {
        return result;
    }
    let exact = |point: DVec3| height(direction, point, origin).value();
    least_overlap(range(a, exact), range(b, exact))
}

fn range(part: &Part, height: impl Fn(DVec3) -> f64) -> (f64, f64) {
    let heights = part.vertices.iter().map(|&vertex| height(vertex));
    heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), height| (low.min(height), high.max(height)))
}

fn least_overlap((a_low, a_high): (f64, f64), (b_low, b_high): (f64, f64)) -> f64 {
    (a_high - b_low).min(b_high - a_low)
}

#[cfg(test)]
mod tests {
    //! Depths that are known.
    use super::*;
    use polhode::mesh::box_mesh;
    use polhode_spatial::{Pose, Rotation};

    fn cube_at(position: DVec3, turn: DVec3) -> Part {
        let cube = box_mesh(DVec3::ONE).expect("a cube");
        Part::of_mesh(cube.mesh()).placed(&Pose::new(Rotation::from_rotation_vector(turn), position))
    }

    #[test]
    fn a_cube_in_a_cube_is_as_deep_as_the_shortest_way_out() {
        let resting = cube_at(DVec3::ZERO, DVec3::ZERO);
        let sunk = |by: f64| depth(&cube_at(DVec3::Z * (1.0 - by), DVec3::ZERO), &resting, 1e-12, &mut None);
        assert!((sunk(1e-9) - 1e-9).abs() < 1e-16);
        assert!(sunk(1e-13) <= 1e-12);
        assert_eq!(sunk(0.0), 0.0);
        let within = depth(&cube_at(DVec3::splat(0.1), DVec3::ZERO), &resting, 1e-12, &mut None);
        assert!((within - 0.9).abs() < 1e-15, "{within}");
    }

    #[test]
    fn crossed_edges_are_apart_by_their_perpendicular() {
        // Both stand on an edge, these crossed at a right angle: half a diagonal each.
        let lower = cube_at(DVec3::ZERO, DVec3::X * std::f64::consts::FRAC_PI_4);
        let at = |gap: f64| cube_at(DVec3::Z * (2.0_f64.sqrt() + gap), DVec3::Y * std::f64::consts::FRAC_PI_4);
        let of_gap = |gap: f64| depth(&at(gap), &lower, 1e-13, &mut None);
        assert!((of_gap(-1e-6) - 1e-6).abs() < 1e-15, "{}", of_gap(-1e-6));
        assert!(of_gap(1e-9) <= 1e-13);
    }

    #[test]
    fn a_triangle_cuts_a_cube_as_deep_as_its_plane_lies() {
        let triangle =
            Part::of_triangle([DVec3::new(-9.0, -9.0, 0.3), DVec3::new(9.0, -9.0, 0.3), DVec3::new(0.0, 9.0, 0.3)]);
        let found = depth(&cube_at(DVec3::ZERO, DVec3::ZERO), &triangle, 1e-12, &mut None);
        assert!((found - 0.2).abs() < 1e-15, "{found}");
    }
}
