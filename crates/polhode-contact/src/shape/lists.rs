//! Lists of unequal length in one array.

/// Lists of unequal length, one after the other: for example the faces or the edges at each vertex.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Lists {
    starts: Vec<usize>,
    items: Vec<u32>,
}

impl Lists {
    /// `count` lists from pairs of a list's number and an item. Each list keeps the order of its items.
    pub(crate) fn new(count: usize, pairs: impl Iterator<Item = (u32, u32)> + Clone) -> Self {
        let mut starts = vec![0; count + 1];
        for (list, _) in pairs.clone() {
            starts[list as usize + 1] += 1;
        }
        for i in 0..count {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let mut items = vec![0; starts[count]];
        for (list, item) in pairs {
            items[next[list as usize]] = item;
            next[list as usize] += 1;
        }
        Self { starts, items }
    }

    /// One list; empty when there is none of this number.
    pub(crate) fn of(&self, list: usize) -> &[u32] {
        let bound = |k: usize| self.starts.get(k).copied().unwrap_or(self.items.len());
        self.items.get(bound(list)..bound(list.saturating_add(1))).unwrap_or(&[])
    }
}
