//! Joints in batches of four, side by side in memory, and what the lanes do with them.
//!
//! Joints of one colour, of one law and with as many rows are a batch; lanes without one are of the immovable body 0
//! and of no effect. For each lane, with the rows `J` (force `f` on A, `-f` on B, moments `m_A`, `m_B`), their gaps `g`
//! (m), and the softness `a`, `b`, `c`,
//!
//! ```text
//! u = f.(v_A - v_B) + m_A.w_A + m_B.w_B           m/s
//! K = L D L^T                                     1/kg; a pivot that is rounding has the inverse zero
//! l <- l - a K^-1 (u + b g) - c l                 N s
//! ```
//!
//! Every number of rows has a kernel of its own. Sources: Golub and Van Loan 4.1 (the factors), Catto 2024 (soft
//! constraints, lanes), docs/REFERENCES.md.

use super::body::{Gathered, ImpulseBody, Twist};
use super::joint::{JointLaw, JointRow};
use super::lanes::{FOUR, Four, Lanes, Vectors};
use super::sweep::{Softness, SweepRule};
use super::works::numbers;
use crate::law::MOST_ROWS;
use crate::tolerances::TRUSTED_PIVOT;

/// One row of each of four joints.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct LaneRow {
    force: [Four; 3],
    moments: [[Four; 3]; 2],
    gap: Four,
    /// Of the present substep, N s.
    pub(super) multiplier: Four,
    /// Of the factors: `L` before the diagonal, on it the inverse of `D`.
    factor: [Four; MOST_ROWS],
}

/// What four joints give: the impulse on A (N s), its opposite on B, and the moments about the centres of mass (N m s).
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct LaneImpulse {
    pub(super) force: [Four; 3],
    pub(super) moments: [[Four; 3]; 2],
}

/// Four joints of one colour.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct JointBatch {
    pub(super) a: [u32; FOUR],
    pub(super) b: [u32; FOUR],
    pub(super) law: JointLaw,
    /// Whether its joints are those of trees (`joint_trees`).
    pub(super) in_tree: bool,
    /// Where its rows begin, and how many there are.
    pub(super) first: u32,
    pub(super) count: u32,
    /// In the present substep, and in the whole step.
    pub(super) given: LaneImpulse,
    pub(super) total: LaneImpulse,
}

/// A batch with its rows.
pub(super) type Rows<'a> = (&'a mut JointBatch, &'a mut [LaneRow]);

impl LaneRow {
    /// Takes the row of a joint in a lane, but for its multiplier.
    pub(super) fn put(&mut self, lane: usize, row: &JointRow) {
        put(&mut self.force, lane, row.force.to_array());
        put(&mut self.moments[0], lane, row.moments[0].to_array());
        put(&mut self.moments[1], lane, row.moments[1].to_array());
        self.gap.0[lane] = row.gap;
    }
}

fn put(to: &mut [Four; 3], lane: usize, from: [f64; 3]) {
    for (four, value) in to.iter_mut().zip(from) {
        four.0[lane] = value;
    }
}

/// A row in lanes.
#[derive(Clone, Copy)]
struct Row<L> {
    force: Vectors<L>,
    on_a: Vectors<L>,
    on_b: Vectors<L>,
}

impl<L: Lanes> Row<L> {
    #[inline(always)]
    fn load(from: &LaneRow, part: usize) -> Self {
        Self {
            force: Vectors::load(&from.force, part),
            on_a: Vectors::load(&from.moments[0], part),
            on_b: Vectors::load(&from.moments[1], part),
        }
    }

    /// The rate of the row.
    #[inline(always)]
    fn rate(&self, between: Vectors<L>, a: Vectors<L>, b: Vectors<L>) -> L {
        self.force.dot(between) + self.on_a.dot(a) + self.on_b.dot(b)
    }
}

/// An impulse in lanes.
#[derive(Clone, Copy)]
struct Given<L> {
    force: Vectors<L>,
    on_a: Vectors<L>,
    on_b: Vectors<L>,
}

impl<L: Lanes> Given<L> {
    #[inline(always)]
    fn none() -> Self {
        let zero = L::splat(0.0);
        let none = Vectors { x: zero, y: zero, z: zero };
        Self { force: none, on_a: none, on_b: none }
    }

    #[inline(always)]
    fn load(from: &LaneImpulse, part: usize) -> Self {
        Self {
            force: Vectors::load(&from.force, part),
            on_a: Vectors::load(&from.moments[0], part),
            on_b: Vectors::load(&from.moments[1], part),
        }
    }

    #[inline(always)]
    fn store(self, to: &mut LaneImpulse, part: usize) {
        let [on_a, on_b] = &mut to.moments;
        for (from, to) in [(self.force, &mut to.force), (self.on_a, on_a), (self.on_b, on_b)] {
            from.x.store(&mut to[0], part);
            from.y.store(&mut to[1], part);
            from.z.store(&mut to[2], part);
        }
    }

    /// Adds what a row gives with this multiplier.
    #[inline(always)]
    fn add(&mut self, row: &Row<L>, multiplier: L) {
        self.force = self.force + row.force.times(multiplier);
        self.on_a = self.on_a + row.on_a.times(multiplier);
        self.on_b = self.on_b + row.on_b.times(multiplier);
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self { force: self.force + other.force, on_a: self.on_a + other.on_a, on_b: self.on_b + other.on_b }
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        Self { force: self.force - other.force, on_a: self.on_a - other.on_a, on_b: self.on_b - other.on_b }
    }

    /// Its work along these velocities, J.
    #[inline(always)]
    fn work(&self, a: &Twist<L>, b: &Twist<L>) -> L {
        self.force.dot(a.linear - b.linear) + self.on_a.dot(a.angular) + self.on_b.dot(b.angular)
    }
}

/// The two bodies of a batch in lanes.
struct Pair<L> {
    numbers: [[u32; FOUR]; 2],
    part: usize,
    a: Gathered<L>,
    b: Gathered<L>,
}

impl<L: Lanes> Pair<L> {
    #[inline(always)]
    fn load(bodies: &[ImpulseBody], batch: &JointBatch, part: usize) -> Self {
        let [a, b] = [&batch.a, &batch.b].map(|of| Gathered::load(bodies, numbers::<L>(of, part)));
        Self { numbers: [batch.a, batch.b], part, a, b }
    }

    #[inline(always)]
    fn take(&mut self, given: &Given<L>) {
        self.a.take(given.force, given.on_a);
        self.b.linear = self.b.linear - given.force.times(self.b.inverse_mass);
        self.b.angular = self.b.angular + self.b.inverse_inertia.times(given.on_b);
    }

    #[inline(always)]
    fn store(&self, bodies: &mut [ImpulseBody]) {
        self.a.store_velocities(bodies, numbers::<L>(&self.numbers[0], self.part));
        self.b.store_velocities(bodies, numbers::<L>(&self.numbers[1], self.part));
    }
}

/// What one part of a batch of `N` rows is asked for.
trait Kernel<L: Lanes> {
    fn run<const N: usize>(&mut self, batch: &mut JointBatch, rows: &mut [LaneRow; N], part: usize);
}

/// Runs a kernel on all parts of a batch, by its number of rows.
#[inline(always)]
fn run<L: Lanes>((batch, rows): Rows<'_>, kernel: &mut impl Kernel<L>) {
    #[inline(always)]
    fn all<L: Lanes, const N: usize>(batch: &mut JointBatch, rows: &mut [LaneRow], kernel: &mut impl Kernel<L>) {
        let Some(rows) = rows.first_chunk_mut::<N>() else { return };
        for part in 0..FOUR / L::WIDTH {
            kernel.run::<N>(batch, rows, part);
        }
    }
    match rows.len() {
        1 => all::<L, 1>(batch, rows, kernel),
        2 => all::<L, 2>(batch, rows, kernel),
        3 => all::<L, 3>(batch, rows, kernel),
        4 => all::<L, 4>(batch, rows, kernel),
        5 => all::<L, 5>(batch, rows, kernel),
        6 => all::<L, 6>(batch, rows, kernel),
        _ => {}
    }
}

/// `L D L^T` of `K`, row by row.
pub(super) fn factor<L: Lanes>(bodies: &[ImpulseBody], of: Rows<'_>) {
    run::<L>(of, &mut Factor(bodies));
}

struct Factor<'b>(&'b [ImpulseBody]);

impl<L: Lanes> Kernel<L> for Factor<'_> {
    #[inline(always)]
    fn run<const N: usize>(&mut self, batch: &mut JointBatch, rows: &mut [LaneRow; N], part: usize) {
        let zero = L::splat(0.0);
        let Pair { a, b, .. } = Pair::<L>::load(self.0, batch, part);
        let inverse_mass = a.inverse_mass + b.inverse_mass;
        let all: [Row<L>; N] = std::array::from_fn(|k| Row::load(&rows[k], part));
        let mut factors = [[zero; N]; N];
        for i in 0..N {
            // What a unit of the row does to its bodies.
            let force = all[i].force.times(inverse_mass);
            let [on_a, on_b] = [a.inverse_inertia.times(all[i].on_a), b.inverse_inertia.times(all[i].on_b)];
            let entry = |j: usize| all[j].rate(force, on_a, on_b);
            let diagonal = entry(i);
            let mut pivot = diagonal;
            let mut scaled = [zero; N];
            for j in 0..i {
                // The entry of L D, and of L.
                let mut value = entry(j);
                for k in 0..j {
                    value = value - scaled[k] * factors[j][k];
                }
                scaled[j] = value;
                factors[i][j] = value * factors[j][j];
                pivot = pivot - value * factors[i][j];
            }
            let inverse = L::splat(1.0) / pivot;
            factors[i][i] = L::pick_greater(pivot, L::splat(TRUSTED_PIVOT) * diagonal, inverse, zero);
        }
        for (i, row) in rows.iter_mut().enumerate() {
            for j in 0..=i {
                factors[i][j].store(&mut row.factor[j], part);
            }
        }
    }
}

/// `K^-1 x`.
#[inline(always)]
fn solved<L: Lanes, const N: usize>(rows: &[LaneRow; N], mut x: [L; N], part: usize) -> [L; N] {
    let factor = |i: usize, j: usize| L::load(&rows[i].factor[j], part);
    for i in 0..N {
        for j in 0..i {
            x[i] = x[i] - factor(i, j) * x[j];
        }
    }
    for (i, x) in x.iter_mut().enumerate() {
        *x = *x * factor(i, i);
    }
    for i in (0..N).rev() {
        for j in i + 1..N {
            x[i] = x[i] - factor(j, i) * x[j];
        }
    }
    x
}

/// Brings a batch to its laws. Its work along the mean of the velocities before and after each of its impulses is added
/// to `work`.
pub(super) fn solve<L: Lanes>(bodies: &mut [ImpulseBody], of: Rows<'_>, (rule, work): (&SweepRule, &mut Four)) {
    run::<L>(of, &mut Solve { bodies, rule, work });
}

struct Solve<'b> {
    bodies: &'b mut [ImpulseBody],
    rule: &'b SweepRule,
    work: &'b mut Four,
}

impl<L: Lanes> Kernel<L> for Solve<'_> {
    #[inline(always)]
    fn run<const N: usize>(&mut self, batch: &mut JointBatch, rows: &mut [LaneRow; N], part: usize) {
        let bodies = &mut *self.bodies;
        let before = Pair::<L>::load(bodies, batch, part);
        let (a, b) = (before.a.twist(), before.b.twist());
        let given = bring_to_law::<L, N>(bodies, (batch, part), rows, self.rule);
        let after = Pair::<L>::load(bodies, batch, part);
        let twice = given.work(&a, &b) + given.work(&after.a.twist(), &after.b.twist());
        (L::load(self.work, part) + L::splat(0.5) * twice).store(self.work, part);
    }
}

/// What the rows of a joint have in common in a sweep, in lanes.
struct Law<L> {
    soft: Softness,
    push: L,
    inverse_step: L,
}

impl<L: Lanes> Law<L> {
    fn of(rule: &SweepRule) -> Self {
        let (soft, push) = (rule.with_fixed, L::splat(rule.push.abs()));
        Self { soft, push, inverse_step: L::splat(rule.inverse_step) }
    }

    /// The speed at which a gap is closed, `b g`, not faster than the push.
    #[inline(always)]
    fn closing(&self, gap: L) -> L {
        let wanted = L::splat(self.soft.rate) * gap;
        let least = wanted.greater(-self.push);
        L::pick_greater(least, self.push, self.push, least)
    }
}

/// Gives the impulses by which a part of a batch obeys its law.
#[inline(always)]
fn bring_to_law<L: Lanes, const N: usize>(
    bodies: &mut [ImpulseBody],
    (batch, part): (&mut JointBatch, usize),
    rows: &mut [LaneRow; N],
    rule: &SweepRule,
) -> Given<L> {
    let law = Law::<L>::of(rule);
    let mut pair = Pair::<L>::load(bodies, batch, part);
    let between = pair.a.linear - pair.b.linear;
    let all: [Row<L>; N] = std::array::from_fn(|k| Row::load(&rows[k], part));
    let rates: [L; N] = std::array::from_fn(|k| all[k].rate(between, pair.a.angular, pair.b.angular));
    let mut given = Given::none();
    if batch.law == JointLaw::Limit {
        let [zero, one] = [0.0, 1.0].map(L::splat);
        let (gap, known) = (L::load(&rows[0].gap, part), L::load(&rows[0].multiplier, part));
        let bias = L::pick_greater(gap, zero, law.inverse_step * gap, law.closing(gap));
        let mass = L::pick_greater(gap, zero, one, L::splat(law.soft.mass));
        let taken_back = L::pick_greater(gap, zero, zero, L::splat(law.soft.impulse));
        let wanted = mass * L::load(&rows[0].factor[0], part) * (rates[0] + bias) + taken_back * known;
        let multiplier = (known - wanted).greater(zero);
        multiplier.store(&mut rows[0].multiplier, part);
        given.add(&all[0], multiplier - known);
    } else {
        let wanted: [L; N] = std::array::from_fn(|k| rates[k] + law.closing(L::load(&rows[k].gap, part)));
        let needed = solved(rows, wanted, part);
        let (mass, taken_back) = (L::splat(law.soft.mass), L::splat(law.soft.impulse));
        for k in 0..N {
            let known = L::load(&rows[k].multiplier, part);
            let change = -(mass * needed[k]) - taken_back * known;
            (known + change).store(&mut rows[k].multiplier, part);
            given.add(&all[k], change);
        }
    }
    Given::load(&batch.given, part).plus(given).store(&mut batch.given, part);
    pair.take(&given);
    pair.store(bodies);
    given
}

/// Takes back what the batch gave in the substep before, and gives its multipliers along the present rows.
pub(super) fn start<L: Lanes>(bodies: &mut [ImpulseBody], of: Rows<'_>) {
    run::<L>(of, &mut Start(bodies));
}

struct Start<'b>(&'b mut [ImpulseBody]);

impl<L: Lanes> Kernel<L> for Start<'_> {
    #[inline(always)]
    fn run<const N: usize>(&mut self, batch: &mut JointBatch, rows: &mut [LaneRow; N], part: usize) {
        let mut given = Given::none();
        for row in rows.iter() {
            given.add(&Row::load(row, part), L::load(&row.multiplier, part));
        }
        let change = given.minus(Given::load(&batch.given, part));
        given.store(&mut batch.given, part);
        let mut pair = Pair::<L>::load(self.0, batch, part);
        pair.take(&change);
        pair.store(self.0);
    }
}

/// Adds the impulses of the substep to those of the step, and their work along the mean velocities of the bodies.
pub(super) fn end<L: Lanes>(bodies: &[ImpulseBody], batch: &mut JointBatch, work: &mut Four) {
    for part in 0..FOUR / L::WIDTH {
        let [a, b] = [&batch.a, &batch.b].map(|of| Twist::<L>::means(bodies, numbers::<L>(of, part)));
        let given = Given::load(&batch.given, part);
        (L::load(work, part) + given.work(&a, &b)).store(work, part);
        Given::load(&batch.total, part).plus(given).store(&mut batch.total, part);
    }
}

impl JointBatch {
    /// Adds the impulses of the substep to those of the step.
    pub(super) fn add_up(&mut self) {
        for (total, given) in self.total.fours_mut().zip(self.given.fours()) {
            total.0.iter_mut().zip(given.0).for_each(|(total, given)| *total += given);
        }
    }
}

impl LaneImpulse {
    /// Adds what a row gives in a lane with this multiplier.
    pub(super) fn take(&mut self, lane: usize, row: &LaneRow, multiplier: f64) {
        let from = row.force.iter().chain(row.moments.iter().flatten());
        for (to, from) in self.force.iter_mut().chain(self.moments.iter_mut().flatten()).zip(from) {
            to.0[lane] += from.0[lane] * multiplier;
        }
    }

    fn fours(&self) -> impl Iterator<Item = Four> {
        self.force.into_iter().chain(self.moments.into_iter().flatten())
    }

    fn fours_mut(&mut self) -> impl Iterator<Item = &mut Four> {
        self.force.iter_mut().chain(self.moments.iter_mut().flatten())
    }
}
