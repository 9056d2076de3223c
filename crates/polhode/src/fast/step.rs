//! A step of all bodies, in its stages (`course.rs`).
//!
//! Contacts are those at the start of a step, as far as its velocities can close them. What a hit within the step gives
//! a body, and where the contact of a round body wanders as it
//! turns, is not among these. So the end is compared with the start: where overlaps have grown by
//! more than a part of the smaller body ([`OVERLAP_GROWTH`](super::rules::OVERLAP_GROWTH)), or one body has come
//! through another (`passage`), the step is not taken, and is made in pieces, with contacts found anew before each: of
//! one substep, and these of a quarter, [`DIVISIONS`] times at most. What the smallest pieces do is taken, and told.

use super::course::Course;
use super::rest::wake;
use super::rules::Rules;
use crate::error::SimulationError;
use crate::model::{Model, prescribed, work};
use crate::tier::executor::Executor;
use polhode_dynamics::BodyState;

/// How often a step is divided at most (1 to 4): after three divisions by four a bullet of 1000 m/s flies 26 cm of a
/// step of 1/60 s.
const DIVISIONS: u32 = 3;

/// The step of all bodies from `t` (s) by these rules, in pieces where it has to be. `after` is called after each piece
/// with its rules, and the times and states from which it
/// went.
///
/// # Errors
/// When there are more bodies than the broad phase can number.
pub(super) fn step(
    course: &mut Course,
    model: &Model,
    executor: &dyn Executor,
    (t, rules): (f64, &Rules),
    mut after: impl FnMut(&Course, [f64; 2], &[BodyState], &Rules),
) -> Result<(), SimulationError> {
    let times = [t, t + rules.h * f64::from(rules.substeps)];
    let mut stepping = Stepping { course, model, executor, after: &mut after };
    stepping.advance(times, rules, DIVISIONS)
}

/// Substeps of a patch that cost a unit of work.
const SUBSTEPS_OF_UNIT: usize = 2;

/// Who is told of each piece.
type After<'a> = dyn FnMut(&Course, [f64; 2], &[BodyState], &Rules) + 'a;

/// What all pieces of a step have in common.
struct Stepping<'a> {
    course: &'a mut Course,
    model: &'a Model,
    executor: &'a dyn Executor,
    after: &'a mut After<'a>,
}

impl Stepping<'_> {
    /// Advances between two times (s) by these rules, divided so often at most.
    fn advance(&mut self, times: [f64; 2], rules: &Rules, divisions: u32) -> Result<(), SimulationError> {
        let before = self.course.states.clone();
        let work_before = self.model.work.total();
        let is_taken = piece(self.course, self.model, self.executor, (times, rules), divisions)?;
        // Which pairs are near depends on what the broad phase remembers: counted are those that touch.
        let of_patch = work::OF_PAIR + rules.substeps as usize / SUBSTEPS_OF_UNIT;
        let of_patches = self.course.patches() * of_patch;
        self.model.work.count_since(work_before, of_patches + self.course.joints_solved());
        if is_taken {
            (self.after)(self.course, times, &before, rules);
            return Ok(());
        }
        let pieces = rules.pieces();
        let mut start = times[0];
        for number in 0..pieces {
            let own = rules.of_piece(number);
            let is_last = number + 1 == pieces;
            let end = if is_last { times[1] } else { times[0] + own.h * f64::from(number + 1) };
            self.advance([start, end], &own, divisions - 1)?;
            start = end;
        }
        Ok(())
    }
}

/// A piece between two times (s) by these rules. Whether it has been taken: states and contacts stay as they are where
/// it has not, since it can be divided.
///
/// # Errors
/// When there are more bodies than the broad phase can number.
fn piece(
    course: &mut Course,
    model: &Model,
    executor: &dyn Executor,
    ([t, end], rules): ([f64; 2], &Rules),
    divisions: u32,
) -> Result<bool, SimulationError> {
    course.fault = None;
    if course.is_all_at_rest(model) {
        course.used = 0;
        return Ok(true);
    }
    let before = course.states.clone();
    course.find_pairs(model, rules)?;
    course.find_patches(model, executor, rules);
    while wake(course, model, rules) {}
    course.make_groups(model, rules);
    course.solve(model, executor, (t, rules));
    course.fly(model, rules);
    prescribed::prescribe(model, end, &mut course.states);
    course.fault = course.fault_since(model, &before, rules);
    if course.fault.is_some() && divisions > 0 {
        course.states = before;
        return Ok(false);
    }
    course.write_back(rules);
    if course.fault.is_none() {
        course.fault = course.inside_now(model);
    }
    Ok(true)
}
