//! The sorting of pairs, for broad phases that find them in any order.

use super::{BroadPhase, BroadPhaseError, begin};
use crate::Aabb;
use std::fmt::Debug;

/// How a broad phase finds the pairs of boxes that overlap.
pub(crate) trait PairSearch: Debug + Send {
    /// Adds every pair to `found` once, in any order.
    fn search(&mut self, boxes: &[Aabb], found: &mut PairCollector);
}

/// A broad phase made of a search and the sorting of its pairs.
#[derive(Debug, Clone, Default)]
pub(crate) struct Sorted<S> {
    search: S,
    found: PairCollector,
}

impl<S: PairSearch> BroadPhase for Sorted<S> {
    fn pairs(&mut self, boxes: &[Aabb], pairs: &mut Vec<(u32, u32)>) -> Result<(), BroadPhaseError> {
        begin(boxes, pairs)?;
        self.found.clear();
        self.search.search(boxes, &mut self.found);
        self.found.sort_into(boxes.len(), pairs);
        Ok(())
    }
}

/// Pairs found so far, each once and in no order.
#[derive(Debug, Clone, Default)]
pub(crate) struct PairCollector {
    found: Vec<(u32, u32)>,
    /// Buffers of the counting sort: the pairs sorted by second box, and the positions of the keys.
    by_second: Vec<(u32, u32)>,
    first_places: Vec<usize>,
    second_places: Vec<usize>,
}

impl PairCollector {
    pub(crate) fn clear(&mut self) {
        self.found.clear();
    }

    /// Adds the pair of two different boxes, in either order.
    pub(crate) fn push(&mut self, i: u32, j: u32) {
        self.found.push((i.min(j), i.max(j)));
    }

    /// Sorts the pairs of `count` boxes into `sorted`, by a stable counting sort: by the second box, then by the first.
    /// The time is linear in the numbers of pairs and boxes, even when one box overlaps all others.
    pub(crate) fn sort_into(&mut self, count: usize, sorted: &mut Vec<(u32, u32)>) {
        for places in [&mut self.first_places, &mut self.second_places] {
            places.clear();
            places.resize(count, 0);
        }
        for &(i, j) in &self.found {
            self.first_places[i as usize] += 1;
            self.second_places[j as usize] += 1;
        }
        distribute(&self.found, |pair| pair.1 as usize, &mut self.second_places, &mut self.by_second);
        distribute(&self.by_second, |pair| pair.0 as usize, &mut self.first_places, sorted);
    }
}

/// One pass of a stable counting sort. `places` holds the number of items with each key, and afterwards where the items
/// of each key end.
pub(crate) fn distribute<T: Copy + Default>(
    items: &[T],
    key: impl Fn(&T) -> usize,
    places: &mut [usize],
    ordered: &mut Vec<T>,
) {
    let mut start = 0;
    for place in &mut *places {
        start += std::mem::replace(place, start);
    }
    ordered.resize(items.len(), T::default());
    for item in items {
        let place = &mut places[key(item)];
        ordered[*place] = *item;
        *place += 1;
    }
}
