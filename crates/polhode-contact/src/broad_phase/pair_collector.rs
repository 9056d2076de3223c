//! Pairs in the order in which they are found, and their sorting.

/// Pairs found so far, each once and in no order.
#[derive(Debug, Clone, Default)]
pub(crate) struct PairCollector {
    found: Vec<(u32, u32)>,
    /// Where the pairs of each first box end in the sorted result, while they are distributed.
    ends: Vec<usize>,
}

impl PairCollector {
    pub(crate) fn clear(&mut self) {
        self.found.clear();
    }

    /// Adds the pair of two different boxes, in either order.
    pub(crate) fn push(&mut self, i: u32, j: u32) {
        self.found.push((i.min(j), i.max(j)));
    }

    /// Sorts the pairs of `count` boxes into `sorted`: by counting on the first box, then by comparison within the few
    /// pairs that share it.
    pub(crate) fn sort_into(&mut self, count: usize, sorted: &mut Vec<(u32, u32)>) {
        self.ends.clear();
        self.ends.resize(count, 0);
        for &(i, _) in &self.found {
            self.ends[i as usize] += 1;
        }
        let mut start = 0;
        for end in &mut self.ends {
            // First the start of the group; every member that is put in moves it towards the end.
            start += std::mem::replace(end, start);
        }
        sorted.clear();
        sorted.resize(self.found.len(), (0, 0));
        for &pair in &self.found {
            let place = &mut self.ends[pair.0 as usize];
            sorted[*place] = pair;
            *place += 1;
        }
        let mut start = 0;
        for &end in &self.ends {
            sorted[start..end].sort_unstable_by_key(|&(_, j)| j);
            start = end;
        }
    }
}
