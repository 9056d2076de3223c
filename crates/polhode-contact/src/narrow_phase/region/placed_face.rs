//! The corners of a face of a polyhedron, classified as inside or outside the sides of another face.
//!
//! For faces with many vertices two circles about the middle of a face, in its plane, decide most cases. A point inside
//! the inscribed circle is inside all sides; a line outside the circumscribed circle crosses no edge. Only corners and
//! edges near the border of the other face are compared with its sides one by one.

use crate::clearance::SIEVE_SLACK;
use crate::shape::polyhedron::Face;
use glam::DVec3;

/// A corner is deep inside the other face when it is inside every side by this many tolerances. Then the edge between
/// two such corners crosses nothing, and no vertex of the other face coincides with the corner.
pub(super) const DEEP_PLACES: f64 = 16.0;

/// A face of each body in A's frame, with the classification of their corners.
#[derive(Debug, Clone, Default)]
pub(crate) struct FacePairBuffers {
    pub(super) a: PlacedFace,
    pub(super) b: PlacedFace,
    /// Corners of B's face that may coincide with one of A's.
    pub(super) near: Vec<usize>,
    /// By how much the distances from the sides and the plane of A's face and of B's may change before the set of
    /// contacts changes, m; not positive when that is not known.
    pub(crate) clearances: [f64; 2],
}

/// Corners and outward sides of a face.
#[derive(Debug, Clone, Default)]
pub(super) struct PlacedFace {
    pub(super) corners: Vec<DVec3>,
    pub(super) sides: Vec<DVec3>,
    /// Whether each corner is far inside every side of the other face.
    pub(super) deep: Vec<bool>,
    /// Whether each corner is a contact: outside no side of the other face.
    pub(super) kept: Vec<bool>,
    /// Whether each side may be crossed by one of the other face.
    pub(super) crossable: Vec<bool>,
    /// 1 where a corner is clearly outside a side of the other face, -1 where clearly inside; corner after corner.
    pub(super) signs: Vec<i8>,
}

impl PlacedFace {
    /// The vertices of the face that are contacts, with their places.
    #[inline]
    pub(super) fn contacts<'a>(&'a self, face: &'a Face<'_>) -> impl Iterator<Item = (u32, DVec3)> + 'a {
        let corners = face.vertices.iter().zip(&self.corners).zip(&self.kept);
        corners.filter(|(_, kept)| **kept).map(|((&vertex, &corner), _)| (vertex, corner))
    }

    /// Distance of a point outside a side, m.
    pub(super) fn outside(&self, point: DVec3, side: usize) -> f64 {
        self.sides[side].dot(point - self.corners[side])
    }

    /// Finds the corners that are deep inside and the sides that cross nothing by circles about the middle of the other
    /// face, whose unit normal is given.
    pub(super) fn classify_by_circles(&mut self, other: &Self, normal: DVec3, tolerance: f64) {
        let (corners, sides) = (self.corners.len(), other.corners.len());
        self.deep.clear();
        self.crossable.clear();
        let margin = DEEP_PLACES * tolerance;
        let middle = other.corners.iter().sum::<DVec3>() / sides as f64;
        let inner = (0..sides).map(|j| -other.outside(middle, j)).fold(f64::INFINITY, f64::min) - margin;
        let outer = other.corners.iter().map(|c| c.distance_squared(middle)).fold(0.0, f64::max).sqrt() + margin;
        let far_inside = |corner: &DVec3| {
            let between = *corner - middle;
            let above = normal.dot(between);
            let square = between.length_squared();
            inner > 0.0 && square - above * above < inner * inner - SIEVE_SLACK * (square + inner * inner)
        };
        self.deep.extend(self.corners.iter().map(far_inside));
        for i in 0..corners {
            let between_deep = self.deep[i] && self.deep[following(i, corners)];
            let beyond = self.outside(middle, i).abs() > outer * (1.0 + SIEVE_SLACK);
            self.crossable.push(!(between_deep || beyond));
        }
    }

    /// Computes the sign of every corner against every side of the other face, and which corners are contacts. Returns
    /// the least distance of a corner from a side, m.
    pub(super) fn classify_by_signs(&mut self, other: &Self, tolerance: f64) -> f64 {
        let (corners, sides) = (self.corners.len(), other.corners.len());
        self.deep.clear();
        self.deep.resize(corners, false);
        self.kept.clear();
        self.kept.resize(corners, true);
        self.signs.clear();
        self.signs.resize(corners * sides, 0);
        let mut least = f64::INFINITY;
        let rows = self.signs.chunks_exact_mut(sides);
        for ((corner, kept), row) in self.corners.iter().zip(&mut self.kept).zip(rows) {
            for ((from, side), sign) in other.corners.iter().zip(&other.sides).zip(row) {
                let distance = side.dot(*corner - *from);
                let outside = distance > tolerance;
                *sign = if outside { 1 } else { -i8::from(distance < -tolerance) };
                *kept &= !outside;
                least = if distance.abs() < least { distance.abs() } else { least };
            }
        }
        least
    }

    /// Finds the corners that are contacts.
    pub(super) fn keep_inside(&mut self, other: &Self, tolerance: f64) {
        let sides = other.corners.len();
        self.kept.clear();
        // The side that excludes one corner often excludes the next.
        let mut last = 0;
        for (&corner, &deep) in self.corners.iter().zip(&self.deep) {
            let inside = |j: usize| other.outside(corner, j) <= tolerance;
            let excluded_by = if deep {
                None
            } else if inside(last) {
                (0..sides).find(|&j| !inside(j))
            } else {
                Some(last)
            };
            last = excluded_by.unwrap_or(last);
            self.kept.push(excluded_by.is_none());
        }
    }
}

/// The corner after a corner of a loop.
pub(super) fn following(corner: usize, count: usize) -> usize {
    if corner + 1 == count { 0 } else { corner + 1 }
}
