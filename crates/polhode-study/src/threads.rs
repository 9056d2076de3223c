//! Threads for what a simulation computes side by side: the islands of a step, the margins of what stands.

use polhode::{Executor, Task};
use std::num::NonZeroUsize;
use std::sync::{Mutex, PoisonError};

/// A number of threads, that of the caller among them. The others last as long as the tasks of one list; where the
/// system gives none, the thread of the caller runs them all.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Threads(pub NonZeroUsize);

impl Threads {
    /// As many as this machine runs at once.
    pub fn of_machine() -> Self {
        Self(std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN))
    }
}

impl Executor for Threads {
    fn width(&self) -> NonZeroUsize {
        self.0
    }

    fn run(&self, tasks: Vec<Task<'_>>) {
        let others = (self.0.get() - 1).min(tasks.len().saturating_sub(1));
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

#[cfg(test)]
mod tests {
    use super::Threads;
    use polhode::{Executor, Task};
    use std::num::NonZeroUsize;

    /// Lists that are shorter than the threads, and longer ones.
    #[test]
    fn every_task_is_run_once() {
        for (number, length) in [(1, 5), (4, 0), (4, 1), (8, 100)] {
            let mut counts = vec![0; length];
            let tasks = counts.iter_mut().map(|count| Box::new(move || *count += 1) as Task<'_>);
            Threads(NonZeroUsize::MIN.saturating_add(number - 1)).run(tasks.collect());
            assert!(counts.iter().all(|&count| count == 1));
        }
    }
}
