//! Which of some members are connected, directly or by others: union-find.
//!
//! A set is known by its smallest member, so that sets do not depend on the order in which members were joined. Paths
//! are halved as they are followed. Source: docs/REFERENCES.md, Tarjan and van Leeuwen 1984.

/// Members `0..n` in disjoint sets.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DisjointSets {
    parent: Vec<usize>,
}

impl DisjointSets {
    /// `n` sets of one member each.
    pub fn new(n: usize) -> Self {
        Self { parent: (0..n).collect() }
    }

    /// Makes one set of those of two members. With a number that is no member nothing changes.
    pub fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.smallest(a), self.smallest(b));
        let (low, high) = (a.min(b), a.max(b));
        if let Some(parent) = self.parent.get_mut(high) {
            *parent = low;
        }
    }

    /// The smallest member of a member's set; a number that is no member is alone.
    pub fn smallest(&mut self, mut member: usize) -> usize {
        while let Some(&parent) = self.parent.get(member)
            && parent != member
        {
            let grandparent = self.parent[parent];
            self.parent[member] = grandparent;
            member = grandparent;
        }
        member
    }
}

#[cfg(test)]
mod tests {
    use super::DisjointSets;

    #[test]
    fn sets_are_known_by_their_smallest_member_in_any_order_of_joining() {
        let joins = [(1, 4), (7, 2), (4, 7), (5, 6)];
        for turned in 0..joins.len() {
            let mut sets = DisjointSets::new(8);
            for k in 0..joins.len() {
                let (a, b) = joins[(k + turned) % joins.len()];
                sets.join(a, b);
            }
            let found: Vec<usize> = (0..8).map(|member| sets.smallest(member)).collect();
            assert_eq!(found, [0, 1, 1, 3, 1, 5, 5, 1]);
        }
    }

    #[test]
    fn numbers_that_are_no_members_are_alone() {
        let mut sets = DisjointSets::new(2);
        sets.join(0, 9);
        assert_eq!([0, 1, 9].map(|member| sets.smallest(member)), [0, 1, 9]);
    }
}
