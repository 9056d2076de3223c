//! A patch of contacts in coordinates of its own: six numbers say how its bodies move relative to each other at its
//! centre, and a matrix of six by six what impulses there do to them.
//!
//! With the centre `c` of the patch, its normal `n` and tangents `t_1`, `t_2` (world), and of each body the velocity of
//! the point at `c`,
//!
//! ```text
//! N = (n.u, t_1.w, t_2.w)      T = (t_1.u, t_2.u, n.w)            u = u_A - u_B (m/s), w = w_A - w_B (rad/s)
//! at the place (x, y) of the patch:    rate of separation  N_0 + y N_1 - x N_2
//!                                      slip                (T_0 - y T_2, T_1 + x T_2)
//! ```
//!
//! An impulse along the normal has parts in `N` alone, `(p, y p, -x p)`, and one of friction in `T` alone,
//! `(p_1, p_2, x p_2 - y p_1)`. The matrix `K = J M^-1 J^T` (1/kg, 1/(kg m), 1/(kg m^2)) has the blocks `K_NN`, `K_TT`
//! and `K_TN`: with them the points of a patch are solved one after the other without a look at the bodies, whose
//! velocities take the sum at the end. Source: algebra; the law at each point is that of single contacts.
//!
//! Assumption: the points of a patch lie in the plane of its centre. Those that are apart along the normal act with
//! their friction at the height of the point with the least separation.

use super::batch::{Batch, Blocks};
use super::body::{Gathered, Twist};
use super::lanes::{Four, Lanes, Vectors};

/// The frame of a batch's manifolds.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame<L> {
    pub(super) normal: Vectors<L>,
    pub(super) first: Vectors<L>,
    pub(super) second: Vectors<L>,
    /// From the centres of mass of A and B to the centre of the patch.
    pub(super) arm_a: Vectors<L>,
    pub(super) arm_b: Vectors<L>,
}

/// How the bodies of a patch move relative to each other, in its coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Relative<L> {
    /// `N`: along the normal, and about both tangents.
    pub(super) pressing: [L; 3],
    /// `T`: along both tangents, and about the normal.
    pub(super) slipping: [L; 3],
}

/// Impulses at a patch, in its coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wrench<L> {
    pub(super) pressing: [L; 3],
    pub(super) slipping: [L; 3],
}

impl<L: Lanes> Frame<L> {
    #[inline(always)]
    pub(super) fn load(batch: &Batch, part: usize) -> Self {
        let normal = Vectors::load(&batch.normal, part);
        let first = Vectors::load(&batch.tangent, part);
        let arm_a = Vectors::load(&batch.arm, part);
        let arm_b = arm_a + Vectors::load(&batch.between, part);
        Self { normal, first, second: normal.cross(first), arm_a, arm_b }
    }

    /// The movement of the bodies relative to each other.
    #[inline(always)]
    pub(super) fn relative(&self, a: &Twist<L>, b: &Twist<L>) -> Relative<L> {
        let u = a.linear - b.linear + a.angular.cross(self.arm_a) - b.angular.cross(self.arm_b);
        let w = a.angular - b.angular;
        Relative {
            pressing: [self.normal.dot(u), self.first.dot(w), self.second.dot(w)],
            slipping: [self.first.dot(u), self.second.dot(u), self.normal.dot(w)],
        }
    }

    /// Velocities of the bodies take impulses: A as they are, B the opposite.
    #[inline(always)]
    pub(super) fn give(&self, wrench: &Wrench<L>, a: &mut Gathered<L>, b: &mut Gathered<L>) {
        let [p, about_first, about_second] = wrench.pressing;
        let [along_first, along_second, about_normal] = wrench.slipping;
        let force = self.vector(p, along_first, along_second);
        let moment = self.vector(about_normal, about_first, about_second);
        a.take(force, self.arm_a.cross(force) + moment);
        b.give(force, self.arm_b.cross(force) + moment);
    }

    /// The same of a patch of one point, which has no moments.
    #[inline(always)]
    pub(super) fn give_at_point(&self, [n, x, y]: [L; 3], a: &mut Gathered<L>, b: &mut Gathered<L>) {
        let force = self.vector(n, x, y);
        a.take(force, self.arm_a.cross(force));
        b.give(force, self.arm_b.cross(force));
    }

    #[inline(always)]
    fn vector(&self, n: L, x: L, y: L) -> Vectors<L> {
        self.normal.times(n) + self.first.times(x) + self.second.times(y)
    }
}

impl<L: Lanes> Relative<L> {
    /// Rate of separation at a place of the patch.
    #[inline(always)]
    pub(super) fn rate(&self, [x, y]: [L; 2]) -> L {
        self.pressing[0] + y * self.pressing[1] - x * self.pressing[2]
    }

    /// Slip at a place of the patch.
    #[inline(always)]
    pub(super) fn slip(&self, [x, y]: [L; 2]) -> [L; 2] {
        [self.slipping[0] - y * self.slipping[2], self.slipping[1] + x * self.slipping[2]]
    }
}

impl<L: Lanes> Wrench<L> {
    /// No impulse.
    #[inline(always)]
    pub(super) fn none() -> Self {
        Self { pressing: [L::splat(0.0); 3], slipping: [L::splat(0.0); 3] }
    }

    /// Adds an impulse along the normal at a place. Returns its parts.
    #[inline(always)]
    pub(super) fn press(&mut self, [x, y]: [L; 2], impulse: L) -> [L; 3] {
        let parts = [impulse, y * impulse, -(x * impulse)];
        self.pressing = add(self.pressing, parts);
        parts
    }

    /// Adds an impulse of friction at a place. Returns its parts.
    #[inline(always)]
    pub(super) fn rub(&mut self, [x, y]: [L; 2], [first, second]: [L; 2]) -> [L; 3] {
        let parts = [first, second, x * second - y * first];
        self.slipping = add(self.slipping, parts);
        parts
    }
}

#[inline(always)]
pub(super) fn add<L: Lanes>(left: [L; 3], right: [L; 3]) -> [L; 3] {
    [left[0] + right[0], left[1] + right[1], left[2] + right[2]]
}

/// One of the symmetric blocks; its entries are read where they are used, since there are more than registers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block<'a> {
    entries: &'a [Four; 6],
    part: usize,
}

impl<'a> Block<'a> {
    #[inline(always)]
    pub(super) fn of(entries: &'a [Four; 6], part: usize) -> Self {
        Self { entries, part }
    }

    #[inline(always)]
    fn load<L: Lanes>(&self) -> [L; 6] {
        let [a, b, c, d, e, f] = self.entries;
        let part = self.part;
        [L::load(a, part), L::load(b, part), L::load(c, part), L::load(d, part), L::load(e, part), L::load(f, part)]
    }

    #[inline(always)]
    pub(super) fn times<L: Lanes>(&self, [x, y, z]: [L; 3]) -> [L; 3] {
        let [xx, xy, xz, yy, yz, zz] = self.load::<L>();
        [xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z]
    }

    /// `K_nn` at a place, of `K_NN`.
    #[inline(always)]
    pub(super) fn of_normal<L: Lanes>(&self, [x, y]: [L; 2]) -> L {
        let [nn, n1, n2, k11, k12, k22] = self.load::<L>();
        let once = y * n1 - x * n2;
        let twice = y * (y * k11 - x * k12) + x * (x * k22 - y * k12);
        nn + (once + once) + twice
    }

    /// `K_11`, `K_12` and `K_22` of the tangents at a place, of `K_TT`.
    #[inline(always)]
    pub(super) fn of_tangents<L: Lanes>(&self, [x, y]: [L; 2]) -> [L; 3] {
        let [k11, k12, k1n, k22, k2n, knn] = self.load::<L>();
        let (once_1, once_2) = (y * k1n, x * k2n);
        [
            k11 - (once_1 + once_1) + y * (y * knn),
            k12 + x * k1n - y * k2n - x * (y * knn),
            k22 + (once_2 + once_2) + x * (x * knn),
        ]
    }
}

/// What one body adds to the blocks.
#[derive(Debug, Clone, Copy)]
struct Rows<L> {
    /// Moments of a unit along each axis at the centre, and what they do.
    moments: [Vectors<L>; 3],
    of_moments: [Vectors<L>; 3],
    /// What units about each axis do.
    of_axes: [Vectors<L>; 3],
}

impl<L: Lanes> Rows<L> {
    #[inline(always)]
    fn of(body: &Gathered<L>, arm: Vectors<L>, [n, x, y]: [Vectors<L>; 3]) -> Self {
        let moments = [arm.cross(n), arm.cross(x), arm.cross(y)];
        let inertia = body.inverse_inertia;
        let of_moments = [inertia.times(moments[0]), inertia.times(moments[1]), inertia.times(moments[2])];
        Self { moments, of_moments, of_axes: [inertia.times(n), inertia.times(x), inertia.times(y)] }
    }
}

/// Finds the blocks of a patch of these bodies.
///
/// `K = sum J M^-1 J^T` over both bodies, with the rows `(e, r x e)` along an axis `e` at the arm `r`, and `(0, e)`
/// about it.
#[inline(always)]
pub(super) fn find_blocks<L: Lanes>(
    frame: &Frame<L>,
    (a, b): (&Gathered<L>, &Gathered<L>),
    (blocks, part): (&mut Blocks, usize),
) {
    let axes = [frame.normal, frame.first, frame.second];
    let masses = a.inverse_mass + b.inverse_mass;
    let (of_a, of_b) = (Rows::of(a, frame.arm_a, axes), Rows::of(b, frame.arm_b, axes));
    // Along an axis with along another, along with about, about with about.
    let along = |i: usize, j: usize| of_a.of_moments[i].dot(of_a.moments[j]) + of_b.of_moments[i].dot(of_b.moments[j]);
    let mixed = |i: usize, j: usize| (of_a.of_moments[i] + of_b.of_moments[i]).dot(axes[j]);
    let about = |i: usize, j: usize| (of_a.of_axes[i] + of_b.of_axes[i]).dot(axes[j]);
    let Blocks { pressing, slipping, coupling, sticking, .. } = blocks;
    store([masses + along(0, 0), mixed(0, 1), mixed(0, 2), about(1, 1), about(1, 2), about(2, 2)], pressing, part);
    let of_slip = [masses + along(1, 1), along(1, 2), mixed(1, 0), masses + along(2, 2), mixed(2, 0), about(0, 0)];
    store(of_slip, slipping, part);
    store(inverse(of_slip), sticking, part);
    store([along(1, 0), mixed(1, 1), mixed(1, 2)], &mut coupling[0], part);
    store([along(2, 0), mixed(2, 1), mixed(2, 2)], &mut coupling[1], part);
    store([mixed(0, 0), about(0, 1), about(0, 2)], &mut coupling[2], part);
}

/// The inverse of a symmetric matrix; where it has none, that of its first two diagonal entries.
#[inline(always)]
fn inverse<L: Lanes>([xx, xy, xz, yy, yz, zz]: [L; 6]) -> [L; 6] {
    let zero = L::splat(0.0);
    let [a, b, c] = [yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy];
    let determinant = xx * a + xy * b + xz * c;
    let of = |cofactor: L, diagonal: L| {
        let alone = L::pick_greater(diagonal, zero, L::splat(1.0) / diagonal, zero);
        L::pick_greater(determinant, zero, cofactor / determinant, alone)
    };
    [
        of(a, xx),
        of(b, zero),
        of(c, zero),
        of(xx * zz - xz * xz, yy),
        of(xy * xz - xx * yz, zero),
        of(xx * yy - xy * xy, zero),
    ]
}

#[inline(always)]
fn store<L: Lanes, const N: usize>(entries: [L; N], to: &mut [Four; N], part: usize) {
    for k in 0..N {
        entries[k].store(&mut to[k], part);
    }
}

/// What impulses of friction do to the rates along the normal: the transpose of `K_TN` times them.
#[inline(always)]
pub(super) fn coupled<L: Lanes>(coupling: &[[Four; 3]; 3], part: usize, [x, y, about]: [L; 3]) -> [L; 3] {
    let [first, second, turning] = coupling;
    [
        L::load(&first[0], part) * x + L::load(&second[0], part) * y + L::load(&turning[0], part) * about,
        L::load(&first[1], part) * x + L::load(&second[1], part) * y + L::load(&turning[1], part) * about,
        L::load(&first[2], part) * x + L::load(&second[2], part) * y + L::load(&turning[2], part) * about,
    ]
}

/// The place of a point in its patch.
#[inline(always)]
pub(super) fn place<L: Lanes>(at: &[Four; 2], part: usize) -> [L; 2] {
    [L::load(&at[0], part), L::load(&at[1], part)]
}
