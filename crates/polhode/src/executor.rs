//! Who computes tasks that do not depend on each other: the thread of the caller, or several.
//!
//! A tier may advance islands at once, since they do not act on each other within a step. The core starts no thread of its own
//! accord: a program gives [`Threads`], or an [`Executor`] over its own pool, to
//! [`Simulation::set_executor`](crate::Simulation::set_executor). Each task writes to a place of its own and the results are
//! put together in the order of the islands, so that the motion has the same bits for every executor.

use std::num::NonZeroUsize;
use std::sync::{Mutex, PoisonError};

/// Work that depends on no other task of the same list.
pub type Task<'a> = Box<dyn FnOnce() + Send + 'a>;

/// Runs tasks.
///
/// ```
/// use polhode::{Executor, Task, Threads};
/// let threads = Threads::new(2.try_into()?);
/// let mut squares = [0, 0, 0];
/// let tasks = squares.iter_mut().enumerate().map(|(n, square)| Box::new(move || *square = n * n) as Task<'_>);
/// threads.run(tasks.collect());
/// assert_eq!(squares, [0, 1, 4]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Executor: std::fmt::Debug + Send + Sync {
    /// How many tasks may run at once: into how many parts work is divided.
    fn width(&self) -> NonZeroUsize;

    /// Runs each task once, in any order, and returns when all have ended.
    fn run(&self, tasks: Vec<Task<'_>>);
}

/// Runs tasks on a number of threads of the standard library, which last as long as the tasks. Where the system gives no
/// thread, as on wasm32, the thread of the caller runs them all.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Threads {
    number: NonZeroUsize,
}

impl Threads {
    /// So many threads, that of the caller among them.
    pub const fn new(number: NonZeroUsize) -> Self {
        Self { number }
    }
}

impl Default for Threads {
    /// The thread of the caller.
    fn default() -> Self {
        Self::new(NonZeroUsize::MIN)
    }
}

impl Executor for Threads {
    fn width(&self) -> NonZeroUsize {
        self.number
    }

    fn run(&self, tasks: Vec<Task<'_>>) {
        let others = (self.number.get() - 1).min(tasks.len().saturating_sub(1));
        let left = Mutex::new(tasks.into_iter());
        let next = || left.lock().unwrap_or_else(PoisonError::into_inner).next();
        let work = || {
            while let Some(task) = next() {
                task();
            }
        };
        std::thread::scope(|scope| {
            for _ in 0..others {
                if std::thread::Builder::new().spawn_scoped(scope, work).is_err() {
                    break;
                }
            }
            work();
        });
    }
}
