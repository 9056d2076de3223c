//! Scenes judged on all processors.

use super::judged::{Judged, judge};
use super::known::Known;
use polhode::ErrorEstimation;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Judges scenes by one thread for each processor; `each` is called as they come, the rows are in order.
pub fn judge_all(known: &[&Known], estimation: ErrorEstimation, each: impl Fn(&Judged) + Sync) -> Vec<Judged> {
    let next = AtomicUsize::new(0);
    let all: Mutex<Vec<(usize, Vec<Judged>)>> = Mutex::default();
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let place = next.fetch_add(1, Ordering::Relaxed);
                    let Some(known) = known.get(place) else { break };
                    let judged = judge(known, estimation);
                    judged.iter().for_each(&each);
                    if let Ok(mut all) = all.lock() {
                        all.push((place, judged));
                    }
                }
            });
        }
    });
    let mut rows = all.into_inner().unwrap_or_default();
    rows.sort_by_key(|(place, _)| *place);
    rows.into_iter().flat_map(|(_, judged)| judged).collect()
}
