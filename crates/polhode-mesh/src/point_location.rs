//! Whether a point lies inside a solid, on its surface or outside, exactly.
//!
//! The winding number of a closed surface around a point is the number of triangles that a ray from the point leaves
//! through, less those that it enters through. The ray runs along +z. Which triangles it meets and whether they lie
//! above the point is decided by the exact signs of determinants (docs/REFERENCES.md, Shewchuk 1997), so the answer is
//! that of exact arithmetic on the coordinates in memory. A ray through an edge or a vertex is moved sideways by (e,
//! e^2) for an infinitely small e (docs/REFERENCES.md, Edelsbrunner and Muecke 1990), which only breaks ties; a point
//! in a triangle is on the surface, and is found before.
//!
//! The number is 1 in the material, 0 outside and in voids, and above 1 where parts of a mesh overlap. Time of a query:
//! about the logarithm of the number of triangles (a tree of bounding boxes).

use crate::predicates::{drop_axis, side_of_line, side_of_plane, unit_scale};
use crate::triangle_tree::TriangleTree;
use crate::{SolidMesh, TriangleMesh};
use glam::{DVec2, DVec3};

/// Where a point lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PointLocation {
    /// In the material.
    Inside,
    /// In a triangle of the surface, exactly.
    OnSurface,
    /// In none of them: outside the solid or in one of its voids.
    Outside,
}

/// Answers where points lie in one solid.
///
/// ```
/// use polhode_mesh::{DVec3, PointLocation, PointLocator, box_mesh};
/// let locator = PointLocator::new(&box_mesh(DVec3::ONE)?);
/// assert_eq!(locator.locate(DVec3::ZERO), PointLocation::Inside);
/// assert_eq!(locator.locate(DVec3::X * 0.5), PointLocation::OnSurface);
/// assert_eq!(locator.locate(DVec3::X), PointLocation::Outside);
/// # Ok::<(), polhode_mesh::PrimitiveError>(())
/// ```
#[derive(Debug, Clone)]
pub struct PointLocator {
    tree: TriangleTree,
    scale: f64,
}

impl PointLocator {
    /// For a solid.
    pub fn new(solid: &SolidMesh) -> Self {
        let scale = unit_scale(solid.mesh().bounds().largest_coordinate());
        let triangles = |mesh: &TriangleMesh| mesh.corner_positions().map(|t| t.map(|corner| corner * scale)).collect();
        Self { tree: TriangleTree::new(triangles(solid.mesh())), scale }
    }

    /// Where `point` (m) lies. A point that is not finite is outside.
    pub fn locate(&self, point: DVec3) -> PointLocation {
        match self.winding_number(point) {
            None => PointLocation::OnSurface,
            Some(0) => PointLocation::Outside,
            Some(_) => PointLocation::Inside,
        }
    }

    /// Whether `point` (m) lies inside or on the surface.
    pub fn contains(&self, point: DVec3) -> bool {
        self.locate(point) != PointLocation::Outside
    }

    /// How often the surface winds around `point` (m), or none for a point on the surface.
    pub fn winding_number(&self, point: DVec3) -> Option<i32> {
        if !point.is_finite() {
            return Some(0);
        }
        let point = point * self.scale;
        let mut winding = 0;
        for &triangle in self.tree.above(point) {
            winding += crossing(triangle, point)?;
        }
        Some(winding)
    }
}

/// +1 when the ray from `point` along +z leaves through the triangle, -1 when it enters, 0 when it misses it, none when
/// the point lies in the triangle.
fn crossing(triangle: [DVec3; 3], point: DVec3) -> Option<i32> {
    let [a, b, c] = triangle;
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    let is_beside = point.x < low.x || point.x > high.x || point.y < low.y || point.y > high.y;
    if is_beside || point.z > high.z {
        return Some(0);
    }
    // Above everything below: whatever lies wholly above the point needs no third determinant.
    let side = if point.z < low.z { None } else { Some(side_of_plane(triangle, point)) };
    if side == Some(0.0) && is_within(triangle, point) {
        return None;
    }
    let [p, q, r] = triangle.map(DVec3::truncate);
    let at = point.truncate();
    let first = tie_broken_side(p, q, at);
    if first == 0.0 || first != tie_broken_side(q, r, at) || first != tie_broken_side(r, p, at) {
        return Some(0);
    }
    // Anticlockwise from above: the outward normal points up, and the point is below when it is behind.
    let is_above_point = side.is_none_or(|side| side * first < 0.0);
    Some(if is_above_point { first as i32 } else { 0 })
}

/// Sign (+1 or -1) of the side of the line from a to b that `point`, moved by (e, e^2), lies on; 0 when a = b.
fn tie_broken_side(a: DVec2, b: DVec2, point: DVec2) -> f64 {
    let sign = |x: f64| if x == 0.0 { 0.0 } else { x.signum() };
    // The side of a moved point grows by e (a.y - b.y) + e^2 (b.x - a.x).
    [side_of_line(a, b, point), a.y - b.y, b.x - a.x].into_iter().map(sign).find(|&s| s != 0.0).unwrap_or(0.0)
}

/// Whether a point in the plane of a triangle lies in it or on its border: it does in every projection along an axis.
/// A degenerate triangle holds no points; its neighbours hold those of its edges.
fn is_within(triangle: [DVec3; 3], point: DVec3) -> bool {
    let mut has_area = false;
    for axis in 0..3 {
        let [a, b, c] = triangle.map(|corner| drop_axis(corner, axis));
        let at = drop_axis(point, axis);
        if side_of_line(a, b, c) == 0.0 {
            continue;
        }
        has_area = true;
        let sides = [side_of_line(a, b, at), side_of_line(b, c, at), side_of_line(c, a, at)];
        if sides.iter().any(|&side| side > 0.0) && sides.iter().any(|&side| side < 0.0) {
            return false;
        }
    }
    has_area
}
