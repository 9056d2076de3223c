//! One sweep over all contacts: each point gets the impulse that brings it to its law, given all that was done before.
//!
//! With the relative velocity `u` of a point, the softness of the contact (Catto 2024) and `s` its present separation,
//!
//! ```text
//! beta = s / h                        where s > 0: it may close by that much (speculative contact)
//!        max(b s, -v_push)            where it overlaps
//! p_n <- max(0, p_n - m (a (u_n) + a' beta) - c p_n)
//! p_t <- P(p_t - rho u_t)             onto the disc |p_t| <= mu p_n; rho one number: friction acts against the slip
//! ```
//!
//! The points of a patch are solved in its coordinates (`patch`), first all along the tangents, then all along the
//! normal (`together`). The formulas are those of a patch of
//! one point; of several no point comes before another. Friction first tries the change of least norm under which none
//! of them slips; where that is beyond a disc, each point
//! takes the step `rho / N` against its own slip. `m = 1 / K_nn`, `rho` the
//! inverse of the largest eigenvalue of `K_tt`; `a`, `b`, `c` are [`Softness`]. Separations are those at the start of
//! the step plus the displacements of the bodies along the rows of then.
//!
//! **Work.** Impulses of a substep do work along the mean of the velocities before and after all of them
//! (`works::book`). A sweep that begins a substep books those of the substep before, which it reads anyway.

use super::batch::{Batch, PointRows};
use super::body::{Gathered, ImpulseBody, Twist};
use super::friction;
use super::lanes::{FOUR, Lanes, by_place};
use super::patch::{Frame, Relative, Wrench, add, coupled, place};
use super::together::{Together, entries};
use super::works::{FourWorks, Works, book, numbers};

/// How a contact gives way where it overlaps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Softness {
    /// Rate at which an overlap is pushed apart, 1/s.
    pub rate: f64,
    /// Part of the effective mass that acts (no unit).
    pub mass: f64,
    /// Part of the impulse that is taken back (no unit).
    pub impulse: f64,
}

impl Softness {
    /// A rigid contact that pushes nothing apart.
    pub const RIGID: Self = Self { rate: 0.0, mass: 1.0, impulse: 0.0 };

    /// A spring of this frequency (Hz) and damping ratio (no unit) over substeps of `h` (s), implicit in time (Catto
    /// 2024).
    pub fn of_spring(frequency_hz: f64, damping: f64, h: f64) -> Self {
        let omega = std::f64::consts::TAU * frequency_hz;
        let a1 = 2.0 * damping + h * omega;
        let a2 = h * omega * a1;
        let a3 = 1.0 / (1.0 + a2);
        Self { rate: omega / a1, mass: a2 * a3, impulse: a3 }
    }
}

/// What a sweep does beside finding impulses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SweepStage {
    /// The first one of a step: nothing.
    First,
    /// It begins a later substep: it books the impulses of the substep before, along the mean velocities of the bodies.
    Next,
    /// It follows a movement of the bodies: separations are found anew.
    Moved,
}

/// In which order a sweep goes through the contacts. A sweep back is the adjoint of one onward: both together damp
/// errors without making them swing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SweepOrder {
    /// Colour by colour, contacts with bodies that impulses do not move last.
    Onward,
    /// The contacts between bodies that move from the last to the first, and then those with others as before: nothing
    /// that these lean on gives way.
    Back,
}

/// A sweep: what it does, in which order, and by which rule.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sweep<'a> {
    pub(super) stage: SweepStage,
    pub(super) order: SweepOrder,
    pub(super) rule: &'a SweepRule,
    /// How many of the batches are between bodies that impulses move.
    pub(super) between: usize,
}

/// What all contacts of a sweep have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepRule {
    /// Contacts between bodies that impulses move.
    pub between: Softness,
    /// Contacts with bodies that they do not move.
    pub with_fixed: Softness,
    /// Largest speed at which overlaps are pushed apart, m/s.
    pub push: f64,
    /// 1 / length of a substep, 1/s.
    pub inverse_step: f64,
    /// Contacts that approach faster than this at the start of the step collide, m/s.
    pub colliding: f64,
}

/// A sweep over all batches. Returns the change of energy that it has booked.
pub(super) fn sweep<L: Lanes>(
    bodies: &mut [ImpulseBody],
    batches: &[Batch],
    points: &mut [PointRows],
    sweep: Sweep<'_>,
) -> Works {
    // A kernel for each stage.
    match sweep.stage {
        SweepStage::First => sweep_all::<L>(bodies, batches, points, Sweep { stage: SweepStage::First, ..sweep }),
        SweepStage::Next => sweep_all::<L>(bodies, batches, points, Sweep { stage: SweepStage::Next, ..sweep }),
        SweepStage::Moved => sweep_all::<L>(bodies, batches, points, Sweep { stage: SweepStage::Moved, ..sweep }),
    }
}

#[inline(always)]
fn sweep_all<L: Lanes>(
    bodies: &mut [ImpulseBody],
    batches: &[Batch],
    points: &mut [PointRows],
    Sweep { stage, order, rule, between }: Sweep<'_>,
) -> Works {
    let mut works = FourWorks::default();
    for place in 0..batches.len() {
        let batch = match order {
            SweepOrder::Back if place < between => &batches[between - 1 - place],
            SweepOrder::Onward | SweepOrder::Back => &batches[place],
        };
        let rows = &mut points[batch.first as usize..(batch.first + batch.count) as usize];
        for part in 0..FOUR / L::WIDTH {
            match stage {
                SweepStage::First => {}
                SweepStage::Next => {
                    let mut own = works.load::<L>(part);
                    book::<L>(bodies, (batch, part), rows, (&mut own, rule.colliding));
                    works.store(own, part);
                }
                SweepStage::Moved => move_all::<L>(bodies, (batch, part), rows),
            }
            solve::<L>(bodies, (batch, part), rows, rule);
        }
    }
    works.sums()
}

/// Separations after the displacements of the bodies.
#[inline(always)]
fn move_all<L: Lanes>(bodies: &[ImpulseBody], (batch, part): (&Batch, usize), rows: &mut [PointRows]) {
    let [a, b] = [&batch.a, &batch.b].map(|of| Twist::<L>::displacements(bodies, numbers::<L>(of, part)));
    let moved = Frame::<L>::load(batch, part).relative(&a, &b);
    for row in rows {
        let present = L::load(&row.separation, part) + moved.rate(place(&row.place, part));
        present.store(&mut row.present, part);
    }
}

/// What the points of a patch have in common in a sweep, in lanes.
struct Law<L> {
    rate: L,
    mass: L,
    taken_back: L,
    inverse_step: L,
    /// Largest speed of the push, negative.
    push: L,
    friction: L,
}

impl<L: Lanes> Law<L> {
    #[inline(always)]
    fn of(rule: &SweepRule, batch: &Batch, part: usize) -> Self {
        let side = L::load(&batch.side, part);
        let square = side * side;
        let pick =
            |between: f64, fixed: f64| L::pick_greater(square, L::splat(0.0), L::splat(fixed), L::splat(between));
        let (between, fixed) = (&rule.between, &rule.with_fixed);
        Self {
            rate: pick(between.mass * between.rate, fixed.mass * fixed.rate),
            mass: pick(between.mass, fixed.mass),
            taken_back: pick(between.impulse, fixed.impulse),
            inverse_step: L::splat(rule.inverse_step),
            push: L::splat(-rule.push),
            friction: L::load(&batch.friction, part),
        }
    }

    /// The impulse along the normal at a point with this rate of separation; what it changes by.
    #[inline(always)]
    fn press(&self, row: &mut PointRows, part: usize, rate: L) -> L {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let separation = L::load(&row.present, part);
        let overlapping = (self.rate * separation).greater(self.push);
        let bias = L::pick_greater(separation, zero, separation * self.inverse_step, overlapping);
        let share = L::pick_greater(separation, zero, one, self.mass);
        let taken_back = L::pick_greater(separation, zero, zero, self.taken_back);
        let before = L::load(&row.impulse[0], part);
        let wanted = before - L::load(&row.mass, part) * (share * rate + bias) - taken_back * before;
        let normal = wanted.greater(zero);
        normal.store(&mut row.impulse[0], part);
        normal - before
    }

    /// The impulses along the normal at all points of a patch whose bodies move like this; the wrench takes what they
    /// change by.
    #[inline(always)]
    fn press_together<const N: usize>(
        &self,
        rows: &mut [PointRows],
        part: usize,
        (relative, wrench): (&Relative<L>, &mut Wrench<L>),
    ) {
        let Some(rows) = rows.first_chunk_mut::<N>() else { return };
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let known: [L; N] = by_place(zero, |i| L::load(&rows[i].impulse[0], part));
        let matrix: [[L; N]; N] = by_place([zero; N], |i| entries(&rows[i], i, part));
        let separation: [L; N] = by_place(zero, |i| L::load(&rows[i].present, part));
        // Of the law of a point, `u + beta / a + (c / a) K p = 0`.
        let compliance = self.taken_back / self.mass;
        let give: [L; N] = by_place(zero, |i| L::pick_greater(separation[i], zero, zero, compliance * matrix[i][i]));
        let wanted: [L; N] = by_place(zero, |i| {
            let overlapping = (self.rate * separation[i]).greater(self.push) / self.mass;
            let bias = L::pick_greater(separation[i], zero, separation[i] * self.inverse_step, overlapping);
            relative.rate(place(&rows[i].place, part)) + bias + give[i] * known[i]
        });
        let change = Together { matrix, known, wanted, give, may: [one; N] }.change();
        for i in 0..N {
            (known[i] + change[i]).store(&mut rows[i].impulse[0], part);
            wrench.press(place(&rows[i].place, part), change[i]);
        }
    }
}

/// Friction at all points of a patch, under the impulses of the substep.
#[inline(always)]
fn rub_together<L: Lanes, const N: usize>(
    rows: &mut [PointRows],
    of: (&Batch, usize),
    coefficient: L,
    moved: (&Relative<L>, &mut Wrench<L>),
) {
    let Some(rows) = rows.first_chunk_mut::<N>() else { return };
    friction::rub_together(rows, of, coefficient, moved, |row| &mut row.impulse, |change| change);
}

/// Brings the points of a patch to the law: all along the tangents, under the impulses along the normal of before, then
/// all along the normal, which matters most.
#[inline(always)]
fn solve<L: Lanes>(
    bodies: &mut [ImpulseBody],
    (batch, part): (&Batch, usize),
    rows: &mut [PointRows],
    rule: &SweepRule,
) {
    let (numbers_a, numbers_b) = (numbers::<L>(&batch.a, part), numbers::<L>(&batch.b, part));
    let (mut a, mut b) = (Gathered::<L>::load(bodies, numbers_a), Gathered::<L>::load(bodies, numbers_b));
    let frame = Frame::<L>::load(batch, part);
    let law = Law::of(rule, batch, part);
    let mut relative = frame.relative(&a.twist(), &b.twist());
    if let [row] = rows {
        let [x, y] = friction::rub(row, part, law.friction, [relative.slipping[0], relative.slipping[1]]);
        let [first, second, _] = &batch.blocks.coupling;
        let rate = relative.pressing[0] + L::load(&first[0], part) * x + L::load(&second[0], part) * y;
        let normal = law.press(row, part, rate);
        frame.give_at_point([normal, x, y], &mut a, &mut b);
    } else {
        let mut wrench = Wrench::none();
        match rows.len() {
            2 => rub_together::<L, 2>(rows, (batch, part), law.friction, (&relative, &mut wrench)),
            3 => rub_together::<L, 3>(rows, (batch, part), law.friction, (&relative, &mut wrench)),
            _ => rub_together::<L, 4>(rows, (batch, part), law.friction, (&relative, &mut wrench)),
        }
        relative.pressing = add(relative.pressing, coupled(&batch.blocks.coupling, part, wrench.slipping));
        match rows.len() {
            2 => law.press_together::<2>(rows, part, (&relative, &mut wrench)),
            3 => law.press_together::<3>(rows, part, (&relative, &mut wrench)),
            _ => law.press_together::<4>(rows, part, (&relative, &mut wrench)),
        }
        frame.give(&wrench, &mut a, &mut b);
    }
    a.store_velocities(bodies, numbers_a);
    b.store_velocities(bodies, numbers_b);
}
