//! Threads for what is computed side by side: the islands of a step and the margins of what stands in a simulation;
//! runs of a sweep and throws, whose results are taken in their order.

use polhode::{Executor, Task};
use std::collections::BTreeMap;
use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError, mpsc};

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

/// Computes each number of a range by so many workers, and gives the results to `take` in the order of the numbers. A
/// worker for which there is none (`work` gives none) ends; those after it are not given.
///
/// # Errors
/// Those of `take`, after which nothing more is computed.
pub(crate) fn in_order<T: Send, E>(
    numbers: Range<u64>,
    workers: NonZeroUsize,
    work: impl Fn(u64) -> Option<T> + Sync,
    mut take: impl FnMut(T) -> Result<(), E>,
) -> Result<(), E> {
    let next = AtomicU64::new(numbers.start);
    let is_over = AtomicBool::new(false);
    let (send, receive) = mpsc::channel();
    let work = |send: mpsc::Sender<(u64, T)>| {
        while !is_over.load(Ordering::Relaxed) {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= numbers.end {
                return;
            }
            let Some(made) = work(number) else { return };
            if send.send((number, made)).is_err() {
                return;
            }
        }
    };
    std::thread::scope(|scope| {
        let mut begun = 0;
        for _ in 0..workers.get() {
            let send = send.clone();
            begun += usize::from(std::thread::Builder::new().spawn_scoped(scope, || work(send)).is_ok());
        }
        if begun == 0 {
            // The system gives no thread: this one computes first, and takes then.
            work(send.clone());
        }
        drop(send);
        let (mut awaited, mut kept) = (numbers.start, BTreeMap::new());
        for (number, made) in receive {
            kept.insert(number, made);
            while let Some(made) = kept.remove(&awaited) {
                if let Err(error) = take(made) {
                    is_over.store(true, Ordering::Relaxed);
                    return Err(error);
                }
                awaited += 1;
            }
        }
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::{Threads, in_order};
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

    /// Results come in order and whole, for any number of workers; an error ends the work.
    #[test]
    fn results_come_in_order() {
        for workers in [1, 3] {
            let workers = NonZeroUsize::MIN.saturating_add(workers - 1);
            let mut taken = Vec::new();
            let all: Result<(), ()> = in_order(
                5..40,
                workers,
                |number| Some(number * number),
                |made| {
                    taken.push(made);
                    Ok(())
                },
            );
            assert_eq!((all, taken), (Ok(()), (5..40).map(|number| number * number).collect::<Vec<u64>>()));
            let ended = in_order(0..u64::MAX, workers, Some, |made| if made < 7 { Ok(()) } else { Err(made) });
            assert_eq!(ended, Err(7));
        }
    }
}
