//! A step of all bodies, in its stages (`course.rs`).

use super::course::Course;
use super::rest::wake;
use super::rules::Rules;
use crate::SimulationError;
use crate::executor::Executor;
use crate::world::World;

/// A step of all bodies from `t` (s) by these rules.
///
/// # Errors
/// When there are more bodies than the broad phase can number.
pub(super) fn step(
    course: &mut Course,
    world: &World,
    executor: &dyn Executor,
    (t, rules): (f64, &Rules),
) -> Result<(), SimulationError> {
    if course.is_all_at_rest(world) {
        course.used = 0;
        return Ok(());
    }
    course.find_pairs(world, rules)?;
    course.find_patches(world, executor, rules);
    while wake(course, world, rules) {}
    course.make_groups(world, rules);
    course.solve(world, executor, (t, rules));
    course.fly(world, rules);
    course.write_back(rules);
    let end = t + rules.h * f64::from(rules.substeps);
    world.prescribe(end, &mut course.states);
    Ok(())
}
