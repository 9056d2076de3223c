//! Weighted sums over triangles from which every mass property follows: fast, compensated, about a local point.
//!
//! For a weight w of each triangle b, c, d and `s = b + c + d` the sums are
//!
//! ```text
//! sum w,    sum w s,    sum w (s s^T + b b^T + c c^T + d d^T) .
//! ```
//!
//! With the edges `e = c - b`, `f = d - b` and `p = e + f`, `q = e - f` the last bracket is
//! `4/3 s s^T + 1/6 p p^T + 1/2 q q^T`, and `s = 3 b + p`: fewer operations, and no products but of what is there.
//!
//! The sums are plain within blocks of [`BLOCK`] triangles, four lanes side by side, and compensated over the blocks:
//! their rounding errors do not grow with the size of the mesh, at nearly the cost of plain sums.

use crate::{Bounds, TriangleMesh};
use glam::{DMat3, DVec3};
use polhode_spatial::CompensatedSum;

/// Triangles that are summed side by side, so that the compiler can use vector instructions. A fixed number, and each
/// lane on its own: the bits do not depend on the instructions.
const LANES: usize = 4;

/// Triangles that are summed plainly, a sixteenth of that in each lane: the error of a plain sum of n terms is that of a
/// random walk of n roundings, here four. Fewer would make the compensation cost more than the sums.
const BLOCK: usize = 16 * LANES;

/// Triangles that are looked at to find a point in the middle of the mesh.
const SAMPLED: usize = 4096;

/// What a triangle counts for.
#[derive(Debug, Clone, Copy)]
enum Weight {
    /// `b . (c x d)`, formed as `b . (e x f)`: for a small triangle far from the reference point the edges are exact and
    /// the products do not cancel.
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
            Weight::Determinant => Self::over_blocks(mesh, reference, |b, n| b[0] * n[0] + b[1] * n[1] + b[2] * n[2]),
            Weight::Area => Self::over_blocks(mesh, reference, |_, n| (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt()),
        }
    }

    fn over_blocks(mesh: &TriangleMesh, reference: DVec3, weight: impl Fn([f64; 3], [f64; 3]) -> f64) -> Self {
        let mut total = [CompensatedSum::ZERO; 10];
        let mut corners = Corners::default();
        for block in mesh.triangles().chunks(BLOCK) {
            corners.gather(mesh.vertices(), block, reference);
            let mut sums = LaneSums::ZERO;
            for group in 0..block.len().div_ceil(LANES) {
                sums.add(&corners, group, reference, &weight);
            }
            for (total, sum) in total.iter_mut().zip(sums.over_lanes()) {
                total.add(sum);
            }
        }
        let [w, fx, fy, fz, dx, dy, dz, ox, oy, oz] = total.map(|sum| sum.value());
        Self {
            weight: w,
            first: DVec3::new(fx, fy, fz),
            diagonal: DVec3::new(dx, dy, dz) * (4.0 / 3.0),
            off_diagonal: DVec3::new(ox, oy, oz) * (4.0 / 3.0),
        }
    }
}

/// Coordinates of the corners of a block of triangles: for each corner its x, y and z, each of all triangles in a row.
/// Written one by one and read four at a time, which is faster than putting vectors together in registers.
struct Corners([[[f64; BLOCK]; 3]; 3]);

impl Default for Corners {
    fn default() -> Self {
        Self([[[0.0; BLOCK]; 3]; 3])
    }
}

impl Corners {
    /// Reads a block of at most [`BLOCK`] triangles. The rest of the last group is filled with triangles that have
    /// shrunk to the reference point and count for nothing.
    fn gather(&mut self, vertices: &[DVec3], block: &[[u32; 3]], reference: DVec3) {
        let mut set = |at: usize, corner: usize, v: DVec3| {
            let [x, y, z] = &mut self.0[corner];
            (x[at], y[at], z[at]) = (v.x, v.y, v.z);
        };
        for (at, triangle) in block.iter().enumerate() {
            for (corner, &index) in triangle.iter().enumerate() {
                set(at, corner, vertices[index as usize]);
            }
        }
        for at in block.len()..block.len().next_multiple_of(LANES) {
            for corner in 0..3 {
                set(at, corner, reference);
            }
        }
    }

    /// Four numbers of coordinate `axis` of corner `corner`.
    #[inline]
    fn lanes(&self, corner: usize, axis: usize, group: usize) -> Lanes {
        self.0[corner][axis].as_chunks::<LANES>().0[group]
    }
}

/// Numbers side by side.
type Lanes = [f64; LANES];

/// An expression for each lane.
macro_rules! lanes {
    ($i:ident => $value:expr) => {{
        let mut result = [0.0; LANES];
        for $i in 0..LANES {
            result[$i] = $value;
        }
        result
    }};
}

/// Plain sums, in the order of [`MomentSums`], of second moments 3/4; each in four lanes.
struct LaneSums([Lanes; 10]);

impl LaneSums {
    const ZERO: Self = Self([[0.0; LANES]; 10]);

    // Operators on vectors of lanes would read better and take four times as long.
    #[inline]
    fn add(&mut self, corners: &Corners, group: usize, reference: DVec3, weight: impl Fn([f64; 3], [f64; 3]) -> f64) {
        let at = |corner: usize, axis: usize| corners.lanes(corner, axis, group);
        let (ax, ay, az) = (at(0, 0), at(0, 1), at(0, 2));
        let (cx, cy, cz) = (at(1, 0), at(1, 1), at(1, 2));
        let (dx, dy, dz) = (at(2, 0), at(2, 1), at(2, 2));
        let (ex, ey, ez) = (lanes!(i => cx[i] - ax[i]), lanes!(i => cy[i] - ay[i]), lanes!(i => cz[i] - az[i]));
        let (fx, fy, fz) = (lanes!(i => dx[i] - ax[i]), lanes!(i => dy[i] - ay[i]), lanes!(i => dz[i] - az[i]));
        let bx = lanes!(i => ax[i] - reference.x);
        let by = lanes!(i => ay[i] - reference.y);
        let bz = lanes!(i => az[i] - reference.z);
        let nx = lanes!(i => ey[i] * fz[i] - ez[i] * fy[i]);
        let ny = lanes!(i => ez[i] * fx[i] - ex[i] * fz[i]);
        let nz = lanes!(i => ex[i] * fy[i] - ey[i] * fx[i]);
        let w = lanes!(i => weight([bx[i], by[i], bz[i]], [nx[i], ny[i], nz[i]]));
        let (px, py, pz) = (lanes!(i => ex[i] + fx[i]), lanes!(i => ey[i] + fy[i]), lanes!(i => ez[i] + fz[i]));
        let (qx, qy, qz) = (lanes!(i => ex[i] - fx[i]), lanes!(i => ey[i] - fy[i]), lanes!(i => ez[i] - fz[i]));
        let sx = lanes!(i => 3.0 * bx[i] + px[i]);
        let sy = lanes!(i => 3.0 * by[i] + py[i]);
        let sz = lanes!(i => 3.0 * bz[i] + pz[i]);
        let (wsx, wsy, wsz) = (lanes!(i => w[i] * sx[i]), lanes!(i => w[i] * sy[i]), lanes!(i => w[i] * sz[i]));
        let (wp, wq) = (lanes!(i => 0.125 * w[i]), lanes!(i => 0.375 * w[i]));
        let (wpx, wpy, wpz) = (lanes!(i => wp[i] * px[i]), lanes!(i => wp[i] * py[i]), lanes!(i => wp[i] * pz[i]));
        let (wqx, wqy, wqz) = (lanes!(i => wq[i] * qx[i]), lanes!(i => wq[i] * qy[i]), lanes!(i => wq[i] * qz[i]));
        let sums = &mut self.0;
        for i in 0..LANES {
            sums[0][i] += w[i];
            sums[1][i] += wsx[i];
            sums[2][i] += wsy[i];
            sums[3][i] += wsz[i];
            sums[4][i] += wsx[i] * sx[i] + wpx[i] * px[i] + wqx[i] * qx[i];
            sums[5][i] += wsy[i] * sy[i] + wpy[i] * py[i] + wqy[i] * qy[i];
            sums[6][i] += wsz[i] * sz[i] + wpz[i] * pz[i] + wqz[i] * qz[i];
            sums[7][i] += wsy[i] * sz[i] + wpy[i] * pz[i] + wqy[i] * qz[i];
            sums[8][i] += wsx[i] * sz[i] + wpx[i] * pz[i] + wqx[i] * qz[i];
            sums[9][i] += wsx[i] * sy[i] + wpx[i] * py[i] + wqx[i] * qy[i];
        }
    }

    /// The sums over the lanes, in pairs.
    fn over_lanes(&self) -> [f64; 10] {
        self.0.map(|[a, b, c, d]| (a + b) + (c + d))
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
