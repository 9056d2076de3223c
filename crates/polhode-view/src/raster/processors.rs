//! Work on all processors, with the same result.

use std::num::NonZero;
use std::panic::resume_unwind;
use std::thread;

/// What a function makes of each element of a list, with as many threads as there are processors: each takes every so
/// many elements. No element knows of another, so that the result is the same with any number of threads.
pub(super) fn on_all_processors<T: Sync, R: Send>(list: &[T], make: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let threads = thread::available_parallelism().map_or(1, NonZero::get).min(list.len()).max(1);
    let of_thread = &|first: usize| list.iter().skip(first).step_by(threads).map(&make).collect::<Vec<R>>();
    let mut made: Vec<_> = thread::scope(|scope| {
        let spawned = |first: usize| (first, thread::Builder::new().spawn_scoped(scope, move || of_thread(first)).ok());
        let others: Vec<_> = (1..threads).map(spawned).collect();
        let own = of_thread(0);
        // Where the system gives no further thread, this one does its work.
        let of_other = |(first, other): (usize, Option<thread::ScopedJoinHandle<'_, Vec<R>>>)| {
            other.map_or_else(|| of_thread(first), |other| other.join().unwrap_or_else(|panic| resume_unwind(panic)))
        };
        std::iter::once(own).chain(others.into_iter().map(of_other)).map(Vec::into_iter).collect()
    });
    (0..list.len()).filter_map(|place| made[place % threads].next()).collect()
}
