//! Numbers side by side: what one instruction does to two or four contacts at once.
//!
//! Rows are stored in fours ([`Four`]); a kernel works on them in parts of as many lanes as the type has. Every
//! operation is one of IEEE 754 on each lane for itself (no fused multiplication, no sum across lanes), so that the
//! bits are the same for every width and on every platform. Source: docs/REFERENCES.md, Catto 2024 (wide contacts).

use std::ops::{Add, Div, Mul, Neg, Sub};
use wide::f64x2;
#[cfg(not(target_arch = "wasm32"))]
use wide::f64x4;

/// How many contacts are stored side by side.
pub(super) const FOUR: usize = 4;

/// Four numbers, one for each contact of a batch.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[repr(C, align(32))]
pub(super) struct Four(pub(super) [f64; FOUR]);

/// Lanes of the width four. On WebAssembly, whose registers hold two numbers, it is two twos: the same bits, and half
/// of the code.
#[cfg(not(target_arch = "wasm32"))]
pub(super) type Fours = f64x4;
#[cfg(target_arch = "wasm32")]
pub(super) type Fours = f64x2;

/// An array whose entries are found by their places, in registers: the standard one makes a call for each entry of a
/// large kernel. `none` fills it before.
#[inline(always)]
pub(super) fn by_place<T: Copy, const N: usize>(none: T, mut of: impl FnMut(usize) -> T) -> [T; N] {
    let mut all = [none; N];
    for (place, own) in all.iter_mut().enumerate() {
        *own = of(place);
    }
    all
}

/// Numbers that one instruction computes with.
pub(super) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// How many.
    const WIDTH: usize;

    /// The same number in every lane.
    fn splat(value: f64) -> Self;

    /// The numbers of a part of a four.
    fn load(from: &Four, part: usize) -> Self;

    /// Writes them there.
    fn store(self, to: &mut Four, part: usize);

    /// One number for each lane.
    fn from_lanes(of_lane: impl Fn(usize) -> f64) -> Self;

    /// The number of a lane.
    fn lane(self, lane: usize) -> f64;

    /// Where `left > right`, the one, else the other; NaN is greater than nothing.
    fn pick_greater(left: Self, right: Self, greater: Self, otherwise: Self) -> Self;

    /// Whether `left > right` in any lane.
    fn any_greater(left: Self, right: Self) -> bool;

    /// The square root.
    fn root(self) -> Self;

    /// The greater one; of a NaN and a number the number on the left.
    fn greater(self, other: Self) -> Self {
        Self::pick_greater(other, self, other, self)
    }
}

impl Lanes for f64x2 {
    const WIDTH: usize = 2;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self::new([value, value])
    }

    #[inline(always)]
    fn load(from: &Four, part: usize) -> Self {
        if part == 0 { Self::new([from.0[0], from.0[1]]) } else { Self::new([from.0[2], from.0[3]]) }
    }

    #[inline(always)]
    fn store(self, to: &mut Four, part: usize) {
        let [x, y] = self.to_array();
        if part == 0 {
            to.0[0] = x;
            to.0[1] = y;
        } else {
            to.0[2] = x;
            to.0[3] = y;
        }
    }

    #[inline(always)]
    fn from_lanes(of_lane: impl Fn(usize) -> f64) -> Self {
        Self::new([of_lane(0), of_lane(1)])
    }

    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        self.to_array()[lane]
    }

    #[inline(always)]
    fn pick_greater(left: Self, right: Self, greater: Self, otherwise: Self) -> Self {
        left.simd_gt(right).select(greater, otherwise)
    }

    #[inline(always)]
    fn any_greater(left: Self, right: Self) -> bool {
        left.simd_gt(right).any()
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl Lanes for f64x4 {
    const WIDTH: usize = 4;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self::new([value; FOUR])
    }

    #[inline(always)]
    fn load(from: &Four, _part: usize) -> Self {
        Self::new(from.0)
    }

    #[inline(always)]
    fn store(self, to: &mut Four, _part: usize) {
        to.0 = self.to_array();
    }

    #[inline(always)]
    fn from_lanes(of_lane: impl Fn(usize) -> f64) -> Self {
        Self::new([of_lane(0), of_lane(1), of_lane(2), of_lane(3)])
    }

    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        self.to_array()[lane]
    }

    #[inline(always)]
    fn pick_greater(left: Self, right: Self, greater: Self, otherwise: Self) -> Self {
        left.simd_gt(right).select(greater, otherwise)
    }

    #[inline(always)]
    fn any_greater(left: Self, right: Self) -> bool {
        left.simd_gt(right).any()
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }
}

/// A vector in each lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Vectors<L> {
    pub(super) x: L,
    pub(super) y: L,
    pub(super) z: L,
}

impl<L: Lanes> Vectors<L> {
    #[inline(always)]
    pub(super) fn load(from: &[Four; 3], part: usize) -> Self {
        Self { x: L::load(&from[0], part), y: L::load(&from[1], part), z: L::load(&from[2], part) }
    }

    #[inline(always)]
    pub(super) fn dot(self, other: Self) -> L {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    #[inline(always)]
    pub(super) fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    #[inline(always)]
    pub(super) fn times(self, factor: L) -> Self {
        Self { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }
}

impl<L: Lanes> Add for Vectors<L> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl<L: Lanes> Sub for Vectors<L> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

/// A symmetric matrix in each lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Symmetric<L> {
    /// xx, xy, xz, yy, yz, zz.
    pub(super) entries: [L; 6],
}

impl<L: Lanes> Symmetric<L> {
    #[inline(always)]
    pub(super) fn times(self, v: Vectors<L>) -> Vectors<L> {
        let [xx, xy, xz, yy, yz, zz] = self.entries;
        Vectors {
            x: xx * v.x + xy * v.y + xz * v.z,
            y: xy * v.x + yy * v.y + yz * v.z,
            z: xz * v.x + yz * v.y + zz * v.z,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two lanes twice and four lanes at once give the same bits, NaN and signs of zero included.
    #[test]
    fn widths_agree() {
        let [x, y] = [Four([1.0, -0.0, f64::NAN, 3.0e-300]), Four([0.0, 0.0, 2.0, -7.0])];
        let wide = f64x4::load(&x, 0).greater(f64x4::load(&y, 0)).to_array().map(f64::to_bits);
        let halves = [0, 1].map(|part| f64x2::load(&x, part).greater(f64x2::load(&y, part)).to_array());
        assert_eq!(wide.to_vec(), halves.concat().into_iter().map(f64::to_bits).collect::<Vec<_>>());
    }
}
