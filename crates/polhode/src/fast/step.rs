//! A step of all bodies, in its stages (`course.rs`).
//!
//! Contacts are those at the start of a step, as far as its velocities can close them. What a hit within the step gives a
//! body, and where the contact of a round body wanders as it
//! turns, is not among these. So the overlaps at the end are compared with those at the start: where they have grown by
//! more than a part of the smaller body ([`OVERLAP_GROWTH`](super::rules::OVERLAP_GROWTH)), the step
//! is not taken, and the engine makes it in pieces of one substep, with contacts found anew before each.

use super::course::Course;
use super::rest::wake;
use super::rules::Rules;
use crate::SimulationError;
use crate::executor::Executor;
use crate::world::World;
use polhode_dynamics::BodyState;

/// The step of all bodies from `t` (s) by these rules, in pieces where it has to be. `after` is called after each piece
/// with its rules, and the times and states from which it
/// went.
///
/// # Errors
/// When there are more bodies than the broad phase can number.
pub(super) fn step(
    course: &mut Course,
    world: &World,
    executor: &dyn Executor,
    (t, rules): (f64, &Rules),
    mut after: impl FnMut(&Course, [f64; 2], &[BodyState], &Rules),
) -> Result<(), SimulationError> {
    let end = t + rules.h * f64::from(rules.substeps);
    let before = course.states.clone();
    if piece(course, world, executor, (t, rules))? {
        after(course, [t, end], &before, rules);
        return Ok(());
    }
    for number in 0..rules.substeps {
        let before = course.states.clone();
        let start = t + rules.h * f64::from(number);
        let own = rules.of_substep(number);
        piece(course, world, executor, (start, &own))?;
        let last = number + 1 == rules.substeps;
        after(course, [start, if last { end } else { start + rules.h }], &before, &own);
    }
    Ok(())
}

/// A piece from `t` (s) by these rules. Whether it has been taken: states and contacts stay as they are where it has not.
///
/// # Errors
/// When there are more bodies than the broad phase can number.
fn piece(
    course: &mut Course,
    world: &World,
    executor: &dyn Executor,
    (t, rules): (f64, &Rules),
) -> Result<bool, SimulationError> {
    if course.is_all_at_rest(world) {
        course.used = 0;
        return Ok(true);
    }
    let before = (rules.substeps > 1).then(|| course.states.clone());
    course.find_pairs(world, rules)?;
    course.find_patches(world, executor, rules);
    while wake(course, world, rules) {}
    course.make_groups(world, rules);
    course.solve(world, executor, (t, rules));
    course.fly(world, rules);
    if let Some(before) = before
        && course.has_sunk(world, &before, rules)
    {
        course.states = before;
        return Ok(false);
    }
    course.write_back(rules);
    let end = t + rules.h * f64::from(rules.substeps);
    world.prescribe(end, &mut course.states);
    Ok(true)
}
