//! Weighted sums over triangles from which every mass property follows: fast, compensated, about a local point.
//!
//! For a weight w of each triangle b, c, d and `s = b + c + d` the sums are
//!
//! ```text
//! sum w,    sum w s,    sum w (s s^T + b b^T + c c^T + d d^T) .
//! ```
//!
//! The last bracket is `g g^T + h h^T + k k^T` of the sums of two corners `g = b + c`, `h = b + d`, `k = c + d`: three
//! products instead of four, none of which waits for the weight; and with the edges `e = c - b`, `f = d - b` it is
//! `g = 2 b + e`, `h = 2 b + f`, `k = g + f`, `s = b + k`.
//!
//! The sums are plain within blocks of [`BLOCK`] triangles, two lanes side by side, and compensated over the blocks:
//! their rounding errors do not grow with the size of the mesh, at nearly the cost of plain sums.

use crate::{Bounds, TriangleMesh};
use glam::{DMat3, DVec3};
use polhode_spatial::CompensatedSum;
use std::array::from_fn;
use std::ops::{Add, Sub};
use wide::f64x2;

/// Triangles that are summed side by side: what the smallest vector registers hold. A fixed number, and each lane on
/// its own: the bits do not depend on the instructions.
const LANES: usize = 2;

/// Triangles that are summed plainly, half of them in each lane: the error of a plain sum of n terms is that of a
/// random walk of n roundings, here four. Fewer would make the compensation cost more than the sums.
const BLOCK: usize = 16 * LANES;

/// Triangles that are looked at to find a point in the middle of the mesh.
const SAMPLED: usize = 1024;

/// What a triangle counts for.
#[derive(Debug, Clone, Copy)]
enum Weight {
    /// `b . (c x d)`, formed as `b . (e x f)`: for a small triangle far from the reference point the edges are exact
    /// and the products do not cancel.
    Determinant,
    /// `|e x f|`, twice its area.
    Area,
}

/// The sums, about the point that the positions were taken from.
#[derive(Debug, Clone, Copy)]
struct MomentSums {
    /// `sum w`.
    weight: f64,
    /// `sum w s`.
    first: DVec3,
    /// `sum w (s s^T + ...)`, diagonal.
    diagonal: DVec3,
    /// The same, elements yz, xz, xy.
    off_diagonal: DVec3,
}

impl MomentSums {
    /// Over the triangles of `mesh`, positions relative to `reference`.
    fn of(mesh: &TriangleMesh, reference: DVec3, weight: Weight) -> Self {
        // One copy of the loop for each weight.
        match weight {
            Weight::Determinant => Self::over_blocks(mesh, reference, Vectors::dot),
            Weight::Area => Self::over_blocks(mesh, reference, |_, n| n.dot(n).sqrt()),
        }
    }

    fn over_blocks(mesh: &TriangleMesh, reference: DVec3, weight: impl Fn(Vectors, Vectors) -> f64x2) -> Self {
        let origin = Vectors::new([reference; LANES]);
        let vertices = mesh.vertices();
        let corners = |triangle: [u32; 3]| triangle.map(|index| vertices[index as usize]);
        let mut total = [CompensatedSum::ZERO; 10];
        for block in mesh.triangles().chunks(BLOCK) {
            let mut sums = LaneSums::ZERO;
            let (pairs, last) = block.as_chunks::<LANES>();
            for &[t, u] in pairs {
                let (t, u) = (corners(t), corners(u));
                sums.add(from_fn(|corner| Vectors::new([t[corner], u[corner]])), origin, &weight);
            }
            // An odd one out is paired with a triangle that has shrunk to the reference point and counts for nothing.
            for &t in last {
                sums.add(corners(t).map(|corner| Vectors::new([corner, reference])), origin, &weight);
            }
            for (total, sum) in total.iter_mut().zip(sums.over_lanes()) {
                total.add(sum);
            }
        }
        let [w, fx, fy, fz, dx, dy, dz, ox, oy, oz] = total.map(|sum| sum.value());
        Self {
            weight: w,
            first: DVec3::new(fx, fy, fz),
            diagonal: DVec3::new(dx, dy, dz),
            off_diagonal: DVec3::new(ox, oy, oz),
        }
    }
}

/// A vector in each lane.
#[derive(Clone, Copy)]
struct Vectors {
    x: f64x2,
    y: f64x2,
    z: f64x2,
}

impl Vectors {
    #[inline]
    fn new([v, w]: [DVec3; LANES]) -> Self {
        Self { x: f64x2::new([v.x, w.x]), y: f64x2::new([v.y, w.y]), z: f64x2::new([v.z, w.z]) }
    }

    #[inline]
    fn dot(self, v: Self) -> f64x2 {
        self.x * v.x + self.y * v.y + self.z * v.z
    }

    #[inline]
    fn cross(self, v: Self) -> Self {
        Self { x: self.y * v.z - self.z * v.y, y: self.z * v.x - self.x * v.z, z: self.x * v.y - self.y * v.x }
    }
}

impl Add for Vectors {
    type Output = Self;

    #[inline]
    fn add(self, v: Self) -> Self {
        Self { x: self.x + v.x, y: self.y + v.y, z: self.z + v.z }
    }
}

impl Sub for Vectors {
    type Output = Self;

    #[inline]
    fn sub(self, v: Self) -> Self {
        Self { x: self.x - v.x, y: self.y - v.y, z: self.z - v.z }
    }
}

/// Plain sums, in the order of [`MomentSums`]; each in two lanes.
struct LaneSums([f64x2; 10]);

impl LaneSums {
    const ZERO: Self = Self([f64x2::ZERO; 10]);

    /// Adds a triangle in each lane. Vectors of a library, because arrays of plain numbers are put into vector
    /// registers by the compiler only when it reads them from memory, to which they would have to be copied first.
    #[inline]
    fn add(&mut self, [b, c, d]: [Vectors; 3], origin: Vectors, weight: impl Fn(Vectors, Vectors) -> f64x2) {
        let (e, f, b) = (c - b, d - b, b - origin);
        let w = weight(b, e.cross(f));
        let twice = b + b;
        let (g, h) = (twice + e, twice + f);
        let k = g + f;
        let s = b + k;
        let sums = &mut self.0;
        sums[0] += w;
        sums[1] += w * s.x;
        sums[2] += w * s.y;
        sums[3] += w * s.z;
        sums[4] += w * (g.x * g.x + h.x * h.x + k.x * k.x);
        sums[5] += w * (g.y * g.y + h.y * h.y + k.y * k.y);
        sums[6] += w * (g.z * g.z + h.z * h.z + k.z * k.z);
        sums[7] += w * (g.y * g.z + h.y * h.z + k.y * k.z);
        sums[8] += w * (g.x * g.z + h.x * h.z + k.x * k.z);
        sums[9] += w * (g.x * g.y + h.x * h.y + k.x * k.y);
    }

    fn over_lanes(&self) -> [f64; 10] {
        self.0.map(|sum| {
            let [a, b] = sum.to_array();
            a + b
        })
    }
}

/// What to integrate over: which weight, and what to divide the sums by.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Simplex {
    weight: Weight,
    /// `sum w / measure`.
    measure: f64,
    /// Corners of the simplex: `sum w s / (corners sum w)` is the centroid.
    corners: f64,
    /// `sum w (s s^T + ...) / int r r^T`.
    second: f64,
}

impl Simplex {
    /// The tetrahedra between the reference point and the triangles.
    pub(crate) const TETRAHEDRON: Self =
        Self { weight: Weight::Determinant, measure: 6.0, corners: 4.0, second: 120.0 };
    /// The triangles.
    pub(crate) const TRIANGLE: Self = Self { weight: Weight::Area, measure: 2.0, corners: 3.0, second: 24.0 };
}

/// Measure, centroid and second moment about it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CentralMoments {
    pub(crate) measure: f64,
    pub(crate) centroid: DVec3,
    pub(crate) second_moment: DMat3,
}

impl CentralMoments {
    /// Of the triangles of `mesh`: about a point in the middle of them first, and once more about the centroid so found
    /// where the shift to it would cancel digits.
    pub(crate) fn of(mesh: &TriangleMesh, simplex: Simplex) -> Self {
        let about = |reference: DVec3| Self::about(mesh, reference, simplex);
        let (moments, shift) = about(middle(mesh));
        // Without measure there is no centroid, and the caller refuses the mesh.
        if moments.keeps_digits_after(shift) || !moments.centroid.is_finite() {
            return moments;
        }
        about(moments.centroid).0
    }

    /// From sums about `reference`; also the centroid relative to it.
    fn about(mesh: &TriangleMesh, reference: DVec3, simplex: Simplex) -> (Self, DVec3) {
        let sums = MomentSums::of(mesh, reference, simplex.weight);
        let measure = sums.weight / simplex.measure;
        let shift = sums.first / (simplex.corners * sums.weight);
        let (mc, cross) = (measure * shift, DVec3::new(shift.y * shift.z, shift.x * shift.z, shift.x * shift.y));
        let d = sums.diagonal / simplex.second - mc * shift;
        let o = sums.off_diagonal / simplex.second - measure * cross;
        let second_moment =
            DMat3::from_cols(DVec3::new(d.x, o.z, o.y), DVec3::new(o.z, d.y, o.x), DVec3::new(o.y, o.x, d.z));
        (Self { measure, centroid: reference + shift, second_moment }, shift)
    }

    /// Whether the shift from the reference point to the centroid has cancelled no more than half of any diagonal
    /// element, so that their relative error has doubled at the most.
    fn keeps_digits_after(&self, shift: DVec3) -> bool {
        let m = &self.second_moment;
        let diagonal = DVec3::new(m.x_axis.x, m.y_axis.y, m.z_axis.z) * self.measure.signum();
        // False for NaN too.
        (self.measure.abs() * shift * shift).cmple(diagonal).all()
    }
}

/// The middle of the box around up to [`SAMPLED`] triangles, evenly chosen: as good a point as the middle of the mesh.
fn middle(mesh: &TriangleMesh) -> DVec3 {
    let step = mesh.triangles().len().div_ceil(SAMPLED).max(1);
    Bounds::of(mesh.triangles().iter().step_by(step).flat_map(|&triangle| mesh.corners(triangle))).center()
}
