//! Where blocks bear on each other: corners of the regions in which a face of one meets the other.
//!
//! A face bears a block if all of the block is above its plane and some of it is in the plane: a corner, an edge or a
//! face. What of this lies over the face is found by cutting it with the planes through the sides of the face
//! one after the other. Where two edges meet, a face of each block bears the other one, so that the forces
//! between them may have every direction between the two normals. Edges that cross bear nothing here: no structure that
//! is judged has them.

use super::block::{Block, normal_of};
use glam::DVec3;

/// A point at which one block pushes another.
#[derive(Debug, Clone, Copy)]
pub(super) struct ContactPoint {
    /// The block that is pushed along the normal.
    pub(super) pushed: usize,
    /// The block whose face bears it.
    pub(super) bearer: usize,
    /// Where, m.
    pub(super) point: DVec3,
    /// Outward unit normal of the face.
    pub(super) normal: DVec3,
}

/// Heights up to this fraction of the size of the blocks are none: above the rounding of the places at which blocks are
/// set (1e-15), below any gap that is meant (1e-3).
const TOUCHING: f64 = 1e-9;

/// Normals are opposite when their sum is shorter than this, rad.
const OPPOSITE: f64 = 1e-9;

/// All points at which some blocks bear each other, where at least one of the two moves.
pub(super) fn contact_points(blocks: &[Block]) -> Vec<ContactPoint> {
    let mut points = Vec::new();
    for (second, b) in blocks.iter().enumerate() {
        for (first, a) in blocks.iter().enumerate().take(second) {
            let reach = a.radius() + b.radius();
            let near = (a.center - b.center).length() <= reach * (1.0 + TOUCHING);
            if near && (a.mass_kg.is_some() || b.mass_kg.is_some()) {
                between([(first, a), (second, b)], &mut points);
            }
        }
    }
    points
}

fn between(pair: [(usize, &Block); 2], points: &mut Vec<ContactPoint>) {
    let first = points.len();
    // The size of the smaller: that of a floor is no measure.
    let tolerance = TOUCHING * pair[0].1.radius().min(pair[1].1.radius());
    for [(bearer, below), (pushed, above)] in [pair, [pair[1], pair[0]]] {
        for face in &below.faces {
            let polygon = below.loop_of(face);
            let normal = normal_of(&polygon);
            // Two faces that lie on each other are one region.
            let known = |point: &ContactPoint| point.pushed == bearer && (point.normal + normal).length() <= OPPOSITE;
            if points[first..].iter().any(known) {
                continue;
            }
            for point in borne(&polygon, normal, above, tolerance) {
                points.push(ContactPoint { pushed, bearer, point, normal });
            }
        }
    }
}

/// Corners of the region in which a block rests on a face; none if it does not touch or is not wholly above.
fn borne(face: &[DVec3], normal: DVec3, block: &Block, tolerance: f64) -> Vec<DVec3> {
    let Some(&corner) = face.first() else { return Vec::new() };
    let height = |place: DVec3| normal.dot(place - corner);
    let lowest = block.corners.iter().map(|&place| height(place)).fold(f64::INFINITY, f64::min);
    if lowest.abs() > tolerance {
        return Vec::new();
    }
    let is_low = |corner: &usize| block.corners.get(*corner).is_some_and(|&place| height(place) <= tolerance);
    // The corners in the plane in the order of the face that has most of them.
    let of_faces = block.faces.iter().map(|face| face.iter().copied().filter(is_low).collect::<Vec<usize>>());
    let low = of_faces.max_by_key(Vec::len).unwrap_or_default();
    let mut region = block.loop_of(&low);
    for (&from, &to) in face.iter().zip(face.iter().cycle().skip(1)) {
        let outward = (to - from).cross(normal).normalize_or_zero();
        region = cut(&region, |place| outward.dot(place - from), tolerance);
    }
    let mut distinct: Vec<DVec3> = Vec::new();
    for place in region {
        if distinct.iter().all(|other| (*other - place).length() > 2.0 * tolerance) {
            distinct.push(place);
        }
    }
    distinct
}

/// What of a polygon is at most `tolerance` outside of a plane.
fn cut(polygon: &[DVec3], outside: impl Fn(DVec3) -> f64, tolerance: f64) -> Vec<DVec3> {
    let mut kept = Vec::new();
    for (&from, &to) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let [start, end] = [from, to].map(&outside);
        if start <= tolerance {
            kept.push(from);
        }
        if (start <= tolerance) != (end <= tolerance) {
            kept.push(from + (to - from) * (start / (start - end)).clamp(0.0, 1.0));
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    //! Regions between boxes whose corners are known.
    use super::*;
    use std::f64::consts::FRAC_PI_4;

    fn upright(center: DVec3, edges: DVec3) -> Block {
        Block::cuboid(center, edges, [DVec3::X, DVec3::Y, DVec3::Z], Some(1.0))
    }

    #[test]
    fn brick_across_a_brick_rests_on_the_overlap() {
        let below = upright(DVec3::ZERO, DVec3::new(2.0, 1.0, 1.0));
        let above = upright(DVec3::new(1.0, 0.0, 1.0), DVec3::new(1.0, 3.0, 1.0));
        let points = contact_points(&[below, above]);
        assert_eq!(points.len(), 4);
        for point in &points {
            assert!((point.normal.z.abs() - 1.0).abs() < 1e-15);
            assert!((0.5..=1.0).contains(&point.point.x) && point.point.y.abs() == 0.5 && point.point.z == 0.5);
        }
    }

    #[test]
    fn cards_that_lean_edge_on_edge_are_borne_by_a_face_of_each() {
        let (c, s) = (libm::cos(FRAC_PI_4 / 2.0), libm::sin(FRAC_PI_4 / 2.0));
        let edges = DVec3::new(0.1, 1.0, 2.0);
        let card = |side: f64| {
            let (x, z) = (DVec3::new(c, 0.0, side * s), DVec3::new(-side * s, 0.0, c));
            // The upper inner edge is at the origin.
            let inner = x * (-side * 0.05) + z;
            Block::cuboid(-inner, edges, [x, DVec3::Y, z], Some(1.0))
        };
        let points = contact_points(&[card(-1.0), card(1.0)]);
        assert_eq!(points.len(), 4);
        for point in &points {
            assert!(point.point.reject_from(DVec3::Y).length() < 1e-9);
            assert!((point.normal.x.abs() - c).abs() < 1e-12, "{point:?}");
        }
    }
}
