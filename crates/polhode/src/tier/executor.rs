//! Who computes tasks that do not depend on each other.
//!
//! A tier may advance islands at once, since they do not act on each other within a step. The core starts no thread: a
//! program gives an [`Executor`] over threads of its own to
//! [`Simulation::set_executor`](crate::Simulation::set_executor). Each task writes to a place of its own and the
//! results are put together in the order of the islands, so that the motion has the same bits for every executor.

use std::num::NonZeroUsize;

/// Work that depends on no other task of the same list.
pub type Task<'a> = Box<dyn FnOnce() + Send + 'a>;

/// Runs tasks.
///
/// ```
/// use polhode::{Executor, Task};
/// use std::num::NonZeroUsize;
/// /// A thread for each task.
/// #[derive(Debug)]
/// struct ThreadEach(NonZeroUsize);
/// impl Executor for ThreadEach {
///     fn width(&self) -> NonZeroUsize {
///         self.0
///     }
///     fn run(&self, tasks: Vec<Task<'_>>) {
///         std::thread::scope(|scope| tasks.into_iter().for_each(|task| drop(scope.spawn(task))));
///     }
/// }
/// let mut squares = [0, 0, 0];
/// let tasks = squares.iter_mut().enumerate().map(|(n, square)| Box::new(move || *square = n * n) as Task<'_>);
/// ThreadEach(NonZeroUsize::MIN).run(tasks.collect());
/// assert_eq!(squares, [0, 1, 4]);
/// ```
pub trait Executor: std::fmt::Debug + Send + Sync {
    /// How many tasks may run at once: into how many parts work is divided.
    fn width(&self) -> NonZeroUsize;

    /// Runs each task once, in any order, and returns when all have ended.
    fn run(&self, tasks: Vec<Task<'_>>);
}

/// The thread of the caller runs one task after the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct OneThread;

impl Executor for OneThread {
    fn width(&self) -> NonZeroUsize {
        NonZeroUsize::MIN
    }

    fn run(&self, tasks: Vec<Task<'_>>) {
        for task in tasks {
            task();
        }
    }
}
