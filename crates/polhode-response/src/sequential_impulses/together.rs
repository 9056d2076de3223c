//! The impulses along the normal at all points of a patch at once, exactly: no point comes first, so that a symmetric
//! blow turns nothing.
//!
//! With the impulses `p` (N s) of up to four points, the rates of separation `u = u_0 + K (p - p_0)` (m/s), biases `b`
//! (m/s) and compliances `g` (1/kg),
//!
//! ```text
//! p_i > 0:   u_i + b_i + g_i p_i + e K_ii (p_i - p_0i) = 0
//! p_i = 0:   u_i + b_i >= 0
//! ```
//!
//! The matrix of four points has rank three, since a rigid face has three ways to approach another: the term with `e`
//! ([`PROXIMAL_OF_POINTS`]) chooses the change of
//! least norm. So the solution is unique, and as symmetric as the patch is. It is found by principal pivoting: the set
//! of points that press is guessed, the equations of the set are solved by
//! `L D L^T`, and all points that contradict the guess change sides. Where this does not end, the first of them alone
//! changes, which ends for every matrix with positive
//! principal minors. Sources: Judice and Pires 1994 (block pivoting), Murty 1974, Golub and Van Loan 4.1,
//! docs/REFERENCES.md.
//!
//! Failure: after [`BLOCK_ROUNDS`] rounds, and as many more as there are sets of points, the last guess stands, without
//! the negative impulses.

use super::batch::PointRows;
use super::lanes::{Lanes, by_place};

/// What holds the change of impulses small, relative to the diagonal (no unit, 1e-8 to 1e-4): the square root of
/// rounding at most, so that what no motion tells apart is
/// known to half of the digits.
const PROXIMAL_OF_POINTS: f64 = 1e-6;

/// Rounds in which all points change sides that contradict their guess: nearly all end in two.
const BLOCK_ROUNDS: usize = 4;

/// The problem of a patch with `N` points, in lanes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Together<L, const N: usize> {
    /// The matrix `K` of the points, its lower triangle, 1/kg.
    pub(super) matrix: [[L; N]; N],
    /// `p_0`, N s.
    pub(super) known: [L; N],
    /// `u_0 + b + g p_0`, m/s.
    pub(super) wanted: [L; N],
    /// `g`, 1/kg.
    pub(super) give: [L; N],
    /// 1 of points that may change their impulses, else 0.
    pub(super) may: [L; N],
}

/// The line of the matrix of point `i`, up to the diagonal.
#[inline(always)]
pub(super) fn entries<L: Lanes, const N: usize>(row: &PointRows, i: usize, part: usize) -> [L; N] {
    by_place(L::splat(0.0), |j| match j {
        _ if j == i => L::load(&row.stiffness, part),
        _ if j < i => L::load(&row.with[j], part),
        _ => L::splat(0.0),
    })
}

impl<L: Lanes, const N: usize> Together<L, N> {
    #[inline(always)]
    fn entry(&self, i: usize, j: usize) -> L {
        if j <= i { self.matrix[i][j] } else { self.matrix[j][i] }
    }

    /// By how much the impulses change.
    #[inline(always)]
    pub(super) fn change(&self) -> [L; N] {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let mut presses: [L; N] = by_place(zero, |i| {
            let stiffness = self.matrix[i][i] + self.give[i];
            L::pick_greater(self.wanted[i], stiffness * self.known[i], zero, self.may[i])
        });
        let mut change = [zero; N];
        // Of the 16 sets of four points each may come once more.
        for round in 0..BLOCK_ROUNDS + 16 {
            let least = presses.iter().fold(one, |least, presses| L::pick_greater(least, *presses, *presses, least));
            let all_press = !L::any_greater(one, least);
            change = if all_press { self.of_set::<true>(&presses) } else { self.of_set::<false>(&presses) };
            let (mut differs, mut first) = (zero, one);
            for i in 0..N {
                // What contradicts the guess, as a positive number.
                let mut wrong = -(self.known[i] + change[i]);
                if !all_press {
                    let own = self.wanted[i] - self.give[i] * self.known[i];
                    let rate = (0..N).fold(own, |rate, j| rate + self.entry(i, j) * change[j]);
                    wrong = L::pick_greater(presses[i], zero, wrong, -rate);
                }
                let mut turns = L::pick_greater(wrong, zero, self.may[i], zero);
                if round >= BLOCK_ROUNDS {
                    turns = turns * first;
                    first = first - turns;
                }
                differs = differs.greater(turns);
                presses[i] = L::pick_greater(turns, zero, one - presses[i], presses[i]);
            }
            if !L::any_greater(differs, zero) {
                break;
            }
        }
        by_place(zero, |i| {
            let least = change[i].greater(-self.known[i]);
            L::pick_greater(self.may[i], zero, least, zero)
        })
    }

    /// The change of the impulses where the points of a set press: the others lose what they had. `ALL` says that all
    /// press: the same numbers, without the terms that
    /// are zero.
    #[inline(always)]
    fn of_set<const ALL: bool>(&self, presses: &[L; N]) -> [L; N] {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let lost: [L; N] =
            by_place(zero, |i| if ALL { zero } else { (one - presses[i]) * self.may[i] * self.known[i] });
        let mut x: [L; N] = by_place(zero, |i| {
            if ALL {
                return -self.wanted[i];
            }
            let right = (0..N).filter(|&j| j != i).fold(-self.wanted[i], |right, j| right + self.entry(i, j) * lost[j]);
            presses[i] * right
        });
        let mut factor = [[zero; N]; N];
        let mut inverse = [zero; N];
        for i in 0..N {
            let mut scaled = [zero; N];
            let own = self.matrix[i][i];
            // One point or two are independent.
            let proximal = if N > 2 { PROXIMAL_OF_POINTS } else { 0.0 };
            let mut pivot = own + own * L::splat(proximal) + self.give[i];
            for j in 0..i {
                let mut value = self.matrix[i][j];
                if !ALL {
                    value = presses[i] * presses[j] * value;
                }
                for k in 0..j {
                    value = value - scaled[k] * factor[j][k];
                }
                scaled[j] = value;
                factor[i][j] = value * inverse[j];
                pivot = pivot - value * factor[i][j];
            }
            // Lanes without a point have no mass.
            inverse[i] = L::pick_greater(pivot, zero, one / pivot, zero);
        }
        for i in 0..N {
            for j in 0..i {
                x[i] = x[i] - factor[i][j] * x[j];
            }
        }
        for i in (0..N).rev() {
            x[i] = x[i] * inverse[i];
            for j in i + 1..N {
                x[i] = x[i] - factor[j][i] * x[j];
            }
        }
        if ALL { x } else { by_place(zero, |i| x[i] - lost[i]) }
    }
}
