//! Several numbers at once, one in each lane: each lane has the bits that it would have alone.
//!
//! Closed forms are chains of divisions and square roots, each of which waits for the one before. Lanes of several
//! bodies do not wait for each other, and the compiler may put two in one register. Nothing is fused and nothing is
//! reordered within a lane; a formula stands once, and one lane is the scalar case.

use std::ops::{Add, Div, Mul, Sub};

/// Numbers side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Lanes<const N: usize>(pub(crate) [f64; N]);

impl<const N: usize> Lanes<N> {
    /// The same number in all lanes.
    #[inline]
    pub(crate) const fn splat(x: f64) -> Self {
        Self([x; N])
    }

    /// From the number of each lane.
    #[inline]
    pub(crate) fn of(lane: impl FnMut(usize) -> f64) -> Self {
        Self(std::array::from_fn(lane))
    }

    #[inline]
    pub(crate) fn map(mut self, f: impl Fn(f64) -> f64) -> Self {
        for x in &mut self.0 {
            *x = f(*x);
        }
        self
    }

    #[inline]
    fn with(mut self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        for (x, y) in self.0.iter_mut().zip(other.0) {
            *x = f(*x, y);
        }
        self
    }

    #[inline]
    pub(crate) fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }

    #[inline]
    pub(crate) fn abs(self) -> Self {
        self.map(f64::abs)
    }

    #[inline]
    pub(crate) fn max(self, other: Self) -> Self {
        self.with(other, f64::max)
    }

    /// These lanes where `chosen`, those of `other` elsewhere.
    #[inline]
    pub(crate) fn where_or(mut self, chosen: [bool; N], other: Self) -> Self {
        for ((x, y), chosen) in self.0.iter_mut().zip(other.0).zip(chosen) {
            *x = if chosen { *x } else { y };
        }
        self
    }
}

macro_rules! lanewise {
    ($($operator:ident $method:ident),*) => {$(
        impl<const N: usize> $operator for Lanes<N> {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                self.with(other, $operator::$method)
            }
        }

        impl<const N: usize> $operator<f64> for Lanes<N> {
            type Output = Self;
            #[inline]
            fn $method(self, other: f64) -> Self {
                self.map(|x| $operator::$method(x, other))
            }
        }

        impl<const N: usize> $operator<Lanes<N>> for f64 {
            type Output = Lanes<N>;
            #[inline]
            fn $method(self, other: Lanes<N>) -> Lanes<N> {
                other.map(|x| $operator::$method(self, x))
            }
        }
    )*};
}

lanewise!(Add add, Sub sub, Mul mul, Div div);
