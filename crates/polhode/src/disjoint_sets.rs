//! Which of some members are connected, directly or by others.

/// Members `0..n` in disjoint sets, each known by its smallest member, so that the order of sets does not depend on the
/// order in which members were joined.
#[derive(Debug)]
pub(crate) struct DisjointSets {
    parent: Vec<usize>,
}

impl DisjointSets {
    /// `n` sets of one member each.
    pub(crate) fn new(n: usize) -> Self {
        Self { parent: (0..n).collect() }
    }

    /// Makes one set of those of two members.
    pub(crate) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.smallest(a), self.smallest(b));
        self.parent[a.max(b)] = a.min(b);
    }

    /// The smallest member of a member's set; found with path halving.
    pub(crate) fn smallest(&mut self, mut member: usize) -> usize {
        while self.parent[member] != member {
            self.parent[member] = self.parent[self.parent[member]];
            member = self.parent[member];
        }
        member
    }
}
