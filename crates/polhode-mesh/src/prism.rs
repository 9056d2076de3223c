//! Prisms over a polygon, and wedges: the stones of an arch.
//!
//! A prism stands along z, half of its height on either side of the plane of its polygon. A wedge is the prism over the
//! trapezoid between two circles about the z axis, with plane faces: with inner and outer radius `r`, `R`, angle `a`
//! and width `w`
//!
//! ```text
//! V = w sin(a) (R^2 - r^2) / 2,     x = 2/3 cos(a/2) (R^3 - r^3) / (R^2 - r^2)
//! ```
//!
//! are its volume (m^3) and the distance of its centre of mass from the axis (m). Its end faces lie in planes through
//! the axis, so that wedges that are turned about it by `a` lie face on face.
//!
//! Assumption: the polygon does not touch itself. Corners on a straight edge are left out, as they are no corners of
//! the solid. Cost: the square of the number of corners, of which there may be as many as a polygon may be cut from.

use crate::SolidMesh;
use crate::polygon::{MOST_CLIPPED_CORNERS, Triangulation, triangulate};
use crate::predicates::side_of_line;
use crate::triangle_mesh::{MeshError, TriangleMesh};
use glam::{DVec2, DVec3};
use polhode_spatial::rounding;
use std::f64::consts::PI;
use thiserror::Error;

/// Why there is no prism.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum PrismError {
    /// Too few corners, or more than can be cut into triangles.
    #[error("the polygon has {0} corners: 3 to {MOST_CLIPPED_CORNERS} are accepted")]
    Corners(usize),
    /// A coordinate is NaN or infinite.
    #[error("corner {0} of the polygon is not finite (counted from 0)")]
    NotFinite(usize),
    /// Two edges meet elsewhere than at a common corner.
    #[error(
        "the polygon touches itself: its edges from corner {0} and from corner {1} meet (counted from 0); give the \
         corners in their order around it, each once"
    )]
    TouchesItself(usize, usize),
    /// All corners lie on a line.
    #[error("the corners of the polygon lie on a line")]
    Flat,
    /// The height is not positive and finite.
    #[error("a height must be positive and finite, found {0} m")]
    Height(f64),
    /// The radii are not positive and finite, or the outer one is not the larger.
    #[error("a wedge needs 0 < inner radius < outer radius, finite, found {inner} and {outer} m")]
    Radii {
        /// Inner radius, m.
        inner: f64,
        /// Outer radius, m.
        outer: f64,
    },
    /// The angle is not that of a wedge.
    #[error("the angle of a wedge must be above 0 and below pi, found {0} rad")]
    Angle(f64),
    /// The solid is flat to rounding.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// The prism along z over a polygon (m) in either direction round, from `-height / 2` to `height / 2`.
///
/// ```
/// use polhode_mesh::prism;
/// let triangle = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(Into::into);
/// assert_eq!(prism(&triangle, 2.0)?.volume_integrals().volume, 1.0);
/// # Ok::<(), polhode_mesh::PrismError>(())
/// ```
///
/// # Errors
/// As [`PrismError`].
pub fn prism(polygon: &[DVec2], height: f64) -> Result<SolidMesh, PrismError> {
    if !(height > 0.0 && height.is_finite()) {
        return Err(PrismError::Height(height));
    }
    let corners = corners(polygon)?;
    let count = corners.len();
    let at = |level: f64| corners.iter().map(move |corner| corner.extend(level * height));
    let vertices: Vec<DVec3> = at(-0.5).chain(at(0.5)).collect();
    let cap: Vec<[usize; 3]> = match triangulate(&vertices[count..]) {
        Triangulation::Fan => (2..count).map(|k| [0, k - 1, k]).collect(),
        Triangulation::Ears(ears) => ears,
        Triangulation::TooLarge => return Err(PrismError::Corners(count)),
    };
    let sides = (0..count).flat_map(|k| {
        let next = (k + 1) % count;
        [[k, next, next + count], [k, next + count, k + count]]
    });
    let caps = cap.iter().flat_map(|&[a, b, c]| [[a, c, b], [a + count, b + count, c + count]]);
    // There are at most a few thousand corners.
    let triangles = caps.chain(sides).map(|triangle| triangle.map(|corner| corner as u32)).collect();
    Ok(SolidMesh::new(TriangleMesh::new(vertices, triangles)?)?)
}

/// A wedge about the z axis, its middle towards +x: of these inner and outer radii (m), this angle between its end
/// faces (rad, below pi), and this width along z (m).
///
/// # Errors
/// As [`PrismError`].
pub fn wedge(inner: f64, outer: f64, angle: f64, width: f64) -> Result<SolidMesh, PrismError> {
    if !(inner > 0.0 && outer > inner && outer.is_finite()) {
        return Err(PrismError::Radii { inner, outer });
    }
    if !(angle > 0.0 && angle < PI) {
        return Err(PrismError::Angle(angle));
    }
    let (sin, cos) = (libm::sin(0.5 * angle), libm::cos(0.5 * angle));
    let [low, high] = [DVec2::new(cos, -sin), DVec2::new(cos, sin)];
    prism(&[low * inner, low * outer, high * outer, high * inner], width)
}

/// The corners anticlockwise, without those on straight edges.
fn corners(polygon: &[DVec2]) -> Result<Vec<DVec2>, PrismError> {
    let count = polygon.len();
    if !(3..=MOST_CLIPPED_CORNERS).contains(&count) {
        return Err(PrismError::Corners(count));
    }
    if let Some(corner) = polygon.iter().position(|corner| !corner.is_finite()) {
        return Err(PrismError::NotFinite(corner));
    }
    let first = polygon[0];
    let edges = polygon.windows(2).map(|pair| (pair[0] - first).perp_dot(pair[1] - first));
    let twice_area: f64 = edges.sum();
    let extent = polygon.iter().fold(0.0_f64, |most, corner| most.max((*corner - first).length()));
    if twice_area.abs() <= rounding::HUNDREDS_OF_TERMS * extent * extent {
        return Err(PrismError::Flat);
    }
    if let Some([a, b]) = touching(polygon) {
        return Err(PrismError::TouchesItself(a, b));
    }
    let is_corner = |&k: &usize| {
        let [before, own, after] = [k + count - 1, k, k + 1].map(|k| polygon[k % count]);
        let (into, out) = (own - before, after - own);
        into.perp_dot(out).abs() > rounding::DOZENS_OF_TERMS * into.length() * out.length()
    };
    let mut corners: Vec<DVec2> = (0..count).filter(is_corner).map(|k| polygon[k]).collect();
    if corners.len() < 3 {
        return Err(PrismError::Flat);
    }
    if twice_area < 0.0 {
        corners.reverse();
    }
    Ok(corners)
}

/// Two edges, by their first corners, that meet elsewhere than where one goes on into the other.
fn touching(polygon: &[DVec2]) -> Option<[usize; 2]> {
    let count = polygon.len();
    let edge = |k: usize| [polygon[k], polygon[(k + 1) % count]];
    for a in 0..count {
        let [from, to] = edge(a);
        if from == to {
            return Some([a, (a + 1) % count]);
        }
        // The next edge begins where this one ends: it must not turn back along it.
        let [_, beyond] = edge((a + 1) % count);
        let turns_back = side_of_line(from, to, beyond) == 0.0 && (to - from).dot(beyond - to) < 0.0;
        if turns_back {
            return Some([a, (a + 1) % count]);
        }
        let is_apart = |b: &usize| *b != a && (*b + 1) % count != a && (a + 1) % count != *b;
        if let Some(b) = (a + 1..count).filter(is_apart).find(|&b| meet(edge(a), edge(b))) {
            return Some([a, b]);
        }
    }
    None
}

/// Whether two segments have a point in common.
fn meet([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
    let side = |from: DVec2, to: DVec2, point: DVec2| side_of_line(from, to, point);
    let sides = [side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b)];
    if sides == [0.0; 4] {
        // On one line: their ranges overlap.
        let overlap = |i: usize| a[i].max(b[i]) >= c[i].min(d[i]) && c[i].max(d[i]) >= a[i].min(b[i]);
        return overlap(0) && overlap(1);
    }
    let is_between = |one: f64, other: f64| one == 0.0 || other == 0.0 || (one > 0.0) != (other > 0.0);
    is_between(sides[0], sides[1]) && is_between(sides[2], sides[3])
}

#[cfg(test)]
mod tests {
    //! Volumes, centres and moments are the closed forms; polygons that are none are told.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;
    use crate::{Density, solid_mass_properties};

    fn polygon(corners: &[[f64; 2]]) -> Vec<DVec2> {
        corners.iter().map(|&own| DVec2::from_array(own)).collect()
    }

    /// The formulas at the head of this file.
    #[test]
    fn a_wedge_has_the_mass_of_its_closed_form() {
        for (inner, outer, angle, width) in [(0.9, 1.1, 0.157, 0.3), (0.1, 2.0, 2.5, 1.0), (10.0, 10.1, 0.01, 5.0)] {
            let solid = wedge(inner, outer, angle, width).unwrap();
            let found = solid_mass_properties(&solid, Density::new(1.0).unwrap()).unwrap();
            let (r2, r3) = (outer * outer - inner * inner, outer.powi(3) - inner.powi(3));
            let volume = 0.5 * width * libm::sin(angle) * r2;
            let x = 2.0 / 3.0 * libm::cos(0.5 * angle) * r3 / r2;
            assert!((found.mass() / volume - 1.0).abs() < 1e-13, "{} {volume}", found.mass());
            assert!((found.center_of_mass() - DVec3::X * x).length() < 1e-13 * outer, "{}", found.center_of_mass());
        }
    }

    /// An L is three squares, whichever way round it is given, with corners on its edges or without.
    #[test]
    fn a_prism_need_not_be_convex() {
        let mut corners =
            polygon(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]]);
        for _ in 0..2 {
            let solid = prism(&corners, 0.5).unwrap();
            assert_eq!(solid.volume_integrals().volume, 1.5);
            assert_eq!(solid.mesh().vertices().len(), 12);
            corners.reverse();
        }
        let found = solid_mass_properties(&prism(&corners, 0.5).unwrap(), Density::new(2.0).unwrap()).unwrap();
        let center = DVec3::new(5.0 / 6.0, 5.0 / 6.0, 0.0);
        assert!((found.center_of_mass() - center).length() < 1e-15);
        // Per mass about the axis through the corner: three squares of side 1 with their centres.
        let about = (0.5 + 2.5 + 2.5) / 3.0 + 1.0 / 6.0 - center.length_squared();
        assert!((found.inertia().matrix().z_axis.z - 3.0 * about).abs() < 1e-14);
    }

    #[test]
    fn what_is_no_polygon_is_told() {
        let refused = |corners: &[[f64; 2]]| prism(&polygon(corners), 1.0).unwrap_err();
        assert_eq!(refused(&[[0.0, 0.0], [1.0, 0.0]]), PrismError::Corners(2));
        assert_eq!(refused(&[[0.0, 0.0], [1.0, f64::NAN], [1.0, 1.0]]), PrismError::NotFinite(1));
        assert_eq!(refused(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [3.0, 3.0]]), PrismError::Flat);
        // Crossed, twice through one point, back along itself, and one corner twice.
        assert_eq!(refused(&[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 1.0]]), PrismError::TouchesItself(0, 2));
        let bow = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]];
        assert!(matches!(refused(&bow), PrismError::TouchesItself(..)));
        let spike = [[0.0, 0.0], [1.0, 0.0], [3.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
        assert!(matches!(refused(&spike), PrismError::TouchesItself(..)));
        let twice = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        assert!(matches!(refused(&twice), PrismError::TouchesItself(..)));
        assert!(matches!(prism(&polygon(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]), 0.0), Err(PrismError::Height(_))));
        assert!(matches!(wedge(1.0, 1.0, 0.1, 1.0), Err(PrismError::Radii { .. })));
        assert!(matches!(wedge(1.0, 2.0, 3.2, 1.0), Err(PrismError::Angle(_))));
    }
}
