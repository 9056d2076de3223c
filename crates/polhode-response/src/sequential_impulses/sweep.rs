//! One sweep over all contacts: each point gets the impulse that brings it to its law, given all that was done before.
//!
//! With the relative velocity `u` of a point, the softness of the contact (Catto 2024) and `s` its present separation,
//!
//! ```text
//! beta = s / h                        where s > 0: it may close by that much (speculative contact)
//!        max(b s, -v_push)            where it overlaps
//! p_n <- max(0, p_n - m (a (u_n) + a' beta) - c p_n)
//! p_t <- P(p_t - rho u_t)             onto the disc |p_t| <= mu p_n; rho one number, so that friction acts against the slip
//! ```
//!
//! `m = 1 / K_nn`, `rho` the inverse of the largest eigenvalue of `K_tt`; `a`, `b`, `c` are [`Softness`]. Separations are those at the
//! start of the step plus the displacements of the bodies along the rows of then.
//!
//! **Work.** Impulses of a substep do work along the mean of the velocities before and after all of them (`works::book`). A sweep that begins a substep books
//! those of the substep before, which it reads anyway.

use super::batch::{Batch, PointRows};
use super::body::{Gathered, ImpulseBody, Twist};
use super::lanes::{FOUR, Lanes, Vectors};
use super::works::{FourWorks, Frame, LaneWorks, Works, book, numbers};

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

    /// A spring of this frequency (Hz) and damping ratio (no unit) over substeps of `h` (s), implicit in time (Catto 2024).
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

/// A sweep over all batches, in order. Returns the change of energy that it has booked.
pub(super) fn sweep<L: Lanes>(
    bodies: &mut [ImpulseBody],
    batches: &[Batch],
    points: &mut [PointRows],
    (stage, rule): (SweepStage, &SweepRule),
) -> Works {
    // A kernel for each stage.
    match stage {
        SweepStage::First => sweep_all::<L>(bodies, batches, points, (SweepStage::First, rule)),
        SweepStage::Next => sweep_all::<L>(bodies, batches, points, (SweepStage::Next, rule)),
        SweepStage::Moved => sweep_all::<L>(bodies, batches, points, (SweepStage::Moved, rule)),
    }
}

#[inline(always)]
fn sweep_all<L: Lanes>(
    bodies: &mut [ImpulseBody],
    batches: &[Batch],
    points: &mut [PointRows],
    (stage, rule): (SweepStage, &SweepRule),
) -> Works {
    let mut works = FourWorks::default();
    for batch in batches {
        let rows = &mut points[batch.first as usize..(batch.first + batch.count) as usize];
        for part in 0..FOUR / L::WIDTH {
            match stage {
                SweepStage::First => {}
                SweepStage::Next => {
                    let mut own = works.load::<L>(part);
                    book_all::<L>(bodies, (batch, part), rows, (&mut own, rule));
                    works.store(own, part);
                }
                SweepStage::Moved => move_all::<L>(bodies, (batch, part), rows),
            }
            solve::<L>(bodies, (batch, part), rows, rule);
        }
    }
    works.sums()
}

/// Books the impulses of the substep before.
#[inline(always)]
fn book_all<L: Lanes>(
    bodies: &[ImpulseBody],
    (batch, part): (&Batch, usize),
    rows: &mut [PointRows],
    (works, rule): (&mut LaneWorks<L>, &SweepRule),
) {
    let frame = Frame::<L>::load(batch, part);
    let [mean_a, mean_b] = [&batch.a, &batch.b].map(|of| Twist::<L>::means(bodies, numbers::<L>(of, part)));
    for row in rows {
        let arm = Vectors::<L>::load(&row.arm, part);
        let mean = mean_a.at(arm) - mean_b.at(arm + frame.between);
        let impulse = [0, 1, 2].map(|k| L::load(&row.impulse[k], part));
        book(works, (row, part), (&frame, mean, impulse), L::splat(-rule.colliding));
    }
}

/// Separations after the displacements of the bodies.
#[inline(always)]
fn move_all<L: Lanes>(bodies: &[ImpulseBody], (batch, part): (&Batch, usize), rows: &mut [PointRows]) {
    let normal = Vectors::<L>::load(&batch.normal, part);
    let between = Vectors::<L>::load(&batch.between, part);
    let [a, b] = [&batch.a, &batch.b].map(|of| Twist::<L>::displacements(bodies, numbers::<L>(of, part)));
    // What all points have in common, and what goes with the arm: n . (w x r) = (n x w) . r.
    let common = normal.dot(a.linear - b.linear) - normal.dot(b.angular.cross(between));
    let along = normal.cross(a.angular - b.angular);
    for row in rows {
        let arm = Vectors::<L>::load(&row.arm, part);
        let moved = common + along.dot(arm);
        (L::load(&row.separation, part) + moved).store(&mut row.present, part);
    }
}

/// The softness of each lane.
struct Soft<L> {
    rate: L,
    mass: L,
    impulse: L,
}

impl<L: Lanes> Soft<L> {
    #[inline(always)]
    fn of(rule: &SweepRule, side: L) -> Self {
        let square = side * side;
        let pick =
            |between: f64, fixed: f64| L::pick_greater(square, L::splat(0.0), L::splat(fixed), L::splat(between));
        let (between, fixed) = (&rule.between, &rule.with_fixed);
        Self {
            rate: pick(between.rate, fixed.rate),
            mass: pick(between.mass, fixed.mass),
            impulse: pick(between.impulse, fixed.impulse),
        }
    }
}

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
    let friction = L::load(&batch.friction, part);
    let soft = Soft::of(rule, L::load(&batch.side, part));
    let (zero, one) = (L::splat(0.0), L::splat(1.0));
    let (inverse_step, push) = (L::splat(rule.inverse_step), L::splat(-rule.push));
    for row in rows {
        let arm = Vectors::<L>::load(&row.arm, part);
        let arm_b = arm + frame.between;
        let velocity = a.linear - b.linear + a.angular.cross(arm) - b.angular.cross(arm_b);
        let separation = L::load(&row.present, part);
        let overlapping = (soft.mass * soft.rate * separation).greater(push);
        let bias = L::pick_greater(separation, zero, separation * inverse_step, overlapping);
        let share = L::pick_greater(separation, zero, one, soft.mass);
        let taken_back = L::pick_greater(separation, zero, zero, soft.impulse);

        let normal_rate = frame.normal.dot(velocity);
        let before = L::load(&row.impulse[0], part);
        let wanted = before - L::load(&row.mass, part) * (share * normal_rate + bias) - taken_back * before;
        let normal = wanted.greater(zero);
        let d_normal = normal - before;

        let slip_x = frame.first.dot(velocity) + L::load(&row.coupling[0], part) * d_normal;
        let slip_y = frame.second.dot(velocity) + L::load(&row.coupling[1], part) * d_normal;
        let (before_x, before_y) = (L::load(&row.impulse[1], part), L::load(&row.impulse[2], part));
        let rho = L::load(&row.sliding_mass, part);
        let (wanted_x, wanted_y) = (before_x - rho * slip_x, before_y - rho * slip_y);
        let limit = friction * normal;
        let square = wanted_x * wanted_x + wanted_y * wanted_y;
        let scale = L::pick_greater(square, limit * limit, limit / square.root(), one);
        let (x, y) = (wanted_x * scale, wanted_y * scale);
        let (d_x, d_y) = (x - before_x, y - before_y);

        normal.store(&mut row.impulse[0], part);
        x.store(&mut row.impulse[1], part);
        y.store(&mut row.impulse[2], part);
        let impulse = frame.vector(d_normal, d_x, d_y);
        a.take(impulse, arm);
        b.give(impulse, arm_b);
    }
    a.store_velocities(bodies, numbers_a);
    b.store_velocities(bodies, numbers_b);
}
